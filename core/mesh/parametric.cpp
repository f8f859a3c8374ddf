#include "core/mesh/parametric.h"

#include <cmath>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/geometry/random.h"

namespace cullscope {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

void checkCount(size_t triangles, size_t least) {
    if (triangles < least || triangles > (size_t{1} << 31))
        throwUsage(CULLSCOPE_TR("This shape takes between %1 and %2 triangles, not %3."),
                   {std::to_string(least), std::to_string(size_t{1} << 31), std::to_string(triangles)});
}

/// A closed grid of u × v quads on a surface that is periodic in both directions.
template <typename Surface>
MeshPointer periodicGrid(const char* name, size_t triangles, double aspect, const Surface& surface) {
    checkCount(triangles, 18);
    const auto across = static_cast<uint32_t>(std::max(3.0, std::round(std::sqrt(double(triangles) / 2.0 / aspect))));
    const auto along = static_cast<uint32_t>(std::max(3.0, std::round(double(triangles) / 2.0 / across)));
    TriangleMesh::Data data;
    data.name = name;
    for (uint32_t u = 0; u < along; ++u)
        for (uint32_t v = 0; v < across; ++v) {
            const auto [position, normal] = surface(kTau * u / along, kTau * v / across);
            data.positions.emplace_back(position);
            data.normals.emplace_back(glm::normalize(normal));
        }
    const auto vertex = [&](uint32_t u, uint32_t v) { return (u % along) * across + v % across; };
    for (uint32_t u = 0; u < along; ++u)
        for (uint32_t v = 0; v < across; ++v)
            data.indices.insert(data.indices.end(), {vertex(u, v), vertex(u + 1, v), vertex(u + 1, v + 1),  //
                                                     vertex(u, v), vertex(u + 1, v + 1), vertex(u, v + 1)});
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// Unit directions and triangles of an icosahedron whose faces are divided f × f.
struct Geodesic {
    std::vector<Vec3> directions;
    std::vector<uint32_t> indices;
};

class GeodesicBuilder {
public:
    explicit GeodesicBuilder(uint32_t frequency) : m_frequency(frequency) {
        const double golden = std::numbers::phi;
        for (const double s : {-1.0, 1.0})
            for (const double t : {-golden, golden}) {
                m_geodesic.directions.push_back(glm::normalize(Vec3(0, s, t)));
                m_geodesic.directions.push_back(glm::normalize(Vec3(s, t, 0)));
                m_geodesic.directions.push_back(glm::normalize(Vec3(t, 0, s)));
            }
    }

    Geodesic build() {
        const double edge = 2.0 / std::sqrt(1.0 + std::numbers::phi * std::numbers::phi);
        const auto adjacent = [&](uint32_t a, uint32_t b) {
            return std::abs(glm::distance(m_geodesic.directions[a], m_geodesic.directions[b]) - edge) < 1e-9;
        };
        for (uint32_t a = 0; a < 12; ++a)
            for (uint32_t b = a + 1; b < 12; ++b)
                for (uint32_t c = b + 1; c < 12; ++c)
                    if (adjacent(a, b) && adjacent(b, c) && adjacent(a, c)) divide(a, b, c);
        return std::move(m_geodesic);
    }

private:
    void divide(uint32_t a, uint32_t b, uint32_t c) {
        const auto& d = m_geodesic.directions;
        if (glm::dot(glm::cross(d[b] - d[a], d[c] - d[a]), d[a]) < 0) std::swap(b, c);
        std::vector<std::vector<uint32_t>> rows(m_frequency + 1);
        for (uint32_t i = 0; i <= m_frequency; ++i)
            for (uint32_t j = 0; j + i <= m_frequency; ++j)
                rows[i].push_back(vertex({std::pair{a, m_frequency - i - j}, std::pair{b, j}, std::pair{c, i}}));
        for (uint32_t i = 0; i < m_frequency; ++i)
            for (uint32_t j = 0; j + i < m_frequency; ++j) {
                m_geodesic.indices.insert(m_geodesic.indices.end(), {rows[i][j], rows[i][j + 1], rows[i + 1][j]});
                if (j + i + 1 < m_frequency)
                    m_geodesic.indices.insert(m_geodesic.indices.end(), {rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]});
            }
    }

    /// The vertex with integer barycentric weights; the same one from either side of an edge.
    uint32_t vertex(std::array<std::pair<uint32_t, uint32_t>, 3> weights) {
        std::sort(weights.begin(), weights.end());
        std::array<uint32_t, 6> key{};
        size_t used = 0;
        Vec3 sum(0.0);
        for (const auto& [corner, weight] : weights) {
            if (weight == 0) continue;
            key[used++] = corner + 1;
            key[used++] = weight;
            sum += m_geodesic.directions[corner] * double(weight);
        }
        if (used == 2) return key[0] - 1;
        const auto [entry, isNew] = m_vertices.try_emplace(key, static_cast<uint32_t>(m_geodesic.directions.size()));
        if (isNew) m_geodesic.directions.push_back(glm::normalize(sum));
        return entry->second;
    }

    uint32_t m_frequency;
    Geodesic m_geodesic;
    std::map<std::array<uint32_t, 6>, uint32_t> m_vertices;
};

Geodesic geodesic(size_t triangles) {
    checkCount(triangles, 20);
    return GeodesicBuilder(static_cast<uint32_t>(std::max(1.0, std::round(std::sqrt(double(triangles) / 20.0))))).build();
}

}  // namespace

