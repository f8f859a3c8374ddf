#include "core/raster/depth_buffer_kernel.h"

namespace cullscope {
namespace {

struct PortableLanes {
    /// Whether no element of a comparison's result holds.
    static bool none(const Ints& mask) {
        int32_t any = 0;
        for (int lane = 0; lane < kLanes; ++lane) any |= mask[lane];
        return any == 0;
    }
};

}  // namespace

void drawTrianglesPortable(const ScreenTriangle* const* triangles, size_t count, const RasterBand& band, RasterCounts& counts) {
    drawTriangles<PortableLanes>(triangles, count, band, counts);
}

}  // namespace cullscope
