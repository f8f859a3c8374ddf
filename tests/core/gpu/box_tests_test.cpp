#include "core/base/error.h"
#include "core/geometry/random.h"
#include "core/gpu/gpu_frame.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

// OpenGL's tests of boxes; the cases of the battery of extremes keep their numbers: camera at the origin looking down −z, 90°,
// aspect 1, near 0.1, far 10 unless stated.

namespace cullscope::test::box_tests_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

View standardView(const Viewport& size = {100, 100}) {
    return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, size};
}

EyeBox box(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

/// Boxes in view; left, right, above, below; in front of near; behind the eye; beyond far; cut by a side; and flat ones in view,
/// seen edge-on and not.
const std::vector<EyeBox> kAround{
    box({-1, -1, -6}, {1, 1, -4}), box({-9, -1, -6}, {-7, 1, -4}),  box({7, -1, -6}, {9, 1, -4}),
    box({-1, 7, -6}, {1, 9, -4}),  box({-1, -9, -6}, {1, -7, -4}),  box({-.01, -.01, -.06}, {.01, .01, -.05}),
    box({-1, -1, 4}, {1, 1, 6}),   box({-1, -1, -16}, {1, 1, -14}), box({4, -1, -6}, {9, 1, -4}),
    box({-1, 0, -6}, {1, 0, -4}),  box({-1, -1, -5}, {1, 1, -5})};

TEST(BoxSelection, boxesInViewAreHitAndThoseBesideItAreNot) {
    const Renderer::SelectedBoxes selected = GlEnvironment::renderer().selectBoxes(standardView(), kAround, 1000);
    EXPECT_THAT(selected.hits, ElementsAre(0, 8, 9, 10));
    EXPECT_EQ(selected.overflows, 0);
    EXPECT_EQ(selected.bufferWords, 1000u);
}

TEST(BoxSelection, hitRecordsSayHowNearAndHowFarABoxReachesInView) {
    // Wholly in view; around the near plane, where its sides lie in view from a distance of 1 on; to beyond the far plane; flat.
    const std::vector<EyeBox> boxes{box({-1, -1, -6}, {1, 1, -4}), box({-1, -1, -3}, {1, 1, -0.05}),
                                    box({-1, -1, -30}, {1, 1, -8}), box({-1, -1, -5}, {1, 1, -5})};
    const std::vector<std::pair<double, double>> expected{{4, 6}, {1, 3}, {8, 10}, {5, 5}};
    const Renderer::SelectedBoxes selected = GlEnvironment::renderer().selectBoxes(standardView(), boxes, 16);
    EXPECT_THAT(selected.hits, ElementsAre(0, 1, 2, 3));
    ASSERT_EQ(selected.distances.size(), selected.hits.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(selected.distances[i].nearest, expected[i].first, 1e-3 * expected[i].first) << i;
        EXPECT_NEAR(selected.distances[i].farthest, expected[i].second, 1e-3 * expected[i].second) << i;
    }
}

TEST(BoxSelection, overflowsAreCountedAndTheDepthsAreThoseOfTheLastTime) {
    const std::vector<EyeBox> boxes(9, box({-1, -1, -6}, {1, 1, -4}));
    const Renderer::SelectedBoxes selected = GlEnvironment::renderer().selectBoxes(standardView(), boxes, 5);
    EXPECT_EQ(selected.overflows, 3) << "5, 10, 20 words are too few for 36";
    EXPECT_EQ(selected.bufferWords, 40u);
    ASSERT_EQ(selected.distances.size(), 9u);
    for (const HitDistances& distances : selected.distances) EXPECT_NEAR(distances.nearest, 4.0, 1e-3);
}

TEST(BoxQueries, boxesInViewCoverSamplesAndThoseBesideItDoNot) {
    // With clamped depth, boxes in front of near or beyond far cover samples; a box behind the eye does not, nor one seen edge-on
    // between two rows of samples.
    EXPECT_THAT(GlEnvironment::renderer().queryBoxes(standardView(), kAround), ElementsAre(0, 5, 7, 8, 10));
}

TEST(BoxQueries, answerAskedForLaterIsThatOfTheFrameThatAsked) {
    // A wall at distance 3 hides the box at distance 5; the answer is fetched after the wall is gone.
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer& renderer = GlEnvironment::renderer();
    Framebuffer target(standardView().viewport());
    renderer.draw(buffers, standardView(), everything(*scene, Facing::TwoSided), target);
    const std::vector<EyeBox> boxes{box({-1, -1, -6}, {1, 1, -4}), box({-1, -1, -2.5}, {1, 1, -2}), box({7, -1, -6}, {9, 1, -4})};
    const BoxTicketPointer before = renderer.askBoxes(standardView(), boxes, target);
    renderer.clear(standardView(), target, {});
    const BoxTicketPointer after = renderer.askBoxes(standardView(), boxes, target);
    const BoxTicketPointer samples = renderer.askBoxes(standardView(), boxes);
    EXPECT_THAT(*renderer.answer(*before), ElementsAre(1));
    EXPECT_THAT(*renderer.answer(*after), ElementsAre(0, 1));
    EXPECT_THAT(*renderer.answer(*samples), ElementsAre(0, 1));
    EXPECT_THAT(*renderer.answer(*before), ElementsAre(1)) << "at every call the same";
}

TEST(BoxQueries, groupIsHitWhereOneOfItsBoxesIs) {
    // A wall at distance 3 hides the first box; the second stands before it, the third beside the view.
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer& renderer = GlEnvironment::renderer();
    Framebuffer target(standardView().viewport());
    renderer.draw(buffers, standardView(), everything(*scene, Facing::TwoSided), target);
    const EyeBox behind = box({-1, -1, -6}, {1, 1, -4}), before = box({-1, -1, -2.5}, {1, 1, -2}),
                 beside = box({7, -1, -6}, {9, 1, -4});
    const std::vector<EyeBox> boxes{behind, beside, behind, before, before, beside, behind};
    const std::vector<uint32_t> ends{2, 4, 5, 6, 7};
    EXPECT_THAT(renderer.queryBoxes(standardView(), boxes, target, ends), ElementsAre(1, 2));
    EXPECT_THAT(renderer.queryBoxes(standardView(), boxes, ends), ElementsAre(0, 1, 2, 4)) << "without depth";
    const BoxTicketPointer ticket = renderer.askBoxes(standardView(), boxes, target, ends);
    renderer.clear(standardView(), target, {});
    EXPECT_THAT(*renderer.answer(*ticket), ElementsAre(1, 2));
}

TEST(BoxQueries, groupsAnswerAsTheirBoxesDoOneByOne) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        std::vector<EyeBox> boxes;
        std::vector<uint32_t> ends;
        for (size_t group = 0; group < 12; ++group) {
            for (int i = 0; i <= int(random.between(0, 5)); ++i)
                boxes.push_back(
                    {{random.between(-12, 12), random.between(-12, 12), random.between(-14, 2)}, Vec3(random.between(0.0, 1.0))});
            ends.push_back(uint32_t(boxes.size()));
        }
        std::vector<uint32_t> expected;
        for (const uint32_t hit : GlEnvironment::renderer().queryBoxes(standardView(), boxes)) {
            const auto group = uint32_t(std::ranges::upper_bound(ends, hit) - ends.begin());
            if (expected.empty() || expected.back() != group) expected.push_back(group);
        }
        EXPECT_EQ(GlEnvironment::renderer().queryBoxes(standardView(), boxes, ends), expected) << "seed " << seed;
    }
}

