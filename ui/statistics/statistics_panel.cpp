#include "ui/statistics/statistics_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/wheel_guard.h"
#include "ui/plots/result_exporter.h"
#include "ui/statistics/column_menu.h"
#include "ui/statistics/flow_layout.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/path_plot.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/run_figures.h"
#include "ui/statistics/sphere_map.h"
#include "ui/statistics/time_bar.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kInterval = 100;  // ms between two refreshes
constexpr int kPanelSpacing = 6;
constexpr int kRowHeight = 22;
constexpr int kHeaderMargins = 6;

}  // namespace

StatisticsPanel::StatisticsPanel(QWidget* parent)
    : QWidget(parent),
      m_bar(new ExperimentBar(this)),
      m_tabs(new QTabBar(this)),
      m_source(new QComboBox(this)),
      m_run(new QComboBox(this)),
      m_across(new QComboBox(this)),
      m_up(new QComboBox(this)),
      m_summary(new QLabel(this)),
      m_software(new QLabel(this)),
      m_export(new QToolButton(this)),
      m_menu(new QMenu(this)),
      m_pages(new QStackedWidget(this)),
      m_tablePage(new QStackedWidget(this)),
      m_table(new QTableView(this)),
      m_columns(nullptr),
      m_chooseColumns(new QToolButton(this)),
      m_tableEmpty(new QLabel(this)),
      m_model(new ResultTableModel(this)),
      m_race(new QTableWidget(this)),
      m_raceWords(new QLabel(this)),
      m_historyPage(new QStackedWidget(this)),
      m_historyEmpty(new QLabel(this)),
      m_history(new HistoryModel(this)),
      m_past(new HistoryPanel(*m_history, this)),
      m_times(new TimeBar(this)),
      m_strip(new PoseStrip(this)),
      m_path(new PathPlot(this)),
      m_pareto(new ParetoPlot(this)),
      m_sphere(new SphereMap(this)),
      m_exporter(new ResultExporter(this)) {
    setUpBars();
    setUpTable();
    setUpPlots();
    setUpAxes();
    setUpRace();
    setUpHistory();
    setUpMenu();
    m_pause.setSingleShot(true);
    m_pause.setInterval(kInterval);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_waiting) refresh();
    });
    connect(m_exporter, &ResultExporter::written, this, &StatisticsPanel::exported);
    connect(m_exporter, &ResultExporter::failed, this, &StatisticsPanel::failed);
    retranslate();
}

StatisticsPanel::~StatisticsPanel() = default;

void StatisticsPanel::setUpBars() {
    auto* second = new QWidget(this);
    auto* line = new FlowLayout(second, kPanelSpacing, kPanelSpacing);
    line->setContentsMargins(0, 0, 0, 0);
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_tabs->setUsesScrollButtons(false);
    m_tabs->setElideMode(Qt::ElideNone);
    for (int tab = 0; tab < TabCount; ++tab) m_tabs->addTab({});
    m_source->addItems({{}, {}});
    m_software->setAutoFillBackground(true);
    m_software->setBackgroundRole(QPalette::ToolTipBase);
    m_software->setForegroundRole(QPalette::ToolTipText);
    m_software->setMargin(2);
    m_software->hide();
    m_export->setPopupMode(QToolButton::InstantPopup);
    m_export->setMenu(m_menu);
    for (QComboBox* box : {m_source, m_run}) box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_tabs, m_source, m_chooseColumns, m_run, m_across, m_up, m_export,
                                                           m_summary, m_software})
        line->addWidget(widget);
    for (QWidget* field : std::initializer_list<QWidget*>{m_tabs, m_source, m_run, m_across, m_up})
        leaveWheelUnlessFocused(*field);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 0);
    layout->setSpacing(4);
    layout->addWidget(m_bar);
    layout->addWidget(second);
    layout->addWidget(m_pages, 1);
    connect(m_bar, &ExperimentBar::startRequested, this, [this](const ExperimentSettings& settings) {
        if (!settings.sweeps.empty()) showTab(Pareto);
        emit startRequested(settings);
    });
    connect(m_bar, &ExperimentBar::cancelRequested, this, &StatisticsPanel::cancelRequested);
    connect(m_bar, &ExperimentBar::failed, this, &StatisticsPanel::failed);
    connect(m_source, &QComboBox::activated, this, &StatisticsPanel::refresh);
    connect(m_run, &QComboBox::activated, this, &StatisticsPanel::refreshPoses);
    connect(m_tabs, &QTabBar::currentChanged, this, [this](int tab) {
        m_pages->setCurrentIndex(tab);
        refreshRace();
        refreshControls();
    });
}

void StatisticsPanel::setUpTable() {
    m_table->setModel(m_model);
    m_columns = new ColumnMenu(*m_table);
    m_chooseColumns->setPopupMode(QToolButton::InstantPopup);
    m_chooseColumns->setMenu(m_columns);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setTextElideMode(Qt::ElideNone);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionsClickable(false);
    m_table->horizontalHeader()->setStretchLastSection(false);
    // Two lines in the letters of any language: a header asks for those of the first font alone.
    m_table->horizontalHeader()->setMinimumHeight(2 * lineHeight(m_table->horizontalHeader()->fontMetrics()) + kHeaderMargins);
    m_tableEmpty->setAlignment(Qt::AlignCenter);
    m_tableEmpty->setWordWrap(true);
    m_tableEmpty->setAutoFillBackground(true);
    m_tableEmpty->setBackgroundRole(QPalette::Base);
    m_tablePage->addWidget(m_table);
    m_tablePage->addWidget(m_tableEmpty);
    m_pages->addWidget(m_tablePage);
    const auto fly = [this](const QModelIndex& index) {
        const QVariant pose = index.data(ResultTableModel::kPoseRole);
        if (pose.isValid()) emit poseChosen(pose.toInt());
    };
    connect(m_table, &QTableView::activated, this, fly);
}

