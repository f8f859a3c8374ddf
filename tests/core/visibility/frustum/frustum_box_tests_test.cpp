#include "core/base/error.h"
#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

// `frustum-select` and `frustum-query`; the cases of the battery of extremes keep their numbers: camera at the origin looking
// down −z, 90°, aspect 1, near 0.1, far 10 unless stated.

namespace cullscope::test::frustum_box_tests_test {
namespace {

constexpr std::array kIds{"frustum-select", "frustum-query"};

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, {100, 100}}; }

std::vector<uint32_t> drawn(const Culled& frame) {
    std::vector<uint32_t> instances;
    for (const DrawRange& range : frame.drawList.ranges) instances.push_back(range.instance);
    return instances;
}

std::vector<uint32_t> drawn(Culler& strategy, const View& view) { return drawn(strategy.cull(view, &GlEnvironment::renderer())); }

std::vector<uint32_t> drawn(const char* id, const Scene& scene, const View& view) {
    const CullerPointer strategy = makeCuller(id);
    strategy->build(scene);
    return drawn(*strategy, view);
}

TEST(FrustumBoxTests, objectInViewIsDrawnAndObjectBesideItCulled) {
    const ScenePointer scene = copiesOf(sphereMesh(80), {translation({0, 0, -5}), translation({0, 0, 5}), translation({9, 0, -5}),
                                                         translation({5.5, 0, -5}), scaling(Vec3(50.0))});
    for (const char* id : kIds) EXPECT_THAT(drawn(id, *scene, standardView()), testing::ElementsAre(0, 3, 4)) << id;
}

TEST(FrustumQuery, whatLiesBeforeNearOrBeyondFarIsCulledThoughDepthIsClamped) {
    const ScenePointer scene = copiesOf(
        sphereMesh(80), {translation({0, 0, -13}), translation({0, 0, -.05}) * scaling(Vec3(.02)), translation({0, 0, -5})});
    const CullerPointer strategy = makeCuller("frustum-query");
    strategy->build(*scene);
    const Culled frame = strategy->cull(standardView(), Recording::On, &GlEnvironment::renderer());
    EXPECT_THAT(drawn(frame), testing::ElementsAre(2));
    const StructureSnapshot snapshot = strategy->snapshot(frame.log);
    ASSERT_EQ(snapshot.nodes.size(), 3u);
    EXPECT_EQ(snapshot.nodes[0].rejectedBy, FrustumPlane::Far);
    EXPECT_EQ(snapshot.nodes[1].rejectedBy, FrustumPlane::Near);
}

TEST(FrustumBoxTests, case26BoxAroundTheWholeFrustumIsDrawn) {
    // A box that contains the far plane, with the eye inside it and 0.05 outside it: OpenGL hits none of its faces.
    const ScenePointer around = sceneOf({boxMesh(Vec3f(-1000), Vec3f(1000))});
    const ScenePointer before = sceneOf({boxMesh({-1000, -1000, -1000}, {1000, 1000, -0.05f})});
    for (const char* id : kIds) {
        EXPECT_THAT(drawn(id, *around, standardView()), testing::ElementsAre(0)) << id;
        EXPECT_THAT(drawn(id, *before, standardView()), testing::ElementsAre(0)) << id;
    }
}

TEST(FrustumBoxTests, case22ObjectAroundTheEyeIsDrawn) {
    const ScenePointer scene = sceneOf({boxMesh({-1, -1, -3}, {1, 1, 3})});
    for (const char* id : kIds) EXPECT_THAT(drawn(id, *scene, standardView()), testing::ElementsAre(0)) << id;
}

TEST(FrustumBoxTests, objectSmallerThanAPixelThatCoversASampleIsDrawn) {
    // Its own box may or may not cover a sample; grown by a pixel it does.
    const View view = standardView();
    const Vec3 sample = view.direction(40.5, 60.5) * 5.0;
    const ScenePointer scene = copiesOf(boxMesh(Vec3f(-1), Vec3f(1)), {translation(sample) * scaling(Vec3(1e-7))});
    for (const char* id : kIds) EXPECT_THAT(drawn(id, *scene, view), testing::ElementsAre(0)) << id;
}

TEST(FrustumBoxTests, objectJustBeforeFarIsDrawnWhereNearIsVeryNear) {
    // An object seen at the side, where a far plane displaced by 2 % would cull it: selection mode with OpenGL's own depth range
    // of -1 … 1 in floats.
    const Camera camera{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(179), 4.5e-5, 33};
    const View view(camera, {96, 64});
    std::vector<Mat4> places;
    for (int i = 0; i < 20; ++i) places.push_back(translation({-4930.0 + i, 1940.0 + i, -32.9 + 0.05 * i}) * scaling(Vec3(0.02)));
    const ScenePointer scene = copiesOf(boxMesh(Vec3f(-1), Vec3f(1)), places);
    for (const char* id : kIds) EXPECT_EQ(drawn(id, *scene, view).size(), 20u) << id;
}

TEST(FrustumSelect, case25NoObjectIsLostWhereTheHitBufferOverflows) {
    std::vector<Mat4> places;
    for (int i = 0; i < 400; ++i)
        places.push_back(translation({0.2 * (i % 20) - 2, 0.2 * (i / 20.0) - 2, -6}) * scaling(Vec3(.05)));
    const ScenePointer scene = copiesOf(boxMesh(Vec3f(-1), Vec3f(1)), places);
    for (const char* words : {"1596", "1600"}) {
        ParameterSet parameters(findStrategy("frustum-select").info.parameters);
        parameters.setFromText("buffer", words);
        const CullerPointer strategy = makeCuller("frustum-select", parameters);
        strategy->build(*scene);
        for (int frame = 0; frame < 2; ++frame) EXPECT_EQ(drawn(*strategy, standardView()).size(), 400u) << words;
    }
}

