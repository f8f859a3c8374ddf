// The frustum family's records: in every combination of its parameters a recorded frame names the tests that were made, all of
// them that led to an answer, and in their order.

#include "core/geometry/frustum_batch.h"
#include "core/geometry/oriented_box.h"
#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::recorded_frustum_test {
namespace {

constexpr uint64_t kScenes = 12;
constexpr int kViews = 10;

CullerPointer strategy(const char* id, const char* key = nullptr, const char* value = nullptr) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    if (key != nullptr) parameters.setFromText(key, value);
    return makeCuller(id, parameters);
}

/// Calls `check(view)` for random views of random scenes, for which `build(scene)` was called.
template <typename Build, typename Check>
void forViews(const Build& build, const Check& check) {
    for (uint64_t seed = 1; seed <= kScenes; ++seed) {
        SCOPED_TRACE(seed);
        const ScenePointer scene = randomScene(seed);
        build(*scene);
        Random random(seed);
        for (int i = 0; i < kViews; ++i) {
            const RandomView sample = randomView(*scene, random);
            check(*scene, View(sample.camera, sample.viewport));
        }
    }
}

/// One plane test.
struct PlaneTest {
    FrustumPlane plane = FrustumPlane::Left;
    double inner = 0.0, margin = 0.0;

    [[nodiscard]] bool outside() const { return inner < -margin; }
    bool operator==(const PlaneTest&) const = default;
};

/// A plane test of an object.
struct ObjectTest : PlaneTest {
    uint32_t object = 0;

    bool operator==(const ObjectTest&) const = default;
};

PlaneTest tighter(const PlaneTest& a, const PlaneTest& b) { return a.inner + a.margin <= b.inner + b.margin ? a : b; }

/// The tests of a frame, made here: all spheres and then all boxes in batches; with an oriented box the boxes of those that are
/// not outside by their spheres, one object at a time; with the length of the box's extent those of all, one at a time.
class OwnTests {
public:
    OwnTests(const Scene& scene, const View& view, std::string box)
        : m_scene(scene), m_view(view), m_box(std::move(box)), m_batch(view.frustum(), view.eye()) {}

    [[nodiscard]] std::vector<ObjectTest> ofAll() const {
        std::vector<Sphere> spheres;
        std::vector<Box3> boxes;
        for (uint32_t i = 0; i < m_scene.instances().size(); ++i) {
            spheres.push_back(m_scene.instanceSphere(i));
            boxes.push_back(m_scene.instanceBox(i));
        }
        if (m_box == "length") return ofEach(std::vector<bool>(spheres.size(), false));
        std::vector<bool> outside(spheres.size(), false);
        std::vector<ObjectTest> tests = ofBatch(SphereBatch(spheres), outside);
        const std::vector<ObjectTest> more = m_box == "oriented" ? ofEach(outside) : ofBatch(BoxBatch(boxes), outside);
        tests.insert(tests.end(), more.begin(), more.end());
        return tests;
    }

private:
    /// In the order in which the batches test on this processor (frustum_batch_order_test.cpp).
    template <typename Batch>
    [[nodiscard]] std::vector<ObjectTest> ofBatch(const Batch& batch, std::vector<bool>& outside) const {
        std::vector<ObjectTest> tests;
        std::vector<uint64_t> bits;
        findOutside(batch, m_batch, bestSimdLevel(), bits, [&](uint32_t object, FrustumPlane plane, const PlaneReach& d) {
            if (m_scene.meshOf(object).triangleCount() == 0) return;
            tests.push_back({{plane, d.farthestInside, d.margin}, object});
            outside[object] = outside[object] || tests.back().outside();
        });
        return tests;
    }
    /// Of the others one after the other, each up to the first plane that it lies outside of.
    [[nodiscard]] std::vector<ObjectTest> ofEach(const std::vector<bool>& outside) const {
        std::vector<ObjectTest> tests;
        for (uint32_t i = 0; i < outside.size(); ++i) {
            if (outside[i] || m_scene.meshOf(i).triangleCount() == 0) continue;
            for (uint32_t p = 0; p < kFrustumPlaneCount; ++p) {
                tests.push_back({bounds(i, static_cast<FrustumPlane>(p)), i});
                if (tests.back().outside()) break;
            }
        }
        return tests;
    }
    [[nodiscard]] PlaneTest sphere(uint32_t instance, FrustumPlane which) const {
        const BatchDistances distances = m_batch.distances(which, m_scene.instanceSphere(instance));
        return {which, distances.farthestInside, distances.margin};
    }
    [[nodiscard]] PlaneTest bounds(uint32_t instance, FrustumPlane which) const {
        const BatchDistances box = m_batch.distances(which, m_scene.instanceBox(instance));
        const EyeBounds own = boundsFromEye(m_scene, instance, m_view.eye());
        const Plane& plane = m_view.frustum().planes[size_t(which)];
        if (m_box == "length")
            return {which, plane.distance(own.box.centre) + glm::length(own.box.halfExtent),
                    std::max(sphere(instance, which).margin, box.margin)};
        const Instance& object = m_scene.instances()[instance];
        const TriangleMesh& mesh = m_scene.meshOf(instance);
        OrientedBox turned = orientedBox(mesh.localBounds(), object.worldFromMesh, m_view.eye(), mesh.origin());
        turned.room += m_scene.pictureRounding(object);
        return tighter(sphere(instance, which), {which, pVertexDistance(plane, turned), own.margin});
    }

