// The latitude-longitude layout against the octahedral one, over meshes and resolutions.
#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/atomic_file.h"
#include "core/gpu/context.h"
#include "core/image/line_plot.h"
#include "core/measure/render_frame.h"
#include "core/spatial/cell_tree.h"
#include "tests/benchmark/lossless_benchmark.h"

namespace cullscope::benchmark {
namespace {

constexpr std::array kLayouts{MapLayout::Octahedral, MapLayout::LatitudeLongitude};
constexpr std::array kLevels{5u, 6u, 7u, 8u, 0u};
constexpr size_t kViewsEach = 6;
constexpr int kRounds = 5;
constexpr int kBuilds = 3;

/// A layout at a level, over one mesh.
struct Contestant {
    MapLayout layout = MapLayout::Octahedral;
    uint32_t level = 0;
    test::CullerPointer strategy;
    double buildMilliseconds = 0.0;
    size_t nodes = 0, leaves = 0;
    double cellRatio = 1.0;  ///< largest : smallest solid angle of a leaf's cell
};

/// The means of a contestant over one path's views; times are medians, the ratio is of frames of the same view.
struct LayoutSample {
    std::string mesh, path;
    MapLayout layout = MapLayout::Octahedral;
    uint32_t level = 0;
    Facing facing = Facing::TwoSided;
    double buildMilliseconds = 0.0, bytes = 0.0, cellRatio = 1.0;
    size_t nodes = 0, leaves = 0;
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

Contestant contestant(const ScenePointer& scene, MapLayout layout, uint32_t level) {
    Contestant result{layout, level, lossless(layout, level, true, "auto"), 0.0, 0, 0, 1.0};
    std::vector<double> times;
    for (int i = 0; i < kBuilds; ++i) {
        result.strategy->build(*scene);
        times.push_back(result.strategy->structure().buildMilliseconds);
    }
    result.buildMilliseconds = medianOf(times);
    const CellTree tree(scene->meshes().front(), {layout, level});
    result.nodes = tree.nodes().size();
    result.leaves = tree.leafCount();
    result.cellRatio = ratioOfLeaves(tree);
    return result;
}

std::vector<Contestant> contestants(const ScenePointer& scene) {
    static_cast<void>(scene->frontFacesSuffice());  // computed once for all layouts
    std::vector<Contestant> all;
    for (const MapLayout layout : kLayouts)
        for (const uint32_t level : kLevels) all.push_back(contestant(scene, layout, level));
    return all;
}

LayoutSample sampleOf(const Contestant& from, const std::string& mesh, const std::string& path) {
    LayoutSample sample;
    sample.mesh = mesh;
    sample.path = path;
    sample.layout = from.layout;
    sample.level = from.level;
    sample.facing = from.strategy->facing();
    sample.buildMilliseconds = from.buildMilliseconds;
    sample.bytes = double(from.strategy->structure().bytes);
    sample.nodes = from.nodes;
    sample.leaves = from.leaves;
    sample.cellRatio = from.cellRatio;
    return sample;
}

void addCounts(LayoutSample& sample, const FrameLog& frame, double faces, double share) {
    sample.visited += double(frame.counters.nodesVisited) * share;
    sample.considered += double(frame.consideredTriangles()) / faces * share;
    for (size_t cause = 0; cause < kCauseCount; ++cause)
        sample.culled[cause] += double(frame.counters.culledTriangles[cause]) / faces * share;
}

/// Draws the frames of the contestants and of backface in turns.
class FrameRace {
public:
    explicit FrameRace(const ScenePointer& scene) : m_buffers(scene, Upload::Vbo), m_backface(test::makeCuller("backface")) {
        m_backface->build(*scene);
    }

