// The structures of `spherical-lossless`: build time beside Embree's tree of the same mesh, and growth with the number of faces.
#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/line_plot.h"
#include "core/measure/meter.h"
#include "core/measure/statistics.h"
#include "core/mesh/parametric.h"
#include "core/spatial/cell_tree.h"
#include "core/spatial/inner_kernel.h"
#include "tests/benchmark/lossless_benchmark.h"

namespace cullscope::benchmark {
namespace {

constexpr std::array kFaces{10'000u, 30'000u, 100'000u, 300'000u, 1'000'000u, 3'000'000u, 10'000'000u};
constexpr size_t kLeastTimed = 90'000;
constexpr int kBuilds = 5;
constexpr double kMostBytes = 14e6;
constexpr double kMostTimesEmbree = 1.5;
constexpr double kBytesTolerance = 0.05;
constexpr double kTimeTolerance = 0.20;

/// Milliseconds for the parts built for one mesh; `all` is the strategy's own build with the bounding sphere, measured
/// separately.
struct BuildTimes {
    double all = 0.0, sphere = 0.0, topology = 0.0, tree = 0.0, kernel = 0.0;
};

struct BuildSample {
    std::string mesh;
    size_t faces = 0;
    size_t cells = 0;
    uint64_t bytes = 0;
    BuildTimes times;
};

double figure(const StructureReport& report, const std::string& name) {
    return std::ranges::find(report.figures, name, &StructureReport::Figure::name)->value;
}

/// Builds the strategy on a mesh without cached properties; fills in bytes and cells.
double wholeBuild(const TriangleMesh& mesh, BuildSample& sample) {
    const MeshPointer fresh = freshCopy(mesh);
    const double sphere = timeOf([&] { static_cast<void>(fresh->localSphere()); });
    const ScenePointer scene = sceneOf(fresh);
    const test::CullerPointer strategy = lossless(MapLayout::Octahedral, 0, true, "auto");
    const double rest = timeOf([&] { strategy->build(*scene); });
    sample.bytes = strategy->structure().bytes;
    sample.cells = size_t(figure(strategy->structure(), "cells"));
    return sphere + rest;
}

BuildTimes buildTimes(const TriangleMesh& mesh, BuildSample& sample) {
    BuildTimes times;
    times.all = wholeBuild(mesh, sample);
    const MeshPointer fresh = freshCopy(mesh);
    times.sphere = timeOf([&] { static_cast<void>(fresh->localSphere()); });
    if (fresh->triangleCount() <= kOptionalAnalysisLimit) times.topology = timeOf([&] { static_cast<void>(fresh->topology()); });
    times.tree = timeOf([&] { const CellTree tree(fresh, {}); });
    times.kernel = timeOf([&] { const InnerKernel kernel(*fresh); });
    return times;
}

double leastOf(const std::vector<double>& values) { return *std::ranges::min_element(values); }

/// One time for each part, from several builds.
BuildTimes reduced(const std::vector<BuildTimes>& builds, double (*reduce)(const std::vector<double>&)) {
    const auto part = [&](double BuildTimes::*which) {
        std::vector<double> values;
        for (const BuildTimes& build : builds) values.push_back(build.*which);
        return reduce(values);
    };
    return {part(&BuildTimes::all), part(&BuildTimes::sphere), part(&BuildTimes::topology), part(&BuildTimes::tree),
            part(&BuildTimes::kernel)};
}

/// The shortest times, because other programs on the machine only lengthen them.
BuildSample sampleOf(const TriangleMesh& mesh) {
    BuildSample sample{mesh.name(), mesh.triangleCount(), 0, 0, {}};
    std::vector<BuildTimes> builds;
    for (int i = 0; i < kBuilds; ++i) builds.push_back(buildTimes(mesh, sample));
    sample.times = reduced(builds, leastOf);
    const BuildTimes& t = sample.times;
    std::printf(
        "%-8s %9zu faces, %7zu cells: %.1f bytes a face, %.2f ms (sphere %.2f, closedness %.2f, cell tree %.2f, kernel %.2f)\n",
        sample.mesh.c_str(), sample.faces, sample.cells, double(sample.bytes) / double(sample.faces), t.all, t.sphere, t.topology,
        t.tree, t.kernel);
    std::fflush(stdout);
    return sample;
}

/// Embree's tree over a mesh's triangles.
class EmbreeTree {
public:
    explicit EmbreeTree(const TriangleMesh& mesh)
        : m_device(rtcNewDevice(nullptr)),
          m_positions(mesh.positions().begin(), mesh.positions().end()),
          m_indices(mesh.indices().begin(), mesh.indices().end()) {
        // Embree reads 16 bytes from the last position too.
        m_positions.emplace_back(0.0f);
    }
    ~EmbreeTree() { rtcReleaseDevice(m_device); }
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;

