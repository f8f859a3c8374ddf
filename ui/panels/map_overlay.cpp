#include "ui/panels/map_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/measure/map_picture.h"
#include "ui/panels/map_edges.h"

namespace cullscope::ui {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kLabelStep = 30;              // degrees between labelled contours
constexpr double kLeastContourStep = 15.0;  // degrees between drawn ones
constexpr double kNumberDistance = 15.0;
constexpr double kLeastWalkedSize = 2.0;
constexpr double kLeastCellSize = 3.0;  // of what must be seen, in pixels

QRectF atLeast(const QRectF& rect, double size) {
    const double across = std::max(0.0, size - rect.width()) / 2, down = std::max(0.0, size - rect.height()) / 2;
    return rect.adjusted(-across, -down, across, down);
}

}  // namespace

Vec2 cornerOf(const CornerRay& ray) {
    const SphericalPoint point = sphericalPoint(ray.point);
    return {point.theta, point.phi};
}

void MapOverlay::paint(const InsideMap& map) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (map.decision.bands) paintBands(*map.decision.bands);
    if (map.decision.region) {
        paintWalked(map);
        paintRegion(map.maps->grid(), *map.decision.region);
    }
    m_painter.restore();
    // The corners may lie at the map's edge.
    if (map.decision.region) paintCorners(map.decision);
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

void MapOverlay::paintWalked(const InsideMap& map) const {
    QColor fill = m_colours.walked;
    fill.setAlphaF(0.8F);
    for (const CornerRay& ray : map.decision.rays)
        for (const WalkedCell& walked : ray.walkedCells)
            m_painter.fillRect(atLeast(m_layout.rectOf(map.maps->grid(), walked.cell), kLeastWalkedSize), fill);
}

void MapOverlay::paintRegion(const SphericalGrid& grid, const VisibleRegion& region) const {
    for (const CellBox& box : region.boxes) {
        QPainterPath path;
        path.addRect(m_layout.rectOf(grid, box).intersected(m_layout.area.adjusted(0.5, 0.5, -0.5, -0.5)));
        strokeOver(m_painter, path, linePen(MapSymbol::Box, m_colours), m_colours.ground);
    }
    // A region around a pole begins and ends at the same place of the map, a turn apart.
    if (!region.outline.empty())
        strokeOver(m_painter, wrapped(region.outline, region.caseNumber != 1), linePen(MapSymbol::Region, m_colours),
                   m_colours.ground);
}

void MapOverlay::paintCorners(const SphericalDecision& decision) const {
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing);
    std::array<QPointF, 4> places;
    for (size_t corner = 0; corner < places.size(); ++corner) places[corner] = m_layout.placeOf(cornerOf(decision.rays[corner]));
    const QPointF middle = (places[0] + places[1] + places[2] + places[3]) / 4;
    for (size_t corner = 0; corner < places.size(); ++corner) {
        // Numbers stand outside, so that they do not cover a small region.
        const QPointF outwards = places[corner] - middle;
        const double distance = std::max(1.0, std::hypot(outwards.x(), outwards.y()));
        paintLabel(m_painter, places[corner] + outwards / distance * kNumberDistance, QString::number(corner + 1), m_layout.area,
                   m_colours);
    }
    for (size_t corner = 0; corner < places.size(); ++corner)
        paintMarker(m_painter, places[corner], decision.rays[corner].hit ? MapSymbol::CornerHit : MapSymbol::CornerMiss,
                    m_colours);
    m_painter.restore();
}

void MapOverlay::paintBands(const ContourBands& bands) const {
    const QPen pen = linePen(MapSymbol::Contour, m_colours);
    const double degrees = bands.width * 180.0 / std::numbers::pi;
    const int every = std::max(1, int(std::ceil(kLeastContourStep / degrees - 1e-9)));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(pen);
    for (uint32_t band = uint32_t(every); band < bands.bands; band += uint32_t(every))
        m_painter.drawPath(wrapped(contour(bands, band * bands.width), false));
    strokeOver(m_painter, wrapped(contour(bands, std::numbers::pi / 2), false), QPen(pen.color(), 2.2), m_colours.ground);
    for (int label = kLabelStep; label < 180; label += kLabelStep) {
        const std::vector<Vec2> line = contour(bands, label * std::numbers::pi / 180.0);
        // Where the curve is highest nothing else crosses it, and the words stand level.
        const Vec2 top = *std::min_element(line.begin(), line.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
        const QPointF place = m_layout.placeOf({top.x, top.y - std::floor(top.y / kTurn) * kTurn});
        paintLabel(m_painter, place, QStringLiteral("%1°").arg(label), m_layout.area, m_colours);
    }
    const SphericalPoint start = sphericalPoint(bands.axis), end = sphericalPoint(-bands.axis);
    paintMarker(m_painter, m_layout.placeOf({start.theta, start.phi}), MapSymbol::Start, m_colours);
    paintMarker(m_painter, m_layout.placeOf({end.theta, end.phi}), MapSymbol::End, m_colours);
}

void MapOverlay::paintPicked(const SphericalGrid& grid, const std::vector<SphericalGrid::Cell>& cells,
                             const SphericalGrid::Cell& centroid) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    MapEdges edges(grid, m_layout);
    edges.choose(cells);
    strokeOver(m_painter, edges.path(), linePen(MapSymbol::Picked, m_colours), m_colours.ground);
    m_painter.fillRect(atLeast(m_layout.rectOf(grid, centroid), kLeastCellSize), m_colours.picked);
    m_painter.restore();
}

void MapOverlay::paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const {
    QPainterPath path;
    path.addRect(atLeast(m_layout.rectOf(grid, cell), 2 * kLeastCellSize).adjusted(-2, -2, 2, 2));
    strokeOver(m_painter, path, QPen(m_colours.text, 1.5), m_colours.ground);
}

}  // namespace cullscope::ui
