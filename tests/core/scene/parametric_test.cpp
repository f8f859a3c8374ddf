#include "core/mesh/parametric.h"

#include <cmath>

#include "core/base/error.h"

namespace cullscope::parametric_test {
namespace {

struct Shape {
    const char* name;
    MeshPointer (*make)(size_t triangles, const Progress& progress);
    bool closed;
};

MeshPointer star(size_t triangles, const Progress& progress) { return starMesh(7, triangles, progress); }
const std::array<Shape, 6> kShapes{{{"sphere", sphereMesh, true},
                                    {"torus", torusMesh, true},
                                    {"bowl", bowlMesh, true},
                                    {"knot", knotMesh, true},
                                    {"star", star, true},
                                    {"teapot", teapotMesh, false}}};

class Parametric : public testing::TestWithParam<Shape> {};

TEST_P(Parametric, tessellatingEndsAtAStop) {
    std::stop_source source;
    int reports = 0;
    const auto stopAtThird = [&](double, std::string_view) {
        if (++reports == 3) source.request_stop();
    };
    EXPECT_THROW((void)GetParam().make(1'000'000, {stopAtThird, source.get_token()}), Error);
    EXPECT_EQ(reports, 3);
}

TEST_P(Parametric, triangleCountIsNearTheOneAskedFor) {
    for (const size_t asked : {500u, 3000u, 20000u, 100000u}) {
        const MeshPointer mesh = GetParam().make(asked, {});
        EXPECT_NEAR(double(mesh->triangleCount()), double(asked), 0.25 * double(asked)) << asked;
    }
}

TEST_P(Parametric, surfaceIsWholeAndOutward) {
    for (const size_t asked : {100u, 3000u, 20000u}) {
        // With so few triangles the teapot's patches fold onto each other.
        if (asked < 1000 && !GetParam().closed) continue;
        const MeshPointer mesh = GetParam().make(asked, {});
        const Topology& topology = mesh->topology();
        EXPECT_EQ(topology.nonManifoldEdges, 0u) << asked;
        EXPECT_TRUE(topology.consistentlyOriented) << asked;
        EXPECT_TRUE(topology.outward) << asked;
        EXPECT_EQ(topology.closed, GetParam().closed) << asked;
        EXPECT_EQ(topology.boundaryEdges == 0, GetParam().closed) << asked;
    }
}

TEST_P(Parametric, everyTriangleHasArea) {
    for (const size_t asked : {64u, 66u, 100u, 224u, 500u, 5'000u}) {
        const MeshPointer mesh = GetParam().make(asked, {});
        for (size_t i = 0; i < mesh->indices().size(); i += 3) {
            const auto corner = [&](size_t k) { return Vec3(mesh->positions()[mesh->indices()[i + k]]); };
            EXPECT_NE(glm::cross(corner(1) - corner(0), corner(2) - corner(0)), Vec3(0.0)) << asked << ", triangle " << i / 3;
        }
    }
}

TEST_P(Parametric, normalsAreUnitAndPointOutward) {
    const MeshPointer mesh = GetParam().make(20000, {});
    ASSERT_EQ(mesh->normals().size(), mesh->vertexCount());
    std::vector<Vec3> sums(mesh->vertexCount(), Vec3(0.0));
    for (size_t i = 0; i < mesh->indices().size(); i += 3) {
        const auto corner = [&](size_t k) { return mesh->position(mesh->indices()[i + k]); };
        const Vec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        EXPECT_GT(glm::length(face), 0.0) << "triangle " << i / 3 << " has no area";
        for (size_t k = 0; k < 3; ++k) sums[mesh->indices()[i + k]] += face;
    }
    for (size_t v = 0; v < mesh->vertexCount(); ++v) {
        EXPECT_NEAR(glm::length(Vec3(mesh->normals()[v])), 1.0, 1e-5);
        EXPECT_GT(glm::dot(glm::normalize(sums[v]), Vec3(mesh->normals()[v])), 0.8) << "vertex " << v << " against its faces";
        EXPECT_TRUE(std::isfinite(mesh->positions()[v].x) && std::isfinite(mesh->positions()[v].y) &&
                    std::isfinite(mesh->positions()[v].z));
    }
}

TEST_P(Parametric, tooFewOrTooManyTrianglesAreRefused) {
    EXPECT_THROW((void)GetParam().make(0, {}), Error);
    EXPECT_THROW((void)GetParam().make(17, {}), Error);
    EXPECT_THROW((void)GetParam().make(size_t{1} << 32, {}), Error);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Parametric, testing::ValuesIn(kShapes), [](const auto& shape) { return shape.param.name; });

TEST(ParametricShape, sphereAndTorusHaveTheirSizes) {
    const MeshPointer sphere = sphereMesh(2000);
    for (size_t v = 0; v < sphere->vertexCount(); ++v) EXPECT_NEAR(glm::length(sphere->position(v)), 1.0, 1e-6);
    const MeshPointer torus = torusMesh(2000);
    for (size_t v = 0; v < torus->vertexCount(); ++v) {
        const Vec3 p = torus->position(v);
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 1.0, p.y), 0.25, 1e-6) << "the axis is y";
    }
}

TEST(ParametricShape, starIsStarShapedAndFollowsItsSeed) {
    const MeshPointer mesh = starMesh(3, 5000);
    for (size_t i = 0; i < mesh->indices().size(); i += 3) {
        const auto corner = [&](size_t k) { return mesh->position(mesh->indices()[i + k]); };
        EXPECT_GT(glm::dot(corner(0), glm::cross(corner(1), corner(2))), 0.0)
            << "triangle " << i / 3 << " turns its back to the origin";
    }
    EXPECT_TRUE(std::ranges::equal(starMesh(3, 5000)->positions(), mesh->positions()));
    EXPECT_FALSE(std::ranges::equal(starMesh(4, 5000)->positions(), mesh->positions()));
    for (size_t v = 0; v < mesh->vertexCount(); ++v) EXPECT_NEAR(glm::length(mesh->position(v)), 1.0, 0.45 + 1e-6);
}

TEST(ParametricShape, teapotStandsUpright) {
    // Handle and spout along x (6.4 and more), the body's width 4 along z, and 3.15 high.
    const Vec3 size = 2.0 * teapotMesh(20000)->localBounds().halfExtent();
    EXPECT_NEAR(size.y, 3.15, 0.01);
    EXPECT_NEAR(size.z, 4.0, 0.02);
    EXPECT_GT(size.x, 6.0);
}

}  // namespace
}  // namespace cullscope::parametric_test
