#include "core/experiments/han_hong_figure_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::han_hong {
namespace {

using namespace spherical;

// Widths and radii in units (DrawStyle::unit).
constexpr float kThin = 1.0f, kRay = 1.5f, kStrong = 2.5f;
constexpr double kEntryRadius = 3.5, kHitRadius = 4.0, kMissRadius = 4.5;

constexpr double kMarkRaised = 0.01;  ///< the same of marks, which are flat and the surface is not
constexpr double kStep = kPi / 360;   ///< of lines on the surface, radians
constexpr int kStepsADash = 4;
/// Between two steps on one surface R changes by less than this share of the sphere's radius.
constexpr double kJump = 0.06;
constexpr float kPale = 0.6f;  ///< share of the background's colour in what a surface hides
constexpr Vec3f kRegionRed(0.86f, 0.08f, 0.08f);

/// Lines through points (θ, φ) on the outermost surface of an object.
class OnSurface {
public:
    OnSurface(const OverlayContext& context, const MapSnapshot& map)
        : m_context(context), m_maps(*map.maps), m_place(context.scene, map) {}

    /// Straight on the map, as the region's outline is. Where a direction meets no surface there is a gap.
    void add(const Vec2& from, const Vec2& to, const Vec3f& colour, bool dashed, std::vector<LineSegment>& lines) {
        const int steps = std::max(1, int(std::ceil(glm::length(to - from) / kStep)));
        std::optional<Vec3> before = at(from);
        for (int i = 1; i <= steps; ++i, ++m_dash) {
            const std::optional<Vec3> here = at(glm::mix(from, to, double(i) / steps));
            const bool joined = before && here && std::abs(glm::length(*here) - glm::length(*before)) < kJump * radius();
            if (joined && !(dashed && m_dash / kStepsADash % 2 == 1))
                lines.push_back({raised(m_context, m_place.world(*before)), raised(m_context, m_place.world(*here)), colour});
            before = here;
        }
    }

private:
    [[nodiscard]] double radius() const { return m_maps.sphere().radius; }

    [[nodiscard]] std::optional<Vec3> at(const Vec2& angles) const {
        const Vec3 direction(std::sin(angles.x) * std::cos(angles.y), std::sin(angles.x) * std::sin(angles.y),
                             std::cos(angles.x));
        const Ray inward{1.001 * radius() * direction, -direction};
        const std::optional<TriangleHit> hit = searchTriangle(m_maps, inward, {0.0, 1.001 * radius()});
        return hit ? std::optional(inward.at(hit->t)) : std::nullopt;
    }

    const OverlayContext& m_context;
    const SphericalMaps& m_maps;
    MapPlace m_place;
    int m_dash = 0;
};

void addBox(OnSurface& surface, const CellBox& box, const SphericalGrid& grid, const Vec3f& colour,
            std::vector<LineSegment>& lines) {
    const double top = grid.thetaOf(box.firstRow), bottom = grid.thetaOf(box.lastRow + 1);
    const double left = grid.phiOf(box.firstColumn), right = grid.phiOf(box.lastColumn + 1);
    for (const double theta : {top, bottom}) surface.add({theta, left}, {theta, right}, colour, false, lines);
    // Full rows have no left and right border.
    if (box.firstColumn == 0 && box.lastColumn + 1 == grid.columns()) return;
    for (const double phi : {left, right}) surface.add({top, phi}, {bottom, phi}, colour, false, lines);
}

}  // namespace

Vec3 raised(const OverlayContext& context, const Vec3& place) {
    const View& viewing = context.viewing;
    const Vec3 toEye = viewing.eye() - place;
    if (viewing.camera().projection == ProjectionKind::Perspective) return place + kRaised * toEye;
    return place + kRaised * glm::dot(toEye, viewing.frustum().forward) * viewing.frustum().forward;
}

