// The latitude-longitude layout against the octahedral one, over meshes and resolutions.
#include <algorithm>
#include <array>

#include "core/measure/frame_measurement.h"
#include "core/spatial/cell_tree.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"
#include "tests/benchmark/lossless_scenes.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr std::array kLayouts{MapLayout::Octahedral, MapLayout::LatitudeLongitude};
constexpr std::array kLevels{5u, 6u, 7u, 8u, 0u};
constexpr size_t kLayoutViewsEach = 6;
constexpr int kLayoutRounds = 5;
constexpr int kLayoutBuilds = 3;

/// A layout at a level, over one mesh.
struct Racer {
    MapLayout layout = MapLayout::Octahedral;
    uint32_t level = 0;
    test::CullerPointer strategy{};
    double buildMilliseconds = 0.0;
    size_t nodes = 0, leaves = 0;
    double cellRatio = 1.0;  ///< largest : smallest solid angle of a leaf's cell
};

/// A racer over one path's views: what the meter says of each, and the sums of what it counts besides.
struct Means {
    std::vector<FrameMeasurement> frames{};
    double visited = 0.0;

    [[nodiscard]] double mean(const std::function<double(const FrameMeasurement&)>& of) const {
        double sum = 0.0;
        for (const FrameMeasurement& frame : frames) sum += of(frame);
        return sum / double(frames.size());
    }
};

double ratioOfLeaves(const CellTree& tree) {
    double largest = 0.0, smallest = 100.0;
    for (const CellTree::Node& node : tree.nodes()) {
        if (node.childCount > 0) continue;
        const double angle = solidAngle(tree.layout(), node.cell());
        largest = std::max(largest, angle);
        smallest = std::min(smallest, angle);
    }
    return largest / smallest;
}

Racer racerOf(const ScenePointer& scene, MapLayout layout, uint32_t level) {
    Racer racer{layout, level, lossless(layout, level, true, "auto")};
    std::vector<double> times;
    for (int i = 0; i < kLayoutBuilds; ++i) {
        racer.strategy->build(*scene);
        times.push_back(racer.strategy->structure().buildMilliseconds);
    }
    racer.buildMilliseconds = medianOf(times);
    const CellTree tree(scene->meshes().front(), {layout, level});
    racer.nodes = tree.nodes().size();
    racer.leaves = tree.leafCount();
    racer.cellRatio = ratioOfLeaves(tree);
    return racer;
}

std::vector<Racer> racersOf(const ScenePointer& scene) {
    static_cast<void>(scene->frontFacesSuffice());  // computed once for all layouts
    std::vector<Racer> all;
    for (const MapLayout layout : kLayouts)
        for (const uint32_t level : kLevels) all.push_back(racerOf(scene, layout, level));
    return all;
}

/// Times the frames of the racers beside `backface`, which is the last of `means`.
std::vector<Means> measured(const SceneBuffers& buffers, const std::vector<Racer>& racers, const BuiltStrategyPointer& backface,
                            const std::vector<View>& views) {
    TimingProtocol protocol;
    protocol.fixedRepetitions = kLayoutRounds;
    Renderer renderer;
    Framebuffer target(views.front().viewport());
    std::vector<Means> means(racers.size() + 1);
    for (const View& view : views) {
        std::vector<TimedFrames> entrants;
        for (size_t i = 0; i < means.size(); ++i) {
            const BuiltStrategyPointer& strategy = i < racers.size() ? racers[i].strategy->built() : backface;
            entrants.push_back({&buffers, strategy, view, {}});
            entrants.back().memories.push_back(strategy->begin());
        }
        TimedRounds rounds(std::move(entrants), protocol);
        while (!rounds.complete()) rounds.step(renderer, [&](const Viewport&, size_t) -> Framebuffer& { return target; });
        for (size_t i = 0; i < means.size(); ++i) {
            means[i].frames.push_back(measurementOf(rounds.entrants()[i]));
            means[i].visited += double(rounds.entrants()[i].log.counters.nodesVisited);
        }
    }
    return means;
}

std::string levelText(uint32_t level) { return level == 0 ? "auto" : std::to_string(level); }

