// Levels of detail, and the distance of surfaces by which their errors are stated.
#include "core/spatial/detail_levels.h"

#include <gtest/gtest.h>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/mesh/primitive/tessellate.h"
#include "core/mesh/surface_distance.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::detail_levels_test {
namespace {

using Indices = std::span<const uint32_t>;

/// The distance from a triangle by the closest point of Ericson 2005, "Real-Time Collision Detection", 5.1.5.
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
                 d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    Vec3 closest = a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
    if (d1 <= 0.0 && d2 <= 0.0)
        closest = a;
    else if (d3 >= 0.0 && d4 <= d3)
        closest = b;
    else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        closest = a + (d1 / (d1 - d3)) * ab;
    else if (d6 >= 0.0 && d5 <= d6)
        closest = c;
    else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        closest = a + (d2 / (d2 - d6)) * ac;
    else if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        closest = b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    return glm::length(p - closest);
}

/// The farthest of points of one surface (corners, and points within triangles) from another, by all of its triangles.
double farthestSample(std::span<const Vec3f> points, Indices from, Indices to, uint64_t samples, Random& random) {
    double farthest = 0.0;
    const auto at = [&](Indices indices, size_t i) { return Vec3(points[indices[i]]); };
    for (uint64_t sample = 0; sample < samples; ++sample) {
        const size_t i = 3 * size_t(random.between(0.0, double(from.size() / 3) - 1e-9));
        double u = random.unit(), v = random.unit();
        if (sample % 3 == 0) u = v = 0.0;
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Vec3 p = at(from, i) + u * (at(from, i + 1) - at(from, i)) + v * (at(from, i + 2) - at(from, i));
        double nearest = std::numeric_limits<double>::infinity();
        for (size_t j = 0; j < to.size(); j += 3)
            nearest = std::min(nearest, distanceToTriangle(p, at(to, j), at(to, j + 1), at(to, j + 2)));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

/// What every level keeps: it is smaller, and its error is no less than what samples of both surfaces find, and not much more.
void expectLevels(const TriangleMesh& mesh, const std::vector<MeshLevel>& levels, Random& random) {
    size_t before = mesh.indices().size();
    double error = 0.0;
    for (const MeshLevel& level : levels) {
        EXPECT_LE(3 * level.indices.size(), 2 * before);
        EXPECT_GT(level.error, error);
        before = level.indices.size();
        error = level.error;
        const uint64_t samples = howMany(3000, 300);
        const double there = farthestSample(mesh.positions(), mesh.indices(), level.indices, samples, random);
        const double back = farthestSample(mesh.positions(), level.indices, mesh.indices(), samples, random);
        EXPECT_LE(std::max(there, back), level.error * (1.0 + 1e-9)) << level.indices.size() / 3 << " triangles";
        EXPECT_GE(1.7 * std::max(there, back) + mesh.localBounds().diagonal() / 4000.0, level.error) << "far above what is there";
    }
}

/// Whether a level closes as its mesh does.
bool closes(const TriangleMesh& mesh, const MeshLevel& level) {
    TriangleMesh::Data data;
    data.positions.assign(mesh.positions().begin(), mesh.positions().end());
    data.indices = level.indices;
    const TriangleMesh coarser(std::move(data));
    return coarser.topology().frontFacesSuffice();
}

TEST(SurfaceDistance, isThatOfKnownSurfaces) {
    // Two squares at a distance, one of them cut into other triangles and larger at one corner.
    const std::vector<Vec3f> points{{0, 0, 0},     {1, 0, 0},     {1, 1, 0},     {0, 1, 0},       {0, 0, 0.25f},
                                    {1, 0, 0.25f}, {1, 1, 0.25f}, {0, 1, 0.25f}, {0.5f, 0.5f, 1}, {4, 0, 0}};
    const std::vector<uint32_t> square{0, 1, 2, 0, 2, 3}, above{4, 5, 7, 5, 6, 7}, tent{0, 1, 8, 1, 2, 8, 2, 3, 8, 3, 0, 8},
        wider{0, 9, 2, 0, 2, 3};
    const auto distance = [&](const std::vector<uint32_t>& one, const std::vector<uint32_t>& other) {
        return SurfaceDistance(points, one).to(other);
    };
    const auto expectAbout = [](double bound, double exact) {
        EXPECT_GE(bound, exact - 1e-12);
        EXPECT_LE(bound, 1.1 * exact);
    };
    EXPECT_EQ(distance(square, square), 0.0);
    expectAbout(distance(square, above), 0.25);
    expectAbout(distance(square, tent), 1.0);  // the tip
    expectAbout(distance(tent, square), 1.0);
    expectAbout(distance(square, wider), 3.0);
    expectAbout(distance(wider, square), 3.0);
    EXPECT_TRUE(std::isinf(distance(square, {})));
    EXPECT_EQ(distance({}, {}), 0.0);
}

TEST(DetailLevels, ofPrimitivesHaveFewerSegmentsAndStateTheirError) {
    namespace solid = primitive;
    const solid::Primitive solids[] = {solid::Cylinder{1.0, 6.0}, solid::Cone{2.0, 1.0, 1.5},
                                       solid::CircularTorus{3.0, 0.5, Angle::fromDegrees(90)}, solid::EllipsoidalDish{2.0, 1.0},
                                       solid::HollowCylinder{1.0, 1.5, 0.5}};
    Random random(3);
    size_t levelsFound = 0;
    for (const solid::Primitive& one : solids) {
        Components components;
        Mat4 placed = translation({5.0, -2.0, 1.0});
        solid::Surface surface;
        solid::appendSurface(surface, one, {.segments = 24}, placed);
        const auto count = uint32_t(surface.triangles.size() / 3);
        components.parts.push_back({MeshPart::Kind::Solid, one, placed, 0, count});
        // A second one beside it: levels hold both.
        placed = translation({-5.0, 0.0, 0.0}) * scaling({0.5, 0.5, 2.0});
        solid::appendSurface(surface, one, {.segments = 20}, placed);
        components.parts.push_back({MeshPart::Kind::Solid, one, placed, count, uint32_t(surface.triangles.size() / 3) - count});
        const MeshPointer mesh = solid::meshOf(surface, "solids");
        const std::vector<MeshLevel> levels = segmentLevels(*mesh, components.parts, {});
        ASSERT_GE(levels.size(), 2u) << solid::kindName(one.index());
        levelsFound += levels.size();
        expectLevels(*mesh, levels, random);
        for (const MeshLevel& level : levels) EXPECT_TRUE(closes(*mesh, level)) << solid::kindName(one.index());
    }
    EXPECT_GE(levelsFound, 15u);
}

TEST(DetailLevels, ofOtherMeshesAreDecimatedAndStateTheirError) {
    Random random(4);
    const MeshPointer sphere = sphereMesh(320);
    const std::vector<MeshLevel> levels = decimatedLevels(*sphere, {});
    ASSERT_GE(levels.size(), 3u);
    expectLevels(*sphere, levels, random);
    for (const MeshLevel& level : levels) EXPECT_TRUE(closes(*sphere, level));
    // A box with edges: a corner has the vertex that its triangle's side needs.
    EXPECT_TRUE(decimatedLevels(*boxMesh(Vec3f(-1.0f), Vec3f(1.0f)), {}).size() <= 1);
}

TEST(DetailLevels, ofASceneLieBehindTheMeshItselfInOneOrder) {
    std::vector<MeshPointer> meshes{sphereMesh(320), boxMesh(Vec3f(-1.0f), Vec3f(1.0f)), sphereMesh(80)};
    std::vector<Instance> instances{{0, Mat4(1.0), "a"}, {1, Mat4(1.0), "b"}, {0, translation({3, 0, 0}), "c"}};
    const Scene scene("levels", std::move(meshes), std::move(instances));
    const DetailLevels levels(scene, {});
    ASSERT_GE(levels.of(0).size(), 4u);
    EXPECT_EQ(levels.of(1).size(), 1u) << "twelve triangles stay as they are";
    EXPECT_EQ(levels.of(2).size(), 1u) << "no object has this mesh";
    EXPECT_EQ(levels.meshesByQuadrics(), 1u);
    EXPECT_EQ(levels.coarserLevels(), levels.of(0).size() - 1);
    const TriangleOrder::OfMesh& order = levels.order()->meshes[0];
    EXPECT_EQ(order.standIns, 320u);
    uint32_t end = 0;
    for (const DetailLevels::Level& level : levels.of(0)) {
        EXPECT_EQ(level.firstIndex, end);
        end += level.indexCount;
    }
    ASSERT_EQ(order.indices.size(), end);
    EXPECT_LE(end, 3 * scene.meshes()[0]->indices().size()) << "all levels together";
    std::vector<bool> own(320, false);
    for (size_t place = 0; place < 320; ++place) {
        const uint32_t triangle = order.triangles[place];
        EXPECT_FALSE(own[triangle]);
        own[triangle] = true;
        EXPECT_TRUE(std::ranges::equal(order.indices.subspan(3 * place, 3),
                                       scene.meshes()[0]->indices().subspan(3 * size_t(triangle), 3)));
    }
    for (const uint32_t triangle : order.triangles) EXPECT_LT(triangle, 320u);
    EXPECT_GE(levels.bytes(), order.indices.size_bytes() + order.triangles.size_bytes());
}

}  // namespace
}  // namespace cullscope::test::detail_levels_test
