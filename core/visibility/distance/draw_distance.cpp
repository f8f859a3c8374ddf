#include "core/visibility/distance/draw_distance.h"

#include <cmath>
#include <numbers>

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/overlay.h"

namespace cullscope::distance {
namespace {

constexpr const char* kDistance = "distance";
constexpr float kRingWidth = 2.0f;  // units
constexpr int kRingSides = 96;

/// The lines of the listing.
enum class DistanceLine : uint8_t { Limit = 1, Objects, Nearest, Beyond, Draw };

/// The objects that have triangles.
struct DrawnObjects : Structure {
    using Structure::Structure;
    std::vector<uint32_t> instances;
};

class DrawDistance final : public StrategyWith<DrawnObjects> {
public:
    using Lines = std::vector<OverlayLines>;
    /// Two circles on the sphere of the distance around the culling eye: a level one, and an upright one ahead.
    [[nodiscard]] Lines overlay(std::string_view /*id*/, const OverlayContext& context, const Structure& /*structure*/,
                                const FrameLog& log) const override {
        if (log.decisions.empty()) return {};
        const double limit = log.decisions.front().operands[1];
        const Frustum frustum = View(log.camera, log.size).frustum();
        OverlayLines rings{{}, {kRingWidth, true}, true};
        for (const Vec3& side : {frustum.right, frustum.up}) {
            const auto at = [&](int i) {
                const double angle = 2.0 * std::numbers::pi * i / kRingSides;
                return log.camera.eye + limit * (std::cos(angle) * frustum.forward + std::sin(angle) * side);
            };
            for (int i = 0; i < kRingSides; ++i) rings.lines.push_back({at(i), at(i + 1), context.contrast});
        }
        return {std::move(rings)};
    }

protected:
    void fill(DrawnObjects& objects, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        for (uint32_t i = 0; i < objects.scene().instances().size(); ++i) {
            progress.check();
            if (objects.scene().meshOf(i).triangleCount() > 0) objects.instances.push_back(i);
        }
        objects.report.bytes = objects.instances.size() * sizeof(uint32_t);
        objects.report.figures = {{"objects", double(objects.instances.size())}};
    }

    void decide(FrameContext& frame, const DrawnObjects& objects, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        const double limit = parameters.real(kDistance) * frame.scene().boundingSphere().radius;
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("distances"));
            for (const uint32_t instance : objects.instances) {
                const uint64_t triangles = frame.scene().meshOf(instance).triangleCount();
                const double nearest = nearestOf(frame, instance);
                const bool beyond = nearest > limit;
                if (beyond)
                    frame.counters().culledTriangles[size_t(Cause::TooSmall)] += triangles;
                else
                    list.ranges.push_back({instance, 0, uint32_t(3 * triangles)});
                if (frame.recording()) record(frame, instance, nearest, limit, beyond);
            }
            frame.counters().nodesVisited = objects.instances.size();
            frame.counters().bytesTouched = objects.instances.size() * sizeof(Sphere);
        }
        frame.draw(std::move(list));
    }

    [[nodiscard]] Promise promiseOf(const DrawnObjects& /*objects*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
    /// The tree that the panel "Tree" and the overlay "boxes" show: a box for each object.
    [[nodiscard]] StructureSnapshot snapshotOf(const DrawnObjects& objects, const FrameLog& log) const override {
        StructureSnapshot tree = objectNodes(log, objects.scene());
        tree.objectSentence = CULLSCOPE_TR("The object \"%1\" is tested as one sphere with %2 triangles.");
        return tree;
    }

private:
    /// The distance of the eye from the sphere's nearest point, less the rounding: at most that of the object itself.
    static double nearestOf(const FrameContext& frame, uint32_t instance) {
        const EyeBounds bounds = boundsFromEye(frame.scene(), instance, frame.view().eye());
        return glm::length(bounds.sphere.centre) - bounds.sphere.radius - bounds.margin;
    }

    /// Says the test, and what became of the object.
    static void record(FrameContext& frame, uint32_t instance, double nearest, double limit, bool beyond) {
        Decision test;
        test.subject = Subject::ofObject(instance);
        test.containment = beyond ? Containment::Outside : Containment::Inside;
        test.sentence = beyond ? CULLSCOPE_TR(
                                     "Its sphere begins %1 from the eye, beyond the distance of %2: so far away it "
                                     "counts as too small.")
                               : CULLSCOPE_TR("Its sphere begins %1 from the eye, within the distance of %2.");
        test.operands = {nearest, limit};
        test.operandCount = 2;
        frame.say(atLine(DistanceLine::Nearest, test));
        if (beyond)
            frame.say(atLine(DistanceLine::Beyond, ending(test.subject, Decision::Outcome::Culled, Cause::TooSmall)));
        else
            frame.say(atLine(DistanceLine::Draw, ending(test.subject, Decision::Outcome::Drawn)));
    }
};

Message noDistance(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no draw distance. Having one: %3.", {option, strategy, having}};
}

Show rings() {
    Show show;
    show.id = kDistance;
    show.help = "of draw-distance: the distance around the culling eye, as two circles";
    show.title = CULLSCOPE_TR("Draw distance");
    show.action = CULLSCOPE_TR("Draw &distance");
    show.explanation = CULLSCOPE_TR("Show in the active view how far from the culling eye objects are drawn");
    show.absent = noDistance;
    return show;
}

Show listing() {
    return listingShow({{CULLSCOPE_TR("limit = distance × scene radius"), 0},
                        {CULLSCOPE_TR("for each object"), 0},
                        {CULLSCOPE_TR("d = distance of its sphere"), 1},
                        {CULLSCOPE_TR("if d > limit: leave it out"), 1},
                        {CULLSCOPE_TR("else draw it"), 1}});
}

ParameterDeclaration distanceParameter() {
    const char* description = CULLSCOPE_TR("How far from the eye objects are drawn, in radii of the scene's sphere.");
    return bySize({kDistance, ParameterType::Real, 4.0, 0.0, 1000.0, "", description, {}}, 0.1);
}

}  // namespace

RegisteredStrategy drawDistance() {
    StrategyInfo info{"draw-distance",
                      CULLSCOPE_TR("Draw distance"),
                      CULLSCOPE_TR("Leaves out objects that lie wholly beyond a distance from the eye."),
                      "",
                      {facingParameter(), distanceParameter()}};
    info.needsEyePoint = true;
    info.sweeps = {{kDistance, {"1", "1.5", "2", "3", "4", "6"}}};
    info.shows = {rings(), treeShow(), listing()};
    return {std::move(info), std::make_shared<DrawDistance>()};
}

}  // namespace cullscope::distance
