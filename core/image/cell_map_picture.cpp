#include "core/image/cell_map_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/raster/canvas.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope {
namespace {

// Widths, lengths and radii in units (DrawStyle::unit).
constexpr double kMapMargin = 14.0;  ///< around the map, for the ticks
constexpr double kTick = 5.0;
constexpr double kLongMapTick = 9.0;  ///< every 90°
constexpr double kThin = 1.0;
constexpr double kStrong = 2.0;
constexpr double kMapCasing = 1.5;      ///< width of the background-coloured border on both sides of a line
constexpr double kCircleCasing = 0.75;  ///< narrower: circles are many, and cells are to be seen between them
constexpr double kDash = 6.0;
constexpr double kMapMark = 4.5;
constexpr double kLeastCell = 5.0;  ///< smaller cells are not outlined
constexpr double kWalkedOpacity = 0.75;
constexpr double kInsideOpacity = 0.22;

constexpr Vec3f kRegionOnMap(0.86f, 0.08f, 0.08f);  ///< red and dashed, as in the paper's Figure 4

/// Brewer's Blues without the lightest one (Harrower & Brewer 2003): even steps of lightness, and no colour that overlays use.
constexpr std::array<uint32_t, 8> kRamp{0xDEEBF7, 0xC6DBEF, 0x9ECAE1, 0x6BAED6, 0x4292C6, 0x2171B5, 0x08519C, 0x08306B};

/// Draws the map and what lies over it.
class CellMapPainter {
public:
    CellMapPainter(const CellMap& map, const Viewport& size, const DrawStyle& style)
        : m_map(map),
          m_canvas(size, style.background, style.backgroundAlpha),
          m_style(style),
          m_contrast(contrastTo(style.background)) {
        const MapArea area = mapArea(size, kMapMargin * style.unit);
        const double top = size.height - area.bottom - area.height;
        m_area = {area.left, top, area.left + area.width, top + area.height};
    }

    void paintCells(const std::vector<Vec3f>& colours);
    void paintFrame();
    void paintOutlines();
    void paintBoxes();
    void paintInsides();
    void paintCurves();
    void paintCircles(const MapCircles& circles);
    void axisMarks(const Vec3& axis);
    void paintMarks();
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
    void box(const SphericalGrid::Box& box, const Canvas::Pen& pen);
    void cross(const Vec2& centre, const Canvas::Pen& pen);
    void tick(const Vec2& from, const Vec2& outward, int degrees);

