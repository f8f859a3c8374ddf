#include "ui/plots/map_overlay.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "core/geometry/angle.h"
#include "ui/look/in_hand.h"
#include "ui/plots/map_edges.h"

namespace cullscope::ui {

namespace {

constexpr double kNumberDistance = 15.0;
constexpr double kLeastWalkedSize = 2.0;
constexpr double kLeastCellSize = 3.0;  // pixels; minimum size of a mark
constexpr double kLeastOutlined = 4.0;  // pixels; a smaller cell would be covered by its outline

QRectF atLeast(const QRectF& rect, double size) {
    const double across = std::max(0.0, size - rect.width()) / 2, down = std::max(0.0, size - rect.height()) / 2;
    return rect.adjusted(-across, -down, across, down);
}

/// The rectangle of a label beside a point: in the wanted direction, or the next one in which `free` accepts it.
QRectF placeBeside(const QPointF& place, double direction, const QString& words, const QRectF& bounds,
                   const QFontMetricsF& metrics, const std::function<bool(const QRectF&)>& free) {
    constexpr double kEighth = kTurn / 8;
    const auto at = [&](double turned, double distance) {
        const QPointF away(std::cos(direction + turned), std::sin(direction + turned));
        return labelPlace(place + away * distance, words, bounds, metrics);
    };
    const double near = kNumberDistance * unitOfLetters(metrics);
    for (const double distance : {near, 2 * near})
        for (const int turned : {0, 1, -1, 2, -2, 3, -3, 4})
            if (const QRectF found = at(turned * kEighth, distance); free(found)) return found;
    return at(0.0, near);
}

QString circleWords(int degrees) { return QStringLiteral("%1°").arg(degrees); }

/// The drawn contour nearest to an angle, of two equally near ones that towards the right angle; degrees. Nothing where there is
/// none, or none at a whole degree, which a label could name.
std::optional<int> drawnCircle(const MapCircles& circles, int degrees) {
    constexpr double kWhole = 1e-6;  // degrees
    const double step = circles.every * circles.width * 180.0 / std::numbers::pi, count = degrees / step;
    const auto which = uint32_t(degrees < 90 ? std::floor(count + 0.5) : std::ceil(count - 0.5));
    const double angle = which * step;
    if (which == 0 || which * circles.every >= circles.bands || std::abs(angle - std::round(angle)) > kWhole) return std::nullopt;
    return int(std::lround(angle));
}

double distanceTo(const QRectF& rect, const QPointF& point) {
    return std::hypot(point.x() - std::clamp(point.x(), rect.left(), rect.right()),
                      point.y() - std::clamp(point.y(), rect.top(), rect.bottom()));
}

}  // namespace

std::vector<QRectF> markNumbers(const MapLayout& layout, const std::vector<MapMark>& marks, const QFontMetricsF& metrics) {
    std::vector<QPointF> places;
    QPointF middle;
    const double unit = unitOfLetters(metrics), reach = kMarkerReach * unit;
    for (const MapMark& mark : marks) {
        places.push_back(layout.placeOf(mark.place));
        middle += places.back();
    }
    middle /= double(std::max<size_t>(marks.size(), 1));
    // Keep clear of the map's frame, which is painted over labels.
    const QRectF bounds = layout.area.adjusted(2, 2, -2, -2);
    std::vector<QRectF> numbers;
    for (size_t i = 0; i < places.size(); ++i) {
        const auto free = [&](const QRectF& number) {
            return std::none_of(places.begin(), places.end(),
                                [&](const QPointF& place) { return distanceTo(number, place) < reach; }) &&
                   std::none_of(numbers.begin(), numbers.end(), [&](const QRectF& other) { return other.intersects(number); });
        };
        // Numbers are placed outside of what the marks surround, so that they do not cover a small one.
        const QPointF outwards = places[i] - middle;
        numbers.push_back(placeBeside(places[i], std::atan2(outwards.y(), outwards.x()), QString::number(marks[i].number), bounds,
                                      metrics, free));
    }
    return numbers;
}

std::vector<CircleLabel> circleLabels(const MapLayout& layout, const MapCircles& circles, const QFontMetricsF& metrics) {
    constexpr double kGap = 2.0;  // pixels between two labels
    // On a low map each label would cover too much of it.
    constexpr double kLowMap = 4.0;  // lines of text
    const bool low = layout.area.height() < kLowMap * metrics.height();
    std::vector<CircleLabel> labels;
    // The right angle, where the paper's method changes, first; then away from it.
    for (const int near : {90, 60, 120, 30, 150}) {
        if (low && near != 90) break;
        const std::optional<int> drawn = near == 90 ? near : drawnCircle(circles, near);
        if (!drawn) continue;
        const int degrees = *drawn;
        const std::vector<Vec2> line = circleOnMap(circles, degrees * std::numbers::pi / 180.0);
        // At its highest point the curve crosses no other line, and is level like the label.
        const Vec2 top = *std::min_element(line.begin(), line.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
        const QPointF centre = layout.placeOf({top.x, top.y - std::floor(top.y / kTurn) * kTurn});
        const QRectF place = labelPlace(centre, circleWords(degrees), layout.area, metrics);
        const QRectF wanted = place.adjusted(-kGap, -kGap, kGap, kGap);
        if (std::ranges::none_of(labels, [&](const CircleLabel& other) { return other.place.intersects(wanted); }))
            labels.push_back({degrees, place});
    }
    return labels;
}

void MapOverlay::paint(const CellMap& map) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (map.circles) paintCircles(*map.circles);
    paintOutlines(map);
    paintWalked(map);
    paintBoxes(map);
    paintCurves(map);
    m_painter.restore();
}

void MapOverlay::paintLabels(const CellMap& map) const {
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (map.circles) {
        for (const CircleLabel& label : circleLabels(m_layout, *map.circles, QFontMetricsF(m_painter.font())))
            paintLabel(m_painter, label.place, circleWords(label.degrees), m_colours);
        paintMarker(m_painter, m_layout.placeOf(mapAngles(map.circles->axis)), MapSymbol::Start, m_colours);
        paintMarker(m_painter, m_layout.placeOf(mapAngles(-map.circles->axis)), MapSymbol::End, m_colours);
    }
    m_painter.restore();
    // Not clipped to the map, because marks may lie at its edge.
    if (!map.marks.empty()) paintMarks(map.marks);
}

QPainterPath MapOverlay::wrapped(const std::vector<Vec2>& line, bool closed) const {
    const auto [least, most] =
        std::minmax_element(line.begin(), line.end(), [](const Vec2& a, const Vec2& b) { return a.y < b.y; });
    const int from = int(std::floor(least->y / kTurn)), to = int(std::floor(most->y / kTurn));
    QPainterPath path;
    for (int turn = from; turn <= to; ++turn) {
        for (size_t i = 0; i < line.size(); ++i) {
            const QPointF place = m_layout.placeOf({line[i].x, line[i].y - turn * kTurn});
            if (i == 0)
                path.moveTo(place);
            else
                path.lineTo(place);
        }
        if (closed) path.closeSubpath();
    }
    return path;
}

void MapOverlay::paintWalked(const CellMap& map) const {
    QColor fill = m_colours.walked;
    fill.setAlphaF(0.8F);
    for (const SphericalGrid::Cell& cell : map.walked)
        m_painter.fillRect(atLeast(m_layout.rectOf(map.grid, cell), kLeastWalkedSize), fill);
}

void MapOverlay::paintBoxes(const CellMap& map) const {
    for (const SphericalGrid::Box& box : map.boxes) {
        QPainterPath path;
        path.addRect(m_layout.rectOf(map.grid, box).intersected(m_layout.area.adjusted(0.5, 0.5, -0.5, -0.5)));
        strokeOver(m_painter, path, linePen(MapSymbol::Box, m_colours), m_colours);
    }
}

void MapOverlay::paintCurves(const CellMap& map) const {
    for (const MapCurve& curve : map.curves)
        if (!curve.points.empty())
            strokeOver(m_painter, wrapped(curve.points, curve.closed), linePen(curve.symbol, m_colours), m_colours);
}

void MapOverlay::paintMarks(const std::vector<MapMark>& marks) const {
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing);
    const std::vector<QRectF> numbers = markNumbers(m_layout, marks, QFontMetricsF(m_painter.font()));
    for (size_t i = 0; i < marks.size(); ++i) paintLabel(m_painter, numbers[i], QString::number(marks[i].number), m_colours);
    for (const MapMark& mark : marks) paintMarker(m_painter, m_layout.placeOf(mark.place), mark.symbol, m_colours);
    m_painter.restore();
}

