// Bounding spheres, visible regions and corner rays of strategies with maps of directions.

#include <numbers>

#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope::spherical {
namespace {

// Widths and radii in units.
constexpr float kCircleWidth = 1.0f;
constexpr float kCellWidth = 1.0f;
constexpr float kLineWidth = 1.5f;
constexpr float kRayMarkWidth = 2.0f;
constexpr double kEntryRadius = 3.5;
constexpr double kHitRadius = 4.0;
constexpr double kMissRadius = 4.5;
constexpr double kLeastCellOnSphere = 8.0;

constexpr double kSphereStep = std::numbers::pi / 120.0;  ///< step of lines on the sphere, radians
constexpr int kStepsADash = 2;

Vec3 directionOf(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

class SphereLines {
public:
    explicit SphereLines(const OverlayContext& context) : m_context(context) {}

    void add(const MapSnapshot& map) {
        const MapPlace place(m_context.scene, map);
        addCircles(map, place);
        if (map.tree && map.decision.walk) addCells(map, place);
        if (map.decision.region) addRegion(map, place);
        for (const CornerRay& ray : map.decision.rays)
            if (ray.followed) addRay(ray, map.decision.eye, place);
    }

    [[nodiscard]] std::vector<OverlayLines> overlays() && {
        // Where cells share a border, that of a drawn cell is drawn last, over the others.
        std::vector<LineSegment> cells;
        for (const TriangleState state :
             {TriangleState::OutsideFrustum, TriangleState::Hidden, TriangleState::BackFacing, TriangleState::Visible})
            cells.insert(cells.end(), m_cells[size_t(state)].begin(), m_cells[size_t(state)].end());
        return {{std::move(m_circles), {kCircleWidth, true}},
                {std::move(m_lines), {kLineWidth, true}, true},
                {std::move(m_marks), {kRayMarkWidth, false}, true},
                {std::move(cells), {kCellWidth, true}}};
    }

private:
    void addCircles(const MapSnapshot& map, const MapPlace& place) {
        const double radius = map.maps.sphere().radius;
        const Vec3f colour = sphereColour(m_context.style.background);
        const Vec3 centre = place.world(Vec3(0.0));
        const double worldRadius = m_context.scene.instanceSphere(map.decision.instance).radius;
        const int pieces = piecesOfCircle(pixelsOf(m_context.viewing, centre, worldRadius));
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = [&](int i) {
                const double angle = 2.0 * std::numbers::pi * i / pieces;
                Vec3 point(0.0);
                point[(axis + 1) % 3] = radius * std::cos(angle);
                point[(axis + 2) % 3] = radius * std::sin(angle);
                return place.world(point);
            };
            for (int i = 0; i < pieces; ++i) m_circles.push_back({at(i), at(i + 1), colour});
        }
    }

    /// A line on the sphere that is straight in (θ, φ).
    void addOnSphere(const Vec2& from, const Vec2& to, double radius, const MapPlace& place, const Vec3f& colour, bool dashed) {
        const int steps = std::max(1, int(std::ceil(glm::length(to - from) / kSphereStep)));
        const auto at = [&](int i) {
            const Vec2 angles = glm::mix(from, to, double(i) / steps);
            return place.world(radius * directionOf(angles.x, angles.y));
        };
        for (int i = 0; i < steps; ++i, ++m_dash)
            if (!dashed || m_dash / kStepsADash % 2 == 0) m_lines.push_back({at(i), at(i + 1), colour});
    }

    void addBox(const CellBox& box, const SphericalGrid& grid, double radius, const MapPlace& place) {
        const double top = grid.thetaOf(box.firstRow), bottom = grid.thetaOf(box.lastRow + 1);
        const double left = grid.phiOf(box.firstColumn), right = grid.phiOf(box.lastColumn + 1);
        for (const double theta : {top, bottom})
            addOnSphere({theta, left}, {theta, right}, radius, place, m_context.contrast, false);
        // Full rows have no left and right border.
        if (box.firstColumn == 0 && box.lastColumn + 1 == grid.columns()) return;
        for (const double phi : {left, right}) addOnSphere({top, phi}, {bottom, phi}, radius, place, m_context.contrast, false);
    }

    void addRegion(const MapSnapshot& map, const MapPlace& place) {
        const VisibleRegion& region = *map.decision.region;
        const double radius = map.maps.sphere().radius;
        for (const CellBox& box : region.boxes) addBox(box, map.maps->grid(), radius, place);
        const std::vector<Vec2>& outline = region.outline;
        const Vec3f colour = regionColour(m_context.style.background);
        m_dash = 0;
        for (size_t i = 1; i < outline.size(); ++i) addOnSphere(outline[i - 1], outline[i], radius, place, colour, true);
        // In case 1 the outline ends a whole turn from its start, which is the same place on the sphere.
        if (region.caseNumber != 1 && outline.size() > 1)
            addOnSphere(outline.back(), outline.front(), radius, place, colour, true);
    }

    void addCells(const MapSnapshot& map, const MapPlace& place) {
        const double radius = map.maps.sphere().radius, squared = radius * radius;
        const double pixels =
            pixelsOf(m_context.viewing, place.world(Vec3(0.0)), m_context.scene.instanceSphere(map.decision.instance).radius);
        const double leastAngle = kLeastCellOnSphere * m_context.style.unit / pixels;
        const Vec3 eye = place.local(m_context.viewing.eye());
        const MapLayout layout = map.tree->layout();
        for (const JudgedCell& judged : map.decision.walk->judged) {
            const MapCell cell = map.tree->nodes()[judged.node].cell();
            if (!(solidAngle(layout, cell) > leastAngle * leastAngle)) continue;
            const TriangleState state = judged.cause ? stateOfCause(*judged.cause) : TriangleState::Visible;
            const std::vector<Vec2> outline = cellOutline(layout, cell);
            for (size_t i = 1; i < outline.size(); ++i) {
                const Vec3 from = radius * directionOf(outline[i - 1].x, outline[i - 1].y);
                const Vec3 to = radius * directionOf(outline[i].x, outline[i].y);
                // Borders on the far side would be seen through the sphere and clutter the picture; seen from within it there is
                // no far side.
                if (glm::dot(eye, eye) > squared && (glm::dot(from, eye) < squared || glm::dot(to, eye) < squared)) continue;
                m_cells[size_t(state)].push_back({place.world(from), place.world(to), m_context.palette[size_t(state)].colour});
            }
        }
    }

    void addRay(const CornerRay& ray, const Vec3& eye, const MapPlace& place) {
        m_lines.push_back({place.world(eye), place.world(ray.point), m_context.contrast});
        if (ray.span)
            addMark(m_marks, m_context, place.world(ray.ray.at(ray.span->from)), kEntryRadius, MarkShape::Ring,
                    m_context.contrast);
        if (ray.hit)
            addMark(m_marks, m_context, place.world(ray.point), kHitRadius, MarkShape::Dot,
                    regionColour(m_context.style.background));
        else
            addMark(m_marks, m_context, place.world(ray.point), kMissRadius, MarkShape::Cross, m_context.contrast);
    }

    const OverlayContext& m_context;
    std::vector<LineSegment> m_circles, m_lines, m_marks;
    std::array<std::vector<LineSegment>, kTriangleStateCount> m_cells;
    int m_dash = 0;  ///< steps since the outline began
};

}  // namespace

Vec3f sphereColour(const Vec3f& background) { return verdictPalette(background)[size_t(TriangleState::Visible)].colour; }

Vec3f regionColour(const Vec3f& /*background*/) { return {0.86f, 0.08f, 0.08f}; }

std::vector<OverlayLines> sphereOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps) {
    SphereLines lines(context);
    for (const MapSnapshot& map : maps)
        if (map.decision.relation != SphereRelation::Outside) lines.add(map);
    return std::move(lines).overlays();
}

}  // namespace cullscope::spherical
