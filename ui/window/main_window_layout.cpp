// The arrangements of the main window: docks and side panel by its width and the number of views, and what is kept of them.
#include "ui/window/main_window.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kMenuMargins = 6;
constexpr int kToolBarMargins = 18;
constexpr int kWideDockWidth = 480;
constexpr int kLegendLetters = 13;  // pixels
constexpr int kWideWindow = 1600;   // from this width on the side panel fits beside the views
constexpr const char* kExploreArrangement = "explore";
constexpr const char* kCompareArrangement = "compare";

}  // namespace

void MainWindow::addRailButton(QAction* action) {
    auto* button = new QToolButton(m_rightRail);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({24, 24});
    button->setFixedSize(SidePanel::kRailWidth - 4, SidePanel::kRailWidth - 4);
    auto* rail = qobject_cast<QVBoxLayout*>(m_rightRail->layout());
    rail->insertWidget(rail->count() - 1, button);
}

void MainWindow::showRightRail() {
    const bool folded = m_floatingDocks->floating() || !m_dock->isVisibleTo(this);
    m_rightRail->setVisible(folded);
    explainColours();
}

void MainWindow::wireLegend() {
    m_colours->layout()->setContentsMargins(10, 3, 10, 3);
    for (const auto signal : {&Session::sceneChanged, &Session::viewCountChanged, &Session::activeViewChanged,
                              &Session::questionChanged, &Session::stepChanged})
        connect(&m_session, signal, this, &MainWindow::explainColours);
    connect(&m_session, &Session::setupChanged, this, &MainWindow::explainColours);
    connect(&m_language, &Language::changed, this, &MainWindow::explainColours);
}

/// Where the panel "Inside" with its legend is folded or floats, a row below the views explains their colours.
void MainWindow::explainColours() {
    const bool folded = m_floatingDocks->floating() || !m_dock->isVisibleTo(this);
    m_colours->explain(m_session.shownViews(), kLegendLetters, {.bars = true});
    m_colours->setVisible(folded && !m_lecture && m_session.opened() && !m_colours->empty());
}

/// The height is the same in all languages, so that a change of language keeps the size of the views.
void MainWindow::fixBarHeights() {
    const int letters = lineHeight(fontMetrics());
    menuBar()->setFixedHeight(letters + kMenuMargins);
    m_toolBar->setFixedHeight(letters + kToolBarMargins);
}

void MainWindow::arrange() {
    const bool compare = m_session.viewCount() > 2;
    const bool wide = width() >= kWideWindow;
    const bool otherWidth = std::exchange(m_arrangedWide, wide) != wide;
    const bool otherArrangement = std::exchange(m_arrangedCompare, compare) != compare;
    if (!otherWidth && !otherArrangement) return;
    m_side->setOpenPage(wide && !compare ? kStrategyPage : -1);
    if (otherArrangement) {
        m_floatingDocks->setFloating(compare);
        showRightRail();
    }
    resizeDocks({m_dock}, {wide ? kWideDockWidth : kDockWidth}, Qt::Horizontal);
}

QString MainWindow::arrangement() const {
    if (m_lecture) return QLatin1String(kLectureArrangement);
    return QLatin1String(m_session.viewCount() > 2 ? kCompareArrangement : kExploreArrangement);
}

void MainWindow::beginLecture() {
    if (!m_session.opened()) return;
    if (m_lecture) return void(m_lecture->close());
    auto* structure = new StructurePanel(m_session, *m_reader);
    structure->showPage(m_structure->page());
    structure->map().setColouring(m_structure->map().map().colouring());
    m_lecture = new LectureWindow(m_session, *m_views, structure, this);
    connect(m_lecture, &LectureWindow::left, this, [this] {
        m_lecture->deleteLater();
        m_lecture = nullptr;
        showState();
    });
    connect(m_actions->stepThrough, &QAction::triggered, structure,
            [structure](bool on) { on ? structure->showSteps() : void(); });
    m_lecture->setStepper(&m_steps->stepper());
    m_lecture->setLessons(&m_lessons->player(), &m_language);
    m_lecture->begin();
    m_presenter->begin();
    showState();
}

void MainWindow::showPanels(const SessionState& state) {
    state.place ? stepper().startAt(*state.place) : stepper().stop();
    if (!state.structurePanel.map.empty()) m_structure->map().setColouring(state.structurePanel.map);
    if (!state.structurePanel.page.empty()) m_structure->showPage(state.structurePanel.page);
}

bool MainWindow::restoreLayout(bool viewCount) {
    const std::optional<WindowMemory::Layout> kept = m_memory->restore();
    if (!kept) return false;
    // The panels keep their restored state: do not rearrange them for the number of views.
    m_arrangedCompare = kept->viewCount > 2;
    m_floatingDocks->adopt(*m_arrangedCompare);
    if (viewCount) m_session.setViewCount(kept->viewCount);
    m_viewCommands->restoreSize();
    arrange();
    showRightRail();
    return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_keepsLayout) m_memory->save({arrangement(), m_session.viewCount()});
    m_steps->stepper().stop();
    if (m_lecture) m_lecture->close();
    QMainWindow::closeEvent(event);
}

void MainWindow::resetLayout() {
    m_floatingDocks->setFloating(false);
    m_memory->reset();
    m_arrangedCompare.reset();
    m_arrangedWide.reset();
    arrange();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    arrange();
}

}  // namespace cullscope::ui
