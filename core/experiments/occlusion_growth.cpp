#include "core/experiments/occlusion_growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/experiments/run_rows.h"
#include "core/scene/courts_scene.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char* kOctree = "frustum-octree";
constexpr std::array kOcclusion{"occlusion-hiz", "occlusion-chc", "occlusion-masked", "clusters"};
constexpr const char* kCopies = "copies";

Rows growthRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    const Scene& scene = *result.request.scene;
    for (const RunMeasurement& run : result.runs) {
        if (run.frames.empty()) continue;
        Row cells = rowCells(setting, run);
        cells["triangles"] = double(scene.triangleCount());
        cells["objects"] = double(scene.instances().size());
        cells["submitted"] = meanOfFrames(run, [](const FrameMeasurement& frame) { return double(frame.submitted.triangles); });
        addRatio(cells, "ratio_to_octree", runOf(result, kOctree), run);
        rows.push_back(std::move(cells));
    }
    return rows;
}

std::vector<ResultColumn> growthColumns(const std::vector<Axis>& axes) {
    std::vector<ResultColumn> columns = columnsOf(axes);
    const std::vector<ResultColumn> measured{{"triangles", CULLSCOPE_TR("triangles")},
                                             {"objects", CULLSCOPE_TR("objects")},
                                             {"frame_ms", CULLSCOPE_TR("frame, ms"), Origin::Measured, 2},
                                             {"cull_ms", CULLSCOPE_TR("culling, ms"), Origin::Measured, 2},
                                             {"ratio_to_octree", CULLSCOPE_TR("× frustum-octree [95 %]"), Origin::Measured, 2},
                                             headroomColumn(),
                                             {"submitted", CULLSCOPE_TR("triangles drawn a view"), Origin::Measured, 0},
                                             {"missed_pixels", CULLSCOPE_TR("missed px")},
                                             {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 1},
                                             {"structure_bytes", CULLSCOPE_TR("bytes")},
                                             {"poses", CULLSCOPE_TR("views")}};
    columns.insert(columns.end(), measured.begin(), measured.end());
    return columns;
}

/// By how many milliseconds a strategy's frame takes longer in the largest scene than in the smallest.
std::optional<double> addedMilliseconds(const ResultTable& table, const char* strategy) {
    std::vector<PlotPoint> points = pointsOf(table, {{{"strategy", {CellValue(std::string(strategy))}}}, kCopies, "frame_ms"});
    if (points.size() < 2) return std::nullopt;
    std::ranges::sort(points, {}, &PlotPoint::x);
    return points.back().y - points.front().y;
}

/// The least growth of the strategies that cull what is hidden, as a share of frustum-octree's.
std::optional<double> leastShare(const ResultTable& table) {
    const std::optional<double> octree = addedMilliseconds(table, kOctree);
    std::optional<double> least;
    for (const char* strategy : kOcclusion)
        if (const std::optional<double> own = addedMilliseconds(table, strategy); own && octree && *octree > 0.0)
            least = std::min(least.value_or(std::numeric_limits<double>::infinity()), *own / *octree);
    return least;
}

/// What both experiments have in common; the settings lack their scenes and views.
Experiment growing(const OcclusionGrowthSize& size, const std::vector<int>& sides) {
    Experiment experiment;
    std::vector<double> copies;
    for (const int side : sides) copies.push_back(double(side) * side);
    Axis strategies{"strategy", CULLSCOPE_TR("strategy"), Axis::Kind::Strategy, {std::string(kOctree)}};
    for (const char* strategy : kOcclusion) strategies.values.emplace_back(std::string(strategy));
    strategies.values.emplace_back(limitText());
    experiment.axes = {{kCopies, CULLSCOPE_TR("copies"), Axis::Kind::Label, axisValues(copies)}, std::move(strategies)};
    Setting common;
    common.shown = kOcclusion.front();
    common.size = size.size;
    common.timing.fixedRepetitions = size.repetitions;
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = growthColumns(experiment.axes);
    const char* triangles = CULLSCOPE_TR("triangles of the scene");
    experiment.plots = {
        linesOf(logPlot(CULLSCOPE_TR("Frame time by the size of the scene"), triangles, CULLSCOPE_TR("frame, ms")), "triangles",
                "frame_ms", "strategy"),
        linesOf(
            logPlot(CULLSCOPE_TR("Triangles drawn by the size of the scene"), triangles, CULLSCOPE_TR("triangles drawn a view")),
            "triangles", "submitted", "strategy")};
    for (RowPlot& plot : experiment.plots) plot.namesExponents = true;
    for (const char* strategy : kOcclusion)
        experiment.checks.push_back(everyRowCheck(fmt::format("pixels missed by {}", strategy),
                                                  {{"strategy", {CellValue(std::string(strategy))}}}, "missed_pixels",
                                                  {.most = 0.0}));
    experiment.rowsOfRuns = growthRows;
    return experiment;
}

int sideOf(const Setting& setting) { return int(std::lround(std::sqrt(setting.number(kCopies)))); }

/// Views from within the first court, the same however many others there are.
CameraPath toursOfFirstCourt(const Scene& courts, int n, const std::string& path) {
    CameraPath made = cameraPath(path, *firstCourt(courts, size_t(n)));
    made.farDistance = std::max(made.farDistance, 2.0 * courts.bounds().diagonal());
    return made;
}

Experiment ofCourts(const OcclusionGrowthSize& size) {
    Experiment experiment = growing(size, size.courts);
    experiment.id = "occlusion-growth";
    experiment.title = CULLSCOPE_TR("Frame time in one of ever more courts");
    experiment.notes = {
        note(CULLSCOPE_TR("Each court is a copy of the scene behind walls of its own. All views are of one court, the same for "
                          "all sizes: what is visible stays the same, while the frustum has more and more in it.")),
        note(CULLSCOPE_TR("An exponent of 1 means that the time grows as the scene does, 0 that it does not grow."))};
    for (Setting& setting : experiment.settings) {
        const int n = sideOf(setting);
        setting.scene = fmt::format("courts:mesh={},n={}", size.court, n);
        setting.path = fmt::format("tour:{} of the first court", size.views);
        setting.views = [n, path = fmt::format("tour:{}", size.views)](const Scene& scene) {
            return toursOfFirstCourt(scene, n, path);
        };
    }
    experiment.checks.push_back(
        {"least growth of the frame's time with occlusion culling, as a share of frustum-octree's", leastShare, -1.0, 0.1});
    experiment.ofScene = [size](const std::string& scene) {
        OcclusionGrowthSize own = size;
        own.court = scene;
        return ofCourts(own);
    };
    return experiment;
}

Experiment ofField(const OcclusionGrowthSize& size) {
    Experiment experiment = growing(size, size.bunnies);
    experiment.id = "occlusion-sizes";
    experiment.title = CULLSCOPE_TR("Frame time in a field of ever more objects");
    for (Setting& setting : experiment.settings) {
        setting.scene = fmt::format("field:mesh=bunny,n={}", sideOf(setting));
        setting.path = fmt::format("walk:{}", size.views);
    }
    return experiment;
}

}  // namespace

OcclusionGrowthSize sizeForGraphicsCard() {
    OcclusionGrowthSize size;
    size.courts = {1, 3, 10, 31};
    size.bunnies = {4, 13, 38, 119};
    return size;
}

std::vector<Experiment> occlusionGrowth(const OcclusionGrowthSize& size) { return {ofCourts(size), ofField(size)}; }

}  // namespace cullscope
