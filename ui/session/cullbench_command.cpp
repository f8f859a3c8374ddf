#include "ui/session/cullbench_command.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "core/visibility/strategy_request.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

namespace {

QString quoted(const QString& word) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./:=,+-]+$"));
    if (plain.match(word).hasMatch()) return word;
    return QLatin1Char('\'') + QString(word).replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

/// The shortest text that reads back as the same double.
QString number(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

QString triple(const Vec3& v) { return number(v.x) + QLatin1Char(',') + number(v.y) + QLatin1Char(',') + number(v.z); }

/// The colour as "RRGGBB".
QString hex(const Vec3f& colour) {
    const auto byte = [](float share) { return uint(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f)); };
    return QStringLiteral("%1").arg(byte(colour.x) << 16 | byte(colour.y) << 8 | byte(colour.z), 6, 16, QLatin1Char('0'));
}

/// A number of degrees that cullbench converts back to exactly this angle.
double exactDegrees(Angle angle) {
    const double degrees = angle.degrees();
    for (const double near : {degrees, std::nextafter(degrees, 0.0), std::nextafter(degrees, 360.0)})
        if (Angle::fromDegrees(near) == angle) return near;
    return degrees;
}

/// The options of a camera: "--eye=…" and so on, with a prefix "--view-eye=…".
QStringList cameraWords(const QString& prefix, const Camera& camera) {
    const QString dashes = QStringLiteral("--") + prefix;
    // Written with "=", so that a coordinate with a minus sign is not parsed as an option.
    QStringList words{dashes + QStringLiteral("eye=") + triple(camera.eye),
                      dashes + QStringLiteral("target=") + triple(camera.target),
                      dashes + QStringLiteral("up=") + triple(camera.up),
                      dashes + QStringLiteral("fovy=") + number(exactDegrees(camera.fovy)),
                      dashes + QStringLiteral("near=") + number(camera.nearDistance),
                      dashes + QStringLiteral("far=") + number(camera.farDistance)};
    if (camera.projection == ProjectionKind::Parallel)
        words << dashes + QStringLiteral("projection=parallel") << dashes + QStringLiteral("height=") + number(camera.height);
    return words;
}

QStringList lookWords(const ViewLook& look) {
    QStringList words;
    for (const std::string& overlay : overlayIds(look)) words << QStringLiteral("--overlay") << QString::fromStdString(overlay);
    for (const auto& [name, value] : unusualOf(look)) {
        words << QStringLiteral("--") + QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char('-'));
        if (value != "true") words << QString::fromStdString(value);
    }
    return words;
}

}  // namespace

QStringList sceneWords(const QString& command, const std::string& scene, const std::vector<std::filesystem::path>& modelFolders) {
    QStringList words;
    for (const std::filesystem::path& folder : modelFolders)
        words << QStringLiteral("--models") << QString::fromStdString(absoluteFile(folder.string()));
    return words << command << QString::fromStdString(withAbsoluteFiles(scene));
}

QStringList cullbenchArguments(const PictureSubject& picture, const QString& output) {
    QStringList words = sceneWords(QStringLiteral("render"), picture.scene, picture.modelFolders);
    words << QStringLiteral("-s") << QString::fromStdString(picture.strategy);
    if (!picture.hidden.empty()) words << QStringLiteral("--hide=") + QString::fromStdString(picture.hidden);
    for (const std::string& parameter : changedParameters(picture.parameters))
        words << QStringLiteral("-p") << QString::fromStdString(parameter);
    words << cameraWords(QString(), picture.culling);
    if (!(picture.viewing == picture.culling)) {
        words << cameraWords(QStringLiteral("view-"), picture.viewing);
        // Without a word an observer has the culling camera's projection.
        if (picture.culling.projection != picture.viewing.projection && picture.viewing.projection == ProjectionKind::Perspective)
            words << QStringLiteral("--view-projection=perspective");
    }
    words << QStringLiteral("--size=") + QString::fromStdString(sizeText(picture.size));
    if (!(picture.cullingSize == picture.size))
        words << QStringLiteral("--culling-size=") + QString::fromStdString(sizeText(picture.cullingSize));
    if (picture.section) words << QStringLiteral("--section=") + QString::fromStdString(sectionText(*picture.section));
    words << lookWords(picture.look) << QStringLiteral("--background=") + hex(picture.style.background)
          << QStringLiteral("--surface=") + hex(picture.style.surface) << QStringLiteral("-o") << output;
    return words;
}

QString shellLine(const QStringList& arguments) {
    QStringList words{QStringLiteral("cullbench")};
    for (const QString& word : arguments) words << quoted(word);
    return words.join(QLatin1Char(' '));
}

QString cullbenchCommand(const PictureSubject& picture) {
    return shellLine(cullbenchArguments(picture, QStringLiteral("view.png")));
}

}  // namespace cullscope::ui
