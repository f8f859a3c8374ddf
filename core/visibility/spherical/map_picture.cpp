#include "core/visibility/spherical/map_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/raster/canvas.h"
#include "core/visibility/spherical/judged_cells.h"

namespace cullscope::spherical {
namespace {

// Widths, lengths and radii in units (DrawStyle::unit).
constexpr double kMargin = 14.0;  ///< around the map, for the ticks
constexpr double kTick = 5.0;
constexpr double kLongTick = 9.0;  ///< every 90°
constexpr double kThin = 1.0;
constexpr double kStrong = 2.0;
constexpr double kCasing = 1.5;  ///< width of the background-coloured border on both sides of a line
constexpr double kDash = 6.0;
constexpr double kMark = 4.5;
constexpr double kLeastCell = 5.0;  ///< smaller cells are not outlined
constexpr double kWalkedOpacity = 0.45;

constexpr Vec3f kRegionOnMap(0.86f, 0.08f, 0.08f);  ///< red and dashed, as in the paper's Figure 4

/// Draws the map and its overlays.
class MapPainter {
public:
    MapPainter(const MapSnapshot& map, const Viewport& size, const DrawStyle& style)
        : m_map(map),
          m_canvas(size, style.background, style.backgroundAlpha),
          m_style(style),
          m_contrast(contrastTo(style.background)) {
        const MapArea area = mapArea(size, kMargin * style.unit);
        const double top = size.height - area.bottom - area.height;
        m_area = {area.left, top, area.left + area.width, top + area.height};
    }

    void paintCells(const std::vector<Vec3f>& colours);
    void paintFrame();
    void paintRegion(const VisibleRegion& region);
    void paintRays(std::span<const CornerRay> rays);
    void paintBands(const ContourBands& bands);
    void paintJudgedCells();
    void paintHorizon();
    [[nodiscard]] std::vector<uint8_t> rgba() const { return m_canvas.rgba(); }

private:
    [[nodiscard]] double unit() const { return m_style.unit; }
    /// The position of (θ, φ) in the picture; φ may lie beyond the seam.
    [[nodiscard]] Vec2 place(const Vec2& angles) const {
        return {m_area.left + angles.y / kTurn * (m_area.right - m_area.left),
                m_area.top + angles.x / std::numbers::pi * (m_area.bottom - m_area.top)};
    }
    [[nodiscard]] Vec3f meanColour(const std::vector<Vec3f>& colours, int x, int y) const;
    /// A line through (θ, φ) with a casing; where it crosses the seam it continues on the other side.
    void curve(const std::vector<Vec2>& angles, const Canvas::Pen& pen);
    void box(const CellBox& box, const Canvas::Pen& pen);
    void cross(const Vec2& centre, const Canvas::Pen& pen);
    void axisMarks(const Vec3& axis);
    void tick(const Vec2& from, const Vec2& outward, int degrees);

