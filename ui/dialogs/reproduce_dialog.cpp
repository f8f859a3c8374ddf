#include "ui/dialogs/reproduce_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kWidth = 1160;
constexpr int kHeight = 460;
constexpr int kLowHeight = 240;
constexpr int kProgressSteps = 1000;

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
    m_progress->setRange(0, kProgressSteps);
    m_progress->setAccessibleName(tr("Progress"));
    for (const File file : {File::Csv, File::Json})
        m_files->addAction(file == File::Csv ? QStringLiteral("CSV…") : QStringLiteral("JSON…"), this,
                           [this, file] { askWhereTo(file); });
    m_export->setMenu(m_files);
    for (QPushButton* button : {m_cancel, m_export, m_close}) button->setAutoDefault(false);
    makeRows();
    wire(session);
    showChosen();
    resize(kWidth, kHeight);
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
        makeWay();
        showTable();
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
    makeWay();
    showState();
}

/// The views are to be seen while they are measured: meanwhile the dialog is low, at the lower edge of its window.
void ReproduceDialog::makeWay() {
    m_notes->setVisible(!m_runner.running());
    resize(width(), m_runner.running() ? kLowHeight : kHeight);
    if (const QWidget* window = parentWidget()) {
        const QRect place = window->geometry();
        move(place.x() + (place.width() - width()) / 2, place.bottom() - height());
    }
}

void ReproduceDialog::showChosen() {
    m_model->setTable(emptyTable(chosen()));
    m_source->setText(QString::fromStdString(chosen().source));
    QStringList notes;
    for (const Message& note : chosen().notes) notes << QStringLiteral("• ") + translated(note);
    m_notes->setText(notes.join(QLatin1Char('\n')));
    m_progress->reset();
    showState();
}

void ReproduceDialog::showTable() {
    m_model->setTable(m_runner.table());
    m_table->resizeColumnsToContents();
    showState();
}

void ReproduceDialog::showProgress(double share, const QString& stage) {
    m_progress->setValue(int(share * kProgressSteps));
    m_progress->setFormat(stage.isEmpty() ? QStringLiteral("%p %")
                                          : QStringLiteral("%1 · %p %").arg(translated(stage.toStdString())));
}

void ReproduceDialog::showState() {
    const bool running = m_runner.running();
    m_choice->setEnabled(!running);
    m_start->setEnabled(!running);
    m_cancel->setEnabled(running);
    m_export->setEnabled(!running && !m_model->table().rows.empty());
    if (running || m_model->table().rows.empty()) return;
    m_progress->setValue(kProgressSteps);
    m_progress->setFormat(m_model->table().interrupted ? tr("stopped early: what was measured until then") : tr("done"));
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
