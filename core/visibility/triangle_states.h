#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/trace.h"

namespace cullscope {

/// What became of a triangle in one frame; the first cause that applied. In the order of desktop.md's table of colours.
enum class TriangleState : uint8_t { Visible, InVain, OutsideFrustum, BackFacing, Hidden, TooSmall, WronglyCulled };
inline constexpr size_t kTriangleStateCount = 7;
/// English, marked for translation.
[[nodiscard]] const char* triangleStateName(TriangleState state);
/// The state of what is culled for that cause.
[[nodiscard]] TriangleState stateOfCause(Cause cause);

/// The truth about a view: the triangles that are visible under a facing rule (measure/reference.h finds them).
struct VisibleTriangles {
    std::span<const uint32_t> triangles;  ///< scene triangle numbers, unique
    Facing facing = Facing::TwoSided;
};

/// One state a scene triangle number, and how many triangles are in each.
struct TriangleStates {
    std::vector<TriangleState> states;
    std::array<uint64_t, kTriangleStateCount> counts{};
    /// False: no truth was given; what is submitted and not back-facing counts as Visible, and nothing as InVain or
    /// WronglyCulled.
    bool againstTruth = false;
};

/// The states of all triangles as `view`, the culling view, decided them; `list` and `trace` come from one cull of that view.
/// With `truth` (none: not known) of the same view, V is its set of visible triangles. In V and drawn: Visible. In V and not
/// drawn (not submitted; or submitted and dropped by OpenGL as back-facing, while the truth shows both sides): WronglyCulled.
/// Submitted and not in V: BackFacing where OpenGL draws front sides only and the triangle turns its back to the eye, else
/// InVain. Not submitted: the cause that the trace names for its object; Hidden where it names none, which no registered strategy
/// does.
[[nodiscard]] TriangleStates triangleStates(const Scene& scene, const View& view, const DrawList& list, const Trace& trace,
                                            const std::optional<VisibleTriangles>& truth);

/// How two strategies' visible sets differ: triangles that are truly visible and drawn.
struct VisibleSetDifference {
    uint64_t both = 0, onlyFirst = 0, onlySecond = 0;
};
/// Of the same scene and view, both against the truth.
[[nodiscard]] VisibleSetDifference compareVisibleSets(const TriangleStates& first, const TriangleStates& second);

}  // namespace cullscope
