#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/work_check.h"
#include "core/spatial/cut_triangles.h"

namespace cullscope {

Vec3 CutTriangles::sharesOf(uint32_t triangle, uint32_t vertex) const {
    const uint32_t* corner = &m_ofTriangle[3 * size_t(triangle)];
    const auto whole = [&](uint32_t original) {
        return Vec3(original == corner[0] ? 1.0 : 0.0, original == corner[1] ? 1.0 : 0.0, original == corner[2] ? 1.0 : 0.0);
    };
    if (!isMade(vertex)) return whole(vertex);
    const Made& own = made(vertex);
    if (const Line& line = m_lines[own.line]; line.edge) return whole(line.from) * (1.0 - own.along) + whole(line.to) * own.along;
    return {1.0 - own.shares.x - own.shares.y, own.shares.x, own.shares.y};
}

void CutTriangles::finish(const Progress& progress) {
    WorkCheck work(progress);
    m_lineStarts.assign(m_lines.size() + 1, 0);
    for (const Made& vertex : m_made) {
        work.step();
        ++m_lineStarts[vertex.line + 1];
    }
    std::partial_sum(m_lineStarts.begin(), m_lineStarts.end(), m_lineStarts.begin());
    m_lineVertices.resize(m_made.size());
    std::vector<uint32_t> next(m_lineStarts.begin(), m_lineStarts.end() - 1);
    for (uint32_t i = 0; i < m_made.size(); ++i) {
        work.step();
        m_lineVertices[next[m_made[i].line]++] = m_original + i;
    }
    const auto nearer = work.counting([&](uint32_t a, uint32_t b) { return made(a).along < made(b).along; });
    for (size_t line = 0; line < m_lines.size(); ++line) {
        work.step();
        std::sort(m_lineVertices.begin() + m_lineStarts[line], m_lineVertices.begin() + m_lineStarts[line + 1], nearer);
    }
}

bool CutTriangles::withNeighbours(uint32_t polygon, std::vector<uint32_t>& vertices) const {
    bool more = false;
    const std::span<const Corner> corners = cornersOf(polygon);
    vertices.clear();
    for (size_t i = 0; i < corners.size(); ++i) {
        const uint32_t from = corners[i].vertex, to = corners[(i + 1) % corners.size()].vertex;
        vertices.push_back(from);
        uint32_t line = corners[i].line;
        if (line == kNone) {
            const auto edge = m_edgeLines.find(vertexPair(from, to));
            if (edge == m_edgeLines.end()) continue;
            line = edge->second;
        }
        const double begin = along(line, from), end = along(line, to);
        const size_t known = vertices.size();
        for (uint32_t place = m_lineStarts[line]; place < m_lineStarts[line + 1]; ++place) {
            const double at = made(m_lineVertices[place]).along;
            if (at > std::min(begin, end) && at < std::max(begin, end)) vertices.push_back(m_lineVertices[place]);
        }
        if (begin > end) std::reverse(vertices.begin() + std::ptrdiff_t(known), vertices.end());
        more = more || vertices.size() > known;
    }
    return more;
}

void CutTriangles::drawWhole(uint32_t triangle, OwnTriangles& out) const {
    const size_t instance = m_scene->instanceOf(triangle);
    const TriangleMesh& mesh = m_scene->meshOf(instance);
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t index = mesh.indices()[3 * (triangle - m_scene->firstTriangle(instance)) + i];
        out.positions.push_back(mesh.positions()[index]);
        out.normals.push_back(mesh.normals()[index]);
    }
    out.triangles.push_back(triangle);
}

void CutTriangles::draw(uint32_t polygon, OwnTriangles& out) const {
    const uint32_t triangle = m_polygons[polygon].triangle;
    std::vector<uint32_t> vertices;
    const bool more = withNeighbours(polygon, vertices);
    if (vertices.size() == 3 && std::ranges::none_of(vertices, [&](uint32_t v) { return isMade(v); }))
        return drawWhole(triangle, out);
    const size_t instance = m_scene->instanceOf(triangle);
    const TriangleMesh& mesh = m_scene->meshOf(instance);
    std::array<Vec3, 3> positions, normals;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t index = mesh.indices()[3 * (triangle - m_scene->firstTriangle(instance)) + i];
        positions[i] = Vec3(mesh.positions()[index]);
        normals[i] = Vec3(mesh.normals()[index]);
    }
    struct Drawn {
        Vec3f position, normal;
    };
    const auto drawn = [&](const Vec3& shares) {
        return Drawn{Vec3f(positions[0] * shares.x + positions[1] * shares.y + positions[2] * shares.z),
                     Vec3f(normals[0] * shares.x + normals[1] * shares.y + normals[2] * shares.z)};
    };
    std::vector<Drawn> corners;
    Vec3 middle(0.0);
    for (const uint32_t vertex : vertices) {
        const Vec3 shares = sharesOf(triangle, vertex);
        middle += shares;
        corners.push_back(drawn(shares));
    }
    const auto add = [&](const Drawn& a, const Drawn& b, const Drawn& c) {
        for (const Drawn* corner : {&a, &b, &c}) {
            out.positions.push_back(corner->position);
            out.normals.push_back(corner->normal);
        }
        out.triangles.push_back(triangle);
    };
    if (!more) {
        for (size_t i = 2; i < corners.size(); ++i) add(corners[0], corners[i - 1], corners[i]);
        return;
    }
    // Several corners on one edge: from the middle no triangle is without area.
    const Drawn centre = drawn(middle / double(vertices.size()));
    for (size_t i = 0; i < corners.size(); ++i) add(centre, corners[i], corners[(i + 1) % corners.size()]);
}

double CutTriangles::share(uint32_t polygon) const {
    const std::span<const Corner> corners = cornersOf(polygon);
    const uint32_t triangle = m_polygons[polygon].triangle;
    const auto flatShares = [&](size_t i) {
        const Vec3 shares = sharesOf(triangle, corners[i % corners.size()].vertex);
        return Vec2(shares.y, shares.z);
    };
    double doubled = 0.0;
    const Vec2 first = flatShares(0);
    for (size_t i = 2; i < corners.size(); ++i) {
        const Vec2 a = flatShares(i - 1) - first, b = flatShares(i) - first;
        doubled += a.x * b.y - a.y * b.x;
    }
    return doubled;
}

uint64_t CutTriangles::bytes() const {
    return (m_positions.size() + m_rounding.size()) * sizeof(Vec3) + m_sides.size() + m_ofTriangle.size() * 4 +
           m_made.size() * (sizeof(Made) + 4) + m_lines.size() * (sizeof(Line) + 4) + m_polygons.size() * sizeof(Polygon) +
           m_corners.size() * sizeof(Corner);
}

}  // namespace cullscope
