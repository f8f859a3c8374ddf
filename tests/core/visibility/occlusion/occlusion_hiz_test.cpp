#include <algorithm>
#include <map>
#include <optional>

#include "core/spatial/instance_octree.h"
#include "core/visibility/why.h"
#include "tests/support/gl_environment.h"
#include "tests/support/stopped_work.h"
#include "tests/support/wall_scene.h"

namespace cullscope::test::occlusion_hiz_test {
namespace {

using Settings = std::map<std::string, std::string>;
using Objects = std::set<uint32_t>;

/// The lines of the listing.
constexpr uint8_t kFirst = 3, kReduce = 5, kTest = 6, kHidden = 7, kDraw = 8, kNext = 10;

CullerPointer occlusionHiz(const Scene& scene, const Settings& settings = {{"rounds", "1"}}) {
    ParameterSet parameters(findStrategy("occlusion-hiz").info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    CullerPointer culler = makeCuller("occlusion-hiz", parameters);
    culler->build(scene);
    return culler;
}

View viewFrom(const Vec3& eye, const Vec3& ahead = {0, 0, -1}) {
    return {{eye, eye + ahead, Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {101, 99}};
}
View standardView() { return viewFrom(Vec3(0.0)); }

Culled frameOf(Culler& culler, const View& view, Recording recording = Recording::On) {
    return culler.cull(view, recording, &GlEnvironment::renderer());
}

uint64_t hidden(const Culled& frame) { return frame.culledTriangles[size_t(Cause::Hidden)]; }

size_t saidAt(const Culled& frame, uint8_t line, Decision::Outcome outcome, std::optional<Subject::Kind> of = {}) {
    return size_t(std::ranges::count_if(frame.log.decisions, [&](const Decision& decision) {
        return decision.line == line && decision.outcome == outcome && (!of || decision.subject.kind == *of);
    }));
}

TEST(OcclusionHiz, drawsWhatWasVisibleFirstAndHidesTheRestByIt) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionHiz(*scene);
    const Culled first = frameOf(*culler, standardView());
    EXPECT_EQ(drawn(first).size(), scene->instances().size() - 1) << "nothing is known yet: all but what is behind the eye";
    EXPECT_EQ(figure(first, "first_objects"), 0);
    EXPECT_EQ(figure(first, "pyramids"), 1) << "at the end";
    for (int frame = 0; frame < 3; ++frame) {
        const Culled next = frameOf(*culler, standardView());
        EXPECT_EQ(drawn(next), (Objects{0, 1}));
        EXPECT_EQ(figure(next, "first_objects"), 2);
        EXPECT_EQ(figure(next, "tested_objects"), 12);
        EXPECT_EQ(figure(next, "pyramids"), 2);
        EXPECT_EQ(hidden(next), 12 * scene->meshOf(3).triangleCount());
    }
}

TEST(OcclusionHiz, anObjectThatIsAloneIsDrawnWithoutAPyramid) {
    const ScenePointer scene = sceneOf({sphereMesh(200)}, {translation({0, 0, -5})});
    const CullerPointer culler = occlusionHiz(*scene);
    for (int frame = 0; frame < 3; ++frame) {
        const Culled next = frameOf(*culler, standardView());
        EXPECT_EQ(drawn(next), (Objects{0}));
        EXPECT_EQ(figure(next, "pyramids"), 0);
        EXPECT_EQ(figure(next, "first_objects"), frame == 0 ? 0 : 1);
    }
}

TEST(OcclusionHiz, roundsHideInTheFirstFrameToo) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionHiz(*scene, {{"rounds", "4"}});
    const Culled first = frameOf(*culler, standardView());
    EXPECT_EQ(drawn(first), (Objects{0, 1})) << "the wall comes in the first round";
    EXPECT_EQ(figure(first, "pyramids"), 4) << "of three rounds, and at the end";
    EXPECT_EQ(drawn(frameOf(*culler, standardView())), (Objects{0, 1}));
}

TEST(OcclusionHiz, whatComesIntoSightIsDrawnInTheSameFrame) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionHiz(*scene);
    for (int frame = 0; frame < 2; ++frame) (void)frameOf(*culler, standardView());
    // A cut to behind the wall, and back.
    const View behind = viewFrom({0, 0, -4});
    const Culled cut = frameOf(*culler, behind);
    for (uint32_t sphere = 3; sphere < 15; ++sphere) EXPECT_TRUE(drawn(cut).contains(sphere)) << sphere;
    EXPECT_EQ(saidAt(cut, kDraw, Decision::Outcome::Drawn), 12u);
    EXPECT_FALSE(drawn(cut).contains(0)) << "the wall lies behind the eye";
    EXPECT_EQ(saidAt(frameOf(*culler, behind), kFirst, Decision::Outcome::Drawn), 12u);
    // Nothing that was visible there hides the wall; the spheres are visible no more at the end.
    EXPECT_TRUE(drawn(frameOf(*culler, standardView())).contains(0));
    EXPECT_EQ(drawn(frameOf(*culler, standardView())), (Objects{0, 1}));
}

TEST(OcclusionHiz, aGroupInWhichNothingWasVisibleIsHiddenByOneTest) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const CullerPointer byGroups = occlusionHiz(*scene, {{"large", "0"}}),
                        byObjects = occlusionHiz(*scene, {{"large", "1000000000"}});
    for (int frame = 0; frame < 4; ++frame) {
        const Culled grouped = frameOf(*byGroups, standardView()), single = frameOf(*byObjects, standardView());
        EXPECT_EQ(drawn(grouped), drawn(single)) << frame;
        EXPECT_EQ(grouped.culledTriangles, single.culledTriangles) << frame;
        EXPECT_EQ(figure(single, "tested_groups"), 0);
        if (frame == 0) {
            EXPECT_EQ(figure(grouped, "tested_groups"), 0) << "nothing is known yet";
            continue;
        }
        EXPECT_GT(figure(single, "tested_objects"), 150);
        EXPECT_GT(figure(grouped, "hidden_groups"), 0);
        EXPECT_LT(figure(grouped, "tested_groups") + figure(grouped, "tested_objects"), 0.5 * figure(single, "tested_objects"));
        using enum Subject::Kind;
        EXPECT_EQ(saidAt(grouped, kHidden, Decision::Outcome::Culled, Node), size_t(figure(grouped, "hidden_groups")));
        EXPECT_EQ(saidAt(grouped, kTest, Decision::Outcome::Open, Node), size_t(figure(grouped, "tested_groups")));
        EXPECT_LE(figure(grouped, "pyramids"), figure(single, "pyramids") + 1) << "one serves all groups";
    }
}

