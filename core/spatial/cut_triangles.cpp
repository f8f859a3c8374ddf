#include "core/spatial/cut_triangles.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/base/work_check.h"
#include "core/geometry/predicates.h"

namespace cullscope {
namespace {

constexpr int8_t kUnknownSide = 2;
/// A vertex between two others is followed to their sides, and those to theirs, so many times; then it is taken where it was
/// rounded to. Each time doubles the work.
constexpr int kMostFollowed = 6;
/// Two numbers that are read as doubles, their product and its sum with others: seven roundings at most, each of 2^-53.
constexpr double kReading = 0x1p-50;
/// A coordinate is kept as a float, from the middle of its mesh: so large a part of it may be rounded away.
constexpr double kAsFloat = 0x1.01p-24;

/// Places, each with a number: one table that is made and freed at once, so that no million entries of their own hold up the end
/// of work that is stopped.
class KnownPlaces {
public:
    /// For at most so many.
    explicit KnownPlaces(size_t most) : m_bits(std::bit_width(2 * most + 1)), m_numbers(size_t{1} << m_bits, kNone) {}

    /// The place's number in `places`, to which a new one is added.
    uint32_t numberOf(const Vec3& place, std::vector<Vec3>& places) {
        const size_t last = m_numbers.size() - 1;
        size_t slot = hash(place) >> (64 - m_bits);
        while (m_numbers[slot] != kNone && places[m_numbers[slot]] != place) slot = (slot + 1) & last;
        if (m_numbers[slot] == kNone) {
            m_numbers[slot] = uint32_t(places.size());
            places.push_back(place);
        }
        return m_numbers[slot];
    }

private:
    static constexpr uint32_t kNone = UINT32_MAX;

    static uint64_t hash(const Vec3& place) {
        uint64_t hash = 0;
        // 0 is added because −0 equals 0.
        for (int axis = 0; axis < 3; ++axis)
            hash = (hash ^ std::bit_cast<uint64_t>(place[axis] + 0.0)) * 0x9E3779B97F4A7C15ull ^ hash >> 29;
        return hash * 0x9E3779B97F4A7C15ull;
    }

    int m_bits;
    std::vector<uint32_t> m_numbers;
};

/// Of the sides around a polygon that change twice: a corner in the plane that is no end of the cut, because the polygon only
/// touches the plane there, counts to the side of its neighbours.
void keepTwoEnds(std::vector<int>& sides) {
    const size_t count = sides.size();
    size_t start = 0;
    while (sides[start] == 0) ++start;
    int before = sides[start];
    for (size_t i = 1; i < count; ++i) {
        int& side = sides[(start + i) % count];
        if (side == 0) {
            size_t next = i + 1;
            while (sides[(start + next) % count] == 0) ++next;
            const int after = sides[(start + next) % count];
            if (after == before) side = before;
            before = after;  // of several in the plane the first one is the end
        } else {
            before = side;
        }
    }
}

bool finitePlace(const Vec3& place) { return std::isfinite(place.x + place.y + place.z); }

}  // namespace

CuttingPlane planeThrough(const Vec3& a, const Vec3& b, const Vec3& c, uint32_t id) {
    // Scaled by the largest difference, so that nothing over- or underflows.
    const Vec3 u = b - a, v = c - a;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(u[axis]), std::abs(v[axis])});
    const double scale = largest > 0.0 ? 1.0 / largest : 1.0;
    const Vec3 normal = glm::cross(u * scale, v * scale);
    const double length = glm::length(normal);
    return {a, b, c, length > 0.0 ? normal / length : Vec3(0.0, 0.0, 1.0), id};
}