    const MapSnapshot& m_map;
    Canvas m_canvas;
    const DrawStyle& m_style;
    Vec3f m_contrast;
    Canvas::Rectangle m_area;
};

/// The mean colour of the cells that a pixel covers; the colour of the cell under its centre where it covers no more than that.
Vec3f MapPainter::meanColour(const std::vector<Vec3f>& colours, int x, int y) const {
    const SphericalGrid& grid = m_map.maps->grid();
    const double columns = grid.columns() / (m_area.right - m_area.left), rows = grid.rows() / (m_area.bottom - m_area.top);
    const auto range = [](double middle, double reach, uint32_t count) {
        const double half = 0.5 * std::max(reach - 1.0, 0.0);
        const auto cell = [&](double at) { return uint32_t(std::clamp(std::floor(at), 0.0, count - 1.0)); };
        return std::pair(cell(middle - half), cell(middle + half));
    };
    const auto [left, right] = range((x + 0.5 - m_area.left) * columns, columns, grid.columns());
    const auto [top, bottom] = range((y + 0.5 - m_area.top) * rows, rows, grid.rows());
    Vec3f sum(0.0f);
    for (uint32_t row = top; row <= bottom; ++row)
        for (uint32_t column = left; column <= right; ++column) sum += colours[grid.number({row, column})];
    return sum / float((bottom - top + 1) * (right - left + 1));
}

void MapPainter::paintCells(const std::vector<Vec3f>& colours) {
    for (int y = int(m_area.top); y < int(m_area.bottom); ++y)
        for (int x = int(m_area.left); x < int(m_area.right); ++x) m_canvas.setPixel(x, y, meanColour(colours, x, y));
}

void MapPainter::tick(const Vec2& from, const Vec2& outward, int degrees) {
    const double length = (degrees % 90 == 0 ? kLongTick : kTick) * unit();
    const std::array points{from, from + length * outward};
    m_canvas.line(points, {m_contrast, kThin * unit()});
}

void MapPainter::paintFrame() {
    const std::array corners{Vec2(m_area.left, m_area.top), Vec2(m_area.right, m_area.top), Vec2(m_area.right, m_area.bottom),
                             Vec2(m_area.left, m_area.bottom), Vec2(m_area.left, m_area.top)};
    m_canvas.line(corners, {m_contrast, kThin * unit()});
    for (int degrees = 0; degrees <= 360; degrees += 30)
        tick(place({std::numbers::pi, degrees * kTurn / 360.0}), Vec2(0.0, 1.0), degrees);
    for (int degrees = 0; degrees <= 180; degrees += 30) tick(place({degrees * kTurn / 360.0, 0.0}), Vec2(-1.0, 0.0), degrees);
}

void MapPainter::curve(const std::vector<Vec2>& angles, const Canvas::Pen& pen) {
    for (const bool casing : {true, false})
        for (const double turn : {-kTurn, 0.0, kTurn}) {
            std::vector<Vec2> points;
            for (const Vec2& each : angles) points.push_back(place({each.x, each.y + turn}));
            m_canvas.line(points, casing ? Canvas::Pen{m_style.background, pen.width + 2.0 * kCasing * unit()} : pen);
        }
}

void MapPainter::box(const CellBox& box, const Canvas::Pen& pen) {
    const SphericalGrid& grid = m_map.maps->grid();
    const double top = grid.thetaOf(box.firstRow), bottom = grid.thetaOf(box.lastRow + 1);
    const double left = grid.phiOf(box.firstColumn), right = grid.phiOf(box.lastColumn + 1);
    const std::array corners{place({top, left}), place({top, right}), place({bottom, right}), place({bottom, left}),
                             place({top, left})};
    m_canvas.line(corners, {m_style.background, pen.width + 2.0 * kCasing * unit()});
    m_canvas.line(corners, pen);
}

void MapPainter::paintRegion(const VisibleRegion& region) {
    m_canvas.clipTo(m_area);
    for (const CellBox& each : region.boxes) box(each, {m_contrast, kThin * unit()});
    std::vector<Vec2> outline = region.outline;
    // In case 1 the outline ends a whole turn from its start and is not closed.
    if (region.caseNumber != 1 && !outline.empty()) outline.push_back(outline.front());
    curve(outline, {kRegionOnMap, kStrong * unit(), kDash * unit()});
}

void MapPainter::cross(const Vec2& centre, const Canvas::Pen& pen) {
    for (const double side : {1.0, -1.0}) {
        const Vec2 arm = kMark * unit() * Vec2(1.0, side);
        const std::array points{centre - arm, centre + arm};
        m_canvas.line(points, {m_style.background, pen.width + 2.0 * kCasing * unit()});
        m_canvas.line(points, pen);
    }
}

void MapPainter::paintRays(std::span<const CornerRay> rays) {
    const SphericalGrid& grid = m_map.maps->grid();
    m_canvas.clipTo(m_area);
    for (const CornerRay& ray : rays)
        for (const WalkedCell& walked : ray.walkedCells) {
            const auto& [row, column] = walked.cell;
            const Vec2 low = place({grid.thetaOf(row), grid.phiOf(column)});
            const Vec2 high = place({grid.thetaOf(row + 1), grid.phiOf(column + 1)});
            m_canvas.fill({low.x, low.y, std::max(high.x, low.x + 1.0), std::max(high.y, low.y + 1.0)}, m_contrast,
                          kWalkedOpacity);
        }
    for (const CornerRay& ray : rays) {
        const Vec2 centre = place(mapAngles(ray.point));
        if (!ray.hit) {
            cross(centre, {m_contrast, kStrong * unit()});
            continue;
        }
        m_canvas.dot(centre, (kMark + kCasing) * unit(), m_style.background);
        m_canvas.dot(centre, kMark * unit(), kRegionOnMap);
    }
}

void MapPainter::paintBands(const ContourBands& bands) {
    m_canvas.clipTo(m_area);
    for (const Contour& contour : contours(bands)) {
        const bool equator = std::abs(contour.alpha - kRightAngle) < 1e-9;
        for (const std::vector<Vec2>& line : contour.lines) {
            std::vector<Vec2> points;
            for (const Vec2& each : line) points.push_back(place(each));
            m_canvas.line(points, {m_contrast, (equator ? kStrong : kThin) * unit()});
        }
    }
    axisMarks(bands.axis);
}

/// Marks on the map where the axis from the centre to the eye starts (ring) and, opposite, where it ends (dot).
void MapPainter::axisMarks(const Vec3& axis) {
    const Vec2 start = place(mapAngles(axis)), end = place(mapAngles(-axis));
    m_canvas.ring(start, kMark * unit(), {m_style.background, (kStrong + 2.0 * kCasing) * unit()});
    m_canvas.ring(start, kMark * unit(), {m_contrast, kStrong * unit()});
    m_canvas.dot(end, (kMark + kCasing) * unit(), m_style.background);
    m_canvas.dot(end, kMark * unit(), m_contrast);
}

void MapPainter::paintJudgedCells() {
    m_canvas.clipTo(m_area);
    const double leastSize = kLeastCell * unit() * kTurn / (m_area.right - m_area.left);
    for (const std::vector<Vec2>& outline : cellOutlines(m_map, leastSize))
        for (const double turn : {-kTurn, 0.0, kTurn}) {
            std::vector<Vec2> points;
            for (const Vec2& each : outline) points.push_back(place({each.x, each.y + turn}));
            m_canvas.line(points, {m_style.background, kThin * unit()});
        }
}

void MapPainter::paintHorizon() {
    const std::vector<Vec2> line = horizonLine(m_map);
    if (line.empty()) return;
    m_canvas.clipTo(m_area);
    curve(line, {kRegionOnMap, kStrong * unit()});
    axisMarks(m_map.decision.eye);
}

}  // namespace

std::vector<uint8_t> mapPicture(const MapSnapshot& map, MapColouring colouring, const Viewport& size, const DrawStyle& style) {
    const SphericalDecision& decision = map.decision;
    MapPainter painter(map, size, style);
    painter.paintCells(cellColours(map, colouring, style.background));
    painter.paintFrame();
    painter.paintJudgedCells();
    painter.paintHorizon();
    if (decision.bands) painter.paintBands(*decision.bands);
    if (decision.region) {
        painter.paintRegion(*decision.region);
        painter.paintRays(decision.rays);
    }
    return painter.rgba();
}

}  // namespace cullscope::spherical
