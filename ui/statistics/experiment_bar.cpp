#include "ui/statistics/experiment_bar.h"

#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <cmath>

#include "core/base/error.h"
#include "ui/look/wheel_guard.h"
#include "ui/statistics/flow_layout.h"
#include "ui/statistics/run_sweeps.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kSpacing = 6;
constexpr int kMostPoses = 10'000;
constexpr int kMostRepetitions = 1000;
// Item data of the path list: the id of a built-in path, or one of these.
const QString kRecorded = QStringLiteral("<recorded>");
const QString kOpened = QStringLiteral("<opened>");
const QString kOpen = QStringLiteral("<open>");

/// The id without its number: "orbit" of "orbit:N".
QString pathId(const BuiltInPath& path) { return QString::fromStdString(path.id).section(QLatin1Char(':'), 0, 0); }
bool takesNumber(const QString& id) {
    for (const BuiltInPath& path : builtInPaths())
        if (pathId(path) == id) return QString::fromStdString(path.id).contains(QLatin1Char(':'));
    return false;
}

}  // namespace

ExperimentBar::ExperimentBar(QWidget* parent)
    : QWidget(parent),
      m_path(new QComboBox(this)),
      m_poses(new QSpinBox(this)),
      m_size(new QComboBox(this)),
      m_repetitions(new QSpinBox(this)),
      m_start(new QPushButton(this)),
      m_sweep(new QToolButton(this)),
      m_sweeps(new QMenu(this)),
      m_progress(new QProgressBar(this)) {
    auto* layout = new FlowLayout(this, kSpacing, kSpacing);
    layout->setContentsMargins(0, 0, 0, 0);
    m_poses->setRange(1, kMostPoses);
    m_poses->setValue(16);
    m_repetitions->setRange(0, kMostRepetitions);
    m_path->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_size->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_progress->setRange(0, 100);
    m_progress->setFixedWidth(120);
    for (QWidget* field : std::initializer_list<QWidget*>{m_path, m_poses, m_size, m_repetitions}) {
        layout->addWidget(field);
        leaveWheelUnlessFocused(*field);
    }
    layout->addWidget(m_start);
    layout->addWidget(m_sweep);
    layout->addWidget(m_progress);
    connect(m_path, &QComboBox::activated, this, &ExperimentBar::choosePath);
    setUpSweeps();
    connect(m_start, &QPushButton::clicked, this, [this] { m_running ? emit cancelRequested() : start(); });
    retranslate();
}

void ExperimentBar::setScene(ScenePointer scene) {
    m_scene = std::move(scene);
    if (m_scene) {
        const QString usual = QString::fromStdString(defaultPathName(*m_scene));
        // A path that the user chose is kept for another scene, unless it was recorded in the former one.
        if (!m_pathChosen || m_path->itemData(m_chosen) == kRecorded)
            m_chosen = std::max(0, m_path->findData(usual.section(QLatin1Char(':'), 0, 0)));
        m_path->setCurrentIndex(m_chosen);
    }
    refresh();
}

void ExperimentBar::setCurrentSize(const Viewport& size) {
    if (size == m_currentSize) return;
    m_currentSize = size;
    setUpSizes();
}

void ExperimentBar::setRecordedPath(std::optional<CameraPath> path) {
    m_recorded = std::move(path);
    fillPaths();
}

void ExperimentBar::openPath(const QString& file) {
    try {
        CameraPath path = readCameraPath(file.toStdString());
        path.name = QFileInfo(file).absoluteFilePath().toStdString();
        m_opened = std::move(path);
    } catch (const Error& error) {
        emit failed(error.message());
        return;
    }
    fillPaths();
    m_chosen = m_path->findData(kOpened);
    m_pathChosen = true;
    m_path->setCurrentIndex(m_chosen);
    refresh();
}

void ExperimentBar::fillPaths() {
    const QVariant chosen = m_path->itemData(m_chosen);
    m_path->clear();
    for (const BuiltInPath& path : builtInPaths()) {
        m_path->addItem(pathId(path), pathId(path));
        m_path->setItemData(m_path->count() - 1, translated(path.description), Qt::ToolTipRole);
    }
    if (m_recorded) m_path->addItem(tr("recorded path"), kRecorded);
    if (m_opened) m_path->addItem(QFileInfo(QString::fromStdString(m_opened->name)).fileName(), kOpened);
    m_path->addItem(tr("Open a path file…"), kOpen);
    m_chosen = std::max(0, m_path->findData(chosen));
    m_path->setCurrentIndex(m_chosen);
    refresh();
}

