#pragma once

#include <QDockWidget>

#include "ui/window/experiments.h"

namespace cullscope::ui {

/// The statistics below the views.
class StatisticsDock : public QDockWidget {
    Q_OBJECT

public:
    explicit StatisticsDock(Experiments& experiments, QWidget* parent = nullptr);

    [[nodiscard]] StatisticsPanel& statistics() { return *m_panel; }

protected:
    void changeEvent(QEvent* event) override;

private:
    StatisticsPanel* m_panel;
};

}  // namespace cullscope::ui
