// Passes of several variants in turns, and the hierarchy as one of them.
#include <ctime>

#include "tests/benchmark/frustum_benchmark.h"
#include "tests/benchmark/lossless_benchmark.h"

namespace cullscope::benchmark {
namespace {

/// A time is measured over as many passes as take at least this long.
constexpr double kLeastMilliseconds = 1.0;
constexpr int kRounds = 15, kRoundsOfMany = 7;
constexpr size_t kMany = 2'000'000;

/// The time of this process only: on a busy machine, a slow variant would be interrupted more often than a fast one.
double processorTime(const std::function<void()>& pass, size_t passes) {
    const std::clock_t start = std::clock();
    for (size_t i = 0; i < passes; ++i) pass();
    return double(std::clock() - start) * 1000.0 / CLOCKS_PER_SEC / double(passes);
}

/// The number of passes that take kLeastMilliseconds.
size_t passesOf(const std::function<void()>& pass) {
    size_t passes = 1;
    pass();
    while (processorTime(pass, passes) * double(passes) < kLeastMilliseconds) passes *= 2;
    return passes;
}

MeshPointer meshOf(std::vector<Vec3f> positions, std::vector<uint32_t> indices) {
    TriangleMesh::Data data;
    data.positions = std::move(positions);
    data.indices = std::move(indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// A triangle from corner to corner of the cube [-1, 1]³, which is its box.
MeshPointer cubeSpanningTriangle() { return meshOf({{-1, -1, -1}, {1, 1, 1}, {-1, 1, 1}}, {0, 1, 2}); }

/// Two triangles between the six points of the unit sphere on the axes: the sphere is their bounding sphere, the cube [-1, 1]³
/// their box.
MeshPointer sphereSpanningTriangles() {
    return meshOf({{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3, 4, 5});
}

Instance placed(const Vec3& centre, const Vec3& half) {
    Mat4 transform(1.0);
    for (int axis = 0; axis < 3; ++axis) transform[axis][axis] = half[axis];
    transform[3] = Vec4(centre, 1.0);
    return {0, transform, {}};
}

ScenePointer sceneOf(const std::vector<Box3>& boxes) {
    std::vector<Instance> instances;
    instances.reserve(boxes.size());
    for (const Box3& box : boxes) instances.push_back(placed(box.centre(), box.halfExtent()));
    return std::make_shared<Scene>("boxes", std::vector<MeshPointer>{cubeSpanningTriangle()}, std::move(instances));
}

ScenePointer sceneOf(const std::vector<Sphere>& spheres) {
    std::vector<Instance> instances;
    instances.reserve(spheres.size());
    for (const Sphere& sphere : spheres) instances.push_back(placed(sphere.centre, Vec3(sphere.radius)));
    return std::make_shared<Scene>("spheres", std::vector<MeshPointer>{sphereSpanningTriangles()}, std::move(instances));
}

std::vector<double> ratios(const std::vector<double>& upper, const std::vector<double>& lower) {
    std::vector<double> ratios;
    for (size_t i = 0; i < upper.size(); ++i) ratios.push_back(upper[i] / lower[i]);
    return ratios;
}

double medianRatio(const std::vector<Variant>& variants, const std::vector<std::vector<double>>& times, const std::string& name,
                   size_t of, bool inverse) {
    for (size_t i = 0; i < variants.size(); ++i)
        if (variants[i].name == name) return medianOf(inverse ? ratios(times[i], times[of]) : ratios(times[of], times[i]));
    return 0.0;
}

}  // namespace

std::vector<FrustumSample> inTurns(const std::vector<Variant>& variants, size_t objects) {
    std::vector<std::vector<double>> times(variants.size());
    std::vector<FrustumSample> samples(variants.size());
    std::vector<size_t> passes;
    for (size_t i = 0; i < variants.size(); ++i) {
        passes.push_back(passesOf(variants[i].pass));
        samples[i].kept = variants[i].kept();
    }
    for (int round = 0; round < (objects < kMany ? kRounds : kRoundsOfMany); ++round)
        for (size_t i = 0; i < variants.size(); ++i) {
            // Loads this variant's arrays into the cache, which the variant before has filled with its own.
            if (objects < kMany) variants[i].pass();
            times[i].push_back(processorTime(variants[i].pass, passes[i]));
        }
    for (size_t i = 0; i < variants.size(); ++i) {
        samples[i].variant = variants[i].name;
        samples[i].objects = objects;
        samples[i].milliseconds = medianOf(times[i]);
        samples[i].toNaive = medianRatio(variants, times, kNaive, i, true);
        samples[i].toRead = medianRatio(variants, times, kRead, i, false);
    }
    return samples;
}

Hierarchy::Hierarchy(ScenePointer scene)
    : m_scene(std::move(scene)), m_octree(*m_scene), m_memory(m_octree.nodes().size(), m_scene->instances().size()) {}

Hierarchy::Hierarchy(const std::vector<Box3>& boxes) : Hierarchy(sceneOf(boxes)) {}

Hierarchy::Hierarchy(const std::vector<Sphere>& spheres) : Hierarchy(sceneOf(spheres)) {}

size_t Hierarchy::kept(const View& view) {
    FrameContext frame(*m_scene, view, false);
    return keptObjects(m_octree, frame, nullptr, {true, &m_memory}).size();
}

}  // namespace cullscope::benchmark
