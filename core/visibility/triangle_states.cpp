#include "core/visibility/triangle_states.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <cassert>

#include "core/base/message.h"
#include "core/scene/eye_triangle.h"

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
            break;
    }
    return CULLSCOPE_TR("wrongly culled");
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

/// The states of all triangles as if none were submitted: by the causes that the decisions name.
std::vector<TriangleState> causes(const Scene& scene, const FrameLog& log) {
    std::vector<TriangleState> states(scene.triangleCount(), TriangleState::Hidden);
    const auto mark = [&](uint32_t instance, Cause cause) {
        std::fill_n(states.begin() + static_cast<std::ptrdiff_t>(scene.firstTriangle(instance)),
                    scene.meshOf(instance).triangleCount(), stateOfCause(cause));
    };
    const auto culls = [](const Decision& decision) {
        return decision.outcome == Decision::Outcome::Culled || decision.outcome == Decision::Outcome::PartlyDrawn;
    };
    for (const Decision& decision : log.decisions) {
        if (!culls(decision)) continue;
        if (decision.subject.kind == Subject::Kind::Object) mark(decision.subject.number, decision.cause);
        for (const uint32_t instance : log.objectsOf(decision)) mark(instance, decision.cause);
    }
    // What a cell's decision says of its triangles is nearer to them than what became of the object.
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Cell || !culls(decision)) continue;
        const uint32_t instance = decision.subject.object, mesh = scene.instances()[instance].mesh;
        for (uint32_t place = decision.places.first; place < decision.places.first + decision.places.count; ++place)
            states[scene.firstTriangle(instance) + triangleAt(log.order.get(), mesh, place)] = stateOfCause(decision.cause);
    }
    return states;
}

/// The state of a submitted triangle.
struct Submitted {
    const std::optional<VisibleTriangles>& truth;
    Facing facing;

    [[nodiscard]] TriangleState state(TriangleState before, const InstanceFromEye& instance, uint64_t triangle) const {
        // All triangles of V were marked as lost before; one that an earlier range drew is already Visible.
        const bool inV = truth.has_value() && (before == TriangleState::WronglyCulled || before == TriangleState::Visible);
        const bool dropped = facing == Facing::Front && instance.facesAway(triangle);
        if (inV) {
            // With a reference of front faces only, OpenGL's facing decision for a visible triangle is the same in the strategy's
            // picture, also edge-on.
            return dropped && truth->facing == Facing::TwoSided ? TriangleState::WronglyCulled : TriangleState::Visible;
        }
        if (dropped) return TriangleState::BackFacing;
        return truth.has_value() ? TriangleState::InVain : TriangleState::Visible;
    }
};

}  // namespace

TriangleStates triangleStates(const Scene& scene, const FrameLog& log, const std::optional<VisibleTriangles>& truth) {
    const DrawList list = drawnTriangles(scene, log);
    TriangleStates result;
    result.againstTruth = truth.has_value();
    result.states = causes(scene, log);
    if (truth.has_value())
        for (const uint32_t triangle : truth->triangles) result.states[triangle] = TriangleState::WronglyCulled;
    const Submitted submitted{truth, log.facing};
    for (const DrawRange& range : list.ranges) {
        const InstanceFromEye instance(scene, range.instance, log.camera.eye);
        const uint64_t first = scene.firstTriangle(range.instance);
        const uint32_t mesh = scene.instances()[range.instance].mesh;
        const uint64_t begin = range.firstIndex / 3;
        tbb::parallel_for(tbb::blocked_range<uint64_t>(begin, begin + range.indexCount / 3, 4096), [&](const auto& block) {
            for (uint64_t place = block.begin(); place < block.end(); ++place) {
                const uint64_t triangle = list.triangleAt(mesh, place);
                TriangleState& state = result.states[first + triangle];
                state = submitted.state(state, instance, triangle);
            }
        });
    }
    for (const TriangleState state : result.states) ++result.counts[static_cast<size_t>(state)];
    return result;
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