std::vector<OverlayLines> searchOnSurface(const OverlayContext& context, const MapSnapshot& map) {
    const MapPlace place(context.scene, map);
    const VisibleRegion& region = *map.decision.region;
    OnSurface surface(context, map);
    OverlayLines boxes{{}, {kRay, true}, true}, outline{{}, {kStrong, true}, true};
    for (const CellBox& box : region.boxes) addBox(surface, box, map.maps->grid(), context.contrast, boxes.lines);
    for (size_t i = 1; i < region.outline.size(); ++i)
        surface.add(region.outline[i - 1], region.outline[i], kRegionRed, true, outline.lines);
    if (!region.winds && region.outline.size() > 1)
        surface.add(region.outline.back(), region.outline.front(), kRegionRed, true, outline.lines);

    OverlayLines behind{{}, {kRay, false}}, rays{{}, {kRay, true}}, marks{{}, {2.0f, false}, true};
    OverlayLines hidden{{}, {2.0f, false}, true}, hits{{}, {2.0f, true}, true};
    const Vec3f pale = glm::mix(context.contrast, context.style.background, kPale);
    const Vec3f paleRed = glm::mix(kRegionRed, context.style.background, kPale);
    for (const CornerRay& ray : map.decision.rays) {
        if (!ray.followed) continue;
        const Vec3 from = place.world(map.decision.eye), to = place.world(ray.point);
        behind.lines.push_back({from, to, pale});
        rays.lines.push_back({from, raised(context, to), context.contrast});
        if (ray.span)
            addMark(marks.lines, context, place.world(ray.ray.at(ray.span->from)), kEntryRadius, MarkShape::Ring,
                    context.contrast);
        if (ray.hit) {
            // Pale where a surface hides it from the viewing camera.
            addMark(hidden.lines, context, to, kHitRadius, MarkShape::Dot, paleRed);
            addMark(hits.lines, context, glm::mix(to, context.viewing.eye(), kMarkRaised), kHitRadius, MarkShape::Dot,
                    kRegionRed);
        } else {
            addMark(marks.lines, context, to, kMissRadius, MarkShape::Cross, context.contrast);
        }
    }
    addMark(marks.lines, context, place.world(map.decision.eye), kHitRadius, MarkShape::Dot, context.contrast);
    return {std::move(boxes), std::move(outline), std::move(behind), std::move(rays),
            std::move(marks), std::move(hidden),  std::move(hits)};
}

OverlayLines greatCircles(const OverlayContext& context, const MapSnapshot& map) {
    const MapPlace place(context.scene, map);
    const double radius = map.maps.sphere().radius;
    const Vec3f colour = context.palette[size_t(TriangleState::Visible)].colour;
    constexpr int kPieces = 96;
    OverlayLines circles{{}, {kThin, true}};
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](int i) {
            Vec3 point(0.0);
            point[(axis + 1) % 3] = radius * std::cos(kTurn * i / kPieces);
            point[(axis + 2) % 3] = radius * std::sin(kTurn * i / kPieces);
            return place.world(point);
        };
        for (int i = 0; i < kPieces; ++i) circles.lines.push_back({at(i), at(i + 1), colour});
    }
    return circles;
}

std::optional<PlotPoint> placeIn(const View& viewing, const Vec3& place) {
    const Frustum& frustum = viewing.frustum();
    const Vec3 to = place - viewing.eye();
    const double distance = glm::dot(to, frustum.forward);
    if (!(distance > 0.0)) return std::nullopt;
    const double pixels = 0.5 * viewing.viewport().height / frustum.halfHeightAt(distance);
    return PlotPoint{0.5 * viewing.viewport().width + pixels * glm::dot(to, frustum.right),
                     0.5 * viewing.viewport().height - pixels * glm::dot(to, frustum.up)};
}

uint32_t tellingSector(const ContourBands& bands, const Vec3& upright) {
    uint32_t best = 0;
    double most = -1e9;
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        int drawn = 0, hidden = 0, larger = 0;
        for (uint32_t band = 0; band < bands.bands; ++band) {
            const BandSector& entry = bands.at(band, sector);
            if (!(entry.size > 0.0) || (band + 1) * bands.width <= kRightAngle * (1.0 + 1e-12)) continue;
            ++(entry.drawn || entry.within ? drawn : hidden);
            larger += !entry.drawn && !entry.within && entry.size > entry.horizon ? 1 : 0;
        }
        const double up = glm::dot(bands.direction(kRightAngle, (sector + 0.5) * kTurn / bands.sectors), upright);
        const double telling = up - 10.0 * larger - (drawn > 0 && hidden > 1 ? 0.0 : 5.0);
        if (telling > most) most = telling, best = sector;
    }
    return best;
}

}  // namespace cullscope::han_hong
