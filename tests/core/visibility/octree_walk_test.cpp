#include "core/visibility/octree_walk.h"

#include <cstdio>
#include <optional>

#include "core/geometry/random.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/grouped_frustum.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::octree_walk_test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 500;
constexpr uint64_t kViewsPerScene = 20;

/// By instance, the planes of an object that one walk kept; none: culled.
using Kept = std::vector<std::optional<uint8_t>>;

Kept byInstance(const std::vector<KeptObject>& kept, size_t instances) {
    Kept result(instances);
    for (const KeptObject& object : kept) {
        EXPECT_FALSE(result[object.instance]) << "kept twice";
        result[object.instance] = object.planes;
    }
    return result;
}

/// An object's own bounds against one plane: the tighter of box and sphere, and their common margin.
struct OwnTest {
    double inner, outer, margin;
};

OwnTest ownTest(const Plane& plane, const Scene& scene, size_t instance, const Vec3& eye) {
    const EyeBox box = relativeToEye(scene.instanceBox(instance), eye);
    const Sphere& sphere = scene.instanceSphere(instance);
    const double centre = plane.distance(box.centre), reach = glm::dot(glm::abs(plane.normal), box.halfExtent);
    const double middle = plane.distance(sphere.centre - eye);
    return {std::min(centre + reach, middle + sphere.radius), std::max(centre - reach, middle - sphere.radius),
            conservativeMargin(glm::length(sphere.centre - eye) + sphere.radius) +
                (glm::length(sphere.centre) + glm::length(eye) + sphere.radius) * 0x1p-49};
}

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
        OctreeWalkCounters figures;
        const Kept kept = byInstance(keptObjects(octree, scene, view, &figures), scene.instances().size());
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
        EXPECT_EQ(figures.objectsCulled, culled);
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
        Trace trace;
        (void)keptObjects(octree, scene, view, nullptr, &trace);
        uint64_t culled = 0;
        for (const TestedGroup& group : trace.groups)
            if (group.containment == Containment::Outside) culled += octree.nodes()[group.node].count;
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

TEST(GroupWalkTrace, culledObjectsHaveAPlaneAndKeptOnesNone) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const ScenePointer scene = randomScene(seed);
        const InstanceOctree octree(*scene);
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            const View view(sample.camera, sample.viewport);
            Trace trace;
            OctreeWalkCounters figures;
            const Kept kept = byInstance(keptObjects(octree, *scene, view, &figures, &trace), scene->instances().size());
            EXPECT_EQ(kept, byInstance(keptObjects(octree, *scene, view), kept.size())) << "a trace changes the answer";
            EXPECT_EQ(trace.groups.size(), figures.nodesVisited);
            EXPECT_EQ(trace.events.size(), 2 * figures.objectsCulled);
            uint64_t triangles = 0;
            for (size_t e = 0; e + 1 < trace.events.size(); e += 2) {
                const TraceEvent &test = trace.events[e], &end = trace.events[e + 1];
                ASSERT_LT(test.instance, kept.size());
                EXPECT_FALSE(kept[test.instance]) << "events of a kept object";
                EXPECT_EQ(test.kind, TraceEvent::Kind::TestedPlane);
                EXPECT_EQ(test.containment, Containment::Outside);
                EXPECT_LT(test.distance, -test.bound);
                EXPECT_GT(test.bound, 0.0);
                const OwnTest own = ownTest(view.frustum().planes[size_t(test.plane)], *scene, test.instance, view.eye());
                EXPECT_NEAR(test.distance, own.inner, own.margin) << "not of its own bounds";
                EXPECT_EQ(end.kind, TraceEvent::Kind::Culled);
                EXPECT_EQ(end.cause, Cause::OutsideFrustum);
                EXPECT_EQ(end.instance, test.instance);
                triangles += scene->meshOf(end.instance).triangleCount();
            }
            EXPECT_EQ(triangles, figures.trianglesCulled);
        }
    }
}

