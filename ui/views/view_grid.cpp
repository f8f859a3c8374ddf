#include "ui/views/view_grid.h"

#include <QPainter>
#include <numeric>

namespace cullscope::ui {

namespace {

constexpr int kGridGap = 2;              // pixels between two views
constexpr double kShareWithStrip = 1.6;  // of the height: a row with strips against one without

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
    ViewPane* pane = m_panes[size_t(view)];
    m_lent.insert(pane);
    return pane;
}

void ViewGrid::take(ViewPane* pane) {
    m_lent.erase(pane);
    pane->setParent(this);
    pane->setLent(ViewPane::Lent::No, 0);
    pane->setFiguresHidden(false);
    arrange();
}

std::vector<QRect> ViewGrid::cells(const QRect& place, const std::vector<int>& views) const {
    if (views.empty()) return {};
    const int count = int(views.size()), rows = count > 2 ? 2 : 1, columns = (count + rows - 1) / rows;
    std::vector<double> shares(size_t(rows), 1.0);
    for (int i = 0; i < count; ++i)
        if (m_panes[size_t(views[size_t(i)])]->strip()) shares[size_t(i / columns)] = kShareWithStrip;
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    const int across = (place.width() - kGridGap * (columns - 1)) / columns, down = place.height() - kGridGap * (rows - 1);
    std::vector<QRect> cells;
    int top = place.top();
    for (int row = 0; row < rows; ++row) {
        const int height = int(down * shares[size_t(row)] / all);
        for (int column = 0; column < columns && int(cells.size()) < count; ++column)
            cells.emplace_back(place.left() + column * (across + kGridGap), top, across, height);
        top += height + kGridGap;
    }
    return cells;
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
    for (ViewPane* pane : m_panes)
        if (!m_lent.contains(pane) && !m_session.shown(pane->view())) pane->hide();
    const std::vector<QRect> cells = this->cells(rect(), shown);
    for (size_t place = 0; place < shown.size(); ++place) {
        ViewPane* pane = m_panes[size_t(shown[place])];
        if (m_lent.contains(pane)) continue;
        pane->setCompare(shown.size() > 2);
        pane->setGeometry(cells[place]);
        pane->show();
    }
}

void ViewGrid::resizeEvent(QResizeEvent*) { arrange(); }

void ViewGrid::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().color(QPalette::Mid)); }

}  // namespace cullscope::ui
