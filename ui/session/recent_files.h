#pragma once

#include <QObject>
#include <QSettings>
#include <QStringList>

#include "core/base/message.h"

namespace cullscope::ui {

/// What was opened last: files (meshes, sessions, pictures) by absolute paths, and generators' specifications. Kept from start
/// to start.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 10;

    explicit RecentFiles(QObject* parent = nullptr);

    /// The newest first.
    [[nodiscard]] const QStringList& entries() const { return m_entries; }
    /// Puts it first; the eleventh goes.
    void add(const QString& what);
    /// Whether all files of an entry are there still. If not, it leaves the list.
    [[nodiscard]] bool keepIfThere(const QString& what);
    /// What to say then.
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
