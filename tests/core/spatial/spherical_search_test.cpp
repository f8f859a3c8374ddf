// The search through the index map finds the same triangles as Embree.
#include "core/spatial/spherical_search.h"

#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/spherical_meshes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::spherical_search_test {
namespace {

/// Embree over a mesh, relative to the maps' centre.
class Tracer {
public:
    explicit Tracer(const SphericalMaps& maps) : m_device(rtcNewDevice(nullptr)), m_scene(rtcNewScene(m_device)) {
        rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const size_t count = maps.mesh().triangleCount();
        auto* positions = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
        auto* indices = static_cast<uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
        for (uint32_t triangle = 0; triangle < count; ++triangle)
            for (size_t i = 0; i < 3; ++i) {
                const Vec3 corner = maps.corners(triangle)[i];
                for (int axis = 0; axis < 3; ++axis) positions[9 * size_t(triangle) + 3 * i + size_t(axis)] = float(corner[axis]);
                indices[3 * size_t(triangle) + i] = uint32_t(3 * size_t(triangle) + i);
            }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(m_scene);
    }
    ~Tracer() {
        rtcReleaseScene(m_scene);
        rtcReleaseDevice(m_device);
    }
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    [[nodiscard]] std::optional<TriangleHit> first(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray.org_x = float(ray.origin.x);
        query.ray.org_y = float(ray.origin.y);
        query.ray.org_z = float(ray.origin.z);
        query.ray.dir_x = float(ray.direction.x);
        query.ray.dir_y = float(ray.direction.y);
        query.ray.dir_z = float(ray.direction.z);
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(m_scene, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
        return TriangleHit{query.hit.primID, query.ray.tfar};
    }

private:
    RTCDevice m_device;
    RTCScene m_scene;
};

/// A ray from the centre, or from outside to a point near the mesh. In float, so that both searches use identical rays.
Ray anyRay(Random& random, double radius, bool fromCentre) {
    // One random number per statement: within one expression the compiler chooses the order.
    Ray ray;
    const double away = random.between(1.2, 6.0) * radius, inside = random.between(0.0, 0.9) * radius;
    const Vec3 from = random.direction();
    const Vec3 to = random.direction();
    if (!fromCentre) ray.origin = Vec3(Vec3f(away * from));
    ray.direction = Vec3(Vec3f(glm::normalize(fromCentre ? to : inside * to - ray.origin)));
    return ray;
}

/// The distance of a ray from an edge of a triangle that only one of the searches found, in radians from its origin and in shares
/// of the radius: near an edge the two may differ by rounding.
double distanceToEdges(const Ray& ray, const std::array<Vec3, 3>& corners) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < 3; ++i) {
        // The distance of two lines, the ray's and the edge's, at the nearest point inside the edge.
        const Vec3& a = corners[i];
        const Vec3 edge = corners[(i + 1) % 3] - a;
        const Vec3 across = a - ray.origin - glm::dot(a - ray.origin, ray.direction) * ray.direction;
        const Vec3 edgeAcross = edge - glm::dot(edge, ray.direction) * ray.direction;
        const double length = glm::dot(edgeAcross, edgeAcross);
        const double s = length > 0.0 ? std::clamp(-glm::dot(across, edgeAcross) / length, 0.0, 1.0) : 0.0;
        least = std::min(least, glm::length(across + s * edgeAcross));
    }
    return least;
}

