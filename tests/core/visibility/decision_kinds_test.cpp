// The kinds of decisions at which a replay can stop, of every registered strategy: each stops at decisions of that kind alone.

#include <map>

#include "core/frame/entry_kinds.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_polygons.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::decision_kinds_test {
namespace {

struct Shot {
    ScenePointer scene;
    View view;
};

/// Polygons that are cut; bodies of many triangles that hide each other, behind the eye and beside it.
std::vector<Shot> shots() {
    std::vector<Shot> result;
    const auto whole = [&](const ScenePointer& scene) {
        result.push_back({scene, View(overviewCamera(*scene, 4.0 / 3.0), {96, 72})});
    };
    whole(openScene("quiz").scene);
    for (uint64_t seed = 0; seed < 2 * kMeetings; ++seed) whole(randomPolygons(seed));
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int z = 0; z < 4; ++z)
        for (int x = -1; x <= 1; ++x) {
            meshes.push_back(starMesh(uint64_t(x + 5), z == 0 ? 600 : 100));
            places.push_back(translation({4.0 * x, 0.3 * x, 12.0 - 6.0 * z}));
        }
    const ScenePointer rows = sceneOf(std::move(meshes), places);
    for (const Vec3& eye : {Vec3(0.0), Vec3(0, 0, 30), Vec3(0, 0, 400)})
        result.push_back({rows, View({eye, {0.2, 0.1, -1}, {0, 1, 0}, Angle::fromDegrees(50), 0.05, 1000}, {96, 72})});
    return result;
}

/// A recorded frame of a strategy with parameters.
FrameLog frameOf(const RegisteredStrategy& strategy, const ParameterSet& parameters, const Shot& shot) {
    Culler culler(strategy, parameters);
    culler.build(*shot.scene);
    (void)culler.cull(shot.view, Recording::Off, &GlEnvironment::renderer());
    return culler.cull(shot.view, Recording::On, &GlEnvironment::renderer()).log;
}

/// By instance: how many triangles a frame has of it, each once or, in parts, several times.
std::map<uint32_t, std::set<uint64_t>> drawnOf(const Scene& scene, const FrameLog& log) {
    std::map<uint32_t, std::set<uint64_t>> drawn;
    const DrawList list = drawnTriangles(scene, log);
    for (const DrawRange& range : list.ranges)
        for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            drawn[range.instance].insert(list.triangleAt(scene.instances()[range.instance].mesh, place));
    return drawn;
}

std::set<EntryKind::Trait> traitsOf(const Decision& decision) {
    std::set<EntryKind::Trait> traits;
    for (const EntryKind& kind : kindsOf({nullptr, &decision, 0})) traits.insert(kind.trait);
    return traits;
}

TEST(DecisionKinds, aDecisionWhoseSubjectIsDrawnHasNoCauseOfBeingLeftOut) {
    using Outcome = Decision::Outcome;
    const std::vector<Shot> all = shots();
    for (const RegisteredStrategy& strategy : strategies()) {
        if (unavailable(strategy.info, GlEnvironment::info())) continue;
        for (const Shot& shot : all) {
            const FrameLog log = frameOf(strategy, ParameterSet(strategy.info.parameters), shot);
            const auto drawn = drawnOf(*shot.scene, log);
            for (const Decision& decision : log.decisions) {
                const bool caused = traitsOf(decision).contains(EntryKind::Trait::Cause);
                const bool leavesOut = decision.outcome == Outcome::Culled || decision.outcome == Outcome::PartlyDrawn;
                ASSERT_EQ(caused, leavesOut) << strategy.info.id;
                const bool parts = decision.subject.kind == Subject::Kind::Object || decision.subject.kind == Subject::Kind::Node;
                ASSERT_TRUE(decision.outcome != Outcome::PartlyDrawn || parts)
                    << strategy.info.id << ": what is said of one part of a triangle, or of pixels, is drawn or is not";
                if (decision.outcome != Outcome::PartlyDrawn || decision.subject.kind != Subject::Kind::Object) continue;
                const uint32_t object = decision.subject.number;
                const auto found = drawn.find(object);
                const size_t shown = found == drawn.end() ? 0 : found->second.size();
                EXPECT_LT(shown, shot.scene->meshOf(object).triangleCount())
                    << strategy.info.id << ": of object " << object << " nothing is left out";
            }
        }
    }
}

TEST(DecisionKinds, ofAFrameByOrderNoneIsOneOfLeavingOut) {
    const ScenePointer quiz = openScene("quiz").scene;
    const Shot shot{quiz, View(overviewCamera(*quiz, 4.0 / 3.0), {96, 72})};
    for (const auto& [id, plane] : {std::pair("bsp", "given"), std::pair("bsp", "balance"), std::pair("painter", "")}) {
        const RegisteredStrategy& strategy = findStrategy(id);
        ParameterSet parameters(strategy.info.parameters);
        if (*plane != '\0') parameters.setFromText("plane", plane);
        const FrameLog log = frameOf(strategy, parameters, shot);
        size_t drawn = 0;
        for (const auto& [kind, count] : countKinds(log)) {
            EXPECT_NE(kind.trait, EntryKind::Trait::Cause) << id << ": " << kindWords(kind, {}).english() << ", " << count;
            if (kind == EntryKind{EntryKind::Trait::Outcome, uint8_t(Decision::Outcome::Drawn)}) drawn = count;
        }
        EXPECT_GT(drawn, quiz->triangleCount()) << id << ": its parts, of which some triangle has several";
    }
}

}  // namespace
}  // namespace cullscope::test::decision_kinds_test
