#include "ui/dialogs/advise_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QScreen>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/experiments/reports.h"
#include "core/measure/field_figures.h"
#include "ui/look/row_table.h"
#include "ui/plots/plot_file.h"
#include "ui/statistics/history_store.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr QSize kAdviseSize{1256, 760};
constexpr int kRowHeight = 22;
constexpr QSize kAdvisePlotSize{960, 480};
constexpr double kPerMillion = 1e6;
constexpr double kAnswerLetters = 1.25;  // of the usual size
enum AdviceColumn { Name, PromiseOf, Speed, Headroom, Frame, Views, Missed, Build, Bytes, PaidBack, Came, AdviceColumns };

/// As the plot shows it.
RunFigures figuresOf(const advice::AdvisedStrategy& strategy) {
    RunFigures figures;
    figures.label = runLabel(strategy.strategy);
    figures.id = QString::fromStdString(strategy.strategy.id);
    figures.role = findStrategy(strategy.strategy.id).info.baseline;
    figures.baseline = figures.role != BaselineRole::None;
    figures.limit = strategy.limit;
    figures.parameters = strategy.strategy.parameters;
    figures.promise = strategy.promise;
    figures.frameMilliseconds = strategy.frameMilliseconds;
    figures.poses.resize(strategy.judgedViews > 0 ? strategy.judgedViews : strategy.views);
    figures.judged = strategy.judgedViews > 0;
    return figures;
}

std::vector<RunFigures> pointsOf(const advice::Advice& advice) {
    std::vector<RunFigures> points;
    for (const advice::AdvisedStrategy* strategy : advice::pictured(advice)) {
        RunFigures figures = figuresOf(*strategy);
        figures.values = advice::tradePoint(*strategy).values;
        if (const auto lost = figures.values.find(kUsualUp); lost != figures.values.end())
            figures.missedPpm = lost->second.ratio * kPerMillion;
        points.push_back(std::move(figures));
    }
    return points;
}

QString missedWords(const advice::AdvisedStrategy& strategy) {
    const std::optional<double> rate = strategy.missedRate();
    if (!rate) return QStringLiteral("–");
    return *rate > 0.0 ? significantText(*rate * kPerMillion) : translated(noLossIn(strategy.judgedViews));
}

std::array<QString, AdviceColumns> cellsOf(const advice::AdvisedStrategy& strategy) {
    const QString none = QStringLiteral("–");
    const bool timed = strategy.views > 0;
    return {runLabel(strategy.strategy),
            strategy.built ? promiseWord(strategy.promise) : none,
            strategy.ratioToAll ? speedWithInterval(*strategy.ratioToAll) : none,
            strategy.headroomShare ? percentText(strategy.headroomShare->ratio) + QStringLiteral(" %") : none,
            timed ? millisecondsText(strategy.frameMilliseconds) : none,
            timed ? countText(strategy.views) : none,
            missedWords(strategy),
            strategy.built ? millisecondsText(strategy.structure.buildMilliseconds) : none,
            strategy.built ? bytesText(strategy.structure.bytes) : none,
            strategy.paybackFrames ? countText(uint64_t(std::ceil(*strategy.paybackFrames))) : none,
            translated(advice::standingWords(strategy))};
}

}  // namespace

