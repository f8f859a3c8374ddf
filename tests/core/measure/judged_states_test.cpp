// Verdicts agree with the count of lost pixels: what the raster's snapping explains is neither lost nor wrongly culled.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/random.h"
#include "core/measure/accuracy.h"
#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::judged_states_test {
namespace {

TEST(JudgedStates, aTriangleIsWronglyCulledOnlyWhereItLostAPixelBeyondSnapping) {
    // Front faces alone beside a truth of both sides: a closed mesh loses nothing beyond snapping, a square seen from behind all.
    uint64_t explained = 0;
    Random random(9);
    for (const MeshPointer& mesh : {starMesh(7, 20000), knotMesh(20000), squareMesh(1, -1)}) {
        const ScenePointer scene = sceneOf({mesh});
        const SceneBuffers buffers(scene, Upload::Vbo);
        for (int i = 0; i < 6; ++i) {
            const Vec3 eye = 4.0 * random.direction();
            const Camera camera{eye, Vec3(0.0), {0.1, 1, 0.2}, Angle::fromDegrees(45), 0.1, 100};
            FrameLog log;
            log.camera = camera;
            log.size = {160, 120};
            log.facing = Facing::Front;
            log.commands = {everything(*scene, Facing::Front)};
            Renderer& renderer = GlEnvironment::renderer();
            const Reference truth = itemBufferReference(renderer, buffers, View(camera, log.size), Facing::TwoSided);
            Framebuffer target(log.size);
            const JudgedFrame judged = judge(renderer, buffers, log, truth, target);
            const TriangleStates states = judgedStates(renderer, buffers, log, Facing::TwoSided);
            ASSERT_TRUE(judged.missedBeyondSnapping && judged.lostTriangles);
            EXPECT_EQ(states.counts[size_t(TriangleState::WronglyCulled)], judged.lostTriangles->size());
            EXPECT_EQ(judged.lostTriangles->empty(), judged.lostPixels() == 0) << eye.x << ' ' << eye.y << ' ' << eye.z;
            for (const uint32_t triangle : states.withinSnapping) {
                EXPECT_EQ(states.states[triangle], TriangleState::BackFacing) << mesh->name() << ' ' << triangle;
                EXPECT_TRUE(std::ranges::binary_search(truth.visibleTriangles, triangle));
            }
            // None is counted twice, and none is forgotten.
            EXPECT_EQ(states.counts[size_t(TriangleState::Visible)] + states.counts[size_t(TriangleState::WronglyCulled)] +
                          states.withinSnapping.size(),
                      truth.visibleTriangles.size());
            explained += states.withinSnapping.size();
        }
    }
    EXPECT_GT(explained, 0u) << "else nothing was tried";
}

}  // namespace
}  // namespace cullscope::test::judged_states_test
