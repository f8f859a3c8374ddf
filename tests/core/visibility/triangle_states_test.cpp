#include "core/visibility/triangle_states.h"

#include <map>
#include <numeric>

#include "core/measure/accuracy.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::triangle_states_test {
namespace {

TEST(VisibleSets, whatOnlyOneOfTwoShowsIsCounted) {
    using enum TriangleState;
    TriangleStates first, second;
    first.states = {Visible, Visible, InVain, WronglyCulled, Visible, BackFacing};
    second.states = {Visible, WronglyCulled, Visible, Visible, Visible, BackFacing};
    const VisibleSetDifference sets = compareVisibleSets(first, second);
    EXPECT_EQ(sets.both, 2u);
    EXPECT_EQ(sets.onlyFirst, 1u);
    EXPECT_EQ(sets.onlySecond, 2u);
}

uint64_t count(const TriangleStates& states, TriangleState state) { return states.counts[static_cast<size_t>(state)]; }

/// Expects the counts to agree with the states, and a state for every triangle.
void expectPartition(const TriangleStates& states, const Scene& scene) {
    ASSERT_EQ(states.states.size(), scene.triangleCount());
    std::array<uint64_t, kTriangleStateCount> counted{};
    for (const TriangleState state : states.states) {
        ASSERT_LT(static_cast<size_t>(state), kTriangleStateCount);
        ++counted[static_cast<size_t>(state)];
    }
    EXPECT_EQ(states.counts, counted);
    EXPECT_EQ(std::accumulate(counted.begin(), counted.end(), uint64_t{0}), scene.triangleCount());
}

std::vector<uint32_t> inState(const TriangleStates& states, TriangleState state) {
    std::vector<uint32_t> triangles;
    for (uint32_t i = 0; i < states.states.size(); ++i)
        if (states.states[i] == state) triangles.push_back(i);
    return triangles;
}

/// V∖S, computed by an independent mask.
std::vector<uint32_t> visibleNotSubmitted(const Reference& reference, const DrawList& list, const Scene& scene) {
    std::vector<uint8_t> submitted(scene.triangleCount(), 0);
    for (const DrawRange& range : list.ranges)
        for (uint32_t i = 0; i < range.indexCount / 3; ++i)
            submitted[scene.firstTriangle(range.instance) +
                      list.triangleAt(scene.instances()[range.instance].mesh, range.firstIndex / 3 + i)] = 1;
    std::vector<uint32_t> lost;
    for (const uint32_t triangle : reference.visibleTriangles)
        if (submitted[triangle] == 0) lost.push_back(triangle);
    return lost;
}

uint64_t falselyCulled(const Reference& reference, const SceneBuffers& buffers, const View& view, const DrawList& list) {
    return compare(reference, {picture(buffers, view, list).depth, {}}, list, buffers.scene()).falselyCulledTriangles;
}

/// A frame that drew this list and said this.
FrameLog logOf(const View& view, DrawList list, std::vector<Decision> decisions = {}) {
    FrameLog log;
    log.camera = view.camera();
    log.size = view.viewport();
    log.facing = list.facing;
    log.recorded = true;
    log.commands.emplace_back(std::move(list));
    log.decisions = std::move(decisions);
    return log;
}

Decision culledFor(uint32_t instance, Cause cause) {
    return ending(Subject::ofObject(instance), Decision::Outcome::Culled, cause);
}

Viewport small(const Viewport& size) { return {std::min(size.width, 96), std::min(size.height, 64)}; }

TEST(TriangleStates, statesOfARandomViewAreAPartition) {
    for (uint64_t seed = 1; seed <= howMany(12, 12); ++seed) {
        const ScenePointer scene = randomScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        std::vector<CullerPointer> built;
        for (const RegisteredStrategy& registered : strategies()) {
            built.push_back(makeCuller(registered.info.id));
            built.back()->build(*scene);
        }
        Random random(seed);
        for (int i = 0; i < 8; ++i) {
            const RandomView sample = randomView(*scene, random);
            const View view(sample.camera, small(sample.viewport));
            std::map<Facing, Reference> references;
            for (const CullerPointer& strategy : built) {
                SCOPED_TRACE(strategy->built()->info().id + " scene seed " + std::to_string(seed) + " view " + std::to_string(i));
                const Culled frame = strategy->cull(view, Recording::On, &GlEnvironment::renderer());
                const DrawList drawn = standingFor(frame.drawList, *scene);
                const Facing facing = strategy->referenceFacing();
                if (!references.contains(facing))
                    references[facing] = itemBufferReference(GlEnvironment::renderer(), buffers, view, facing);
                const Reference& reference = references.at(facing);
                const TriangleStates states = triangleStates(*scene, frame.log, reference.visible());
                EXPECT_TRUE(states.againstTruth);
                expectPartition(states, *scene);
                // Where OpenGL culls no triangle that the truth contains, the lost ones are V∖S.
                if (drawn.facing == reference.facing) {
                    EXPECT_EQ(inState(states, TriangleState::WronglyCulled), visibleNotSubmitted(reference, drawn, *scene));
                    EXPECT_EQ(count(states, TriangleState::WronglyCulled), falselyCulled(reference, buffers, view, drawn));
                    EXPECT_EQ(count(states, TriangleState::Visible) + count(states, TriangleState::WronglyCulled),
                              reference.visibleTriangles.size());
                }
                EXPECT_EQ(count(states, TriangleState::OutsideFrustum) + count(states, TriangleState::Hidden) +
                              count(states, TriangleState::TooSmall) + frame.culledTriangles[size_t(Cause::BackFacing)] +
                              visibleNotSubmitted(reference, drawn, *scene).size() + drawn.triangleCount(),
                          scene->triangleCount());
            }
        }
    }
}

View overThree() { return {{{0, 3, 12}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {200, 150}}; }
ScenePointer threeBodies() {
    return sceneOf({knotMesh(4000), starMesh(7, 3000), sphereMesh(9000)},
                   {translation({-2.5, 0, 0}), translation({2, 0, 0}), translation({0, 0, -5})});
}

TEST(TriangleStates, wrongDrawListLosesWhatIsSeen) {
    const ScenePointer scene = threeBodies();
    const SceneBuffers buffers(scene, Upload::Vbo);
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, overThree(), facing);
        for (uint32_t removed = 0; removed < 3; ++removed) {
            // Half of an object is not submitted; its decision has the cause.
            DrawList lossy = everything(*scene, facing);
            lossy.ranges[removed].firstIndex = 3 * static_cast<uint32_t>(scene->meshOf(removed).triangleCount() / 2);
            lossy.ranges[removed].indexCount -= lossy.ranges[removed].firstIndex;
            const FrameLog log = logOf(overThree(), lossy, {culledFor(removed, Cause::TooSmall)});
            const TriangleStates states = triangleStates(*scene, log, reference.visible());
            expectPartition(states, *scene);
            const std::vector<uint32_t> lost = inState(states, TriangleState::WronglyCulled);
            EXPECT_EQ(lost, visibleNotSubmitted(reference, lossy, *scene));
            EXPECT_EQ(lost.size(), falselyCulled(reference, buffers, overThree(), lossy));
            EXPECT_GT(lost.size(), 20u);
            EXPECT_EQ(count(states, TriangleState::TooSmall) + lost.size(), lossy.ranges[removed].firstIndex / 3)
                << "what was not given and is not seen has the cause";
            EXPECT_EQ(count(states, TriangleState::BackFacing) > 0, facing == Facing::Front);
        }
    }
}

