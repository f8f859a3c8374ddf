#include "ui/dialogs/reproduce_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/experiments/experiment_list.h"
#include "ui/plots/plot_file.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 460;
constexpr int kPlotHeight = 600;  // with a plot
constexpr int kProgressSteps = 1000;
constexpr QSize kPlotFile{960, 480};

int stepsOf(double share) { return int(share * kProgressSteps); }

bool ofPlot(ReproduceDialog::File file) { return file == ReproduceDialog::File::Svg || file == ReproduceDialog::File::Pdf; }

QString endingOf(ReproduceDialog::File file) {
    const std::array<QString, 4> endings{QStringLiteral("csv"), QStringLiteral("json"), QStringLiteral("svg"),
                                         QStringLiteral("pdf")};
    return endings[size_t(file)];
}

}  // namespace

ReproduceDialog::ReproduceDialog(Session& session, PaperRunner& runner, QWidget* parent)
    : QDialog(parent),
      m_runner(runner),
      m_exporter(new ResultExporter(this)),
      m_model(new PaperTableModel(this)),
      m_choice(new QComboBox(this)),
      m_source(new QLabel(this)),
      m_notes(new QLabel(this)),
      m_table(new QTableView(this)),
      m_plots{new LinePlotWidget(this)},
      m_pages(new QTabWidget(this)),
      m_progress(new QProgressBar(this)),
      m_start(new QPushButton(tr("&Start"), this)),
      m_cancel(new QPushButton(tr("&Cancel"), this)),
      m_export(new QPushButton(tr("E&xport"), this)),
      m_close(new QPushButton(tr("C&lose"), this)),
      m_files(new QMenu(this)) {
    setWindowTitle(tr("Reproduce a paper's table"));
    for (const Experiment& experiment : knownExperiments())
        m_choice->addItem(QStringLiteral("%1: %2").arg(QString::fromStdString(experiment.id), translated(experiment.title)));
    m_choice->setAccessibleName(tr("Table"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("The paper's numbers beside ours"));
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    for (QHeaderView* header : {m_table->horizontalHeader(), m_table->verticalHeader()})
        header->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_progress->setRange(0, kProgressSteps);
    m_progress->setAccessibleName(tr("Progress"));
    makePages();
    makeMenu();
    for (QPushButton* button : {m_cancel, m_export, m_close}) button->setAutoDefault(false);
    makeRows();
    chooseNewest();
    wire(session);
    resize(QSize(kWidth, kHeight).boundedTo(screen()->availableGeometry().size()));
    showChosen();
}

/// Chooses the experiment measured last, so that a new dialog shows the results of the one closed before.
void ReproduceDialog::chooseNewest() {
    const std::vector<Experiment>& all = knownExperiments();
    const auto newest = std::find_if(
        all.begin(), all.end(), [this](const Experiment& experiment) { return experiment.id == m_runner.table().experiment; });
    if (newest != all.end()) m_choice->setCurrentIndex(int(newest - all.begin()));
}

void ReproduceDialog::makePages() {
    m_pages->addTab(m_table, tr("Table"));
    m_pages->addTab(m_plots.front(), tr("Plot"));
    m_pages->setDocumentMode(true);
}

void ReproduceDialog::makeMenu() {
    for (const File file : {File::Csv, File::Json, File::Svg, File::Pdf})
        m_files->addAction(endingOf(file).toUpper() + QStringLiteral("…"), this, [this, file] { askWhereTo(file); })
            ->setData(ofPlot(file));
    m_export->setMenu(m_files);
}

void ReproduceDialog::makeRows() {
    for (QLabel* label : {m_source, m_notes}) label->setWordWrap(true);
    m_source->setEnabled(false);
    auto* top = new QHBoxLayout;
    top->addWidget(m_choice, 1);
    top->addWidget(m_start);
    top->addWidget(m_cancel);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_progress, 1);
    bottom->addWidget(m_export);
    bottom->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_source);
    layout->addWidget(m_pages, 1);
    layout->addWidget(m_notes);
    layout->addLayout(bottom);
}