MeshPointer sphereMesh(size_t triangles) {
    Geodesic sphere = geodesic(triangles);
    TriangleMesh::Data data;
    data.name = "sphere";
    data.positions.assign(sphere.directions.begin(), sphere.directions.end());
    data.normals = data.positions;
    data.indices = std::move(sphere.indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

MeshPointer torusMesh(size_t triangles) {
    constexpr double kTube = 0.25;
    return periodicGrid("torus", triangles, 1.0 / kTube, [](double u, double v) {
        const Vec3 outward(std::cos(u), 0, -std::sin(u));
        const Vec3 normal = outward * std::cos(v) + Vec3(0, std::sin(v), 0);
        return std::pair(outward + normal * kTube, normal);
    });
}

MeshPointer knotMesh(size_t triangles) {
    constexpr double kTube = 0.25;
    const auto centre = [](double t) {
        const double r = 1.0 + 0.5 * std::cos(3 * t);
        return Vec3(r * std::cos(2 * t), r * std::sin(2 * t), 0.5 * std::sin(3 * t));
    };
    return periodicGrid("knot", triangles, 8.0, [&](double u, double v) {
        // A frame from the curve's own tangent and its pull toward the axis: smooth and periodic, as the curve never runs along
        // it.
        const Vec3 tangent = glm::normalize(centre(u + 1e-4) - centre(u - 1e-4));
        const Vec3 outward = centre(u);
        const Vec3 first = glm::normalize(outward - tangent * glm::dot(outward, tangent));
        const Vec3 second = glm::cross(first, tangent);
        const Vec3 normal = first * std::cos(v) + second * std::sin(v);
        return std::pair(centre(u) + normal * kTube, normal);
    });
}

MeshPointer starMesh(uint64_t seed, size_t triangles) {
    Geodesic sphere = geodesic(triangles);
    struct Bump {
        Vec3 direction;
        double height, sharpness;
    };
    Random random(seed);
    std::vector<Bump> bumps(24);
    for (Bump& bump : bumps) bump = {random.direction(), random.between(-0.3, 0.3), random.between(8.0, 60.0)};
    TriangleMesh::Data data;
    data.name = "star";
    for (const Vec3& direction : sphere.directions) {
        double sum = 0.0;
        for (const Bump& bump : bumps)
            sum += bump.height * std::exp(bump.sharpness * (glm::dot(direction, bump.direction) - 1.0));
        data.positions.emplace_back(direction * (1.0 + 0.45 * std::tanh(sum / 0.45)));
    }
    data.indices = std::move(sphere.indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

}  // namespace cullscope
