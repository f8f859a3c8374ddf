#include "core/raster/depth_buffer_kernel.h"
#include "core/raster/projection_kernel.h"
#include "core/raster/shading_kernel.h"

namespace cullscope {
namespace {

struct PortableLanes {
    /// Whether no element of a comparison's result holds.
    static bool none(const Ints& mask) {
        int32_t any = 0;
        for (int lane = 0; lane < kLanes; ++lane) any |= mask[lane];
        return any == 0;
    }
    static Ints rounded(const Floats& values) {
        Ints whole{};
        for (int lane = 0; lane < kLanes; ++lane) whole[lane] = int32_t(__builtin_lrintf(values[lane]));
        return whole;
    }
    static void drawBlock(const Batch& batch, size_t i, const BlockPlace& block, const RasterBand& band,
                          PixelCounters& counters) {
        cullscope::drawBlock<PortableLanes>(batch, i, block, band, counters);
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

void projectPortable(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    project<PortableLanes>(projection, positions, count, vertices);
}

void shadeRowPortable(const Shading& shading, const uint32_t* items, int32_t count, int32_t first, int32_t row, uint32_t* rgba) {
    shadeRow<PortableLanes>(shading, items, count, first, row, rgba);
}

}  // namespace cullscope
