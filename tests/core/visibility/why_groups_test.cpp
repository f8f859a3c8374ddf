// The explanation of the groups that objects were tested with.

#include <tuple>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/visibility/why.h"
#include "tests/support/decisions.h"
#include "tests/support/grouped_frustum.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::why_groups_test {
namespace {

ScenePointer field() {
    std::vector<Mat4> places;
    // Not a power of two, so that some groups have one object.
    for (int i = 0; i < 13; ++i)
        for (int j = 0; j < 17; ++j) places.push_back(translation({(i - 6) * 2.5, 0.1 * i, (j - 8) * 2.5}));
    return copiesOf(sphereMesh(80), places);
}

std::vector<View> views() {
    std::vector<View> views;
    Random random(31);
    for (int i = 0; i < 15; ++i) {
        const Vec3 eye(random.between(-9, 9), random.between(-3, 3), random.between(-9, 9));
        const Angle field = Angle::fromDegrees(random.between(40, 110));
        views.push_back(View({eye, eye + random.direction(), {0, 1, 0}, field, 0.01, 60}, {200, 150}));
    }
    return views;
}

/// By instance, the innermost visited group that contains it: nothing was tested below it.
std::vector<VisitedGroup> decidingGroups(const InstanceOctree& octree, const FrameLog& log, size_t instances) {
    std::vector<VisitedGroup> groups(instances);
    for (const VisitedGroup& group : visitedGroups(log))
        for (const uint32_t instance : octree.instancesOf(octree.nodes()[group.node])) groups[instance] = group;
    return groups;
}

std::string sentenceAbout(const VisitedGroup& group, uint32_t objects) {
    const std::string begin = "It lies in a group of " + std::to_string(objects) + " objects, whose box was tested first: ";
    if (group.containment == Containment::Outside) return begin + "outside the " + planeName(group.plane.value()) + ".";
    if (group.containment == Containment::Inside)
        return begin + "wholly inside the frustum, so that nothing of it was tested again.";
    return begin + "it reaches over the edge of the frustum, so that its objects were tested one by one.";
}

TEST(WhyOfGroups, onlyTheLevelThatDecidedIsNamed) {
    const ScenePointer scene = field();
    GroupedCuller strategy;
    strategy.build(*scene);
    std::array<int, 4> seen{};  ///< by containment; the last: groups of one
    for (const View& view : views()) {
        const Culled frame = strategy.cull(view, Recording::On);
        const auto groups = decidingGroups(strategy.octree(), frame.log, scene->instances().size());
        for (uint32_t i = 0; i < groups.size(); ++i) {
            const uint32_t objects = strategy.octree().nodes()[groups[i].node].count;
            std::vector<std::string> said;
            for (const WhyStep& step : why(*strategy.built(), frame.log, scene->firstTriangle(i))) {
                EXPECT_THAT(step.sentence.english(), testing::Not(testing::HasSubstr("%")));
                if (step.sentence.english().find("group") == std::string::npos) continue;
                said.push_back(step.sentence.english());
                EXPECT_EQ(step.containment, groups[i].containment);
            }
            // A group of one is the object itself: see below.
            const auto expected =
                objects < 2 ? std::vector<std::string>{} : std::vector<std::string>{sentenceAbout(groups[i], objects)};
            EXPECT_EQ(said, expected) << "instance " << i;
            ++seen[objects < 2 ? 3 : size_t(groups[i].containment)];
        }
    }
    for (const int count : seen) EXPECT_GT(count, 20);
}

TEST(WhyOfGroups, groupOfOneIsExplainedAsItsObject) {
    const ScenePointer scene = field();
    GroupedCuller strategy;
    strategy.build(*scene);
    std::array<int, 3> seen{};  ///< by containment
    for (const View& view : views()) {
        const Culled frame = strategy.cull(view, Recording::On);
        const auto groups = decidingGroups(strategy.octree(), frame.log, scene->instances().size());
        for (uint32_t i = 0; i < groups.size(); ++i) {
            if (strategy.octree().nodes()[groups[i].node].count > 1) continue;
            // Where the group was decided as a whole, the object has no tests of its own.
            const bool whole = groups[i].containment != Containment::Straddles;
            const Subject subject = whole ? Subject::ofNode(groups[i].node) : Subject::ofObject(i);
            std::vector<FrustumPlane> tested, told;
            for (const Decision& decision : frame.log.decisions)
                if (decision.subject == subject && decision.plane) tested.push_back(*decision.plane);
            for (const WhyStep& step : why(*strategy.built(), frame.log, scene->firstTriangle(i)))
                if (step.plane) told.push_back(*step.plane);
            EXPECT_EQ(told, tested) << "instance " << i;
            ++seen[size_t(groups[i].containment)];
        }
    }
    EXPECT_GT(seen[size_t(Containment::Outside)], 5);
    EXPECT_GT(seen[size_t(Containment::Straddles)], 10);
}

TEST(WhyOfGroups, testsOfTheGroupThatDecidedAreToldWithTheirNumbers) {
    const ScenePointer scene = field();
    GroupedCuller strategy;
    strategy.build(*scene);
    std::array<int, 3> seen{};  ///< by containment
    for (const View& view : views()) {
        const Culled frame = strategy.cull(view, Recording::On);
        const auto groups = decidingGroups(strategy.octree(), frame.log, scene->instances().size());
        for (uint32_t i = 0; i < groups.size(); i += 3) {
            if (strategy.octree().nodes()[groups[i].node].count < 2) continue;
            std::vector<std::tuple<bool, FrustumPlane, double, double>> tested, told;
            for (const Decision& decision : frame.log.decisions) {
                const bool ofGroup = decision.subject == Subject::ofNode(groups[i].node);
                if ((ofGroup || decision.subject == Subject::ofObject(i)) && isPlaneTest(decision))
                    tested.emplace_back(ofGroup, *decision.plane, decision.distance(), decision.margin());
            }
            for (const WhyStep& step : why(*strategy.built(), frame.log, scene->firstTriangle(i)))
                if (step.plane) told.emplace_back(step.ofGroup, *step.plane, step.distance.value(), step.bound.value());
            EXPECT_EQ(told, tested) << "instance " << i;
            EXPECT_FALSE(told.empty());
            ++seen[size_t(groups[i].containment)];
        }
    }
    for (const int count : seen) EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace cullscope::test::why_groups_test
