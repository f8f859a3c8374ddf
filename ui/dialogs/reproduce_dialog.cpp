#include "ui/dialogs/reproduce_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 460;
constexpr int kProgressSteps = 1000;

int stepsOf(double share) { return int(share * kProgressSteps); }

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
      m_progress(new QProgressBar(this)),
      m_start(new QPushButton(tr("&Start"), this)),
      m_cancel(new QPushButton(tr("&Cancel"), this)),
      m_export(new QPushButton(tr("E&xport"), this)),
      m_close(new QPushButton(tr("C&lose"), this)),
      m_files(new QMenu(this)) {
    setWindowTitle(tr("Reproduce a paper's table"));
    for (const PaperExperiment& experiment : paperExperiments())
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
    for (const File file : {File::Csv, File::Json})
        m_files->addAction(file == File::Csv ? QStringLiteral("CSV…") : QStringLiteral("JSON…"), this,
                           [this, file] { askWhereTo(file); });
    m_export->setMenu(m_files);
    for (QPushButton* button : {m_cancel, m_export, m_close}) button->setAutoDefault(false);
    makeRows();
    chooseNewest();
    wire(session);
    showChosen();
    resize(QSize(kWidth, kHeight).boundedTo(screen()->availableGeometry().size()));
}

/// What was measured is not lost with the dialog that it was measured in.
void ReproduceDialog::chooseNewest() {
    const std::vector<PaperExperiment>& all = paperExperiments();
    const auto newest = std::find_if(all.begin(), all.end(), [this](const PaperExperiment& experiment) {
        return experiment.id == m_runner.table().experiment;
    });
    if (newest != all.end()) m_choice->setCurrentIndex(int(newest - all.begin()));
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
    layout->addWidget(m_table, 1);
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
    connect(&m_runner, &PaperRunner::ended, this, [this] {
        showTable();
        makeWay();
    });
    connect(m_exporter, &ResultExporter::written, this, [&session](const QString& path) {
        session.raise(Severity::Information, {QT_TRANSLATE_NOOP("core", "Saved %1."), {path.toStdString()}});
    });
    connect(m_exporter, &ResultExporter::failed, this,
            [&session](const Message& message) { session.raise(Severity::Error, message); });
}

const PaperExperiment& ReproduceDialog::chosen() const { return paperExperiments()[size_t(m_choice->currentIndex())]; }

void ReproduceDialog::start() {
    m_runner.start(chosen());
    showState();
    makeWay();
}

/// The views are to be seen while they are measured: meanwhile the dialog is low, in the lower third of its window. Its whole
/// frame stays on the screen.
void ReproduceDialog::makeWay() {
    m_notes->setVisible(!m_runner.running());
    // What it takes at least without the notes.
    layout()->activate();
    const QRect screenPlace = screen()->availableGeometry();
    const QRect seen = parentWidget() ? parentWidget()->window()->frameGeometry().intersected(screenPlace) : QRect();
    const QRect place = seen.isEmpty() ? screenPlace : seen;
    const QSize frame = frameGeometry().size() - size();
    const int most = m_runner.running() ? place.height() / 3 : std::min(kHeight + frame.height(), screenPlace.height());
    // Afterwards every column is to be seen: the losses are in the last ones.
    const int beside = width() - m_table->viewport()->width();
    const int wide = m_runner.running() ? kWidth : std::max(kWidth, m_table->horizontalHeader()->length() + beside);
    resize(std::min(wide, screenPlace.width() - frame.width()), most - frame.height());
    const QSize taken = size() + frame;
    const int left = place.x() + (place.width() - taken.width()) / 2, top = place.bottom() + 1 - taken.height();
    move(std::clamp(left, screenPlace.left(), std::max(screenPlace.left(), screenPlace.right() + 1 - taken.width())),
         std::clamp(top, screenPlace.top(), std::max(screenPlace.top(), screenPlace.bottom() + 1 - taken.height())));
}

void ReproduceDialog::showChosen() {
    const PaperTable& newest = m_runner.table();
    m_model->setTable(newest.experiment == chosen().id ? newest : emptyTable(chosen()));
    QStringList notes;
    for (const Message& note : chosen().notes) notes << QStringLiteral("• ") + translated(note);
    m_notes->setText(notes.join(QLatin1Char('\n')));
    showState();
}

void ReproduceDialog::showTable() {
    m_model->setTable(m_runner.table());
    if (m_runner.running()) m_table->scrollToBottom();
    showState();
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
    showHeading();
    if (running) return;
    if (m_model->table().rows.empty()) return m_progress->reset();
    const bool stopped = m_model->table().interrupted;
    m_progress->setValue(stopped ? std::min(stepsOf(m_runner.share()), kProgressSteps - 1) : kProgressSteps);
    m_progress->setFormat(stopped ? tr("stopped early: what was measured until then") : tr("done"));
}

void ReproduceDialog::showHeading() {
    QString heading = QString::fromStdString(chosen().source);
    const PaperSetting& setting = chosen().settings.front();
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
    const QString ending = file == File::Csv ? QStringLiteral("csv") : QStringLiteral("json");
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    if (dialog.exec() == QDialog::Accepted) exportTo(file, dialog.selectedFiles().front().toStdString());
}

void ReproduceDialog::exportTo(File file, const std::filesystem::path& path) {
    m_exporter->write(path, [table = m_model->table(), file] {
        return QByteArray::fromStdString(file == File::Csv ? paperTableCsv(table) : paperTablesJson({table}));
    });
}

void ReproduceDialog::reject() {
    m_runner.cancel();
    QDialog::reject();
}

}  // namespace cullscope::ui
