// The cost of one cull by the number of faces, with equal pictures: one star shape in ever finer tessellations, the same cameras.
#include <array>

#include "core/experiments/run_rows.h"
#include "core/mesh/parametric.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/lossless_scenes.h"
#include "tests/benchmark/run_means.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr size_t kCullShape = 7;
constexpr const char* kWithinLarge = "within-large";
// Limits for the exponent with which visited nodes grow with the faces: below linear growth, and hardly any growth.
constexpr double kAutoExponent = 0.9;
constexpr double kFixedExponent = 0.2;

struct Configuration {
    const char* name;
    MapLayout layout;
    uint32_t level;
    bool horizon;
};
constexpr std::array kConfigurations{Configuration{"octahedral, auto", MapLayout::Octahedral, 0, true},
                                     Configuration{"lat.-long., auto", MapLayout::LatitudeLongitude, 0, true},
                                     Configuration{"oct., no horizon", MapLayout::Octahedral, 0, false},
                                     Configuration{"octahedral, level 6", MapLayout::Octahedral, 6, true},
                                     Configuration{"lat.-long., level 6", MapLayout::LatitudeLongitude, 6, true}};

std::string cullStrategy(const Configuration& configuration) {
    // Above five million triangles `auto` draws both sides, because closedness is not checked, so `front` is set.
    return losslessText(configuration.layout, configuration.level, configuration.horizon, "front");
}

std::vector<CellValue> cullPaths() {
    std::vector<CellValue> names(kObjectPaths.begin(), kObjectPaths.end());
    names.emplace_back(std::string(kWithinLarge));
    return names;
}

/// The cameras for all tessellations, by path. Made when the first one is asked for.
std::function<CameraPath(const std::string& path)> camerasOfAll(const LosslessCullSize& size) {
    return [size, scene = std::make_shared<ScenePointer>()](const std::string& path) {
        if (!*scene) *scene = sceneOf(starMesh(kCullShape, size.camerasBy));
        return objectPath(path == kWithinLarge ? kObjectPaths.back() : path, **scene, size.views);
    };
}

/// One configuration over a path's views: means over the views.
Row cullCells(const Setting& setting, const RunMeasurement& run, const Configuration& configuration, double faces) {
    Row row = rowCells(setting, run);
    const auto share = [&](Cause cause) {
        return meanOver(run, [&](const FrameMeasurement& frame) { return double(frame.culledTriangles[size_t(cause)]) / faces; });
    };
    row["faces"] = faces;
    row["configuration"] = std::string(configuration.name);
    row["layout"] = std::string(mapLayoutId(configuration.layout));
    row["level"] = double(configuration.level);
    row["horizon"] = configuration.horizon ? 1.0 : 0.0;
    row["nodes_visited"] = meanOver(run, [](const FrameMeasurement& frame) { return double(frame.nodesVisited); });
    row["cull_ms"] = meanOver(run, [](const FrameMeasurement& frame) { return frame.cullMilliseconds; });
    row["considered_share"] =
        meanOver(run, [&](const FrameMeasurement& frame) { return double(frame.consideredTriangles) / faces; });
    row["outside_share"] = share(Cause::OutsideFrustum);
    row["back_facing_share"] = share(Cause::BackFacing);
    row["hidden_share"] = share(Cause::Hidden);
    return row;
}

Rows cullRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    for (const Configuration& configuration : kConfigurations)
        for (const RunMeasurement& run : result.runs)
            if (!run.frames.empty() && strategyText(run.strategy) == cullStrategy(configuration))
                rows.push_back(cullCells(setting, run, configuration, double(result.request.scene->triangleCount())));
    return rows;
}

RowPlot cullPlot(const char* title, const char* unit, const char* column) {
    RowPlot described{logPlot(title, "faces", unit)};
    described.x = "faces";
    described.y = {{column}};
    described.lines = {"configuration"};
    described.separate = {"path"};
    described.powers = {{"as the faces grow", 1.0}, {"as their square root", 0.5}};
    return described;
}

/// That visited nodes grow less than the faces with automatic resolution, and hardly with equal cells.
std::vector<Check> cullChecks() {
    std::vector<Check> all;
    for (const CellValue& path : cullPaths())
        for (const Configuration& c : kConfigurations) {
            const RowFilter rows{{"path", {path}}, {"configuration", {std::string(c.name)}}};
            const std::string place = std::get<std::string>(path) + ", " + c.name;
            all.push_back(exponentCheck(place + ": nodes grow with the faces to the power of", {rows, "faces", "nodes_visited"},
                                        {.most = c.level == 0 ? kAutoExponent : kFixedExponent}));
            all.push_back(exponentCheck(place + ": cull time grows with the faces to the power of", {rows, "faces", "cull_ms"}));
        }
    return all;
}

}  // namespace

Experiment losslessCull(const LosslessCullSize& size) {
    Experiment experiment;
    experiment.id = "spherical-lossless-cull";
    experiment.title = "Nodes and time of one cull of spherical-lossless by faces, at equal pictures";
    experiment.notes = {
        {"case-1 to case-3: the frustum cuts the object; within: the object inside the frustum; both %1 x %2. "
         "within-large: the same at %3 x %4. All tessellations have the cameras of the one of %5 faces.",
         {std::to_string(size.picture.width), std::to_string(size.picture.height), std::to_string(size.large.width),
          std::to_string(size.large.height), std::to_string(size.camerasBy)}}};
    std::vector<CellValue> configurations;
    Setting common;
    for (const Configuration& configuration : kConfigurations) {
        configurations.emplace_back(std::string(configuration.name));
        common.strategies.push_back(cullStrategy(configuration));
    }
    common.timing.fixedRepetitions = size.repetitions;
    experiment.axes = {{"faces", "faces", Axis::Kind::Label, axisValues(kGrowingFaces)},
                       {"path", "path", Axis::Kind::Path, cullPaths()},
                       {"configuration", "configuration", Axis::Kind::InTurns, configurations}};
    const auto cameras = camerasOfAll(size);
    experiment.settings = settingsOf(experiment.axes, common);
    for (Setting& setting : experiment.settings) {
        setting.scene =
            "star:seed=" + std::to_string(kCullShape) + ",triangles=" + std::to_string(size_t(setting.number("faces")));
        // Triangles smaller than the raster's grid of 1/256 pixel may be flipped by snapping, so that no cone counts as
        // back-facing: whole objects are seen in a large picture, too.
        setting.size = setting.path == kWithinLarge ? size.large : size.picture;
        setting.views = [path = setting.path, cameras](const Scene&) { return cameras(path); };
    }
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"layout", "level", "horizon"}) experiment.columns.push_back({key, key, Origin::Axis});
    experiment.columns.push_back({"nodes_visited", "nodes_visited"});
    experiment.columns.push_back({"cull_ms", "cull_ms", Origin::Measured, 4});
    for (const char* key : {"considered_share", "outside_share", "back_facing_share", "hidden_share"})
        experiment.columns.push_back({key, key, Origin::Measured, 3});
    experiment.columns.push_back({"missed_pixels", "missed_pixels"});
    experiment.columns.push_back({"ratio_to_backface", "x backface [95 %]", Origin::Measured, 2});
    experiment.plots = {cullPlot("Nodes visited by one cull, %1", "nodes", "nodes_visited"),
                        cullPlot("Time of one cull, %1", "ms", "cull_ms")};
    experiment.checks = cullChecks();
    experiment.rowsOfRuns = cullRows;
    return experiment;
}

}  // namespace cullscope::benchmark
