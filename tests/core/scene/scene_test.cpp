#include "core/scene/scene.h"

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::scene_test {
namespace {

TEST(Scene, everyTriangleHasItsInstance) {
    const ScenePointer scene =
        sceneOf({squareMesh(1, 0), meshOf({{0, 0, 0}}, {}), boxMesh(Vec3f(0), Vec3f(1)), squareMesh(1, 1)});
    EXPECT_EQ(scene->triangleCount(), 16u);
    const std::array<size_t, 4> counts{2, 0, 12, 2};
    uint64_t number = 0;
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(scene->firstTriangle(i), number);
        for (size_t t = 0; t < counts[i]; ++t) EXPECT_EQ(scene->instanceOf(number++), i);
    }
}

TEST(Scene, boundsHoldEveryVertex) {
    Random random(41);
    const MeshPointer star = starMesh(5, 400);
    for (int i = 0; i < 200; ++i) {
        const Vec3 offset = random.direction() * std::pow(10.0, random.between(-2, 7));
        Mat4 place(1.0);
        for (int column = 0; column < 3; ++column)
            place[column] = Vec4(random.direction() * std::pow(10.0, random.between(-2, 2)), 0.0);
        place[3] = Vec4(random.direction() * std::pow(10.0, random.between(-2, 7)), 1.0);
        const ScenePointer scene = sceneOf({withOrigin(*star, offset), star}, {place, place});
        for (size_t instance = 0; instance < 2; ++instance) {
            const TriangleMesh& mesh = scene->meshOf(instance);
            const Box3& box = scene->instanceBox(instance);
            const Sphere& sphere = scene->instanceSphere(instance);
            for (size_t v = 0; v < mesh.vertexCount(); ++v) {
                std::array<long double, 3> world{};
                long double squared = 0, squaredFromAll = 0;
                for (int row = 0; row < 3; ++row) {
                    long double& coordinate = world[size_t(row)];
                    coordinate = place[3][row];
                    for (int axis = 0; axis < 3; ++axis)
                        coordinate += static_cast<long double>(place[axis][row]) *
                                      (static_cast<long double>(mesh.origin()[axis]) + mesh.positions()[v][axis]);
                    ASSERT_LE(static_cast<long double>(box.min[row]), coordinate);
                    ASSERT_GE(static_cast<long double>(box.max[row]), coordinate);
                    ASSERT_LE(static_cast<long double>(scene->bounds().min[row]), coordinate);
                    const long double off = coordinate - sphere.centre[row];
                    const long double offAll = coordinate - scene->boundingSphere().centre[row];
                    squared += off * off;
                    squaredFromAll += offAll * offAll;
                }
                ASSERT_LE(std::sqrt(squared), static_cast<long double>(sphere.radius));
                ASSERT_LE(std::sqrt(squaredFromAll), static_cast<long double>(scene->boundingSphere().radius) * (1 + 1e-12L));
            }
        }
    }
}

TEST(Scene, hashFollowsWhatIsDrawn) {
    const MeshPointer square = squareMesh(1, 0);
    const std::string plain = sceneOf({square})->sha256();
    EXPECT_EQ(plain.size(), 64u);
    EXPECT_EQ(sceneOf({squareMesh(1, 0)})->sha256(), plain);
    EXPECT_NE(sceneOf({square}, {translation({0, 0, 1e-9})})->sha256(), plain);
    EXPECT_NE(sceneOf({squareMesh(1, 1e-6f)})->sha256(), plain);
    EXPECT_NE(sceneOf({withOrigin(*square, {1e-9, 0, 0})})->sha256(), plain);
    EXPECT_NE(copiesOf(square, {Mat4(1.0), Mat4(1.0)})->sha256(), plain);
    EXPECT_NE(sceneOf({meshOf({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 1})})->sha256(), plain);
}

TEST(Scene, frontFacesSufficeForClosedOutwardMeshesOnly) {
    EXPECT_TRUE(sceneOf({boxMesh(Vec3f(-1), Vec3f(1)), sphereMesh(80)})->frontFacesSuffice());
    EXPECT_FALSE(sceneOf({boxMesh(Vec3f(-1), Vec3f(1)), squareMesh(1, 0)})->frontFacesSuffice());
    EXPECT_FALSE(sceneOf({boxMesh(Vec3f(1), Vec3f(-1))})->frontFacesSuffice()) << "turned inside out by three reflections";
}

TEST(Scene, emptySceneHasNoBounds) {
    const Scene scene("empty", {}, {});
    EXPECT_EQ(scene.triangleCount(), 0u);
    EXPECT_TRUE(scene.bounds().empty());
    EXPECT_EQ(scene.boundingSphere().radius, 0.0);
}

}  // namespace
}  // namespace cullscope::test::scene_test
