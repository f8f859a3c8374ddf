#include "core/visibility/frustum/frustum_box_tests.h"

#include <cmath>

#include "core/base/message.h"
#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::frustum {
namespace {

/// The lines of both listings (boxListing). A strategy that does not clamp depth has no line NearAndFar.
enum class BoxLine : uint8_t { Ask = 1, Objects, NearRectangle, NearAndFar, Hit, Draw, LeaveOut };

/// The result for an object before OpenGL is queried, or that it has to be.
enum class Answer { Visible, BeforeNear, BeyondFar, Asked };

/// The boxes that OpenGL tests in one cull.
struct GrownBoxes {
    std::vector<Answer> answers;          ///< by instance
    std::vector<uint32_t> instances;      ///< whose boxes OpenGL tests
    std::vector<EyeBox> boxes;            ///< of those, grown
    std::vector<double> growths;          ///< of those, while the frame is recorded: by how much
    std::vector<HitDistances> distances;  ///< of those, while the frame is recorded: of the hit records; empty: there are none
};

/// The length by which a box grows: a pixel's width at its farthest distance from the eye, plus the margin of a plane test.
double growthOf(const EyeBounds& bounds, const View& view) { return pixelAtFarthest(bounds.box, view) + bounds.margin; }

struct ObjectBoxes : Structure {
    using Structure::Structure;
};

/// The common part of both strategies: everything but the OpenGL test.
template <typename State = ViewState>
class FrustumBoxTests : public StrategyWith<ObjectBoxes, State> {
protected:
    void fill(ObjectBoxes& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        // The boxes are the scene's own; nothing else is built.
        const size_t objects = structure.scene().instances().size();
        structure.report.bytes = objects * sizeof(Box3);
        structure.report.figures = {{"objects", double(objects)}};
    }

    void decide(FrameContext& frame, const ObjectBoxes& /*structure*/, State& state,
                const ParameterSet& parameters) const override {
        const Scene& scene = frame.scene();
        std::vector<uint8_t> visible(scene.instances().size(), 0);
        GrownBoxes questions;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("boxes"));
            questions = grownBoxes(frame);
        }
        {
            const StageTimer stage(frame, CULLSCOPE_TR("asking OpenGL"));
            for (uint32_t i = 0; i < visible.size(); ++i) visible[i] = questions.answers[i] == Answer::Visible ? 1 : 0;
            const SelectedBoxes answer = ask(frame, std::move(questions.boxes), state, parameters);
            for (const uint32_t hit : answer.hits) visible[questions.instances[hit]] = 1;
            if (frame.recording()) {
                questions.distances.resize(answer.distances.empty() ? 0 : questions.instances.size());
                for (size_t i = 0; i < answer.distances.size(); ++i) questions.distances[answer.hits[i]] = answer.distances[i];
            }
        }
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
            if (frame.recording()) sayAnswers(frame, questions, visible);
            for (uint32_t i = 0; i < visible.size(); ++i) {
                const auto indices = static_cast<uint32_t>(scene.meshOf(i).indices().size());
                if (indices == 0) continue;
                if (visible[i] != 0)
                    list.ranges.push_back({i, 0, indices});
                else
                    frame.counters().culledTriangles[size_t(Cause::OutsideFrustum)] += indices / 3;
            }
            frame.counters().nodesVisited = visible.size();
            frame.counters().bytesTouched = visible.size() * sizeof(Box3);
        }
        frame.draw(std::move(list));
    }

    [[nodiscard]] Promise promiseOf(const ObjectBoxes& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const ObjectBoxes& structure, const FrameLog& log) const override {
        return objectNodes(log, structure.scene());
    }

    /// The boxes that OpenGL hits.
    [[nodiscard]] virtual SelectedBoxes ask(FrameContext& frame, std::vector<EyeBox> boxes, State& state,
                                            const ParameterSet& parameters) const = 0;
    /// Whether OpenGL also hits boxes before the near or beyond the far plane, so that they must be culled before the test.
    [[nodiscard]] virtual bool clampsDepth() const = 0;

