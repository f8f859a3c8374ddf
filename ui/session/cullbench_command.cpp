#include "ui/session/cullbench_command.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/scene/scene_source.h"

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

/// "RRGGBB".
QString hex(const Vec3f& colour) {
    const auto byte = [](float share) { return uint(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f)); };
    return QStringLiteral("%1").arg(byte(colour.x) << 16 | byte(colour.y) << 8 | byte(colour.z), 6, 16, QLatin1Char('0'));
}

/// Degrees that cullbench reads back as the very same angle.
double exactDegrees(Angle angle) {
    const double degrees = angle.degrees();
    for (const double near : {degrees, std::nextafter(degrees, 0.0), std::nextafter(degrees, 360.0)})
        if (Angle::fromDegrees(near) == angle) return near;
    return degrees;
}

QString absolutePath(const QString& file) {
    if (file.isEmpty()) return file;
    return QString::fromStdString(std::filesystem::absolute(file.toStdString()).lexically_normal().string());
}

/// The word "bunny" stands for the installed one.
QString absoluteMesh(const QString& file) {
    return file == QLatin1String("bunny") && !std::filesystem::exists("bunny") ? file : absolutePath(file);
}

bool isGenerator(const QString& id) {
    const std::vector<GeneratorInfo>& known = sceneGenerators();
    return std::any_of(known.begin(), known.end(), [&](const GeneratorInfo& info) { return info.id == id.toStdString(); });
}

/// The specification with the files in it by absolute paths. Cut as core's openScene does: at commas before `key=`.
QString absoluteScene(const QString& scene) {
    const QString id = scene.section(QLatin1Char(':'), 0, 0);
    if (!isGenerator(id)) return absolutePath(scene);
    if (!scene.contains(QLatin1Char(':'))) return std::filesystem::is_regular_file(id.toStdString()) ? absolutePath(id) : scene;
    static const QRegularExpression comma(QStringLiteral(",(?=[A-Za-z0-9_-]+=)"));
    static const QRegularExpression value(QStringLiteral("^[A-Za-z0-9_-]+="));
    QStringList pieces = scene.mid(id.size() + 1).split(comma);
    for (QString& piece : pieces) {
        const QString key = value.match(piece).captured();
        const bool names = id == QLatin1String("mesh") ? key.isEmpty() : key == QLatin1String("mesh=");
        if (names && !piece.isEmpty()) piece = key + absoluteMesh(piece.mid(key.size()));
    }
    return id + QLatin1Char(':') + pieces.join(QLatin1Char(','));
}

}  // namespace

QStringList cullbenchArguments(const PictureRequest& request, const QString& output) {
    QStringList words;
    for (const std::filesystem::path& folder : request.modelFolders)
        words << QStringLiteral("--models") << absolutePath(QString::fromStdString(folder.string()));
    words << QStringLiteral("render") << absoluteScene(QString::fromStdString(request.scene)) << QStringLiteral("-s")
          << QString::fromStdString(request.strategy);
    for (const ParameterDeclaration& declaration : request.parameters.declarations()) {
        const ParameterValue& value = request.parameters.value(declaration.key);
        if (value == declaration.defaultValue) continue;
        words << QStringLiteral("-p") << QString::fromStdString(declaration.key + "=" + toText(value));
    }
    const Camera& camera = request.camera;
    // With "=", a coordinate that begins with a minus sign is not taken for an option.
    words << QStringLiteral("--eye=") + triple(camera.eye) << QStringLiteral("--target=") + triple(camera.target)
          << QStringLiteral("--up=") + triple(camera.up) << QStringLiteral("--fovy=") + number(exactDegrees(camera.fovy))
          << QStringLiteral("--near=") + number(camera.nearDistance) << QStringLiteral("--far=") + number(camera.farDistance)
          << QStringLiteral("--size=%1x%2").arg(request.size.width).arg(request.size.height)
          << QStringLiteral("--background=") + hex(request.style.background)
          << QStringLiteral("--surface=") + hex(request.style.surface) << QStringLiteral("-o") << output;
    return words;
}

QString cullbenchCommand(const PictureRequest& request) {
    QStringList words{QStringLiteral("cullbench")};
    for (const QString& word : cullbenchArguments(request, QStringLiteral("view.png"))) words << quoted(word);
    return words.join(QLatin1Char(' '));
}

}  // namespace cullscope::ui
