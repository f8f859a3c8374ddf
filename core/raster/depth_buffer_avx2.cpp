#include <immintrin.h>

#include "core/raster/depth_buffer_kernel.h"

namespace cullscope {
namespace {

struct Avx2Lanes {
    /// Whether no element of a comparison's result holds.
    static bool none(const Ints& mask) {
        const __m256i bits = reinterpret_cast<const __m256i&>(mask);
        return _mm256_testz_si256(bits, bits) != 0;
    }
};

}  // namespace

void drawTrianglesAvx2(const ScreenTriangle* const* triangles, size_t count, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<Avx2Lanes>(triangles, count, band, counts);
}

}  // namespace cullscope