TEST(TriangleStates, everyCauseBecomesItsState) {
    const ScenePointer scene =
        sceneOf({squareMesh(1, 0), squareMesh(1, -1), squareMesh(1, -2), squareMesh(1, -3), squareMesh(1, -4)});
    std::vector<Decision> decisions;
    for (uint32_t i = 0; i < kCauseCount; ++i) decisions.push_back(culledFor(i, static_cast<Cause>(i)));
    const TriangleStates states = triangleStates(*scene, logOf(overThree(), {}, decisions), std::nullopt);
    using enum TriangleState;
    EXPECT_THAT(states.states, testing::ElementsAre(OutsideFrustum, OutsideFrustum, BackFacing, BackFacing, Hidden, Hidden,
                                                    TooSmall, TooSmall, TooSmall, TooSmall));
    EXPECT_FALSE(states.againstTruth);
}

TEST(TriangleStates, groupNamesTheCauseOfItsObjectsAndACellThatOfItsTriangles) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0), squareMesh(1, -1), squareMesh(1, -2)});
    FrameLog log = logOf(overThree(), {Facing::TwoSided, {{1, 0, 3}}});
    log.objects = {2, 0};
    Decision group = ending(Subject::ofNode(5), Decision::Outcome::Culled, Cause::TooSmall);
    group.firstObject = 0;
    group.objectCount = 2;
    Decision cell = ending(Subject::ofCell(3, 1), Decision::Outcome::Culled, Cause::BackFacing);
    cell.places = {1, 1};
    const Decision object = ending(Subject::ofObject(1), Decision::Outcome::PartlyDrawn, Cause::Hidden);
    log.decisions = {group, cell, object};
    using enum TriangleState;
    EXPECT_THAT(triangleStates(*scene, log, std::nullopt).states,
                testing::ElementsAre(TooSmall, TooSmall, Visible, BackFacing, TooSmall, TooSmall));
}

TEST(TriangleStates, whatNoDecisionNamesIsHidden) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0), squareMesh(1, -1)});
    using enum TriangleState;
    EXPECT_THAT(triangleStates(*scene, logOf(overThree(), {Facing::TwoSided, {{0, 0, 6}}}), std::nullopt).states,
                testing::ElementsAre(Visible, Visible, Hidden, Hidden));
}