AdviseDialog::AdviseDialog(Session& session, QWidget* parent)
    : RunDialog(session, Measures::Times, parent),
      m_path(new QComboBox(this)),
      m_size(new QComboBox(this)),
      m_mayMiss(new QDoubleSpinBox(this)),
      m_answer(new QLabel(this)),
      m_table(new QTableWidget(this)),
      m_plot(new ParetoPlot(this)),
      m_progress(new QProgressBar(this)),
      m_start(new QPushButton(tr("&Advise"), this)),
      m_cancel(new QPushButton(tr("C&ancel"), this)),
      m_show(new QPushButton(tr("&Show it in the active view"), this)),
      m_export(new QPushButton(tr("&Export"), this)),
      m_close(new QPushButton(tr("C&lose"), this)),
      m_exporter(new ResultExporter(this)) {
    setWindowTitle(tr("Advice: which strategy suits this scene"));
    auto* layout = new QVBoxLayout(this);
    auto* top = new QHBoxLayout;
    setUpTop(*top);
    m_answer->setWordWrap(true);
    QFont letters = m_answer->font();
    letters.setPointSizeF(letters.pointSizeF() * kAnswerLetters);
    m_answer->setFont(letters);
    m_answer->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setUpTable();
    m_plot->setAxes(tradeFigure("ratio_to_all"), tradeFigure(kUsualUp));
    m_plot->setEmptySentence(tr("Nothing is measured yet. Choose a camera path above and press Advise."));
    auto* parts = new QSplitter(Qt::Vertical, this);
    parts->addWidget(m_table);
    parts->addWidget(m_plot);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 4);
    auto* bottom = new QHBoxLayout;
    setUpBottom(*bottom);
    layout->addLayout(top);
    layout->addWidget(m_answer);
    layout->addWidget(parts, 1);
    layout->addLayout(bottom);
    connect(m_plot, &ParetoPlot::strategyChosen, this, &AdviseDialog::strategyWanted);
    connect(m_exporter, &ResultExporter::written, this, [this](const QString& path) { m_session.tellSaved(path); });
    connect(m_exporter, &ResultExporter::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    showState();
    resize(kAdviseSize.boundedTo(screen()->availableGeometry().size()));
}

void AdviseDialog::setUpTop(QLayout& layout) {
    const QString usual = m_session.scene() ? QString::fromStdString(defaultPathName(*m_session.scene())) : QString();
    m_path->setEditable(true);
    for (const char* path : {"tour:16", "walk:16", "fibonacci:16", "orbit:16"}) m_path->addItem(QString::fromLatin1(path));
    m_path->setCurrentText(usual);
    m_path->setAccessibleName(tr("Camera path"));
    m_path->setToolTip(tr("A built-in camera path, or a file"));
    m_size->addItem(QStringLiteral("320 × 240"), QSize(320, 240));
    m_size->addItem(QStringLiteral("640 × 480"), QSize(640, 480));
    m_size->setCurrentIndex(1);
    m_size->setAccessibleName(tr("Size of the picture"));
    m_mayMiss->setRange(0.0, kPerMillion);
    m_mayMiss->setDecimals(1);
    m_mayMiss->setSpecialValueText(tr("nothing may be missed"));
    m_mayMiss->setPrefix(tr("may miss: "));
    m_mayMiss->setSuffix(tr(" per million"));
    m_mayMiss->setAccessibleName(tr("How many of a million covered pixels may be missed"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_path, m_size, m_mayMiss}) layout.addWidget(widget);
    static_cast<QHBoxLayout&>(layout).addStretch(1);
    layout.addWidget(m_start);
    layout.addWidget(m_cancel);
    connect(m_start, &QPushButton::clicked, this, &AdviseDialog::start);
    cancelBy(m_cancel);
}

void AdviseDialog::setUpTable() {
    setUpRows(*m_table, {tr("Strategy"), tr("Promise"), tr("× everything"), tr("Headroom"), tr("Frame"), tr("Views"),
                         tr("Missed, ppm"), tr("Build time"), tr("Structure"), tr("Paid back, frames"), tr("How it came out")});
    m_table->horizontalHeaderItem(Headroom)->setToolTip(tr("Share of the time saved that any culling could save"));
    m_table->horizontalHeaderItem(Missed)->setToolTip(tr("Missed of a million covered pixels"));
    m_table->horizontalHeaderItem(Views)->setToolTip(
        tr("How many views were timed. Of a strategy that left early, speed and frame time are the best one's, times how both "
           "compare at these views."));
    m_table->setAccessibleName(tr("Strategies by their speed"));
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &AdviseDialog::showState);
    connect(m_table, &QTableWidget::cellActivated, this, &AdviseDialog::showChosen);
}

