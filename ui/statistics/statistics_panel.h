#pragma once

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>

#include "ui/statistics/experiment_bar.h"
#include "ui/statistics/history_panel.h"
#include "ui/statistics/measure_command.h"
#include "ui/statistics/result_table_model.h"

namespace cullscope::ui {

class ColumnMenu;
class ParetoPlot;
class PathPlot;
class PlotWidget;
class PosePlot;
class PoseStrip;
class ResultExporter;
struct ReportPlot;
class SphereMap;
class TimeBar;

/// The statistics: sets up and starts an experiment and shows its result as table, bars, strip, plots and map; also shows the
/// metrics at the present camera as table and bars. Other objects supply the data; it is shown at most ten times a second.
class StatisticsPanel : public QWidget {
    Q_OBJECT

public:
    enum Tab { Table, Times, Poses, Path, Pareto, Sphere, Race, History, TabCount };
    enum class File { Csv, Json, Svg, Pdf, Html, Report };

    explicit StatisticsPanel(QWidget* parent = nullptr);
    ~StatisticsPanel() override;

    /// Sets the scene; a new one discards the result of the former one. `origin` names the scene in the command of the report.
    void setScene(ScenePointer scene, SceneOrigin origin = {});
    /// Shows a badge beside the times if OpenGL is rendered by the CPU.
    void setSoftwareOpenGl(bool software);
    /// What gives the picture of the scene in a report; none by default.
    void setScenePicture(std::function<QImage()> picture) { m_scenePicture = std::move(picture); }
    void setCurrentSize(const Viewport& size) { m_bar->setCurrentSize(size); }
    /// Sets the recorded path. Its name is written into result files; if it is a file name, also into the command of the report.
    void setRecordedPath(std::optional<CameraPath> path) { m_bar->setRecordedPath(std::move(path)); }

    /// Sets the metrics of the shown views at the present camera.
    void setLive(std::vector<LiveFigures> views);
    /// Sets a partial or complete result: the experiment's table (sweepExperiment), and the frames behind it. A result of another
    /// scene is ignored.
    void setResult(const ResultTable& table, const MeasureResult& result);
    /// Sets the experiments of the store, the newest last.
    void setHistory(std::vector<PastExperiment> experiments);
    /// Begins or ends an experiment. While it runs its result replaces the metrics at the present camera.
    void setRunning(bool running);
    void setProgress(double share, const QString& stage) { m_bar->setProgress(share, stage); }

    void showTab(Tab tab);
    /// Writes the result, or the plot of the present tab, to a file. Emits `exported` or `failed`.
    void exportTo(File file, const std::filesystem::path& path);

    [[nodiscard]] ExperimentBar& bar() { return *m_bar; }
    /// The experiment's result as far as it is there; none: there is none of this scene.
    [[nodiscard]] const std::optional<MeasureResult>& result() const { return m_result; }
    [[nodiscard]] ResultTableModel& model() { return *m_model; }
    [[nodiscard]] HistoryModel& history() { return *m_history; }
    [[nodiscard]] HistoryPanel& past() { return *m_past; }
    /// "fibonacci:16 · 320 × 240": path and size of a measurement.
    [[nodiscard]] static QString pathAndSize(const MeasureRequest& request);

signals:
    void startRequested(const cullscope::ui::ExperimentSettings& settings);
    void cancelRequested();
    void poseChosen(int pose);
    /// The strategy of a point or of a row is to be shown in a view.
    void strategyChosen(const cullscope::StrategyRequest& strategy);
    void exported(const QString& path);
    /// Of measurements of the store, by their numbers.
    void compareRequested(qint64 a, qint64 b);
    void pastExportRequested(const std::vector<qint64>& numbers, const QString& path);
    void failed(const cullscope::Message& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpBars();
    void setUpTable();
    void setUpPlots();
    void setUpAxes();
    void retranslateAxes();
    /// Makes their lists as wide as what is chosen.
    void fitAxes();
    void setUpRace();
    void setUpHistory();
    void setUpMenu();
    void addPage(PlotWidget* plot);
    [[nodiscard]] std::array<PlotWidget*, 5> plots() const;
    void retranslate();

    /// Shows new data now, or as soon as a tenth of a second has passed since the last refresh.
    void scheduleRefresh();
    void refresh();
    void refreshControls();
    void refreshTablePage();
    void refreshPoses();
    void refreshSummary();
    void refreshRace();
    void fillRuns();

    [[nodiscard]] bool showsExperiment() const;
    [[nodiscard]] PlotWidget* currentPlot() const;
    /// The plots of the report; a plot that shows a single strategy is repeated for each one.
    [[nodiscard]] std::vector<ReportPlot> reportPlots() const;
    void askWhereTo(File file);

    ExperimentBar* m_bar;
    QTabBar* m_tabs;
    QComboBox* m_source;
    QComboBox* m_run;
    QComboBox *m_across, *m_up;  ///< axes of the Pareto plot
    QLabel* m_summary;
    QLabel* m_software;
    QToolButton* m_export;
    QMenu* m_menu;
    QStackedWidget* m_pages;
    QStackedWidget* m_tablePage;  ///< the table, or a hint while it is empty
    QTableView* m_table;
    ColumnMenu* m_columns;
    QToolButton* m_chooseColumns;
    QLabel* m_tableEmpty;
    ResultTableModel* m_model;
    QTableWidget* m_race;           ///< each strategy of the experiment against each
    QLabel* m_raceWords;            ///< how its cells are read
    QStackedWidget* m_historyPage;  ///< the experiments beside each other, or a hint while there are none
    QLabel* m_historyEmpty;
    HistoryModel* m_history;
    HistoryPanel* m_past;
    TimeBar* m_times;
    PoseStrip* m_strip;
    PathPlot* m_path;
    ParetoPlot* m_pareto;
    SphereMap* m_sphere;
    ResultExporter* m_exporter;
    QTimer m_pause;
    bool m_waiting = false;
    bool m_running = false;

    std::function<QImage()> m_scenePicture = [] { return QImage(); };
    ScenePointer m_scene;
    SceneOrigin m_origin;
    std::vector<LiveFigures> m_live;
    std::optional<MeasureResult> m_result;
    ResultTable m_resultTable;  ///< with `m_result`
};

}  // namespace cullscope::ui
