#include "core/mesh/parametric.h"

#include <cmath>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/geometry/random.h"

namespace cullscope {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

constexpr size_t kMostTriangles = 2'000'000'000;

void checkCount(const char* shape, size_t triangles, size_t least) {
    if (triangles < least || triangles > kMostTriangles)
        throwUsage(CULLSCOPE_TR("%1 takes between %2 and %3 triangles, not %4."),
                   {shape, std::to_string(least), std::to_string(kMostTriangles), std::to_string(triangles)});
}

/// Reports the finished rows of a tessellation, and throws Error(Interrupted) on a stop request.
void row(const Progress& progress, size_t done, size_t all) {
    progress.check();
    progress.tell(double(done) / double(all), CULLSCOPE_TR("Tessellating the shape"));
}

/// A closed grid of u × v quads on a surface that is periodic in both directions.
template <typename Surface>
MeshPointer periodicGrid(const char* name, size_t triangles, double aspect, const Progress& progress, const Surface& surface) {
    checkCount(name, triangles, 18);
    const auto across = static_cast<uint32_t>(std::max(3.0, std::round(std::sqrt(double(triangles) / 2.0 / aspect))));
    const auto along = static_cast<uint32_t>(std::max(3.0, std::round(double(triangles) / 2.0 / across)));
    TriangleMesh::Data data;
    data.name = name;
    data.positions.reserve(size_t{along} * across);
    data.normals.reserve(size_t{along} * across);
    data.indices.reserve(size_t{along} * across * 6);
    for (uint32_t u = 0; u < along; ++u) {
        row(progress, u, 2 * size_t{along});
        for (uint32_t v = 0; v < across; ++v) {
            const auto [position, normal] = surface(kTau * u / along, kTau * v / across);
            data.positions.emplace_back(position);
            data.normals.emplace_back(glm::normalize(normal));
        }
    }
    const auto vertex = [&](uint32_t u, uint32_t v) { return (u % along) * across + v % across; };
    for (uint32_t u = 0; u < along; ++u) {
        row(progress, along + u, 2 * size_t{along});
        for (uint32_t v = 0; v < across; ++v)
            data.indices.insert(data.indices.end(), {vertex(u, v), vertex(u + 1, v), vertex(u + 1, v + 1),  //
                                                     vertex(u, v), vertex(u + 1, v + 1), vertex(u, v + 1)});
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// Unit directions and triangles of an icosahedron with each face divided f × f.
struct Geodesic {
    std::vector<Vec3> directions;
    std::vector<uint32_t> indices;
};

class GeodesicBuilder {
public:
    GeodesicBuilder(uint32_t frequency, const Progress& progress) : m_frequency(frequency), m_progress(progress) {
        const size_t squared = size_t{frequency} * frequency;
        m_geodesic.directions.reserve(10 * squared + 2);
        m_geodesic.indices.reserve(60 * squared);
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
        std::vector<uint32_t> below = verticesOfRow(a, b, c, 0);
        for (uint32_t i = 0; i < m_frequency; ++i) {
            row(m_progress, m_rows++, 20 * size_t{m_frequency});
            const std::vector<uint32_t> above = verticesOfRow(a, b, c, i + 1);
            for (uint32_t j = 0; j + i < m_frequency; ++j) {
                m_geodesic.indices.insert(m_geodesic.indices.end(), {below[j], below[j + 1], above[j]});
                if (j + i + 1 < m_frequency)
                    m_geodesic.indices.insert(m_geodesic.indices.end(), {below[j + 1], above[j + 1], above[j]});
            }
            below = above;
        }
    }

    std::vector<uint32_t> verticesOfRow(uint32_t a, uint32_t b, uint32_t c, uint32_t i) {
        std::vector<uint32_t> vertices;
        for (uint32_t j = 0; j + i <= m_frequency; ++j)
            vertices.push_back(vertex({std::pair{a, m_frequency - i - j}, std::pair{b, j}, std::pair{c, i}}));
        return vertices;
    }

    /// The vertex with these integer barycentric weights; the same vertex from both sides of an edge.
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
        // A vertex inside a face belongs to that face only; vertices on edges are shared.
        if (used == 6) {
            m_geodesic.directions.push_back(glm::normalize(sum));
            return static_cast<uint32_t>(m_geodesic.directions.size() - 1);
        }
        const auto [entry, isNew] = m_vertices.try_emplace(key, static_cast<uint32_t>(m_geodesic.directions.size()));
        if (isNew) m_geodesic.directions.push_back(glm::normalize(sum));
        return entry->second;
    }

    uint32_t m_frequency;
    const Progress& m_progress;
    size_t m_rows = 0;  ///< done
    Geodesic m_geodesic;
    std::map<std::array<uint32_t, 6>, uint32_t> m_vertices;
};

Geodesic geodesic(const char* shape, size_t triangles, const Progress& progress) {
    checkCount(shape, triangles, 20);
    const double frequency = std::max(1.0, std::round(std::sqrt(double(triangles) / 20.0)));
    return GeodesicBuilder(static_cast<uint32_t>(frequency), progress).build();
}

}  // namespace

MeshPointer sphereMesh(size_t triangles, const Progress& progress) {
    Geodesic sphere = geodesic("sphere", triangles, progress);
    TriangleMesh::Data data;
    data.name = "sphere";
    data.positions.assign(sphere.directions.begin(), sphere.directions.end());
    data.normals = data.positions;
    data.indices = std::move(sphere.indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

MeshPointer torusMesh(size_t triangles, const Progress& progress) {
    constexpr double kTube = 0.25;
    return periodicGrid("torus", triangles, 1.0 / kTube, progress, [](double u, double v) {
        const Vec3 outward(std::cos(u), 0, -std::sin(u));
        const Vec3 normal = outward * std::cos(v) + Vec3(0, std::sin(v), 0);
        return std::pair(outward + normal * kTube, normal);
    });
}

MeshPointer bowlMesh(size_t triangles, const Progress& progress) {
    constexpr double kInner = 0.92;
    checkCount("bowl", triangles, 64);
    // 4 n sides and n rings on each of the two walls: 16 n² triangles.
    const auto n = std::max<size_t>(2, size_t(std::lround(std::sqrt(double(triangles) / 16.0))));
    const auto sides = uint32_t(4 * n);
    TriangleMesh::Data data;
    data.name = "bowl";
    uint32_t done = 0;
    const auto addRing = [&](double radius, double angle) {
        row(progress, done++, uint32_t(4 * n));
        for (uint32_t side = 0; side < sides; ++side) {
            const double turn = 2.0 * std::numbers::pi * side / sides;
            data.positions.emplace_back(
                Vec3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), -std::cos(angle)) * radius);
        }
    };
    const double step = 0.5 * std::numbers::pi / double(n);
    for (size_t ring = 1; ring <= n; ++ring) addRing(1.0, double(ring) * step);
    for (size_t ring = n; ring >= 1; --ring) addRing(kInner, double(ring) * step);
    const auto rings = uint32_t(2 * n), outerPole = rings * sides, innerPole = outerPole + 1;
    data.positions.emplace_back(0.0f, 0.0f, -1.0f);
    data.positions.emplace_back(0.0f, 0.0f, float(-kInner));
    const auto at = [&](uint32_t ring, uint32_t side) { return ring * sides + side % sides; };
    for (uint32_t side = 0; side < sides; ++side) {
        row(progress, uint32_t(2 * n) + side / 2, uint32_t(4 * n));
        data.indices.insert(data.indices.end(), {outerPole, at(0, side + 1), at(0, side)});
        for (uint32_t ring = 0; ring + 1 < rings; ++ring)
            data.indices.insert(data.indices.end(), {at(ring, side), at(ring, side + 1), at(ring + 1, side + 1),  //
                                                     at(ring, side), at(ring + 1, side + 1), at(ring + 1, side)});
        data.indices.insert(data.indices.end(), {innerPole, at(rings - 1, side), at(rings - 1, side + 1)});
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

MeshPointer knotMesh(size_t triangles, const Progress& progress) {
    constexpr double kTube = 0.25;
    const auto centre = [](double t) {
        const double r = 1.0 + 0.5 * std::cos(3 * t);
        return Vec3(r * std::cos(2 * t), r * std::sin(2 * t), 0.5 * std::sin(3 * t));
    };
    return periodicGrid("knot", triangles, 8.0, progress, [&](double u, double v) {
        // A frame from the curve's tangent and the direction away from the axis: smooth and periodic, because the tangent never
        // has that direction.
        const Vec3 tangent = glm::normalize(centre(u + 1e-4) - centre(u - 1e-4));
        const Vec3 outward = centre(u);
        const Vec3 first = glm::normalize(outward - tangent * glm::dot(outward, tangent));
        const Vec3 second = glm::cross(first, tangent);
        const Vec3 normal = first * std::cos(v) + second * std::sin(v);
        return std::pair(centre(u) + normal * kTube, normal);
    });
}

MeshPointer starMesh(uint64_t seed, size_t triangles, const Progress& progress) {
    Geodesic sphere = geodesic("star", triangles, progress);
    struct Bump {
        Vec3 direction;
        double height, sharpness;
    };
    Random random(seed);
    std::vector<Bump> bumps(24);
    for (Bump& bump : bumps) bump = {random.direction(), random.between(-0.3, 0.3), random.between(8.0, 60.0)};
    TriangleMesh::Data data;
    data.name = "star";
    data.positions.reserve(sphere.directions.size());
    for (const Vec3& direction : sphere.directions) {
        if (data.positions.size() % 65536 == 0) progress.check();
        double sum = 0.0;
        for (const Bump& bump : bumps)
            sum += bump.height * std::exp(bump.sharpness * (glm::dot(direction, bump.direction) - 1.0));
        data.positions.emplace_back(direction * (1.0 + 0.45 * std::tanh(sum / 0.45)));
    }
    data.indices = std::move(sphere.indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

}  // namespace cullscope
