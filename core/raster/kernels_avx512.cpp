// GCC's header leaves what a mask of ones replaces without a value.
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

#include "core/raster/depth_buffer_kernel.h"
#include "core/raster/occlusion_kernel.h"
#include "core/raster/occlusion_setup_kernel.h"
#include "core/raster/projection_kernel.h"
#include "core/raster/shading_kernel.h"

namespace cullscope {
namespace {

struct Avx512Lanes {
    /// A bit of each element of a comparison's result.
    static uint32_t bitsOf(const Ints& mask) { return uint32_t(_mm256_movemask_ps(reinterpret_cast<const __m256&>(mask))); }
    /// How many elements of a comparison's results hold.
    static uint32_t countOf(const Ints (&masks)[2]) {
        return uint32_t(__builtin_popcount(bitsOf(masks[0]) | bitsOf(masks[1]) << kLanes));
    }
    static Ints rounded(const Floats& values) { return reinterpret_cast<Ints>(_mm256_cvtps_epi32(values)); }
    /// a · b + c, rounded once.
    static Floats fused(const Floats& a, const Floats& b, const Floats& c) { return _mm256_fmadd_ps(a, b, c); }
    static Floats root(const Floats& values) { return _mm256_sqrt_ps(values); }
    /// As drawSmallByHalves, a tile in one register.
    static void drawSmall(const Batch& batch, size_t i, const RasterBand& band, RasterCounts& counts) {
        const __m512i columnOf = _mm512_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
        const __m512i rowOf = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
        const auto all = [](int32_t value) { return _mm512_set1_epi32(value); };
        const auto allFloats = [](float value) { return _mm512_set1_ps(value); };
        const int32_t firstColumn = batch.column[i], endColumn = batch.endColumn[i], endRow = batch.endRow[i];
        const __m512i number = all(int32_t(batch.number[i]));
        __m512i perColumn[3], perRow[3], ofRow[3];
        for (int e = 0; e < 3; ++e) {
            perColumn[e] = all(batch.perColumn[e][i]);
            perRow[e] = all(batch.perRow[e][i]);
            ofRow[e] = _mm512_add_epi32(
                _mm512_add_epi32(_mm512_mullo_epi32(columnOf, perColumn[e]), _mm512_mullo_epi32(rowOf, perRow[e])),
                all(batch.edge[e][i]));
        }
        uint32_t any = 0, comparisons = 0, written = 0;
        for (int32_t row = batch.row[i]; row < endRow; row += kTile) {
            RasterTile* const tiles = band.tiles + size_t((row - band.firstRow) / kTile) * band.tilesInRow;
            __m512i edge[3] = {ofRow[0], ofRow[1], ofRow[2]};
            for (int32_t column = firstColumn; column < endColumn; column += kTile) {
                auto covered = __mmask16(~_mm512_movepi32_mask(_mm512_or_si512(_mm512_or_si512(edge[0], edge[1]), edge[2])));
                for (int e = 0; e < 3; ++e) edge[e] = _mm512_add_epi32(edge[e], _mm512_slli_epi32(perColumn[e], 2));
                if (reachesBeyond(band, column, row))
                    covered &= __mmask16(_mm512_cmplt_epi32_mask(columnOf, all(band.width - column)) &
                                         _mm512_cmplt_epi32_mask(rowOf, all(band.endRow - row)));
                const __m512 along = _mm512_fmadd_ps(allFloats(batch.depthPerColumn[i]),
                                                     _mm512_add_ps(_mm512_cvtepi32_ps(columnOf), allFloats(float(column))),
                                                     allFloats(batch.depth[i]));
                const __m512 unlimited = _mm512_fmadd_ps(allFloats(batch.depthPerRow[i]),
                                                         _mm512_add_ps(_mm512_cvtepi32_ps(rowOf), allFloats(float(row))), along);
                // What is no number stays none.
                const __m512 depth = _mm512_min_ps(allFloats(1.0f), unlimited);
                // Which tiles a triangle covers, and where it is nearer, is chance: nothing branches on it.
                RasterTile& tile = tiles[column / kTile];
                const __m512 before = _mm512_load_ps(tile.depth);
                const __mmask16 pass = _mm512_mask_cmp_ps_mask(covered, depth, before, _CMP_GT_OQ);
                any |= covered;
                comparisons += uint32_t(__builtin_popcount(covered));
                written += uint32_t(__builtin_popcount(pass));
                _mm512_store_ps(tile.depth, _mm512_mask_blend_ps(pass, before, depth));
                _mm512_store_si512(tile.number, _mm512_mask_blend_epi32(pass, _mm512_load_si512(tile.number), number));
            }
            for (int e = 0; e < 3; ++e) ofRow[e] = _mm512_add_epi32(ofRow[e], _mm512_slli_epi32(perRow[e], 2));
        }
        counts.comparisons += comparisons;
        counts.written += written;
        if (any != 0) sayCovers(band, batch.number[i]);
    }
};

}  // namespace

void drawTrianglesAvx512(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<Avx512Lanes>(part, band, counts);
}

void placeAvx512(const RasterPlacing& placing, uint32_t* places) { placeTriangles<Avx512Lanes>(placing, places); }

void projectAvx512(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    project<Avx512Lanes>(projection, positions, count, vertices);
}

void shadeAvx512(const Shading& shading, const ShadedBlock& block) { shadeBlock<Avx512Lanes>(shading, block); }

void markShownAvx512(const uint32_t* items, size_t count, uint8_t* fates) { markShownItems<Avx512Lanes>(items, count, fates); }

size_t setUpOccludersAvx512(const OccluderSetup& setup, OccluderTriangle* triangles) {
    return setUpOccluders<Avx512Lanes>(setup, triangles);
}

void drawOccludersAvx512(const OccluderTriangle* triangles, size_t count, const OcclusionTiles& tiles) {
    drawAllOccluders(triangles, count, tiles);
}

}  // namespace cullscope
