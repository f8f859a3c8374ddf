#include "ui/screenshots/screenshot_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/models/metrics_words.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

QString shownStrategy(const Session& session, int view) {
    const StrategySlot& slot = session.slot(session.culledBy(view));
    return strategyWords({slot.id(), slot.parameters()});
}

QString madeCaption(Session& session, bool grid) {
    if (!session.opened()) return {};
    const int view = session.activeView();
    QStringList parts{QString::fromStdString(session.opened()->scene->name())};
    const ViewMetrics& figures = session.figures(view);
    if (!grid) parts << shownStrategy(session, view) << metricsLine(figures);
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