void MapOverlay::paintCircles(const MapCircles& circles) const {
    const QPen pen = linePen(MapSymbol::Circle, m_colours);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(pen);
    for (uint32_t band = circles.every; band < circles.bands; band += circles.every)
        m_painter.drawPath(wrapped(circleOnMap(circles, band * circles.width), false));
    strokeOver(m_painter, wrapped(circleOnMap(circles, std::numbers::pi / 2), false), linePen(MapSymbol::RightAngle, m_colours),
               m_colours);
}

void MapOverlay::paintOutlines(const CellMap& map) const {
    const std::vector<std::vector<Vec2>> outlines = map.source->outlines(kLeastOutlined * kTurn / m_layout.area.width());
    if (outlines.empty()) return;
    QPainterPath cells;
    for (const std::vector<Vec2>& outline : outlines) cells.addPath(wrapped(outline, false));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(linePen(MapSymbol::Cell, m_colours));
    m_painter.drawPath(cells);
}

void MapOverlay::paintPicked(const SphericalGrid& grid, const std::vector<SphericalGrid::Cell>& cells,
                             const SphericalGrid::Cell& centroid) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    MapEdges edges(grid, m_layout);
    edges.choose(cells);
    strokeOver(m_painter, edges.path(), linePen(MapSymbol::Picked, m_colours), m_colours);
    m_painter.fillRect(atLeast(m_layout.rectOf(grid, centroid), kLeastCellSize), m_colours.picked);
    m_painter.restore();
}

