#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/frame/commands.h"
#include "core/scene/scene.h"

namespace cullscope {

/// A plane that cuts, by three of its points: which side a point lies on is decided exactly (geometry/predicates.h). One that a
/// scene gives is kept as its numbers were written: see `sideOf`.
struct CuttingPlane {
    Vec3 a{0.0}, b{0.0}, c{0.0};  ///< from the front they turn counter-clockwise
    Vec3 normal{0.0};             ///< unit length, to the front
    uint32_t id = 0;              ///< that of the triangle that it goes through, or another number that is used only once
    Vec4 given{0.0};              ///< a, b, c, d of ax + by + cz + d = 0, of any length, positive in front; 0: not given so

    [[nodiscard]] bool isGiven() const { return given != Vec4(0.0); }

    /// Signed distance, positive in front; rounded.
    [[nodiscard]] double distance(const Vec3& point) const { return glm::dot(normal, point - a); }
};
/// The points are not on one line.
[[nodiscard]] CuttingPlane planeThrough(const Vec3& a, const Vec3& b, const Vec3& c, uint32_t id);
/// The plane { p : normal·p + offset = 0 }; the normal is not 0.
[[nodiscard]] CuttingPlane givenPlane(const Vec3& normal, double offset, uint32_t id);
/// 1: a point lies in front of a plane, −1: behind it, 0: in it. Of a plane through points this is exact for the doubles as they
/// are. In a given plane a point lies, too, that may lie there as its numbers and the plane's were written: where its distance is
/// not more than what reading them as doubles, and a rounding of the point's coordinates by `rounding`, can make of 0.
[[nodiscard]] int sideOf(const CuttingPlane& plane, const Vec3& point, const Vec3& rounding = Vec3(0.0));

/// The triangles of a scene in world coordinates (double), as convex polygons that planes cut into smaller ones. A corner that a
/// plane made is remembered as lying on that plane and between the ends of the edge that it cut: rounding never puts it on the
/// wrong side of a plane that both ends lie on or on the same side of. Corners at the same place are one.
class CutTriangles {
public:
    static constexpr uint32_t kNone = 0xFFFFFFFF;

    struct Corner {
        uint32_t vertex = 0;
        uint32_t line =
            kNone;  ///< on which the edge to the next corner lies; kNone: an edge of the triangle that nothing cut yet
    };
    struct Polygon {
        uint32_t triangle = 0;  ///< scene triangle number
        uint32_t first = 0, count = 0;
    };
    enum class Place { Front, Back, On, Across };

    /// Throws Error(Interrupted) on a stop request.
    explicit CutTriangles(const Scene& scene, const Progress& progress = {});

    /// The first ones are those of whole triangles that have an area.
    [[nodiscard]] const std::vector<Polygon>& polygons() const { return m_polygons; }
    /// Triangles without area: they cover nothing and have no plane.
    [[nodiscard]] const std::vector<uint32_t>& flat() const { return m_flat; }
    [[nodiscard]] std::span<const Corner> cornersOf(uint32_t polygon) const {
        return std::span(m_corners).subspan(m_polygons[polygon].first, m_polygons[polygon].count);
    }
    [[nodiscard]] const Vec3& position(uint32_t vertex) const { return m_positions[vertex]; }
    [[nodiscard]] size_t vertexCount() const { return m_positions.size(); }
    [[nodiscard]] CuttingPlane planeOf(uint32_t triangle) const;
    [[nodiscard]] uint64_t cuts() const { return m_cuts; }

    /// 1: in front of the plane, −1: behind it, 0: in it.
    [[nodiscard]] int side(uint32_t vertex, const CuttingPlane& plane) const { return sideWithin(vertex, plane, 0); }
    /// Where a polygon lies. Sides are kept as long as the plane stays the same.
    [[nodiscard]] Place place(uint32_t polygon, const CuttingPlane& plane);
    /// Cuts a polygon that lies Across: the parts in front and behind are appended, and it must not be used any more.
    std::pair<uint32_t, uint32_t> cut(uint32_t polygon, const CuttingPlane& plane);

