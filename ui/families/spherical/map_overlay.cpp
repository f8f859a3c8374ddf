#include "ui/families/spherical/map_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_picture.h"
#include "ui/families/spherical/map_edges.h"

namespace cullscope::ui {

namespace {

constexpr int kLabelStep = 30;              // degrees between labelled contours
constexpr double kLeastContourStep = 15.0;  // degrees between drawn ones
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
    for (const double distance : {kNumberDistance, 2 * kNumberDistance})
        for (const int turned : {0, 1, -1, 2, -2, 3, -3, 4})
            if (const QRectF found = at(turned * kEighth, distance); free(found)) return found;
    return at(0.0, kNumberDistance);
}

double distanceTo(const QRectF& rect, const QPointF& point) {
    return std::hypot(point.x() - std::clamp(point.x(), rect.left(), rect.right()),
                      point.y() - std::clamp(point.y(), rect.top(), rect.bottom()));
}

}  // namespace

std::array<QRectF, 4> cornerNumbers(const MapLayout& layout, const spherical::SphericalDecision& decision,
                                    const QFontMetricsF& metrics) {
    std::array<QPointF, 4> places;
    for (size_t corner = 0; corner < places.size(); ++corner) places[corner] = layout.placeOf(cornerOf(decision.rays[corner]));
    const QPointF middle = (places[0] + places[1] + places[2] + places[3]) / 4;
    // Keep clear of the map's frame, which is painted over labels.
    const QRectF bounds = layout.area.adjusted(2, 2, -2, -2);
    std::array<QRectF, 4> numbers;
    for (size_t corner = 0; corner < places.size(); ++corner) {
        const auto free = [&](const QRectF& number) {
            return std::none_of(places.begin(), places.end(),
                                [&](const QPointF& place) { return distanceTo(number, place) < kMarkerReach; }) &&
                   std::none_of(numbers.begin(), numbers.begin() + corner,
                                [&](const QRectF& other) { return other.intersects(number); });
        };
        // Numbers are placed outside the region, so that they do not cover a small one.
        const QPointF outwards = places[corner] - middle;
        numbers[corner] = placeBeside(places[corner], std::atan2(outwards.y(), outwards.x()), QString::number(corner + 1), bounds,
                                      metrics, free);
    }
    return numbers;
}

double contourStep(const spherical::ContourBands& bands) {
    const double degrees = bands.width * 180.0 / std::numbers::pi;
    return bands.width * std::max(1.0, std::ceil(kLeastContourStep / degrees - 1e-9));
}

std::vector<std::vector<Vec2>> sectorEdge(const spherical::ContourBands& bands, double beta) {
    constexpr int kSteps = 180;
    std::vector<std::vector<Vec2>> lines(1);
    for (int step = 0; step <= kSteps; ++step) {
        Vec2 point = spherical::mapAngles(bands.direction(step * std::numbers::pi / kSteps, beta));
        if (!lines.back().empty()) {
            const double before = lines.back().back().y;
            point.y += std::round((before - point.y) / kTurn) * kTurn;
            // φ jumps at a pole: begin a new line.
            if (std::abs(point.y - before) > kTurn / 4) lines.emplace_back();
        }
        lines.back().push_back(point);
    }
    return lines;
}

Vec2 cornerOf(const spherical::CornerRay& ray) { return spherical::mapAngles(ray.point); }

void MapOverlay::paint(const spherical::MapSnapshot& map) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (map.decision.bands) paintBands(*map.decision.bands);
    if (map.decision.walk) paintWalk(map);
    if (map.decision.region) {
        paintWalked(map);
        paintRegion(map.maps->grid(), *map.decision.region);
    }
    m_painter.restore();
    // Painted without the clipping to the map, because corners may lie at its edge.
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

void MapOverlay::paintWalked(const spherical::MapSnapshot& map) const {
    QColor fill = m_colours.walked;
    fill.setAlphaF(0.8F);
    for (const spherical::CornerRay& ray : map.decision.rays)
        for (const WalkedCell& walked : ray.walkedCells)
            m_painter.fillRect(atLeast(m_layout.rectOf(map.maps->grid(), walked.cell), kLeastWalkedSize), fill);
}

