#pragma once

#include <QDockWidget>

#include "ui/session/experiment_runner.h"
#include "ui/session/session.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui {

/// The statistics below the views: experiments over the shown views' strategies, and the present camera's figures.
class StatisticsDock : public QDockWidget {
    Q_OBJECT

public:
    explicit StatisticsDock(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] StatisticsPanel& statistics() { return *m_panel; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void wire();
    void start(const ExperimentSettings& settings);
    void end();
    void goToPose(int pose);
    void showLive();

    Session& m_session;
    StatisticsPanel* m_panel;
    ExperimentRunner* m_runner;
    CameraPath m_path;  ///< of the newest experiment
};

}  // namespace cullscope::ui