TEST(BoxQueries, frameLogsGroupsAndRefusesThoseThatDoNotHoldEachBoxOnce) {
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const std::vector<EyeBox> boxes(3, box({-1, -1, -6}, {1, 1, -4}));
    const View view = standardView();
    GpuFrame frame(GlEnvironment::renderer(), buffers, view);
    EXPECT_THAT(frame.visibleBoxes(boxes, BoxQuestion::DepthSoFar, {1, 3}), ElementsAre(0, 1));
    const BoxTicketPointer ticket = frame.ask(boxes, BoxQuestion::DepthSoFar, {3});
    EXPECT_THAT(*frame.answer(*ticket), ElementsAre(0)) << "in the frame that asked";
    for (const std::vector<uint32_t>& ends : {std::vector<uint32_t>{0, 3}, {2, 2, 3}, {3, 2}, {2}, {4}}) {
        EXPECT_THROW((void)frame.visibleBoxes(boxes, BoxQuestion::DepthSoFar, ends), Error);
        EXPECT_THROW((void)frame.ask(boxes, BoxQuestion::Samples, ends), Error);
    }
    const FrameLog log = frame.take();
    ASSERT_EQ(log.commands.size(), 2u);
    EXPECT_THAT(std::get<AskedBoxes>(log.commands[0]).ends, ElementsAre(1, 3));
    EXPECT_THAT(std::get<AskedBoxes>(log.commands[1]).ends, ElementsAre(3));
}