void MapOverlay::paintRegion(const SphericalGrid& grid, const spherical::VisibleRegion& region) const {
    for (const spherical::CellBox& box : region.boxes) {
        QPainterPath path;
        path.addRect(m_layout.rectOf(grid, box).intersected(m_layout.area.adjusted(0.5, 0.5, -0.5, -0.5)));
        strokeOver(m_painter, path, linePen(MapSymbol::Box, m_colours), m_colours.ground);
    }
    // The outline of a region around a pole ends one turn after its start, which is the same point of the map: it is not closed.
    if (!region.outline.empty())
        strokeOver(m_painter, wrapped(region.outline, region.caseNumber != 1), linePen(MapSymbol::Region, m_colours),
                   m_colours.ground);
}

void MapOverlay::paintCorners(const spherical::SphericalDecision& decision) const {
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing);
    const std::array<QRectF, 4> numbers = cornerNumbers(m_layout, decision, QFontMetricsF(m_painter.font()));
    for (size_t corner = 0; corner < numbers.size(); ++corner)
        paintLabel(m_painter, numbers[corner], QString::number(corner + 1), m_colours);
    for (const spherical::CornerRay& ray : decision.rays)
        paintMarker(m_painter, m_layout.placeOf(cornerOf(ray)), ray.hit ? MapSymbol::CornerHit : MapSymbol::CornerMiss,
                    m_colours);
    m_painter.restore();
}

void MapOverlay::paintBands(const spherical::ContourBands& bands) const {
    const QPen pen = linePen(MapSymbol::Contour, m_colours);
    const auto every = uint32_t(std::lround(contourStep(bands) / bands.width));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(pen);
    for (uint32_t band = every; band < bands.bands; band += every)
        m_painter.drawPath(wrapped(contour(bands, band * bands.width), false));
    strokeOver(m_painter, wrapped(contour(bands, std::numbers::pi / 2), false), linePen(MapSymbol::RightAngle, m_colours),
               m_colours.ground);
    for (int label = kLabelStep; label < 180; label += kLabelStep) {
        const std::vector<Vec2> line = contour(bands, label * std::numbers::pi / 180.0);
        // At its highest point the curve crosses no other line, and is level like the label.
        const Vec2 top = *std::min_element(line.begin(), line.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
        const QPointF place = m_layout.placeOf({top.x, top.y - std::floor(top.y / kTurn) * kTurn});
        paintLabel(m_painter, place, QStringLiteral("%1°").arg(label), m_layout.area, m_colours);
    }
    const SphericalPoint start = sphericalPoint(bands.axis), end = sphericalPoint(-bands.axis);
    paintMarker(m_painter, m_layout.placeOf({start.theta, start.phi}), MapSymbol::Start, m_colours);
    paintMarker(m_painter, m_layout.placeOf({end.theta, end.phi}), MapSymbol::End, m_colours);
}

void MapOverlay::paintWalk(const spherical::MapSnapshot& map) const {
    QPainterPath cells;
    for (const std::vector<Vec2>& outline : cellOutlines(map, kLeastOutlined * kTurn / m_layout.area.width()))
        cells.addPath(wrapped(outline, false));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(linePen(MapSymbol::JudgedCell, m_colours));
    m_painter.drawPath(cells);
    if (const std::vector<Vec2> horizon = horizonLine(map); !horizon.empty())
        strokeOver(m_painter, wrapped(horizon, false), linePen(MapSymbol::Horizon, m_colours), m_colours.ground);
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

void MapOverlay::paintSector(const spherical::ContourBands& bands, uint32_t sector) const {
    m_painter.save();
    m_painter.setClipRect(m_layout.area, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::Antialiasing);
    for (const uint32_t edge : {sector, sector + 1})
        for (const std::vector<Vec2>& line : sectorEdge(bands, edge * kTurn / bands.sectors))
            strokeOver(m_painter, wrapped(line, false), linePen(MapSymbol::Sector, m_colours), m_colours.ground);
    m_painter.restore();
}

void MapOverlay::paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const {
    QPainterPath path;
    path.addRect(atLeast(m_layout.rectOf(grid, cell), 2 * kLeastCellSize).adjusted(-2, -2, 2, 2));
    strokeOver(m_painter, path, QPen(m_colours.text, 1.5), m_colours.ground);
}

}  // namespace cullscope::ui
