#include "core/mesh/inside_out.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <tuple>

#include "core/geometry/predicates.h"
#include "core/mesh/edges.h"
#include "core/mesh/triangle_boxes.h"
#include "core/mesh/triangle_contact.h"

namespace cullscope {
namespace {

/// Of meshes of size 1: what is smaller comes of rounding. Floats of such a mesh are 6e-8 apart.
constexpr double kSpeck = 1e-9;

/// A line of contact in one of its triangles.
struct Line {
    uint32_t triangle;
    TriangleContact::Piece piece;
};

/// A point of a triangle in front of which the winding number is asked.
struct Place {
    uint32_t triangle;
    Vec3 point;
};

/// The corners about the middle of the mesh, scaled by a power of two so that none is farther than 1 along an axis. Differences
/// of floats of one mesh are exact, or rounded in their last places by which triangles that share corners move alike.
std::vector<TriangleCorners> scaledCorners(const TriangleMesh& mesh) {
    const Box3& box = mesh.localBounds();
    const Vec3 middle(Vec3f(box.centre()));
    const Vec3 half = glm::max(box.max - middle, middle - box.min);
    const double largest = std::max({half.x, half.y, half.z});
    const double scale = largest > 0.0 ? std::exp2(-std::ilogb(largest) - 1) : 1.0;
    std::vector<TriangleCorners> triangles(mesh.triangleCount());
    const std::span<const uint32_t> indices = mesh.indices();
    tbb::parallel_for(size_t{0}, triangles.size(), [&](size_t i) {
        for (size_t corner = 0; corner < 3; ++corner)
            triangles[i][corner] = (Vec3(mesh.positions()[indices[3 * i + corner]]) - middle) * scale;
    });
    return triangles;
}

class Windings {
public:
    Windings(std::span<const TriangleCorners> triangles, const TriangleBoxes& boxes) : m_triangles(triangles), m_boxes(boxes) {}

    /// The winding number just in front of a triangle at a point of it; none where every axis through it meets an edge.
    [[nodiscard]] std::optional<int> inFrontOf(const Place& place) const {
        const TriangleCorners& corners = m_triangles[place.triangle];
        const Vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        std::array<int, 3> axes{0, 1, 2};
        std::ranges::sort(axes, std::greater<>{}, [&](int axis) { return std::abs(normal[axis]); });
        for (const int axis : axes) {
            if (!(std::abs(normal[axis]) > 1e-9)) break;
            if (const std::optional<int> winding = along(place, normal, axis)) return winding;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] std::optional<int> along(const Place& place, const Vec3& normal, int axis) const {
        const bool forward = normal[axis] > 0.0;
        int winding = 0;
        bool clear = true;
        std::vector<uint32_t> met;
        m_boxes.visitAlong(place.point, axis, forward, [&](uint32_t triangle) { met.push_back(triangle); });
        std::ranges::sort(met);
        met.erase(std::unique(met.begin(), met.end()), met.end());
        for (const uint32_t triangle : met) {
            if (triangle == place.triangle) continue;
            const std::optional<int> step = crossing(m_triangles[triangle], place.point, normal, axis, forward);
            clear = clear && step;
            winding += step.value_or(0);
        }
        return clear ? std::optional(winding) : std::nullopt;
    }

    /// +1 where the line leaves through a triangle's front, −1 where it enters there, 0 where it misses; none: it meets an edge,
    /// or begins on the triangle.
    static std::optional<int> crossing(const TriangleCorners& corners, const Vec3& from, const Vec3& normal, int axis,
                                       bool forward) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto flat = [&](const Vec3& point) { return Vec2(point[u], point[v]); };
        std::array<int, 3> turns{};
        for (size_t i = 0; i < 3; ++i) turns[i] = turnOf(flat(corners[i]), flat(corners[(i + 1) % 3]), flat(from));
        const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
        if (least < 0 && most > 0) return 0;
        // Seen edge-on, or over an edge. An edge-on triangle is met only where the point's line runs in its plane.
        if (least == 0 || most == 0) return onBorder(corners, from, u, v) ? std::nullopt : std::optional(0);
        const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double away = glm::dot(across, from - corners[0]) / glm::length(across);
        // In the same plane: behind the point, which is in front of its own triangle.
        if (std::abs(away) <= kContactRoom)
            return glm::length(glm::cross(normal, across / glm::length(across))) < 1e-3 ? std::optional(0) : std::nullopt;
        const bool up = most > 0;  // the triangle's normal along the axis
        const int side = sideOfPlane(corners[0], corners[1], corners[2], from);
        const bool ahead = up == forward ? side < 0 : side > 0;
        if (!ahead) return 0;
        return up == forward ? 1 : -1;
    }