TEST(FrustumBoxTests, everyObjectIsDecidedWhereItsAnswerFalls) {
    const ScenePointer scene = copiesOf(sphereMesh(80), {translation({0, 0, -5}), translation({9, 0, -5}), scaling(Vec3(50.0))});
    for (const char* id : kIds) {
        SCOPED_TRACE(id);
        const bool clamps = std::string_view(id) == "frustum-query";
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const Culled frame = strategy->cull(standardView(), Recording::On, &GlEnvironment::renderer());
        const auto& hits = std::get<AskedBoxes>(frame.log.commands.front()).hits;
        using enum Decision::Outcome;
        constexpr std::array kTests{"OpenGL was asked", "OpenGL was asked", "The box reaches the near rectangle"};
        std::array<std::vector<Decision>, 3> about;
        for (const Decision& decision : frame.log.decisions) about.at(decision.subject.number).push_back(decision);
        for (uint32_t i = 0; i < about.size(); ++i) {
            // Of a box that OpenGL is asked about with its depth clamped, the near and the far plane were tested before.
            const size_t planes = clamps && i < 2 ? 2 : 0;
            ASSERT_EQ(about[i].size(), planes + 2) << i;
            for (size_t plane = 0; plane < planes; ++plane) {
                EXPECT_EQ(about[i][plane].plane, plane == 0 ? FrustumPlane::Near : FrustumPlane::Far);
                EXPECT_EQ(about[i][plane].commands, 0u) << "tested before the question";
            }
            const Decision &answer = about[i][planes], &end = about[i][planes + 1];
            EXPECT_EQ(answer.outcome, Open);
            EXPECT_FALSE(answer.plane);
            EXPECT_TRUE(says(answer, kTests[i])) << i;
            EXPECT_EQ(answer.commands, i < 2 ? 1u : 0u) << "OpenGL's answer falls after the question";
            EXPECT_EQ(end.outcome, i == 1 ? Culled : Drawn);
            if (i < 2) {
                EXPECT_EQ(answer.containment == Containment::Outside, std::ranges::find(hits, i) == hits.end());
            }
        }
        const StructureSnapshot snapshot = strategy->snapshot(frame.log);
        ASSERT_EQ(snapshot.nodes.size(), 3u);
        for (const SnapshotNode& node : snapshot.nodes) {
            EXPECT_EQ(node.culled, node.instance == 1);
            EXPECT_FALSE(node.rejectedBy);
            EXPECT_TRUE(node.tested);
        }
    }
}

TEST(FrustumBoxTests, recordedAnswersAreThoseOfOpenGl) {
    Random random(8);
    std::vector<Mat4> places;
    for (int i = 0; i < 200; ++i)
        places.push_back(translation({random.between(-9, 9), random.between(-9, 9), random.between(-14, 3)}));
    const ScenePointer scene = copiesOf(sphereMesh(80), places);
    for (const char* id : kIds) {
        SCOPED_TRACE(id);
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const FrameLog log = strategy->cull(standardView(), Recording::On, &GlEnvironment::renderer()).log;
        const auto& asked = std::get<AskedBoxes>(log.commands.front());
        size_t hit = 0, missed = 0, planes = 0;
        for (const Decision& decision : log.decisions) {
            planes += isPlaneTest(decision) ? 1 : 0;
            if (!says(decision, "OpenGL was asked")) continue;
            ++(decision.containment == Containment::Outside ? missed : hit);
        }
        EXPECT_EQ(hit, asked.hits.size());
        EXPECT_EQ(hit + missed, asked.boxes.size());
        EXPECT_GT(missed, 20u);
        EXPECT_EQ(planes > 0, std::string_view(id) == "frustum-query");
    }
}

TEST(FrustumBoxTests, logHasTheQuestionAndTheAnswer) {
    const ScenePointer scene = copiesOf(sphereMesh(80), {translation({0, 0, -5}), translation({9, 0, -5}), scaling(Vec3(50.0))});
    for (const char* id : kIds) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const FrameLog log = strategy->cull(standardView(), &GlEnvironment::renderer()).log;
        ASSERT_EQ(log.commands.size(), 2u) << id;
        const auto* asked = std::get_if<AskedBoxes>(&log.commands[0]);
        ASSERT_NE(asked, nullptr) << id;
        EXPECT_EQ(asked->question, std::string_view(id) == "frustum-select" ? BoxQuestion::Selection : BoxQuestion::Samples);
        EXPECT_EQ(asked->boxes.size(), 2u) << "the box around the eye is visible without asking";
        EXPECT_THAT(asked->hits, testing::ElementsAre(0));
        EXPECT_TRUE(std::holds_alternative<DrawList>(log.commands[1])) << id;
    }
}

TEST(FrustumBoxTests, refusesToDecideWithoutOpenGl) {
    const ScenePointer scene = copiesOf(sphereMesh(80), {Mat4(1.0)});
    for (const char* id : kIds) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        try {
            (void)strategy->cull(standardView());
            ADD_FAILURE() << id;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::OpenGl);
        }
    }
}

TEST(FrustumSelect, aloneNeedsACompatibilityProfile) {
    GlInfo gl = GlEnvironment::info();
    gl.compatibilityProfile = true;
    for (const RegisteredStrategy& registered : strategies()) EXPECT_FALSE(unavailable(registered.info, gl));
    gl.compatibilityProfile = false;
    for (const RegisteredStrategy& registered : strategies())
        EXPECT_EQ(unavailable(registered.info, gl).has_value(), registered.info.id == "frustum-select") << registered.info.id;
}

}  // namespace
}  // namespace cullscope::test::frustum_box_tests_test
