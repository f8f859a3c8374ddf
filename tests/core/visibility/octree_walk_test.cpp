#include "core/visibility/octree_walk.h"

#include <cstdio>

#include "core/geometry/random.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"
#include "tests/support/walked.h"

namespace cullscope::test::octree_walk_test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 500;
constexpr uint64_t kViewsPerScene = 20;

struct Tally {
    uint64_t views = 0, objects = 0, visible = 0, culledInGroups = 0, culledAlone = 0, keptWhole = 0, keptInPart = 0;
};

class WalkProperty {
public:
    void run(uint64_t views) {
        for (uint64_t first = 0; first < views; first += kViewsPerScene) {
            m_seed = 5000 + first / kViewsPerScene;
            const ScenePointer scene = randomScene(m_seed);
            const InstanceOctree octree(*scene);
            Random random(m_seed * 7919);
            for (uint64_t view = first; view < std::min(views, first + kViewsPerScene); ++view)
                check(*scene, octree, randomView(*scene, random));
        }
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    void check(const Scene& scene, const InstanceOctree& octree, const RandomView& random) {
        const View view(random.camera, random.viewport);
        const Walked walk = walked(octree, scene, view);
        const Kept kept = byInstance(walk.objects, scene.instances().size());
        const ExactVisibility exact(random.camera, random.viewport);
        uint64_t culled = 0;
        for (size_t i = 0; i < kept.size(); ++i) {
            const bool visible = exact.judge(scene, i).visible;
            m_tally.visible += visible ? 1 : 0;
            EXPECT_TRUE(kept[i] || !visible) << "visible object culled: scene seed " << m_seed << " instance " << i << "; "
                                             << described(random.camera, random.viewport);
            culled += kept[i] ? 0 : 1;
            if (kept[i]) checkPlanes(scene, view, i, *kept[i]);
        }
        EXPECT_EQ(walk.figures.objectsCulled, culled);
        ++m_tally.views;
        m_tally.objects += kept.size();
        m_tally.culledAlone += culled - std::min(culled, culledInGroups(scene, octree, view));
        m_tally.culledInGroups += culledInGroups(scene, octree, view);
    }

    /// Checks that no plane rejects the object by more than rounding, that every plane of the mask may cut it, and that no other
    /// plane does.
    void checkPlanes(const Scene& scene, const View& view, size_t instance, uint8_t planes) {
        ++(planes == 0 ? m_tally.keptWhole : m_tally.keptInPart);
        for (size_t p = 0; p < 6; ++p) {
            const Plane& plane = view.frustum().planes[p];
            const OwnTest own = ownTest(plane, scene, instance, view.eye());
            EXPECT_GE(own.inner, -2.0 * own.margin) << "kept though outside: seed " << m_seed << " instance " << instance;
            if ((planes >> p & 1) != 0)
                EXPECT_LE(own.outer, 2.0 * own.margin) << "inside plane " << p << ": seed " << m_seed << " instance " << instance;
            else
                EXPECT_GE(leastDistance(scene, instance, plane, view.eye()), 0.0)
                    << "cut by plane " << p << ": seed " << m_seed << " instance " << instance;
        }
    }

    static double leastDistance(const Scene& scene, size_t instance, const Plane& plane, const Vec3& eye) {
        double least = std::numeric_limits<double>::infinity();
        const TriangleMesh& mesh = scene.meshOf(instance);
        for (size_t v = 0; v < mesh.vertexCount(); ++v) {
            const Vec3 world(scene.instances()[instance].worldFromMesh * Vec4(mesh.position(v), 1.0));
            least = std::min(least, plane.distance(world - eye));
        }
        return least;
    }

    static uint64_t culledInGroups(const Scene& scene, const InstanceOctree& octree, const View& view) {
        uint64_t culled = 0;
        for (const Decision& decision : walked(octree, scene, view, Recording::On).log.decisions)
            culled += decision.outcome == Decision::Outcome::Culled ? decision.objectCount : 0;
        return culled;
    }

    uint64_t m_seed = 0;
    Tally m_tally;
};

TEST(GroupWalkProperty, noVisibleObjectIsCulled) {
    WalkProperty property;
    property.run(howMany(kAllViews, kSample));
    const Tally& t = property.tally();
    std::printf(
        "long: group-walk-property views %llu objects %llu visible %llu culled-in-groups %llu culled-alone %llu kept-whole "
        "%llu kept-in-part %llu\n",
        static_cast<unsigned long long>(t.views), static_cast<unsigned long long>(t.objects),
        static_cast<unsigned long long>(t.visible), static_cast<unsigned long long>(t.culledInGroups),
        static_cast<unsigned long long>(t.culledAlone), static_cast<unsigned long long>(t.keptWhole),
        static_cast<unsigned long long>(t.keptInPart));
    // Guards against a vacuous pass: enough objects must be visible.
    EXPECT_GT(t.visible, t.views / 2);
    EXPECT_GT(t.culledInGroups, t.objects / 10);
    EXPECT_GT(t.culledAlone, t.objects / 100);
    EXPECT_GT(t.keptWhole, t.views / 20);
    EXPECT_GT(t.keptInPart, t.views / 2);
}

TEST(OctreeWalk, costGrowsWithTheBoundaryAndNotWithTheCount) {
    // The same square kilometre from the same place, with ever smaller spacing: √n objects lie on the frustum's boundary, n
    // inside.
    std::vector<Walked> at;
    for (const int n : {32, 100, 316}) {
        const ScenePointer scene = boxField(n, 1000.0 / n);
        at.push_back(walked(*scene, {{0, 300, 0}, {200, 0, 300}, {0, 1, 0}, Angle::fromDegrees(50), 1, 5000}));
        const uint64_t all = uint64_t(n) * uint64_t(n);
        EXPECT_EQ(at.back().kept() + at.back().figures.objectsCulled, all);
        EXPECT_GT(at.back().kept(), all / 20);
        EXPECT_GT(at.back().figures.objectsCulled, all / 20);
        EXPECT_LT(at.back().tests(), uint64_t(20 * n)) << n;
    }
    EXPECT_GT(at[2].kept(), 50 * at[0].kept());
    EXPECT_LT(at[2].tests(), 15 * at[0].tests()) << "the boundary grew by ten";
}

TEST(OctreeWalk, costDoesNotGrowWithWhatIsNotInThePicture) {
    const Camera camera{{0.3, 2, 0.2}, {5, 0, 3}, {0, 1, 0}, Angle::fromDegrees(50), 0.1, 15};
    const Walked small = walked(*boxField(32, 1.5), camera), large = walked(*boxField(316, 1.5), camera);
    EXPECT_EQ(small.kept(), large.kept());
    EXPECT_GT(small.kept(), 20u);
    EXPECT_LT(large.tests(), small.tests() + 100) << "more than a path from the root";
}

TEST(OctreeWalk, planeThatHasAGroupInsideIsNotTestedBelowIt) {
    // From above, with a picture 90° wide whose one side plane stands vertically near the middle: no other plane cuts an object.
    const Angle fovy = Angle::fromRadians(2.0 * std::atan(480.0 / 640.0));
    const ScenePointer scene = boxField(100, 1.5);
    const Walked half = walked(*scene, {{13, 500, 0}, {513, 0, 0}, {0, 0, -1}, fovy, 1, 5000});
    EXPECT_GT(half.kept(), 4'000u);
    EXPECT_GT(half.figures.objectsCulled, 3'000u);
    EXPECT_GT(half.tests(), 100u);
    EXPECT_LT(half.figures.planesTested, 2 * half.tests());
}

TEST(OctreeWalk, wholeSceneInsideOrOutsideTakesOneTest) {
    const ScenePointer scene = boxField(100, 1.5);
    const Camera over{{0, 500, 1}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 1, 1000};
    const Walked all = walked(*scene, over);
    EXPECT_EQ(all.kept(), 10'000u);
    EXPECT_EQ(all.tests(), 1u);
    for (const KeptObject& object : all.objects) ASSERT_EQ(object.planes, 0);
    Camera away = over;
    away.target = {0, 1000, 0};
    const Walked none = walked(*scene, away);
    EXPECT_EQ(none.kept(), 0u);
    EXPECT_EQ(none.tests(), 1u);
    EXPECT_EQ(none.figures.trianglesCulled, scene->triangleCount());
}

TEST(OctreeWalk, emptySceneIsNotVisitedAndWhatCannotBePlacedIsKept) {
    const Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100};
    EXPECT_EQ(walked(Scene("nothing", {}, {}), camera).figures.nodesVisited, 0u);
    std::vector<Mat4> places;
    for (int i = 0; i < 30; ++i) places.push_back(translation({100.0 + i, 0, 0}));
    places[12] = translation({std::nan(""), 0, 0});
    const ScenePointer scene = copiesOf(boxMesh(Vec3f(-0.3f), Vec3f(0.3f)), places);
    const std::vector<KeptObject> kept = walked(InstanceOctree(*scene), *scene, View(camera, {64, 64})).objects;
    ASSERT_EQ(kept.size(), 1u) << "what cannot be placed is drawn, and nothing with it";
    EXPECT_EQ(kept[0].instance, 12u);
}

}  // namespace
}  // namespace cullscope::test::octree_walk_test