TEST(SphericalSearch, findsWhatEmbreeFinds) {
    const std::vector<MeshPointer> meshes = mapTestMeshes();
    const size_t rays = howMany(1'000'000, 60'000) / meshes.size() + 1;
    Random random(51);
    uint64_t hits = 0, edges = 0, all = 0;
    for (const MeshPointer& mesh : meshes) {
        const SphericalMaps maps(mesh, SphericalGrid::forTriangles(mesh->triangleCount()));
        const SphericalMaps entries(mesh, maps.grid(), maps.frame(), MapStorage::Entries);
        const Tracer tracer(maps);
        const double radius = maps.sphere().radius;
        for (size_t i = 0; i < rays; ++i) {
            const Ray ray = anyRay(random, radius, i % 2 == 0);
            const std::optional<TriangleHit> expected = tracer.first(ray), found = searchTriangle(maps, ray);
            const std::optional<TriangleHit> byEntries = searchTriangle(entries, ray);
            ASSERT_EQ(found.has_value(), byEntries.has_value()) << mesh->name() << ", ray " << i;
            // Of two triangles that are hit at one distance either may be told: that of the cell in which one was tested first.
            if (found) ASSERT_EQ(found->t, byEntries->t) << mesh->name() << ", ray " << i;
            ++all;
            hits += expected ? 1 : 0;
            if (!expected && !found) continue;
            // A triangle through the ray's origin may be hit or not, by rounding.
            if (std::min(expected ? expected->t : radius, found ? found->t : radius) < 1e-5 * radius) continue;
            if (expected && found && (expected->triangle == found->triangle || std::abs(expected->t - found->t) < 1e-5 * radius))
                continue;
            // Where the results differ, the ray passes close to an edge, or the triangle is seen edge-on.
            const bool foundNearer = found && (!expected || found->t < expected->t);
            const std::array<Vec3, 3> corners = maps.corners(foundNearer ? found->triangle : expected->triangle);
            const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const bool edgeOn = std::abs(glm::dot(normal, ray.direction)) < 1e-4 * glm::length(normal);
            ++edges;
            ASSERT_TRUE(edgeOn || distanceToEdges(ray, corners) < 2e-6 * (radius + glm::length(ray.origin)))
                << mesh->name() << ", ray " << i << ": Embree " << (expected ? expected->t : -1.0) << ", search "
                << (found ? found->t : -1.0) << ", distance to an edge " << distanceToEdges(ray, corners) / radius << " R";
        }
    }
    std::printf(
        "long: search through the index map: %llu rays, %llu meet something, %llu pass an edge differently from Embree's\n",
        static_cast<unsigned long long>(all), static_cast<unsigned long long>(hits), static_cast<unsigned long long>(edges));
    EXPECT_GT(hits, all / 4);
    EXPECT_LT(edges, all / 500 + 5);
}

TEST(WalkedCells, areTheCellsOfTheRaysPoints) {
    Random random(52);
    for (int i = 0; i < int(howMany(300'000, 3'000)); ++i) {
        const uint32_t columns = 4 + uint32_t(random.between(0.0, 400.0));
        const SphericalGrid grid(columns, 2 + uint32_t(random.between(0.0, 200.0)));
        Ray ray = anyRay(random, 1.0, false);
        // Some rays along the axis, through it, and in planes of constant z.
        if (i % 7 == 1) ray.direction = glm::normalize(Vec3(0.0, 0.0, 0.3) * random.unit() - ray.origin);
        if (i % 7 == 2) ray.direction = {0.0, 0.0, ray.origin.z > 0.0 ? -1.0 : 1.0};
        if (i % 7 == 3) ray.direction = glm::normalize(Vec3(-ray.origin.x, -ray.origin.y, 0.0));
        const std::optional<Span> span = throughSphere(ray, 1.0);
        if (!span) continue;
        const std::vector<WalkedCell> walked = walkedCells(grid, ray, *span);
        ASSERT_FALSE(walked.empty());
        EXPECT_EQ(walked.front().span.from, span->from);
        EXPECT_EQ(walked.back().span.to, span->to);
        for (size_t step = 1; step < walked.size(); ++step) EXPECT_EQ(walked[step].span.from, walked[step - 1].span.to);
        for (int sample = 0; sample < 200; ++sample) {
            const double t = random.between(span->from, span->to);
            const auto step = std::find_if(walked.begin(), walked.end(), [&](const WalkedCell& one) { return t <= one.span.to; });
            ASSERT_NE(step, walked.end());
            // Very close to a boundary the cell depends on rounding.
            const double margin = std::min(t - step->span.from, step->span.to - t);
            if (margin < 1e-9) continue;
            const SphericalGrid::Cell cell = grid.cellOf(ray.at(t));
            ASSERT_EQ(step->cell, cell) << "ray " << i << ", t " << t << ", grid " << grid.columns() << " × " << grid.rows();
        }
    }
}

TEST(ThroughSphere, beginsWhereTheRayDoes) {
    const Ray inside{{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    ASSERT_TRUE(throughSphere(inside, 1.0));
    EXPECT_EQ(throughSphere(inside, 1.0)->from, 0.0);
    EXPECT_DOUBLE_EQ(throughSphere(inside, 1.0)->to, 0.5);
    EXPECT_FALSE(throughSphere({{2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, 1.0)) << "behind it";
    EXPECT_FALSE(throughSphere({{-2.0, 1.5, 0.0}, {1.0, 0.0, 0.0}}, 1.0)) << "beside it";
}

}  // namespace
}  // namespace cullscope::test::spherical_search_test
