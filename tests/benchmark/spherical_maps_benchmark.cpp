// Builds the three spherical maps (Han & Hong 2008, Table 1) with automatic resolution over meshes of 10,000 to 10 million faces,
// writes the bytes and milliseconds of each to maps.csv and maps.svg in a folder, and fits a power of the number of faces to
// them. Exit status 1 where bytes or build time do not grow linearly.
//
//   spherical_maps_benchmark FOLDER [MESH]     MESH: resampled to the same counts up to a million, beside spheres
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/image/line_plot.h"
#include "core/mesh/load.h"
#include "core/mesh/parametric.h"
#include "core/mesh/resample.h"
#include "core/spatial/spherical_maps.h"

namespace {

using namespace cullscope;

constexpr std::array kFaces{10'000u, 30'000u, 100'000u, 300'000u, 1'000'000u, 3'000'000u, 10'000'000u};
constexpr size_t kMostResampled = 1'000'000;
constexpr int kBuilds = 3;
constexpr double kBytesTolerance = 0.05;
constexpr double kTimeTolerance = 0.20;

/// The maps of one mesh; the times are medians of the sum over all maps.
struct Sample {
    size_t faces = 0;
    uint32_t columns = 0, rows = 0;
    SphericalMaps::Bytes bytes;
    SphericalMaps::BuildTimes times;

    [[nodiscard]] double milliseconds() const { return times.centroidMap + times.indexMap + times.accessMap; }
};

struct Series {
    std::string mesh;
    std::vector<Sample> samples;
};

Sample sampleOf(const MeshPointer& mesh) {
    std::vector<Sample> builds;
    for (int i = 0; i < kBuilds; ++i) {
        const SphericalMaps maps(mesh, SphericalGrid::forTriangles(mesh->triangleCount()));
        builds.push_back({mesh->triangleCount(), maps.grid().columns(), maps.grid().rows(), maps.bytes(), maps.buildTimes()});
    }
    std::ranges::sort(builds, {}, &Sample::milliseconds);
    return builds[kBuilds / 2];
}

void print(const std::string& mesh, const Sample& sample) {
    const double faces = double(sample.faces);
    std::printf(
        "%-8s %9zu faces, %5u x %4u cells: %11llu bytes (%.1f a face: centroid %.1f, index %.1f, access %.1f), "
        "%.1f ms (%.1f, %.1f, %.1f)\n",
        mesh.c_str(), sample.faces, sample.columns, sample.rows, static_cast<unsigned long long>(sample.bytes.all()),
        double(sample.bytes.all()) / faces, double(sample.bytes.centroidMap) / faces, double(sample.bytes.indexMap) / faces,
        double(sample.bytes.accessMap) / faces, sample.milliseconds(), sample.times.centroidMap, sample.times.indexMap,
        sample.times.accessMap);
    std::fflush(stdout);
}

Series spheres() {
    Series series{"sphere", {}};
    for (const size_t faces : kFaces) {
        series.samples.push_back(sampleOf(sphereMesh(faces)));
        print(series.mesh, series.samples.back());
    }
    return series;
}

Series resampledMesh(const std::filesystem::path& file) {
    const MeshPointer mesh = loadMeshFile(file).objects.front().mesh;
    Series series{file.stem().string(), {}};
    for (const size_t faces : kFaces) {
        if (faces > kMostResampled) break;
        series.samples.push_back(sampleOf(resampled(*mesh, faces)));
        print(series.mesh, series.samples.back());
    }
    return series;
}

std::vector<PlotPoint> points(const Series& series, double (*value)(const Sample&)) {
    std::vector<PlotPoint> points;
    for (const Sample& sample : series.samples) points.push_back({double(sample.faces), value(sample)});
    return points;
}

double bytesOf(const Sample& sample) { return double(sample.bytes.all()); }
double millisecondsOf(const Sample& sample) { return sample.milliseconds(); }

void writeCsv(const std::filesystem::path& file, const std::vector<Series>& all) {
    writeFileAtomically(file, [&](std::ostream& out) {
        out << "mesh,faces,columns,rows,centroid_bytes,index_bytes,access_bytes,bytes_per_face,centroid_ms,index_ms,access_ms\n";
        for (const Series& series : all)
            for (const Sample& s : series.samples)
                out << series.mesh << ',' << s.faces << ',' << s.columns << ',' << s.rows << ',' << s.bytes.centroidMap << ','
                    << s.bytes.indexMap << ',' << s.bytes.accessMap << ',' << double(s.bytes.all()) / double(s.faces) << ','
                    << s.times.centroidMap << ',' << s.times.indexMap << ',' << s.times.accessMap << '\n';
    });
}

void writePlots(const std::filesystem::path& file, const std::vector<Series>& all) {
    LinePlot bytes = logPlot("Bytes of the three maps by faces, resolution on auto", "faces", "bytes");
    LinePlot times = logPlot("Build time of the three maps by faces, resolution on auto", "faces", "ms");
    const auto add = [](LinePlot& plot, const Series& series, const std::string& name, double (*value)(const Sample&)) {
        plot.lines.push_back({series.mesh + ": " + name, points(series, value)});
    };
    for (const Series& series : all) {
        add(bytes, series, "all", bytesOf);
        add(bytes, series, "centroid map", [](const Sample& s) { return double(s.bytes.centroidMap); });
        add(bytes, series, "index map", [](const Sample& s) { return double(s.bytes.indexMap); });
        add(bytes, series, "access map", [](const Sample& s) { return double(s.bytes.accessMap); });
        add(times, series, "all", millisecondsOf);
        add(times, series, "centroid map", [](const Sample& s) { return s.times.centroidMap; });
        add(times, series, "index map", [](const Sample& s) { return s.times.indexMap; });
        add(times, series, "access map", [](const Sample& s) { return s.times.accessMap; });
    }
    writeFileAtomically(file, [&](std::ostream& out) { out << linePlotsSvg({bytes, times}); });
}

/// Whether bytes and build time grow linearly; prints the result.
bool linear(const Series& series) {
    const double bytes = exponentOf(points(series, bytesOf)), time = exponentOf(points(series, millisecondsOf));
    std::printf("%s: bytes grow with faces^%.3f, build time with faces^%.3f\n", series.mesh.c_str(), bytes, time);
    return std::abs(bytes - 1.0) <= kBytesTolerance && std::abs(time - 1.0) <= kTimeTolerance;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2 || argc > 3) {
        std::fprintf(stderr, "spherical_maps_benchmark FOLDER [MESH]\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    std::vector<Series> all{spheres()};
    if (argc == 3) all.push_back(resampledMesh(argv[2]));
    writeCsv(folder / "maps.csv", all);
    writePlots(folder / "maps.svg", all);
    return std::ranges::all_of(all, linear) ? 0 : 1;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
