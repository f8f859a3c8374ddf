#include "core/raster/depth_buffer.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/raster/in_parallel.h"
#include "core/raster/kernel_choice.h"
#include "core/raster/triangle_setup.h"

namespace cullscope {
namespace {

/// Copies a band's rows to the picture; how many of its pixels show a surface.
uint64_t copyRows(const RasterBand& band, FinishedPicture& picture) {
    const auto width = size_t(band.width);
    uint64_t covered = 0;
    for (int32_t row = band.firstRow; row < band.endRow; ++row) {
        const RasterTile* tile = band.tiles + size_t((row - band.firstRow) / kTile) * band.tilesInRow;
        const size_t inTile = size_t(row % kTile) * kTile;
        float* depth = &picture.depth[size_t(row) * width];
        uint32_t* number = &picture.triangle[size_t(row) * width];
        uint32_t ofRow = 0;
        size_t column = 0;
        for (; column + kTile <= width; column += kTile, ++tile) {
            std::memcpy(depth + column, tile->depth + inTile, kTile * sizeof(float));
            std::memcpy(number + column, tile->number + inTile, kTile * sizeof(uint32_t));
            for (size_t i = 0; i < kTile; ++i) ofRow += tile->number[inTile + i] != 0 ? 1 : 0;
        }
        for (size_t i = 0; column + i < width; ++i) {
            depth[column + i] = tile->depth[inTile + i];
            number[column + i] = tile->number[inTile + i];
            ofRow += tile->number[inTile + i] != 0 ? 1 : 0;
        }
        covered += ofRow;
    }
    return covered;
}

}  // namespace

RowCounts RasterPicture::total() const {
    RowCounts sum;
    for (const RowCounts& row : rows) {
        sum.endRow = std::max(sum.endRow, row.endRow);
        sum.triangles += row.triangles;
        sum.samples += row.samples;
        sum.comparisons += row.comparisons;
        sum.edges += row.edges;
        sum.crossings += row.crossings;
        sum.spans += row.spans;
        sum.written += row.written;
        sum.covered += row.covered;
    }
    return sum;
}

RasterPicture drawDepthBuffer(const SceneOnRaster& scene, bool parallel, RasterSimd simd, const Progress& progress) {
    const auto width = size_t(scene.size.width), pixels = width * size_t(scene.size.height);
    RasterPicture result;
    result.picture = std::make_shared<FinishedPicture>();
    FinishedPicture& picture = *result.picture;
    picture.size = scene.size;
    picture.triangle.resize(pixels);
    picture.depth.resize(pixels);
    result.rows.resize(scene.bands());
    result.fates = scene.fates;
    RasterKernel* const kernel = kernelFor<RasterKernel>(simd, CULLSCOPE_VARIANTS(drawTriangles));
    result.bytes = (width + kTile - 1) / kTile * size_t(kBandRows / kTile) * sizeof(RasterTile);

    forEachOf(scene.bands(), parallel, [&](size_t number) {
        RowCounts& counts = result.rows[number];
        counts.firstRow = int(number) * kBandRows;
        counts.endRow = std::min(counts.firstRow + kBandRows, scene.size.height);
        const size_t tilesInRow = (width + kTile - 1) / kTile;
        const auto tileRows = size_t(counts.endRow - counts.firstRow + kTile - 1) / kTile;
        std::vector<RasterTile> tiles(tilesInRow * tileRows);
        const RasterBand band{tiles.data(), tilesInRow, counts.firstRow, counts.endRow, scene.size.width, result.fates.data()};
        RasterCounts kernelCounts{};
        for (const TrianglesOnRaster& part : scene.parts) {
            progress.check();
            const PartInBand triangles = part.inBand(number);
            counts.triangles += triangles.count;
            if (triangles.count > 0) kernel(triangles, band, kernelCounts);
        }
        counts.samples = counts.comparisons = kernelCounts.comparisons;
        counts.written = kernelCounts.written;
        counts.covered = copyRows(band, picture);
    });
    return result;
}

std::optional<FollowedPicture> followDepthBuffer(const SceneOnRaster& scene, const Progress& progress) {
    FollowedPicture result;
    RasterPicture& drawn = result.drawn;
    drawn.rows.resize(scene.bands());
    std::vector<ScreenTriangle> triangles;
    uint64_t inBoxes = 0;
    for (size_t band = 0; band < scene.bands(); ++band) {
        RowCounts& counts = drawn.rows[band];
        counts.firstRow = int(band) * kBandRows;
        counts.endRow = std::min(counts.firstRow + kBandRows, scene.size.height);
        for (const ScreenTriangle& triangle : scene.trianglesIn(band)) {
            ++counts.triangles;
            if (size_t(triangle.firstRow / kBandRows) != band) continue;  // it begins in a band before
            inBoxes += uint64_t(triangle.endColumn - triangle.firstColumn) * uint64_t(triangle.endRow - triangle.firstRow);
            if (inBoxes > kMostFollowed) return std::nullopt;
            triangles.push_back(triangle);
        }
    }
    std::ranges::stable_sort(triangles, {}, &ScreenTriangle::number);
    const size_t pixels = size_t(scene.size.width) * size_t(scene.size.height);
    drawn.picture = std::make_shared<FinishedPicture>();
    FinishedPicture& picture = *drawn.picture;
    picture.size = scene.size;
    picture.triangle.assign(pixels, 0);
    picture.depth.assign(pixels, 0.0f);
    drawn.fates = scene.fates;
    drawn.bytes = triangles.capacity() * sizeof(ScreenTriangle);
    for (const ScreenTriangle& triangle : triangles) {
        progress.check();
        // The pieces of a clipped triangle follow each other.
        const bool another = result.triangles.empty() || result.triangles.back().triangle != triangle.number - 1;
        if (another) result.triangles.emplace_back().triangle = triangle.number - 1;
        FollowedTriangle& of = result.triangles.back();
        for (int row = triangle.firstRow; row < triangle.endRow; ++row) {
            RowCounts& counts = drawn.rows[size_t(row / kBandRows)];
            for (int column = triangle.firstColumn; column < triangle.endColumn; ++column) {
                if (!coversCentre(triangle, column, row)) continue;
                const size_t pixel = size_t(row) * size_t(scene.size.width) + size_t(column);
                const float before = picture.depth[pixel], depth = depthOf(triangle, column, row);
                const bool nearer = depth > before;
                ++counts.comparisons;
                if (of.samples++ == 0 || (nearer && of.written == 0)) {
                    of.column = column;
                    of.row = row;
                    of.depth = depth;
                    of.stored = before;
                }
                if (!nearer) continue;
                ++of.written;
                ++counts.written;
                of.first += before == 0.0f ? 1 : 0;
                counts.covered += picture.triangle[pixel] == 0 ? 1 : 0;
                picture.depth[pixel] = depth;
                picture.triangle[pixel] = triangle.number;
            }
        }
        if (of.samples == 0)
            result.triangles.pop_back();
        else
            drawn.fates[of.triangle] = kCovers;
    }
    for (RowCounts& counts : drawn.rows) counts.samples = counts.comparisons;
    return result;
}

}  // namespace cullscope