TEST(TriangleStates, backFaceThatTheTruthShowsIsLost) {
    // An open square seen from behind: OpenGL culls it, but two-sided it would be visible.
    const ScenePointer scene = sceneOf({squareMesh(1, 0)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View behind({{0, 0, -4}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64});
    const DrawList list = everything(*scene, Facing::Front);
    const auto states = [&](Facing truth) {
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, behind, truth);
        return triangleStates(*scene, logOf(behind, list), reference.visible());
    };
    EXPECT_EQ(count(states(Facing::TwoSided), TriangleState::WronglyCulled), 2u);
    EXPECT_EQ(count(states(Facing::Front), TriangleState::BackFacing), 2u);
    EXPECT_EQ(count(triangleStates(*scene, logOf(behind, list), std::nullopt), TriangleState::BackFacing), 2u);
    const View before({{0, 0, 4}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64});
    EXPECT_EQ(count(triangleStates(*scene, logOf(before, list), std::nullopt), TriangleState::Visible), 2u);
}

TEST(TriangleStates, triangleDrawnTwiceKeepsItsState) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0), squareMesh(1, -1)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, overThree(), Facing::TwoSided);
    const DrawList twice{Facing::TwoSided, {{0, 0, 6}, {1, 0, 6}, {0, 0, 3}, {1, 3, 3}}};
    EXPECT_EQ(triangleStates(*scene, logOf(overThree(), twice), reference.visible()).states,
              triangleStates(*scene, logOf(overThree(), everything(*scene, Facing::TwoSided)), reference.visible()).states);
}

/// Whether the outer side of a triangle of a body around `centre` faces away from the eye, independent of its winding.
bool outerSideTurnedAway(const Scene& scene, uint32_t instance, uint32_t triangle, const Vec3& centre, const Vec3& eye) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i)
        corners[i] = Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.position(mesh.indices()[3 * triangle + i]), 1.0));
    Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::dot(normal, corners[0] - centre) < 0.0) normal = -normal;
    return glm::dot(normal, eye - corners[0]) < 0.0;
}

TEST(TriangleStates, mirroredInstanceShowsItsFront) {
    const std::vector<Mat4> places{translation({-2, 0, 0}), translation({2, 0, 0}) * scaling({-1, 1, 1}),
                                   translation({0, 2, 0}) * scaling({1, -2, .5}),
                                   translation({0, -2, 0}) * scaling({-1, -1, -1})};
    const ScenePointer scene = copiesOf(sphereMesh(20000), places);
    const TriangleStates states = triangleStates(*scene, logOf(overThree(), everything(*scene, Facing::Front)), std::nullopt);
    expectPartition(states, *scene);
    for (uint32_t i = 0; i < places.size(); ++i) {
        const auto triangles = static_cast<uint32_t>(scene->meshOf(i).triangleCount());
        for (uint32_t t = 0; t < triangles; ++t) {
            const bool away = outerSideTurnedAway(*scene, i, t, Vec3(places[i][3]), overThree().eye());
            ASSERT_EQ(states.states[scene->firstTriangle(i) + t], away ? TriangleState::BackFacing : TriangleState::Visible)
                << "instance " << i << " triangle " << t;
        }
    }
    EXPECT_GT(count(states, TriangleState::BackFacing), scene->triangleCount() / 3);
}

TEST(TriangleStates, fieldCountsAgreeWithTheCounters) {
    std::vector<Mat4> places;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) places.push_back(translation({(i - 9.5) * 2.5, 0, (j - 9.5) * 2.5}));
    const ScenePointer scene = copiesOf(sphereMesh(320), places);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    Random random(5);
    for (int i = 0; i < 10; ++i) {
        const View view({{random.between(-20, 20), 1, random.between(-20, 20)},
                         {random.between(-5, 5), 0, random.between(-5, 5)},
                         {0, 1, 0},
                         Angle::fromDegrees(45),
                         0.05,
                         100},
                        {160, 120});
        const Culled frame = frustum->cull(view, Recording::On);
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, frustum->referenceFacing());
        const uint64_t outside = frame.culledTriangles[static_cast<size_t>(Cause::OutsideFrustum)];
        ASSERT_GT(outside, 0u);
        for (const std::optional<VisibleTriangles>& truth :
             {std::optional(reference.visible()), std::optional<VisibleTriangles>()}) {
            const TriangleStates states = triangleStates(*scene, frame.log, truth);
            expectPartition(states, *scene);
            EXPECT_EQ(count(states, TriangleState::OutsideFrustum), outside);
            EXPECT_EQ(count(states, TriangleState::WronglyCulled), 0u);
            EXPECT_EQ(count(states, TriangleState::InVain) > 0, truth.has_value());
        }
    }
}

TEST(TriangleStates, everyStateHasANameOfItsOwn) {
    std::set<std::string> names;
    for (size_t i = 0; i < kTriangleStateCount; ++i) names.insert(triangleStateName(static_cast<TriangleState>(i)));
    EXPECT_EQ(names.size(), kTriangleStateCount);
}

}  // namespace
}  // namespace cullscope::test::triangle_states_test