TEST(GroupWalkTrace, boundIsTheOneThatDecided) {
    // Its stretched sphere extends farther than its box and has the larger margin; it lies in front of the near plane by a
    // distance between the two.
    const double groupMargin = (0.9 + 10.0) * 0x1p-20;
    const ScenePointer scene =
        copiesOf(boxMesh(Vec3f(-1), Vec3f(1)), {translation({0, 0, -0.9 + 1.3 * groupMargin}) * scaling({10, 0.1, 0.1})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 1, 100}, {64, 64});
    Trace trace;
    EXPECT_TRUE(keptObjects(InstanceOctree(*scene), *scene, view, nullptr, &trace).empty());
    ASSERT_EQ(trace.events.size(), 2u);
    EXPECT_EQ(trace.events[0].plane, FrustumPlane::Near);
    EXPECT_GT(ownTest(view.frustum().planes[4], *scene, 0, view.eye()).margin, -trace.events[0].distance);
    EXPECT_LT(trace.events[0].distance, -trace.events[0].bound);
}

/// A square field of n × n boxes with this spacing, about the origin.
ScenePointer field(int n, double spacing) {
    std::vector<Mat4> places;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) places.push_back(translation(spacing * Vec3(i - 0.5 * (n - 1), 0, j - 0.5 * (n - 1))));
    return copiesOf(boxMesh(Vec3f(-0.3f), Vec3f(0.3f)), places);
}

struct Walked {
    OctreeWalkCounters figures;
    size_t kept = 0;

    [[nodiscard]] uint64_t tests() const { return figures.nodesVisited + figures.objectsTested; }
};

Walked walked(const Scene& scene, const Camera& camera) {
    Walked result;
    result.kept = keptObjects(InstanceOctree(scene), scene, View(camera, {640, 480}), &result.figures).size();
    return result;
}

TEST(OctreeWalk, costGrowsWithTheBoundaryAndNotWithTheCount) {
    // The same square kilometre from the same place, with ever smaller spacing: √n objects lie on the frustum's boundary, n
    // inside.
    std::vector<Walked> at;
    for (const int n : {32, 100, 316}) {
        const ScenePointer scene = field(n, 1000.0 / n);
        at.push_back(walked(*scene, {{0, 300, 0}, {200, 0, 300}, {0, 1, 0}, Angle::fromDegrees(50), 1, 5000}));
        const uint64_t all = uint64_t(n) * uint64_t(n);
        EXPECT_EQ(at.back().kept + at.back().figures.objectsCulled, all);
        EXPECT_GT(at.back().kept, all / 20);
        EXPECT_GT(at.back().figures.objectsCulled, all / 20);
        EXPECT_LT(at.back().tests(), uint64_t(20 * n)) << n;
    }
    EXPECT_GT(at[2].kept, 50 * at[0].kept);
    EXPECT_LT(at[2].tests(), 15 * at[0].tests()) << "the boundary grew by ten";
}

TEST(OctreeWalk, costDoesNotGrowWithWhatIsNotInThePicture) {
    const Camera camera{{0.3, 2, 0.2}, {5, 0, 3}, {0, 1, 0}, Angle::fromDegrees(50), 0.1, 15};
    const Walked small = walked(*field(32, 1.5), camera), large = walked(*field(316, 1.5), camera);
    EXPECT_EQ(small.kept, large.kept);
    EXPECT_GT(small.kept, 20u);
    EXPECT_LT(large.tests(), small.tests() + 100) << "more than a path from the root";
}