void ExperimentBar::choosePath(int row) {
    if (m_path->itemData(row) != kOpen) {
        m_chosen = row;
        m_pathChosen = true;
        return refresh();
    }
    m_path->setCurrentIndex(m_chosen);
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a camera path"), {}, tr("Camera paths (*.json)"));
    if (!file.isEmpty()) openPath(file);
}

void ExperimentBar::setUpSizes() {
    const int chosen = std::max(0, m_size->currentIndex());
    m_size->clear();
    m_size->addItem(QStringLiteral("320 × 240"), QSize(320, 240));
    m_size->addItem(QStringLiteral("640 × 480"), QSize(640, 480));
    m_size->addItem(tr("as the view: %1 × %2").arg(m_currentSize.width).arg(m_currentSize.height),
                    QSize(m_currentSize.width, m_currentSize.height));
    m_size->setCurrentIndex(chosen);
}

void ExperimentBar::setUpSweeps() {
    m_sweep->setPopupMode(QToolButton::InstantPopup);
    m_sweep->setFocusPolicy(Qt::StrongFocus);
    m_sweep->setMenu(m_sweeps);
    m_sweeps->addAction({}, this, [this] { start(builtInSweeps()); });
    m_sweeps->addSeparator();
    for (const ParameterSweep& sweep : builtInSweeps()) m_sweeps->addAction({}, this, [this, sweep] { start({sweep}); });
}

void ExperimentBar::choosePathFor(ExperimentSettings& settings) const {
    const QString id = m_path->itemData(m_chosen).toString();
    if (id == kRecorded) settings.poses = m_recorded;
    if (id == kOpened) settings.poses = m_opened;
    const QString name = takesNumber(id) ? id + QLatin1Char(':') + QString::number(m_poses->value()) : id;
    settings.path = settings.poses ? settings.poses->name : name.toStdString();
}

void ExperimentBar::start(const std::vector<ParameterSweep>& sweeps) {
    if (!m_scene || m_running) return;
    ExperimentSettings settings;
    choosePathFor(settings);
    const QSize size = m_size->currentData().toSize();
    settings.size = {size.width(), size.height()};
    settings.repetitions = m_repetitions->value();
    settings.sweeps = sweeps;
    emit startRequested(settings);
}

void ExperimentBar::setRunning(bool running) {
    m_running = running;
    m_progress->setValue(0);
    refresh();
}

void ExperimentBar::setProgress(double share, const QString& stage) {
    m_progress->setValue(int(std::lround(100.0 * share)));
    const QString words = translated(stage.toStdString());
    m_progress->setToolTip(words);
    m_progress->setAccessibleDescription(words);
}

void ExperimentBar::refresh() {
    for (QWidget* field : std::initializer_list<QWidget*>{m_path, m_poses, m_size, m_repetitions})
        field->setEnabled(m_scene && !m_running);
    m_poses->setVisible(takesNumber(m_path->itemData(m_chosen).toString()));
    m_path->setToolTip(m_path->itemData(m_chosen, Qt::ToolTipRole).toString());
    m_start->setEnabled(m_scene != nullptr);
    m_start->setText(m_running ? tr("Cancel") : tr("Start"));
    m_start->setToolTip(m_scene ? QString() : tr("Open a scene first"));
    m_sweep->setEnabled(m_scene && !m_running);
    m_sweep->setToolTip(m_scene
                            ? tr("Measures strategies at several values of a parameter and joins their points in the Pareto plot")
                            : tr("Open a scene first"));
    m_progress->setVisible(m_running);
}

void ExperimentBar::retranslate() {
    m_path->setAccessibleName(tr("Camera path"));
    m_poses->setAccessibleName(tr("Number of poses"));
    m_poses->setPrefix(tr("poses: "));
    m_size->setAccessibleName(tr("Size of the picture"));
    m_size->setToolTip(m_size->accessibleName());
    m_repetitions->setAccessibleName(tr("Repetitions of each frame"));
    m_repetitions->setToolTip(m_repetitions->accessibleName());
    m_repetitions->setSpecialValueText(tr("repeat until steady"));
    m_repetitions->setPrefix(tr("repetitions: "));
    m_sweep->setText(tr("Sweep"));
    const QList<QAction*> sweeps = m_sweeps->actions();
    sweeps.front()->setText(tr("All of these", "sweeps over parameters"));
    // + 2: the action for all sweeps and the separator come first.
    for (size_t i = 0; i < builtInSweeps().size(); ++i) sweeps[qsizetype(i) + 2]->setText(sweepWords(builtInSweeps()[i]));
    m_progress->setAccessibleName(tr("Progress of the experiment"));
    setUpSizes();
    fillPaths();
}

void ExperimentBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
