#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/experiments/plant_rows.h"
#include "core/spatial/occupancy.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::plants {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char* kSide = "side_px";

/// One point of the curve: a method with a threshold that stands for so many pixels.
struct CurvePoint {
    const char* method;
    double side;
    std::string strategy;  ///< as strategyText writes it
};

/// Half a length divided by the distance, for a square of a pixel.
double ratioOfPixel(const PlantFiguresSize& size) { return std::tan(kField.radians() / 2.0) / size.size.width; }

/// The paper's thresholds are ratios of half a length to a distance: half a picture is tan θ. The bounded method counts pixels.
std::vector<CurvePoint> curvePoints(const PlantFiguresSize& size) {
    std::vector<CurvePoint> points;
    const auto add = [&](const char* method, double side, const char* parameter, const std::string& value) {
        points.push_back({method, side, strategyText(strategyFromText(fmt::format("{}:{}={}", method, parameter, value)))});
    };
    for (const double side : size.sides) {
        const std::string ratio = fmt::format("{:.6g}", side * ratioOfPixel(size));
        add(kFeature, side, "threshold", ratio);
        add(kTriangle, side, "threshold", ratio);
        add(kBounded, side, "pixels", std::to_string(int64_t(side * side)));
    }
    return points;
}

/// Views of a whole scene from four sides and from distances at which its middle component has the size of the thresholds: all of
/// the scene may be in the picture, and small.
CameraPath viewsNearThresholds(const Scene& scene, const PlantFiguresSize& size) {
    std::vector<double> values;
    const std::vector<double> all = occupancyValues(scene);
    for (size_t i = 0; i < all.size(); ++i)
        if (scene.meshOf(i).triangleCount() > 0) values.push_back(all[i]);
    std::ranges::sort(values);
    const double middle = values.empty() ? 0.0 : values[values.size() / 2];
    CameraPath path = cameraPath("orbit:4", scene);
    const std::vector<CameraPath::Pose> sides = std::move(path.poses);
    path.poses.clear();
    const Sphere& around = scene.boundingSphere();
    for (const double side : size.distances) {
        const double distance = std::max(1.5 * around.radius, middle / (side * ratioOfPixel(size)));
        for (const CameraPath::Pose& pose : sides)
            path.poses.push_back({around.centre + distance * glm::normalize(pose.eye - pose.target), around.centre, pose.up});
        path.nearDistance = std::min(path.nearDistance, 0.01 * around.radius);
        path.farDistance = std::max(path.farDistance, distance + 2.0 * around.radius);
    }
    return path;
}

Rows curveRows(const std::vector<CurvePoint>& points, const Setting& setting, const MeasureResult& result) {
    Rows rows;
    for (const CurvePoint& point : points) {
        const RunMeasurement* run = runOf(result, point.strategy);
        if (run == nullptr) continue;
        rows.push_back(runCells(setting, result, *run));
        rows.back()["method"] = std::string(point.method);
        rows.back()[kSide] = point.side;
    }
    // What any culling could gain has no threshold.
    if (const RunMeasurement* limit = runOf(result, limitText())) {
        rows.push_back(runCells(setting, result, *limit));
        rows.back()["method"] = limitText();
    }
    return rows;
}

/// `views`: of the scene; the paper's field of view replaces their own.
Experiment curveOf(const PlantFiguresSize& size, const std::string& scene,
                   const std::function<CameraPath(const Scene& scene)>& views) {
    Experiment experiment;
    experiment.id = "plant-losses";
    experiment.title = CULLSCOPE_TR("Loss of small-feature culling by its threshold");
    experiment.source = "Du et al. 2017";
    experiment.notes = {
        note(CULLSCOPE_TR("A threshold of so many pixels is the side of a square. It is k′·tan θ of small-feature and "
                          "small-feature-triangle, with the paper's field of view of 30°; small-feature-bounded may lose as "
                          "many pixels of a group as the square has."))};
    experiment.axes = {{"scene", CULLSCOPE_TR("scene"), Axis::Kind::Scene, {scene}},
                       {kSide, CULLSCOPE_TR("threshold, px"), Axis::Kind::InTurns, axisValues(size.sides)}};
    const std::vector<CurvePoint> points = curvePoints(size);
    Setting common = commonSetting(size);
    common.stated.clear();  // the paper has no such curve
    common.strategies = {kOctree, limitText()};
    for (const CurvePoint& point : points)
        if (std::ranges::find(common.strategies, point.strategy) == common.strategies.end())
            common.strategies.push_back(point.strategy);
    common.path = "30° across";
    common.views = [views, picture = size.size](const Scene& opened) { return withField(views(opened), picture); };
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.back().decimals = 2;
    experiment.columns.push_back({"method", CULLSCOPE_TR("method"), Origin::Axis});
    for (const ResultColumn& column : plantColumns({}))
        for (const char* key : {"fps_overall", "ratio_to_octree", "headroom_share", "culled_fraction", "missed_pixels",
                                "missed_pixel_rate", "largest_hole_px", "lost_at_most", "beyond_stated", "cull_ms", "poses"})
            if (column.key == key) experiment.columns.push_back(column);
    const char* side = CULLSCOPE_TR("threshold, px");
    RowPlot speed = linesOf(logPlot(CULLSCOPE_TR("Speed by threshold: %1"), side, CULLSCOPE_TR("× frustum-octree")), kSide,
                            "ratio_to_octree", "method");
    RowPlot loss = linesOf(logPlot(CULLSCOPE_TR("Loss by threshold: %1"), side, CULLSCOPE_TR("missed pixels, share")), kSide,
                           "missed_pixel_rate", "method");
    loss.zeros = true;
    for (RowPlot* plot : {&loss, &speed}) plot->separate = {"scene"};
    experiment.plots = {std::move(loss), std::move(speed)};
    experiment.checks = {boundCheck()};
    experiment.rowsOfRuns = [points](const Setting& setting, const MeasureResult& result) {
        return curveRows(points, setting, result);
    };
    return experiment;
}

}  // namespace

Experiment lossCurve(const PlantFiguresSize& size) {
    Experiment experiment = curveOf(size, plantOf(size.curvePipelines),
                                    [size](const Scene& scene) { return partsOfWalk(scene, size.views, size.size); });
    experiment.ofScene = [size](const std::string& scene) {
        return curveOf(size, scene, [size](const Scene& opened) { return viewsNearThresholds(opened, size); });
    };
    return experiment;
}

}  // namespace cullscope::plants