private:
    /// The answer about one object; while the frame is recorded, says the tests that it comes from.
    [[nodiscard]] Answer answerTo(FrameContext& frame, uint32_t instance, const EyeBounds& bounds, const EyeBox& grown,
                                  double growth) const {
        const Frustum& frustum = frame.view().frustum();
        const Subject subject = Subject::ofObject(instance);
        if (!isDrawnInPlace(grown, frustum) || meetsNearRectangle(frustum, grown, bounds.margin)) {
            if (frame.recording()) frame.say(atLine(lineOf(BoxLine::NearRectangle), boxQuestion(subject, false, true, growth)));
            return Answer::Visible;
        }
        if (!clampsDepth()) return Answer::Asked;
        const auto isOutside = [&](FrustumPlane which) {
            const Plane& plane = frustum.planes[size_t(which)];
            const double inner = farthestInside(plane, bounds);
            if (frame.recording())
                frame.say(atLine(lineOf(BoxLine::NearAndFar), outsideTest(subject, which, inner, bounds.margin)));
            return inner < -bounds.margin;
        };
        if (isOutside(FrustumPlane::Near)) return Answer::BeforeNear;
        return isOutside(FrustumPlane::Far) ? Answer::BeyondFar : Answer::Asked;
    }

    [[nodiscard]] GrownBoxes grownBoxes(FrameContext& frame) const {
        const Scene& scene = frame.scene();
        GrownBoxes questions;
        questions.answers.assign(scene.instances().size(), Answer::Visible);
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            if (scene.meshOf(i).triangleCount() == 0) continue;
            const EyeBounds bounds = boundsFromEye(scene, i, frame.view().eye());
            const double growth = growthOf(bounds, frame.view());
            EyeBox grown = bounds.box;
            grown.halfExtent += Vec3(growth);
            const Answer answer = questions.answers[i] = answerTo(frame, i, bounds, grown, growth);
            if (answer == Answer::Asked) {
                questions.instances.push_back(i);
                questions.boxes.push_back(grown);
                if (frame.recording()) questions.growths.push_back(growth);
            } else if (frame.recording()) {
                sayEnd(frame, i, answer == Answer::Visible);
            }
        }
        return questions;
    }

    [[nodiscard]] uint8_t lineOf(BoxLine line) const {
        return uint8_t(uint8_t(line) - (clampsDepth() || line < BoxLine::NearAndFar ? 0 : 1));
    }

    /// What OpenGL answered about each box.
    void sayAnswers(FrameContext& frame, const GrownBoxes& questions, const std::vector<uint8_t>& visible) const {
        for (size_t i = 0; i < questions.instances.size(); ++i) {
            const uint32_t instance = questions.instances[i];
            const bool hit = visible[instance] != 0;
            Decision question = boxQuestion(Subject::ofObject(instance), true, hit, questions.growths[i]);
            if (hit && !questions.distances.empty()) {
                question.sentence =
                    CULLSCOPE_TR("OpenGL was asked about the box, grown by %1: it was hit, at depths from %2 to %3.");
                question.operands[1] = questions.distances[i].nearest;
                question.operands[2] = questions.distances[i].farthest;
                question.operandCount = 3;
            }
            frame.say(atLine(lineOf(BoxLine::Hit), question));
            sayEnd(frame, instance, hit);
        }
    }

    void sayEnd(FrameContext& frame, uint32_t instance, bool visible) const {
        frame.say(atLine(lineOf(visible ? BoxLine::Draw : BoxLine::LeaveOut),
                         ending(Subject::ofObject(instance), visible ? Decision::Outcome::Drawn : Decision::Outcome::Culled)));
    }

    static Decision boxQuestion(const Subject& subject, bool asked, bool visible, double growth) {
        Decision decision;
        decision.subject = subject;
        decision.containment = visible ? Containment::Straddles : Containment::Outside;
        decision.operands[0] = growth;
        decision.operandCount = 1;
        decision.sentence = !asked ? CULLSCOPE_TR("The box reaches the near rectangle of the view: it is visible without asking.")
                            : visible ? CULLSCOPE_TR("OpenGL was asked about the box, grown by %1: it was hit.")
                                      : CULLSCOPE_TR("OpenGL was asked about the box, grown by %1: nothing of it was hit.");
        return decision;
    }
};

struct HitBuffer : ViewState {
    size_t words = 0;  ///< the size that was large enough the last time; 0: none yet

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<HitBuffer>(*this); }
};

