#include "core/visibility/frustum_asking.h"

#include <cmath>

#include "core/base/message.h"
#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope {
namespace {

/// What OpenGL is asked about in one cull.
struct Questions {
    std::vector<uint32_t> instances;
    std::vector<EyeBox> boxes;  ///< grown
};

/// How far a box grows: as much as a pixel spans where it lies farthest from the eye, and the slack of a plane test.
double growthOf(const EyeBounds& bounds, const View& view) {
    const Frustum& frustum = view.frustum();
    const double farthest = glm::dot(frustum.forward, bounds.box.centre) + glm::dot(glm::abs(frustum.forward), bounds.box.half);
    const double pixel = 2.0 * frustum.tanHalfHeight / view.viewport().height;
    return pixel * std::max(farthest, 0.0) + bounds.slack;
}

/// What both strategies share: everything but the question.
class FrustumAsking : public Strategy {
public:
    using Strategy::Strategy;
    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] Facing facing() const override { return m_facing; }
    [[nodiscard]] Inside inside(const Trace& trace) const override { return objectNodes(trace, scene()); }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        m_facing = resolveFacing(parameters(), scene);
        // The boxes are the scene's own: nothing is built besides.
        report.bytes = scene.instances().size() * sizeof(Box3);
        report.figures = {{"objects", double(scene.instances().size())}};
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        std::vector<uint8_t> visible(scene().instances().size(), 1);
        Questions questions;
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("boxes"));
            questions = questionsAbout(view);
        }
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("asking OpenGL"));
            for (const uint32_t instance : questions.instances) visible[instance] = 0;
            for (const uint32_t hit : ask(view, questions.boxes)) visible[questions.instances[hit]] = 1;
        }
        const StageTimer stage(verdict, CULLSCOPE_TR("draw list"));
        for (uint32_t i = 0; i < visible.size(); ++i) {
            const auto indices = static_cast<uint32_t>(scene().meshOf(i).indices().size());
            if (indices == 0) continue;
            if (visible[i] != 0)
                verdict.drawList.ranges.push_back({i, 0, indices});
            else
                verdict.culledTriangles[size_t(Cause::OutsideFrustum)] += indices / 3;
        }
        verdict.nodesVisited = visible.size();
        verdict.bytesTouched = visible.size() * sizeof(Box3);
        if (trace != nullptr) record(view, questions, visible, *trace);
    }

    /// Which of the boxes OpenGL hits: places in the span.
    [[nodiscard]] virtual std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) = 0;

private:
    /// The box as it is asked about; nothing where it is visible without asking.
    [[nodiscard]] static std::optional<EyeBox> questionAbout(const EyeBounds& bounds, const View& view) {
        EyeBox grown = bounds.box;
        grown.half += Vec3(growthOf(bounds, view));
        // OpenGL's floats hold neither what is not finite nor what is larger than they are.
        const double farthest = glm::length(grown.centre) + glm::length(grown.half);
        if (!(farthest < 1e30) || meetsNearRectangle(view.frustum(), grown, bounds.slack)) return std::nullopt;
        return grown;
    }

    [[nodiscard]] Questions questionsAbout(const View& view) const {
        Questions questions;
        for (uint32_t i = 0; i < scene().instances().size(); ++i) {
            if (scene().meshOf(i).triangleCount() == 0) continue;
            const std::optional<EyeBox> box = questionAbout(boundsFromEye(scene(), i, view.eye()), view);
            if (!box) continue;
            questions.instances.push_back(i);
            questions.boxes.push_back(*box);
        }
        return questions;
    }

    void record(const View& view, const Questions& questions, const std::vector<uint8_t>& visible, Trace& trace) const {
        size_t next = 0;
        for (uint32_t i = 0; i < visible.size(); ++i) {
            if (scene().meshOf(i).triangleCount() == 0) continue;
            const bool asked = next < questions.instances.size() && questions.instances[next] == i;
            next += asked ? 1 : 0;
            TraceEvent event{asked ? TraceEvent::Kind::AskedOpenGl : TraceEvent::Kind::MeetsNear, i};
            event.containment = visible[i] != 0 ? Containment::Straddles : Containment::Outside;
            event.bound = growthOf(boundsFromEye(scene(), i, view.eye()), view);
            trace.events.push_back(event);
            trace.events.push_back({visible[i] != 0 ? TraceEvent::Kind::Accepted : TraceEvent::Kind::Culled, i});
        }
    }

    Facing m_facing = Facing::TwoSided;
};

class FrustumSelect final : public FrustumAsking {
public:
    using FrustumAsking::FrustumAsking;

protected:
    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        FrustumAsking::buildStructures(scene, progress, report);
        m_bufferWords = size_t(parameters().integer("buffer"));
    }
    [[nodiscard]] std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) override {
        Renderer::SelectedBoxes selected = renderer().selectBoxes(view, boxes, m_bufferWords);
        m_bufferWords = selected.bufferWords;
        return std::move(selected.hits);
    }

private:
    size_t m_bufferWords = 0;  ///< as many as did the last time
};

class FrustumQuery final : public FrustumAsking {
public:
    using FrustumAsking::FrustumAsking;

protected:
    [[nodiscard]] std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) override {
        return renderer().queryBoxes(view, boxes);
    }
};

}  // namespace

StrategyInfo frustumSelectInfo() {
    return {
        "frustum-select",
        CULLSCOPE_TR("View-frustum culling by selection"),
        CULLSCOPE_TR("Draws the objects' boxes in OpenGL's selection mode: the hit records name the objects in view."),
        "Cho et al.",
        {facingParameter("two-sided"),
         {"buffer",
          ParameterType::Integer,
          int64_t{4096},
          1.0,
          1e9,
          "",
          CULLSCOPE_TR("Words of the hit buffer to begin with, four an object in view: one that overflows is doubled, and the "
                       "boxes are drawn again."),
          {}}},
        Asks::CompatibilityProfile};
}

StrategyPointer makeFrustumSelect(ParameterSet parameters) { return std::make_unique<FrustumSelect>(std::move(parameters)); }

StrategyInfo frustumQueryInfo() {
    return {"frustum-query",
            CULLSCOPE_TR("View-frustum culling by queries"),
            CULLSCOPE_TR("Draws the objects' boxes unseen, with an occlusion query each: those that cover a sample are in view."),
            "",
            {facingParameter()},
            Asks::OpenGl};
}

StrategyPointer makeFrustumQuery(ParameterSet parameters) { return std::make_unique<FrustumQuery>(std::move(parameters)); }

}  // namespace cullscope