CuttingPlane givenPlane(const Vec3& normal, double offset, uint32_t id) {
    const Vec3 away = glm::abs(normal);
    // The axis along which the plane is steepest is solved for; the other two coordinates are 0 or 1.
    const int axis = away.x >= away.y && away.x >= away.z ? 0 : away.y >= away.z ? 1 : 2;
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    const auto point = [&](double y, double z) {
        Vec3 result(0.0);
        result[second] = y;
        result[third] = z;
        result[axis] = -(offset + normal[second] * y + normal[third] * z) / normal[axis];
        return result;
    };
    const Vec3 a = point(0.0, 0.0), b = point(1.0, 0.0), c = point(0.0, 1.0);
    CuttingPlane plane = normal[axis] > 0.0 ? planeThrough(a, b, c, id) : planeThrough(a, c, b, id);
    plane.given = Vec4(normal, offset);
    return plane;
}

int sideOf(const CuttingPlane& plane, const Vec3& point, const Vec3& rounding) {
    if (!plane.isGiven()) return sideOfPlane(plane.a, plane.b, plane.c, point);
    double value = plane.given.w, written = std::abs(plane.given.w) * kReading;
    for (int axis = 0; axis < 3; ++axis) {
        value += plane.given[axis] * point[axis];
        written += std::abs(plane.given[axis]) * (rounding[axis] + std::abs(point[axis]) * kReading);
    }
    return value > written ? 1 : value < -written ? -1 : 0;
}

CutTriangles::CutTriangles(const Scene& scene, const Progress& progress) : m_scene(&scene) {
    addCorners(scene, progress);
    m_original = uint32_t(m_positions.size());
    m_sides.assign(m_positions.size(), kUnknownSide);
    WorkCheck work(progress);
    for (uint32_t triangle = 0; 3 * size_t(triangle) < m_ofTriangle.size(); ++triangle) {
        work.step();
        const uint32_t* corner = &m_ofTriangle[3 * size_t(triangle)];
        const Vec3 &a = m_positions[corner[0]], &b = m_positions[corner[1]], &c = m_positions[corner[2]];
        if (!finitePlace(a) || !finitePlace(b) || !finitePlace(c) || onOneLine(a, b, c)) {
            m_flat.push_back(triangle);
            continue;
        }
        m_polygons.push_back({triangle, uint32_t(m_corners.size()), 3});
        for (int i = 0; i < 3; ++i) m_corners.push_back({corner[i], kNone});
    }
}

void CutTriangles::addCorners(const Scene& scene, const Progress& progress) {
    WorkCheck work(progress);
    size_t vertices = 0;
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) vertices += scene.meshOf(instance).vertexCount();
    KnownPlaces known(vertices);
    m_ofTriangle.reserve(3 * scene.triangleCount());
    std::vector<uint32_t> numbers;
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) {
        const TriangleMesh& mesh = scene.meshOf(instance);
        if (mesh.triangleCount() == 0) continue;
        const Mat4& place = scene.instances()[instance].worldFromMesh;
        numbers.assign(mesh.vertexCount(), 0);
        const Mat3 turn(place);
        for (size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
            work.step();
            const Vec3 world(place * Vec4(mesh.position(vertex), 1.0));
            const uint32_t number = known.numberOf(world, m_positions);
            numbers[vertex] = number;
            if (scene.planes().empty()) continue;
            m_rounding.resize(m_positions.size(), Vec3(0.0));
            const Vec3 kept = glm::abs(mesh.position(vertex) - mesh.origin()) * kAsFloat;
            Vec3 rounding(0.0);
            for (int axis = 0; axis < 3; ++axis) rounding += glm::abs(turn[axis]) * kept[axis];
            m_rounding[number] = glm::max(m_rounding[number], rounding);
        }
        for (const uint32_t index : mesh.indices()) {
            work.step();
            m_ofTriangle.push_back(numbers[index]);
        }
    }
}

CuttingPlane CutTriangles::planeOf(uint32_t triangle) const {
    const uint32_t* corner = &m_ofTriangle[3 * size_t(triangle)];
    return planeThrough(m_positions[corner[0]], m_positions[corner[1]], m_positions[corner[2]], triangle);
}

