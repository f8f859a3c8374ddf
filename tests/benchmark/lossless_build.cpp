// The structures of `spherical-lossless`: build time beside Embree's tree of the same mesh, and growth with the number of faces.
#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

#include "core/mesh/parametric.h"
#include "core/spatial/cell_tree.h"
#include "core/spatial/inner_kernel.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"
#include "tests/benchmark/lossless_scenes.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char *kOurs = "spherical-lossless", *kTheirs = "Embree";
constexpr double kLeastTimed = 90'000;
constexpr int kBuilds = 5;
constexpr size_t kBuiltShape = 7;
constexpr double kMostBytes = 14e6;
constexpr double kMostTimesEmbree = 1.5;
constexpr double kBytesTolerance = 0.05;
constexpr double kTimeTolerance = 0.20;

/// What one build took and made. Milliseconds of the parts, none of what is not built for so large a mesh; `all` is the
/// strategy's own build with the bounding sphere, measured separately.
struct Build {
    double all = 0.0, sphere = 0.0, tree = 0.0;
    std::optional<double> closedness, kernel;
    double cells = 0.0, bytes = 0.0;
};

double figure(const StructureReport& report, const std::string& name) {
    return std::ranges::find(report.figures, name, &StructureReport::Figure::name)->value;
}

/// Builds the strategy, and then its parts, each on a mesh without cached properties.
Build build(const TriangleMesh& mesh) {
    Build built;
    const MeshPointer whole = freshCopy(mesh);
    const double sphere = timeOf([&] { static_cast<void>(whole->localSphere()); });
    const ScenePointer scene = sceneOf(whole);
    const test::CullerPointer strategy = lossless(MapLayout::Octahedral, 0, true, "auto");
    built.all = sphere + timeOf([&] { strategy->build(*scene); });
    built.bytes = double(strategy->structure().bytes);
    built.cells = figure(strategy->structure(), "cells");
    const MeshPointer fresh = freshCopy(mesh);
    built.sphere = timeOf([&] { static_cast<void>(fresh->localSphere()); });
    const bool all = fresh->triangleCount() <= kOptionalAnalysisLimit;
    if (all) built.closedness = timeOf([&] { static_cast<void>(fresh->topology()); });
    built.tree = timeOf([&] { const CellTree tree(fresh, {}); });
    if (all) built.kernel = timeOf([&] { const InnerKernel kernel(*fresh); });
    return built;
}

double leastOf(const std::vector<double>& values) { return *std::ranges::min_element(values); }

/// The parts of several builds of one mesh, one time for each.
Row partsOf(const std::vector<Build>& builds, double (*reduce)(const std::vector<double>&)) {
    const auto part = [&](auto which) -> CellValue {
        std::vector<double> values;
        for (const Build& each : builds)
            if (const std::optional<double> value = each.*which) values.push_back(*value);
        return values.empty() ? CellValue() : CellValue(reduce(values));
    };
    return {{"sphere_ms", part(&Build::sphere)},  {"closedness_ms", part(&Build::closedness)},
            {"cell_tree_ms", part(&Build::tree)}, {"kernel_ms", part(&Build::kernel)},
            {"build_ms", part(&Build::all)},      {"cells", builds.front().cells},
            {"bytes", builds.front().bytes}};
}

const std::array<const char*, 5> kTimes{"build_ms", "sphere_ms", "closedness_ms", "cell_tree_ms", "kernel_ms"};

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

// ---- Beside Embree

/// A tree of the same mesh before and after each build, so that the machine's changes meet both.
Rows besideEmbree(const TriangleMesh& mesh, int rounds) {
    const EmbreeTree embree(mesh);
    std::vector<Build> builds;
    const auto buildTree = [&] { return embree.build(); };
    const auto buildOurs = [&] {
        builds.push_back(build(mesh));
        return builds.back().all;
    };
    const std::vector<std::vector<double>> times = inTurns({buildTree, buildOurs, buildTree}, rounds, 1);
    builds.erase(builds.begin());  // of the warm-up
    std::vector<double> theirs;
    for (size_t i = 0; i < times[0].size(); ++i) theirs.push_back(0.5 * (times[0][i] + times[2][i]));
    const double faces = double(mesh.triangleCount());
    Row ours = partsOf(builds, medianOf);
    ours.insert({{"builder", std::string(kOurs)},
                 {"faces", faces},
                 {"best_ms", leastOf(times[1])},
                 {"to_embree", ratioInTurns(times[1], theirs)}});
    const Row other{
        {"builder", std::string(kTheirs)}, {"faces", faces}, {"best_ms", leastOf(theirs)}, {"build_ms", medianOf(theirs)}};
    return {ours, other};
}

// ---- Growth

RowPlot growthPlot(const char* title, const char* unit, std::vector<RowPlot::Column> columns) {
    RowPlot described{logPlot(title, "faces", unit)};
    described.x = "faces";
    described.y = std::move(columns);
    described.lines = {"mesh"};
    return described;
}