void ReproduceDialog::wire(Session& session) {
    connect(m_choice, &QComboBox::currentIndexChanged, this, &ReproduceDialog::showChosen);
    connect(m_start, &QPushButton::clicked, this, &ReproduceDialog::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        m_runner.cancel();
    });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_runner, &PaperRunner::progressed, this, &ReproduceDialog::showProgress);
    connect(&m_runner, &PaperRunner::tableChanged, this, &ReproduceDialog::showTable);
    connect(&m_runner, &PaperRunner::plotsChanged, this, [this] { showPlots(m_runner.table()); });
    connect(&m_runner, &PaperRunner::ended, this, [this] {
        showTable();
        makeWay();
    });
    connect(m_exporter, &ResultExporter::written, &session, &Session::tellSaved);
    connect(m_exporter, &ResultExporter::failed, this,
            [&session](const Message& message) { session.raise(Severity::Error, message); });
}

const Experiment& ReproduceDialog::chosen() const { return knownExperiments()[size_t(m_choice->currentIndex())]; }

void ReproduceDialog::start() {
    m_runner.start(chosen());
    // Table rows are added at the end of a setting, points of the plot after each view.
    if (hasPlot()) m_pages->setCurrentWidget(m_plots.front());
    showState();
    makeWay();
}

/// Lets the user see the views during the measurement: shrinks the dialog to a low strip at the bottom of its window. Its whole
/// frame stays on the screen.
void ReproduceDialog::makeWay() {
    m_notes->setVisible(!m_runner.running());
    // Compute the minimum size without the notes.
    layout()->activate();
    const QRect screenPlace = screen()->availableGeometry();
    const QRect seen = parentWidget() ? parentWidget()->window()->frameGeometry().intersected(screenPlace) : QRect();
    const QRect place = seen.isEmpty() ? screenPlace : seen;
    const QSize frame = frameGeometry().size() - size();
    // A plot needs more height than rows.
    const int low = hasPlot() ? place.height() / 2 : place.height() / 3, high = hasPlot() ? kPlotHeight : kHeight;
    const int most = m_runner.running() ? low : std::min(high + frame.height(), screenPlace.height());
    // After the measurement every column must be visible: the losses are in the last ones.
    const int beside = width() - m_pages->width() + m_table->width() - m_table->viewport()->width();
    const int wanted = m_runner.running() ? kWidth : std::max(kWidth, m_table->horizontalHeader()->length() + beside);
    const int wide = std::min(wanted, screenPlace.width() - frame.width());
    resize(wide, most - frame.height());
    growTo(leastHeight(wide));
    const QSize taken = size() + frame;
    moveOnScreen({place.x() + (place.width() - taken.width()) / 2, place.bottom() + 1 - taken.height()});
}

/// Moves the top left corner of the frame to `corner`, or to the nearest point at which the whole frame is on the screen.
void ReproduceDialog::moveOnScreen(const QPoint& corner) {
    const QRect place = screen()->availableGeometry();
    const QSize taken = size() + frameGeometry().size() - geometry().size();
    move(std::clamp(corner.x(), place.left(), std::max(place.left(), place.right() + 1 - taken.width())),
         std::clamp(corner.y(), place.top(), std::max(place.top(), place.bottom() + 1 - taken.height())));
}

/// The height that shows all contents. A dialog's minimumSize() ignores that wrapped labels take more lines when it is narrow.
int ReproduceDialog::leastHeight(int width) const {
    // Otherwise the layout takes the plot's new size hint into account only in the next event loop.
    m_pages->updateGeometry();
    return std::max(layout()->totalMinimumSize().height(), layout()->minimumHeightForWidth(width));
}

/// Makes the dialog at least that high, as far as the screen allows, and keeps it on the screen.
void ReproduceDialog::growTo(int height) {
    const int frame = frameGeometry().height() - this->height();
    const int wanted = std::min(height, screen()->availableGeometry().height() - frame);
    if (this->height() >= wanted) return;
    resize(width(), wanted);
    if (isVisible()) moveOnScreen(frameGeometry().topLeft());
}

/// A plot and its notes need more height than rows.
void ReproduceDialog::makeRoom() {
    if (hasPlot()) growTo(kPlotHeight);
}

void ReproduceDialog::showChosen() {
    const ResultTable& newest = m_runner.table();
    m_model->setTable(newest.experiment == chosen().id ? newest : emptyTable(chosen()));
    showPlots(m_model->table());
    showNotes();
    showState();
    makeRoom();
}

