#include "core/visibility/why.h"

#include <algorithm>

#include "core/frame/entry_words.h"
#include "core/scene/eye_triangle.h"
#include "core/visibility/left_out_triangles.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {
namespace {

/// The sentence that every decision of an outcome has, for decisions without one of their own.
Message endSentence(const Decision& decision) {
    if (decision.outcome == Decision::Outcome::Culled)
        return {CULLSCOPE_TR("The strategy leaves the object out: %1."), {causeName(decision.cause)}};
    if (decision.outcome == Decision::Outcome::PartlyDrawn)
        return {CULLSCOPE_TR("The strategy draws the object in part; the rest is left out: %1."), {causeName(decision.cause)}};
    return {CULLSCOPE_TR("The strategy keeps the object."), {}};
}

/// The culled triangles of an object by cause, where they were decided by cells.
std::array<uint64_t, kCauseCount> culledInPart(const FrameLog& log, uint32_t instance) {
    std::array<uint64_t, kCauseCount> counts{};
    for (const Decision& decision : log.decisions) {
        const bool counted = decision.subject.kind == Subject::Kind::Cell || decision.subject.kind == Subject::Kind::Triangles;
        if (!counted || decision.subject.object != instance) continue;
        uint64_t& count = counts[size_t(decision.cause)];
        if (decision.outcome == Decision::Outcome::Culled) count += decision.places.count;
        if (decision.outcome == Decision::Outcome::DrawnAfterAll) count -= decision.places.count;
    }
    forEachLeftOut(log, [&](uint32_t of, const LeftOutTriangles& triangles) {
        for (const LeftOutTriangles::Run& run : triangles.runs)
            counts[size_t(run.cause)] += of == instance ? run.places.count : 0;
    });
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
            return WhyStep{
                {snapshot.objectSentence != nullptr ? snapshot.objectSentence
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
    // What is left out by its size is left out with its group, however few objects that has.
    const bool bySize = group != nullptr && group->culled && (group->cause == Cause::TooSmall || group->cause == Cause::NoSample);
    if (group == nullptr || (group->objects < 2 && !bySize)) return std::nullopt;
    const std::string count = std::to_string(group->objects);
    Message sentence{
        snapshot.groupSentence != nullptr
            ? snapshot.groupSentence
            : CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: it reaches over the edge of "
                           "the frustum, so that its objects were tested one by one."),
        {count}};
    if (group->culled && group->cause == Cause::Hidden)
        sentence = {CULLSCOPE_TR("It lies in a group of %1 objects, whose box was tested first: what was drawn before hides it."),
                    {count}};
    else if (bySize)
        sentence = {CULLSCOPE_TR("It is left out with its whole group (objects: %1): %2."), {count, causeName(group->cause)}};
    else if (group->culled && !group->rejectedBy)
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

/// The tests of the group that decided, with their numbers.
void addGroupTests(const FrameLog& log, uint32_t group, std::vector<WhyStep>& steps) {
    for (const Decision& decision : log.decisions) {
        if (decision.subject != Subject::ofNode(group) || decision.outcome != Decision::Outcome::Open) continue;
        steps.push_back(whyStep(decision));
        steps.back().ofGroup = true;
    }
}

/// Where a triangle of an object stands in the order of the frame; `own`: its number in the mesh.
uint64_t placeOf(const Scene& scene, const FrameLog& log, uint32_t instance, uint64_t own) {
    const uint32_t mesh = scene.instances()[instance].mesh;
    uint64_t place = 0;
    while (place < scene.meshOf(instance).triangleCount() && triangleAt(log.order.get(), mesh, place) != own) ++place;
    return place;
}

/// What was said of the cell or range of cells by which the triangle at a place of an object was decided, with its numbers.
void addCellTests(const FrameLog& log, uint32_t instance, uint64_t place, std::vector<WhyStep>& steps) {
    const auto holds = [&](const Decision& decision) {
        return decision.subject.holdsTriangles() && decision.subject.object == instance && decision.places.first <= place &&
               place - decision.places.first < decision.places.count;
    };
    const auto last = std::find_if(log.decisions.rbegin(), log.decisions.rend(), [&](const Decision& decision) {
        return decision.outcome != Decision::Outcome::Open && holds(decision);
    });
    if (last == log.decisions.rend()) return;
    for (const Decision& decision : log.decisions)
        if (decision.subject == last->subject && decision.sentence != nullptr) steps.push_back(whyStep(decision));
}

/// Why a triangle of a drawn cell was left out by itself; none: it was not.
std::optional<Message> leftOutByItself(const FrameLog& log, uint32_t instance, uint64_t place) {
    std::optional<Cause> cause;
    forEachLeftOut(log, [&](uint32_t of, const LeftOutTriangles& triangles) {
        if (of == instance && !cause) cause = triangles.causeAt(uint32_t(place));
    });
    if (!cause) return std::nullopt;
    if (*cause == Cause::BackFacing)
        return Message{
            CULLSCOPE_TR("The triangle faces away, however rounding and snapping move its corners: OpenGL would drop it."), {}};
    return Message{CULLSCOPE_TR("No pixel centre lies in the triangle, however rounding and snapping move its corners."), {}};
}

/// Whether stand-ins are drawn in place of an object's surface.
bool standsIn(const DrawList& list, const Scene& scene, uint32_t instance) {
    return std::ranges::any_of(list.ranges, [&](const DrawRange& range) {
        return range.instance == instance && list.standIn(scene.instances()[instance].mesh, range);
    });
}

/// What became of a triangle in the end. `ownPicture`: the strategy makes its picture without OpenGL.
const char* lastSentence(bool given, bool ownPicture) {
    if (ownPicture)
        return given ? CULLSCOPE_TR("The triangle is in the picture that the strategy made.")
                     : CULLSCOPE_TR("The triangle is not in the picture that the strategy made.");
    return given ? CULLSCOPE_TR("The triangle is given to OpenGL.") : CULLSCOPE_TR("The triangle is not given to OpenGL.");
}

/// At a step: what the frame has of a triangle so far; `given`: drawn. None: it is decided to be left out, or was drawn.
std::optional<Message> soFar(const Scene& scene, const FrameLog& log, uint64_t triangle, bool given) {
    const auto parts = std::ranges::count_if(log.decisions, [&](const Decision& decision) {
        return decision.subject.kind == Subject::Kind::Fragment && decision.subject.number == triangle &&
               decision.places.count > 0;
    });
    if (given && parts > 0)
        return Message{CULLSCOPE_TR("Up to this step it is drawn, as a whole or in part; pieces: %1."), {std::to_string(parts)}};
    if (given) return std::nullopt;
    const TriangleState state = triangleStates(scene, log, std::nullopt).states[triangle];
    if (state == TriangleState::Undecided)
        return Message{CULLSCOPE_TR("Up to this step nothing of it is decided, and nothing of it is drawn."), {}};
    if (state == TriangleState::Visible)
        return Message{CULLSCOPE_TR("Up to this step it is decided to be drawn, and nothing of it is drawn yet."), {}};
    return std::nullopt;
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

WhyStep whyStep(const Decision& decision) {
    WhyStep result{{}, decision.plane, {}, {}, decision.containment};
    if (decision.sentence == nullptr) {
        result.sentence = endSentence(decision);
        result.ofEnd = true;
        return result;
    }
    std::vector<std::string> arguments;
    if (decision.plane) result.distance = decision.distance();
    if (decision.plane || decision.margin() != 0.0) result.bound = decision.margin();
    for (const Term& term : decisionTerms(decision)) arguments.push_back(term.english());
    result.sentence = {decision.sentence, std::move(arguments)};
    return result;
}

std::vector<WhyStep> why(const BuiltStrategy& strategy, const FrameLog& log, uint64_t triangle) {
    const Scene& scene = strategy.scene();
    const auto instance = static_cast<uint32_t>(scene.instanceOf(triangle));
    const uint64_t own = triangle - scene.firstTriangle(instance);
    std::vector<WhyStep> steps;
    const StructureSnapshot snapshot = strategy.snapshot(log);
    if (auto box = boxStep(scene, snapshot, instance)) steps.push_back(std::move(*box));
    if (auto group = groupStep(snapshot, instance)) {
        steps.push_back(std::move(*group));
        addGroupTests(log, decidingGroup(snapshot, instance)->number, steps);
    }
    const std::array<uint64_t, kCauseCount> inPart = culledInPart(log, instance);
    const bool several = std::ranges::count_if(inPart, [](uint64_t count) { return count > 0; }) > 1;
    // A group of this object alone: its tests are the object's, unless the object was tested by itself.
    const SnapshotNode* group = decidingGroup(snapshot, instance);
    const bool tested = std::ranges::any_of(log.decisions, [&](const Decision& decision) {
        return decision.subject == Subject::ofObject(instance) && decision.outcome == Decision::Outcome::Open;
    });
    const bool alone = group != nullptr && group->objects == 1 && (group->containment != Containment::Straddles || !tested);
    const auto isAbout = [&](const Decision& decision) {
        if (decision.subject == Subject::ofObject(instance)) return true;
        // That it is kept is said of the object too.
        return alone && decision.subject == Subject::ofNode(group->number) && decision.outcome != Decision::Outcome::Drawn;
    };
    for (const Decision& decision : log.decisions) {
        if (!isAbout(decision)) continue;
        if (decision.outcome == Decision::Outcome::PartlyDrawn && several)
            addCauses(inPart, steps);
        else
            steps.push_back(whyStep(decision));
    }
    const uint64_t place = placeOf(scene, log, instance, own);
    addCellTests(log, instance, place, steps);
    strategy.addWhySteps(log, instance, uint32_t(own), steps);
    if (std::optional<Message> byItself = leftOutByItself(log, instance, place))
        steps.push_back({std::move(*byItself), {}, {}, {}, Containment::Outside});
    const DrawList drawn = drawnTriangles(scene, log);
    if (standsIn(drawn, scene, instance)) {
        steps.push_back({{CULLSCOPE_TR("A coarser surface of the object is given to OpenGL in place of the triangle."), {}},
                         {},
                         {},
                         {},
                         Containment::Straddles,
                         false,
                         true});
        return steps;
    }
    const bool given = submits(drawn, scene, instance, own);
    if (!log.whole)
        if (std::optional<Message> words = soFar(scene, log, triangle, given)) {
            steps.push_back({std::move(*words), {}, {}, {}, Containment::Straddles, false, true});
            return steps;
        }
    const Containment containment = given ? Containment::Straddles : Containment::Outside;
    const bool ownPicture = std::ranges::any_of(
        log.commands, [](const Command& command) { return std::holds_alternative<FinishedPicturePointer>(command); });
    steps.push_back({{lastSentence(given, ownPicture), {}}, {}, {}, {}, containment, false, true});
    if (given && !ownPicture) {
        const bool away = InstanceFromEye(scene, instance, log.camera).facesAway(own);
        const Facing facing = facingOf(scene, instance, log.facing);
        const bool dropped = facing == Facing::Front && away;
        const Containment drawnSide = dropped ? Containment::Outside : Containment::Straddles;
        steps.push_back({openGlSentence(facing, away), {}, {}, {}, drawnSide, false, true});
    }
    return steps;
}

const WhyStep* decidingStep(std::span<const WhyStep> steps) {
    if (steps.empty()) return nullptr;
    const bool leftOut = steps.back().containment == Containment::Outside;
    const auto decided = [leftOut](const WhyStep& step) {
        return !step.ofEnd && (!leftOut || step.containment == Containment::Outside);
    };
    for (size_t i = steps.size(); i-- > 0;)
        if (decided(steps[i])) return &steps[i];
    return &steps.back();
}

}  // namespace cullscope
