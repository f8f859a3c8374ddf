// The states of triangles after the first entries of a frame: what nothing was decided about yet is a state of its own.

#include "core/mesh/parametric.h"
#include "core/visibility/triangle_states.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::undecided_states_test {
namespace {

/// Rows of stars before, beside and behind the eye of `ahead`; those of every third row have triangles enough for cells.
ScenePointer rows() {
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int z = 0; z < 5; ++z)
        for (int x = -3; x <= 3; ++x) {
            meshes.push_back(starMesh(uint64_t(x + 5), z % 3 == 0 ? (fewSamples() ? 1000 : 2500) : 100));
            places.push_back(translation({4.0 * x, 0.3 * x, 12.0 - 6.0 * z}));
        }
    return sceneOf(std::move(meshes), places);
}

// A picture with few rows has a short log where each span of a row is a step.
View ahead() {
    const Viewport size = fewSamples() ? Viewport{40, 30} : Viewport{80, 60};
    return {{Vec3(0.0), {0.2, 0.1, -1}, {0, 1, 0}, Angle::fromDegrees(40), 0.5, 60}, size};
}

uint64_t undecided(const TriangleStates& states) { return states.counts[size_t(TriangleState::Undecided)]; }

/// By object: whether the log names it, or one of its groups or cells, in a decision that ends something, or draws of it.
std::vector<bool> namedObjects(const Scene& scene, const FrameLog& log) {
    std::vector<bool> named(scene.instances().size(), false);
    for (const Decision& decision : log.decisions) {
        if (decision.outcome == Decision::Outcome::Open) continue;
        if (decision.subject.object < named.size()) named[decision.subject.object] = true;
        for (const uint32_t instance : log.objectsOf(decision)) named[instance] = true;
    }
    for (const DrawRange& range : drawnTriangles(scene, log).ranges) named[range.instance] = true;
    return named;
}

TEST(UndecidedStates, areAllAtFirstNoneAtLastAndOnlyOfObjectsThatNothingWasDecidedAbout) {
    const ScenePointer scene = rows();
    for (const RegisteredStrategy& registered : strategies()) {
        if (unavailable(registered.info, GlEnvironment::info())) continue;
        SCOPED_TRACE(registered.info.id);
        Culler culler(registered);
        culler.build(*scene);
        const FrameLog log = culler.cull(ahead(), Recording::On, &GlEnvironment::renderer()).log;
        const TriangleStates whole = triangleStates(*scene, log, std::nullopt);
        EXPECT_EQ(undecided(whole), 0u);
        EXPECT_EQ(undecided(triangleStates(*scene, log.upTo(0), std::nullopt)), scene->triangleCount());
        EXPECT_EQ(triangleStates(*scene, log.upTo(log.entries()), std::nullopt).states, whole.states);
        uint64_t before = scene->triangleCount();
        for (size_t i = 1; i < 12; i += fewSamples() ? 4 : 1) {
            const FrameLog part = log.upTo(log.entries() * i / 12);
            if (part.whole) continue;
            const TriangleStates states = triangleStates(*scene, part, std::nullopt);
            EXPECT_LE(undecided(states), before) << "what was decided stays decided";
            before = undecided(states);
            const std::vector<bool> named = namedObjects(*scene, part);
            for (uint32_t instance = 0; instance < named.size(); ++instance) {
                const TriangleState state = states.states[scene->firstTriangle(instance)];
                EXPECT_TRUE(named[instance] || state == TriangleState::Undecided) << "object " << instance << ", part " << i;
            }
        }
    }
}

TEST(UndecidedStates, leaveStatesThatWereDecidedAsTheyAreAtTheEnd) {
    const ScenePointer scene = rows();
    for (const char* id : {"frustum", "frustum-octree"}) {
        SCOPED_TRACE(id);
        const CullerPointer culler = makeCuller(id);
        culler->build(*scene);
        const FrameLog log = culler->cull(ahead(), Recording::On).log;
        const TriangleStates whole = triangleStates(*scene, log, std::nullopt);
        size_t outside = 0, drawn = 0;
        for (size_t k = 0; k < log.entries(); k += 7) {
            const TriangleStates states = triangleStates(*scene, log.upTo(k), std::nullopt);
            for (size_t i = 0; i < states.states.size(); i += 17) {
                if (states.states[i] == TriangleState::Undecided) continue;
                const bool culled = states.states[i] == TriangleState::OutsideFrustum;
                EXPECT_EQ(culled, whole.states[i] == TriangleState::OutsideFrustum) << "triangle " << i << ", entry " << k;
                ++(culled ? outside : drawn);
            }
        }
        EXPECT_GT(outside, 100u);
        EXPECT_GT(drawn, 100u);
    }
}

TEST(UndecidedStates, areNotLostBesideTheTruth) {
    const ScenePointer scene = rows();
    const CullerPointer culler = makeCuller("frustum");
    culler->build(*scene);
    const FrameLog log = culler->cull(ahead(), Recording::On).log;
    std::vector<uint32_t> all(scene->triangleCount());
    for (uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const TriangleStates none = triangleStates(*scene, log.upTo(0), VisibleTriangles{all, Facing::TwoSided});
    EXPECT_EQ(undecided(none), scene->triangleCount());
    const TriangleStates whole = triangleStates(*scene, log, VisibleTriangles{all, Facing::TwoSided});
    EXPECT_EQ(undecided(whole), 0u);
    EXPECT_GT(whole.counts[size_t(TriangleState::WronglyCulled)], 0u);
}

}  // namespace
}  // namespace cullscope::test::undecided_states_test