/// That a mesh's structures grow at most linearly. Small meshes are excluded from the times, because the kernel's constant cost
/// dominates there, and the largest from the sum, because less is built for it.
std::vector<Check> growthChecks(const std::string& mesh) {
    const RowFilter rows{{"mesh", {mesh}}};
    return {
        exponentCheck(mesh + ": bytes grow with the faces to the power of", {rows, "faces", "bytes"},
                      {1.0 - kBytesTolerance, 1.0 + kBytesTolerance}),
        exponentCheck(mesh + ", 100,000 to 3 million faces: build time grows with the faces to the power of",
                      {rows, "faces", "build_ms", kLeastTimed, double(kOptionalAnalysisLimit)}, {.most = 1.0 + kTimeTolerance}),
        exponentCheck(mesh + ", from 100,000 faces on: the cell tree's time grows with the faces to the power of",
                      {rows, "faces", "cell_tree_ms", kLeastTimed}, {.most = 1.0 + kTimeTolerance})};
}

}  // namespace

Experiment losslessBuild(const std::vector<std::string>& scenes, int rounds) {
    Experiment experiment;
    experiment.id = "spherical-lossless-build";
    experiment.title = "Build time of spherical-lossless beside Embree's tree of the same mesh";
    experiment.notes = {{"%1 threads, %2 rounds in turns; build, sphere, closedness, cell tree and kernel are medians",
                         {std::to_string(tbb::this_task_arena::max_concurrency()), std::to_string(rounds)}}};
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, {scenes.begin(), scenes.end()}},
                       {"builder", "builder", Axis::Kind::InTurns, {std::string(kOurs), std::string(kTheirs)}}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"faces", "faces"});
    experiment.columns.push_back({"best_ms", "best_ms", Origin::Measured, 2});
    for (const char* key : kTimes) experiment.columns.push_back({key, key, Origin::Measured, 2});
    experiment.columns.push_back({"to_embree", "build time / Embree's [95 %]", Origin::Measured, 2});
    for (const char* key : {"cells", "bytes"}) experiment.columns.push_back({key, key});
    RowPlot times{logPlot("Build time of spherical-lossless and of Embree's tree", "faces", "ms")};
    times.x = "faces";
    times.y = {{"build_ms", "median"}, {"best_ms", "best"}};
    times.lines = {"builder"};
    times.byX = true;
    experiment.plots = {times};
    const RowFilter ours{{"builder", {std::string(kOurs)}}};
    experiment.checks = {everyRowCheck("build time over Embree's", ours, "to_embree", {.most = kMostTimesEmbree}),
                         everyRowCheck("bytes", ours, "bytes", {.most = kMostBytes})};
    experiment.measured = [rounds](const Setting& /*setting*/, const ScenePointer& opened, const Progress& /*progress*/) {
        return besideEmbree(*opened->meshes().front(), rounds);
    };
    return experiment;
}

Experiment losslessGrowth() {
    Experiment experiment;
    experiment.id = "spherical-lossless-growth";
    experiment.title = "Bytes and build time of spherical-lossless by faces";
    experiment.notes = {{"The shortest times of several builds, because other programs on the machine only lengthen them.", {}}};
    experiment.axes = {{"mesh", "mesh", Axis::Kind::Label, {std::string("sphere"), std::string("star")}},
                       {"faces", "faces", Axis::Kind::Label, axisValues(kGrowingFaces)}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"cells", "bytes"}) experiment.columns.push_back({key, key});
    experiment.columns.push_back({"bytes_per_face", "bytes_per_face", Origin::Measured, 1});
    for (const char* key : kTimes) experiment.columns.push_back({key, key, Origin::Measured, 2});
    experiment.plots = {
        growthPlot("Bytes of spherical-lossless by faces", "bytes", {{"bytes", "all"}}),
        growthPlot("Build time of spherical-lossless by faces (above five million without closedness and kernel)", "ms",
                   {{"build_ms", "all"},
                    {"cell_tree_ms", "cell tree"},
                    {"closedness_ms", "closedness"},
                    {"kernel_ms", "inner kernel"}})};
    for (const char* mesh : {"sphere", "star"})
        for (Check& check : growthChecks(mesh)) experiment.checks.push_back(std::move(check));
    experiment.measured = [](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        const auto faces = size_t(setting.number("faces"));
        const MeshPointer mesh = setting.words("mesh") == "star" ? starMesh(kBuiltShape, faces) : sphereMesh(faces);
        std::vector<Build> builds;
        for (int i = 0; i < kBuilds; ++i) builds.push_back(build(*mesh));
        Row cells = partsOf(builds, leastOf);
        const double triangles = double(mesh->triangleCount());
        cells.insert({{"faces", triangles}, {"bytes_per_face", builds.front().bytes / triangles}});
        return Rows{cells};
    };
    return experiment;
}

}  // namespace cullscope::benchmark
