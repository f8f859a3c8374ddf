#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/experiments/trade_plot.h"
#include "core/measure/meter.h"
#include "core/scene/camera_path.h"

namespace cullscope::advice {

struct AdviseRequest {
    ScenePointer scene;
    CameraPath path;
    Viewport size{640, 480};
    Upload upload = Upload::Vbo;
    double maxMissed = 0.0;  ///< of the covered pixels: the share that may be lost; 0: only what promises to lose nothing will do
    double buildSeconds = 0.0;  ///< after which building ends; 0: 100 frames of the fastest so far, at least half a second
};

/// How a strategy came out.
enum class Standing {
    Finished,   ///< it was in the race to the end
    Behind,     ///< it left: by its 95 % interval it is slower than the fastest
    FarBehind,  ///< it left after the first views, which took it several times as long as the fastest; or another value of a
                ///< parameter was not tried, as its default was refused or too slow
    Loses,      ///< it promises nothing here, or lost more than is allowed
    Refused     ///< it does not serve the scene, or building takes too long
};

struct AdvisedStrategy {
    StrategyRequest strategy;
    Promise promise = Promise::Approximate;  ///< the weakest at the path's views
    bool everything = false;                 ///< a baseline: it leaves out nothing
    bool limit = false;                      ///< what any culling could gain at most
    Standing standing = Standing::Refused;
    Message why{};       ///< for Standing::Refused
    bool built = false;  ///< its promise and its structure are known
    StructureReport structure{};
    // The three figures below hold for all views. Of a strategy that left the race they are the best one's, times how both
    // compare at the views and turns that it drew: with those alone one that saw the easy views would look faster than it is.
    size_t views = 0;                              ///< timed
    double frameMilliseconds = 0.0;                ///< mean
    std::optional<RatioEstimate> ratioToAll{};     ///< over drawing everything, both sides
    std::optional<RatioEstimate> headroomShare{};  ///< shareOfHeadroom; no interval where it left
    size_t judgedViews = 0, viewsWithLoss = 0;     ///< of the judged ones
    uint64_t coveredPixels = 0, lostPixels = 0;    ///< likewise
    std::optional<double>
        paybackFrames{};  ///< after which the structure's build time is saved; none: it has none, or nothing is saved

    [[nodiscard]] std::optional<double> missedRate() const {
        if (judgedViews == 0 || coveredPixels == 0) return std::nullopt;
        return double(lostPixels) / double(coveredPixels);
    }
};

/// Which strategy suits a scene.
struct Advice {
    AdviseRequest request;
    GlInfo gl{};
    std::vector<AdvisedStrategy> strategies;     ///< those that may be chosen first, each group by speed; last the refused ones
    std::optional<size_t> best;                  ///< none where it was stopped before anything was timed
    std::optional<double> limitRatio;            ///< ratio of the limit of culling to drawing everything
    std::optional<RatioEstimate> headroomShare;  ///< shareOfHeadroom of the best
    double seconds = 0.0;                        ///< of the whole, building included
    size_t frames = 0;                           ///< drawn
    bool interrupted = false;
};

/// What is tried: every strategy that needs no file and is no limit, at its defaults, the baselines first; then every value of
/// the sweeps that they declare.
[[nodiscard]] std::vector<StrategyRequest> candidates();

/// Measures the strategies that can serve a scene, and leaves out early those that cannot win: builds each, draws it at two
/// views, and then has those that remain draw every view in turns. One whose interval excludes the fastest leaves. Needs a
/// current context. A stop request ends it, and gives the advice of what was measured until then.
[[nodiscard]] Advice advise(const AdviseRequest& request, const Progress& progress = {});

/// The answer in sentences: which strategy, how fast, what it loses, what its structure costs, how much any culling could gain.
[[nodiscard]] std::vector<Message> sentences(const Advice& advice);
/// How a strategy came out, in words.
[[nodiscard]] Message standingWords(const AdvisedStrategy& strategy);
/// The sentences and the ranked table.
[[nodiscard]] std::string adviceText(const Advice& advice);
[[nodiscard]] std::string adviceJson(const Advice& advice);
/// The timed ones as points: ratio_to_all, lost_pixel_rate, build_ms, structure_bytes.
[[nodiscard]] std::vector<TradePoint> tradePoints(const Advice& advice);
[[nodiscard]] TradePoint tradePoint(const AdvisedStrategy& strategy);
/// Those that have room in a picture, in their order: the drawing of everything, and of each other strategy the value that came
/// first, but for what is far slower.
[[nodiscard]] std::vector<const AdvisedStrategy*> pictured(const Advice& advice);

}  // namespace cullscope::advice
