// The strategy `oracle`: exactly what is visible, in no more time than drawing it takes.
#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/measure/render_frame.h"
#include "core/visibility/strategy_request.h"
#include "core/visibility/structure_store.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::oracle_test {
namespace {

/// Closed and open bodies, some mirrored, some behind others.
ScenePointer bodies(uint64_t seed) {
    Random random(seed);
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int i = 0; i < 12; ++i) {
        meshes.push_back(i % 3 == 0 ? bowlMesh(400) : i % 3 == 1 ? starMesh(seed + uint64_t(i), 500) : knotMesh(600));
        const double z = random.between(-4, 4), y = random.between(-2, 2), x = random.between(-2, 2);
        places.push_back(translation({x, y, z}) * rotation(random.direction(), random.between(0, 6)) *
                         scaling({i % 4 == 0 ? -0.6 : 0.6, 0.6, 0.6}));
    }
    return sceneOf(std::move(meshes), places);
}

View around(Random& random) {
    const Vec3 eye = random.between(0.5, 9.0) * random.direction();
    return {{eye, random.direction(), random.direction(), Angle::fromDegrees(random.between(30, 90)), 0.05, 50}, {120, 90}};
}

std::vector<uint32_t> trianglesOf(const Scene& scene, const DrawList& list) {
    std::vector<uint32_t> triangles;
    for (const DrawRange& range : list.ranges)
        for (uint32_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            triangles.push_back(uint32_t(scene.firstTriangle(range.instance) + place));
    std::ranges::sort(triangles);
    return triangles;
}

TEST(Oracle, drawsTheVisibleTrianglesAndNothingElse) {
    for (const char* facing : {"auto", "front", "two-sided"})
        for (uint64_t seed = 0; seed < howMany(20, 3); ++seed) {
            const ScenePointer scene = bodies(seed);
            const SceneBuffers buffers(scene, Upload::Vbo);
            const CullerPointer exact = strategyWith("oracle", {{"facing", facing}});
            const CullerPointer objects = strategyWith("oracle", {{"facing", facing}, {"by", "objects"}});
            exact->build(*scene);
            objects->build(*scene);
            EXPECT_EQ(exact->promise(), Promise::Exact);
            EXPECT_EQ(objects->promise(), Promise::Conservative);
            Random random(seed + 99);
            for (int i = 0; i < 6; ++i) {
                const View view = around(random);
                const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, exact->referenceFacing());
                Framebuffer target(view.viewport());
                const FrameLog log = exact->cull(view, Recording::Off, &GlEnvironment::renderer()).log;
                EXPECT_EQ(trianglesOf(*scene, drawnTriangles(*scene, log)), truth.visibleTriangles)
                    << "seed " << seed << " view " << i;
                EXPECT_EQ(log.counters.culledTriangles[size_t(Cause::Hidden)],
                          scene->triangleCount() - truth.visibleTriangles.size());
                const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, log, truth, target);
                EXPECT_EQ(judged.lostPixels(), 0u);
                EXPECT_EQ(judged.accuracy.extraPixels, 0u);
                std::set<size_t> seen, drawn;
                for (const uint32_t triangle : truth.visibleTriangles) seen.insert(scene->instanceOf(triangle));
                const FrameLog whole = objects->cull(view, Recording::Off, &GlEnvironment::renderer()).log;
                for (const DrawRange& range : drawnTriangles(*scene, whole).ranges) {
                    drawn.insert(range.instance);
                    EXPECT_EQ(range.indexCount, scene->meshOf(range.instance).indices().size());
                }
                EXPECT_EQ(drawn, seen);
                EXPECT_EQ(judge(GlEnvironment::renderer(), buffers, whole, truth, target).lostPixels(), 0u);
            }
        }
}

TEST(Oracle, findingWhatIsVisibleIsInNoTimeOfTheFrame) {
    const ScenePointer scene = bodies(1);
    const SceneBuffers buffers(scene, Upload::Vbo);
    StructureStore store;
    const BuiltStrategyPointer oracle =
        buildStrategy("oracle", ParameterSet(findStrategy("oracle").info.parameters), scene, store);
    Random random(7);
    const View view = around(random);
    Framebuffer target(view.viewport());
    GpuFrame frame(GlEnvironment::renderer(), buffers, view, target, {});
    const ViewStatePointer state = oracle->begin();
    const auto start = std::chrono::steady_clock::now();
    oracle->draw(frame, *state);
    const double passed = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GT(frame.untimedMilliseconds(), 0.0);
    const double untimed = frame.untimedMilliseconds(), drawing = frame.drawingMilliseconds();
    const FrameLog log = frame.take();
    // What the parts add up to: no part counts twice, and none is missing but what the clock itself takes.
    EXPECT_LE(log.cullMilliseconds + untimed + drawing, passed);
    EXPECT_GE(log.cullMilliseconds, 0.0);
}

TEST(Oracle, needsOpenGl) {
    const ScenePointer scene = bodies(1);
    StructureStore store;
    const BuiltStrategyPointer oracle =
        buildStrategy("oracle", ParameterSet(findStrategy("oracle").info.parameters), scene, store);
    Random random(7);
    const View view = around(random);
    try {
        (void)oracle->decide(view, *oracle->begin(), false);
        FAIL() << "decided without OpenGL";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::OpenGl);
    }
}

}  // namespace
}  // namespace cullscope::test::oracle_test
