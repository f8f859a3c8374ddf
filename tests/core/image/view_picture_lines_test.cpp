// Lines in the pictures of views: boxes and the frustum.
#include <gtest/gtest.h>

#include "core/image/view_picture.h"
#include "tests/core/image/shown_picture.h"
#include "tests/support/decisions.h"
#include "tests/support/grouped_frustum.h"

namespace cullscope::test::view_picture_lines_test {
namespace {

TEST(ViewPicture, everyObjectHasItsBox) {
    const ScenePointer scene = field(45);
    const View culling(inTheField(), {320, 240});
    Camera camera = above();
    camera.eye = {0, 150, 1};
    camera.farDistance = 1000;
    const View observer(camera, {900, 900});
    const auto palette = verdictPalette(kLight.background);
    const Shown look = shown(scene, "frustum", culling, observer, {"boxes"}, kLight);
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const Culled frame = frustum->cull(culling, Recording::On);
    const StructureSnapshot snapshot = frustum->snapshot(frame.log);
    ASSERT_GT(snapshot.nodes.size(), 2000u);
    size_t culled = 0;
    for (const SnapshotNode& node : snapshot.nodes) {
        // The middles of the four upper edges, which the observer sees from above.
        const Vec3f colour = palette[size_t(node.culled ? TriangleState::OutsideFrustum : TriangleState::Visible)].colour;
        const Vec3 centre = node.box.centre(), half = node.box.halfExtent();
        for (const Vec3& edge : {Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(0, 1, 1), Vec3(0, 1, -1)})
            ASSERT_TRUE(look.near(observer, centre + half * edge, colour)) << "instance " << node.instance;
        culled += node.culled ? 1 : 0;
    }
    EXPECT_GT(culled, 1000u);
    EXPECT_LT(culled, 2025u);
}

TEST(ViewPicture, boxesOfObjectsNotYetDecidedHaveTheirOwnColour) {
    const ScenePointer scene = field(10);
    const View culling(inTheField(), {320, 240});
    Camera camera = above();
    camera.eye = {0, 40, 1};
    const View observer(camera, {900, 900});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const Culled frame = frustum->cull(culling, Recording::On);
    const auto picture = [&](const FrameLog& log, const ViewLook& boxes) {
        Framebuffer target(observer.viewport());
        drawViewPicture(GlEnvironment::renderer(), buffers, *frustum->built(), log, observer, nullptr, boxes, kLight, target);
        return Shown{target.readColour(), target.readDepth(), observer.viewport()};
    };
    const auto palette = verdictPalette(kLight.background);
    // The last test of the whole batch: all objects were tested, and none is drawn yet.
    size_t tests = 0;
    while (frame.log.decisions[tests].outcome == Decision::Outcome::Open) ++tests;
    ASSERT_GT(tests, 20u);
    for (const ViewLook& boxes : {ViewLook{"boxes"}, ViewLook{"boxes", "planes"}}) {
        const Shown part = picture(frame.log.upTo(tests), boxes);
        EXPECT_EQ(part.count(palette[size_t(TriangleState::Visible)].colour), 0u);
        EXPECT_GT(part.count(palette[size_t(TriangleState::Undecided)].colour), 500u);
        const Shown whole = picture(frame.log, boxes);
        EXPECT_GT(whole.count(palette[size_t(TriangleState::Visible)].colour), 500u);
    }
}

TEST(ViewPicture, testedGroupsHaveTheirBoxes) {
    const ScenePointer scene = field(20);
    const View culling(inTheField(), {320, 240});
    Camera camera = above();
    camera.eye = {0, 70, 1};
    camera.farDistance = 1000;
    const View observer(camera, {900, 900});
    const SceneBuffers buffers(scene, Upload::Vbo);
    GroupedCuller strategy;
    strategy.build(*scene);
    const Culled frame = strategy.cull(culling, Recording::On);
    Framebuffer target(observer.viewport());
    drawViewPicture(GlEnvironment::renderer(), buffers, *strategy.built(), frame.log, observer, nullptr, {"boxes"}, kLight,
                    target);
    const Shown look{target.readColour(), target.readDepth(), observer.viewport()};
    std::array<int, 2> seen{};
    for (const VisitedGroup& group : visitedGroups(frame.log)) {
        const bool culled = group.containment == Containment::Outside;
        const auto colour =
            verdictPalette(kLight.background)[size_t(culled ? TriangleState::OutsideFrustum : TriangleState::Visible)].colour;
        // Between the first object and the second along the upper edge, where only groups have lines; of nested groups the inner
        // one's line is visible.
        const InstanceOctree::Node& node = strategy.octree().nodes()[group.node];
        if (node.box.max.x - node.box.min.x < 4 || (group.containment == Containment::Straddles && !node.leaf())) continue;
        EXPECT_TRUE(look.near(observer, {node.box.min.x + 2.25, node.box.max.y, node.box.max.z}, colour)) << group.node;
        ++seen[culled ? 1 : 0];
    }
    EXPECT_GT(seen[0], 3);
    EXPECT_GT(seen[1], 3);
}

TEST(ViewPicture, frustumIsWhereTheCameraLooks) {
    // A scene of one small sphere, so that nothing hides the lines; the far plane is cut to it.
    const ScenePointer scene = sceneOf({sphereMesh(80)}, {translation({0, 0, -8}) * scaling(Vec3(.2))});
    Camera camera = downMinusZ();
    camera.nearDistance = 2;
    camera.farDistance = 1e6;
    const View culling(camera, {200, 200});
    const View observer({{25, 9, -4}, {0, 0, -4}, {0, 1, 0}, Angle::fromDegrees(70), 0.1, 26}, {400, 400});
    for (const DrawStyle& style : {kLight, DrawStyle{}}) {
        const Shown look = shown(scene, "frustum", culling, observer, {"frustum"}, style);
        const Vec3f lines = contrastTo(style.background);
        const double far = -scene->bounds().min.z;
        for (const double side : {-1.0, 1.0})
            for (const double t : {0.0, 0.3, 0.7, 1.0}) {
                EXPECT_TRUE(look.near(observer, {side * 2, (2 * t - 1) * 2, -2}, lines)) << "near rectangle";
                EXPECT_TRUE(look.near(observer, {(2 * t - 1) * far, side * far, -far}, lines)) << "far rectangle";
                const double depth = 2 + t * (far - 2);
                EXPECT_TRUE(look.near(observer, {side * depth, depth, -depth}, lines)) << "edge at " << depth;
                EXPECT_TRUE(look.near(observer, {side * depth, -depth, -depth}, lines)) << "edge at " << depth;
            }
        EXPECT_TRUE(look.near(observer, culling.eye(), lines)) << "the eye";
        EXPECT_FALSE(look.near(observer, {0, 0, -12}, lines));
        // Beyond the observer's far plane; seen from its own camera the frustum has no lines.
        EXPECT_EQ(shown(scene, "frustum", culling, culling, {"frustum"}, style).colour,
                  shown(scene, "frustum", culling, culling, {}, style).colour);
    }
}

}  // namespace
}  // namespace cullscope::test::view_picture_lines_test
