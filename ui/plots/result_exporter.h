#pragma once

#include <QObject>
#include <filesystem>
#include <functional>

#include "core/base/message.h"
#include "ui/jobs/background.h"

namespace cullscope::ui {

/// Writes what was measured to files, beside the window: hashing a large scene for a result takes a second. Whole or not at all.
class ResultExporter : public QObject {
    Q_OBJECT

public:
    /// Makes a file's bytes; called on a thread of the exporter.
    using Contents = std::function<QByteArray()>;

    using QObject::QObject;

    /// A newer file does not stop an older one.
    void write(const std::filesystem::path& path, Contents contents);

signals:
    void written(const QString& path);
    void failed(const cullscope::Message& message);
};

}  // namespace cullscope::ui
