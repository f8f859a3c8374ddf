// A scene whose objects are all hidden: there is nothing to cull, draw or compare, and every operation must still work.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/measure/accuracy.h"
#include "core/measure/meter.h"
#include "core/measure/ray_reference.h"
#include "core/measure/render_frame.h"
#include "core/scene/hidden.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::empty_scene_test {
namespace {

constexpr Viewport kSize{40, 30};

ScenePointer emptyScene() { return withoutInstances(sceneOf({boxMesh(Vec3f(0), Vec3f(1)), squareMesh(1, 0)}), {true, true}); }

TEST(EmptyScene, strategiesSubmitAndLoseNothing) {
    const ScenePointer scene = emptyScene();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(overviewCamera(*scene, 4.0 / 3), kSize);
    Framebuffer target(kSize);
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id, ParameterSet(registered.info.parameters));
        strategy->build(*scene);
        EXPECT_EQ(strategy->cull(view, Recording::On, &GlEnvironment::renderer()).consideredTriangles, 0u) << registered.info.id;
        (void)strategy->promiseAt(view);
        const FrameResult frame =
            renderFrame(GlEnvironment::renderer(), buffers, *strategy->built(), strategy->state(), view, target);
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy->referenceFacing());
        EXPECT_EQ(reference.coveredPixels, 0u);
        const Accuracy accuracy = compare(reference, {target.readDepth(), {}}, drawnTriangles(*scene, frame.log), *scene);
        EXPECT_EQ(accuracy.missedPixels + accuracy.extraPixels + accuracy.submittedTriangles + accuracy.visibleTriangles, 0u)
            << registered.info.id;
    }
}

TEST(EmptyScene, raysHitNothing) {
    const ScenePointer scene = emptyScene();
    const View view(overviewCamera(*scene, 4.0 / 3), kSize);
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) EXPECT_EQ(rayReference(*scene, view, facing).coveredPixels, 0u);
}

TEST(EmptyScene, measurementIsRefused) {
    MeasureRequest request;
    request.scene = emptyScene();
    request.strategies = {{"all", ParameterSet(findStrategy("all").info.parameters)}};
    request.path = cameraPath("orbit:2", *request.scene);
    request.size = kSize;
    try {
        (void)measure(request);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
    }
}

}  // namespace
}  // namespace cullscope::test::empty_scene_test
