#include "core/visibility/frustum/frustum_culling.h"

#include "core/base/message.h"
#include "core/geometry/frustum_batch.h"
#include "core/geometry/oriented_box.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/frustum/plane_sources.h"
#include "core/visibility/frustum/rejected_objects.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::frustum {
namespace {

/// The lines of the listing (frustumListing).
enum class FrustumLine : uint8_t { Batches = 1, Planes, Distance, Beyond, Objects, Outside, Draw };

enum class BoxTest { PVertex, Oriented, Length, Sphere };

BoxTest boxTestFromId(const std::string& id) {
    if (id == "oriented") return BoxTest::Oriented;
    if (id == "sphere") return BoxTest::Sphere;
    return id == "length" ? BoxTest::Length : BoxTest::PVertex;
}

PlaneSource sourceFromId(const std::string& id) {
    if (id == "rows") return PlaneSource::Rows;
    if (id == "corners") return PlaneSource::Corners;
    return id == "as-published" ? PlaneSource::AsPublished : PlaneSource::Basis;
}

/// The tighter of two bounds: the smaller distance with its margin.
PlaneReach tighter(const PlaneReach& a, const PlaneReach& b) {
    return a.farthestInside + a.margin <= b.farthestInside + b.margin ? a : b;
}

[[nodiscard]] size_t lanes() {
    switch (bestSimdLevel()) {
        case SimdLevel::Avx512:
            return 8;
        case SimdLevel::Avx2:
            return 4;
        case SimdLevel::Scalar:
            break;
    }
    return 1;
}

struct ObjectBatches : Structure {
    using Structure::Structure;
    std::optional<BoxBatch> boxes;
    std::optional<SphereBatch> spheres;
};

/// The mesh's own box, transformed with the object.
OrientedBox orientedBoxOf(const Scene& scene, uint32_t instance, const Vec3& eye) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Instance& object = scene.instances()[instance];
    OrientedBox box = orientedBox(mesh.localBounds(), object.worldFromMesh, eye, mesh.origin());
    box.room += scene.pictureRounding(object);
    return box;
}

/// The tests of one frame.
class ObjectTests {
public:
    ObjectTests(FrameContext& frame, const ObjectBatches& batches, BoxTest test, PlaneSource source)
        : m_frame(frame),
          m_batches(batches),
          m_test(test),
          m_sourced(frustumFrom(frame.view(), source)),
          m_frustum(m_sourced.frustum, frame.view().eye()) {
        if (source == PlaneSource::AsPublished) m_published = publishedPlanes(frame.view());
        if (!m_sourced.kept) frame.counters().figures.push_back({"planes_of_the_basis", 1.0});
        findOutsideObjects();
    }

    [[nodiscard]] bool isOutside(uint32_t instance) const { return (m_outside[instance / 64] >> (instance % 64) & 1) != 0; }

private:
    /// Sets the bit of every object that is outside. While the frame is recorded, each test is said where the batch makes it.
    void findOutsideObjects() {
        if (m_test == BoxTest::Length || m_published) {
            m_outside.assign(m_batches.boxes->wordCount(), 0);
            addOutside();
            return;
        }
        BatchTestTold told;
        if (m_frame.recording()) told = [this](uint32_t i, FrustumPlane plane, const PlaneReach& reach) { say(i, plane, reach); };
        findOutside(*m_batches.spheres, m_frustum, bestSimdLevel(), m_outside, told);
        if (m_test == BoxTest::Sphere) return;
        if (m_test == BoxTest::Oriented) {
            addOutside();
            return;
        }
        std::vector<uint64_t> outsideByBox;
        findOutside(*m_batches.boxes, m_frustum, bestSimdLevel(), outsideByBox, told);
        for (size_t word = 0; word < m_outside.size(); ++word) m_outside[word] |= outsideByBox[word];
    }

