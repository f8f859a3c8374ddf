#pragma once

#include "core/visibility/registry.h"

namespace cullscope::software {

/// `depth-buffer`: makes the picture on the processor by the depth buffer (core/raster/depth_buffer.h): the triangles in any
/// order, each sample compared with the depth stored there. Exact: shows what OpenGL shows, up to the raster's snapping.
[[nodiscard]] RegisteredStrategy depthBuffer();

/// `scan-line`: makes the same picture, to the bit, by the scan line (core/raster/scan_line.h): depths are compared only where
/// surfaces begin, end or cross along a row. Exact.
[[nodiscard]] RegisteredStrategy scanLine();

}  // namespace cullscope::software
