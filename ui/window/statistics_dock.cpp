#include "ui/window/statistics_dock.h"

#include <QEvent>

namespace cullscope::ui {

StatisticsDock::StatisticsDock(Experiments& experiments, QWidget* parent)
    : QDockWidget(parent), m_panel(experiments.makePanel(this)) {
    setObjectName(QStringLiteral("statistics"));
    setAllowedAreas(Qt::BottomDockWidgetArea | Qt::TopDockWidgetArea);
    setWidget(m_panel);
    setWindowTitle(tr("Statistics"));
}

void StatisticsDock::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) setWindowTitle(tr("Statistics"));
    QDockWidget::changeEvent(event);
}

}  // namespace cullscope::ui