    const Scene& m_scene;
    const View& m_view;
    std::string m_box;
    BatchFrustum m_batch;
};

/// By instance, in their order.
std::vector<std::vector<PlaneTest>> said(const FrameLog& log, size_t instances) {
    std::vector<std::vector<PlaneTest>> tests(instances);
    for (const Decision& decision : log.decisions)
        if (isPlaneTest(decision))
            tests[decision.subject.number].push_back({*decision.plane, decision.distance(), decision.margin()});
    return tests;
}

TEST(RecordedFrustum, namesTheTestsInTheOrderInWhichTheBatchesMadeThemThenTheAnswers) {
    for (const char* box : {"p-vertex", "oriented", "length"}) {
        SCOPED_TRACE(box);
        size_t outside = 0;
        const CullerPointer culler = strategy("frustum", "box", box);
        forViews([&](const Scene& scene) { culler->build(scene); },
                 [&](const Scene& scene, const View& view) {
                     const FrameLog log = culler->cull(view, Recording::On).log;
                     const std::vector<ObjectTest> expected = OwnTests(scene, view, box).ofAll();
                     ASSERT_GT(log.decisions.size(), expected.size());
                     std::vector<bool> rejected(scene.instances().size(), false);
                     for (size_t i = 0; i < expected.size(); ++i) {
                         const Decision& said = log.decisions[i];
                         ASSERT_TRUE(isPlaneTest(said)) << i;
                         const ObjectTest test{{*said.plane, said.distance(), said.margin()}, said.subject.number};
                         ASSERT_EQ(test, expected[i]) << "test " << i << " of object " << said.subject.number;
                         EXPECT_EQ(said.line, test.outside() ? 4 : 3);
                         EXPECT_EQ(said.containment, test.outside() ? Containment::Outside : Containment::Straddles)
                             << "it is not tested whether all of the bounds lie inside";
                         EXPECT_EQ(said.operandCount, 2) << "the distance of one point, and the margin";
                         rejected[test.object] = rejected[test.object] || test.outside();
                     }
                     auto answer = log.decisions.begin() + ptrdiff_t(expected.size());
                     for (uint32_t i = 0; i < rejected.size(); ++i) {
                         if (scene.meshOf(i).triangleCount() == 0) continue;
                         ASSERT_NE(answer, log.decisions.end());
                         EXPECT_EQ(answer->subject, Subject::ofObject(i));
                         EXPECT_EQ(answer->outcome, rejected[i] ? Decision::Outcome::Culled : Decision::Outcome::Drawn) << i;
                         outside += rejected[i] ? 1 : 0;
                         ++answer;
                     }
                     EXPECT_EQ(answer, log.decisions.end());
                 });
        EXPECT_GT(outside, 100u);
    }
}