    /// Milliseconds of a build in medium quality, on the arrays in place.
    [[nodiscard]] double build() const {
        RTCScene scene = nullptr;
        const double time = timeOf([&] {
            scene = rtcNewScene(m_device);
            rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
            RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, m_positions.data(), 0,
                                       sizeof(Vec3f), m_positions.size() - 1);
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, m_indices.data(), 0,
                                       3 * sizeof(uint32_t), m_indices.size() / 3);
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene, geometry);
            rtcReleaseGeometry(geometry);
            rtcCommitScene(scene);
        });
        rtcReleaseScene(scene);
        return time;
    }

private:
    RTCDevice m_device;
    std::vector<Vec3f> m_positions;
    std::vector<uint32_t> m_indices;
};

std::vector<PlotPoint> points(const std::vector<BuildSample>& samples, const std::string& mesh, auto value, size_t least = 0,
                              size_t most = kFaces.back()) {
    std::vector<PlotPoint> points;
    for (const BuildSample& sample : samples)
        if (sample.mesh == mesh && sample.faces >= least && sample.faces <= most && value(sample) > 0.0)
            points.push_back({double(sample.faces), value(sample)});
    return points;
}

double bytesOf(const BuildSample& sample) { return double(sample.bytes); }
double timeOfAll(const BuildSample& sample) { return sample.times.all; }
double timeOfTree(const BuildSample& sample) { return sample.times.tree; }

void writeGrowth(const std::filesystem::path& folder, const std::vector<BuildSample>& samples) {
    writeFileAtomically(folder / "spherical-lossless-growth.csv", [&](std::ostream& out) {
        out << "mesh,faces,cells,bytes,bytes_per_face,build_ms,sphere_ms,closedness_ms,cell_tree_ms,kernel_ms\n";
        for (const BuildSample& s : samples)
            out << s.mesh << ',' << s.faces << ',' << s.cells << ',' << s.bytes << ',' << double(s.bytes) / double(s.faces) << ','
                << s.times.all << ',' << s.times.sphere << ',' << s.times.topology << ',' << s.times.tree << ',' << s.times.kernel
                << '\n';
    });
    LinePlot bytes = logPlot("Bytes of spherical-lossless by faces", "faces", "bytes");
    LinePlot times =
        logPlot("Build time of spherical-lossless by faces (above five million without closedness and kernel)", "faces", "ms");
    for (const char* mesh : {"sphere", "star"}) {
        const auto add = [&](LinePlot& plot, const char* name, auto value) {
            plot.lines.push_back({std::string(mesh) + ": " + name, points(samples, mesh, value)});
        };
        add(bytes, "all", bytesOf);
        add(times, "all", timeOfAll);
        add(times, "cell tree", timeOfTree);
        add(times, "closedness", [](const BuildSample& s) { return s.times.topology; });
        add(times, "inner kernel", [](const BuildSample& s) { return s.times.topology > 0.0 ? s.times.kernel : 0.0; });
    }
    writeFileAtomically(folder / "spherical-lossless-growth.svg", [&](std::ostream& out) {
        out << linePlotsSvg({bytes, times});
    });
}

