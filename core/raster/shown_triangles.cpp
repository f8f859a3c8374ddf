#include "core/raster/shown_triangles.h"

#include <algorithm>

#include "core/raster/in_parallel.h"
#include "core/raster/kernel_choice.h"
#include "core/raster/shaded_rows.h"

namespace cullscope {

void markShown(const FinishedPicture& picture, std::vector<uint8_t>& fates, bool parallel, RasterSimd simd) {
    constexpr size_t kPixels = 1 << 14;
    ShowingKernel* const kernel = kernelFor<ShowingKernel>(simd, CULLSCOPE_VARIANTS(markShown));
    const size_t pixels = picture.triangle.size();
    forEachOf((pixels + kPixels - 1) / kPixels, parallel, [&](size_t part) {
        const size_t first = part * kPixels;
        kernel(&picture.triangle[first], std::min(kPixels, pixels - first), fates.data());
    });
}

}  // namespace cullscope
