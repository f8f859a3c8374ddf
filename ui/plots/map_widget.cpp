#include "ui/plots/map_widget.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/plots/map_words.h"
#include "ui/text/terms.h"

namespace cullscope::ui {

namespace {

constexpr double kMapReach = 9.0;  // pixels; radius around a mark within which its tooltip is shown
constexpr int kWidestMap = 480;    // pixels; width up to which the map asks for more height
constexpr int kFarStep = 10;       // cells that the cursor moves with Shift

}  // namespace

MapWidget::MapWidget(QWidget* parent) : PlotWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
}

void MapWidget::setContents(const MapContents& contents) {
    if (contents == m_painter.contents()) return;
    m_painter.setContents(contents);
    // The new map may have fewer cells.
    if (m_cursor && !empty()) {
        const SphericalGrid& grid = contents.shown.grid();
        m_cursor = SphericalGrid::Cell{std::min(m_cursor->row, grid.rows() - 1), std::min(m_cursor->column, grid.columns() - 1)};
    }
    contentsChanged();
}

void MapWidget::setColouring(const std::string& colouring) {
    if (m_painter.setColouring(colouring)) contentsChanged();
}

void MapWidget::setBrief() {
    m_painter.setBrief();
    contentsChanged();
}

int MapWidget::wholeHeight(int width) const { return int(m_painter.neededHeight(width, QFontMetricsF(font()))); }

std::vector<MapLegend::Entry> MapWidget::lines() const { return empty() ? std::vector<MapLegend::Entry>() : m_painter.lines(); }

std::vector<TriangleState> MapWidget::states() const { return empty() ? std::vector<TriangleState>() : m_painter.states(); }

MapLayout MapWidget::layoutOfMap() const { return m_painter.layout(rect(), QFontMetricsF(font())); }

QString MapWidget::title() const { return empty() ? QString() : translated(m_painter.contents().shown.map->title); }

void MapWidget::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    m_painter.paint(painter, place, palette);
}

void MapWidget::paintEvent(QPaintEvent*) {
    if (empty()) return;
    QPainter painter(this);
    painter.setFont(font());
    m_painter.paint(painter, rect(), palette(), hasFocus() ? m_cursor : std::nullopt);
}

int MapWidget::neededHeight(int width) const {
    if (m_painter.brief()) return 0;
    // In a wide and low panel the map must not displace all other widgets: there its height limits its width.
    return int(m_painter.neededHeight(std::min(width, kWidestMap), QFontMetricsF(font())));
}

QString MapWidget::description() const {
    const MapContents& contents = m_painter.contents();
    const CellMap& map = *contents.shown.map;
    QStringList lines{translated(map.objectWords), translated(map.decisionWords)};
    lines << translatedLines(map.lines);
    if (m_cursor) lines << cellWords(contents.shown, contents.truth.get(), map.grid.number(*m_cursor));
    lines << tr("The arrow keys go through the cells, with Shift ten at a time; Enter picks a triangle of the cell.");
    return lines.join(QLatin1Char('\n'));
}

QString MapWidget::wordsAt(const QPointF& place) const {
    if (empty()) return {};
    const MapContents& contents = m_painter.contents();
    const CellMap& map = *contents.shown.map;
    const MapLayout layout = layoutOfMap();
    for (const MapMark& mark : map.marks) {
        const QPointF away = layout.placeOf(mark.place) - place;
        if (std::hypot(away.x(), away.y()) <= kMapReach) return translated(mark.words);
    }
    const std::optional<SphericalGrid::Cell> cell = layout.cellAt(map.grid, place);
    return cell ? cellWords(contents.shown, contents.truth.get(), map.grid.number(*cell)) : QString();
}

void MapWidget::showWords(const QPointF& place, const QPoint& onScreen) {
    const QString words = wordsAt(place);
    if (words.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(onScreen, words, this);
}

bool MapWidget::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PlotWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    showWords(help->pos(), help->globalPos());
    return true;
}

void MapWidget::mouseMoveEvent(QMouseEvent* event) { showWords(event->position(), event->globalPosition().toPoint()); }

void MapWidget::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || empty()) return PlotWidget::mousePressEvent(event);
    const SphericalGrid& grid = m_painter.contents().shown.grid();
    const std::optional<SphericalGrid::Cell> cell = layoutOfMap().cellAt(grid, event->position());
    if (!cell) return;
    m_cursor = cell;
    contentsChanged();
    emit cellChosen(grid.number(*cell));
}

void MapWidget::moveCursor(int rows, int columns) {
    const SphericalGrid& grid = m_painter.contents().shown.grid();
    const SphericalGrid::Cell from = m_cursor.value_or(SphericalGrid::Cell{grid.rows() / 2, grid.columns() / 2});
    const auto width = int64_t(grid.columns());
    // The cursor wraps around at the seam of the columns and stops at the poles.
    m_cursor = SphericalGrid::Cell{uint32_t(std::clamp<int64_t>(int64_t(from.row) + rows, 0, int64_t(grid.rows()) - 1)),
                                   uint32_t(((int64_t(from.column) + columns) % width + width) % width)};
    contentsChanged();
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    const MapContents& contents = m_painter.contents();
    const QPoint below = layoutOfMap().rectOf(grid, *m_cursor).bottomRight().toPoint();
    QToolTip::showText(mapToGlobal(below), cellWords(contents.shown, contents.truth.get(), grid.number(*m_cursor)), this);
}

void MapWidget::keyPressEvent(QKeyEvent* event) {
    if (empty()) return PlotWidget::keyPressEvent(event);
    const int step = event->modifiers().testFlag(Qt::ShiftModifier) ? kFarStep : 1;
    switch (event->key()) {
        case Qt::Key_Left:
            return moveCursor(0, -step);
        case Qt::Key_Right:
            return moveCursor(0, step);
        case Qt::Key_Up:
            return moveCursor(-step, 0);
        case Qt::Key_Down:
            return moveCursor(step, 0);
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            if (m_cursor) emit cellChosen(m_painter.contents().shown.grid().number(*m_cursor));
            return;
        default:
            PlotWidget::keyPressEvent(event);
    }
}

void MapWidget::focusInEvent(QFocusEvent* event) {
    PlotWidget::focusInEvent(event);
    if (!empty() && !m_cursor && event->reason() != Qt::MouseFocusReason) moveCursor(0, 0);
}

void MapWidget::focusOutEvent(QFocusEvent* event) {
    PlotWidget::focusOutEvent(event);
    update();
}

}  // namespace cullscope::ui