TEST(OctreeWalk, planeThatHasAGroupInsideIsNotTestedBelowIt) {
    // From above, with a picture 90° wide whose one side plane stands vertically near the middle: no other plane cuts an object.
    const Angle fovy = Angle::fromRadians(2.0 * std::atan(480.0 / 640.0));
    const ScenePointer scene = field(100, 1.5);
    const Walked half = walked(*scene, {{13, 500, 0}, {513, 0, 0}, {0, 0, -1}, fovy, 1, 5000});
    EXPECT_GT(half.kept, 4'000u);
    EXPECT_GT(half.figures.objectsCulled, 3'000u);
    EXPECT_GT(half.tests(), 100u);
    EXPECT_LT(half.figures.planesTested, 2 * half.tests());
}

TEST(OctreeWalk, wholeSceneInsideOrOutsideTakesOneTest) {
    const ScenePointer scene = field(100, 1.5);
    const Camera over{{0, 500, 1}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 1, 1000};
    const Walked all = walked(*scene, over);
    EXPECT_EQ(all.kept, 10'000u);
    EXPECT_EQ(all.tests(), 1u);
    for (const KeptObject& object : keptObjects(InstanceOctree(*scene), *scene, View(over, {640, 480})))
        ASSERT_EQ(object.planes, 0);
    Camera away = over;
    away.target = {0, 1000, 0};
    const Walked none = walked(*scene, away);
    EXPECT_EQ(none.kept, 0u);
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
    const std::vector<KeptObject> kept = keptObjects(InstanceOctree(*scene), *scene, View(camera, {64, 64}));
    ASSERT_EQ(kept.size(), 1u) << "what cannot be placed is drawn, and nothing with it";
    EXPECT_EQ(kept[0].instance, 12u);
}

TEST(GroupNodes, verdictsAndPlacesFitThoseOfTheParents) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const ScenePointer scene = randomScene(seed);
        GroupedFrustum strategy;
        strategy.build(*scene);
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            Trace trace;
            (void)strategy.cull(View(sample.camera, sample.viewport), &trace);
            const StructureSnapshot snapshot = strategy.snapshot(trace);
            const size_t objects = scene->instances().size();
            ASSERT_EQ(snapshot.nodes.size(), objects + strategy.octree().nodes().size());
            for (size_t n = 0; n < snapshot.nodes.size(); ++n) {
                const SnapshotNode& node = snapshot.nodes[n];
                EXPECT_EQ(node.isGroup(), n >= objects);
                EXPECT_EQ(node.culled, node.containment == Containment::Outside);
                EXPECT_EQ(node.culled, node.rejectedBy.has_value());
                if (node.parent < 0) {
                    EXPECT_EQ(n, objects) << "two roots";
                    continue;
                }
                const SnapshotNode& parent = snapshot.nodes[size_t(node.parent)];
                ASSERT_TRUE(parent.isGroup());
                EXPECT_TRUE(glm::all(glm::lessThanEqual(parent.box.min, node.box.min)));
                EXPECT_TRUE(glm::all(glm::greaterThanEqual(parent.box.max, node.box.max)));
                if (parent.culled) {
                    EXPECT_TRUE(node.culled && node.rejectedBy == parent.rejectedBy);
                } else if (parent.containment == Containment::Inside) {
                    EXPECT_FALSE(node.culled);
                }
            }
        }
    }
}

TEST(GroupNodes, countsAddUp) {
    const ScenePointer scene = field(12, 1.5);
    GroupedFrustum strategy;
    strategy.build(*scene);
    const StructureSnapshot snapshot = strategy.snapshot({});
    std::vector<uint32_t> objects(snapshot.nodes.size(), 0);
    std::vector<uint64_t> triangles(snapshot.nodes.size(), 0);
    for (const SnapshotNode& node : snapshot.nodes) {
        EXPECT_FALSE(node.culled) << "nothing was decided";
        if (node.parent < 0) continue;
        objects[size_t(node.parent)] += node.objects;
        triangles[size_t(node.parent)] += node.triangles;
    }
    for (size_t n = 0; n < snapshot.nodes.size(); ++n) {
        if (!snapshot.nodes[n].isGroup()) continue;
        EXPECT_EQ(objects[n], snapshot.nodes[n].objects);
        EXPECT_EQ(triangles[n], snapshot.nodes[n].triangles);
    }
}

}  // namespace
}  // namespace cullscope::test::octree_walk_test
