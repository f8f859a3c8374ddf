#include "core/experiments/han_hong_band_lines.h"

#include <algorithm>
#include <cmath>

#include "core/experiments/han_hong_figure_lines.h"
#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::han_hong {
namespace {

using namespace spherical;

// Widths and radii in units (DrawStyle::unit).
constexpr float kAxisWidth = 1.5f, kRadiusWidth = 2.0f, kCutWidth = 2.5f;
constexpr double kOriginRadius = 3.5;
// Shares of the bounding sphere's radius.
constexpr double kAxisTop = 1.1, kAlphaRadius = 0.22, kSquareSide = 0.06, kProjectionDash = 0.035, kAxisArrow = 0.05;
constexpr uint32_t kProjectionOrange = 0xC44E00;

void addProjectionDashes(std::vector<LineSegment>& lines, const Vec3& from, const Vec3& to, double dash, const Vec3f& colour) {
    const int dashes = std::max(1, int(glm::length(to - from) / (2.0 * dash)));
    for (int i = 0; i < dashes; ++i)
        lines.push_back({glm::mix(from, to, double(i) / dashes), glm::mix(from, to, (i + 0.6) / dashes), colour});
}

/// The square corner between two directions of unit length.
void addRightAngle(std::vector<LineSegment>& lines, const Vec3& corner, const Vec3& one, const Vec3& other, double side,
                   const Vec3f& colour) {
    const Vec3 tip = corner + side * (one + other);
    lines.push_back({corner + side * one, tip, colour});
    lines.push_back({tip, corner + side * other, colour});
}

}  // namespace

std::array<Vec3, 3> cornersInWorld(const Scene& scene, uint64_t triangle) {
    const size_t instance = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(instance);
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t vertex = mesh.indices()[3 * (triangle - scene.firstTriangle(instance)) + i];
        corners[i] = Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.origin() + Vec3(mesh.positions()[vertex]), 1.0));
    }
    return corners;
}

double lightnessOfBand(const ContourBands& bands, const Vec3& place) {
    constexpr double kDarker = 0.74;
    return bands.bandOf(bands.anglesOf(place).x) % 2 == 1 ? kDarker : 1.0;
}

OverlayLines rimOf(const OverlayContext& context, const FrameLog& log) {
    struct Edge {
        uint32_t instance = 0, low = 0, high = 0;

        auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;
    const DrawList drawn = drawnTriangles(context.scene, log);
    for (const DrawRange& range : drawn.ranges) {
        const uint32_t mesh = context.scene.instances()[range.instance].mesh;
        const std::span<const uint32_t> ordered = drawn.orderOf(mesh).indices;
        const std::span<const uint32_t> indices = ordered.empty() ? context.scene.meshes()[mesh]->indices() : ordered;
        for (uint32_t first = range.firstIndex; first < range.firstIndex + range.indexCount; first += 3)
            for (uint32_t i = 0; i < 3; ++i) {
                const uint32_t a = indices[first + i], b = indices[first + (i + 1) % 3];
                edges.push_back({range.instance, std::min(a, b), std::max(a, b)});
            }
    }
    std::ranges::sort(edges);
    OverlayLines rim{{}, {kAxisWidth, true}};
    for (size_t i = 0; i < edges.size(); ++i) {
        if ((i > 0 && edges[i - 1] == edges[i]) || (i + 1 < edges.size() && edges[i + 1] == edges[i])) continue;
        const Instance& instance = context.scene.instances()[edges[i].instance];
        const TriangleMesh& mesh = *context.scene.meshes()[instance.mesh];
        const auto at = [&](uint32_t vertex) {
            return raised(context, Vec3(instance.worldFromMesh * Vec4(mesh.origin() + Vec3(mesh.positions()[vertex]), 1.0)));
        };
        rim.lines.push_back({at(edges[i].low), at(edges[i].high), context.contrast});
    }
    return rim;
}

std::optional<Projection> projectionOf(const Scene& scene, const MapSnapshot& map, const std::vector<SizePlace>& sizes) {
    constexpr int kPieces = 24;
    const auto largest = std::ranges::max_element(sizes, {}, [](const SizePlace& size) { return size.larger ? 0.0 : size.size; });
    if (largest == sizes.end()) return std::nullopt;
    const MapPlace place(scene, map);
    const double radius = map.maps.sphere().radius;
    const Vec3& axis = map.decision.bands->axis;
    const Vec3 outward = glm::normalize(largest->surface - largest->foot);
    Projection projection{place.world(Vec3(0.0)),
                          place.world(largest->surface),
                          place.world(radius * axis),
                          place.world(kAxisTop * radius * outward),
                          place.world(largest->size * outward),
                          {},
                          radius};
    const double alpha = std::atan2(largest->size, glm::dot(largest->surface, axis));
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = alpha * i / kPieces;
        projection.arc.push_back(place.world(kAlphaRadius * radius * (std::cos(angle) * axis + std::sin(angle) * outward)));
    }
    return projection;
}

std::vector<OverlayLines> projectionLines(const OverlayContext& context, const Projection& projection) {
    const Vec3f colour = projectionColour();
    const Vec3 &origin = projection.origin, &top = projection.top;
    const Vec3 toEye = glm::normalize(projection.start - origin), up = glm::normalize(top - origin);
    const double side = kSquareSide * projection.radius, arrow = kAxisArrow * projection.radius;
    OverlayLines axis{{}, {kAxisWidth, false}, true}, size{{}, {kCutWidth, false}, true}, far{{}, {kRadiusWidth, false}, true};
    OverlayLines dashes{{}, {kAxisWidth, false}, true}, marks{{}, {kRadiusWidth, false}, true};
    axis.lines.push_back({origin, top, context.contrast});
    for (const double aside : {-0.5, 0.5})
        axis.lines.push_back({top, top - arrow * up + aside * arrow * toEye, context.contrast});
    addRightAngle(axis.lines, origin, toEye, up, side, context.contrast);
    addRightAngle(axis.lines, projection.onPerpendicular, glm::normalize(projection.place - projection.onPerpendicular), -up,
                  side, context.contrast);
    for (size_t i = 1; i < projection.arc.size(); ++i)
        axis.lines.push_back({projection.arc[i - 1], projection.arc[i], context.contrast});
    size.lines.push_back({origin, projection.onPerpendicular, sizeColour(context.style.background)});
    far.lines.push_back({origin, projection.place, colour});
    addProjectionDashes(dashes.lines, projection.place, projection.onPerpendicular, kProjectionDash * projection.radius, colour);
    addMark(marks.lines, context, origin, kOriginRadius, MarkShape::Dot, context.contrast);
    return {std::move(axis), std::move(size), std::move(far), std::move(dashes), std::move(marks)};
}

Vec3f projectionColour() { return colourFromHexadecimal(kProjectionOrange); }

}  // namespace cullscope::han_hong
