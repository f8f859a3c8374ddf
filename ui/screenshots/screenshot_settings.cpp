#include "ui/screenshots/screenshot_settings.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/image/picture_file.h"

namespace cullscope::ui {

namespace {

const QString kOptions = QStringLiteral("screenshot/options");
const QString kFolder = QStringLiteral("screenshot/folder");
const QString kPattern = QStringLiteral("screenshot/pattern");
const QString kFirstPattern = QStringLiteral("{scene}-{strategy}-{n:03}.png");

/// The ids of the shown strategies, for the field {strategy}.
std::string strategiesOf(const Session& session, bool grid) {
    if (!grid) return session.slot(session.culledBy(session.activeView())).id();
    std::string ids;
    for (const int view : session.shownViews()) ids += (ids.empty() ? "" : "+") + session.slot(session.culledBy(view)).id();
    return ids;
}

}  // namespace

ScreenshotSettings ScreenshotSettings::load() {
    const QSettings stored;
    ScreenshotSettings settings;
    settings.options = screenshotOptionsFromText(stored.value(kOptions).toString().toStdString());
    settings.folder = stored.value(kFolder).toString();
    if (settings.folder.isEmpty()) settings.folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    if (!QFileInfo(settings.folder).isDir()) settings.folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    settings.pattern = stored.value(kPattern, kFirstPattern).toString();
    return settings;
}

void ScreenshotSettings::save() const {
    QSettings stored;
    stored.setValue(kOptions, QString::fromStdString(optionsText(options)));
    stored.setValue(kFolder, folder);
    stored.setValue(kPattern, pattern);
}

std::filesystem::path screenshotPath(const Session& session, const ScreenshotSettings& settings) {
    // A name with folders, absolute or within the chosen folder, names its own.
    QString pattern = settings.pattern.trimmed();
    if (pattern.startsWith(QStringLiteral("~/"))) pattern.replace(0, 1, QDir::homePath());
    const QFileInfo named(QDir(settings.folder), pattern);
    const QFileInfo place(pattern.contains(QLatin1Char('/')) ? named.path() : settings.folder);
    const std::string folder = place.filePath().toStdString();
    if (!place.isDir()) throwUsage(QT_TRANSLATE_NOOP("core", "There is no folder %1: choose another one."), {folder});
    if (!place.isWritable())
        throwUsage(QT_TRANSLATE_NOOP("core", "Nothing can be written into the folder %1: choose another one."), {folder});
    if (named.fileName().isEmpty() || pattern.isEmpty())
        throwUsage(QT_TRANSLATE_NOOP("core", "The file has no name: give it one, such as {scene}-{n}.png."));
    const std::string name = session.opened() ? session.opened()->scene->name() : std::string();
    const std::filesystem::path path =
        nextFileName(folder, named.fileName().toStdString(), name, strategiesOf(session, settings.options.grid));
    requirePictureFormat(path);
    return path;
}

}  // namespace cullscope::ui
