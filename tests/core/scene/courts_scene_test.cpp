#include "core/scene/courts_scene.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/scene/scene_rays.h"
#include "core/scene/scene_source.h"

namespace cullscope::test::courts_scene_test {
namespace {

ScenePointer courts(const std::string& specification) { return openScene(specification).scene; }

TEST(Courts, areCopiesThatShareMeshesAndBeginWithTheOneInItsOwnPlace) {
    const ScenePointer one = courts("plant:pipelines=2"), four = courts("courts:mesh=plant:pipelines=2,n=2");
    const size_t court = objectsOfACourt(*one, {});
    ASSERT_EQ(court, one->instances().size() + 4);
    ASSERT_EQ(four->instances().size(), 4 * court);
    EXPECT_EQ(four->meshes().size(), one->meshes().size() + 1) << "the wall";
    EXPECT_EQ(four->triangleCount(), 4 * (one->triangleCount() + 4 * 12));
    EXPECT_EQ(four->upAxis(), one->upAxis());
    for (size_t i = 0; i < one->instances().size(); ++i) {
        EXPECT_EQ(four->instances()[i].worldFromMesh, one->instances()[i].worldFromMesh);
        EXPECT_EQ(four->instances()[i].name, one->instances()[i].name);
        EXPECT_EQ(four->partsOf(court + i).size(), one->partsOf(i).size()) << "a copy is of the same primitives";
    }
    const ScenePointer first = firstCourt(*four, 2);
    EXPECT_EQ(first->instances().size(), court);
    EXPECT_EQ(first->bounds().min, courts("courts:mesh=plant:pipelines=2,n=1")->bounds().min);
}

TEST(Courts, lieBesideEachOther) {
    for (const char* mesh : {"plant:pipelines=2", "torus:triangles=200", "teapot:triangles=1000"}) {
        const ScenePointer nine = courts(std::string("courts:n=3,mesh=") + mesh);
        const size_t court = nine->instances().size() / 9;
        std::vector<Box3> boxes(9);
        for (size_t i = 0; i < nine->instances().size(); ++i) {
            boxes[i / court].add(nine->instanceBox(i).min);
            boxes[i / court].add(nine->instanceBox(i).max);
        }
        const int up = nine->upAxis() == UpAxis::Z ? 2 : 1;
        for (size_t a = 0; a < 9; ++a)
            for (size_t b = a + 1; b < 9; ++b) {
                bool apart = false;
                for (int axis = 0; axis < 3; ++axis)
                    apart = apart ||
                            (axis != up && (boxes[a].max[axis] < boxes[b].min[axis] || boxes[b].max[axis] < boxes[a].min[axis]));
                EXPECT_TRUE(apart) << mesh << ", courts " << a << " and " << b;
            }
    }
}

TEST(Courts, hideEachOtherFromBelowTheTopOfTheirWalls) {
    const ScenePointer nine = courts("courts:mesh=plant:pipelines=2,n=3");
    const size_t court = nine->instances().size() / 9;
    const SceneRays rays(*nine, nine->bounds().centre());
    const ScenePointer one = courts("plant:pipelines=2");
    size_t hits = 0;
    for (int i = 0; i < 4'000; ++i) {
        // Places spread over the scene within the walls, directions over the sphere, by Kronecker sequences.
        const auto at = [i](double step) { return std::fmod(0.5 + step * i, 1.0); };
        const Vec3 share(at(0.8191725134), at(0.6710436067), at(0.5497004779));
        const Vec3 eye = one->bounds().min + share * (one->bounds().max - one->bounds().min);
        const double z = 2.0 * at(0.7548776662) - 1.0, turn = 6.283185307 * at(0.5698402910);
        const Vec3 direction(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z);
        const auto hit = rays.first(eye, direction);
        if (!hit) continue;
        ++hits;
        EXPECT_LT(hit->instance, court) << i;
    }
    EXPECT_GT(hits, 1'000u) << "of rays that hit anything";
}

TEST(Courts, mayHaveNoWallsAndRefuseWhatIsNone) {
    EXPECT_EQ(courts("courts:mesh=torus:triangles=200,n=2,walls=0")->instances().size(), 4u);
    EXPECT_EQ(courts("courts:mesh=layers:count=1,triangles=2,n=1")->meshes().size(), 2u);
    EXPECT_THROW((void)courts("courts:n=0"), Error);
    EXPECT_THROW((void)courts("courts:n=1001"), Error);
    EXPECT_THROW((void)courts("courts:walls=-1"), Error);
    EXPECT_THROW((void)courts("courts:mesh=gone.obj"), Error);
    EXPECT_THROW((void)courts("courts:mesh=plant:pipelines=1e5,n=1000"), Error) << "more objects than memory";
}

TEST(Courts, wallsAreClosedAndFaceOutward) {
    const ScenePointer one = courts("courts:mesh=torus:triangles=200,n=1");
    for (size_t i = 1; i < one->instances().size(); ++i) EXPECT_TRUE(one->frontFacesSuffice(i)) << i;
}

}  // namespace
}  // namespace cullscope::test::courts_scene_test
