#include <immintrin.h>

#include "core/raster/depth_buffer_kernel.h"
#include "core/raster/projection_kernel.h"
#include "core/raster/shading_kernel.h"

namespace cullscope {
namespace {

struct Avx2Lanes {
    /// Whether no element of a comparison's result holds.
    static bool none(const Ints& mask) {
        const __m256i bits = reinterpret_cast<const __m256i&>(mask);
        return _mm256_testz_si256(bits, bits) != 0;
    }
    static Ints rounded(const Floats& values) { return reinterpret_cast<Ints>(_mm256_cvtps_epi32(values)); }
    static void drawBlock(const Batch& batch, size_t i, const BlockPlace& block, const RasterBand& band,
                          PixelCounters& counters) {
        cullscope::drawBlock<Avx2Lanes>(batch, i, block, band, counters);
    }
    static Floats root(const Floats& values) { return _mm256_sqrt_ps(values); }
};

}  // namespace

void drawTrianglesAvx2(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<Avx2Lanes>(part, band, counts);
}

void projectAvx2(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    project<Avx2Lanes>(projection, positions, count, vertices);
}

void shadeRowAvx2(const Shading& shading, const uint32_t* items, int32_t count, int32_t first, int32_t row, uint32_t* rgba) {
    shadeRow<Avx2Lanes>(shading, items, count, first, row, rgba);
}

}  // namespace cullscope
