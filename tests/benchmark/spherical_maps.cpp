// Builds the three spherical maps with automatic resolution over meshes of 10,000 to 10 million faces.
#include <algorithm>
#include <array>

#include "core/mesh/load.h"
#include "core/mesh/parametric.h"
#include "core/mesh/resample.h"
#include "core/spatial/spherical_maps.h"
#include "tests/benchmark/experiments.h"

namespace cullscope::benchmark {
namespace {

constexpr unsigned kMostResampled = 1'000'000;
constexpr int kMapBuilds = 3;
constexpr double kMapBytesTolerance = 0.05, kMapTimeTolerance = 0.20;
const std::string kSphere = "sphere";

double milliseconds(const SphericalMaps::BuildTimes& times) { return times.centroidMap + times.indexMap + times.accessMap; }

/// The times are those of the build whose sum is the median.
Row cellsOf(const MeshPointer& mesh) {
    std::vector<SphericalMaps::BuildTimes> builds;
    Row cells;
    for (int i = 0; i < kMapBuilds; ++i) {
        const SphericalMaps maps(mesh, SphericalGrid::forTriangles(mesh->triangleCount()));
        const SphericalMaps::Bytes bytes = maps.bytes();
        const double faces = double(mesh->triangleCount());
        cells = {{"faces", faces},
                 {"columns", double(maps.grid().columns())},
                 {"rows", double(maps.grid().rows())},
                 {"centroid_bytes", double(bytes.centroidMap)},
                 {"index_bytes", double(bytes.indexMap)},
                 {"access_bytes", double(bytes.accessMap)},
                 {"bytes", double(bytes.all())},
                 {"bytes_per_face", double(bytes.all()) / faces}};
        builds.push_back(maps.buildTimes());
    }
    std::ranges::sort(builds, {}, milliseconds);
    const SphericalMaps::BuildTimes& median = builds[kMapBuilds / 2];
    cells.insert({{"centroid_ms", median.centroidMap},
                  {"index_ms", median.indexMap},
                  {"access_ms", median.accessMap},
                  {"build_ms", milliseconds(median)}});
    return cells;
}

RowPlot plotOf(const char* title, const char* unit, const std::string& all, const std::string& ending) {
    RowPlot described{logPlot(title, "faces", unit)};
    described.x = "faces";
    described.y = {
        {all, "all"}, {"centroid" + ending, "centroid map"}, {"index" + ending, "index map"}, {"access" + ending, "access map"}};
    described.lines = {"mesh"};
    return described;
}

}  // namespace

Experiment sphericalMapsGrowth(const std::filesystem::path& meshFile) {
    const MeshPointer other = meshFile.empty() ? nullptr : loadMeshFile(meshFile).objects.front().mesh;
    Experiment experiment;
    experiment.id = "spherical-maps";
    experiment.title = "The three spherical maps by faces, resolution on auto";
    Axis meshes{"mesh", "mesh", Axis::Kind::Label, {kSphere}};
    Axis faces{"faces", "faces", Axis::Kind::Label, axisValues(kGrowingFaces)};
    experiment.settings = settingsOf({meshes, faces});
    if (other) {
        const std::string name = meshFile.stem().string();
        for (Setting& setting : settingsOf({{"mesh", "", Axis::Kind::Label, {name}}, faces}))
            if (setting.number("faces") <= kMostResampled) experiment.settings.push_back(std::move(setting));
        meshes.values.emplace_back(name);
    }
    experiment.axes = {meshes, faces};
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"columns", "rows", "centroid_bytes", "index_bytes", "access_bytes", "bytes"})
        experiment.columns.push_back({key, key});
    for (const char* key : {"bytes_per_face", "centroid_ms", "index_ms", "access_ms", "build_ms"})
        experiment.columns.push_back({key, key, ResultColumn::Origin::Measured, 2});
    experiment.plots = {plotOf("Bytes of the three maps by faces, resolution on auto", "bytes", "bytes", "_bytes"),
                        plotOf("Build time of the three maps by faces, resolution on auto", "ms", "build_ms", "_ms")};
    for (const CellValue& value : meshes.values) {
        const auto& mesh = std::get<std::string>(value);
        experiment.checks.push_back(exponentCheck(mesh + ": bytes grow with the faces to the power of",
                                                  {{{"mesh", {mesh}}}, "faces", "bytes"},
                                                  {1.0 - kMapBytesTolerance, 1.0 + kMapBytesTolerance}));
        experiment.checks.push_back(exponentCheck(mesh + ": build time grows with the faces to the power of",
                                                  {{{"mesh", {mesh}}}, "faces", "build_ms"},
                                                  {1.0 - kMapTimeTolerance, 1.0 + kMapTimeTolerance}));
    }
    experiment.measured = [other](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        const auto count = size_t(setting.number("faces"));
        return Rows{cellsOf(setting.words("mesh") == kSphere ? sphereMesh(count) : resampled(*other, count))};
    };
    return experiment;
}

}  // namespace cullscope::benchmark