TEST(RecordedFrustum, namesAsManyTestsOfGroupsAndObjectsAsAMeasuredFrameCounts) {
    for (const char* refine : {"on", "off"}) {
        SCOPED_TRACE(refine);
        // Both remember from view to view which plane to test first.
        const CullerPointer recorded = strategy("frustum-octree", "refine", refine);
        const CullerPointer measured = strategy("frustum-octree", "refine", refine);
        double all = 0.0;
        forViews(
            [&](const Scene& scene) {
                recorded->build(scene);
                measured->build(scene);
            },
            [&](const Scene&, const View& view) {
                const FrameLog log = recorded->cull(view, Recording::On).log, plain = measured->cull(view).log;
                const double counted = plain.counters.figures.at(0).value;
                EXPECT_EQ(plain.counters.figures.at(0).name, "plane_tests");
                EXPECT_EQ(double(std::ranges::count_if(log.decisions, isPlaneTest)), counted);
                EXPECT_TRUE(std::string(refine) == "on" || std::ranges::none_of(log.decisions, isAxisTest));
                all += counted;
            });
        EXPECT_GT(all, 1000.0);
    }
}

TEST(RecordedFrustum, namesEveryBoxThatOpenGlWasAskedAboutWithItsAnswer) {
    for (const char* id : {"frustum-select", "frustum-query"}) {
        if (unavailable(findStrategy(id).info, GlEnvironment::info())) continue;
        SCOPED_TRACE(id);
        const bool clamps = std::string(id) == "frustum-query";
        const CullerPointer culler = strategy(id);
        size_t asked = 0;
        forViews([&](const Scene& scene) { culler->build(scene); },
                 [&](const Scene& scene, const View& view) {
                     const FrameLog log = culler->cull(view, Recording::On, &GlEnvironment::renderer()).log;
                     const AskedBoxes* boxes = nullptr;
                     for (const Command& command : log.commands)
                         if (const auto* found = std::get_if<AskedBoxes>(&command)) boxes = found;
                     ASSERT_NE(boxes, nullptr);
                     const std::vector<std::vector<PlaneTest>> tests = said(log, scene.instances().size());
                     std::vector<uint32_t> hits;
                     size_t number = 0;
                     for (const Decision& decision : log.decisions) {
                         if (isPlaneTest(decision)) {
                             EXPECT_NE(decision.containment, Containment::Inside) << "which is not tested";
                             EXPECT_EQ(decision.operandCount, 2);
                         }
                         if (!says(decision, "OpenGL was asked")) continue;
                         ASSERT_LT(number, boxes->boxes.size());
                         const EyeBox own = relativeToEye(scene.instanceBox(decision.subject.number), view.eye());
                         EXPECT_EQ(boxes->boxes[number].centre, own.centre);
                         EXPECT_EQ(boxes->boxes[number].halfExtent, own.halfExtent + Vec3(decision.operands[0]));
                         if (decision.containment != Containment::Outside) hits.push_back(uint32_t(number));
                         EXPECT_EQ(tests[decision.subject.number].size(), clamps ? 2u : 0u) << "near and far";
                         ++number;
                     }
                     EXPECT_EQ(number, boxes->boxes.size());
                     EXPECT_EQ(hits, boxes->hits);
                     asked += number;
                 });
        EXPECT_GT(asked, 500u);
    }
}

}  // namespace
}  // namespace cullscope::test::recorded_frustum_test
