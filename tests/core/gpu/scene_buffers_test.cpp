#include "core/gpu/scene_buffers.h"

#include <epoxy/gl.h>

#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/scene/hidden.h"
#include "core/scene/split_scene.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::scene_buffers_test {
namespace {

constexpr Viewport kSize{160, 120};

size_t covered(const Picture& picture) {
    return picture.depth.size() - size_t(std::count(picture.depth.begin(), picture.depth.end(), 0.0f));
}

ScenePointer threeBodies() {
    return sceneOf({sphereMesh(500), knotMesh(2000), squareMesh(0.5, 0)},
                   {translation({-3, 0, 0}), Mat4(1.0), translation({3, 0, 0})});
}

/// A fan of that many vertices over a half circle that faces +z.
MeshPointer fanOf(size_t vertices) {
    TriangleMesh::Data data;
    data.name = "fan";
    data.positions.push_back(Vec3f(0.0f));
    for (size_t i = 1; i < vertices; ++i) {
        const double angle = 3.14159265358979 * double(i - 1) / double(vertices - 2);
        data.positions.push_back(Vec3f(Vec3(std::cos(angle), std::sin(angle), 0.0)));
    }
    for (uint32_t i = 1; i + 1 < vertices; ++i) data.indices.insert(data.indices.end(), {0, i, i + 1});
    return std::make_shared<TriangleMesh>(std::move(data));
}

TEST(SceneBuffers, indicesOf16BitsReach65536VerticesAndDrawTheSame) {
    const Camera camera{Vec3(0, 0, 3), Vec3(0, 0, 0), Vec3(0, 1, 0), Angle::fromDegrees(45), 1, 10};
    std::vector<size_t> coveredPixels;
    for (const Upload upload : {Upload::Vbo, Upload::VertexArray})
        for (const size_t vertices : {size_t{65'536}, size_t{65'537}}) {
            const ScenePointer scene = copiesOf(fanOf(vertices), {Mat4(1.0)});
            const SceneBuffers buffers(scene, upload);
            const unsigned bytes = upload == Upload::Vbo && vertices == 65'536 ? 2 : 4;
            EXPECT_EQ(buffers.mesh(0).whole.bytes, bytes);
            EXPECT_EQ(buffers.ownOrder(0).bytes, bytes);
            const DrawList all = everything(*scene, Facing::Front);
            coveredPixels.push_back(covered(picture(buffers, View(camera, kSize), all)));
            DrawList half = all;
            half.ranges[0].indexCount = half.ranges[0].indexCount / 6 * 3;
            EXPECT_NEAR(double(covered(picture(buffers, View(camera, kSize), half))), double(coveredPixels.back()) / 2, 40.0);
        }
    EXPECT_GT(coveredPixels[0], 1500u);
    EXPECT_EQ(coveredPixels, std::vector<size_t>(4, coveredPixels[0]));
}

TEST(SceneBuffers, hidingUploadsNothingAgainAndDrawsTheRest) {
    const ScenePointer scene = threeBodies();
    const View view(overviewCamera(*scene, 4.0 / 3), kSize);
    const SceneBuffers all(scene, Upload::Vbo);
    for (const std::vector<bool>& hidden : {std::vector{true, false, false}, std::vector{false, true, false}}) {
        const ScenePointer rest = withoutInstances(scene, hidden);
        const SceneBuffers shared(rest, all);
        EXPECT_EQ(&shared.scene(), rest.get());
        for (size_t mesh = 0; mesh < 3; ++mesh) {
            EXPECT_EQ(shared.mesh(mesh).vertices, all.mesh(mesh).vertices);
            EXPECT_EQ(shared.mesh(mesh).whole.buffer, all.mesh(mesh).whole.buffer);
        }
        const Picture sharing = picture(shared, view, everything(*rest, Facing::TwoSided));
        EXPECT_EQ(sharing, picture(rest, view, Facing::TwoSided));
        EXPECT_NE(sharing, picture(all, view, everything(*scene, Facing::TwoSided)));
    }
}

TEST(SceneBuffers, goWithTheLastOfThoseWhoShare) {
    const ScenePointer scene = threeBodies();
    const ScenePointer rest = withoutInstances(scene, {true});
    const View view(overviewCamera(*scene, 4.0 / 3), kSize);
    auto first = std::make_unique<SceneBuffers>(scene, Upload::Vbo);
    const unsigned buffer = first->mesh(0).vertices;
    auto second = std::make_unique<SceneBuffers>(rest, *first);
    auto third = std::make_unique<SceneBuffers>(scene, *second);
    first.reset();
    EXPECT_TRUE(glIsBuffer(buffer));
    const Picture drawn = picture(*third, view, everything(*scene, Facing::Front));
    EXPECT_GT(covered(drawn), 1000u);
    EXPECT_EQ(drawn, picture(scene, view, Facing::Front));
    third.reset();
    EXPECT_TRUE(glIsBuffer(buffer));
    second.reset();
    EXPECT_FALSE(glIsBuffer(buffer));
}

TEST(SceneBuffers, everythingHiddenDrawsNothing) {
    const ScenePointer scene = threeBodies();
    const ScenePointer empty = withoutInstances(scene, {true, true, true});
    const SceneBuffers all(scene, Upload::Vbo);
    const SceneBuffers none(empty, all);
    const View view(overviewCamera(*empty, 4.0 / 3), kSize);
    const DrawList list = everything(*empty, Facing::TwoSided);
    EXPECT_EQ(covered(picture(none, view, list)), 0u);
    EXPECT_THAT(GlEnvironment::renderer().drawItemBuffer(none, view, list).triangle, testing::Each(0u));
    const ScenePointer nothing = std::make_shared<Scene>("nothing", std::vector<MeshPointer>{}, std::vector<Instance>{});
    EXPECT_EQ(covered(picture(nothing, view, Facing::TwoSided)), 0u);
}

TEST(SplitPicture, isThatOfTheWhole) {
    // Also far from the origin: parts keep the mesh's origin, so that they are rounded equally.
    const Mat4 place = translation({2.5, 0, 1}) * scaling({-1, 1, 0.5});
    for (const Vec3& origin : {Vec3(0.0), Vec3(4e6, -2e6, 100.0625)})
        for (const MeshPointer& mesh : {knotMesh(30'000), starMesh(7, 20'000), teapotMesh(8'000)}) {
            const MeshPointer there = withOrigin(*mesh, origin);
            const ScenePointer scene = sceneOf({there, there}, {translation(-origin), place * translation(-origin)});
            for (const SplitRule& rule : {SplitRule{}, SplitRule{SplitRule::By::Clusters, 500}}) {
                const ScenePointer split = splitScene(*scene, "split", rule);
                EXPECT_EQ(split->triangleCount(), scene->triangleCount());
                for (const CameraPath::Pose& pose : cameraPath("fibonacci:5", *scene).poses) {
                    Camera camera{pose.eye, pose.target, pose.up};
                    fitDepthRange(camera, *scene);
                    const Picture whole = picture(scene, View(camera, kSize), Facing::TwoSided);
                    EXPECT_GT(covered(whole), kSize.width * kSize.height / 20u) << mesh->name();
                    EXPECT_EQ(picture(split, View(camera, kSize), Facing::TwoSided), whole) << mesh->name();
                }
            }
        }
}

}  // namespace
}  // namespace cullscope::test::scene_buffers_test
