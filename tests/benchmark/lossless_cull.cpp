// The cost of one cull by the number of faces, with equal pictures: one star shape in ever finer tessellations, the same cameras.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/atomic_file.h"
#include "core/image/line_plot.h"
#include "core/mesh/parametric.h"
#include "tests/benchmark/lossless_benchmark.h"

namespace cullscope::benchmark {
namespace {

constexpr std::array kFaces{10'000u, 30'000u, 100'000u, 300'000u, 1'000'000u, 3'000'000u, 10'000'000u};
constexpr size_t kShape = 7;
constexpr size_t kCamerasBy = 100'000;
constexpr size_t kViewsEach = 12;
constexpr int kRounds = 11;
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

/// The result of one configuration over a path's views: means over the views, for times means of the views' medians.
struct CullSample {
    size_t configuration = 0;
    std::string path;
    size_t faces = 0;
    double nodes = 0.0, milliseconds = 0.0, considered = 0.0;
    std::array<double, kCauseCount> culled{};  ///< shares of the faces
};

CullSample countsOf(test::Culler& strategy, const Views& views, size_t faces) {
    CullSample sample;
    sample.path = views.name;
    sample.faces = faces;
    const double share = 1.0 / double(views.views.size());
    for (const View& view : views.views) {
        const test::Culled frame = strategy.cull(view);
        sample.nodes += double(frame.nodesVisited) * share;
        sample.considered += double(frame.consideredTriangles) / double(faces) * share;
        for (size_t cause = 0; cause < kCauseCount; ++cause)
            sample.culled[cause] += double(frame.culledTriangles[cause]) / double(faces) * share;
    }
    return sample;
}

/// Measured in turns. Milliseconds by configuration: the mean over the views of the median over the rounds.
std::vector<double> cullTimes(const std::vector<test::CullerPointer>& strategies, const std::vector<View>& views) {
    std::vector<double> means(strategies.size(), 0.0);
    for (const View& view : views) {
        std::vector<std::vector<double>> times(strategies.size());
        for (int round = 0; round < kRounds; ++round)
            for (size_t i = 0; i < strategies.size(); ++i) times[i].push_back(strategies[i]->cull(view).log.cullMilliseconds);
        for (size_t i = 0; i < strategies.size(); ++i) means[i] += medianOf(times[i]) / double(views.size());
    }
    return means;
}

void print(const CullSample& s) {
    std::printf(
        "%9zu faces, %-12s, %-19s: %8.0f nodes, %.4f ms; considered %4.1f %%, outside %4.1f, back-facing %4.1f, hidden %4.1f\n",
        s.faces, s.path.c_str(), kConfigurations[s.configuration].name, s.nodes, s.milliseconds, 100.0 * s.considered,
        100.0 * s.culled[size_t(Cause::OutsideFrustum)], 100.0 * s.culled[size_t(Cause::BackFacing)],
        100.0 * s.culled[size_t(Cause::Hidden)]);
    std::fflush(stdout);
}

void addSamples(const MeshPointer& mesh, const std::vector<Views>& paths, std::vector<CullSample>& samples) {
    const ScenePointer scene = sceneOf(mesh);
    std::vector<test::CullerPointer> strategies;
    for (const Configuration& c : kConfigurations) {
        // Above five million triangles `auto` draws both sides, because closedness is not checked, so `front` is set.
        strategies.push_back(lossless(c.layout, c.level, c.horizon, "front"));
        strategies.back()->build(*scene);
    }
    for (const Views& path : paths) {
        const std::vector<double> times = cullTimes(strategies, path.views);
        for (size_t i = 0; i < strategies.size(); ++i) {
            samples.push_back(countsOf(*strategies[i], path, mesh->triangleCount()));
            samples.back().configuration = i;
            samples.back().milliseconds = times[i];
            print(samples.back());
        }
    }
}

std::vector<PlotPoint> points(const std::vector<CullSample>& samples, const std::string& path, size_t configuration,
                              double CullSample::*value) {
    std::vector<PlotPoint> points;
    for (const CullSample& s : samples)
        if (s.path == path && s.configuration == configuration) points.push_back({double(s.faces), s.*value});
    return points;
}

/// A line that grows with a power of the faces from a line's first point on.
PlotLine growing(const char* name, const std::vector<PlotPoint>& from, double power) {
    PlotLine line{name, {}};
    for (const PlotPoint& point : from)
        line.points.push_back({point.x, from.front().y * std::pow(point.x / from.front().x, power)});
    return line;
}

LinePlot plotOf(const std::vector<CullSample>& samples, const std::string& path, const std::string& title, const char* unit,
                double CullSample::*value) {
    LinePlot plot = logPlot(title, "faces", unit);
    for (size_t i = 0; i < kConfigurations.size(); ++i)
        plot.lines.push_back({kConfigurations[i].name, points(samples, path, i, value)});
    plot.lines.push_back(growing("as the faces grow", plot.lines.front().points, 1.0));
    plot.lines.push_back(growing("as their square root", plot.lines.front().points, 0.5));
    return plot;
}

void write(const std::filesystem::path& folder, const std::vector<CullSample>& samples) {
    writeFileAtomically(folder / "spherical-lossless-cull.csv", [&](std::ostream& out) {
        out << "faces,path,layout,level,horizon,nodes_visited,cull_ms,considered_share,outside_share,back_facing_share,"
               "hidden_share\n";
        for (const CullSample& s : samples) {
            const Configuration& c = kConfigurations[s.configuration];
            out << s.faces << ',' << s.path << ',' << mapLayoutId(c.layout) << ',' << c.level << ',' << (c.horizon ? 1 : 0) << ','
                << s.nodes << ',' << s.milliseconds << ',' << s.considered << ',' << s.culled[size_t(Cause::OutsideFrustum)]
                << ',' << s.culled[size_t(Cause::BackFacing)] << ',' << s.culled[size_t(Cause::Hidden)] << '\n';
        }
    });
    std::vector<LinePlot> plots;
    for (const auto& [path, where] : kPaths) {
        plots.push_back(plotOf(samples, path, std::string("Nodes visited by one cull, ") + where, "nodes", &CullSample::nodes));
        plots.push_back(plotOf(samples, path, std::string("Time of one cull, ") + where, "ms", &CullSample::milliseconds));
    }
    writeFileAtomically(folder / "spherical-lossless-cull.svg", [&](std::ostream& out) { out << linePlotsSvg(plots); });
}

/// The cameras for all tessellations, and those of whole objects in a large picture too: triangles smaller than the raster's grid
/// of 1/256 pixel may be flipped by snapping, so that no cone counts as back-facing.
std::vector<Views> pathsOfAll() {
    std::vector<Views> paths = cutAndWithin(*sceneOf(starMesh(kShape, kCamerasBy)), kViewsEach);
    paths.push_back({kPaths[2].id, {}});
    for (const View& view : paths[1].views) paths[2].views.emplace_back(view.camera(), kLarge);
    return paths;
}

/// Whether visited nodes grow less than the faces with automatic resolution, and hardly with equal cells; prints the result.
bool fewerThanFaces(const std::vector<CullSample>& samples) {
    bool fewer = true;
    for (const PathName& path : kPaths)
        for (size_t i = 0; i < kConfigurations.size(); ++i) {
            const double nodes = exponentOf(points(samples, path.id, i, &CullSample::nodes));
            const double time = exponentOf(points(samples, path.id, i, &CullSample::milliseconds));
            std::printf("%-12s, %-19s: nodes grow with faces^%.2f, cull time with faces^%.2f\n", path.id, kConfigurations[i].name,
                        nodes, time);
            fewer = fewer && nodes < (kConfigurations[i].level == 0 ? kAutoExponent : kFixedExponent);
        }
    return fewer;
}

}  // namespace

int cullByFaces(const std::filesystem::path& folder) {
    const std::vector<Views> paths = pathsOfAll();
    std::vector<CullSample> samples;
    for (const size_t faces : kFaces) addSamples(starMesh(kShape, faces), paths, samples);
    write(folder, samples);
    return fewerThanFaces(samples) ? 0 : 1;
}

}  // namespace cullscope::benchmark
