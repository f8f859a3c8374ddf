// GCC's header leaves what a mask of ones replaces without a value.
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

#include "core/raster/depth_buffer_kernel.h"

namespace cullscope {
namespace {

struct Avx512Lanes {
    /// Whether no element of a comparison's result holds.
    static bool none(const Ints& mask) {
        const __m256i bits = reinterpret_cast<const __m256i&>(mask);
        return _mm256_testz_si256(bits, bits) != 0;
    }
    /// A block of a small triangle at once: four rows of four columns.
    static void drawBlock(const Batch& batch, size_t i, const BlockPlace& block, const RasterBand& band,
                          PixelCounters& counters) {
        const __m512i columnOf = _mm512_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
        const __m512i rowOf = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
        const auto all = [](int32_t value) { return _mm512_set1_epi32(value); };
        const __m512i columns = _mm512_add_epi32(columnOf, all(block.right)), rows = _mm512_add_epi32(rowOf, all(block.up));
        const auto edge = [&](int e) {
            const __m512i sum = _mm512_add_epi32(_mm512_mullo_epi32(columns, all(batch.perColumn[e][i])),
                                                 _mm512_mullo_epi32(rows, all(batch.perRow[e][i])));
            return _mm512_add_epi32(sum, all(batch.edge[e][i]));
        };
        // Below 0 beyond the box's last column or row, as an edge function.
        const __m512i left = _mm512_or_si512(_mm512_sub_epi32(all(batch.endColumn[i] - block.column - 1), columnOf),
                                             _mm512_sub_epi32(all(batch.endRow[i] - block.row - 1), rowOf));
        const __m512i signs = _mm512_or_si512(_mm512_or_si512(edge(0), edge(1)), _mm512_or_si512(edge(2), left));
        const auto covered = __mmask16(~_mm512_movepi32_mask(signs));
        if (covered == 0) return;
        sayCovers(band, batch.number[i]);
        const __m512d steps = _mm512_setr_pd(0, 1, 2, 3, 0, 1, 2, 3);
        const auto allDoubles = [](double value) { return _mm512_set1_pd(value); };
        const __m512d along = _mm512_mul_pd(allDoubles(batch.depthPerColumn[i]),
                                            _mm512_add_pd(steps, allDoubles(batch.fromColumn[i] + block.right)));
        const __m512d rowDepths = _mm512_add_pd(
            allDoubles(batch.depth[i]),
            _mm512_mul_pd(allDoubles(batch.depthPerRow[i]), _mm512_add_pd(steps, allDoubles(batch.fromRow[i] + block.up))));
        const __m512i lowRows = _mm512_setr_epi64(0, 0, 0, 0, 1, 1, 1, 1), highRows = _mm512_setr_epi64(2, 2, 2, 2, 3, 3, 3, 3);
        const __m256 low = _mm512_cvtpd_ps(_mm512_add_pd(_mm512_permutexvar_pd(lowRows, rowDepths), along));
        const __m256 high = _mm512_cvtpd_ps(_mm512_add_pd(_mm512_permutexvar_pd(highRows, rowDepths), along));
        const __m512 depth = _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
        float* depthAt[4];
        uint32_t* numberAt[4];
        for (size_t row = 0; row < 4; ++row) {
            depthAt[row] = band.depth + block.at + row * band.stride;
            numberAt[row] = band.number + block.at + row * band.stride;
        }
        __m512 before = _mm512_castps128_ps512(_mm_loadu_ps(depthAt[0]));
        before = _mm512_insertf32x4(before, _mm_loadu_ps(depthAt[1]), 1);
        before = _mm512_insertf32x4(before, _mm_loadu_ps(depthAt[2]), 2);
        before = _mm512_insertf32x4(before, _mm_loadu_ps(depthAt[3]), 3);
        const __mmask16 pass = _mm512_mask_cmp_ps_mask(covered, depth, before, _CMP_GT_OQ);
        counters.blockComparisons += uint32_t(__builtin_popcount(covered));
        counters.blockWritten += uint32_t(__builtin_popcount(pass));
        const __m512 after = _mm512_mask_blend_ps(pass, before, depth);
        _mm_storeu_ps(depthAt[0], _mm512_castps512_ps128(after));
        _mm_storeu_ps(depthAt[1], _mm512_extractf32x4_ps(after, 1));
        _mm_storeu_ps(depthAt[2], _mm512_extractf32x4_ps(after, 2));
        _mm_storeu_ps(depthAt[3], _mm512_extractf32x4_ps(after, 3));
        const __m128i number = _mm_set1_epi32(int32_t(batch.number[i]));
        for (int row = 0; row < 4; ++row) {
            auto* const numbers = reinterpret_cast<__m128i*>(numberAt[row]);
            _mm_storeu_si128(numbers, _mm_mask_blend_epi32(__mmask8(pass >> (4 * row) & 15), _mm_loadu_si128(numbers), number));
        }
    }
};

}  // namespace

void drawTrianglesAvx512(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<Avx512Lanes>(part, band, counts);
}

}  // namespace cullscope
