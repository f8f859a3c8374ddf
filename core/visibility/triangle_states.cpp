#include "core/visibility/triangle_states.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <cassert>

#include "core/base/message.h"
#include "core/scene/eye_triangle.h"
#include "core/visibility/left_out_triangles.h"

namespace cullscope {

const char* triangleStateName(TriangleState state) {
    switch (state) {
        case TriangleState::Visible:
            return CULLSCOPE_TR("drawn and visible");
        case TriangleState::InVain:
            return CULLSCOPE_TR("drawn in vain");
        case TriangleState::OutsideFrustum:
            return CULLSCOPE_TR("outside the frustum");
        case TriangleState::BackFacing:
            return CULLSCOPE_TR("back-facing");
        case TriangleState::Hidden:
            return CULLSCOPE_TR("hidden");
        case TriangleState::TooSmall:
            return CULLSCOPE_TR("too small");
        case TriangleState::WronglyCulled:
            return CULLSCOPE_TR("wrongly culled");
        case TriangleState::Undecided:
            break;
    }
    return CULLSCOPE_TR("not yet decided");
}

TriangleState stateOfCause(Cause cause) {
    switch (cause) {
        case Cause::OutsideFrustum:
            return TriangleState::OutsideFrustum;
        case Cause::BackFacing:
            return TriangleState::BackFacing;
        case Cause::Hidden:
            return TriangleState::Hidden;
        case Cause::TooSmall:
        case Cause::NoSample:
            break;
    }
    return TriangleState::TooSmall;
}

namespace {

/// The states of all triangles as if none were submitted: by the causes that the decisions name. In the first entries of a frame
/// a triangle that was decided to be drawn counts as drawn, before the command that draws it, and one about which nothing was
/// decided is Undecided.
class NamedStates {
public:
    NamedStates(const Scene& scene, const FrameLog& log)
        : m_scene(scene),
          m_log(log),
          m_states(scene.triangleCount(), log.whole ? TriangleState::Hidden : TriangleState::Undecided) {}

    [[nodiscard]] std::vector<TriangleState> take() {
        for (const Decision& decision : m_log.decisions) {
            const std::optional<TriangleState> state = stateAfter(decision);
            if (!state) continue;
            if (decision.subject.kind == Subject::Kind::Object) markObject(decision.subject.number, *state);
            for (const uint32_t instance : m_log.objectsOf(decision)) markObject(instance, *state);
        }
        // What a cell's decision says of its triangles is nearer to them than what became of the object.
        for (const Decision& decision : m_log.decisions)
            if (const std::optional<TriangleState> state = stateAfter(decision); state && isCell(decision))
                markCell(decision.subject.object, decision.places, *state);
        // And nearer still what is said of triangles by themselves.
        forEachLeftOut(m_log, [&](uint32_t instance, const LeftOutTriangles& triangles) {
            for (const LeftOutTriangles::Run& run : triangles.runs) markCell(instance, run.places, stateOfCause(run.cause));
        });
        return std::move(m_states);
    }

private:
    static bool isCell(const Decision& decision) {
        return decision.subject.kind == Subject::Kind::Cell || decision.subject.kind == Subject::Kind::Triangles;
    }

    /// None: the decision leaves it open.
    [[nodiscard]] std::optional<TriangleState> stateAfter(const Decision& decision) const {
        switch (decision.outcome) {
            case Decision::Outcome::Culled:
                return stateOfCause(decision.cause);
            case Decision::Outcome::PartlyDrawn:
                // Which part it is, the next command tells.
                if (!m_log.whole && decision.commands >= m_log.commands.size()) return std::nullopt;
                return stateOfCause(decision.cause);
            case Decision::Outcome::Drawn:
            case Decision::Outcome::DrawnAfterAll:
                if (!m_log.whole) return TriangleState::Visible;
                return std::nullopt;
            case Decision::Outcome::Open:
                break;
        }
        return std::nullopt;
    }

    void markObject(uint32_t instance, TriangleState state) {
        std::fill_n(m_states.begin() + std::ptrdiff_t(m_scene.firstTriangle(instance)), m_scene.meshOf(instance).triangleCount(),
                    state);
    }

    void markCell(uint32_t instance, const PlaceRun& places, TriangleState state) {
        const uint32_t mesh = m_scene.instances()[instance].mesh;
        for (uint32_t place = places.first; place < places.first + places.count; ++place)
            m_states[m_scene.firstTriangle(instance) + triangleAt(m_log.order.get(), mesh, place)] = state;
    }