TEST(OcclusionHiz, whatIsInAGroupThatComesIntoSightIsDrawnInTheSameFrame) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const CullerPointer culler = occlusionHiz(*scene, {{"large", "0"}});
    for (int frame = 0; frame < 3; ++frame) (void)frameOf(*culler, standardView());
    EXPECT_GT(figure(frameOf(*culler, standardView()), "hidden_groups"), 0);
    // The wall lies behind the eye.
    const View behind = viewFrom({0, 0, -4});
    const Culled first = frameOf(*culler, behind);
    EXPECT_GT(figure(first, "tested_groups"), 0);
    EXPECT_EQ(figure(first, "hidden_groups"), 0);
    EXPECT_EQ(hidden(first), 0U);
    EXPECT_EQ(drawn(first), drawn(frameOf(*occlusionHiz(*scene), behind))) << "all in the frustum, as without a past";
    EXPECT_EQ(figure(frameOf(*culler, behind), "tested_groups"), 0) << "all was visible";
}

TEST(OcclusionHiz, aGroupThatShowsThoughNothingInItDoesIsNotAskedAboutAgainAtOnce) {
    // Two walls with a gap between them hide every box of a row; the box around the row shows in the gap.
    std::vector<MeshPointer> meshes{meshOf({{-9, -9, -3}, {-0.4f, -9, -3}, {-0.4f, 9, -3}, {-9, 9, -3}}, {0, 1, 2, 0, 2, 3}),
                                    meshOf({{0.4f, -9, -3}, {9, -9, -3}, {9, 9, -3}, {0.4f, 9, -3}}, {0, 1, 2, 0, 2, 3})};
    std::vector<Mat4> places{Mat4(1.0), Mat4(1.0)};
    for (int i = 0; i < 64; ++i) {
        meshes.push_back(boxMesh(Vec3f(-0.1f), Vec3f(0.1f)));
        places.push_back(translation({(i % 2 == 0 ? -1.0 : 1.0) * (4.0 + 0.1 * (i / 2)), 0, -20.0}));
    }
    const ScenePointer scene = sceneOf(std::move(meshes), places);
    const CullerPointer culler = occlusionHiz(*scene, {{"large", "0"}});
    std::vector<double> shown;
    for (int frame = 0; frame < 40; ++frame) {
        const Culled culled = frameOf(*culler, standardView());
        shown.push_back(figure(culled, "tested_groups") - figure(culled, "hidden_groups"));
        if (frame > 0) {
            EXPECT_EQ(drawn(culled), (Objects{0, 1})) << frame;
        }
    }
    EXPECT_GT(shown[1], 0);
    for (int frame = 2; frame < 17; ++frame) EXPECT_EQ(shown[size_t(frame)], 0) << frame;
    EXPECT_EQ(shown[17], shown[1]) << "after 16 frames it is asked about again";
}