    /// Tests the objects that are not outside yet, one at a time.
    void addOutside() {
        for (uint32_t i = 0; i < m_batches.boxes->size(); ++i)
            if (!isOutside(i) && scene().meshOf(i).triangleCount() > 0 && testOne(i))
                m_outside[i / 64] |= uint64_t{1} << (i % 64);
    }

    /// Whether an object is outside a plane.
    [[nodiscard]] bool testOne(uint32_t instance) const {
        for (uint32_t p = 0; p < kFrustumPlaneCount; ++p) {
            const auto plane = static_cast<FrustumPlane>(p);
            const PlaneReach reach = reachOf(instance, plane);
            if (m_frame.recording()) say(instance, plane, reach);
            if (reach.outside()) return true;
        }
        return false;
    }

    void say(uint32_t instance, FrustumPlane plane, const PlaneReach& reach) const {
        if (scene().meshOf(instance).triangleCount() == 0) return;
        m_frame.say(atLine(reach.outside() ? FrustumLine::Beyond : FrustumLine::Distance,
                           outsideTest(Subject::ofObject(instance), plane, reach.farthestInside, reach.margin)));
    }

    /// How far one object by itself reaches inside one plane.
    [[nodiscard]] PlaneReach reachOf(uint32_t instance, FrustumPlane which) const {
        if (m_published) return publishedReach(instance, (*m_published)[static_cast<size_t>(which)]);
        const View& view = m_frame.view();
        const BatchDistances sphere = m_frustum.distances(which, scene().instanceSphere(instance));
        const Plane& plane = m_sourced.frustum.planes[static_cast<size_t>(which)];
        const EyeBounds bounds = boundsFromEye(scene(), instance, view.eye());
        if (m_test == BoxTest::Length) {
            const double centre = plane.distance(bounds.box.centre), length = glm::length(bounds.box.halfExtent);
            // The margin of the batch test, so that this looser test never culls an object that the tighter one keeps.
            const double margin = std::max(sphere.margin, m_frustum.distances(which, scene().instanceBox(instance)).margin);
            return {centre + length, margin};
        }
        const OrientedBox box = orientedBoxOf(scene(), instance, view.eye());
        return tighter({sphere.farthestInside, sphere.margin}, {pVertexDistance(plane, box), bounds.margin});
    }

    /// The blog's test as printed, without a margin: the object's own position, and its radius or, of a box, the length of its
    /// extent vector. Normals point outward and are not of unit length, and neither are these distances.
    [[nodiscard]] PlaneReach publishedReach(uint32_t instance, const Plane& plane) const {
        const Vec3 position(scene().instances()[instance].worldFromMesh[3]);
        const double extent = m_test == BoxTest::Sphere ? scene().instanceSphere(instance).radius
                                                        : glm::length(scene().instanceBox(instance).halfExtent());
        return {extent - plane.distance(position), 0.0};
    }

    [[nodiscard]] const Scene& scene() const { return m_frame.scene(); }

    FrameContext& m_frame;
    const ObjectBatches& m_batches;
    BoxTest m_test;
    SourcedFrustum m_sourced;
    std::optional<FrustumPlanes> m_published;
    BatchFrustum m_frustum;
    std::vector<uint64_t> m_outside;
};

class FrustumCulling final : public StrategyWith<ObjectBatches> {
public:
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return rejectedObjects(log, structure.scene(), false);
    }

