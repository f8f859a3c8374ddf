#include "core/visibility/frustum/frustum_culling.h"

#include "core/base/message.h"
#include "core/geometry/frustum_batch.h"
#include "core/geometry/oriented_box.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::frustum {
namespace {

enum class BoxTest { PVertex, Oriented, Length };

BoxTest boxTestFromId(const std::string& id) {
    if (id == "oriented") return BoxTest::Oriented;
    return id == "length" ? BoxTest::Length : BoxTest::PVertex;
}

/// Signed distances of an object's points farthest inside and farthest outside one plane; it is outside where inner < −bound.
struct PlaneTest {
    double inner = 0.0, outer = 0.0, bound = 0.0;

    [[nodiscard]] bool outside() const { return inner < -bound; }
};

/// The tighter of two bounds in both directions: the smaller inner distance with its margin, and the larger outer distance.
PlaneTest tighter(const BatchDistances& a, const BatchDistances& b) {
    const BatchDistances& nearer = a.farthestInside + a.margin <= b.farthestInside + b.margin ? a : b;
    return {nearer.farthestInside, std::max(a.farthestOutside, b.farthestOutside), nearer.margin};
}

class FrustumCulling final : public Strategy {
public:
    explicit FrustumCulling(ParameterSet set) : Strategy(std::move(set)), m_test(boxTestFromId(parameters().choice("box"))) {}

    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override { return objectNodes(trace, scene()); }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        std::vector<Box3> boxes;
        std::vector<Sphere> spheres;
        for (size_t i = 0; i < scene.instances().size(); ++i) {
            boxes.push_back(scene.instanceBox(i));
            spheres.push_back(scene.instanceSphere(i));
        }
        m_boxes.emplace(boxes);
        m_spheres.emplace(spheres);
        report.bytes = m_boxes->bytes() + m_spheres->bytes();
        report.figures = {{"objects", double(boxes.size())}, {"objects tested at a time", double(lanes())}};
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        const BatchFrustum frustum(view.frustum(), view.eye());
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("plane tests"));
            findOutsideObjects(view, frustum);
        }
        const StageTimer stage(verdict, CULLSCOPE_TR("draw list"));
        const auto count = static_cast<uint32_t>(scene().instances().size());
        for (uint32_t i = 0; i < count; ++i) {
            const uint64_t triangles = scene().meshOf(i).triangleCount();
            if (triangles == 0) continue;
            const bool outside = isOutside(i);
            if (trace != nullptr) record(view, frustum, i, *trace);
            if (outside)
                verdict.culledTriangles[static_cast<size_t>(Cause::OutsideFrustum)] += triangles;
            else
                verdict.drawList.ranges.push_back({i, 0, static_cast<uint32_t>(triangles * 3)});
        }
        verdict.nodesVisited = count;
        verdict.bytesTouched = m_boxes->bytes() + m_spheres->bytes();
    }

private:
    [[nodiscard]] static size_t lanes() {
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

    /// Sets the bit of every object that is outside.
    void findOutsideObjects(const View& view, const BatchFrustum& frustum) {
        if (m_test == BoxTest::Length) {
            m_outside.assign(m_boxes->wordCount(), 0);
            addOutside(view, frustum);
            return;
        }
        findOutside(*m_spheres, frustum, bestSimdLevel(), m_outside);
        if (m_test == BoxTest::Oriented) {
            addOutside(view, frustum);
            return;
        }
        findOutside(*m_boxes, frustum, bestSimdLevel(), m_outsideByBox);
        for (size_t word = 0; word < m_outside.size(); ++word) m_outside[word] |= m_outsideByBox[word];
    }

    /// Tests the objects that are not outside yet, one at a time.
    void addOutside(const View& view, const BatchFrustum& frustum) {
        for (uint32_t i = 0; i < m_boxes->size(); ++i) {
            if (isOutside(i)) continue;
            for (uint32_t p = 0; p < view.frustum().planes.size(); ++p) {
                if (!testOf(view, frustum, i, static_cast<FrustumPlane>(p)).outside()) continue;
                m_outside[i / 64] |= uint64_t{1} << (i % 64);
                break;
            }
        }
    }

    [[nodiscard]] bool isOutside(uint32_t instance) const { return (m_outside[instance / 64] >> (instance % 64) & 1) != 0; }

    /// The test of one object against one plane, as `decide` applies it to all objects.
    [[nodiscard]] PlaneTest testOf(const View& view, const BatchFrustum& frustum, uint32_t instance, FrustumPlane which) const {
        const BatchDistances sphere = frustum.distances(which, scene().instanceSphere(instance));
        if (m_test == BoxTest::PVertex) return tighter(sphere, frustum.distances(which, scene().instanceBox(instance)));
        const Plane& plane = view.frustum().planes[static_cast<size_t>(which)];
        const EyeBounds bounds = boundsFromEye(scene(), instance, view.eye());
        if (m_test == BoxTest::Length) {
            const double centre = plane.distance(bounds.box.centre), length = glm::length(bounds.box.halfExtent);
            // The margin of the batch test, so that this looser test never culls an object that the tighter one keeps.
            const double margin = std::max(sphere.margin, frustum.distances(which, scene().instanceBox(instance)).margin);
            return {centre + length, centre - length, margin};
        }
        const OrientedBox box = orientedBoxOf(instance, view.eye());
        return tighter(sphere, {pVertexDistance(plane, box), nVertexDistance(plane, box), bounds.margin});
    }

    /// The mesh's own box, transformed with the object.
    [[nodiscard]] OrientedBox orientedBoxOf(uint32_t instance, const Vec3& eye) const {
        const TriangleMesh& mesh = scene().meshOf(instance);
        const Instance& object = scene().instances()[instance];
        OrientedBox box = orientedBox(mesh.localBounds(), object.worldFromMesh, eye, mesh.origin());
        box.room += scene().pictureRounding(object);
        return box;
    }

    void record(const View& view, const BatchFrustum& frustum, uint32_t instance, Trace& trace) const {
        for (uint32_t p = 0; p < view.frustum().planes.size(); ++p) {
            const PlaneTest test = testOf(view, frustum, instance, static_cast<FrustumPlane>(p));
            addPlaneTest(trace, instance, static_cast<FrustumPlane>(p), test.inner, test.outer, test.bound);
            if (!test.outside()) continue;
            trace.events.push_back({TraceEvent::Kind::Culled, instance});
            return;
        }
        trace.events.push_back({TraceEvent::Kind::Accepted, instance});
    }

    BoxTest m_test;
    std::optional<BoxBatch> m_boxes;
    std::optional<SphereBatch> m_spheres;
    std::vector<uint64_t> m_outside, m_outsideByBox;  ///< results of the current `decide`
};

}  // namespace

StrategyInfo frustumInfo() {
    return {
        "frustum",
        CULLSCOPE_TR("View-frustum culling"),
        CULLSCOPE_TR("Leaves out objects whose bounds lie outside one of the six planes of the view."),
        "Assarsson & Möller 2000; Orangelie 2023",
        {facingParameter(),
         choiceParameter("box", "p-vertex", CULLSCOPE_TR("How a bounding box is tested against a plane."),
                         {{"p-vertex", CULLSCOPE_TR("by its corner farthest inside")},
                          {"oriented", CULLSCOPE_TR("the mesh's own box, turned with the object, by its corner farthest inside")},
                          {"length", CULLSCOPE_TR("by the length of its extent vector (wastes corners)")}})}};
}

StrategyPointer makeFrustum(ParameterSet parameters) { return std::make_unique<FrustumCulling>(std::move(parameters)); }

}  // namespace cullscope::frustum
