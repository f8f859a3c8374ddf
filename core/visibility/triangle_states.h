#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/frame/triangle_state.h"

namespace cullscope {

/// English, marked for translation.
[[nodiscard]] const char* triangleStateName(TriangleState state);
/// The state of triangles culled for that cause.
[[nodiscard]] TriangleState stateOfCause(Cause cause);

/// Ground truth for a view: the triangles that are visible under a facing rule (computed by measure/reference.h).
struct VisibleTriangles {
    std::span<const uint32_t> triangles;  ///< scene triangle numbers, unique
    Facing facing = Facing::TwoSided;
};

/// The state of each triangle by scene triangle number, and the number of triangles in each state.
struct TriangleStates {
    std::vector<TriangleState> states;
    std::array<uint64_t, kTriangleStateCount> counts{};
    /// False where no ground truth was given: then submitted triangles that are not back-facing count as Visible, and none as
    /// InVain or WronglyCulled.
    bool againstTruth = false;
    /// Triangles that the truth shows and that were left out without the loss of a pixel, ascending (see `lost` below).
    std::vector<uint32_t> withinSnapping{};
};

/// The states of all triangles in a recorded frame of the scene. With `truth` (none: not known) for its culling view, V is its
/// set of visible triangles. In V and drawn: Visible. In V and not drawn (not submitted; or submitted and culled by OpenGL as
/// back-facing while the truth has both sides): WronglyCulled. Submitted and not in V: BackFacing where OpenGL draws front faces
/// only and the triangle is back-facing for the eye, else InVain. Not submitted: by the cause of the last decision about its
/// cell, object or group; Hidden where there is none, as in a frame whose choices the GPU makes. Of the first entries of a frame
/// (FrameLog::upTo): Visible also where it was decided to be drawn and no command has drawn it yet, and Undecided where nothing
/// was decided.
[[nodiscard]] TriangleStates triangleStates(const Scene& scene, const FrameLog& log,
                                            const std::optional<VisibleTriangles>& truth);
/// The states of all triangles as if the frame had submitted none: by the causes that its decisions name.
[[nodiscard]] std::vector<TriangleState> statesOfUnsubmitted(const Scene& scene, const FrameLog& log);
/// As triangleStates, where it is known which triangles lost a pixel (`lost`: ascending; none: not known, as above). Only those
/// are WronglyCulled. Any other one in V that was not drawn has the state that it would have without the truth: the raster's
/// snapping explains its pixels.
[[nodiscard]] TriangleStates triangleStates(const Scene& scene, const FrameLog& log, const VisibleTriangles& truth,
                                            const std::optional<std::vector<uint32_t>>& lost);

/// The difference of two strategies' visible sets: triangles that are visible and drawn.
struct VisibleSetDifference {
    uint64_t both = 0, onlyFirst = 0, onlySecond = 0;
};
/// Both must be of the same scene and view, with ground truth.
[[nodiscard]] VisibleSetDifference compareVisibleSets(const TriangleStates& first, const TriangleStates& second);

}  // namespace cullscope
