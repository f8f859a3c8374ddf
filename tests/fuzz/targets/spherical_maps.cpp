#include "core/spatial/spherical_maps.h"

#include <algorithm>

#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void spherical_maps(std::string_view input) {
    Values values(input);
    const SphericalGrid grid(uint32_t(4 + values.below(64)), uint32_t(2 + values.below(32)));
    const MeshPointer mesh = meshOf(values);
    if (!mesh) return;
    constexpr uint64_t kMostEntries = 100'000;
    accepted({ErrorKind::Usage}, [&] {
        const SphericalMaps maps(mesh, grid, {}, kMostEntries);
        std::vector<uint32_t> order(maps.triangleOrder().begin(), maps.triangleOrder().end());
        std::ranges::sort(order);
        require(order.size() == mesh->triangleCount(), "the centroid map has not every triangle");
        for (uint32_t i = 0; i < order.size(); ++i) require(order[i] == i, "the centroid map has a triangle twice");
        std::vector<bool> indexed(mesh->triangleCount());
        for (uint32_t cell = 0; cell < grid.cellCount(); ++cell) {
            for (const uint32_t triangle : maps.triangles(cell)) indexed[triangle] = true;
            if (!maps.triangles(cell).empty() && !maps.extent(cell).empty())
                require(maps.extent(cell).nearest >= 0.0f, "a distance is negative");
        }
        require(std::ranges::find(indexed, false) == indexed.end(), "a triangle is in no cell of the index map");
    });
}

}  // namespace cullscope::fuzz