class FrustumSelect final : public FrustumBoxTests<HitBuffer> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<HitBuffer>(); }

protected:
    [[nodiscard]] SelectedBoxes ask(FrameContext& frame, std::vector<EyeBox> boxes, HitBuffer& buffer,
                                    const ParameterSet& parameters) const override {
        if (buffer.words == 0) buffer.words = size_t(parameters.integer("buffer"));
        SelectedBoxes selected = frame.selectBoxes(std::move(boxes), buffer.words);
        buffer.words = selected.bufferWords;
        frame.counters().figures.push_back({"hit_records", double(selected.hits.size())});
        frame.counters().figures.push_back({"hit_buffer_words", double(selected.bufferWords)});
        frame.counters().figures.push_back({"hit_buffer_overflows", double(selected.overflows)});
        return selected;
    }
    [[nodiscard]] bool clampsDepth() const override { return false; }

public:
    [[nodiscard]] std::string frameLine(const Structure& /*structure*/, const FrameLog& log) const override {
        for (const Command& command : log.commands) {
            const auto* asked = std::get_if<AskedBoxes>(&command);
            if (asked == nullptr || asked->bufferWords == 0) continue;
            std::string text = std::to_string(asked->hits.size()) + " hit records of " + std::to_string(asked->boxes.size()) +
                               " boxes in a buffer of " + std::to_string(asked->bufferWords) + " words, which overflowed " +
                               std::to_string(asked->overflows) + " times before";
            if (asked->distances.empty()) return text;
            const auto nearest = std::ranges::min(asked->distances, {}, &HitDistances::nearest);
            const auto farthest = std::ranges::max(asked->distances, {}, &HitDistances::farthest);
            return text + "; depths from " + Term::length(nearest.nearest).english() + " to " +
                   Term::length(farthest.farthest).english();
        }
        return {};
    }
};

class FrustumQuery final : public FrustumBoxTests<> {
protected:
    [[nodiscard]] SelectedBoxes ask(FrameContext& frame, std::vector<EyeBox> boxes, ViewState& /*state*/,
                                    const ParameterSet& /*parameters*/) const override {
        return {frame.visibleBoxes(std::move(boxes), BoxQuestion::Samples)};
    }
    [[nodiscard]] bool clampsDepth() const override { return true; }
};

/// `ask`: how OpenGL is asked.
Show boxListing(const char* ask, bool clampsDepth) {
    std::vector<ListingLine> lines{{ask, 0},
                                   {CULLSCOPE_TR("for each object"), 0},
                                   {CULLSCOPE_TR("box at near rectangle: in view"), 1},
                                   {CULLSCOPE_TR("outside near or far: not in view"), 1},
                                   {CULLSCOPE_TR("else in view if OpenGL hit it"), 1},
                                   {CULLSCOPE_TR("in view: draw it"), 1},
                                   {CULLSCOPE_TR("not in view: leave it out"), 1}};
    if (!clampsDepth) lines.erase(lines.begin() + uint8_t(BoxLine::NearAndFar) - 1);
    return listingShow(std::move(lines));
}

}  // namespace

RegisteredStrategy frustumSelect() {
    StrategyInfo info{
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
    info.withoutProfile = CULLSCOPE_TR(
        "\"%1\" draws in OpenGL's selection mode, which was removed from the core profile, and this OpenGL "
        "(%2) gives no compatibility profile: \"frustum-query\" asks the same without it.");
    info.shows = {treeShow(), boxListing(CULLSCOPE_TR("draw grown boxes for selection"), false)};
    return {std::move(info), std::make_shared<FrustumSelect>()};
}

RegisteredStrategy frustumQuery() {
    StrategyInfo info{
        "frustum-query",
        CULLSCOPE_TR("View-frustum culling by queries"),
        CULLSCOPE_TR("Draws the objects' boxes unseen, with an occlusion query each: those that cover a sample are in view."),
        "",
        {facingParameter()},
        GlRequirement::Context};
    info.shows = {treeShow(), boxListing(CULLSCOPE_TR("draw grown boxes, a query each"), true)};
    return {std::move(info), std::make_shared<FrustumQuery>()};
}

}  // namespace cullscope::frustum