int CutTriangles::sideWithin(uint32_t vertex, const CuttingPlane& plane, int depth) const {
    const Vec3& place = m_positions[vertex];
    if (!isMade(vertex)) return sideOf(plane, place, roundingOf(vertex));
    const Made& own = made(vertex);
    if (own.plane == plane.id) return 0;
    const int clear =
        plane.isGiven() ? sideOf(plane, place, roundingOf(vertex)) : clearSideOfPlane(plane.a, plane.b, plane.c, place);
    if (clear != 0) return clear;
    if (depth < kMostFollowed) {
        const Line& line = m_lines[own.line];
        const int from = sideWithin(line.from, plane, depth + 1), to = sideWithin(line.to, plane, depth + 1);
        if (from * to >= 0) return from != 0 ? from : to;
    }
    if (liesInPlane(own.plane, plane)) return 0;
    return sideOf(plane, place, roundingOf(vertex));
}

bool CutTriangles::liesInPlane(uint32_t triangle, const CuttingPlane& plane) const {
    if (3 * size_t(triangle) >= m_ofTriangle.size()) return false;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t vertex = m_ofTriangle[3 * size_t(triangle) + i];
        if (sideOf(plane, m_positions[vertex], roundingOf(vertex)) != 0) return false;
    }
    return true;
}

int CutTriangles::knownSide(uint32_t vertex, const CuttingPlane& plane) {
    if (m_plane != plane.id) {
        for (const uint32_t known : m_knownSides) m_sides[known] = kUnknownSide;
        m_knownSides.clear();
        m_madeNow.clear();
        m_plane = plane.id;
    }
    int8_t& known = m_sides[vertex];
    if (known == kUnknownSide) {
        known = int8_t(side(vertex, plane));
        m_knownSides.push_back(vertex);
    }
    return known;
}

CutTriangles::Place CutTriangles::place(uint32_t polygon, const CuttingPlane& plane) {
    int front = 0, back = 0, changes = 0, first = 0, last = 0;
    double nearest = 0.0, farthest = 0.0;
    for (const Corner& corner : cornersOf(polygon)) {
        const int side = knownSide(corner.vertex, plane);
        if (side == 0) continue;
        ++(side > 0 ? front : back);
        if (first == 0) first = side;
        if (last != 0 && side != last) ++changes;
        last = side;
        const double distance = plane.distance(m_positions[corner.vertex]);
        nearest = std::max(nearest, distance);
        farthest = std::min(farthest, distance);
    }
    if (front == 0 && back == 0) return Place::On;
    if (back == 0) return Place::Front;
    if (front == 0) return Place::Back;
    if (last != first) ++changes;
    if (changes == 2) return Place::Across;
    // Rounded corners of a polygon that lies nearly in the plane: it stays whole, on the side where most of it is.
    return nearest >= -farthest ? Place::Front : Place::Back;
}

double CutTriangles::along(uint32_t line, uint32_t vertex) const {
    if (m_lines[line].from == vertex) return 0.0;
    if (m_lines[line].to == vertex) return 1.0;
    assert(isMade(vertex) && made(vertex).line == line);
    return made(vertex).along;
}

uint32_t CutTriangles::edgeLine(uint32_t from, uint32_t to) {
    const auto [entry, isNew] = m_edgeLines.try_emplace(vertexPair(from, to), uint32_t(m_lines.size()));
    if (isNew) m_lines.push_back({std::min(from, to), std::max(from, to), true});
    return entry->second;
}

