#include "core/visibility/baseline/recorded.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/geometry/frustum.h"
#include "core/scene/drawn_sets.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::baseline {
namespace {

constexpr const char* kFile = "file";

enum class RecordedLine : uint8_t { Pose = 1, Objects, Draw, LeaveOut };

struct RecordedSets : Structure {
    using Structure::Structure;
    DrawnSets sets;  ///< empty without a file, by which nothing is decided then
};

class Recorded final : public StrategyWith<RecordedSets> {
protected:
    void fill(RecordedSets& structure, const ParameterSet& parameters, const Progress& /*progress*/) const override {
        const std::string& file = parameters.choice(kFile);
        structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
        if (file.empty()) return;
        structure.sets = readDrawnSets(file, structure.scene());
        if (structure.sets.path.poses.empty())
            throwInput(CULLSCOPE_TR("%1 has no cameras beside its sets, by which a view would find its own: give every pose eye, "
                                    "target and up."),
                       {file});
        structure.report.figures.push_back({"poses", double(structure.sets.poses.size())});
        for (const DrawnSets::Triangles& pose : structure.sets.poses) structure.report.bytes += pose.size() * sizeof(pose[0]);
    }
    void decide(FrameContext& frame, const RecordedSets& structure, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        const Scene& scene = structure.scene();
        const size_t pose = structure.sets.nearestPose(frame.view().camera());
        sayBegin(frame, uint8_t(RecordedLine::Pose),
                 CULLSCOPE_TR("The camera of pose %1 of the file is the nearest one: its set is drawn."), {double(pose)});
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("listing"));
            for (uint32_t i = 0; i < scene.instances().size(); ++i) {
                const uint64_t all = scene.meshOf(i).triangleCount();
                if (all == 0) continue;
                const uint64_t drawn = addRanges(list, scene, i, structure.sets.poses[pose]);
                const Cause cause = outside(scene, i, frame.view()) ? Cause::OutsideFrustum : Cause::Hidden;
                frame.counters().culledTriangles[size_t(cause)] += all - drawn;
                if (frame.recording()) frame.say(end(i, drawn, all, cause));
            }
        }
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const RecordedSets& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }

private:
    /// What is drawn of one object; returns how many of its triangles.
    static uint64_t addRanges(DrawList& list, const Scene& scene, uint32_t instance, const DrawnSets::Triangles& triangles) {
        const uint64_t begin = scene.firstTriangle(instance), end = begin + scene.meshOf(instance).triangleCount();
        auto range = std::ranges::upper_bound(triangles, begin, {}, &std::pair<uint64_t, uint64_t>::second);
        uint64_t drawn = 0;
        for (; range != triangles.end() && range->first < end; ++range) {
            const uint64_t from = std::max(begin, range->first), to = std::min(end, range->second);
            list.ranges.push_back({instance, uint32_t(3 * (from - begin)), uint32_t(3 * (to - from))});
            drawn += to - from;
        }
        return drawn;
    }
    /// Why the other program left something out is not in its file; what lies outside the view needs no other reason.
    static bool outside(const Scene& scene, uint32_t instance, const View& view) {
        return classify(view.frustum(), relativeToEye(scene.instanceBox(instance), view.eye())) == Containment::Outside;
    }
    [[nodiscard]] static Decision end(uint32_t instance, uint64_t drawn, uint64_t all, Cause cause) {
        const Subject subject = Subject::ofObject(instance);
        if (drawn == 0) return atLine(RecordedLine::LeaveOut, ending(subject, Decision::Outcome::Culled, cause));
        const auto outcome = drawn == all ? Decision::Outcome::Drawn : Decision::Outcome::PartlyDrawn;
        return atLine(RecordedLine::Draw, ending(subject, outcome, cause));
    }
};

}  // namespace

RegisteredStrategy recorded() {
    StrategyInfo info{
        "recorded",
        CULLSCOPE_TR("Recorded"),
        CULLSCOPE_TR("Draws what another program says that it draws at the nearest pose, from a file."),
        "",
        {facingParameter("two-sided"),
         fileParameter(kFile, CULLSCOPE_TR("File of drawn sets with their cameras (JSON); without one everything is "
                                           "drawn."))},
        GlRequirement::None};
    info.decidesByFile = kFile;
    info.shows = {listingShow({{CULLSCOPE_TR("take the pose with the nearest camera"), 0},
                               {CULLSCOPE_TR("for each object"), 0},
                               {CULLSCOPE_TR("draw what the file has of it"), 1},
                               {CULLSCOPE_TR("nothing: leave it out"), 1}})};
    return {std::move(info), std::make_shared<Recorded>()};
}

}  // namespace cullscope::baseline