void MapOverlay::paintPart(const CellMap& map, uint32_t part) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    for (const std::vector<Vec2>& line : map.source->partEdges(part))
        strokeOver(m_painter, wrapped(line, false), linePen(MapSymbol::Part, m_colours), m_colours);
    m_painter.restore();
}

void MapOverlay::paintInHand(const std::vector<std::vector<Vec2>>& lines) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area.adjusted(-2, -2, 2, 2), Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setBrush(Qt::NoBrush);
    QPainterPath path;
    for (const std::vector<Vec2>& line : lines) {
        if (line.empty()) continue;
        QPainterPath one = wrapped(line, false);
        // A cell that is smaller than its outline's width stays visible.
        if (const QRectF bounds = one.boundingRect(); std::max(bounds.width(), bounds.height()) < 2 * kLeastCellSize) {
            one = QPainterPath();
            one.addRect(atLeast(bounds, 2 * kLeastCellSize));
        }
        path.addPath(one);
    }
    m_painter.setPen(QPen(kInHandEdge, kInHandEdgeWidth * m_colours.unit));
    m_painter.drawPath(path);
    m_painter.setPen(QPen(kInHandColour, kInHandWidth * m_colours.unit));
    m_painter.drawPath(path);
    m_painter.restore();
}

void MapOverlay::paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const {
    QPainterPath path;
    path.addRect(atLeast(m_layout.rectOf(grid, cell), 2 * kLeastCellSize).adjusted(-2, -2, 2, 2));
    strokeOver(m_painter, path, QPen(m_colours.text, 1.5 * m_colours.unit), m_colours);
}

}  // namespace cullscope::ui