TEST(OcclusionHiz, whatReachesBeforeTheNearPlaneIsDrawnFirstWithoutATest) {
    // The sphere around the eye hides the square at distance 1.5, but not what reaches before the near plane.
    const ScenePointer scene =
        sceneOf({sphereMesh(320), squareMesh(0.05f, -0.15f), sphereMesh(320), squareMesh(20, -1.5f)},
                {scaling(Vec3(1.4)), Mat4(1.0), translation({0, 0, -0.55}) * scaling(Vec3(0.5)), Mat4(1.0)});
    const CullerPointer culler = occlusionHiz(*scene, {{"facing", "two-sided"}, {"rounds", "1"}});
    for (int frame = 0; frame < 2; ++frame) {
        const Culled culled = frameOf(*culler, standardView());
        EXPECT_EQ(drawn(culled), (Objects{0, 1, 2}));
        EXPECT_GE(figure(culled, "first_objects"), 2);
        for (const Command& command : culled.log.commands)
            if (const auto* asked = std::get_if<AskedBoxes>(&command))
                for (const EyeBox& box : asked->boxes) {
                    EXPECT_LT(box.centre.z + box.halfExtent.z, -0.1);
                }
    }
}

TEST(OcclusionHiz, recordedFramesDrawAndCountWhatMeasuredOnesDo) {
    const ScenePointer scene = boxesBehindHalfAWall();
    for (const Settings& settings : {Settings{{"rounds", "1"}}, {{"rounds", "3"}}, {{"large", "0"}}}) {
        const CullerPointer recorded = occlusionHiz(*scene, settings);
        const CullerPointer measured = occlusionHiz(*scene, settings);
        for (int frame = 0; frame < 4; ++frame) {
            const View view = viewFrom({0.3 * frame, 0, 0});
            const Culled one = frameOf(*recorded, view), other = frameOf(*measured, view, Recording::Off);
            EXPECT_EQ(drawn(one), drawn(other));
            EXPECT_EQ(one.culledTriangles, other.culledTriangles);
            EXPECT_EQ(one.log.commands.size(), other.log.commands.size());
            for (const char* name :
                 {"first_objects", "tested_groups", "hidden_groups", "tested_objects", "tested_boxes", "pyramids"})
                EXPECT_EQ(figure(one, name), figure(other, name));
            EXPECT_GT(
                saidAt(one, frame == 0 ? kDraw : kHidden, frame == 0 ? Decision::Outcome::Drawn : Decision::Outcome::Culled), 0u);
            EXPECT_TRUE(other.log.decisions.empty());
        }
    }
}

TEST(OcclusionHiz, copiesOfAMemoryDecideTheSameAndThatOfAnotherRendererTellsNothing) {
    const ScenePointer scene = wallBeforeSpheres();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer culler = occlusionHiz(*scene);
    const View view = standardView();
    {
        Renderer other;
        for (int frame = 0; frame < 2; ++frame) (void)culler->cull(view, &other);
        EXPECT_GT(hidden(culler->cull(view, &other)), 0u);
        EXPECT_EQ(hidden(frameOf(*culler, view)), 0u);
        (void)culler->cull(view, &other);
    }
    EXPECT_EQ(hidden(frameOf(*culler, view)), 0u) << "the other renderer is gone";
    for (int i = 0; i < 3; ++i) {
        const ViewStatePointer copy = culler->state().clone();
        GpuFrame frame(GlEnvironment::renderer(), buffers, view);
        culler->built()->draw(frame, *copy);
        EXPECT_EQ(frame.take().consideredTriangles(), 2 + scene->meshOf(1).triangleCount());
    }
}

TEST(OcclusionHiz, decisionsEndForEveryObjectOnceAndTestsStandBeforeTheirDraw) {
    const ScenePointer scene = boxesBehindHalfAWall();
    for (const Settings& settings : {Settings{{"rounds", "1"}}, {{"rounds", "4"}}, {{"large", "0"}}}) {
        const CullerPointer culler = occlusionHiz(*scene, settings);
        for (int number = 0; number < 3; ++number) {
            const Culled frame = frameOf(*culler, standardView());
            const size_t lines = culler->built()->info().first(Show::Kind::Listing)->lines.size();
            EXPECT_EQ(lines, 10u);
            std::vector<int> ends(scene->instances().size(), 0);
            Objects said;
            for (const Decision& decision : frame.log.decisions) {
                ASSERT_TRUE(decision.line >= 1 && decision.line <= lines);
                if (decision.outcome == Decision::Outcome::Open) continue;
                if (decision.subject.kind == Subject::Kind::Object) {
                    ++ends[decision.subject.number];
                    if (decision.outcome == Decision::Outcome::Drawn) said.insert(decision.subject.number);
                }
                for (const uint32_t instance : frame.log.objectsOf(decision)) ++ends[instance];
                // A replay up to the end of a part's decisions has not drawn it yet.
                if (decision.outcome == Decision::Outcome::Drawn) {
                    ASSERT_LT(decision.commands, frame.log.commands.size());
                    const DrawList* next = nullptr;
                    for (size_t command = decision.commands; next == nullptr; ++command)
                        next = std::get_if<DrawList>(&frame.log.commands.at(command));
                    EXPECT_TRUE(std::ranges::any_of(
                        next->ranges, [&](const DrawRange& range) { return range.instance == decision.subject.number; }));
                }
            }
            EXPECT_THAT(ends, testing::Each(1));
            EXPECT_EQ(said, drawn(frame));
            EXPECT_EQ(saidAt(frame, kReduce, Decision::Outcome::Open), size_t(figure(frame, "pyramids")));
        }
    }
}

