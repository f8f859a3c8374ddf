#include "ui/views/view_grid.h"

#include <QPainter>

namespace cullscope::ui {

namespace {

constexpr int kGridGap = 2;  // pixels between two views

}  // namespace

ViewGrid::ViewGrid(Session& session, QWidget* parent) : QWidget(parent), m_session(session) {
    for (int view = 0; view < Session::kMostViews; ++view) {
        auto* pane = new ViewPane(session, view, this);
        connect(&pane->picture(), &SceneView::menuRequested, this, &ViewGrid::menuRequested);
        connect(&pane->header(), &ViewHeader::menuRequested, this, &ViewGrid::menuRequested);
        connect(&pane->picture(), &SceneView::loupeMoved, this, &ViewGrid::moveLoupes);
        m_panes.push_back(pane);
    }
    connect(&session, &Session::viewCountChanged, this, &ViewGrid::arrange);
    connect(&session, &Session::activeViewChanged, this, &ViewGrid::arrange);
    arrange();
}

ViewPane* ViewGrid::lend(int view) {
    m_lent = m_panes[size_t(view)];
    m_lent->setCompare(false);
    m_lent->setLent(true);
    return m_lent;
}

void ViewGrid::take(ViewPane* pane) {
    m_lent = nullptr;
    pane->setParent(this);
    pane->setLent(false);
    arrange();
}

QRect ViewGrid::cell(int place, int columns, int rows) const {
    const int across = (width() - kGridGap * (columns - 1)) / columns;
    const int down = (height() - kGridGap * (rows - 1)) / rows;
    return {place % columns * (across + kGridGap), place / columns * (down + kGridGap), across, down};
}

void ViewGrid::moveLoupes(int view, const std::optional<QPointF>& place) {
    for (ViewPane* pane : m_panes) {
        if (pane->view() == view) continue;
        const bool same = m_session.setup(view).role == Role::Linked && m_session.setup(pane->view()).role == Role::Linked &&
                          m_session.renderSize(pane->view()) == m_session.renderSize(view);
        pane->picture().setLoupePlace(same ? place : std::nullopt);
    }
}

void ViewGrid::arrange() {
    const std::vector<int> shown = m_session.shownViews();
    const int count = int(shown.size());
    const int rows = count > 2 ? 2 : 1;
    for (ViewPane* pane : m_panes)
        if (pane != m_lent && !m_session.shown(pane->view())) pane->hide();
    for (int place = 0; place < count; ++place) {
        ViewPane* pane = m_panes[size_t(shown[size_t(place)])];
        if (pane == m_lent) continue;
        pane->setCompare(count > 2);
        pane->setGeometry(cell(place, count / rows, rows));
        pane->show();
    }
}

void ViewGrid::resizeEvent(QResizeEvent*) { arrange(); }

void ViewGrid::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().color(QPalette::Mid)); }

}  // namespace cullscope::ui
