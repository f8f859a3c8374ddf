#include "core/visibility/frustum_culling.h"

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"

namespace cullscope {
namespace {

enum class BoxTest { PVertex, Length };

double farthestInside(const Plane& plane, const EyeBounds& bounds, BoxTest test) {
    if (test == BoxTest::Length) return plane.distance(bounds.box.centre) + glm::length(bounds.box.half);
    return farthestInside(plane, bounds);
}

double farthestOutside(const Plane& plane, const EyeBounds& bounds, BoxTest test) {
    if (test == BoxTest::Length) return plane.distance(bounds.box.centre) - glm::length(bounds.box.half);
    return farthestOutside(plane, bounds);
}

class FrustumCulling final : public Strategy {
public:
    explicit FrustumCulling(ParameterSet set)
        : Strategy(std::move(set)), m_test(parameters().choice("box") == "length" ? BoxTest::Length : BoxTest::PVertex) {}

    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] Facing facing() const override { return m_facing; }
    [[nodiscard]] Inside inside(const Trace& trace) const override {
        Inside result;
        for (const TraceEvent& event : trace.events) {
            // The events of one object follow each other.
            if (result.nodes.empty() || result.nodes.back().instance != event.instance)
                result.nodes.push_back(untested(event.instance));
            InsideNode& node = result.nodes.back();
            if (event.kind == TraceEvent::Kind::Culled) {
                node.culled = true;
                node.cause = event.cause;
            } else if (event.kind == TraceEvent::Kind::TestedPlane && event.containment != Containment::Inside) {
                node.containment = event.containment;
                if (event.containment == Containment::Outside) node.rejectedBy = event.plane;
            }
        }
        return result;
    }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        m_facing = resolveFacing(parameters(), scene);
        // The bounds are the scene's own: nothing is built besides.
        report.bytes = scene.instances().size() * (sizeof(Box3) + sizeof(Sphere));
        report.figures = {{"objects", double(scene.instances().size())}};
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        const StageTimer stage(verdict, CULLSCOPE_TR("plane tests"));
        const auto count = static_cast<uint32_t>(scene().instances().size());
        for (uint32_t i = 0; i < count; ++i) {
            const uint64_t triangles = scene().meshOf(i).triangleCount();
            if (triangles == 0) continue;
            if (isOutside(view, i, trace)) {
                verdict.culledTriangles[static_cast<size_t>(Cause::OutsideFrustum)] += triangles;
                if (trace != nullptr) trace->events.push_back({TraceEvent::Kind::Culled, i});
                continue;
            }
            verdict.drawList.ranges.push_back({i, 0, static_cast<uint32_t>(triangles * 3)});
            if (trace != nullptr) trace->events.push_back({TraceEvent::Kind::Accepted, i});
        }
        verdict.nodesVisited = count;
        verdict.bytesTouched = count * (sizeof(Box3) + sizeof(Sphere));
    }

private:
    [[nodiscard]] InsideNode untested(uint32_t instance) const {
        InsideNode node;
        node.instance = instance;
        node.box = scene().instanceBox(instance);
        node.triangles = scene().meshOf(instance).triangleCount();
        node.containment = Containment::Inside;
        return node;
    }
    [[nodiscard]] bool isOutside(const View& view, uint32_t instance, Trace* trace) const {
        const EyeBounds bounds = boundsFromEye(scene(), instance, view.eye());
        for (size_t p = 0; p < view.frustum().planes.size(); ++p) {
            const double distance = farthestInside(view.frustum().planes[p], bounds, m_test);
            const bool outside = distance < -bounds.slack;
            if (trace != nullptr) {
                const bool inside = farthestOutside(view.frustum().planes[p], bounds, m_test) > bounds.slack;
                trace->events.push_back({TraceEvent::Kind::TestedPlane, instance, static_cast<FrustumPlane>(p),
                                         outside  ? Containment::Outside
                                         : inside ? Containment::Inside
                                                  : Containment::Straddles,
                                         distance, Cause::OutsideFrustum, bounds.slack});
            }
            if (outside) return true;
        }
        return false;
    }

    BoxTest m_test;
    Facing m_facing = Facing::TwoSided;
};

}  // namespace

StrategyInfo frustumInfo() {
    return {
        "frustum",
        CULLSCOPE_TR("View-frustum culling"),
        CULLSCOPE_TR("Leaves out objects whose bounds lie outside one of the six planes of the view."),
        "Assarsson & Möller 2000; Orangelie 2023",
        {facingParameter(), choiceParameter("box", "p-vertex", CULLSCOPE_TR("How a bounding box is tested against a plane."),
                                            {{"p-vertex", CULLSCOPE_TR("by its corner farthest inside")},
                                             {"length", CULLSCOPE_TR("by the length of its extent vector (wastes corners)")}})}};
}

StrategyPointer makeFrustum(ParameterSet parameters) { return std::make_unique<FrustumCulling>(std::move(parameters)); }

}  // namespace cullscope
