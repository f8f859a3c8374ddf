#pragma once

#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope::test {

/// A mesh as Draco's encoder writes it: positions with the number 0, normals along z with 1. Without `bits` the positions are not
/// quantised. Triangles keep no order.
[[nodiscard]] std::string dracoBytes(const std::vector<Vec3f>& positions, const std::vector<uint32_t>& triangles,
                                     bool edgebreaker, int bits = 0);

}  // namespace cullscope::test
