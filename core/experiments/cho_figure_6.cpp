#include "core/experiments/cho_figure_6.h"

#include <algorithm>

#include "core/experiments/result_file.h"
#include "core/experiments/run_rows.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

// ---- What the paper states

constexpr double kFpsOfAll = 0.83;  // at every viewpoint
constexpr double kMostFps = 33, kMeanFps = 10;
constexpr double kSpeedup = 12;  // mean
constexpr double kCulledFraction = 0.79;
constexpr double kCullShare = 0.04;
constexpr int kViewpoints = 40;
constexpr Viewport kSize{650, 650};

std::vector<Message> notes() {
    return {
        note(CULLSCOPE_TR("The paper does not give its 40 viewpoints: here a walk on which the frustum leaves out about as "
                          "much, 79 % on average.")),
        note(CULLSCOPE_TR("Two-sided rows (solid lines) draw both sides of every face, as the paper does: compare them with "
                          "all. Front rows (dashed) leave back faces to OpenGL: compare them with backface.")),
        note(CULLSCOPE_TR("The paper's method is frustum-select; frustum tests the same boxes on the processor. The paper's "
                          "largest speed-up is its 33 fps over its 0.83.")),
        note(CULLSCOPE_TR("A few views with little in them raise the means of the frames per second and of the views' ratios; "
                          "\"fps, all views\" and \"× all\" are of the total times.")),
        note(CULLSCOPE_TR("Culling saves work on triangles, not on pixels: where pixels take much of the frame, as in a "
                          "software OpenGL, the gain is small.")),
        note(CULLSCOPE_TR("Where the walk leads through a bunny, a picture of both sides shows its inside, which backface "
                          "does not draw: those are its missed pixels.")),
        note(CULLSCOPE_TR("The paper's machine was a Pentium III at 866 MHz with a GeForce3 Ti 200: compare the ratios, not "
                          "the frames per second. The paper counts no lost pixels."))};
}

Axis cullingStrategies() {
    Axis axis{"strategy", CULLSCOPE_TR("strategy"), Axis::Kind::Strategy, {}};
    for (const char* strategy : {"all", "frustum-select", "frustum:facing=two-sided", "backface", "frustum", "frustum-octree",
                                 "frustum-query", "spherical-lossless"})
        axis.values.emplace_back(std::string(strategy));
    return axis;
}

std::vector<ResultColumn> columns() {
    return {{"strategy", CULLSCOPE_TR("strategy"), Origin::Axis},
            {"facing", CULLSCOPE_TR("sides drawn"), Origin::Axis},
            {"paper_fps_mean", CULLSCOPE_TR("paper: fps mean"), Origin::Stated, 2},
            {"fps_mean", CULLSCOPE_TR("fps mean"), Origin::Measured, 1},
            {"paper_fps_max", CULLSCOPE_TR("paper: fps max"), Origin::Stated, 2},
            {"fps_max", CULLSCOPE_TR("fps max"), Origin::Measured, 1},
            {"fps_min", CULLSCOPE_TR("fps min"), Origin::Measured, 1},
            {"fps_overall", CULLSCOPE_TR("fps, all views"), Origin::Measured, 1},
            {"paper_speedup_vs_all", CULLSCOPE_TR("paper: × all"), Origin::Stated, 1},
            {"speedup_vs_all", CULLSCOPE_TR("mean of the views' × all [95 %]"), Origin::Measured, 2},
            {"ratio_to_all", CULLSCOPE_TR("× all [95 %]"), Origin::Measured, 2},
            {"paper_speedup_vs_all_max", CULLSCOPE_TR("paper: × all, max"), Origin::Stated, 1},
            {"speedup_vs_all_max", CULLSCOPE_TR("× all, best view [95 %]"), Origin::Measured, 1},
            {"ratio_to_backface", CULLSCOPE_TR("× backface [95 %]"), Origin::Measured, 2},
            {"paper_culled_fraction", CULLSCOPE_TR("paper: culled, %"), Origin::Stated, 0, 100.0},
            {"culled_fraction", CULLSCOPE_TR("culled, %"), Origin::Measured, 1, 100.0},
            {"culled_fraction_max", CULLSCOPE_TR("culled max, %"), Origin::Measured, 1, 100.0},
            {"paper_cull_share", CULLSCOPE_TR("paper: culling, % of the frame"), Origin::Stated, 0, 100.0},
            {"cull_share", CULLSCOPE_TR("culling, % of the frame"), Origin::Measured, 2, 100.0},
            {"missed_pixels", CULLSCOPE_TR("missed px"), Origin::Measured},
            {"largest_hole_px", CULLSCOPE_TR("largest hole, px"), Origin::Measured},
            {"poses", CULLSCOPE_TR("views"), Origin::Measured}};
}

