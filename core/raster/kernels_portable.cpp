#include "core/raster/depth_buffer_kernel.h"
#include "core/raster/occlusion_kernel.h"
#include "core/raster/occlusion_setup_kernel.h"
#include "core/raster/projection_kernel.h"
#include "core/raster/shading_kernel.h"

namespace cullscope {
namespace {

struct PortableLanes {
    /// A bit of each element of a comparison's result.
    static uint32_t bitsOf(const Ints& mask) {
        uint32_t bits = 0;
        for (int lane = 0; lane < kLanes; ++lane) bits |= uint32_t(mask[lane] & 1) << lane;
        return bits;
    }
    /// How many elements of a comparison's results hold.
    static uint32_t countOf(const Ints (&masks)[2]) {
        int32_t count = 0;
        for (int lane = 0; lane < kLanes; ++lane) count -= masks[0][lane] + masks[1][lane];
        return uint32_t(count);
    }
    static Ints rounded(const Floats& values) {
        Ints whole{};
        for (int lane = 0; lane < kLanes; ++lane) whole[lane] = int32_t(__builtin_lrintf(values[lane]));
        return whole;
    }
    /// a · b + c, rounded once.
    static Floats fused(const Floats& a, const Floats& b, const Floats& c) {
        Floats sum{};
        for (int lane = 0; lane < kLanes; ++lane) sum[lane] = __builtin_fmaf(a[lane], b[lane], c[lane]);
        return sum;
    }
    /// What is no number stays none.
    static Floats atMostOne(const Floats& values) { return values > 1.0f ? Floats{} + 1.0f : values; }
    /// By a comparison's result.
    static Floats chosen(const Ints& mask, const Floats& one, const Floats& other) { return mask ? one : other; }
    static void drawSmall(const Batch& batch, size_t i, const RasterBand& band, RasterCounts& counts) {
        drawSmallByHalves<PortableLanes>(batch, i, band, counts);
    }
    static Floats root(const Floats& values) {
        Floats roots{};
        for (int lane = 0; lane < kLanes; ++lane) roots[lane] = __builtin_sqrtf(values[lane]);
        return roots;
    }
};

}  // namespace

void drawTrianglesPortable(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<PortableLanes>(part, band, counts);
}

void placePortable(const RasterPlacing& placing, uint32_t* places) { placeTriangles<PortableLanes>(placing, places); }

void projectPortable(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    project<PortableLanes>(projection, positions, count, vertices);
}

void shadePortable(const Shading& shading, const ShadedBlock& block) { shadeBlock<PortableLanes>(shading, block); }

void markShownPortable(const uint32_t* items, size_t count, uint8_t* fates) {
    markShownItems<PortableLanes>(items, count, fates);
}

size_t setUpOccludersPortable(const OccluderSetup& setup, OccluderTriangle* triangles) {
    return setUpOccluders<PortableLanes>(setup, triangles);
}

void drawOccludersPortable(const OccluderTriangle* triangles, size_t count, const OcclusionTiles& tiles) {
    drawAllOccluders(triangles, count, tiles);
}

}  // namespace cullscope
