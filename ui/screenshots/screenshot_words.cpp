#include "ui/screenshots/screenshot_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/visibility/strategy_request.h"
#include "ui/models/metrics_words.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

QString strategyText(const Session& session, int view) {
    const StrategySlot& slot = session.slot(session.culledBy(view));
    QString text = translated(findStrategy(slot.id()).info.name);
    for (const std::string& parameter : changedParameters(slot.parameters()))
        text += QLatin1Char(' ') + QString::fromStdString(parameter);
    return text;
}

QString madeCaption(Session& session, bool grid) {
    if (!session.opened()) return {};
    const int view = session.activeView();
    QStringList parts{QString::fromStdString(session.opened()->scene->name())};
    const ViewMetrics& figures = session.figures(view);
    if (!grid) parts << strategyText(session, view) << metricsLine(figures);
    if (figures.state == ViewMetrics::State::Ready)
        parts << QCoreApplication::translate("Screenshot", "figures at %1 × %2 pixels")
                     .arg(figures.size.width)
                     .arg(figures.size.height);
    // A software OpenGL is stated wherever times are shown.
    if (session.gpu() && session.gpu()->info().software) parts << QCoreApplication::translate("Screenshot", "software OpenGL");
    return parts.join(QStringLiteral(" · "));
}

QString legendHeading(const Viewport& size) {
    return QCoreApplication::translate("Screenshot", "Triangles at %1 × %2 pixels:", "heading of the legend's counts")
        .arg(size.width)
        .arg(size.height);
}

}  // namespace cullscope::ui