void StatisticsPanel::setUpPlots() {
    for (PlotWidget* plot : plots()) addPage(plot);
    for (const PosePlot* plot : std::initializer_list<PosePlot*>{m_strip, m_sphere})
        connect(plot, &PosePlot::poseChosen, this, &StatisticsPanel::poseChosen);
}

void StatisticsPanel::setUpHistory() {
    connect(m_past, &HistoryPanel::compareRequested, this, &StatisticsPanel::compareRequested);
    connect(m_past, &HistoryPanel::exportRequested, this, &StatisticsPanel::pastExportRequested);
    m_historyEmpty->setAlignment(Qt::AlignCenter);
    m_historyEmpty->setWordWrap(true);
    m_historyEmpty->setAutoFillBackground(true);
    m_historyEmpty->setBackgroundRole(QPalette::Base);
    m_historyPage->addWidget(m_historyEmpty);
    m_historyPage->addWidget(m_past);
    m_pages->addWidget(m_historyPage);
}

void StatisticsPanel::setHistory(std::vector<PastExperiment> experiments) {
    m_historyPage->setCurrentWidget(experiments.empty() ? static_cast<QWidget*>(m_historyEmpty) : m_past);
    m_history->setExperiments(std::move(experiments));
}

QString StatisticsPanel::pathAndSize(const MeasureRequest& request) { return ui::pathAndSize(request.path.name, request.size); }

std::array<PlotWidget*, 5> StatisticsPanel::plots() const { return {m_times, m_strip, m_path, m_pareto, m_sphere}; }

void StatisticsPanel::addPage(PlotWidget* plot) {
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(plot);
    m_pages->addWidget(scroll);
}

void StatisticsPanel::setScene(ScenePointer scene, SceneOrigin origin) {
    if (scene != m_scene) m_result.reset();
    m_scene = std::move(scene);
    m_origin = std::move(origin);
    m_bar->setScene(m_scene);
    refresh();
}

void StatisticsPanel::setSoftwareOpenGl(bool software) { m_software->setVisible(software); }

void StatisticsPanel::setLive(std::vector<LiveFigures> views) {
    m_live = std::move(views);
    if (!showsExperiment()) scheduleRefresh();
}

void StatisticsPanel::setResult(const ResultTable& table, const MeasureResult& result) {
    if (result.request.scene != m_scene) return;
    m_resultTable = table;
    m_result = result;
    scheduleRefresh();
}

void StatisticsPanel::setRunning(bool running) {
    m_bar->setRunning(running);
    m_running = running;
    for (PlotWidget* plot : plots()) plot->setMeasuring(running);
    if (!running) return refreshTablePage();
    m_result.reset();
    m_source->setCurrentIndex(1);
    refresh();
}

void StatisticsPanel::showTab(Tab tab) { m_tabs->setCurrentIndex(tab); }

bool StatisticsPanel::showsExperiment() const { return m_source->currentIndex() == 1; }

PlotWidget* StatisticsPanel::currentPlot() const {
    switch (m_tabs->currentIndex()) {
        case Times:
            return m_times;
        case Poses:
            return m_strip;
        case Path:
            return m_path;
        case Pareto:
            return m_pareto;
        case Sphere:
            return m_sphere;
        default:
            return nullptr;
    }
}

void StatisticsPanel::retranslate() {
    const std::array<QString, TabCount> tabs{tr("Table"),  tr("Times"),  tr("Poses"), tr("Plot"),
                                             tr("Pareto"), tr("Sphere"), tr("Race"),  tr("History")};
    for (int tab = 0; tab < TabCount; ++tab) m_tabs->setTabText(tab, tabs[size_t(tab)]);
    m_tabs->setAccessibleName(tr("Statistics"));
    m_source->setItemText(0, tr("at the present camera"));
    m_source->setItemText(1, tr("of the experiment"));
    m_source->setAccessibleName(tr("Which figures are shown"));
    m_run->setAccessibleName(tr("Strategy whose poses are shown"));
    retranslateAxes();
    m_race->setAccessibleName(tr("Each strategy against each"));
    m_table->setAccessibleName(tr("Results"));
    m_historyEmpty->setText(tr("Each experiment that ends appears here beside the others, also at later starts."));
    m_history->retranslate();
    m_past->retranslate();
    m_software->setText(tr("software OpenGL"));
    m_software->setToolTip(tr("Software OpenGL: not the times of a graphics card"));
    m_export->setText(tr("Export"));
    const std::array<QString, 6> files{tr("Frames as CSV…"), tr("Result as JSON…"), tr("Plot as SVG…"),
                                       tr("Plot as PDF…"),   tr("Report as HTML…"), tr("Report as PDF…")};
    for (qsizetype i = 0; i < m_menu->actions().size(); ++i) m_menu->actions()[i]->setText(files[size_t(i)]);
    m_chooseColumns->setText(tr("Columns"));
    m_chooseColumns->setToolTip(tr("Which columns the table shows"));
    m_model->retranslate();
    m_columns->retranslate();
    refresh();
}

void StatisticsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