TEST(BoxQueries, ticketsOfAnotherRendererAreNotAnswered) {
    BoxTicketPointer kept;
    {
        Renderer other;
        kept = other.askBoxes(standardView(), kAround);
        EXPECT_TRUE(other.answer(*kept));
        EXPECT_FALSE(GlEnvironment::renderer().answer(*kept));
    }
    EXPECT_FALSE(GlEnvironment::renderer().answer(*kept)) << "the renderer is gone";
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(BoxQueries, queriesOfTicketsThatAreGoneAreUsedAgain) {
    Renderer& renderer = GlEnvironment::renderer();
    const std::vector<uint32_t> expected = renderer.queryBoxes(standardView(), kAround);
    for (int i = 0; i < 300; ++i) {
        const BoxTicketPointer forgotten = renderer.askBoxes(standardView(), kAround);
        EXPECT_EQ(renderer.queryBoxes(standardView(), kAround), expected);
    }
}

TEST(BoxQueries, questionThatWasGivenUpDoesNotSpoilTheNextOne) {
    // A frame asks at its end and is forgotten with its picture; the next one asks what a wall at distance 3 hides.
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer& renderer = GlEnvironment::renderer();
    const std::vector<EyeBox> before(64, box({-2, -2, -2.5}, {2, 2, -2})), behind{box({-1, -1, -6}, {1, 1, -4})};
    const auto drawn = [&](const Viewport& size) {
        auto target = std::make_unique<Framebuffer>(size);
        renderer.draw(buffers, standardView(size), everything(*scene, Facing::TwoSided), *target);
        return target;
    };
    constexpr int kRounds = 300;
    for (int i = 0; i < kRounds; ++i) {
        (void)renderer.askBoxes(standardView({300, 300}), before, *drawn({300, 300}));
        const Viewport size{96, 64};
        EXPECT_THAT(renderer.queryBoxes(standardView(size), behind, *drawn(size)), IsEmpty()) << "round " << i;
    }
    GLuint next = 0;
    glGenQueries(1, &next);
    glDeleteQueries(1, &next);
    EXPECT_LT(next, 100u * before.size()) << "those of questions that were given up are used again, too";
}

TEST(BoxQueries, frameLogsAQuestionWithoutItsAnswerAndNeedsOpenGl) {
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const std::vector<EyeBox> boxes{box({-1, -1, -6}, {1, 1, -4})};
    const View view = standardView();
    GpuFrame frame(GlEnvironment::renderer(), buffers, view);
    const BoxTicketPointer first = frame.ask(boxes, BoxQuestion::DepthSoFar);
    frame.draw(everything(*scene, Facing::TwoSided));
    const BoxTicketPointer second = frame.ask(boxes, BoxQuestion::DepthSoFar);
    const FrameLog log = frame.take();
    ASSERT_EQ(log.commands.size(), 3u);
    const auto& asked = std::get<AskedBoxes>(log.commands[0]);
    EXPECT_FALSE(asked.answered);
    EXPECT_THAT(asked.hits, IsEmpty());
    EXPECT_EQ(asked.boxes.size(), 1u);
    // The next frame gets both answers; a replay asks nothing.
    GpuFrame next(GlEnvironment::renderer(), buffers, view);
    EXPECT_THAT(*next.answer(*first), ElementsAre(0));
    EXPECT_THAT(*next.answer(*second), IsEmpty());
    Framebuffer target(view.viewport());
    GlEnvironment::renderer().draw(buffers, view, log, target);
    FrameContext without(*scene, view, false);
    EXPECT_THROW((void)without.ask(boxes, BoxQuestion::DepthSoFar), Error);
    EXPECT_THROW((void)without.answer(*first), Error);
}

TEST(BoxSelection, case25OverflowOfTheHitBufferIsNoticed) {
    std::vector<EyeBox> boxes;
    Random random(400);
    for (int i = 0; i < 400; ++i) {
        const Vec3 centre(random.between(-3, 3), random.between(-3, 3), random.between(-9, -5));
        boxes.push_back({centre, Vec3(0.05)});
    }
    for (const size_t words : {size_t{1600}, size_t{1596}, size_t{1}}) {
        const Renderer::SelectedBoxes selected = GlEnvironment::renderer().selectBoxes(standardView(), boxes, words);
        EXPECT_EQ(selected.hits.size(), 400u) << words;
        EXPECT_EQ(selected.overflows, words == 1600 ? 0 : words == 1596 ? 1 : 11) << words;
        EXPECT_EQ(selected.bufferWords, words << selected.overflows);
        for (uint32_t i = 0; i < selected.hits.size(); ++i) EXPECT_EQ(selected.hits[i], i);
    }
}

TEST(BoxSelection, boxAroundTheFrustumIsNotHit) {
    // The reason why a box that touches the near rectangle must not be tested by OpenGL (stability case 26).
    const std::vector<EyeBox> around{{Vec3(0.0), Vec3(50.0)}};
    EXPECT_THAT(GlEnvironment::renderer().selectBoxes(standardView(), around, 100).hits, IsEmpty());
}

TEST(BoxTests, askingAboutNoBoxesGivesNone) {
    EXPECT_THAT(GlEnvironment::renderer().selectBoxes(standardView(), {}, 0).hits, IsEmpty());
    EXPECT_THAT(GlEnvironment::renderer().queryBoxes(standardView(), {}), IsEmpty());
}

TEST(BoxTests, pictureOfOnePixelOrOneRowHitsTheBox) {
    for (const Viewport size : {Viewport{1, 1}, Viewport{16384, 1}, Viewport{1, 4096}}) {
        const View view = standardView(size);
        const Vec3 middle = view.direction(0.5, 0.5) * 5.0;
        const std::vector<EyeBox> boxes{{middle, Vec3(6.0)}};
        EXPECT_THAT(GlEnvironment::renderer().selectBoxes(view, boxes, 100).hits, ElementsAre(0)) << size.width;
        EXPECT_THAT(GlEnvironment::renderer().queryBoxes(view, boxes), ElementsAre(0)) << size.width;
    }
}

TEST(BoxTests, stateThatTheyChangeIsRestored) {
    (void)GlEnvironment::renderer().selectBoxes(standardView(), kAround, 4);
    (void)GlEnvironment::renderer().queryBoxes(standardView(), kAround);
    GLint value = -1;
    for (const GLenum binding : {GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_ARRAY_BUFFER_BINDING,
                                 GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING}) {
        glGetIntegerv(binding, &value);
        EXPECT_EQ(value, 0) << std::hex << binding;
    }
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &value);
    EXPECT_EQ(value, GL_NEGATIVE_ONE_TO_ONE);
    glGetIntegerv(GL_RENDER_MODE, &value);
    EXPECT_EQ(value, GL_RENDER);
    glGetIntegerv(GL_MATRIX_MODE, &value);
    EXPECT_EQ(value, GL_MODELVIEW);
    for (const GLenum depth : {GL_PROJECTION_STACK_DEPTH, GL_MODELVIEW_STACK_DEPTH}) {
        glGetIntegerv(depth, &value);
        EXPECT_EQ(value, 1);
    }
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_DEPTH_CLAMP, GL_VERTEX_ARRAY})
        EXPECT_FALSE(glIsEnabled(capability)) << std::hex << capability;
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace cullscope::test::box_tests_test