    /// Of a point whose turns about a triangle's edges have no two signs: whether it is on them and not beside them.
    static bool onBorder(const TriangleCorners& corners, const Vec3& from, int u, int v) {
        const auto [leastU, mostU] = std::minmax({corners[0][u], corners[1][u], corners[2][u]});
        const auto [leastV, mostV] = std::minmax({corners[0][v], corners[1][v], corners[2][v]});
        return from[u] >= leastU && from[u] <= mostU && from[v] >= leastV && from[v] <= mostV;
    }

    std::span<const TriangleCorners> m_triangles;
    const TriangleBoxes& m_boxes;
};

/// The lines of contact of one triangle in coordinates of its plane.
class LinesInTriangle {
public:
    LinesInTriangle(const TriangleCorners& corners, std::span<const Line> lines) : m_corner(corners[0]) {
        const Vec3 edge = corners[1] - corners[0];
        m_u = glm::normalize(edge);
        m_v = glm::normalize(glm::cross(glm::cross(edge, corners[2] - corners[0]), edge));
        for (size_t i = 0; i < 3; ++i) m_corners[i] = flat(corners[i]);
        for (const Line& line : lines) addClipped(flat(line.piece.from), flat(line.piece.to));
        // Triangles that share an edge bring it along twice.
        std::ranges::sort(m_lines, {}, &Segment::key);
        const auto same = [](const Segment& a, const Segment& b) { return a.key() == b.key(); };
        m_lines.erase(std::unique(m_lines.begin(), m_lines.end(), same), m_lines.end());
        m_asked = m_lines.size();
        for (size_t i = 0; i < 3; ++i) m_lines.push_back({m_corners[i], m_corners[(i + 1) % 3]});
    }

    /// Points beside each line, on both sides of each piece into which the others and the triangle's edges cut it.
    void addPlaces(uint32_t triangle, std::vector<Place>& places) const {
        for (size_t i = 0; i < m_asked; ++i) {
            const Segment& line = m_lines[i];
            std::vector<double> cuts = this->cuts(line);
            for (size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
                // Not the middle: axes through it would meet edges of meshes that are as even as boxes are.
                const Vec2 at = glm::mix(line.from, line.to, glm::mix(cuts[piece], cuts[piece + 1], 0.43819));
                const double length = (cuts[piece + 1] - cuts[piece]) * glm::length(line.to - line.from);
                if (!(length > kSpeck)) continue;
                const Vec2 along = glm::normalize(line.to - line.from);
                const Vec2 aside = Vec2(-along.y, along.x) * (0.2371 * std::min(length, roomAt(at)));
                for (const Vec2& point : {at + aside, at - aside})
                    if (inside(point)) places.push_back({triangle, m_corner + point.x * m_u + point.y * m_v});
            }
        }
    }

private:
    struct Segment {
        Vec2 from, to;

        [[nodiscard]] std::tuple<double, double, double, double> key() const { return {from.x, from.y, to.x, to.y}; }
    };

    /// Of a line that lies in the triangle's plane the part that lies in the triangle or on its border.
    void addClipped(Vec2 from, Vec2 to) {
        if (std::tuple(to.x, to.y) < std::tuple(from.x, from.y)) std::swap(from, to);
        double begin = 0.0, end = 1.0;
        for (size_t i = 0; i < 3; ++i) {
            const Vec2 edge = m_corners[(i + 1) % 3] - m_corners[i];
            const double room = kContactRoom * glm::length(edge);
            const double atFrom = cross(edge, from - m_corners[i]) + room, atTo = cross(edge, to - m_corners[i]) + room;
            if (atFrom < 0.0 && atTo < 0.0) return;
            if (atFrom < 0.0) begin = std::max(begin, atFrom / (atFrom - atTo));
            if (atTo < 0.0) end = std::min(end, atFrom / (atFrom - atTo));
        }
        if (begin < end) m_lines.push_back({glm::mix(from, to, begin), glm::mix(from, to, end)});
    }

    [[nodiscard]] Vec2 flat(const Vec3& point) const {
        return {glm::dot(point - m_corner, m_u), glm::dot(point - m_corner, m_v)};
    }

    static double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