    void addView(const View& view, std::vector<Contestant>& racers, std::vector<LayoutSample>& samples, double share) {
        std::vector<double> baseline;
        std::vector<std::vector<double>> frames(racers.size()), culls(racers.size());
        for (int round = -1; round < kRounds; ++round) {
            const double backface = draw(*m_backface, view).frameMilliseconds;
            if (round >= 0) baseline.push_back(backface);
            for (size_t i = 0; i < racers.size(); ++i) {
                const FrameResult frame = draw(*racers[i].strategy, view);
                if (round < 0) {  // warm-up
                    addCounts(samples[i], frame.log, double(m_buffers.scene().triangleCount()), share);
                    continue;
                }
                frames[i].push_back(frame.frameMilliseconds);
                culls[i].push_back(frame.log.cullMilliseconds);
            }
        }
        for (size_t i = 0; i < racers.size(); ++i) {
            samples[i].cullMilliseconds += medianOf(culls[i]) * share;
            samples[i].framesOfBackface += medianOf(frames[i]) / medianOf(baseline) * share;
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

const char* facingText(Facing facing) { return facing == Facing::Front ? "front" : "two-sided"; }

void print(const LayoutSample& s) {
    std::printf(
        "%-7s %-9s %-6s %-18s %4s: build %6.1f ms, %5.1f MB, %6zu nodes, cells %7.1f : 1; %6.0f visited, cull %.3f ms, "
        "considered "
        "%4.1f %%, outside %4.1f, back-facing %4.1f, hidden %4.1f; frame %.2f x backface\n",
        s.mesh.c_str(), facingText(s.facing), s.path.c_str(), mapLayoutId(s.layout), levelText(s.level).c_str(),
        s.buildMilliseconds, 1e-6 * s.bytes, s.nodes, s.cellRatio, s.visited, s.cullMilliseconds, 100.0 * s.considered,
        100.0 * s.culled[size_t(Cause::OutsideFrustum)], 100.0 * s.culled[size_t(Cause::BackFacing)],
        100.0 * s.culled[size_t(Cause::Hidden)], s.framesOfBackface);
    std::fflush(stdout);
}

void addMesh(const MeshPointer& mesh, std::vector<LayoutSample>& all) {
    const ScenePointer scene = sceneOf(mesh);
    std::vector<Contestant> racers = contestants(scene);
    FrameRace race(scene);
    for (const Views& path : cutAndWithin(*scene, kViewsEach)) {
        std::vector<LayoutSample> samples;
        for (const Contestant& racer : racers) samples.push_back(sampleOf(racer, mesh->name(), path.name));
        for (const View& view : path.views) race.addView(view, racers, samples, 1.0 / double(path.views.size()));
        for (const LayoutSample& sample : samples) print(sample);
        all.insert(all.end(), samples.begin(), samples.end());
    }
}

void writeTable(const std::filesystem::path& file, const std::vector<LayoutSample>& samples) {
    writeFileAtomically(file, [&](std::ostream& out) {
        out << "mesh,facing,path,layout,level,build_ms,bytes,nodes,leaves,largest_to_smallest_cell,nodes_visited,cull_ms,"
               "considered_"
               "share,"
               "outside_share,back_facing_share,hidden_share,frame_to_backface\n";
        for (const LayoutSample& s : samples)
            out << s.mesh << ',' << facingText(s.facing) << ',' << s.path << ',' << mapLayoutId(s.layout) << ','
                << levelText(s.level) << ',' << s.buildMilliseconds << ',' << uint64_t(s.bytes) << ',' << s.nodes << ','
                << s.leaves << ',' << s.cellRatio << ',' << s.visited << ',' << s.cullMilliseconds << ',' << s.considered << ','
                << s.culled[size_t(Cause::OutsideFrustum)] << ',' << s.culled[size_t(Cause::BackFacing)] << ','
                << s.culled[size_t(Cause::Hidden)] << ',' << s.framesOfBackface << '\n';
    });
}

/// One plot for each mesh; a line connects the levels of a layout over one path, coarse to fine, without auto.
void writePlots(const std::filesystem::path& file, const std::vector<LayoutSample>& samples) {
    std::vector<LinePlot> plots;
    for (const LayoutSample& s : samples) {
        if (s.level == 0) continue;
        const std::string title = s.mesh + (s.facing == Facing::Front ? "" : ", both sides drawn") +
                                  ": share of the faces considered against what culling costs, levels 5 to 8";
        if (plots.empty() || plots.back().title != title) plots.push_back(logPlot(title, "ms a cull", "share"));
        const std::string name = (s.layout == MapLayout::Octahedral ? "octahedral, " : "latitude-longitude, ") + s.path;
        std::vector<PlotLine>& lines = plots.back().lines;
        if (lines.empty() || lines.back().name != name) lines.push_back({name, {}});
        lines.back().points.push_back({s.cullMilliseconds, std::max(s.considered, 1e-6)});
    }
    writeFileAtomically(file, [&](std::ostream& out) { out << linePlotsSvg(plots); });
}

}  // namespace

int layouts(const std::filesystem::path& folder, const std::vector<std::string>& specifications) {
    const HeadlessContext context;
    std::printf("%s, 320 x 240\n", context.info().renderer.c_str());
    std::vector<std::string> all = specifications;
    for (const char* shape : {"torus", "knot", "sphere"}) all.push_back(std::string(shape) + ":triangles=144046");
    std::vector<LayoutSample> samples;
    for (const std::string& specification : all) addMesh(meshOf(specification), samples);
    writeTable(folder / "spherical-layouts.csv", samples);
    writePlots(folder / "spherical-layouts.svg", samples);
    return 0;
}

}  // namespace cullscope::benchmark
