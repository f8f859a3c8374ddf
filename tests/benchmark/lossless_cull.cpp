// The cost of one cull by the number of faces, with equal pictures: one star shape in ever finer tessellations, the same cameras.
#include <array>

#include "core/mesh/parametric.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"
#include "tests/benchmark/lossless_scenes.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr size_t kCullShape = 7;
constexpr size_t kCamerasBy = 100'000;
constexpr size_t kCullViewsEach = 12;
constexpr int kCullRounds = 11;
constexpr Viewport kLarge{1920, 1080};
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

struct PathName {
    const char* id;
    const char* where;
};
constexpr std::array kPaths{PathName{"cut", "the frustum cuts the object, 320 x 240"},
                            PathName{"within", "the object inside the frustum, 320 x 240"},
                            PathName{"within-large", "the object inside the frustum, 1920 x 1080"}};

/// The result of one configuration over a path's views: means over the views.
Row countsOf(test::Culler& strategy, const Configuration& configuration, const Views& path, double faces) {
    double nodes = 0.0, considered = 0.0;
    std::array<double, kCauseCount> culled{};
    const double share = 1.0 / double(path.views.size());
    for (const View& view : path.views) {
        const test::Culled frame = strategy.cull(view);
        nodes += double(frame.nodesVisited) * share;
        considered += double(frame.consideredTriangles) / faces * share;
        for (size_t cause = 0; cause < kCauseCount; ++cause)
            culled[cause] += double(frame.culledTriangles[cause]) / faces * share;
    }
    return {{"faces", faces},
            {"path", path.name},
            {"configuration", std::string(configuration.name)},
            {"layout", std::string(mapLayoutId(configuration.layout))},
            {"level", double(configuration.level)},
            {"horizon", configuration.horizon ? 1.0 : 0.0},
            {"nodes_visited", nodes},
            {"considered_share", considered},
            {"outside_share", culled[size_t(Cause::OutsideFrustum)]},
            {"back_facing_share", culled[size_t(Cause::BackFacing)]},
            {"hidden_share", culled[size_t(Cause::Hidden)]}};
}

/// Milliseconds by configuration: the mean over the views of the median over the rounds.
std::vector<double> cullTimes(const std::vector<test::CullerPointer>& strategies, const std::vector<View>& views) {
    std::vector<double> means(strategies.size(), 0.0);
    for (const View& view : views) {
        std::vector<std::function<double()>> culls;
        for (const test::CullerPointer& strategy : strategies)
            culls.emplace_back([&view, culler = strategy.get()] { return culler->cull(view).log.cullMilliseconds; });
        const std::vector<std::vector<double>> times = inTurns(culls, kCullRounds);
        for (size_t i = 0; i < strategies.size(); ++i) means[i] += medianOf(times[i]) / double(views.size());
    }
    return means;
}

Rows rowsOf(const MeshPointer& mesh, const std::vector<Views>& paths) {
    const ScenePointer scene = sceneOf(mesh);
    std::vector<test::CullerPointer> strategies;
    for (const Configuration& c : kConfigurations) {
        // Above five million triangles `auto` draws both sides, because closedness is not checked, so `front` is set.
        strategies.push_back(lossless(c.layout, c.level, c.horizon, "front"));
        strategies.back()->build(*scene);
    }
    Rows rows;
    for (const Views& path : paths) {
        const std::vector<double> times = cullTimes(strategies, path.views);
        for (size_t i = 0; i < strategies.size(); ++i) {
            rows.push_back(countsOf(*strategies[i], kConfigurations[i], path, double(mesh->triangleCount())));
            rows.back()["cull_ms"] = times[i];
        }
    }
    return rows;
}

/// The cameras for all tessellations, and those of whole objects in a large picture too: triangles smaller than the raster's grid
/// of 1/256 pixel may be flipped by snapping, so that no cone counts as back-facing.
const std::vector<Views>& pathsOfAll() {
    static const std::vector<Views> kViews = [] {
        std::vector<Views> paths = cutAndWithin(*sceneOf(starMesh(kCullShape, kCamerasBy)), kCullViewsEach);
        paths.push_back({kPaths[2].id, {}});
        for (const View& view : paths[1].views) paths[2].views.emplace_back(view.camera(), kLarge);
        return paths;
    }();
    return kViews;
}

RowPlot plotOf(const char* path, const std::string& title, const char* unit, const char* column) {
    RowPlot described{logPlot(title, "faces", unit)};
    described.x = "faces";
    described.y = {{column}};
    described.lines = {"configuration"};
    described.rows = {{"path", {std::string(path)}}};
    described.powers = {{"as the faces grow", 1.0}, {"as their square root", 0.5}};
    return described;
}

/// That visited nodes grow less than the faces with automatic resolution, and hardly with equal cells.
std::vector<Check> cullChecks() {
    std::vector<Check> all;
    for (const PathName& path : kPaths)
        for (const Configuration& c : kConfigurations) {
            const RowFilter rows{{"path", {std::string(path.id)}}, {"configuration", {std::string(c.name)}}};
            const std::string place = std::string(path.id) + ", " + c.name;
            all.push_back(exponentCheck(place + ": nodes grow with the faces to the power of", {rows, "faces", "nodes_visited"},
                                        {.most = c.level == 0 ? kAutoExponent : kFixedExponent}));
            all.push_back(exponentCheck(place + ": cull time grows with the faces to the power of", {rows, "faces", "cull_ms"}));
        }
    return all;
}

template <typename Things>
std::vector<CellValue> namesOf(const Things& things, const char* Things::value_type::*name) {
    std::vector<CellValue> names;
    for (const auto& thing : things) names.emplace_back(std::string(thing.*name));
    return names;
}

}  // namespace

Experiment losslessCull() {
    Experiment experiment;
    experiment.id = "spherical-lossless-cull";
    experiment.title = "Nodes and time of one cull of spherical-lossless by faces, at equal pictures";
    experiment.axes = {{"faces", "faces", Axis::Kind::Label, axisValues(kGrowingFaces)},
                       {"path", "path", Axis::Kind::InTurns, namesOf(kPaths, &PathName::id)},
                       {"configuration", "configuration", Axis::Kind::InTurns, namesOf(kConfigurations, &Configuration::name)}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"layout", "level", "horizon"}) experiment.columns.push_back({key, key, Origin::Axis});
    experiment.columns.push_back({"nodes_visited", "nodes_visited"});
    experiment.columns.push_back({"cull_ms", "cull_ms", Origin::Measured, 4});
    for (const char* key : {"considered_share", "outside_share", "back_facing_share", "hidden_share"})
        experiment.columns.push_back({key, key, Origin::Measured, 3});
    for (const PathName& path : kPaths) {
        const std::string where = path.where;
        experiment.plots.push_back(plotOf(path.id, "Nodes visited by one cull, " + where, "nodes", "nodes_visited"));
        experiment.plots.push_back(plotOf(path.id, "Time of one cull, " + where, "ms", "cull_ms"));
    }
    experiment.checks = cullChecks();
    experiment.measured = [](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        return rowsOf(starMesh(kCullShape, size_t(setting.number("faces"))), pathsOfAll());
    };
    return experiment;
}

}  // namespace cullscope::benchmark
