// `clusters` with what the frame has drawn as that which hides clusters.

#include <map>

#include "core/base/error.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/lossless_scenes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::cluster_passes_test {
namespace {

using Places = std::map<uint32_t, std::set<uint32_t>>;  ///< of triangles, by object

/// A star before a wall of a thousand triangles, and three stars behind it, of which one looks out beside it.
ScenePointer starsAroundAWall() {
    std::vector<Vec3f> corners;
    std::vector<uint32_t> indices;
    constexpr int kSide = 24;
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x) corners.emplace_back(0.25f * float(x) - 3.0f, 0.25f * float(y) - 3.0f, -3.0f);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t at = y * (kSide + 1) + x;
            for (const uint32_t next : {at, at + 1, at + kSide + 1, at + 1, at + kSide + 2, at + kSide + 1})
                indices.push_back(next);
        }
    const MeshPointer star = starMesh(5, 4'000);
    return sceneOf({meshOf(corners, indices), star, star, star, star},
                   {Mat4(1.0), translation({0, 0, -2}) * scaling(Vec3(0.2)), translation({0, 0, -8}), translation({-1, 1, -10}),
                    translation({6, 0, -6})});
}

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {161, 121}}; }

CullerPointer passes(const Scene& scene) {
    CullerPointer culler = strategyWith("clusters", {{"occlusion", "hiz"}, {"size", "32"}});
    culler->build(scene);
    return culler;
}

Culled frameOf(Culler& culler, Recording recording) { return culler.cull(standardView(), recording, &GlEnvironment::renderer()); }

uint64_t hidden(const Culled& frame) { return frame.culledTriangles[size_t(Cause::Hidden)]; }

TEST(ClusterPasses, everyTriangleIsDrawnOrCountedAndClustersBehindTheWallAreHidden) {
    const ScenePointer scene = starsAroundAWall();
    const CullerPointer culler = passes(*scene);
    for (int number = 0; number < 4; ++number) {
        const Culled frame = frameOf(*culler, Recording::Off);
        uint64_t left = 0;
        for (const uint64_t count : frame.culledTriangles) left += count;
        EXPECT_EQ(left + frame.consideredTriangles, scene->triangleCount());
        if (number == 0) continue;
        // Of two stars all front faces, less than a half of the star beside the wall.
        EXPECT_GT(hidden(frame), 4'000u);
        std::set<uint32_t> objects;
        for (const DrawRange& range : frame.drawList.ranges) objects.insert(range.instance);
        EXPECT_EQ(objects, (std::set<uint32_t>{0, 1, 4}));
        EXPECT_LT(frame.consideredTriangles, scene->triangleCount() / 2);
    }
}

TEST(ClusterPasses, decisionsAreThoseOfWhatIsDrawnAndRecordingChangesNothing) {
    const ScenePointer scene = starsAroundAWall();
    const CullerPointer recorded = passes(*scene), measured = passes(*scene);
    for (int number = 0; number < 3; ++number) {
        const Culled frame = frameOf(*recorded, Recording::On);
        const Culled other = frameOf(*measured, Recording::Off);
        EXPECT_EQ(frame.drawList.ranges, other.drawList.ranges);
        EXPECT_EQ(frame.culledTriangles, other.culledTriangles);
        Places said, drawn;
        std::map<uint32_t, Decision::Outcome> ends;
        for (const Decision& decision : frame.log.decisions) {
            ASSERT_TRUE(decision.line >= 1 && decision.line <= 10);
            if (decision.outcome == Decision::Outcome::Open) continue;
            if (decision.subject.kind == Subject::Kind::Object) ends[decision.subject.number] = decision.outcome;
            if (decision.subject.kind != Subject::Kind::Cell || decision.outcome != Decision::Outcome::Drawn) continue;
            for (uint32_t place = decision.places.first; place < decision.places.first + decision.places.count; ++place)
                EXPECT_TRUE(said[decision.subject.object].insert(place).second) << "twice";
        }
        for (const Command& command : frame.log.commands)
            if (const auto* list = std::get_if<DrawList>(&command))
                for (const DrawRange& range : list->ranges)
                    for (uint32_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
                        drawn[range.instance].insert(place);
        EXPECT_EQ(said, drawn);
        ASSERT_EQ(ends.size(), scene->instances().size());
        for (const auto& [instance, outcome] : ends) {
            const size_t count = drawn.contains(instance) ? drawn[instance].size() : 0;
            EXPECT_EQ(outcome, count == 0                                         ? Decision::Outcome::Culled
                               : count == scene->meshOf(instance).triangleCount() ? Decision::Outcome::Drawn
                                                                                  : Decision::Outcome::PartlyDrawn)
                << instance;
        }
    }
}

TEST(ClusterPasses, whyOfAHiddenTriangleNamesThePyramid) {
    const ScenePointer scene = starsAroundAWall();
    const CullerPointer culler = passes(*scene);
    (void)frameOf(*culler, Recording::Off);
    const Culled frame = frameOf(*culler, Recording::On);
    const auto culled = std::ranges::find_if(frame.log.decisions, [](const Decision& decision) {
        return decision.subject.kind == Subject::Kind::Cell && decision.outcome == Decision::Outcome::Culled &&
               decision.cause == Cause::Hidden;
    });
    ASSERT_NE(culled, frame.log.decisions.end());
    const uint32_t mesh = scene->instances()[culled->subject.object].mesh;
    const uint64_t triangle =
        scene->firstTriangle(culled->subject.object) + triangleAt(frame.log.order.get(), mesh, culled->places.first);
    const std::vector<WhyStep> steps = why(*culler->built(), frame.log, triangle);
    const WhyStep* deciding = decidingStep(steps);
    ASSERT_NE(deciding, nullptr);
    EXPECT_THAT(deciding->sentence.english(), testing::HasSubstr("It lies behind all texels that it may cover on level"));
}

TEST(ClusterPasses, needsOpenGlOnlyWhereAPyramidHides) {
    const ScenePointer scene = starsAroundAWall();
    EXPECT_THROW((void)passes(*scene)->cull(standardView()), Error);
    const CullerPointer masked = strategyWith("clusters", {});
    masked->build(*scene);
    EXPECT_NO_THROW((void)masked->cull(standardView()));
}

}  // namespace
}  // namespace cullscope::test::cluster_passes_test
