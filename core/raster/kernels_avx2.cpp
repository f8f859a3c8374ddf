#include <immintrin.h>

#include "core/raster/depth_buffer_kernel.h"
#include "core/raster/occlusion_kernel.h"
#include "core/raster/occlusion_setup_kernel.h"
#include "core/raster/projection_kernel.h"
#include "core/raster/shading_kernel.h"

namespace cullscope {
namespace {

struct Avx2Lanes {
    /// A bit of each element of a comparison's result.
    static uint32_t bitsOf(const Ints& mask) { return uint32_t(_mm256_movemask_ps(reinterpret_cast<const __m256&>(mask))); }
    /// How many elements of a comparison's results hold.
    static uint32_t countOf(const Ints (&masks)[2]) {
        return uint32_t(__builtin_popcount(bitsOf(masks[0]) | bitsOf(masks[1]) << kLanes));
    }
    static Ints rounded(const Floats& values) { return reinterpret_cast<Ints>(_mm256_cvtps_epi32(values)); }
    /// a · b + c, rounded once.
    static Floats fused(const Floats& a, const Floats& b, const Floats& c) { return _mm256_fmadd_ps(a, b, c); }
    /// What is no number stays none.
    static Floats atMostOne(const Floats& values) { return _mm256_min_ps(_mm256_set1_ps(1.0f), values); }
    /// By a comparison's result.
    static Floats chosen(const Ints& mask, const Floats& one, const Floats& other) {
        return _mm256_blendv_ps(other, one, reinterpret_cast<const __m256&>(mask));
    }
    static void drawSmall(const Batch& batch, size_t i, const RasterBand& band, RasterCounts& counts) {
        drawSmallByHalves<Avx2Lanes>(batch, i, band, counts);
    }
    static Floats root(const Floats& values) { return _mm256_sqrt_ps(values); }
};

}  // namespace

void drawTrianglesAvx2(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<Avx2Lanes>(part, band, counts);
}

void placeAvx2(const RasterPlacing& placing, uint32_t* places) { placeTriangles<Avx2Lanes>(placing, places); }

void projectAvx2(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    project<Avx2Lanes>(projection, positions, count, vertices);
}

void shadeAvx2(const Shading& shading, const ShadedBlock& block) { shadeBlock<Avx2Lanes>(shading, block); }

void markShownAvx2(const uint32_t* items, size_t count, uint8_t* fates) { markShownItems<Avx2Lanes>(items, count, fates); }

size_t setUpOccludersAvx2(const OccluderSetup& setup, OccluderTriangle* triangles) {
    return setUpOccluders<Avx2Lanes>(setup, triangles);
}

void drawOccludersAvx2(const OccluderTriangle* triangles, size_t count, const OcclusionTiles& tiles) {
    drawAllOccluders(triangles, count, tiles);
}

}  // namespace cullscope