void AdviseDialog::setUpBottom(QLayout& layout) {
    m_progress->setAccessibleName(tr("Progress"));
    auto* files = new QMenu(m_export);
    files->addAction(tr("Advice as JSON…"), this, [this] { askWhereTo(File::Json); });
    files->addAction(tr("Points as CSV…"), this, [this] { askWhereTo(File::Csv); });
    files->addAction(tr("Plot as SVG…"), this, [this] { askWhereTo(File::Svg); });
    files->addAction(tr("Plot as PDF…"), this, [this] { askWhereTo(File::Pdf); });
    m_export->setMenu(files);
    static_cast<QHBoxLayout&>(layout).addWidget(m_progress, 1);
    for (QPushButton* button : {m_show, m_export, m_close}) layout.addWidget(button);
    for (QPushButton* button : {m_cancel, m_show, m_export, m_close}) button->setAutoDefault(false);
    connect(m_show, &QPushButton::clicked, this, &AdviseDialog::showChosen);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void AdviseDialog::start() {
    if (running() || !m_session.scene()) return;
    advice::AdviseRequest request;
    request.scene = m_session.scene();
    const QSize size = m_size->currentData().toSize();
    request.size = {size.width(), size.height()};
    request.maxMissed = m_mayMiss->value() / kPerMillion;
    m_advice.reset();
    run([this, request, path = m_path->currentText().toStdString()](const Progress& progress) mutable -> Result {
        request.path = cameraPath(path, *request.scene, {nullptr, progress.stop});
        return [this, advice = advice::advise(request, progress)] {
            if (advice.best) setAdvice(advice);
            if (!advice.interrupted) keepReport(m_session, reportOf(advice));
        };
    });
}

void AdviseDialog::showProgress(double share) { m_progress->setValue(int(100.0 * share)); }

void AdviseDialog::showFailure(const Message& failure) { m_answer->setText(translated(failure)); }

void AdviseDialog::setAdvice(const advice::Advice& advice) {
    m_advice = advice;
    m_table->setRowCount(int(advice.strategies.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const std::array<QString, AdviceColumns> cells = cellsOf(advice.strategies[size_t(row)]);
        for (int column = 0; column < AdviceColumns; ++column) {
            auto* item = new QTableWidgetItem(cells[size_t(column)]);
            const bool words = column == Name || column == PromiseOf || column == Came;
            item->setTextAlignment((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
    m_plot->setRuns(pointsOf(advice));
    m_table->selectRow(0);
    showState();
}

void AdviseDialog::showState() {
    m_start->setEnabled(!running() && m_session.scene());
    m_cancel->setEnabled(running());
    m_export->setEnabled(m_advice.has_value());
    m_show->setEnabled(m_advice && m_table->currentRow() >= 0);
    m_plot->setMeasuring(running());
    if (!running()) m_progress->setValue(m_advice ? 100 : 0);
    if (running())
        m_answer->setText(tr("Strategies are being tried on this scene; those that cannot win leave the race early…"));
    else if (!m_advice)
        m_answer->setText(
            tr("Each strategy that can serve this scene is measured over a camera path, and what cannot win is left "
               "out early. The answer says which one suits, what it would lose, and what its structure costs."));
    else {
        QStringList sentences;
        for (const Message& sentence : advice::sentences(*m_advice)) sentences << translated(sentence);
        m_answer->setText(sentences.join(QLatin1Char(' ')));
    }
}

void AdviseDialog::showChosen() {
    const int row = m_table->currentRow();
    if (m_advice && row >= 0) emit strategyWanted(m_advice->strategies[size_t(row)].strategy);
}

void AdviseDialog::askWhereTo(File file) {
    const std::array<QString, 4> endings{QStringLiteral("json"), QStringLiteral("csv"), QStringLiteral("svg"),
                                         QStringLiteral("pdf")};
    const QString ending = endings[size_t(file)];
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    if (dialog.exec() == QDialog::Accepted) exportTo(file, dialog.selectedFiles().front().toStdString());
}

void AdviseDialog::exportTo(File file, const std::filesystem::path& path) {
    if (!m_advice) return;
    QByteArray bytes;
    if (file == File::Json) bytes = QByteArray::fromStdString(adviceJson(*m_advice));
    if (file == File::Csv) bytes = QByteArray::fromStdString(tradeCsv(advice::tradePoints(*m_advice)));
    if (file == File::Svg) bytes = plotSvg(*m_plot, kAdvisePlotSize);
    if (file == File::Pdf) bytes = plotPdf(*m_plot, kAdvisePlotSize);
    m_exporter->write(path, [bytes] { return bytes; });
}

}  // namespace cullscope::ui