    [[nodiscard]] std::vector<double> cuts(const Segment& line) const {
        std::vector<double> cuts{0.0, 1.0};
        const Vec2 along = line.to - line.from;
        const double length = glm::length(along);
        for (const Segment& other : m_lines) {
            const Vec2 across = other.to - other.from, apart = other.from - line.from;
            const double turn = cross(along, across);
            const double share = cross(apart, along) / turn, room = kContactRoom / glm::length(across);
            if (turn != 0.0 && share >= -room && share <= 1.0 + room) cuts.push_back(cross(apart, across) / turn);
            // Of a line that lies on this one the ends cut.
            for (const Vec2& end : {other.from, other.to})
                if (std::abs(cross(end - line.from, along)) <= kSpeck * length)
                    cuts.push_back(glm::dot(end - line.from, along) / (length * length));
        }
        std::erase_if(cuts, [](double cut) { return !(cut >= 0.0 && cut <= 1.0); });
        std::ranges::sort(cuts);
        return cuts;
    }

    /// The distance to the nearest line that does not go through the point.
    [[nodiscard]] double roomAt(const Vec2& point) const {
        double room = 1.0;
        for (const Segment& line : m_lines) {
            const Vec2 along = line.to - line.from;
            const double squared = glm::dot(along, along);
            const double share = squared > 0.0 ? std::clamp(glm::dot(point - line.from, along) / squared, 0.0, 1.0) : 0.0;
            const double distance = glm::length(line.from + share * along - point);
            if (distance > kSpeck) room = std::min(room, distance);
        }
        return room;
    }

    [[nodiscard]] bool inside(const Vec2& point) const {
        for (size_t i = 0; i < 3; ++i)
            if (!(cross(m_corners[(i + 1) % 3] - m_corners[i], point - m_corners[i]) > 0.0)) return false;
        return true;
    }

    Vec3 m_corner, m_u, m_v;
    std::array<Vec2, 3> m_corners;
    std::vector<Segment> m_lines;
    size_t m_asked = 0;
};

std::vector<Line> linesOfContact(std::span<const TriangleCorners> triangles, const TriangleBoxes& boxes,
                                 const Progress& progress) {
    std::vector<Line> lines;
    std::mutex adding;
    boxes.visitOverlapping([&](uint32_t a, uint32_t b) {
        if (progress.stopRequested()) return;
        const TriangleContact contact = contactOf(triangles[a], triangles[b]);
        if (contact.count == 0) return;
        const std::lock_guard lock(adding);
        for (const TriangleContact::Piece& piece : contact.lines()) lines.insert(lines.end(), {{a, piece}, {b, piece}});
    });
    progress.check();
    std::ranges::sort(lines, {}, &Line::triangle);
    return lines;
}

/// The middle, nearly, of the largest triangle of each component.
std::vector<Place> placesOfComponents(const TriangleMesh& mesh, std::span<const TriangleCorners> triangles,
                                      const Progress& progress) {
    const std::vector<uint32_t> component = edgeComponents(mesh.positions(), mesh.indices(), progress);
    const auto area = [&](uint32_t i) {
        return glm::length(glm::cross(triangles[i][1] - triangles[i][0], triangles[i][2] - triangles[i][0]));
    };
    std::vector<Place> places;
    std::vector<uint32_t> largest(triangles.size(), UINT32_MAX);
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        uint32_t& of = largest[component[i]];
        if (of == UINT32_MAX || area(i) > area(of)) of = i;
    }
    for (const uint32_t i : largest)
        if (i != UINT32_MAX && area(i) > 0.0)
            places.push_back({i, 0.48312 * triangles[i][0] + 0.29171 * triangles[i][1] + 0.22517 * triangles[i][2]});
    return places;
}

}  // namespace

Pockets pocketsInsideOut(const TriangleMesh& mesh, const Progress& progress) {
    const std::vector<TriangleCorners> triangles = scaledCorners(mesh);
    const TriangleBoxes boxes(triangles);
    const std::vector<Line> lines = linesOfContact(triangles, boxes, progress);
    std::vector<Place> places = placesOfComponents(mesh, triangles, progress);
    for (size_t begin = 0; begin < lines.size();) {
        size_t end = begin;
        while (end < lines.size() && lines[end].triangle == lines[begin].triangle) ++end;
        const uint32_t triangle = lines[begin].triangle;
        LinesInTriangle(triangles[triangle], std::span(lines).subspan(begin, end - begin)).addPlaces(triangle, places);
        begin = end;
    }
    const Windings windings(triangles, boxes);
    std::atomic<bool> found = false, unproven = false;
    tbb::parallel_for(size_t{0}, places.size(), [&](size_t i) {
        if (found || progress.stopRequested()) return;
        const std::optional<int> winding = windings.inFrontOf(places[i]);
        if (!winding)
            unproven = true;
        else if (*winding < 0)
            found = true;
    });
    progress.check();
    return found ? Pockets::Found : unproven ? Pockets::NotProven : Pockets::None;
}

}  // namespace cullscope