    /// To be called when nothing more is cut, before `draw`. Throws Error(Interrupted) on a stop request.
    void finish(const Progress& progress = {});
    /// Appends a polygon as triangles. An uncut triangle is appended as the scene has it. Corners that other parts of the
    /// scene's surface have on its edges are corners of it, too, so that no gap shows between them.
    void draw(uint32_t polygon, OwnTriangles& out) const;
    /// Appends a triangle as the scene has it.
    void drawWhole(uint32_t triangle, OwnTriangles& out) const;
    /// The share of its triangle's area.
    [[nodiscard]] double share(uint32_t polygon) const;
    [[nodiscard]] uint64_t bytes() const;

private:
    /// Where vertices that were made lie: an edge of triangles, or a cut through one triangle.
    struct Line {
        uint32_t from = 0, to = 0;
        bool edge = false;
    };
    struct Made {
        uint32_t line = kNone;
        uint32_t plane = kNone;
        double along = 0.0;  ///< from 0 at the line's begin to 1 at its end
        Vec2 shares{0.0};    ///< of the second and third corner of the triangle; unused where the line is an edge
    };

    [[nodiscard]] static uint64_t vertexPair(uint32_t a, uint32_t b) { return uint64_t(std::min(a, b)) << 32 | std::max(a, b); }
    void addCorners(const Scene& scene, const Progress& progress);
    [[nodiscard]] Vec3 roundingOf(uint32_t vertex) const { return m_rounding.empty() ? Vec3(0.0) : m_rounding[vertex]; }
    [[nodiscard]] int sideWithin(uint32_t vertex, const CuttingPlane& plane, int depth) const;
    [[nodiscard]] bool liesInPlane(uint32_t triangle, const CuttingPlane& plane) const;
    [[nodiscard]] int knownSide(uint32_t vertex, const CuttingPlane& plane);
    [[nodiscard]] bool isMade(uint32_t vertex) const { return vertex >= m_original; }
    [[nodiscard]] const Made& made(uint32_t vertex) const { return m_made[vertex - m_original]; }
    [[nodiscard]] double along(uint32_t line, uint32_t vertex) const;
    [[nodiscard]] uint32_t edgeLine(uint32_t from, uint32_t to);
    uint32_t vertexOn(uint32_t triangle, Corner& from, uint32_t to, const CuttingPlane& plane);
    /// The shares of a triangle's three corners in a vertex of one of its polygons.
    [[nodiscard]] Vec3 sharesOf(uint32_t triangle, uint32_t vertex) const;
    [[nodiscard]] bool withNeighbours(uint32_t polygon, std::vector<uint32_t>& vertices) const;

    const Scene* m_scene;
    std::vector<Vec3> m_positions;
    std::vector<Vec3> m_rounding;        ///< by how much coordinates may differ from those written; only of scenes with planes
    uint32_t m_original = 0;             ///< the vertices before were not made by a plane
    std::vector<uint32_t> m_ofTriangle;  ///< three vertices for each scene triangle
    std::vector<Made> m_made;
    std::vector<Line> m_lines;
    std::unordered_map<uint64_t, uint32_t> m_edgeLines;  ///< by the two original vertices
    std::vector<Polygon> m_polygons;
    std::vector<Corner> m_corners;
    std::vector<uint32_t> m_flat;
    uint64_t m_cuts = 0;
    // Of the current plane.
    uint32_t m_plane = kNone;
    std::vector<int8_t> m_sides;                                  ///< by vertex; 2: not known
    std::vector<uint32_t> m_knownSides;                           ///< vertices whose sides are known
    std::map<std::pair<uint32_t, uint64_t>, uint32_t> m_madeNow;  ///< by line and ends of an edge
    // After `finish`: the vertices of each line, in their order along it.
    std::vector<uint32_t> m_lineStarts, m_lineVertices;
};

}  // namespace cullscope
