// The radii of the kernel, checked against rays from the centre to every triangle.
#include "core/spatial/inner_kernel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <numbers>

#include "core/geometry/triangle.h"
#include "core/mesh/parametric.h"
#include "tests/support/lossless_scenes.h"
#include "tests/support/spherical_meshes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::inner_kernel_test {
namespace {

using State = InnerKernel::State;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

auto scaledBy(const Vec3& factor, const Vec3& shift = Vec3(0.0)) {
    return [=](const Vec3& p) { return factor * p + shift; };
}

MeshPointer joined(const TriangleMesh& a, const TriangleMesh& b) {
    std::vector<Vec3f> positions(a.positions().begin(), a.positions().end());
    std::vector<uint32_t> indices(a.indices().begin(), a.indices().end());
    for (const uint32_t index : b.indices()) indices.push_back(uint32_t(positions.size()) + index);
    positions.insert(positions.end(), b.positions().begin(), b.positions().end());
    return meshOf(std::move(positions), std::move(indices));
}

/// A sphere of radius 0.5 inside one of radius 1, each reversed or not.
template <typename Turned>
MeshPointer shells(const Turned& innerTurned) {
    const MeshPointer sphere = sphereMesh(4'000);
    return joined(*sphere, *changed(*sphere, scaledBy(Vec3(0.5)), innerTurned));
}

/// The distance at which a ray from the origin hits a triangle, in lengths of the direction (Möller & Trumbore 1997); infinite:
/// no hit.
double hit(const TriangleCorners& corners, const Vec3& direction) {
    const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec3 p = glm::cross(direction, v);
    const double determinant = glm::dot(u, p);
    if (determinant == 0.0) return kInfinity;
    const Vec3 q = glm::cross(-corners[0], u);
    const double a = glm::dot(-corners[0], p) / determinant, b = glm::dot(direction, q) / determinant;
    const double t = glm::dot(v, q) / determinant;
    return a >= 0.0 && b >= 0.0 && a + b <= 1.0 && t >= 0.0 ? t : kInfinity;
}

class Surface {
public:
    explicit Surface(const TriangleMesh& mesh) {
        for (size_t i = 0; i < mesh.indices().size(); i += 3) {
            TriangleCorners corners;
            for (size_t k = 0; k < 3; ++k) corners[k] = Vec3(mesh.positions()[mesh.indices()[i + k]]) - mesh.localSphere().centre;
            m_triangles.push_back(corners);
        }
    }
    /// The distance from the centre to the first triangle in a unit direction.
    [[nodiscard]] double distance(const Vec3& direction) const {
        double nearest = kInfinity;
        for (const TriangleCorners& corners : m_triangles) nearest = std::min(nearest, hit(corners, direction));
        return nearest;
    }

private:
    std::vector<TriangleCorners> m_triangles;
};

/// A random direction within an angle of another.
Vec3 directionNear(Random& random, const Vec3& direction, double angle) {
    const double turn = angle * random.unit();
    const Vec3 aside = glm::normalize(glm::cross(direction, random.direction()));
    return std::cos(turn) * direction + std::sin(turn) * aside;
}

void expectFilled(const TriangleMesh& mesh, uint64_t seed) {
    const InnerKernel kernel(mesh);
    ASSERT_EQ(kernel.state(), State::Filled);
    const Surface surface(mesh);
    Random random(seed);
    for (uint64_t i = 0; i < howMany(600, 600); ++i) {
        const Vec3 direction = random.direction();
        const double distance = surface.distance(direction);
        ASSERT_LE(kernel.radius(octahedralCell(direction, kernel.level())), distance);
        ASSERT_GE(kernel.radius(octahedralCell(direction, kernel.level())), kernel.leastRadius());
        for (int k = 0; k < 30; ++k) {
            const Vec3 other = directionNear(random, direction, kernel.reach());
            ASSERT_LE(kernel.radiusAround(7.0 * other), distance) << "direction " << i << ", seed " << seed;
        }
    }
}

TEST(InnerKernel, noRayMeetsTheSurfaceWithinIt) {
    const MeshPointer star = starMesh(7, 5'000);
    const std::vector<MeshPointer> meshes{
        sphereMesh(300),
        sphereMesh(5'000),
        sphereMesh(12'000),
        star,
        starMesh(3, 20'000),
        starMesh(11, 1'000),
        boxMesh({-1, -1, -1}, {1, 1, 1}),
        boxMesh({-1, -0.3f, -0.1f}, {1, 0.3f, 0.1f}),
        joined(*boxMesh({-1, -1, -1}, {1, 1, 1}), *star),
        changed(*star, scaledBy({0.2, 1.0, 0.4}), kNone),
        changed(*star, scaledBy({1.0, 1.0, 1.0}, {30.0, -20.0, 10.0}), kNone),
        changed(*star, kStay, kEvery),
        shells(kNone),
    };
    for (size_t i = 0; i < meshes.size(); ++i) {
        SCOPED_TRACE(i);
        ASSERT_NO_FATAL_FAILURE(expectFilled(*meshes[i], i));
    }
}

TEST(InnerKernel, fillsAFineSphereNearlyToItsSurface) {
    const MeshPointer mesh = sphereMesh(20'000);
    const InnerKernel kernel(*mesh);
    ASSERT_TRUE(kernel.filled());
    EXPECT_TRUE(kernel.outward());
    EXPECT_GT(kernel.leastRadius(), 0.998f);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 direction = random.direction();
        EXPECT_NEAR(kernel.radius(octahedralCell(direction, kernel.level())), 1.0, 0.002);
        EXPECT_NEAR(kernel.radiusAround(direction), 1.0, 0.002);
    }
}

TEST(InnerKernel, followsTheSurfaceWhereItIsNotRound) {
    // Where the surface is farther in all directions within the kernel's reach, the kernel is larger too.
    const MeshPointer mesh = starMesh(7, 20'000);
    const InnerKernel kernel(*mesh);
    ASSERT_TRUE(kernel.filled());
    float largest = 0.0f;
    for (uint32_t code = 0; code < 1U << (2 * kernel.level()); ++code)
        largest = std::max(largest, kernel.radius(mapCell(code, kernel.level())));
    EXPECT_GT(largest, 1.3f * kernel.leastRadius());
    EXPECT_GT(kernel.leastRadius(), 0.4f);
}

TEST(InnerKernel, invertedSphereIsFilledAndFacesInward) {
    const InnerKernel kernel(*changed(*sphereMesh(5'000), kStay, kEvery));
    EXPECT_EQ(kernel.state(), State::Filled);
    EXPECT_FALSE(kernel.outward());
    EXPECT_GT(kernel.leastRadius(), 0.99f);
}

TEST(InnerKernel, openMeshesAreNotClosed) {
    EXPECT_EQ(InnerKernel(*squareMesh(1.0f, 0.2f)).state(), State::NotClosed);
    EXPECT_EQ(InnerKernel(*teapotMesh(5'000)).state(), State::NotClosed);
    EXPECT_EQ(InnerKernel(*randomTriangles(11, 400)).state(), State::NotClosed);
    EXPECT_EQ(InnerKernel(*meshOf({}, {})).state(), State::NotClosed);
    const MeshPointer sphere = sphereMesh(5'000);
    const std::vector<uint32_t> most(sphere->indices().begin(), sphere->indices().end() - 3);
    EXPECT_EQ(InnerKernel(*meshOf({sphere->positions().begin(), sphere->positions().end()}, most)).state(), State::NotClosed);
}

TEST(InnerKernel, inconsistentlyOrientedMeshIsNotClosed) {
    const MeshPointer star = starMesh(5, 5'000);
    EXPECT_EQ(InnerKernel(*changed(*star, kStay, [](size_t i) { return i % 7 == 3; })).state(), State::NotClosed);
    EXPECT_EQ(InnerKernel(*changed(*star, kStay, [](size_t i) { return i == 17; })).state(), State::NotClosed);
}

TEST(InnerKernel, centreInNoPartOfTheSolidIsOutside) {
    EXPECT_EQ(InnerKernel(*torusMesh(5'000)).state(), State::CentreOutside);
    EXPECT_EQ(InnerKernel(*bowlMesh(5'000)).state(), State::CentreOutside);
    const MeshPointer sphere = sphereMesh(2'000);
    const auto part = [&](double x) { return changed(*sphere, scaledBy(Vec3(0.4), {x, 0.0, 0.0}), kNone); };
    EXPECT_EQ(InnerKernel(*joined(*part(-0.9), *part(1.3))).state(), State::CentreOutside);
}

TEST(InnerKernel, centreInACavityIsOutside) { EXPECT_EQ(InnerKernel(*shells(kEvery)).state(), State::CentreOutside); }

TEST(InnerKernel, nestedShellsAreFilledUpToTheInnerOne) {
    const InnerKernel kernel(*shells(kNone));
    ASSERT_EQ(kernel.state(), State::Filled);
    EXPECT_TRUE(kernel.outward());
    EXPECT_NEAR(kernel.leastRadius(), 0.5, 0.01);
    Random random(2);
    for (int i = 0; i < 200; ++i) EXPECT_LE(kernel.radiusAround(random.direction()), 0.5f);
}

TEST(InnerKernel, shellOfTwoWallsAgainstEachOtherHasItsCentreOutside) {
    // The outer sphere inward, the inner one outward: the winding number at the centre is 0.
    EXPECT_EQ(InnerKernel(*changed(*shells(kEvery), kStay, kEvery)).state(), State::CentreOutside);
}

TEST(InnerKernel, thinSolidsAreTooThin) {
    EXPECT_EQ(InnerKernel(*boxMesh({-1, -1, -0.01f}, {1, 1, 0.01f})).state(), State::TooThin);
    EXPECT_EQ(InnerKernel(*changed(*sphereMesh(10'000), scaledBy({1e-3, 1.0, 2e-3}), kNone)).state(), State::TooThin);
}

TEST(InnerKernel, surfaceThroughTheCentreLeavesNoKernel) {
    // A box with one wall, and one with an edge, through the centre of the bounding sphere, which a distant box determines.
    const MeshPointer far = boxMesh({-9, -1, -1}, {-8, 1, 1}), other = boxMesh({8, -1, -1}, {9, 1, 1});
    const MeshPointer ends = joined(*far, *other);
    EXPECT_NE(InnerKernel(*joined(*ends, *boxMesh({0, -1, -1}, {2, 1, 1}))).state(), State::Filled);
    EXPECT_NE(InnerKernel(*joined(*ends, *boxMesh({0, 0, -1}, {2, 2, 1}))).state(), State::Filled);
}

TEST(InnerKernel, doesNotDependOnTheNumberOfThreads) {
    const MeshPointer mesh = starMesh(9, 60'000);
    const auto builtBy = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return InnerKernel(*mesh);
    };
    const InnerKernel one = builtBy(1), two = builtBy(2);
    ASSERT_TRUE(one.filled() && two.filled());
    EXPECT_EQ(one.leastRadius(), two.leastRadius());
    for (uint32_t code = 0; code < 1U << (2 * one.level()); ++code) {
        const MapCell cell = mapCell(code, one.level());
        const double size = 1.0 / double(1U << one.level());
        const Vec3 middle = directionAt(MapLayout::Octahedral, Vec2(cell.x + 0.5, cell.y + 0.5) * size);
        ASSERT_EQ(one.radius(cell), two.radius(cell));
        ASSERT_EQ(one.radiusAround(middle), two.radiusAround(middle));
    }
}

}  // namespace
}  // namespace cullscope::test::inner_kernel_test
