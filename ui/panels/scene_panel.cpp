#include "ui/panels/scene_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/wheel_guard.h"
#include "ui/panels/split_dialog.h"

namespace cullscope::ui {

namespace {

constexpr int kFactHeight = 18;
constexpr int kReportHeight = 84;
constexpr int kMostFacts = 14;

}  // namespace

ScenePanel::ScenePanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_scene(new SceneModel(this)),
      m_report(new ReportModel(this)),
      m_facts(new QTableView(this)),
      m_upTitle(new QLabel(this)),
      m_up(new QComboBox(this)),
      m_upSource(new QLabel(this)),
      m_reportTitle(new QLabel(this)),
      m_sentences(new QListView(this)),
      m_outliner(new Outliner(session, this)) {
    for (QPushButton** button : {&m_hide, &m_show, &m_frame, &m_isolate, &m_showAll, &m_split}) *button = new QPushButton(this);
    setUpFacts();
    setUpReport();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_facts);
    layout->addLayout(makeUpRow());
    layout->addWidget(m_reportTitle);
    layout->addWidget(m_sentences);
    layout->addWidget(m_outliner, 1);
    layout->addLayout(makeButtons());
    setFocusProxy(&m_outliner->search());
    connect(&session, &Session::sceneChanged, this, &ScenePanel::refresh);
    // A change of the up axis moves the cameras, or leaves them where they were.
    connect(&session, &Session::cameraChanged, this, &ScenePanel::showUp);
    connect(m_outliner, &Outliner::stateChanged, this, &ScenePanel::enableButtons);
    retranslate();
    refresh();
}

void ScenePanel::setUpFacts() {
    m_facts->setModel(m_scene);
    m_facts->setFrameShape(QFrame::NoFrame);
    m_facts->setShowGrid(false);
    m_facts->setSelectionMode(QAbstractItemView::NoSelection);
    m_facts->setTabKeyNavigation(false);
    m_facts->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_facts->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_facts->setWordWrap(false);
    m_facts->horizontalHeader()->hide();
    m_facts->verticalHeader()->hide();
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_facts->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_facts->verticalHeader()->setMinimumSectionSize(kFactHeight);
    m_facts->verticalHeader()->setDefaultSectionSize(kFactHeight);
    m_facts->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
}

QHBoxLayout* ScenePanel::makeUpRow() {
    leaveWheelUnlessFocused(*m_up);
    m_up->addItem(QStringLiteral("y"), int(UpAxis::Y));
    m_up->addItem(QStringLiteral("z"), int(UpAxis::Z));
    m_upTitle->setBuddy(m_up);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(3, 0, 3, 0);
    row->setSpacing(6);
    row->addWidget(m_upTitle);
    row->addStretch(1);
    row->addWidget(m_upSource);
    row->addWidget(m_up);
    connect(m_up, &QComboBox::activated, this, [this] { m_session.setUpAxis(UpAxis(m_up->currentData().toInt())); });
    return row;
}

void ScenePanel::showUp() {
    const OpenedScenePointer& opened = m_session.opened();
    for (QWidget* widget : {static_cast<QWidget*>(m_upTitle), static_cast<QWidget*>(m_up), static_cast<QWidget*>(m_upSource)})
        widget->setVisible(opened != nullptr);
    if (!opened) return;
    m_up->setCurrentIndex(m_up->findData(int(m_session.upAxis())));
    const SceneRemarks& remarks = opened->scene->remarks();
    QString source = tr("chosen", "the up axis");
    if (m_session.upAxis() == opened->scene->upAxis())
        source = remarks.up          ? tr("as the scene says", "the up axis")
                 : remarks.guessedUp ? tr("guessed from its shape", "the up axis")
                                     : QString();
    m_upSource->setText(source);
}

void ScenePanel::setUpReport() {
    m_sentences->setModel(m_report);
    m_sentences->setWordWrap(true);
    m_sentences->setResizeMode(QListView::Adjust);
    m_sentences->setSpacing(2);
    m_sentences->setFrameShape(QFrame::NoFrame);
    m_sentences->setSelectionMode(QAbstractItemView::NoSelection);
    m_sentences->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QGridLayout* ScenePanel::makeButtons() {
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    const std::array rows{std::array{m_hide, m_show, m_frame}, std::array{m_isolate, m_showAll, m_split}};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) {
            grid->addWidget(rows[size_t(row)][size_t(column)], row, column);
            grid->setColumnStretch(column, 1);
        }
    connect(m_hide, &QPushButton::clicked, m_outliner, &Outliner::hideSelected);
    connect(m_show, &QPushButton::clicked, m_outliner, &Outliner::showSelected);
    connect(m_frame, &QPushButton::clicked, m_outliner, &Outliner::frameSelected);
    connect(m_isolate, &QPushButton::clicked, m_outliner, &Outliner::isolateSelected);
    connect(m_showAll, &QPushButton::clicked, m_outliner, &Outliner::showAll);
    connect(m_split, &QPushButton::clicked, this, &ScenePanel::split);
    return grid;
}

void ScenePanel::refresh() {
    const OpenedScenePointer& opened = m_session.opened();
    m_scene->setScene(opened ? opened->scene : nullptr);
    m_report->setReport(opened ? opened->report : std::nullopt);
    const bool reported = m_report->rowCount() > 0;
    m_reportTitle->setVisible(reported);
    m_sentences->setVisible(reported);
    // A clean file needs room for one sentence; a longer report scrolls.
    m_sentences->setFixedHeight(m_report->clean() ? kReportHeight / 3 : kReportHeight);
    // A plant of many kinds scrolls.
    m_facts->setFixedHeight(std::min(m_scene->rowCount(), kMostFacts) * kFactHeight + 2);
    showUp();
    // Offer to split a scene of one object: strategies that cull objects have nothing to cull in it.
    m_split->setVisible(opened && opened->scene->instances().size() == 1);
    enableButtons();
}

void ScenePanel::enableButtons() {
    const bool any = m_outliner->view().selectionModel()->hasSelection();
    const std::vector<bool>& hidden = m_session.hidden();
    for (QPushButton* button : {m_hide, m_show, m_frame, m_isolate}) button->setEnabled(any);
    m_showAll->setEnabled(std::find(hidden.begin(), hidden.end(), true) != hidden.end());
}

void ScenePanel::split() {
    const OpenedScenePointer& opened = m_session.opened();
    SplitDialog dialog(QString::fromStdString(opened->specification), opened->scene->triangleCount(), this);
    if (dialog.exec() == QDialog::Accepted) m_session.open(dialog.specification());
}

void ScenePanel::retranslate() {
    m_scene->retranslate();
    m_report->retranslate();
    m_facts->setAccessibleName(tr("Facts of the scene"));
    m_sentences->setAccessibleName(tr("What was found in the file"));
    m_reportTitle->setText(tr("What was found in the file"));
    m_upTitle->setText(tr("Up axis"));
    m_up->setAccessibleName(m_upTitle->text());
    m_up->setToolTip(tr("Which axis points up. The views stand anew; nothing is loaded again."));
    showUp();
    m_hide->setText(tr("Hide"));
    m_show->setText(tr("Show"));
    m_frame->setText(tr("Frame"));
    m_frame->setToolTip(tr("Brings the selected objects into the active view"));
    m_isolate->setText(tr("Isolate"));
    m_isolate->setToolTip(tr("Hides all other objects"));
    m_showAll->setText(tr("Show all"));
    m_split->setText(tr("Split…"));
    m_split->setToolTip(tr("Splits the object, so that there are objects to leave out"));
}

void ScenePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
