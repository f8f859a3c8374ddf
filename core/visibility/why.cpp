#include "core/visibility/why.h"

#include <algorithm>
#include <cstdio>

#include "core/scene/eye_triangle.h"
#include "core/visibility/spherical/why.h"

namespace cullscope {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

Message planeSentence(const TraceEvent& test) {
    const std::string plane = planeName(test.plane);
    const std::string distance = number(std::abs(test.distance));
    const std::string bound = number(test.bound);
    if (test.containment == Containment::Outside)
        return {CULLSCOPE_TR(
                    "Tested against the %1: even the nearest point of the bounds lies %2 outside, more than the bound of %3."),
                {plane, distance, bound}};
    if (test.containment == Containment::Inside)
        return {CULLSCOPE_TR("Tested against the %1: all of the bounds lie inside, the farthest point by %2."),
                {plane, distance}};
    if (test.distance < 0.0)
        return {CULLSCOPE_TR("Tested against the %1: the bounds lie %2 outside, within the bound of %3, and count as inside."),
                {plane, distance, bound}};
    return {CULLSCOPE_TR("Tested against the %1: the bounds reach %2 to the inside."), {plane, distance}};
}

WhyStep step(const TraceEvent& event) {
    if (event.kind == TraceEvent::Kind::TestedPlane)
        return {planeSentence(event), event.plane, event.distance, event.bound, event.containment};
    if (event.kind == TraceEvent::Kind::TestedAxes)
        return {{CULLSCOPE_TR(
                     "No single plane has the bounds outside, but an axis parts them from the frustum: they lie beside one of "
                     "its edges or corners."),
                 {}},
                {},
                {},
                event.bound,
                Containment::Outside};
    if (event.kind == TraceEvent::Kind::MeetsNear)
        return {{CULLSCOPE_TR("The box reaches the near rectangle of the view: it is visible without asking."), {}},
                {},
                {},
                {},
                Containment::Straddles};
    if (event.kind == TraceEvent::Kind::AskedOpenGl)
        return {{event.containment == Containment::Outside
                     ? CULLSCOPE_TR("OpenGL was asked about the box, grown by %1: nothing of it was hit.")
                     : CULLSCOPE_TR("OpenGL was asked about the box, grown by %1: it was hit."),
                 {number(event.bound)}},
                {},
                {},
                event.bound,
                event.containment};
    if (event.kind == TraceEvent::Kind::Culled)
        return {{CULLSCOPE_TR("The strategy leaves the object out: %1."), {causeName(event.cause)}},
                {},
                {},
                {},
                Containment::Outside};
    if (event.kind == TraceEvent::Kind::PartlyDrawn)
        return {{CULLSCOPE_TR("The strategy draws the object in part; the rest is left out: %1."), {causeName(event.cause)}},
                {},
                {},
                {},
                Containment::Straddles};
    return {{CULLSCOPE_TR("The strategy keeps the object."), {}}, {}, {}, {}, Containment::Straddles};
}

/// The culled triangles of an object by cause, where the trace has them by ranges.
std::array<uint64_t, kCauseCount> culledInPart(const Trace& trace, uint32_t instance) {
    std::array<uint64_t, kCauseCount> counts{};
    for (const CulledRun& run : trace.culledRuns)
        if (run.instance == instance) counts[size_t(run.cause)] += run.places.count;
    return counts;
}

void addCauses(const std::array<uint64_t, kCauseCount>& counts, std::vector<WhyStep>& steps) {
    for (size_t cause = 0; cause < kCauseCount; ++cause) {
        if (counts[cause] == 0) continue;
        Message sentence{CULLSCOPE_TR("The strategy draws the object in part; %1 of its triangles are left out: %2."),
                         {std::to_string(counts[cause]), causeName(static_cast<Cause>(cause))}};
        steps.push_back({std::move(sentence), {}, {}, {}, Containment::Straddles});
    }
}

/// The box of the object, where the strategy has boxes.
std::optional<WhyStep> boxStep(const Scene& scene, const StructureSnapshot& snapshot, uint32_t instance) {
    for (const SnapshotNode& node : snapshot.nodes)
        if (node.instance == instance)
            return WhyStep{{snapshot.mapOf(instance) != nullptr
                                ? CULLSCOPE_TR("The object \"%1\" is tested as one bounding sphere with %2 triangles.")
                                : CULLSCOPE_TR("The object \"%1\" is tested as one box with %2 triangles."),
                            {scene.instances()[instance].name, std::to_string(node.triangles)}},
                           {},
                           {},
                           {},
                           node.containment};
    return std::nullopt;
}

const SnapshotNode* parentOf(const SnapshotNode& node, const StructureSnapshot& snapshot) {
    return node.parent < 0 ? nullptr : &snapshot.nodes[size_t(node.parent)];
}

/// The group by which the object was decided: the outermost one completely outside or inside, else the object's leaf. Null: none.
const SnapshotNode* decidingGroup(const StructureSnapshot& snapshot, uint32_t instance) {
    const auto own = std::find_if(snapshot.nodes.begin(), snapshot.nodes.end(),
                                  [&](const SnapshotNode& node) { return node.instance == instance; });
    if (own == snapshot.nodes.end()) return nullptr;
    const SnapshotNode* group = parentOf(*own, snapshot);
    if (group == nullptr || !group->isGroup()) return nullptr;
    // Below the deciding group all nodes have its result; above it all straddle.
    for (const SnapshotNode* next = group; next != nullptr && next->containment != Containment::Straddles;
         next = parentOf(*next, snapshot))
        group = next;
    return group;
}

/// The group that the object was tested with, where it contains other objects too.
std::optional<WhyStep> groupStep(const StructureSnapshot& snapshot, uint32_t instance) {
    const SnapshotNode* group = decidingGroup(snapshot, instance);
    if (group == nullptr || group->objects < 2) return std::nullopt;
    const std::string count = std::to_string(group->objects);
    Message sentence{CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: it reaches over the edge of the "
                                  "frustum, so that its objects were tested one by one."),
                     {count}};
    if (group->culled && !group->rejectedBy)
        sentence = {
            CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: an axis parts it from the frustum."),
            {count}};
    else if (group->culled)
        sentence = {CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: outside the %2."),
                    {count, planeName(*group->rejectedBy)}};
    else if (group->containment == Containment::Inside)
        sentence = {
            CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: wholly inside the frustum, so that "
                         "nothing of it was tested again."),
            {count}};
    return WhyStep{std::move(sentence), {}, {}, {}, group->containment};
}

