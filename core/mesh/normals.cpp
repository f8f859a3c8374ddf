#include "core/mesh/normals.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include "core/mesh/steps.h"

namespace cullscope {
namespace {

constexpr size_t kParallelFrom = 100'000;  ///< triangles; with fewer, starting threads costs more time than it saves

/// A scale that brings the largest coordinate to 1, so that squares and products neither overflow nor underflow.
double scaleToOne(std::span<const Vec3f> positions) {
    float largest = 0.0F;
    for (const Vec3f& position : positions)
        largest = std::max({largest, std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    return largest > 0.0F ? 1.0 / static_cast<double>(largest) : 1.0;
}

/// Sums the triangles' normals at the vertices in [first, last), in the order of the triangles.
void sumNormals(std::span<const Vec3f> positions, std::span<const uint32_t> indices, double scale, size_t first, size_t last,
                std::span<Vec3f> normals, const Progress& progress) {
    const auto mine = [&](uint32_t vertex) { return vertex - first < last - first; };
    constexpr size_t kStep = size_t{1} << 17;
    for (size_t begin = 0; begin < indices.size() / 3 && !progress.stopRequested(); begin += kStep) {
        const size_t end = std::min(indices.size() / 3, begin + kStep);
        for (const uint32_t* corner = indices.data() + 3 * begin; corner != indices.data() + 3 * end; corner += 3) {
            if (!mine(corner[0]) && !mine(corner[1]) && !mine(corner[2])) continue;
            const Vec3 a(positions[corner[0]]);
            const Vec3f normal(glm::cross((Vec3(positions[corner[1]]) - a) * scale, (Vec3(positions[corner[2]]) - a) * scale));
            for (int i = 0; i < 3; ++i)
                if (mine(corner[i])) normals[corner[i]] += normal;
        }
    }
    for (size_t vertex = first; vertex < last; ++vertex) {
        if (vertex % kStep == 0 && progress.stopRequested()) return;
        const Vec3 sum(normals[vertex]);
        const double length = glm::length(sum);
        normals[vertex] = length > 0.0 && std::isfinite(length) ? Vec3f(sum / length) : Vec3f(0.0F, 0.0F, 1.0F);
    }
}

}  // namespace

std::vector<Vec3f> areaWeightedNormals(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                       const Progress& progress) {
    std::vector<Vec3f> normals(positions.size(), Vec3f(0.0F));
    const double scale = scaleToOne(positions);
    // Every thread reads all triangles and sums only for its own vertices: no locks, and the same order of summation for any
    // number of threads.
    const size_t threads = indices.size() / 3 < kParallelFrom ? 1 : static_cast<size_t>(tbb::info::default_concurrency());
    const auto part = [&](size_t thread) {
        sumNormals(positions, indices, scale, positions.size() * thread / threads, positions.size() * (thread + 1) / threads,
                   normals, progress);
    };
    if (threads == 1)
        part(0);
    else
        tbb::parallel_for(size_t{0}, threads, part);
    progress.check();
    return normals;
}

}  // namespace cullscope