TEST(OcclusionHiz, treeWhyAndCountsTellWhatIsHidden) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionHiz(*scene);
    (void)frameOf(*culler, standardView());
    const Culled frame = frameOf(*culler, standardView());
    const StructureSnapshot tree = culler->snapshot(frame.log);
    size_t objects = 0;
    for (const SnapshotNode& node : tree.nodes) {
        if (node.isGroup()) continue;
        ++objects;
        EXPECT_EQ(node.culled, !drawn(frame).contains(node.instance)) << node.instance;
        if (node.culled) {
            EXPECT_EQ(node.cause, node.instance == 2 ? Cause::OutsideFrustum : Cause::Hidden);
        }
    }
    EXPECT_EQ(objects, scene->instances().size());
    const Bars bars = culler->built()->bars(frame.log).at(0);
    std::vector<uint64_t> values;
    for (const Bar& bar : bars.bars) values.push_back(bar.value);
    EXPECT_THAT(values, testing::ElementsAre(0, 2, 12, 12, 0, 2));
    const auto has = [&](uint32_t instance, const std::string& words) {
        for (const WhyStep& step : why(*culler->built(), frame.log, scene->firstTriangle(instance)))
            if (step.sentence.english().find(words) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(has(5, "smaller boxes, and each lies behind all texels"));
    EXPECT_TRUE(has(5, "is not given to OpenGL"));
    EXPECT_TRUE(has(5, "the next frame does not draw it first"));
    EXPECT_TRUE(has(0, "visible at the end of the frame before"));
    EXPECT_TRUE(has(0, "is given to OpenGL"));
    EXPECT_TRUE(has(0, "the next frame draws it first"));
}

TEST(OcclusionHiz, aTestSaysLevelTexelsAndDepths) {
    // A square of two triangles has one box: 9 ahead, and the wall 3.
    const ScenePointer scene = sceneOf({squareMesh(8, -3), squareMesh(1, -9)}, {Mat4(1.0), Mat4(1.0)});
    const CullerPointer culler = occlusionHiz(*scene);
    (void)frameOf(*culler, standardView());
    const Culled frame = frameOf(*culler, standardView());
    EXPECT_EQ(drawn(frame), (Objects{0}));
    const auto test = std::ranges::find(frame.log.decisions, kTest, &Decision::line);
    ASSERT_NE(test, frame.log.decisions.end());
    ASSERT_EQ(test->operandCount, 5);
    EXPECT_NEAR(test->operands[1], 9.0 - test->operands[0], 1e-3) << "the box begins so far ahead";
    // 99 pixels are 18 high at a distance of 9: the square has 11 pixels in the middle, and the box two more on each side. They
    // lie in five texels of 4 pixels, so in three of 8.
    EXPECT_EQ(test->operands[2], 3.0) << "level";
    EXPECT_EQ(test->operands[3], 9.0) << "texels";
    EXPECT_NEAR(test->operands[4], 3.0, 1e-3);
}

TEST(OcclusionHiz, stopsAtTheNextLookAndThenRemembersWhatItDidBefore) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer culler = occlusionHiz(*scene), other = occlusionHiz(*scene);
    for (Culler* one : {culler.get(), other.get()}) (void)frameOf(*one, standardView(), Recording::Off);
    const StoppedWork stopped = stoppedAfter(1, [&](const Progress& progress) {
        const View view = standardView();
        GpuFrame frame(GlEnvironment::renderer(), buffers, view);
        frame.stopBy(progress.stop);
        culler->built()->draw(frame, culler->state());
    });
    EXPECT_TRUE(stopped.interrupted);
    EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween);
    const Culled frame = frameOf(*culler, standardView(), Recording::Off);
    EXPECT_EQ(drawn(frame), drawn(frameOf(*other, standardView(), Recording::Off)));
    EXPECT_GT(hidden(frame), 0u);
}

TEST(OcclusionHiz, needsOpenGl) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionHiz(*scene);
    EXPECT_THROW((void)culler->cull(standardView()), Error);
}

}  // namespace
}  // namespace cullscope::test::occlusion_hiz_test
