#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/gpu/scene_buffers.h"
#include "core/image/line_plot.h"
#include "core/measure/meter.h"
#include "core/scene/camera_path.h"

namespace cullscope::worst {

/// What is sought of a strategy.
enum class Of {
    Missed,  ///< the view that loses the largest share of its covered pixels
    Ratio    ///< the view with the smallest gain: the least ratio of the time of drawing the same sides to the strategy's
};

struct WorstRequest {
    ScenePointer scene;
    StrategyRequest strategy;
    Of of = Of::Missed;
    Viewport size{320, 240};
    size_t views = 200;     ///< at most so many are tried
    bool inside = false;    ///< from places within the scene, as `tour` finds them; else from around it
    double distance = 3.0;  ///< of the eye from the centre, in radii of the scene's sphere; outside
    int repetitions = 3;    ///< of each frame, for Of::Ratio
};

/// A part of the map, and the view in its middle.
struct TriedView {
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;  ///< degrees of azimuth and elevation
    size_t place = 0;                                         ///< inside: the number of the eye's place
    CameraPath::Pose pose{};
    double value = 0.0;  ///< missed share of the covered pixels, or ratio
    uint64_t lostPixels = 0, coveredPixels = 0;
    size_t replaced = 0;  ///< how many smaller parts took its place; 0: it is part of the map

    [[nodiscard]] double azimuth() const { return 0.5 * (left + right); }
    [[nodiscard]] double elevation() const { return 0.5 * (bottom + top); }
};

struct WorstResult {
    WorstRequest request;
    GlInfo gl{};
    CameraPath lens{};  ///< without poses
    std::vector<TriedView> views{};
    size_t worst = 0;  ///< among them; there is one unless `views` is empty
    /// With Of::Ratio: of the worst view, by frames that were drawn after the search. What the search found is the least of many
    /// values, each with its error: it lies below the truth. None: not asked for, or it was stopped before.
    std::optional<RatioEstimate> confirmed{};
    bool interrupted = false;

    /// Whether one value is worse than another one.
    [[nodiscard]] bool worse(double one, double other) const { return request.of == Of::Missed ? one > other : one < other; }
    /// The views as a camera path, the worst first, at most so many.
    [[nodiscard]] CameraPath path(size_t most) const;
    /// The view of the map's part at these degrees, or (inside) of the place nearest to a point of the plan; none: there is none.
    [[nodiscard]] const TriedView* at(const PlotPoint& point) const;
};

/// Searches the views: a coarse grid of all directions (inside: of all places), and then again and again the parts that are worst
/// so far, each in four. Needs a current context. A stop request ends it with what was found until then.
[[nodiscard]] WorstResult worstView(const WorstRequest& request, const Progress& progress = {});

/// What was found, in sentences.
[[nodiscard]] std::vector<Message> sentences(const WorstResult& result);
/// The map: outside of azimuth and elevation, inside a plan of the places, coloured by the value; the worst view is marked.
[[nodiscard]] LinePlot worstMap(const WorstResult& result);
/// With `poses` of the worst views, so that the file is a camera path, too.
[[nodiscard]] std::string worstJson(const WorstResult& result);
[[nodiscard]] std::string worstText(const WorstResult& result);

}  // namespace cullscope::worst