void ReproduceDialog::showPlots(const ResultTable& table) {
    const size_t count = std::max<size_t>(1, table.plots.size());
    for (; m_plots.size() > count; m_plots.pop_back()) delete m_plots.back();
    while (m_plots.size() < count) m_pages->addTab(m_plots.emplace_back(new LinePlotWidget(m_pages)), QString());
    for (size_t i = 0; i < count; ++i) {
        m_plots[i]->setPlot(hasPlot() ? table.plots[i] : LinePlot());
        m_pages->setTabText(m_pages->indexOf(m_plots[i]), count == 1 ? tr("Plot") : m_plots[i]->title());
    }
    m_pages->tabBar()->setVisible(hasPlot());
    if (!hasPlot()) m_pages->setCurrentWidget(m_table);
    // The first lines make the legend higher.
    if (isVisible()) growTo(leastHeight(width()));
}

LinePlotWidget& ReproduceDialog::plotInFront() const {
    auto* plot = qobject_cast<LinePlotWidget*>(m_pages->currentWidget());
    return plot != nullptr ? *plot : *m_plots.front();
}

void ReproduceDialog::showTable() {
    m_model->setTable(m_runner.table());
    showPlots(m_runner.table());
    showNotes();
    if (m_runner.running()) m_table->scrollToBottom();
    showState();
}

void ReproduceDialog::showNotes() {
    QStringList notes;
    for (const Message& note : m_model->table().notes) notes << QStringLiteral("• ") + translated(note);
    m_notes->setText(notes.join(QLatin1Char('\n')));
}

void ReproduceDialog::showProgress(double share, const QString& stage) {
    m_progress->setValue(stepsOf(share));
    m_progress->setFormat(stage.isEmpty() ? QStringLiteral("%p %")
                                          : QStringLiteral("%1 · %p %").arg(translated(stage.toStdString())));
}

void ReproduceDialog::showState() {
    const bool running = m_runner.running();
    m_choice->setEnabled(!running);
    m_start->setEnabled(!running);
    m_cancel->setEnabled(running);
    m_export->setEnabled(!running && !m_model->table().rows.empty());
    for (QAction* action : m_files->actions()) action->setEnabled(hasPlot() || !action->data().toBool());
    showHeading();
    if (running) return;
    if (m_model->table().rows.empty()) return m_progress->reset();
    const bool stopped = m_model->table().interrupted;
    m_progress->setValue(stopped ? std::min(stepsOf(m_runner.share()), kProgressSteps - 1) : kProgressSteps);
    m_progress->setFormat(stopped ? tr("stopped early: what was measured until then") : tr("done"));
}

void ReproduceDialog::showHeading() {
    QString heading = QString::fromStdString(chosen().source);
    const Setting& setting = chosen().settings.front();
    if (m_runner.running() && setting.timed()) {
        QStringList others;
        for (const std::string& strategy : setting.strategies)
            if (strategy != setting.shown) others << QString::fromStdString(strategy);
        heading += QStringLiteral(" · ") +
                   tr("The views show %1 at the view being measured; beside it, off the window, are measured: %2.")
                       .arg(QString::fromStdString(setting.shown), others.join(QStringLiteral(", ")));
    }
    m_source->setText(heading);
}

void ReproduceDialog::askWhereTo(File file) {
    const QString ending = endingOf(file);
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    if (dialog.exec() == QDialog::Accepted) exportTo(file, dialog.selectedFiles().front().toStdString());
}

void ReproduceDialog::exportTo(File file, const std::filesystem::path& path) {
    if (ofPlot(file)) {
        // Render the plot here: widgets are painted on the window's thread only.
        if (!hasPlot()) return;
        const LinePlotWidget& plot = plotInFront();
        const QByteArray bytes = file == File::Svg ? plotSvg(plot, kPlotFile) : plotPdf(plot, kPlotFile);
        return m_exporter->write(path, [bytes] { return bytes; });
    }
    m_exporter->write(path, [table = m_model->table(), file] {
        return QByteArray::fromStdString(file == File::Csv ? tableCsv(table) : tablesJson({table}));
    });
}

void ReproduceDialog::reject() {
    m_runner.cancel();
    QDialog::reject();
}

}  // namespace cullscope::ui
