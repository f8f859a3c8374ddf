#include "ui/statistics/pose_plot.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>

#include "ui/text/wording.h"

namespace cullscope::ui {

PosePlot::PosePlot(QWidget* parent) : PlotWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
}

void PosePlot::setRun(RunFigures run, size_t poseCount) {
    m_run = std::move(run);
    m_poseCount = std::max(poseCount, m_run.poses.empty() ? 0 : m_run.poses.back().pose + 1);
    m_current = std::min(m_current, int(m_run.poses.size()) - 1);
    contentsChanged();
}

QString PosePlot::title() const { return empty() ? subject() : QStringLiteral("%1 · %2").arg(subject(), m_run.label); }

QString PosePlot::poseText(const PoseFigures& pose) const {
    QStringList lines{tr("Pose %1").arg(pose.pose), tr("Frame: %1").arg(millisecondsText(pose.frameMilliseconds))};
    lines << (pose.missedPpm
                  ? tr("Missed: %1 pixels, %2 per million").arg(countText(pose.missedPixels), significantText(*pose.missedPpm))
                  : tr("Missed: not measured"));
    return lines.join(QLatin1Char('\n'));
}

QString PosePlot::description() const {
    return m_current >= 0 ? poseText(m_run.poses[size_t(m_current)])
                          : tr("%1, poses: %2. The arrow keys go through them, Enter flies there.")
                                .arg(m_run.label, countText(m_run.poses.size()));
}

void PosePlot::setCurrent(int index) {
    m_current = index;
    contentsChanged();
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

void PosePlot::choose(int index) {
    setCurrent(index);
    emit poseChosen(int(m_run.poses[size_t(index)].pose));
}

bool PosePlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PlotWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    showValues(help->pos(), help->globalPos());
    return true;
}

void PosePlot::mouseMoveEvent(QMouseEvent* event) { showValues(event->position(), event->globalPosition().toPoint()); }

void PosePlot::showValues(const QPointF& place, const QPoint& onScreen) {
    const int index = empty() ? -1 : poseAt(place);
    if (index < 0)
        QToolTip::hideText();
    else
        QToolTip::showText(onScreen, poseText(m_run.poses[size_t(index)]), this);
}

void PosePlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || empty()) return PlotWidget::mouseReleaseEvent(event);
    if (const int index = poseAt(event->position()); index >= 0) choose(index);
}

void PosePlot::keyPressEvent(QKeyEvent* event) {
    if (empty()) return PlotWidget::keyPressEvent(event);
    const int last = int(m_run.poses.size()) - 1;
    switch (event->key()) {
        case Qt::Key_Left:
            return setCurrent(std::max(0, m_current - 1));
        case Qt::Key_Right:
            return setCurrent(std::min(last, m_current + 1));
        case Qt::Key_Home:
            return setCurrent(0);
        case Qt::Key_End:
            return setCurrent(last);
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            if (m_current >= 0) choose(m_current);
            return;
        default:
            PlotWidget::keyPressEvent(event);
    }
}

void PosePlot::focusInEvent(QFocusEvent* event) {
    PlotWidget::focusInEvent(event);
    if (m_current < 0 && !empty() && event->reason() != Qt::MouseFocusReason) setCurrent(0);
}

}  // namespace cullscope::ui