uint32_t CutTriangles::vertexOn(uint32_t triangle, Corner& from, uint32_t to, const CuttingPlane& plane) {
    if (from.line == kNone) from.line = edgeLine(from.vertex, to);
    // Two polygons in one place have edges with the same ends on lines of their own.
    const std::pair edge(from.line, vertexPair(from.vertex, to));
    if (const auto known = m_madeNow.find(edge); known != m_madeNow.end()) return known->second;
    const Line line = m_lines[from.line];
    const double begin = along(from.line, from.vertex), end = along(from.line, to);
    const auto between = [&](double value) { return value > std::min(begin, end) && value < std::max(begin, end); };
    // From the ends of the whole line, so that no error adds up; where these do not tell, from the edge's own.
    const auto meeting = [&](uint32_t first, uint32_t second) {
        const double one = plane.distance(m_positions[first]), other = plane.distance(m_positions[second]);
        return one / (one - other);
    };
    double at = meeting(line.from, line.to);
    if (!between(at)) at = begin + (end - begin) * meeting(from.vertex, to);
    // The exact sides differ, but one distance is only rounding: the plane passes beside that end.
    if (!between(at)) {
        const bool atBegin = std::abs(plane.distance(m_positions[from.vertex])) <= std::abs(plane.distance(m_positions[to]));
        at = atBegin ? begin + (end - begin) * 0x1p-40 : end + (begin - end) * 0x1p-40;
    }
    const auto vertex = uint32_t(m_positions.size());
    Made result{from.line, plane.id, at, Vec2(0.0)};
    if (!line.edge) {
        const Vec3 shares = sharesOf(triangle, line.from) * (1.0 - at) + sharesOf(triangle, line.to) * at;
        result.shares = {shares.y, shares.z};
    }
    m_positions.push_back(m_positions[line.from] + (m_positions[line.to] - m_positions[line.from]) * at);
    if (!m_rounding.empty()) m_rounding.push_back(glm::max(m_rounding[line.from], m_rounding[line.to]));
    m_made.push_back(result);
    m_sides.push_back(0);
    m_knownSides.push_back(vertex);
    m_madeNow.emplace(edge, vertex);
    return vertex;
}

std::pair<uint32_t, uint32_t> CutTriangles::cut(uint32_t number, const CuttingPlane& plane) {
    const Polygon polygon = m_polygons[number];
    std::vector<Corner> corners(cornersOf(number).begin(), cornersOf(number).end());
    std::vector<int> sides;
    for (const Corner& corner : corners) sides.push_back(knownSide(corner.vertex, plane));
    keepTwoEnds(sides);
    std::vector<uint32_t> meets(corners.size(), kNone);
    for (size_t i = 0; i < corners.size(); ++i) {
        const size_t next = (i + 1) % corners.size();
        if (sides[i] * sides[next] < 0) meets[i] = vertexOn(polygon.triangle, corners[i], corners[next].vertex, plane);
    }
    const auto cutLine = uint32_t(m_lines.size());
    std::vector<Corner> front, back;
    std::vector<uint32_t> ends;
    for (size_t i = 0; i < corners.size(); ++i) {
        const int next = sides[(i + 1) % corners.size()];
        const Corner own = corners[i];
        if (sides[i] == 0) {
            ends.push_back(own.vertex);
            front.push_back({own.vertex, next < 0 ? cutLine : own.line});
            back.push_back({own.vertex, next > 0 ? cutLine : own.line});
            continue;
        }
        (sides[i] > 0 ? front : back).push_back(own);
        if (meets[i] == kNone) continue;
        ends.push_back(meets[i]);
        (sides[i] > 0 ? front : back).push_back({meets[i], cutLine});
        (sides[i] > 0 ? back : front).push_back({meets[i], own.line});
    }
    assert(ends.size() >= 2);
    m_lines.push_back({ends.front(), ends.back(), false});
    const auto add = [&](const std::vector<Corner>& part) {
        m_polygons.push_back({polygon.triangle, uint32_t(m_corners.size()), uint32_t(part.size())});
        m_corners.insert(m_corners.end(), part.begin(), part.end());
        return uint32_t(m_polygons.size() - 1);
    };
    ++m_cuts;
    const uint32_t before = add(front);
    return {before, add(back)};
}

}  // namespace cullscope
