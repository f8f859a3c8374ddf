// The latitude-longitude layout against the octahedral one, over meshes and resolutions.
#include <algorithm>
#include <array>

#include "core/measure/render_frame.h"
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

/// The means of a racer over one path's views; times are medians, the ratio is of frames of the same view.
struct Means {
    double visited = 0.0, cullMilliseconds = 0.0, considered = 0.0, framesOfBackface = 0.0;
    std::array<double, kCauseCount> culled{};
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

void addCounts(Means& means, const FrameLog& frame, double faces, double share) {
    means.visited += double(frame.counters.nodesVisited) * share;
    means.considered += double(frame.consideredTriangles()) / faces * share;
    for (size_t cause = 0; cause < kCauseCount; ++cause)
        means.culled[cause] += double(frame.counters.culledTriangles[cause]) / faces * share;
}

/// Draws the frames of the racers and of backface in turns.
class FrameRace {
public:
    explicit FrameRace(const ScenePointer& scene) : m_buffers(scene, Upload::Vbo), m_backface(test::makeCuller("backface")) {
        m_backface->build(*scene);
    }

    void addView(const View& view, std::vector<Racer>& racers, std::vector<Means>& means, double share) {
        std::vector<std::vector<double>> culls(racers.size());
        std::vector<std::function<double()>> draws{[&] { return draw(*m_backface, view).frameMilliseconds; }};
        for (size_t i = 0; i < racers.size(); ++i)
            draws.emplace_back([&, i] {
                const FrameResult frame = draw(*racers[i].strategy, view);
                // The first is of the warm-up.
                if (culls[i].empty()) addCounts(means[i], frame.log, double(m_buffers.scene().triangleCount()), share);
                culls[i].push_back(frame.log.cullMilliseconds);
                return frame.frameMilliseconds;
            });
        const std::vector<std::vector<double>> frames = inTurns(draws, kLayoutRounds, 1);
        for (size_t i = 0; i < racers.size(); ++i) {
            culls[i].erase(culls[i].begin());
            means[i].cullMilliseconds += medianOf(culls[i]) * share;
            means[i].framesOfBackface += medianOf(frames[i + 1]) / medianOf(frames[0]) * share;
        }
    }

private:
    FrameResult draw(test::Culler& strategy, const View& view) {
        return renderFrame(m_renderer, m_buffers, *strategy.built(), strategy.state(), view, m_target);
    }

    Renderer m_renderer;
    SceneBuffers m_buffers;
    Framebuffer m_target{Viewport{320, 240}};
    test::CullerPointer m_backface;
};

std::string levelText(uint32_t level) { return level == 0 ? "auto" : std::to_string(level); }

Row cellsOf(const Racer& racer, const Means& means) {
    return {{"facing", std::string(racer.strategy->facing() == Facing::Front ? "front" : "two-sided")},
            {"layout", std::string(mapLayoutId(racer.layout))},
            {"level", levelText(racer.level)},
            {"build_ms", racer.buildMilliseconds},
            {"bytes", double(racer.strategy->structure().bytes)},
            {"nodes", double(racer.nodes)},
            {"leaves", double(racer.leaves)},
            {"largest_to_smallest_cell", racer.cellRatio},
            {"nodes_visited", means.visited},
            {"cull_ms", means.cullMilliseconds},
            {"considered_share", means.considered},
            {"outside_share", means.culled[size_t(Cause::OutsideFrustum)]},
            {"back_facing_share", means.culled[size_t(Cause::BackFacing)]},
            {"hidden_share", means.culled[size_t(Cause::Hidden)]},
            {"frame_to_backface", means.framesOfBackface}};
}

Rows rowsOf(const MeshPointer& mesh) {
    const ScenePointer scene = sceneOf(mesh);
    std::vector<Racer> racers = racersOf(scene);
    FrameRace race(scene);
    Rows rows;
    for (const Views& path : cutAndWithin(*scene, kLayoutViewsEach)) {
        std::vector<Means> means(racers.size());
        for (const View& view : path.views) race.addView(view, racers, means, 1.0 / double(path.views.size()));
        for (size_t i = 0; i < racers.size(); ++i) {
            rows.push_back(cellsOf(racers[i], means[i]));
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
                                                            {"frame_to_backface", 2}};
    for (const auto& [key, decimals] : measured) experiment.columns.push_back({key, key, Origin::Measured, decimals});
    experiment.plots = {layoutsPlot()};
    experiment.draws = true;
    experiment.measured = [](const Setting& /*setting*/, const ScenePointer& scene, const Progress& /*progress*/) {
        return rowsOf(scene->meshes().front());
    };
    return experiment;
}

}  // namespace cullscope::benchmark
