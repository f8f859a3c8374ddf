#include "core/visibility/frustum/frustum_box_tests.h"

#include <cmath>

#include "core/base/message.h"
#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::frustum {
namespace {

/// The result for an object before OpenGL is queried, or that it has to be.
enum class Answer { Visible, BeforeNear, BeyondFar, Asked };

/// The boxes that OpenGL tests in one cull.
struct GrownBoxes {
    std::vector<Answer> answers;      ///< by instance
    std::vector<uint32_t> instances;  ///< whose boxes OpenGL tests
    std::vector<EyeBox> boxes;        ///< of those, grown
};

/// The length by which a box grows: a pixel's width at its farthest distance from the eye, plus the margin of a plane test.
double growthOf(const EyeBounds& bounds, const View& view) {
    const Frustum& frustum = view.frustum();
    const double farthest =
        glm::dot(frustum.forward, bounds.box.centre) + glm::dot(glm::abs(frustum.forward), bounds.box.halfExtent);
    const double pixel = 2.0 * frustum.tanHalfHeight / view.viewport().height;
    return pixel * std::max(farthest, 0.0) + bounds.margin;
}

/// The common part of both strategies: everything but the OpenGL test.
class FrustumBoxTests : public Strategy {
public:
    using Strategy::Strategy;
    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override { return objectNodes(trace, scene()); }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        // The boxes are the scene's own; nothing else is built.
        report.bytes = scene.instances().size() * sizeof(Box3);
        report.figures = {{"objects", double(scene.instances().size())}};
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        std::vector<uint8_t> visible(scene().instances().size(), 0);
        GrownBoxes questions;
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("boxes"));
            questions = grownBoxes(view);
        }
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("asking OpenGL"));
            for (uint32_t i = 0; i < visible.size(); ++i) visible[i] = questions.answers[i] == Answer::Visible ? 1 : 0;
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

    /// The boxes that OpenGL hits, as indices into the span.
    [[nodiscard]] virtual std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) = 0;
    /// Whether OpenGL also hits boxes before the near or beyond the far plane, so that they must be culled before the test.
    [[nodiscard]] virtual bool clampsDepth() const = 0;

private:
    [[nodiscard]] Answer answerTo(const EyeBounds& bounds, const EyeBox& grown, const View& view) const {
        const Frustum& frustum = view.frustum();
        // Infinities, NaN and numbers beyond the range of float cannot be passed to OpenGL.
        const double farthest = glm::length(grown.centre) + glm::length(grown.halfExtent);
        if (!(farthest < 1e30) || meetsNearRectangle(frustum, grown, bounds.margin)) return Answer::Visible;
        if (!clampsDepth()) return Answer::Asked;
        const auto isOutside = [&](FrustumPlane plane) {
            return farthestInside(frustum.planes[size_t(plane)], bounds) < -bounds.margin;
        };
        if (isOutside(FrustumPlane::Near)) return Answer::BeforeNear;
        return isOutside(FrustumPlane::Far) ? Answer::BeyondFar : Answer::Asked;
    }

    [[nodiscard]] GrownBoxes grownBoxes(const View& view) const {
        GrownBoxes questions;
        questions.answers.assign(scene().instances().size(), Answer::Visible);
        for (uint32_t i = 0; i < scene().instances().size(); ++i) {
            if (scene().meshOf(i).triangleCount() == 0) continue;
            const EyeBounds bounds = boundsFromEye(scene(), i, view.eye());
            EyeBox grown = bounds.box;
            grown.halfExtent += Vec3(growthOf(bounds, view));
            questions.answers[i] = answerTo(bounds, grown, view);
            if (questions.answers[i] != Answer::Asked) continue;
            questions.instances.push_back(i);
            questions.boxes.push_back(grown);
        }
        return questions;
    }

    void record(const View& view, const GrownBoxes& questions, const std::vector<uint8_t>& visible, Trace& trace) const {
        for (uint32_t i = 0; i < visible.size(); ++i) {
            if (scene().meshOf(i).triangleCount() == 0) continue;
            recordAnswer(view, questions.answers[i], i, visible[i] != 0, trace);
            trace.events.push_back({visible[i] != 0 ? TraceEvent::Kind::Accepted : TraceEvent::Kind::Culled, i});
        }
    }

    void recordAnswer(const View& view, Answer answer, uint32_t instance, bool visible, Trace& trace) const {
        const EyeBounds bounds = boundsFromEye(scene(), instance, view.eye());
        if (answer == Answer::BeforeNear || answer == Answer::BeyondFar) {
            const FrustumPlane which = answer == Answer::BeforeNear ? FrustumPlane::Near : FrustumPlane::Far;
            const Plane& plane = view.frustum().planes[size_t(which)];
            addPlaneTest(trace, instance, which, farthestInside(plane, bounds), farthestOutside(plane, bounds), bounds.margin);
            return;
        }
        TraceEvent event{answer == Answer::Asked ? TraceEvent::Kind::AskedOpenGl : TraceEvent::Kind::MeetsNear, instance};
        event.containment = visible ? Containment::Straddles : Containment::Outside;
        event.bound = growthOf(bounds, view);
        trace.events.push_back(event);
    }
};

class FrustumSelect final : public FrustumBoxTests {
public:
    using FrustumBoxTests::FrustumBoxTests;

protected:
    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        FrustumBoxTests::buildStructures(scene, progress, report);
        m_bufferWords = size_t(parameters().integer("buffer"));
    }
    [[nodiscard]] std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) override {
        Renderer::SelectedBoxes selected = renderer().selectBoxes(view, boxes, m_bufferWords);
        m_bufferWords = selected.bufferWords;
        return std::move(selected.hits);
    }
    [[nodiscard]] bool clampsDepth() const override { return false; }

private:
    size_t m_bufferWords = 0;  ///< the size that was large enough the last time
};

class FrustumQuery final : public FrustumBoxTests {
public:
    using FrustumBoxTests::FrustumBoxTests;

protected:
    [[nodiscard]] std::vector<uint32_t> ask(const View& view, std::span<const EyeBox> boxes) override {
        return renderer().queryBoxes(view, boxes);
    }
    [[nodiscard]] bool clampsDepth() const override { return true; }
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
          1e7,
          "",
          CULLSCOPE_TR("Words of the hit buffer to begin with, four an object in view: one that overflows is doubled, and the "
                       "boxes are drawn again."),
          {}}},
        GlRequirement::CompatibilityProfile};
}

StrategyPointer makeFrustumSelect(ParameterSet parameters) { return std::make_unique<FrustumSelect>(std::move(parameters)); }

StrategyInfo frustumQueryInfo() {
    return {"frustum-query",
            CULLSCOPE_TR("View-frustum culling by queries"),
            CULLSCOPE_TR("Draws the objects' boxes unseen, with an occlusion query each: those that cover a sample are in view."),
            "",
            {facingParameter()},
            GlRequirement::Context};
}

StrategyPointer makeFrustumQuery(ParameterSet parameters) { return std::make_unique<FrustumQuery>(std::move(parameters)); }

}  // namespace cullscope::frustum