    const CellMap& m_map;
    Canvas m_canvas;
    const DrawStyle& m_style;
    Vec3f m_contrast;
    Canvas::Rectangle m_area;
};

/// The mean colour of the cells that a pixel covers; the colour of the cell under its centre where it covers no more than that.
Vec3f CellMapPainter::meanColour(const std::vector<Vec3f>& colours, int x, int y) const {
    const SphericalGrid& grid = m_map.grid;
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

void CellMapPainter::paintCells(const std::vector<Vec3f>& colours) {
    for (int y = int(m_area.top); y < int(m_area.bottom); ++y)
        for (int x = int(m_area.left); x < int(m_area.right); ++x) m_canvas.setPixel(x, y, meanColour(colours, x, y));
}

void CellMapPainter::tick(const Vec2& from, const Vec2& outward, int degrees) {
    const double length = (degrees % 90 == 0 ? kLongMapTick : kTick) * unit();
    const std::array points{from, from + length * outward};
    m_canvas.line(points, {m_contrast, kThin * unit()});
}

void CellMapPainter::paintFrame() {
    const std::array corners{Vec2(m_area.left, m_area.top), Vec2(m_area.right, m_area.top), Vec2(m_area.right, m_area.bottom),
                             Vec2(m_area.left, m_area.bottom), Vec2(m_area.left, m_area.top)};
    m_canvas.line(corners, {m_contrast, kThin * unit()});
    for (int degrees = 0; degrees <= 360; degrees += 30)
        tick(place({std::numbers::pi, degrees * kTurn / 360.0}), Vec2(0.0, 1.0), degrees);
    for (int degrees = 0; degrees <= 180; degrees += 30) tick(place({degrees * kTurn / 360.0, 0.0}), Vec2(-1.0, 0.0), degrees);
}

void CellMapPainter::curve(const std::vector<Vec2>& angles, const Canvas::Pen& pen) {
    for (const bool casing : {true, false})
        for (const double turn : {-kTurn, 0.0, kTurn}) {
            std::vector<Vec2> points;
            for (const Vec2& each : angles) points.push_back(place({each.x, each.y + turn}));
            m_canvas.line(points, casing ? Canvas::Pen{m_style.background, pen.width + 2.0 * kMapCasing * unit()} : pen);
        }
}

void CellMapPainter::box(const SphericalGrid::Box& box, const Canvas::Pen& pen) {
    const SphericalGrid& grid = m_map.grid;
    const double top = grid.thetaOf(box.firstRow), bottom = grid.thetaOf(box.lastRow + 1);
    const double left = grid.phiOf(box.firstColumn), right = grid.phiOf(box.lastColumn + 1);
    std::array corners{place({top, left}), place({top, right}), place({bottom, right}), place({bottom, left}),
                       place({top, left})};
    // A border that is the map's, too, stands within it, where it can be told from the map's frame.
    const double inside = pen.width / 2 + kMapCasing * unit();
    for (Vec2& corner : corners)
        corner = glm::clamp(corner, Vec2(m_area.left + inside, m_area.top + inside),
                            Vec2(m_area.right - inside, m_area.bottom - inside));
    m_canvas.line(corners, {m_style.background, pen.width + 2.0 * kMapCasing * unit()});
    m_canvas.line(corners, pen);
}

void CellMapPainter::paintBoxes() {
    m_canvas.clipTo(m_area);
    for (const SphericalGrid::Box& each : m_map.boxes) box(each, {m_contrast, kStrong * unit()});
}

/// Shades what regions enclose: what a line encloses that is closed, or what lies between a line around the axis and its pole.
void CellMapPainter::paintInsides() {
    m_canvas.clipTo(m_area);
    for (const MapCurve& each : m_map.curves) {
        if (each.symbol != MapSymbol::Region || !(each.closed || each.pole)) continue;
        for (const double turn : {-kTurn, 0.0, kTurn}) {
            std::vector<Vec2> polygon;
            for (const Vec2& point : each.points) polygon.push_back(place({point.x, point.y + turn}));
            if (each.pole) {
                polygon.push_back(place({*each.pole, each.points.back().y + turn}));
                polygon.push_back(place({*each.pole, each.points.front().y + turn}));
            }
            m_canvas.fill(polygon, kRegionOnMap, kInsideOpacity);
        }
    }
}

void CellMapPainter::paintCurves() {
    m_canvas.clipTo(m_area);
    for (const MapCurve& each : m_map.curves) {
        std::vector<Vec2> points = each.points;
        if (each.closed && !points.empty()) points.push_back(points.front());
        const bool dashed = each.symbol == MapSymbol::Region;
        curve(points, {kRegionOnMap, kStrong * unit(), dashed ? kDash * unit() : 0.0});
    }
}

void CellMapPainter::cross(const Vec2& centre, const Canvas::Pen& pen) {
    for (const double side : {1.0, -1.0}) {
        const Vec2 arm = kMapMark * unit() * Vec2(1.0, side);
        const std::array points{centre - arm, centre + arm};
        m_canvas.line(points, {m_style.background, pen.width + 2.0 * kMapCasing * unit()});
        m_canvas.line(points, pen);
    }
}

void CellMapPainter::paintMarks() {
    const SphericalGrid& grid = m_map.grid;
    m_canvas.clipTo(m_area);
    for (const auto& [row, column] : m_map.walked) {
        const Vec2 low = place({grid.thetaOf(row), grid.phiOf(column)});
        const Vec2 high = place({grid.thetaOf(row + 1), grid.phiOf(column + 1)});
        m_canvas.fill({low.x, low.y, std::max(high.x, low.x + 1.0), std::max(high.y, low.y + 1.0)}, m_contrast, kWalkedOpacity);
    }
    for (const MapMark& mark : m_map.marks) {
        const Vec2 centre = place(mark.place);
        if (mark.symbol == MapSymbol::Miss) {
            cross(centre, {m_contrast, kStrong * unit()});
            continue;
        }
        m_canvas.dot(centre, (kMapMark + kMapCasing) * unit(), m_style.background);
        m_canvas.dot(centre, kMapMark * unit(), kRegionOnMap);
    }
}

void CellMapPainter::paintCircles(const MapCircles& circles) {
    m_canvas.clipTo(m_area);
    for (const CutCircle& circle : cutCircles(circles)) {
        const bool equator = std::abs(circle.alpha - kRightAngle) < 1e-9;
        for (const std::vector<Vec2>& line : circle.lines) {
            std::vector<Vec2> points;
            for (const Vec2& each : line) points.push_back(place(each));
            const double width = (equator ? kStrong : kThin) * unit();
            m_canvas.line(points, {m_style.background, width + 2.0 * kCircleCasing * unit()});
            m_canvas.line(points, {m_contrast, width});
        }
    }
}

/// Marks where an axis starts (dot) and, opposite, where it ends (ring), as the desktop's map does.
void CellMapPainter::axisMarks(const Vec3& axis) {
    m_canvas.clipTo(m_area);
    const Vec2 start = place(mapAngles(axis)), end = place(mapAngles(-axis));
    m_canvas.dot(start, (kMapMark + kMapCasing) * unit(), m_style.background);
    m_canvas.dot(start, kMapMark * unit(), m_contrast);
    m_canvas.ring(end, kMapMark * unit(), {m_style.background, (kStrong + 2.0 * kMapCasing) * unit()});
    m_canvas.ring(end, kMapMark * unit(), {m_contrast, kStrong * unit()});
}

void CellMapPainter::paintOutlines() {
    m_canvas.clipTo(m_area);
    const double leastSize = kLeastCell * unit() * kTurn / (m_area.right - m_area.left);
    for (const std::vector<Vec2>& outline : m_map.source->outlines(leastSize))
        for (const double turn : {-kTurn, 0.0, kTurn}) {
            std::vector<Vec2> points;
            for (const Vec2& each : outline) points.push_back(place({each.x, each.y + turn}));
            m_canvas.line(points, {m_style.background, kThin * unit()});
        }
}

}  // namespace

Vec3f rampColour(double share, const Vec3f& background) {
    return colourFromRamp(kRamp, isLight(background) ? share : 1.0 - share);
}

std::vector<Vec3f> cellColours(const CellMap& map, std::string_view colouring, const Vec3f& background) {
    std::vector<Vec3f> colours;
    const MapColouring* shown = map.colouring(colouring);
    if (shown == nullptr || !shown->states) {
        for (const float share : map.source->values(colouring).shares)
            colours.push_back(share < 0.0f ? background : rampColour(share, background));
        return colours;
    }
    const auto palette = verdictPalette(background);
    const auto& states = map.source->states();
    for (uint32_t cell = 0; cell < states.size(); ++cell) {
        const std::optional<TriangleState> state = states[cell] ? states[cell] : map.source->stateBetween(cell);
        colours.push_back(state ? palette[size_t(*state)].colour : background);
    }
    return colours;
}

std::vector<uint8_t> cellMapPicture(const CellMap& map, std::string_view colouring, const Viewport& size,
                                    const DrawStyle& style) {
    CellMapPainter painter(map, size, style);
    painter.paintCells(cellColours(map, colouring, style.background));
    painter.paintFrame();
    painter.paintOutlines();
    painter.paintInsides();
    painter.paintBoxes();
    painter.paintCurves();
    if (map.circles) painter.paintCircles(*map.circles);
    if (map.axis) painter.axisMarks(*map.axis);
    painter.paintMarks();
    return painter.rgba();
}

}  // namespace cullscope