/// Whether a mesh's structures grow at most linearly; prints the result. Small meshes are excluded from the times, because the
/// kernel's constant cost dominates there, and the largest from the sum, because less is built for it.
bool linear(const std::vector<BuildSample>& samples, const std::string& mesh) {
    const double bytes = exponentOf(points(samples, mesh, bytesOf));
    const double time = exponentOf(points(samples, mesh, timeOfAll, kLeastTimed, kOptionalAnalysisLimit));
    const double tree = exponentOf(points(samples, mesh, timeOfTree, kLeastTimed));
    std::printf(
        "%s: bytes grow with faces^%.3f; from 100,000 faces on build time up to 3 million with faces^%.3f, the cell tree's up to "
        "10 million with faces^%.3f\n",
        mesh.c_str(), bytes, time, tree);
    return std::abs(bytes - 1.0) <= kBytesTolerance && time <= 1.0 + kTimeTolerance && tree <= 1.0 + kTimeTolerance;
}

void printBuild(const std::vector<double>& ours, const std::vector<double>& theirs, const BuildSample& sample,
                const BuildTimes& parts) {
    std::printf("%s, %zu faces, %d threads, %zu rounds in turns\n", sample.mesh.c_str(), sample.faces,
                tbb::this_task_arena::max_concurrency(), ours.size());
    const auto row = [](const char* name, const std::vector<double>& times) {
        std::printf("%-20s best %8.2f ms, median %8.2f ms\n", name, leastOf(times), medianOf(times));
    };
    row("spherical-lossless", ours);
    row("Embree", theirs);
    std::printf("parts, medians: sphere %.2f, closedness %.2f, cell tree %.2f, kernel %.2f ms\n", parts.sphere, parts.topology,
                parts.tree, parts.kernel);
}

}  // namespace

int buildBesideEmbree(const std::string& specification, int rounds) {
    const MeshPointer mesh = meshOf(specification);
    const EmbreeTree embree(*mesh);
    BuildSample sample{mesh->name(), mesh->triangleCount(), 0, 0, {}};
    std::vector<double> ours, theirs, ratios;
    std::vector<BuildTimes> parts;
    for (int round = -1; round < rounds; ++round) {
        const double first = embree.build();
        const BuildTimes times = buildTimes(*mesh, sample);
        const double second = embree.build();
        if (round < 0) continue;  // warm-up
        parts.push_back(times);
        ours.push_back(times.all);
        theirs.push_back(0.5 * (first + second));
        ratios.push_back(ours.back() / theirs.back());
    }
    printBuild(ours, theirs, sample, reduced(parts, medianOf));
    const double ratio = medianOf(ratios);
    std::printf("%.2f x Embree's time, half of the rounds within %.2f to %.2f, all within %.2f to %.2f (at most %.1f wanted)\n",
                ratio, quantile(ratios, 0.25), quantile(ratios, 0.75), leastOf(ratios), *std::ranges::max_element(ratios),
                kMostTimesEmbree);
    std::printf("%llu bytes in %zu cells (at most %.0f wanted)\n", static_cast<unsigned long long>(sample.bytes), sample.cells,
                kMostBytes);
    return ratio <= kMostTimesEmbree && double(sample.bytes) <= kMostBytes ? 0 : 1;
}

int growth(const std::filesystem::path& folder) {
    std::vector<BuildSample> samples;
    for (const size_t faces : kFaces) {
        samples.push_back(sampleOf(*sphereMesh(faces)));
        samples.push_back(sampleOf(*starMesh(7, faces)));
    }
    writeGrowth(folder, samples);
    const bool sphere = linear(samples, "sphere"), star = linear(samples, "star");
    return sphere && star ? 0 : 1;
}

}  // namespace cullscope::benchmark
