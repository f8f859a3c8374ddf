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

QStringList figuresSizes(const Session& session, const std::vector<int>& views) {
    QStringList sizes;
    for (const int view : views) {
        const ViewMetrics& figures = session.figures(view);
        if (figures.state == ViewMetrics::State::Ready) sizes << pixelText(figures.size);
    }
    sizes.removeDuplicates();
    return sizes;
}

QString madeCaption(Session& session, bool grid) {
    if (!session.opened()) return {};
    const int active = session.activeView();
    QStringList parts{QString::fromStdString(session.opened()->scene->name())};
    if (!grid) parts << shownStrategy(session, active) << metricsLine(session.figures(active));
    const QStringList sizes = figuresSizes(session, grid ? session.shownViews() : std::vector<int>{active});
    // Views of several sizes state theirs in their headlines.
    if (sizes.size() == 1) parts << QCoreApplication::translate("Screenshot", "figures at %1 pixels").arg(sizes.front());
    // A software OpenGL is stated wherever times are shown.
    if (session.gpu() && session.gpu()->info().software) parts << QCoreApplication::translate("Screenshot", "software OpenGL");
    return parts.join(QStringLiteral(" · "));
}

QString legendHeading(const Viewport& size) {
    return QCoreApplication::translate("Screenshot", "Triangles at %1 pixels:", "heading of the legend's counts, size")
        .arg(pixelText(size));
}

}  // namespace cullscope::ui
