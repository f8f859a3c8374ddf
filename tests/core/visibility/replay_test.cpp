// Replays of parts of frames whose strategies make what they show: own triangles in an order, or a finished picture.

#include "core/frame/decided_ahead.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"

namespace cullscope::test::replay_test {
namespace {

FrameLog recordedQuiz(const char* id) {
    const ScenePointer scene = openScene("quiz").scene;
    const CullerPointer culler = makeCuller(id);
    culler->build(*scene);
    return culler->cull(View(overviewCamera(*scene, 4.0 / 3.0), {96, 72}), Recording::On, &GlEnvironment::renderer()).log;
}

size_t pixelsOf(const FinishedPicture& picture) {
    return size_t(std::ranges::count_if(picture.triangle, [](uint32_t item) { return item != 0; }));
}

TEST(Replay, ofOwnTrianglesHasThoseThatWereNamedSoFarInTheirOrder) {
    for (const char* id : {"painter", "bsp"}) {
        SCOPED_TRACE(id);
        const FrameLog log = recordedQuiz(id);
        ASSERT_EQ(log.commands.size(), 1u);
        const OwnTriangles& all = *std::get<OwnTrianglesPointer>(log.commands.front());
        size_t named = 0;
        for (size_t k = 0; k < log.entries(); ++k) {
            const FrameLog part = replayUpTo(log, k);
            if (k > 0 && log.decisions[k - 1].subject.kind == Subject::Kind::Fragment)
                named = std::max(named, size_t(log.decisions[k - 1].places.first + log.decisions[k - 1].places.count));
            ASSERT_EQ(part.commands.size(), named > 0 ? 1u : 0u);
            if (named == 0) continue;
            const OwnTriangles& shown = *std::get<OwnTrianglesPointer>(part.commands.front());
            ASSERT_EQ(shown.triangles.size(), named);
            EXPECT_TRUE(std::equal(shown.triangles.begin(), shown.triangles.end(), all.triangles.begin()));
            EXPECT_EQ(shown.positions.size(), 3 * named);
            size_t inRuns = 0;
            for (const OwnTriangles::Run& run : shown.runs) inRuns += run.count;
            EXPECT_EQ(inRuns, named);
        }
        EXPECT_EQ(named, all.triangles.size()) << "every triangle was named before the command";
        EXPECT_EQ(std::get<OwnTrianglesPointer>(replayUpTo(log, log.entries()).commands.front()),
                  std::get<OwnTrianglesPointer>(log.commands.front()));
    }
}

TEST(Replay, ofAFinishedPictureHasThePixelsThatWereNamedSoFar) {
    const FrameLog log = recordedQuiz("scan-line");
    ASSERT_EQ(log.commands.size(), 1u);
    const FinishedPicture& all = *std::get<FinishedPicturePointer>(log.commands.front());
    size_t before = 0, steps = 0;
    for (size_t k = 0; k < log.entries(); ++k) {
        const FrameLog part = replayUpTo(log, k);
        if (part.commands.empty()) continue;
        const FinishedPicture& shown = *std::get<FinishedPicturePointer>(part.commands.front());
        for (size_t pixel = 0; pixel < all.triangle.size(); ++pixel) {
            if (shown.triangle[pixel] == 0) continue;
            ASSERT_EQ(shown.triangle[pixel], all.triangle[pixel]);
            ASSERT_EQ(shown.depth[pixel], all.depth[pixel]);
        }
        const size_t now = pixelsOf(shown);
        EXPECT_GE(now, before);
        steps += now > before ? 1 : 0;
        before = now;
    }
    EXPECT_EQ(before, pixelsOf(all)) << "every pixel was named before the command";
    EXPECT_GT(steps, 1u) << "the picture comes in parts";
}

TEST(Replay, ofADepthBufferDrawsTheTrianglesThatWereDrawnSoFar) {
    const ScenePointer scene = openScene("quiz").scene;
    const FrameLog log = recordedQuiz("depth-buffer");
    const FinishedPicture& all = *std::get<FinishedPicturePointer>(log.commands.front());
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(log.camera, log.size);
    std::vector<float> before(all.depth.size(), 0.0f);
    uint64_t named = 0;
    for (size_t k = 0; k < log.decisions.size(); ++k) {
        const Decision& decision = log.decisions[k];
        if (decision.subject.kind != Subject::Kind::Triangles || decision.outcome != Decision::Outcome::Drawn) continue;
        const FrameLog part = replayUpTo(log, k + 1);
        EXPECT_EQ(std::get<DrawList>(part.commands.at(0)).triangleCount(), ++named);
        const Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, part, {0, 0, log.size});
        // Where it is nearer, and at no other sample, its depth is stored, as the decision counts it.
        const auto number = uint32_t(scene->firstTriangle(decision.subject.object) + decision.places.first) + 1;
        uint64_t written = 0, first = 0;
        for (size_t pixel = 0; pixel < before.size(); ++pixel) {
            if (items.depth[pixel] == before[pixel]) continue;
            EXPECT_EQ(items.triangle[pixel], number);
            EXPECT_GT(items.depth[pixel], before[pixel]);
            ++written;
            first += before[pixel] == 0.0f ? 1 : 0;
        }
        EXPECT_EQ(written, uint64_t(decision.operands[0]));
        EXPECT_EQ(first, uint64_t(decision.operands[1]));
        EXPECT_GT(decision.operands[2], decision.operands[3]);
        before = items.depth;
    }
    EXPECT_GE(named, 6u);
    EXPECT_EQ(before, all.depth) << "the last step shows the frame";
}

}  // namespace
}  // namespace cullscope::test::replay_test
