#include "ui/session/cullbench_command.h"

#include <QRegularExpression>
#include <QStringList>

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

}  // namespace

QString cullbenchCommand(const std::string& scene, const std::string& strategy, const ParameterSet& parameters,
                         const Camera& camera, const Viewport& size) {
    QStringList words{QStringLiteral("cullbench"), QStringLiteral("render"), quoted(QString::fromStdString(scene)),
                      QStringLiteral("-s"), quoted(QString::fromStdString(strategy))};
    for (const ParameterDeclaration& declaration : parameters.declarations()) {
        const ParameterValue& value = parameters.value(declaration.key);
        if (value == declaration.defaultValue) continue;
        words << QStringLiteral("-p") << quoted(QString::fromStdString(declaration.key + "=" + toText(value)));
    }
    // With "=", a coordinate that begins with a minus sign is not taken for an option.
    words << QStringLiteral("--eye=") + triple(camera.eye) << QStringLiteral("--target=") + triple(camera.target)
          << QStringLiteral("--up=") + triple(camera.up) << QStringLiteral("--fovy=") + number(camera.fovy.degrees())
          << QStringLiteral("--near=") + number(camera.nearDistance) << QStringLiteral("--far=") + number(camera.farDistance)
          << QStringLiteral("--size=%1x%2").arg(size.width).arg(size.height) << QStringLiteral("-o")
          << QStringLiteral("view.png");
    return words.join(QLatin1Char(' '));
}

}  // namespace cullscope::ui
