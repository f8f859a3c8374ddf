#include "core/spatial/hiding_sheets.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"

namespace cullscope {
namespace {

/// Of the scene's diagonal: how far a sheet stays from the box from which is looked.
constexpr double kReach = 0x1p-9;
/// Of the squared distance over the scene's diagonal: how far a sheet stays before what it hides. So inverse distances differ by
/// at least this over the diagonal; one half is for the rounding of depths, the other one for triangles that are seen nearly
/// edge-on.
constexpr double kDepthRoom = 0x1p-6;
/// Of the distance: by how much corners are moved sideways. Both surfaces may be moved by 1/64 of the coarsest pixel; Mesa and
/// today's hardware snap to 1/256, and move corners by half of that along both axes.
constexpr double kSidewaysRoom = SightRoom::kPixel / 32.0;
/// How far a sample may lie outside of the triangle that covers it once its corners are snapped, at distance 1.
constexpr double kOutside = SightRoom::kPixel / 256.0;
constexpr size_t kMostTriangles = 512;  // of a sheet
constexpr int kMostSeeds = 4;           // surfaces along a line of sight that are tried

Box3 grown(const Box3& box, double by) { return {box.min - Vec3(by), box.max + Vec3(by)}; }

/// Whether a triangle may touch a box: false only where a side of the box or the triangle's plane parts them.
bool mayTouch(const std::array<Vec3, 3>& corners, const Box3& box) {
    const Vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    const Vec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    if (glm::any(glm::lessThan(high, box.min)) || glm::any(glm::greaterThan(low, box.max))) return false;
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double distance = glm::dot(normal, box.centre() - corners[0]);
    const double reach = glm::dot(glm::abs(normal), box.halfExtent());
    // The rounding of the products, and of the world coordinates in them.
    const double magnitude = glm::length(box.centre()) + glm::length(box.halfExtent()) + glm::length(corners[0]);
    const double room = glm::length(normal) * magnitude * 0x1p-44;
    return std::abs(distance) <= reach + room;
}

/// Whether a segment passes through a triangle: 1, or 0; −1 where it passes through an edge, or an end lies in the plane.
int crosses(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& corners) {
    const int begin = sideOfPlane(corners[0], corners[1], corners[2], from);
    const int end = sideOfPlane(corners[0], corners[1], corners[2], to);
    if (begin == 0 || end == 0) return -1;
    if (begin == end) return 0;
    std::array<int, 3> sides{};
    for (size_t i = 0; i < 3; ++i) sides[i] = sideOfPlane(from, to, corners[i], corners[(i + 1) % 3]);
    const bool positive = sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0;
    const bool negative = sides[0] <= 0 && sides[1] <= 0 && sides[2] <= 0;
    if (!positive && !negative) return 0;
    return sides[0] != 0 && sides[1] != 0 && sides[2] != 0 ? 1 : -1;
}

/// Whether the depths that a picture gives a triangle, where it covers a sample, are its own within half of the depth room, seen
/// from anywhere in a box; false also where its plane may cut the box. `side`: on which side of the plane the box lies.
bool depthsAreItsOwn(const std::array<Vec3, 3>& corners, const Box3& from, double diagonal, int& side) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double twiceArea = glm::length(normal), half = glm::length(from.halfExtent());
    if (!(twiceArea > 0.0)) return false;
    double longest = 0.0, farthest = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        longest = std::max(longest, glm::length(corners[(i + 1) % 3] - corners[i]));
        farthest = std::max(farthest, glm::length(corners[i] - from.centre()) + half);
    }
    const double middle = glm::dot(normal, from.centre() - corners[0]) / twiceArea;
    const double reach = glm::dot(glm::abs(normal), from.halfExtent()) / twiceArea;
    // The rounding of the normal of a thin triangle turns it.
    const double rounding =
        0x1p-44 * (glm::length(from.centre()) + half + glm::length(corners[0])) * (1.0 + longest * longest / twiceArea);
    const double height = std::abs(middle) - reach - rounding;  // of the eye above the plane, at least
    if (!(height > 0.0)) return false;
    side = middle > 0.0 ? 1 : -1;
    // With the plane's unit normal n the inverse distance in the direction (x, y, 1) is n · (x, y, 1) / height: a step beside the
    // triangle changes it by at most that step over the height. Rounding acts as such a step does, of at most 2^-25 · length^3 /
    // area in the picture, where the area is at least height · area / distance^3.
    const Vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    const Vec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    const Vec3 gap = glm::max(glm::max(low - from.max, from.min - high), Vec3(0.0));
    const double length = std::min(longest / std::max(height, glm::length(gap)), 4.0);
    const double area = height * 0.5 * twiceArea / (farthest * farthest * farthest);
    const double beside = kOutside + 0x1p-25 * length * length * length / area;
    return beside / height <= 0.5 * kDepthRoom / diagonal;
}

