#include "core/visibility/baseline/oracle.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::baseline {
namespace {

/// What the exact picture of the last view showed: of the same view it is not asked for again.
struct Known : ViewState {
    std::optional<Camera> camera;
    Viewport size;
    std::vector<uint32_t> visible;  ///< ascending

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<Known>(*this); }
    const std::vector<uint32_t>& of(FrameContext& frame) {
        const View& view = frame.view();
        if (camera == view.camera() && size == view.viewport()) return visible;
        visible = frame.visibleTriangles();
        camera = view.camera();
        size = view.viewport();
        return visible;
    }
};

enum class OracleLine : uint8_t { Known = 1, Objects, Draw, LeaveOut };

/// The visible triangles of one object, ascending.
std::span<const uint32_t> ofObject(const Scene& scene, uint32_t instance, std::span<const uint32_t> visible) {
    const uint64_t first = scene.firstTriangle(instance);
    const auto from = std::ranges::lower_bound(visible, first);
    const auto to = std::lower_bound(from, visible.end(), first + scene.meshOf(instance).triangleCount());
    return {from, to};
}

class Oracle final : public StrategyWith<Structure, Known> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Known>(); }

protected:
    void fill(Structure& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
    }
    void decide(FrameContext& frame, const Structure& structure, Known& known, const ParameterSet& parameters) const override {
        const Scene& scene = structure.scene();
        const std::vector<uint32_t>& visible = known.of(frame);
        sayBegin(frame, uint8_t(OracleLine::Known),
                 CULLSCOPE_TR("The exact picture shows %1 triangles. They are known beforehand, and in no time of the frame."),
                 {double(visible.size())});
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("listing"));
            const bool byObjects = parameters.choice("by") == "objects";
            for (uint32_t i = 0; i < scene.instances().size(); ++i) {
                const uint64_t all = scene.meshOf(i).triangleCount();
                if (all == 0) continue;
                const std::span<const uint32_t> own = ofObject(scene, i, visible);
                const uint64_t drawn = own.empty() ? 0 : byObjects ? all : own.size();
                frame.counters().culledTriangles[size_t(Cause::Hidden)] += all - drawn;
                if (drawn == all)
                    list.ranges.push_back({i, 0, uint32_t(3 * all)});
                else
                    addRuns(list, i, scene.firstTriangle(i), own);
                if (frame.recording()) frame.say(end(i, drawn, all));
            }
        }
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.choice("by") == "objects" ? Promise::Conservative : Promise::Exact;
    }

private:
    /// Ranges of consecutive triangles.
    static void addRuns(DrawList& list, uint32_t instance, uint64_t first, std::span<const uint32_t> triangles) {
        for (size_t i = 0; i < triangles.size(); ++i) {
            const auto place = uint32_t(3 * (triangles[i] - first));
            if (i > 0 && triangles[i] == triangles[i - 1] + 1)
                list.ranges.back().indexCount += 3;
            else
                list.ranges.push_back({instance, place, 3});
        }
    }
    [[nodiscard]] static Decision end(uint32_t instance, uint64_t drawn, uint64_t all) {
        const Subject subject = Subject::ofObject(instance);
        if (drawn == 0) return atLine(OracleLine::LeaveOut, ending(subject, Decision::Outcome::Culled, Cause::Hidden));
        const auto outcome = drawn == all ? Decision::Outcome::Drawn : Decision::Outcome::PartlyDrawn;
        return atLine(OracleLine::Draw, ending(subject, outcome, Cause::Hidden));
    }
};

}  // namespace

RegisteredStrategy oracle() {
    StrategyInfo info{
        "oracle",
        CULLSCOPE_TR("Oracle"),
        CULLSCOPE_TR("Draws exactly what is visible, known beforehand: what any culling could gain at most."),
        "",
        {facingParameter(), choiceParameter("by", "triangles", CULLSCOPE_TR("What is drawn where any of it is visible."),
                                            {{"triangles", CULLSCOPE_TR("the visible triangles")},
                                             {"objects", CULLSCOPE_TR("whole objects of which anything is visible")}})},
        GlRequirement::Context};
    info.limit = true;
    info.shows = {listingShow({{CULLSCOPE_TR("know what is visible (not timed)"), 0},
                               {CULLSCOPE_TR("for each object"), 0},
                               {CULLSCOPE_TR("draw what is visible of it"), 1},
                               {CULLSCOPE_TR("nothing: leave it out"), 1}})};
    return {std::move(info), std::make_shared<Oracle>()};
}

}  // namespace cullscope::baseline
