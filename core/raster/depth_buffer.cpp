#include "core/raster/depth_buffer.h"

#include <algorithm>
#include <array>

#include "core/raster/in_parallel.h"

namespace cullscope {
namespace {

RasterKernel* kernelOf(RasterSimd simd) {
#ifdef CULLSCOPE_RASTER_AVX
    if (simd == RasterSimd::Avx512) return drawTrianglesAvx512;
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

RasterPicture drawDepthBuffer(const SceneOnRaster& scene, bool parallel, RasterSimd simd) {
    const auto width = size_t(scene.size.width), pixels = width * size_t(scene.size.height);
    RasterPicture result;
    result.picture = std::make_shared<FinishedPicture>();
    FinishedPicture& picture = *result.picture;
    picture.size = scene.size;
    picture.triangle.resize(pixels);
    picture.depth.resize(pixels);
    result.rows.resize(scene.bands());
    result.fates = scene.fates;
    RasterKernel* const kernel = kernelOf(simd);
    const size_t stride = (width + size_t(kLanes) - 1) / size_t(kLanes) * size_t(kLanes);

    forEachOf(scene.bands(), parallel, [&](size_t number) {
        RowCounts& counts = result.rows[number];
        counts.firstRow = int(number) * kBandRows;
        counts.endRow = std::min(counts.firstRow + kBandRows, scene.size.height);
        const size_t first = size_t(counts.firstRow) * width, rows = size_t(counts.endRow - counts.firstRow);
        RasterBand band{&picture.depth[first], &picture.triangle[first], stride,        counts.firstRow,
                        counts.endRow,         scene.size.width,         counts.endRow, result.fates.data()};
        // Rows whose length is no multiple of the lanes are drawn longer than they are, elsewhere; so are bands whose rows are no
        // multiple of four.
        const bool elsewhere = stride != width || rows % 4 != 0;
        const size_t moreRows = (rows + 3) / 4 * 4;
        std::vector<float> depth(elsewhere ? stride * moreRows : 0);
        std::vector<uint32_t> numbers(depth.size());
        if (elsewhere) {
            band.depth = depth.data();
            band.number = numbers.data();
            band.endOfRows = band.firstRow + int(moreRows);
        }
        RasterCounts kernelCounts{};
        for (const TrianglesOnRaster& part : scene.parts) {
            const PartInBand triangles = part.inBand(number);
            counts.triangles += triangles.count;
            if (triangles.count > 0) kernel(triangles, band, kernelCounts);
        }
        counts.samples = counts.comparisons = kernelCounts.comparisons;
        counts.written = kernelCounts.written;
        if (elsewhere)
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
