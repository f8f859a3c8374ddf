#include "core/spatial/inner_kernel.h"

#include <cmath>

#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void inner_kernel(std::string_view input) {
    Values values(input);
    const MeshPointer mesh = meshOf(values);
    if (!mesh) return;
    const InnerKernel kernel(*mesh);
    if (!kernel.filled()) return;
    require(kernel.leastRadius() > 0.0f, "a kernel without an extent");
    const uint32_t side = 1U << kernel.level();
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const float radius = kernel.radius({kernel.level(), x, y});
            require(radius >= kernel.leastRadius() && radius <= mesh->localSphere().radius * 1.001, "a radius beyond the solid");
        }
    const Vec3 direction(values.quarter(), values.quarter(), values.quarter());
    if (direction != Vec3(0.0)) require(kernel.radiusAround(direction) >= kernel.leastRadius(), "a radius below the least one");
}

}  // namespace cullscope::fuzz
