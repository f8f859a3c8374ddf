#pragma once

#include <QObject>
#include <QSettings>
#include <QStringList>

#include "core/base/message.h"

namespace cullscope::ui {

/// The newest opened files (meshes, sessions, pictures, by absolute paths) and generator specifications. Stored in the settings.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 10;

    explicit RecentFiles(QObject* parent = nullptr);

    /// All entries, the newest first.
    [[nodiscard]] const QStringList& entries() const { return m_entries; }
    /// Moves or adds an entry to the front; an eleventh entry is dropped.
    void add(const QString& what);
    /// Whether all files of an entry still exist. If not, removes the entry.
    [[nodiscard]] bool keepIfThere(const QString& what);
    /// The message for an entry whose files no longer exist.
    [[nodiscard]] static Message goneMessage(const QString& what);
    void clear();

signals:
    void changed();

private:
    void setEntries(const QStringList& entries);

    QSettings m_settings;
    QStringList m_entries;
};

}  // namespace cullscope::ui
