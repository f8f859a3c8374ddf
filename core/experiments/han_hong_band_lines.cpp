#include "core/experiments/han_hong_band_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/experiments/han_hong_figure_lines.h"
#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::han_hong {
namespace {

using namespace spherical;

// Widths and radii in units (DrawStyle::unit).
constexpr float kContourWidth = 1.0f, kAxisWidth = 1.5f, kRadiusWidth = 2.0f, kCutWidth = 2.5f;
constexpr double kOriginRadius = 3.5;
// Shares of the bounding sphere's radius.
constexpr double kAxisTop = 1.1, kAlphaRadius = 0.22, kSquareSide = 0.06, kProjectionDash = 0.035, kAxisArrow = 0.05;
constexpr uint32_t kProjectionOrange = 0xC44E00;

/// A place on an edge of a mesh, found by the edge's ends: the same from both triangles at it, whatever their indices are.
using EdgeKey = std::array<float, 6>;

EdgeKey keyOf(const Vec3& a, const Vec3& b) {
    std::array<Vec3f, 2> ends{Vec3f(a), Vec3f(b)};
    const auto before = [](const Vec3f& left, const Vec3f& right) {
        return std::tie(left.x, left.y, left.z) < std::tie(right.x, right.y, right.z);
    };
    if (before(ends[1], ends[0])) std::swap(ends[0], ends[1]);
    return {ends[0].x, ends[0].y, ends[0].z, ends[1].x, ends[1].y, ends[1].z};
}

/// The pieces of one contour, which are joined where they meet on an edge.
class Contour {
public:
    void add(const std::array<Vec3, 2>& ends, const std::array<EdgeKey, 2>& edges) {
        const uint32_t a = rootOf(numberOf(edges[0])), b = rootOf(numberOf(edges[1]));
        m_pieces.push_back({ends, a});
        m_parent[b] = a;
    }
    /// Those of lines of at least that length.
    template <typename Told>
    void tell(double leastLength, const Told& told) {
        std::map<uint32_t, double> lengths;
        for (const Piece& piece : m_pieces) lengths[rootOf(piece.line)] += glm::length(piece.ends[1] - piece.ends[0]);
        for (const Piece& piece : m_pieces)
            if (lengths[rootOf(piece.line)] >= leastLength) told(piece.ends);
    }

private:
    struct Piece {
        std::array<Vec3, 2> ends;
        uint32_t line = 0;
    };
    uint32_t numberOf(const EdgeKey& edge) {
        const auto [place, isNew] = m_numbers.try_emplace(edge, uint32_t(m_parent.size()));
        if (isNew) m_parent.push_back(place->second);
        return place->second;
    }
    uint32_t rootOf(uint32_t number) {
        while (m_parent[number] != number) number = m_parent[number] = m_parent[m_parent[number]];
        return number;
    }

    std::map<EdgeKey, uint32_t> m_numbers;
    std::vector<uint32_t> m_parent;
    std::vector<Piece> m_pieces;
};

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

std::vector<OverlayLines> contoursOnSurface(const OverlayContext& context, const MapSnapshot& map, double leastLength) {
    const ContourBands& bands = *map.decision.bands;
    const MapPlace place(context.scene, map);
    std::vector<Contour> contours(bands.bands + 1);
    for (uint32_t triangle = 0; triangle < map.maps.mesh().triangleCount(); ++triangle) {
        const std::array<Vec3, 3> corners = map.maps->corners(triangle);
        std::array<double, 3> alpha{};
        for (size_t i = 0; i < 3; ++i) alpha[i] = bands.anglesOf(corners[i]).x;
        const auto [least, most] = std::ranges::minmax(alpha);
        for (auto band = uint32_t(std::ceil(least / bands.width)); band * bands.width < most; ++band) {
            const double level = band * bands.width;
            std::array<Vec3, 2> ends;
            std::array<EdgeKey, 2> edges;
            size_t found = 0;
            for (size_t i = 0; i < 3 && found < 2; ++i) {
                const size_t next = (i + 1) % 3;
                if ((alpha[i] < level) == (alpha[next] < level)) continue;
                const double share = (level - alpha[i]) / (alpha[next] - alpha[i]);
                edges[found] = keyOf(corners[i], corners[next]);
                ends[found++] = glm::mix(corners[i], corners[next], share);
            }
            if (found == 2) contours[band].add(ends, edges);
        }
    }
    OverlayLines thin{{}, {kContourWidth, true}, true}, middle{{}, {kCutWidth, true}, true};
    for (uint32_t band = 0; band < contours.size(); ++band) {
        const bool right = std::abs(band * bands.width - kRightAngle) < 1e-9;
        contours[band].tell(leastLength * map.maps.sphere().radius, [&](const std::array<Vec3, 2>& ends) {
            (right ? middle : thin)
                .lines.push_back(
                    {raised(context, place.world(ends[0])), raised(context, place.world(ends[1])), context.contrast});
        });
    }
    return {std::move(thin), std::move(middle)};
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
