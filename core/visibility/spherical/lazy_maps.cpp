#include "core/visibility/spherical/lazy_maps.h"

#include <algorithm>

namespace cullscope::spherical {

const SphericalMaps& LazyMaps::operator*() const {
    if (m_ready) return *m_ready;
    std::call_once(m_made->once, [&] {
        constexpr size_t kMost = 144'046;  // the number of triangles whose automatic grid is the paper's
        const SphericalGrid grid = SphericalGrid::forTriangles(std::min(m_made->mesh->triangleCount(), kMost));
        m_made->maps = std::make_shared<SphericalMaps>(m_made->mesh, grid);
    });
    return *m_made->maps;
}

}  // namespace cullscope::spherical
