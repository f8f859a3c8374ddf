#include "ui/session/cullbench_command.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
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
    return {dashes + QStringLiteral("eye=") + triple(camera.eye),
            dashes + QStringLiteral("target=") + triple(camera.target),
            dashes + QStringLiteral("up=") + triple(camera.up),
            dashes + QStringLiteral("fovy=") + number(exactDegrees(camera.fovy)),
            dashes + QStringLiteral("near=") + number(camera.nearDistance),
            dashes + QStringLiteral("far=") + number(camera.farDistance)};
}

QStringList lookWords(const ViewLook& look) {
    QStringList words;
    const auto add = [&](bool shown, const QString& name) {
        if (shown) words << QStringLiteral("--overlay") << name;
    };
    // The model in spherical coordinates replaces the whole picture: no other overlay is visible.
    if (look.sphericalModel) return {QStringLiteral("--overlay"), QStringLiteral("spherical-model")};
    const bool verdicts = look.colouring == Colouring::Verdicts;
    add(verdicts, QStringLiteral("verdicts"));
    add(look.boxes, QStringLiteral("boxes"));
    add(look.frustum, QStringLiteral("frustum"));
    add(look.bands, QStringLiteral("bands"));
    add(look.kernel, QStringLiteral("kernel"));
    if (look.byPlane()) words << QStringLiteral("--box-colouring") << QString::fromLatin1(boxColouringId(look.boxColouring));
    if (verdicts && !look.culledToo) words << QStringLiteral("--drawn-only");
    return words;
}

QString sizeWord(const QString& option, const Viewport& size) {
    return QStringLiteral("--%1=%2x%3").arg(option).arg(size.width).arg(size.height);
}

}  // namespace

QStringList cullbenchArguments(const PictureRequest& request, const QString& output) {
    QStringList words;
    for (const std::filesystem::path& folder : request.modelFolders)
        words << QStringLiteral("--models")
              << QString::fromStdString(std::filesystem::absolute(folder).lexically_normal().string());
    words << QStringLiteral("render") << QString::fromStdString(withAbsoluteFiles(request.scene)) << QStringLiteral("-s")
          << QString::fromStdString(request.strategy);
    if (!request.hidden.empty()) words << QStringLiteral("--hide=") + QString::fromStdString(request.hidden);
    for (const std::string& parameter : changedParameters(request.parameters))
        words << QStringLiteral("-p") << QString::fromStdString(parameter);
    words << cameraWords(QString(), request.camera);
    if (request.observer && !(*request.observer == request.camera))
        words << cameraWords(QStringLiteral("view-"), *request.observer);
    words << sizeWord(QStringLiteral("size"), request.size);
    if (request.cullingSize && !(*request.cullingSize == request.size))
        words << sizeWord(QStringLiteral("culling-size"), *request.cullingSize);
    words << lookWords(request.look) << QStringLiteral("--background=") + hex(request.style.background)
          << QStringLiteral("--surface=") + hex(request.style.surface) << QStringLiteral("-o") << output;
    return words;
}

QString cullbenchCommand(const PictureRequest& request) {
    QStringList words{QStringLiteral("cullbench")};
    for (const QString& word : cullbenchArguments(request, QStringLiteral("view.png"))) words << quoted(word);
    return words.join(QLatin1Char(' '));
}

}  // namespace cullscope::ui