double widest(const Box3& box) {
    const Vec3 size = box.max - box.min;
    return std::max({size.x, size.y, size.z});
}

std::array<Box3, 2> halves(const Box3& box) {
    const Vec3 size = box.max - box.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::array<Box3, 2> parts{box, box};
    parts[0].max[axis] = parts[1].min[axis] = box.centre()[axis];
    return parts;
}

}  // namespace

SightRoom::SightRoom(const Scene& scene)
    : reach(scene.bounds().diagonal() * kReach), nearest(scene.bounds().diagonal() * 0x1p-21 / (kDepthRoom / 2.0)) {}

bool SightRoom::holds(const View& view) const {
    const Frustum& frustum = view.frustum();
    const double slant =
        std::sqrt(1.0 + frustum.tanHalfWidth * frustum.tanHalfWidth + frustum.tanHalfHeight * frustum.tanHalfHeight);
    return !frustum.parallel() && frustum.nearDistance >= nearest && frustum.nearDistance * slant < reach * (1.0 - 0x1p-10) &&
           2.0 * frustum.tanHalfHeight / view.viewport().height <= kPixel;
}

/// Two boxes with the room of the proof about them.
struct HidingSheets::Pair {
    Box3 near;   ///< no sheet touches it: what is looked from, with what a near plane may cut off
    Box3 clear;  ///< no sheet touches it: what is looked at, with the error of depths
    Shaft shaft;
    Vec3 from, to;  ///< a line of sight
};

HidingSheets::HidingSheets(const Scene& scene, const WeldedTriangles& triangles, const SceneRays& rays)
    : m_scene(scene), m_triangles(triangles), m_rays(rays), m_room(scene), m_diagonal(scene.bounds().diagonal()) {
    const Box3& bounds = scene.bounds();
    m_rounding = glm::length(glm::max(glm::abs(bounds.min), glm::abs(bounds.max))) * 0x1p-44;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        m_dropsBacks.push_back(scene.frontFacesSuffice(i));
        if (scene.meshOf(i).triangleCount() > 0)
            m_rounding = std::max(m_rounding, 2.0 * scene.pictureRounding(scene.instances()[i]));
    }
}

bool HidingSheets::hides(const Box3& from, const Box3& box, int halvings, Work& work) const {
    bool blocked = false;
    if (hiddenByOneSheet(from, box, work, blocked)) return true;
    if (halvings == 0 || !blocked) return false;
    if (widest(from) > widest(box)) {
        const std::array<Box3, 2> parts = halves(from);
        return hides(parts[0], box, halvings - 1, work) && hides(parts[1], box, halvings - 1, work);
    }
    const std::array<Box3, 2> parts = halves(box);
    return hides(from, parts[0], halvings - 1, work) && hides(from, parts[1], halvings - 1, work);
}

bool HidingSheets::hiddenByOneSheet(const Box3& from, const Box3& box, Work& work, bool& blocked) const {
    Box3 both = from;
    both.add(box);
    const double distance = both.diagonal();
    // Meshes about their own origin have coordinates that are rounded by parts of their size.
    const double sideways = distance * (kSidewaysRoom + 0x1p-19) + m_diagonal * 0x1p-20 + m_rounding;
    const Box3 seen = grown(box, sideways);
    const double depths = kDepthRoom * distance * distance / m_diagonal;
    // Not the centres: lines through these meet the edges of many models.
    const auto inside = [](const Box3& of, double x, double y, double z) { return of.min + (of.max - of.min) * Vec3(x, y, z); };
    const Pair pair{grown(from, m_room.reach + m_rounding), grown(seen, depths), Shaft(grown(from, m_rounding), seen),
                    inside(from, 0.4861, 0.5273, 0.5119), inside(box, 0.5231, 0.4877, 0.5097)};
    const Vec3 line = pair.to - pair.from;
    double begin = 0.0;
    for (int i = 0; i < kMostSeeds; ++i) {
        const std::optional<SceneRays::Hit> hit = m_rays.first(pair.from, line, begin, 1.0);
        if (!hit) return false;
        blocked = true;
        begin = hit->distance * (1.0 + 1e-6) + 1e-7;
        const uint32_t seed = m_triangles.numberOf(m_scene.firstTriangle(hit->instance) + hit->triangle);
        if (seed != WeldedTriangles::kNone && sheetThrough(seed, pair, work) && crossedOdd(pair, work)) return true;
    }
    return false;
}