    const Scene& m_scene;
    const FrameLog& m_log;
    std::vector<TriangleState> m_states;
};

/// The state of a submitted triangle.
struct Submitted {
    const std::optional<VisibleTriangles>& truth;
    bool dropsBacks = false, truthDropsBacks = false;  ///< of the triangle's object

    [[nodiscard]] TriangleState state(TriangleState before, const InstanceFromEye& instance, uint64_t triangle) const {
        // All triangles of V were marked as lost before; one that an earlier range drew is already Visible.
        const bool inV = truth.has_value() && (before == TriangleState::WronglyCulled || before == TriangleState::Visible);
        const bool dropped = dropsBacks && instance.facesAway(triangle);
        if (inV) {
            // With a reference of front faces only, OpenGL's facing decision for a visible triangle is the same in the strategy's
            // picture, also edge-on.
            return dropped && !truthDropsBacks ? TriangleState::WronglyCulled : TriangleState::Visible;
        }
        if (dropped) return TriangleState::BackFacing;
        return truth.has_value() ? TriangleState::InVain : TriangleState::Visible;
    }
};

}  // namespace

std::vector<TriangleState> statesOfUnsubmitted(const Scene& scene, const FrameLog& log) { return NamedStates(scene, log).take(); }

TriangleStates triangleStates(const Scene& scene, const FrameLog& log, const std::optional<VisibleTriangles>& truth) {
    const DrawList list = drawnTriangles(scene, log);
    TriangleStates result;
    result.againstTruth = truth.has_value();
    result.states = statesOfUnsubmitted(scene, log);
    if (truth.has_value())
        for (const uint32_t triangle : truth->triangles) result.states[triangle] = TriangleState::WronglyCulled;
    for (const DrawRange& range : list.ranges) {
        const InstanceFromEye instance(scene, range.instance, log.camera);
        const Submitted submitted{truth, dropsBacks(scene, range.instance, log.facing),
                                  truth.has_value() && dropsBacks(scene, range.instance, truth->facing)};
        const uint64_t first = scene.firstTriangle(range.instance);
        const uint32_t mesh = scene.instances()[range.instance].mesh;
        // Stand-ins are drawn for the whole object.
        const bool standIn = list.standIn(mesh, range);
        const uint64_t begin = standIn ? 0 : range.firstIndex / 3;
        const uint64_t count = standIn ? scene.meshOf(range.instance).triangleCount() : range.indexCount / 3;
        tbb::parallel_for(tbb::blocked_range<uint64_t>(begin, begin + count, 4096), [&](const auto& block) {
            for (uint64_t place = block.begin(); place < block.end(); ++place) {
                const uint64_t triangle = standIn ? place : list.triangleAt(mesh, place);
                TriangleState& state = result.states[first + triangle];
                state = submitted.state(state, instance, triangle);
            }
        });
    }
    if (truth.has_value() && !log.whole) {
        // What is not decided yet is not lost.
        const std::vector<TriangleState> named = statesOfUnsubmitted(scene, log);
        for (const uint32_t triangle : truth->triangles)
            if (result.states[triangle] == TriangleState::WronglyCulled && named[triangle] == TriangleState::Undecided)
                result.states[triangle] = TriangleState::Undecided;
    }
    for (const TriangleState state : result.states) ++result.counts[static_cast<size_t>(state)];
    return result;
}

TriangleStates triangleStates(const Scene& scene, const FrameLog& log, const VisibleTriangles& truth,
                              const std::optional<std::vector<uint32_t>>& lost) {
    TriangleStates states = triangleStates(scene, log, truth);
    if (!lost || !states.againstTruth) return states;
    std::vector<uint32_t> counted, explained;
    for (const uint32_t triangle : truth.triangles) {
        const bool leftOut = states.states[triangle] == TriangleState::WronglyCulled;
        (leftOut && !std::ranges::binary_search(*lost, triangle) ? explained : counted).push_back(triangle);
    }
    if (explained.empty()) return states;
    states = triangleStates(scene, log, VisibleTriangles{counted, truth.facing});
    states.withinSnapping = std::move(explained);
    return states;
}

VisibleSetDifference compareVisibleSets(const TriangleStates& first, const TriangleStates& second) {
    assert(first.states.size() == second.states.size());
    VisibleSetDifference difference;
    for (size_t i = 0; i < first.states.size(); ++i) {
        const bool a = first.states[i] == TriangleState::Visible, b = second.states[i] == TriangleState::Visible;
        difference.both += a && b ? 1 : 0;
        difference.onlyFirst += a && !b ? 1 : 0;
        difference.onlySecond += b && !a ? 1 : 0;
    }
    return difference;
}

}  // namespace cullscope