bool submits(const DrawList& list, const Scene& scene, uint32_t instance, uint64_t triangle) {
    const uint32_t mesh = scene.instances()[instance].mesh;
    return std::any_of(list.ranges.begin(), list.ranges.end(), [&](const DrawRange& range) {
        if (range.instance != instance) return false;
        const uint64_t first = range.firstIndex / 3, last = first + range.indexCount / 3;
        if (list.orderOf(mesh).triangles.empty()) return first <= triangle && triangle < last;
        for (uint64_t place = first; place < last; ++place)
            if (list.triangleAt(mesh, place) == triangle) return true;
        return false;
    });
}

Message openGlSentence(Facing facing, bool facesAway) {
    if (facing == Facing::TwoSided) return {CULLSCOPE_TR("OpenGL draws the triangle: both sides count."), {}};
    return {facesAway ? CULLSCOPE_TR("OpenGL drops the triangle: it is back-facing.")
                      : CULLSCOPE_TR("OpenGL draws the triangle: its front is turned to the eye."),
            {}};
}

}  // namespace

std::vector<WhyStep> why(const Scene& scene, const View& culling, const Strategy& strategy, const DrawList& list,
                         const Trace& trace, uint64_t triangle) {
    const auto instance = static_cast<uint32_t>(scene.instanceOf(triangle));
    const uint64_t own = triangle - scene.firstTriangle(instance);
    std::vector<WhyStep> steps;
    const StructureSnapshot snapshot = strategy.snapshot(trace);
    if (auto box = boxStep(scene, snapshot, instance)) steps.push_back(std::move(*box));
    if (auto group = groupStep(snapshot, instance)) steps.push_back(std::move(*group));
    const std::array<uint64_t, kCauseCount> inPart = culledInPart(trace, instance);
    for (const TraceEvent& event : trace.events) {
        if (event.instance != instance) continue;
        const bool several = std::ranges::count_if(inPart, [](uint64_t count) { return count > 0; }) > 1;
        if (event.kind == TraceEvent::Kind::PartlyDrawn && several)
            addCauses(inPart, steps);
        else
            steps.push_back(step(event));
    }
    if (const spherical::MapSnapshot* map = snapshot.mapOf(instance)) spherical::addMapSteps(*map, uint32_t(own), steps);
    const bool given = submits(list, scene, instance, own);
    const Containment containment = given ? Containment::Straddles : Containment::Outside;
    steps.push_back(
        {{given ? CULLSCOPE_TR("The triangle is given to OpenGL.") : CULLSCOPE_TR("The triangle is not given to OpenGL."), {}},
         {},
         {},
         {},
         containment});
    if (given) {
        const bool away = InstanceFromEye(scene, instance, culling.eye()).facesAway(own);
        const bool dropped = list.facing == Facing::Front && away;
        steps.push_back({openGlSentence(list.facing, away), {}, {}, {}, dropped ? Containment::Outside : Containment::Straddles});
    }
    return steps;
}

}  // namespace cullscope
