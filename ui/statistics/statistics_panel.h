#pragma once

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <array>
#include <filesystem>
#include <optional>

#include "ui/statistics/experiment_bar.h"
#include "ui/statistics/measure_command.h"
#include "ui/statistics/result_table_model.h"

namespace cullscope::ui {

class ParetoPlot;
class PathPlot;
class PlotWidget;
class PosePlot;
class PoseStrip;
class ResultExporter;
struct ReportPlot;
class SphereMap;
class TimeBar;

/// The statistics: an experiment set up, started and shown as table, bars, strip, plots and map; and the present camera's figures
/// as table and bars. Fed from outside, and shown at most ten times a second.
class StatisticsPanel : public QWidget {
    Q_OBJECT

public:
    enum Tab { Table, Times, Poses, Path, Pareto, Sphere, TabCount };
    enum class File { Csv, Json, Svg, Pdf, Html };

    explicit StatisticsPanel(QWidget* parent = nullptr);
    ~StatisticsPanel() override;

    /// Another scene takes the result of the one before away. `origin` is what the report's command opens it by.
    void setScene(ScenePointer scene, SceneOrigin origin = {});
    /// Whether the processor draws: a badge says so beside the times.
    void setSoftwareOpenGl(bool software);
    void setCurrentSize(const Viewport& size) { m_bar->setCurrentSize(size); }
    /// Its name goes into result files, and as a file's name into the report's command.
    void setRecordedPath(std::optional<CameraPath> path) { m_bar->setRecordedPath(std::move(path)); }

    /// What the shown views do at the present camera.
    void setLive(std::vector<LiveFigures> views);
    /// A result, partial or whole. One of another scene than the present is dropped.
    void setResult(const MeasureResult& result);
    /// An experiment begins or ends; beginning one shows its result in place of the present camera's figures.
    void setRunning(bool running);
    void setProgress(double share, const QString& stage) { m_bar->setProgress(share, stage); }

    void showTab(Tab tab);
    /// Writes the result, or the plot of the present tab; `exported` or `failed` tells what came of it.
    void exportTo(File file, const std::filesystem::path& path);

    [[nodiscard]] ExperimentBar& bar() { return *m_bar; }
    [[nodiscard]] ResultTableModel& model() { return *m_model; }

signals:
    void startRequested(const cullscope::ui::ExperimentSettings& settings);
    void cancelRequested();
    void poseChosen(int pose);
    void exported(const QString& path);
    void failed(const cullscope::Message& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpBars();
    void setUpTable();
    void setUpPlots();
    void setUpMenu();
    void addPage(PlotWidget* plot);
    [[nodiscard]] std::array<PlotWidget*, 5> plots() const;
    void retranslate();

    /// Shows what came in now, or as soon as a tenth of a second has passed since the last time.
    void scheduleRefresh();
    void refresh();
    void refreshControls();
    void refreshTablePage();
    void refreshPoses();
    void refreshSummary();
    void fillRuns();

    [[nodiscard]] bool showsExperiment() const;
    [[nodiscard]] PlotWidget* currentPlot() const;
    /// The plots of the report; one a strategy where a plot shows a single one.
    [[nodiscard]] std::vector<ReportPlot> reportPlots() const;
    void askWhereTo(File file);

    ExperimentBar* m_bar;
    QTabBar* m_tabs;
    QComboBox* m_source;
    QComboBox* m_run;
    QLabel* m_summary;
    QLabel* m_software;
    QToolButton* m_export;
    QMenu* m_menu;
    QStackedWidget* m_pages;
    QStackedWidget* m_tablePage;  ///< the table, or what to do while it is empty
    QTableView* m_table;
    QLabel* m_tableEmpty;
    ResultTableModel* m_model;
    TimeBar* m_times;
    PoseStrip* m_strip;
    PathPlot* m_path;
    ParetoPlot* m_pareto;
    SphereMap* m_sphere;
    ResultExporter* m_exporter;
    QTimer m_pause;
    bool m_waiting = false;
    bool m_running = false;

    ScenePointer m_scene;
    SceneOrigin m_origin;
    std::vector<LiveFigures> m_live;
    std::optional<MeasureResult> m_result;
};

}  // namespace cullscope::ui