Row cellsOf(const Racer& racer, const Means& means, const Means& backface, double faces) {
    const auto share = [&](Cause cause) {
        return means.mean([&](const FrameMeasurement& frame) { return double(frame.culledTriangles[size_t(cause)]) / faces; });
    };
    return {
        {"facing", std::string(racer.strategy->facing() == Facing::Front ? "front" : "two-sided")},
        {"layout", std::string(mapLayoutId(racer.layout))},
        {"level", levelText(racer.level)},
        {"build_ms", racer.buildMilliseconds},
        {"bytes", double(racer.strategy->structure().bytes)},
        {"nodes", double(racer.nodes)},
        {"leaves", double(racer.leaves)},
        {"largest_to_smallest_cell", racer.cellRatio},
        {"nodes_visited", means.visited / double(means.frames.size())},
        {"cull_ms", means.mean([](const FrameMeasurement& frame) { return frame.cullMilliseconds; })},
        {"considered_share", means.mean([&](const FrameMeasurement& frame) { return frame.submitted.share(uint64_t(faces)); })},
        {"outside_share", share(Cause::OutsideFrustum)},
        {"back_facing_share", share(Cause::BackFacing)},
        {"hidden_share", share(Cause::Hidden)},
        {"ratio_to_backface", ratioOver(backface.frames, means.frames)}};
}

Rows rowsOf(const MeshPointer& mesh) {
    const ScenePointer scene = sceneOf(mesh);
    const std::vector<Racer> racers = racersOf(scene);
    const test::CullerPointer backface = test::makeCuller("backface");
    backface->build(*scene);
    const SceneBuffers buffers(scene, Upload::Vbo);
    Rows rows;
    for (const Views& path : cutAndWithin(*scene, kLayoutViewsEach)) {
        const std::vector<Means> means = measured(buffers, racers, backface->built(), path.views);
        for (size_t i = 0; i < racers.size(); ++i) {
            rows.push_back(cellsOf(racers[i], means[i], means.back(), double(mesh->triangleCount())));
            rows.back().insert({{"mesh", mesh->name()}, {"path", path.name}});
        }
    }
    return rows;
}

/// A plot for each mesh; a line connects the levels of a layout over one path, coarse to fine, without auto.
RowPlot layoutsPlot() {
    RowPlot described{
        logPlot("%1, %2: share of the faces considered against what culling costs, levels 5 to 8", "ms a cull", "share")};
    described.x = "cull_ms";
    described.y = {{"considered_share"}};
    described.lines = {"layout", "path"};
    for (const uint32_t level : kLevels)
        if (level > 0) described.rows["level"].emplace_back(levelText(level));
    described.separate = {"mesh", "facing"};
    return described;
}

}  // namespace

Experiment losslessLayouts(const std::vector<std::string>& scenes) {
    Experiment experiment;
    experiment.id = "spherical-layouts";
    experiment.title = "Both layouts of the map of spherical-lossless, 320 x 240";
    std::vector<CellValue> layouts, levels;
    for (const MapLayout layout : kLayouts) layouts.emplace_back(std::string(mapLayoutId(layout)));
    for (const uint32_t level : kLevels) levels.emplace_back(levelText(level));
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, {scenes.begin(), scenes.end()}},
                       {"path", "path", Axis::Kind::InTurns, {std::string("cut"), std::string("within")}},
                       {"layout", "layout", Axis::Kind::InTurns, layouts},
                       {"level", "level", Axis::Kind::InTurns, levels}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"mesh", "facing"}) experiment.columns.push_back({key, key, Origin::Axis});
    const std::vector<std::pair<const char*, int>> measured{{"build_ms", 1},
                                                            {"bytes", 0},
                                                            {"nodes", 0},
                                                            {"leaves", 0},
                                                            {"largest_to_smallest_cell", 1},
                                                            {"nodes_visited", 0},
                                                            {"cull_ms", 3},
                                                            {"considered_share", 3},
                                                            {"outside_share", 3},
                                                            {"back_facing_share", 3},
                                                            {"hidden_share", 3},
                                                            {"ratio_to_backface", 2}};
    for (const auto& [key, decimals] : measured) experiment.columns.push_back({key, key, Origin::Measured, decimals});
    experiment.plots = {layoutsPlot()};
    experiment.draws = true;
    experiment.measured = [](const Setting& /*setting*/, const ScenePointer& scene, const Progress& /*progress*/) {
        return rowsOf(scene->meshes().front());
    };
    return experiment;
}

}  // namespace cullscope::benchmark