LinePlot framesByViewpoint() {
    LinePlot plot;
    plot.title = CULLSCOPE_TR("Frames per second by viewpoint");
    plot.x = {CULLSCOPE_TR("viewpoint"), PlotScale::Linear, 1.0, double(kViewpoints)};
    plot.y = {CULLSCOPE_TR("frames per second"), PlotScale::Logarithmic};
    plot.references = {{CULLSCOPE_TR("paper, culled, at most:"), kMostFps},
                       {CULLSCOPE_TR("paper, culled, mean:"), kMeanFps},
                       {CULLSCOPE_TR("paper, every bunny drawn:"), kFpsOfAll}};
    return plot;
}

Setting walkThroughTheField() {
    Setting setting;
    setting.scene = "field:mesh=mesh:bunny,triangles=5000,n=20,spacing=2.5";
    setting.shown = "frustum";
    setting.path = "walk:" + std::to_string(kViewpoints);
    setting.size = kSize;
    setting.stated["all"] = {{"paper_fps_mean", kFpsOfAll}, {"paper_fps_max", kFpsOfAll}};
    for (const char* culled : {"frustum-select", "frustum:facing=two-sided"})
        setting.stated[culled] = {{"paper_fps_mean", kMeanFps},
                                  {"paper_fps_max", kMostFps},
                                  {"paper_speedup_vs_all", kSpeedup},
                                  {"paper_speedup_vs_all_max", kMostFps / kFpsOfAll},
                                  {"paper_culled_fraction", kCulledFraction},
                                  {"paper_cull_share", kCullShare}};
    return setting;
}

// ---- What is measured here

/// The run of direct rendering; null where it was not requested.
const RunMeasurement* directRendering(const MeasureResult& result) {
    const auto found =
        std::find_if(result.runs.begin(), result.runs.end(), [](const RunMeasurement& run) { return run.strategy.id == "all"; });
    return found == result.runs.end() ? nullptr : &*found;
}

/// × in the view where it is the largest.
RatioEstimate bestRatio(const RunMeasurement& run, const RunMeasurement& all) {
    const auto ratio = [&](size_t view) { return all.frames[view].frameMilliseconds / run.frames[view].frameMilliseconds; };
    size_t best = 0;
    for (size_t view = 1; view < std::min(run.frames.size(), all.frames.size()); ++view)
        if (ratio(view) > ratio(best)) best = view;
    return ratioOver({&all.frames[best], 1}, {&run.frames[best], 1});
}

/// The largest share of the scene's triangles that a run culled in one view.
double largestCulledFraction(const RunMeasurement& run, const Scene& scene) {
    double least = 1.0;
    for (const FrameMeasurement& frame : run.frames) least = std::min(least, frame.submitted.share(scene.triangleCount()));
    return 1.0 - least;
}

Rows cullingRows(const Setting& setting, const MeasureResult& result) {
    const RunMeasurement* all = directRendering(result);
    Rows rows;
    for (const RunMeasurement& run : result.runs) {
        if (run.frames.empty()) continue;
        Row cells = rowCells(setting, run);
        cells["facing"] = std::string(facingId(run.facing));
        if (all != nullptr) cells["speedup_vs_all_max"] = bestRatio(run, *all);
        cells["culled_fraction_max"] = largestCulledFraction(run, *result.request.scene);
        rows.push_back(std::move(cells));
    }
    return rows;
}

/// Runs of one strategy have one colour; those that draw front faces only are dashed; the baselines are grey.
void plotRuns(ResultTable& table, const Setting& /*setting*/, const MeasureResult& result) {
    LinePlot& plot = table.plots.front();
    plot.lines.clear();
    std::vector<std::string> ids;
    for (const RunMeasurement& run : result.runs) {
        PlotLine line;
        line.name = strategyText(run.strategy);
        line.baseline = findStrategy(run.strategy.id).info.baseline != BaselineRole::None;
        line.dashed = run.facing == Facing::Front;
        const auto known = std::find(ids.begin(), ids.end(), run.strategy.id);
        line.colour = size_t(known - ids.begin());
        if (known == ids.end() && !line.baseline) ids.push_back(run.strategy.id);
        for (const FrameMeasurement& frame : run.frames)
            line.points.push_back({double(frame.pose + 1), 1000.0 / frame.frameMilliseconds});
        plot.lines.push_back(std::move(line));
    }
}

}  // namespace

Experiment choFigure6() {
    Experiment experiment;
    experiment.id = "vfc-40-views";
    experiment.title = CULLSCOPE_TR("400 bunnies from 40 viewpoints: view-frustum culling");
    experiment.source = "Cho et al., Figure 6";
    experiment.notes = notes();
    experiment.columns = columns();
    experiment.plots = {{framesByViewpoint()}};
    experiment.axes = {cullingStrategies()};
    experiment.settings = settingsOf(experiment.axes, walkThroughTheField());
    experiment.rowsOfRuns = cullingRows;
    experiment.plotFrames = plotRuns;
    return experiment;
}

}  // namespace cullscope