protected:
    void fill(ObjectBatches& batches, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        const Scene& scene = batches.scene();
        std::vector<Box3> boxes;
        std::vector<Sphere> spheres;
        for (size_t i = 0; i < scene.instances().size(); ++i) {
            boxes.push_back(scene.instanceBox(i));
            spheres.push_back(scene.instanceSphere(i));
        }
        batches.boxes.emplace(boxes);
        batches.spheres.emplace(spheres);
        batches.report.bytes = batches.boxes->bytes() + batches.spheres->bytes();
        batches.report.figures = {{"objects", double(boxes.size())}, {"objects tested at a time", double(lanes())}};
    }

    void decide(FrameContext& frame, const ObjectBatches& batches, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        frame.draw(listed(frame, batches, boxTestFromId(parameters.choice("box")), sourceFromId(parameters.choice("planes"))));
    }

    [[nodiscard]] Promise promiseOf(const ObjectBatches& /*batches*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return sourceFromId(parameters.choice("planes")) == PlaneSource::AsPublished ? Promise::Approximate
                                                                                     : Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const ObjectBatches& batches, const FrameLog& log) const override {
        return objectNodes(log, batches.scene());
    }

private:
    [[nodiscard]] static DrawList listed(FrameContext& frame, const ObjectBatches& batches, BoxTest test, PlaneSource source) {
        std::optional<ObjectTests> tests;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("plane tests"));
            tests.emplace(frame, batches, test, source);
        }
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
            for (uint32_t i = 0; i < frame.scene().instances().size(); ++i) {
                const uint64_t triangles = frame.scene().meshOf(i).triangleCount();
                if (triangles == 0) continue;
                const bool outside = tests->isOutside(i);
                if (outside)
                    frame.counters().culledTriangles[static_cast<size_t>(Cause::OutsideFrustum)] += triangles;
                else
                    list.ranges.push_back({i, 0, static_cast<uint32_t>(triangles * 3)});
                if (frame.recording())
                    frame.say(
                        atLine(outside ? FrustumLine::Outside : FrustumLine::Draw,
                               ending(Subject::ofObject(i), outside ? Decision::Outcome::Culled : Decision::Outcome::Drawn)));
            }
            frame.counters().nodesVisited = frame.scene().instances().size();
            frame.counters().bytesTouched = batches.report.bytes;
        }
        return list;
    }
};

Show frustumListing() {
    return listingShow({{CULLSCOPE_TR("for batches of spheres, then of boxes"), 0},
                        {CULLSCOPE_TR("for each plane, until all are outside"), 1},
                        {CULLSCOPE_TR("d = how far each one reaches in"), 2},
                        {CULLSCOPE_TR("outside: those with d < −margin"), 2},
                        {CULLSCOPE_TR("for each object"), 0},
                        {CULLSCOPE_TR("outside: leave it out"), 1},
                        {CULLSCOPE_TR("else draw it"), 1}});
}

}  // namespace

RegisteredStrategy frustum() {
    StrategyInfo info{
        "frustum",
        CULLSCOPE_TR("View-frustum culling"),
        CULLSCOPE_TR("Leaves out objects whose bounds lie outside one of the six planes of the view."),
        "Assarsson & Möller 2000; Orangelie 2023",
        {facingParameter(),
         choiceParameter("box", "p-vertex", CULLSCOPE_TR("How a bounding box is tested against a plane."),
                         {{"p-vertex", CULLSCOPE_TR("by its corner farthest inside")},
                          {"oriented", CULLSCOPE_TR("the mesh's own box, turned with the object, by its corner farthest inside")},
                          {"length", CULLSCOPE_TR("by the length of its extent vector (wastes corners)")},
                          {"sphere", CULLSCOPE_TR("not at all: the bounding sphere by its radius")}}),
         choiceParameter("planes", "basis", CULLSCOPE_TR("Where the six planes come from."),
                         {{"basis", CULLSCOPE_TR("the camera's basis")},
                          {"rows", CULLSCOPE_TR("rows of the clip matrix (Gribb & Hartmann 2001)")},
                          {"corners", CULLSCOPE_TR("corners of the inverse clip cube (Orangelie 2023, mended)")},
                          {"as-published", CULLSCOPE_TR("the same as printed, with radius or extent length: loses objects")}})}};
    info.shows = {treeShow(), planesShow(), frustumListing(), rejectedObjectsShow()};
    return {std::move(info), std::make_shared<FrustumCulling>()};
}

}  // namespace cullscope::frustum
