#pragma once

#include "core/visibility/parameters.h"

namespace cullscope::spherical {

/// Which objects contour bands decide about.
enum class Branch {
    Text,     ///< §2.3: those in the frustum that no corner ray meets
    Appendix  ///< Appendix 1: those whose bounding sphere lies inside the frustum
};

/// What becomes of a corner ray that meets no triangle, where others do or Branch::Appendix holds. The paper is silent.
enum class Missed {
    Nearest,  ///< the region's corner is the point nearest to the ray, of what RayStart says
    LeftOut,  ///< the region has no such corner; without any corner nothing is drawn
    Bands     ///< bands decide about the object
};

/// Where a corner ray begins to walk the index map, and where the point lies that Missed::Nearest takes.
enum class RayStart {
    Sphere,  ///< §2.2 and 2.3: the bounding sphere
    Box      ///< Appendix 1: the bounding box
};

/// How the region's corners are connected. The paper is silent.
enum class Join {
    Chart,  ///< by straight lines on the θ–φ map: the extremes are at the corners
    Arcs    ///< by great-circle arcs: a box extends to an arc's extreme latitude
};

/// When a pole lies in the region, which is case 1.
enum class PoleRule {
    Direction,  ///< when the surface in its direction is within the view
    Outline     ///< when the outline winds around it
};

/// What a band of a sector hides whose S does not exceed the largest S before it.
enum class Cut {
    ForGood,  ///< §2.3, "from the start up to the region found hidden": itself and all bands behind it
    ByBand    ///< §2.3, "compares each sampled region": itself alone
};

/// How `spherical` reads Han & Hong 2008 where text and appendix differ or say nothing. docs/methods/spherical.md has what each
/// reading loses and costs.
struct Readings {
    Branch branch = Branch::Text;
    Missed missed = Missed::Nearest;
    RayStart start = RayStart::Sphere;
    Join join = Join::Chart;
    PoleRule pole = PoleRule::Direction;
    Cut cut = Cut::ForGood;
};

/// The parameters of the readings, and what they say.
[[nodiscard]] std::vector<ParameterDeclaration> readingParameters();
[[nodiscard]] Readings readingsOf(const ParameterSet& parameters);

}  // namespace cullscope::spherical
