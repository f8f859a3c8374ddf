#include "ui/session/recent_files.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "ui/session/session_state.h"

namespace cullscope::ui {

namespace {

constexpr const char* kSetting = "recent";

bool isThere(const QString& what) {
    bool all = true;
    (void)withFiles(what.toStdString(), [&](const std::string& file) {
        all = all && QFileInfo::exists(QString::fromStdString(file));
        return file;
    });
    return all;
}

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {
    m_entries = m_settings.value(QLatin1String(kSetting)).toStringList().mid(0, kMost);
    m_entries.removeAll(QString());
    m_entries.removeDuplicates();
}

void RecentFiles::add(const QString& what) {
    if (what.isEmpty()) return;
    const QString entry = QString::fromStdString(withAbsoluteFiles(what.toStdString()));
    QStringList entries = m_entries;
    entries.removeAll(entry);
    entries.prepend(entry);
    setEntries(entries.mid(0, kMost));
}

bool RecentFiles::keepIfThere(const QString& what) {
    if (isThere(what)) return true;
    QStringList entries = m_entries;
    entries.removeAll(what);
    setEntries(entries);
    return false;
}

Message RecentFiles::goneMessage(const QString& what) {
    return {QT_TRANSLATE_NOOP("core", "%1 is not there any more; it was taken off the list of recent files."),
            {what.toStdString()}};
}

void RecentFiles::clear() { setEntries({}); }

void RecentFiles::setEntries(const QStringList& entries) {
    if (entries == m_entries) return;
    m_entries = entries;
    m_settings.setValue(QLatin1String(kSetting), entries);
    emit changed();
}

}  // namespace cullscope::ui