/// The sheet grows from a triangle over its edges in the shaft until no border is left in it.
bool HidingSheets::sheetThrough(uint32_t seed, const Pair& pair, Work& work) const {
    if (work.inSheet.empty() || work.search == UINT32_MAX) {
        work.inSheet.assign(m_triangles.triangles().size(), 0);
        work.odd.assign(m_triangles.edgeCount(), 0);
        work.search = 0;
    }
    ++work.search;
    work.sheet.clear();
    work.open.clear();
    if (!usable(seed, pair) || !add(seed, pair, work)) return false;
    while (!work.open.empty()) {
        const uint32_t edge = work.open.back();
        work.open.pop_back();
        if (work.odd[edge] == work.search && !close(edge, pair, work)) return false;
    }
    return true;
}

bool HidingSheets::usable(uint32_t triangle, const Pair& pair) const {
    const WeldedTriangles::Triangle& of = m_triangles.triangles()[triangle];
    const std::array<Vec3, 3> corners = m_triangles.corners(of);
    if (mayTouch(corners, pair.near) || mayTouch(corners, pair.clear)) return false;
    int side = 0;
    return depthsAreItsOwn(corners, pair.near, m_diagonal, side) && (side > 0 || !m_dropsBacks[of.instance]);
}

bool HidingSheets::add(uint32_t triangle, const Pair& pair, Work& work) const {
    if (work.sheet.size() == kMostTriangles) return false;
    work.inSheet[triangle] = work.search;
    work.sheet.push_back(triangle);
    for (const uint32_t edge : m_triangles.triangles()[triangle].edges) {
        const auto& [a, b] = m_triangles.edge(edge);
        if (work.odd[edge] == work.search) {
            work.odd[edge] = 0;
        } else if (pair.shaft.mayMeet(m_triangles.vertex(a), m_triangles.vertex(b))) {
            work.odd[edge] = work.search;
            work.open.push_back(edge);
        }
    }
    return true;
}

/// Adds the triangle at the edge that continues the sheet straightest.
bool HidingSheets::close(uint32_t edge, const Pair& pair, Work& work) const {
    const uint32_t a = m_triangles.edge(edge)[0], b = m_triangles.edge(edge)[1];
    const Vec3& begin = m_triangles.vertex(a);
    const Vec3 along = m_triangles.vertex(b) - begin;
    const auto away = [&](uint32_t triangle) {
        for (const uint32_t vertex : m_triangles.triangles()[triangle].vertices) {
            if (vertex == a || vertex == b) continue;
            const Vec3 to = m_triangles.vertex(vertex) - begin;
            return glm::normalize(to - along * (glm::dot(to, along) / glm::dot(along, along)));
        }
        return Vec3(0.0);
    };
    Vec3 known(0.0);
    for (const uint32_t triangle : m_triangles.at(edge))
        if (work.inSheet[triangle] == work.search) known = away(triangle);
    uint32_t best = WeldedTriangles::kNone;
    double straightest = 2.0;
    for (const uint32_t triangle : m_triangles.at(edge)) {
        if (work.inSheet[triangle] == work.search || !usable(triangle, pair)) continue;
        const double bend = glm::dot(known, away(triangle));
        if (best != WeldedTriangles::kNone && !(bend < straightest)) continue;
        best = triangle;
        straightest = bend;
    }
    return best != WeldedTriangles::kNone && add(best, pair, work);
}

bool HidingSheets::crossedOdd(const Pair& pair, const Work& work) const {
    size_t crossings = 0;
    for (const uint32_t triangle : work.sheet) {
        const int crossed = crosses(pair.from, pair.to, m_triangles.corners(m_triangles.triangles()[triangle]));
        if (crossed < 0) return false;
        crossings += size_t(crossed);
    }
    return crossings % 2 == 1;
}

}  // namespace cullscope
