#include "core/raster/depth_buffer.h"

#include <algorithm>
#include <array>

#include "core/raster/in_parallel.h"

namespace cullscope {
namespace {

RasterKernel* kernelOf(RasterSimd simd) {
#ifdef CULLSCOPE_RASTER_AVX
    if (simd == RasterSimd::Avx2) return drawTrianglesAvx2;
#endif
    return simd == RasterSimd::Portable ? drawTrianglesPortable : nullptr;
}

}  // namespace

RowCounts RasterPicture::total() const {
    RowCounts sum;
    for (const RowCounts& row : rows) {
        sum.endRow = std::max(sum.endRow, row.endRow);
        sum.triangles += row.triangles;
        sum.samples += row.samples;
        sum.comparisons += row.comparisons;
        sum.crossings += row.crossings;
        sum.spans += row.spans;
        sum.written += row.written;
        sum.covered += row.covered;
    }
    return sum;
}

std::span<const RasterSimd> availableRasterSimd() {
    static constexpr std::array kAll{RasterSimd::Portable, RasterSimd::Avx2};
#ifdef CULLSCOPE_RASTER_AVX
    static const bool kAvx2 = __builtin_cpu_supports("avx2") != 0;
    if (kAvx2) return kAll;
#endif
    return std::span(kAll).first(1);
}

RasterPicture drawDepthBuffer(const SceneOnRaster& scene, bool parallel, RasterSimd simd) {
    const auto width = size_t(scene.size.width), pixels = width * size_t(scene.size.height);
    const RasterBins bins(scene, kBandRows, parallel);
    RasterPicture result;
    result.picture = std::make_shared<FinishedPicture>();
    FinishedPicture& picture = *result.picture;
    picture.size = scene.size;
    picture.triangle.resize(pixels);
    picture.depth.resize(pixels);
    result.rows.resize(bins.bands());
    RasterKernel* const kernel = kernelOf(simd);
    const size_t stride = (width + size_t(kLanes) - 1) / size_t(kLanes) * size_t(kLanes);

    forEachOf(bins.bands(), parallel, [&](size_t number) {
        RowCounts& counts = result.rows[number];
        counts.firstRow = int(number) * kBandRows;
        counts.endRow = std::min(counts.firstRow + kBandRows, scene.size.height);
        const std::span triangles = bins.band(number);
        counts.triangles = triangles.size();
        const size_t first = size_t(counts.firstRow) * width, rows = size_t(counts.endRow - counts.firstRow);
        RasterBand band{&picture.depth[first], &picture.triangle[first], stride, counts.firstRow, counts.endRow};
        // Rows whose length is no multiple of the lanes are drawn longer than they are, elsewhere.
        std::vector<float> depth;
        std::vector<uint32_t> numbers;
        if (stride != width) {
            depth.resize(stride * rows);
            numbers.resize(stride * rows);
            band.depth = depth.data();
            band.number = numbers.data();
        }
        RasterCounts kernelCounts{};
        kernel(triangles.data(), triangles.size(), band, kernelCounts);
        counts.samples = counts.comparisons = kernelCounts.comparisons;
        counts.written = kernelCounts.written;
        if (stride != width)
            for (size_t row = 0; row < rows; ++row) {
                std::copy_n(&depth[row * stride], width, &picture.depth[first + row * width]);
                std::copy_n(&numbers[row * stride], width, &picture.triangle[first + row * width]);
            }
        const auto begin = picture.triangle.begin() + std::ptrdiff_t(first);
        counts.covered = rows * width - uint64_t(std::count(begin, begin + std::ptrdiff_t(rows * width), 0u));
    });
    return result;
}

}  // namespace cullscope
