#pragma once

#include <algorithm>
#include <cmath>

#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// Transforms a map's coordinates, which are relative to its bounding sphere's centre, to the world.
class MapPlace {
public:
    MapPlace(const Scene& scene, const MapSnapshot& map)
        : m_worldFromMesh(scene.instances()[map.decision.instance].worldFromMesh),
          m_meshFromMap(map.maps.meshFromMap()),
          m_centre(map.maps.mesh().origin() + map.maps.sphere().centre) {}

    [[nodiscard]] Vec3 world(const Vec3& point) const {
        return Vec3(m_worldFromMesh * Vec4(m_centre + m_meshFromMap * point, 1.0));
    }
    /// The same of directions.
    [[nodiscard]] Mat3 linear() const { return Mat3(m_worldFromMesh) * m_meshFromMap; }
    /// The inverse; not finite for an object that its transform flattens.
    [[nodiscard]] Vec3 local(const Vec3& place) const {
        return (Vec3(glm::inverse(m_worldFromMesh) * Vec4(place, 1.0)) - m_centre) * m_meshFromMap;
    }

private:
    const Mat4& m_worldFromMesh;
    Mat3 m_meshFromMap;
    Vec3 m_centre;
};

/// The number of straight pieces with which a circle of that radius in pixels looks round.
[[nodiscard]] inline int piecesOfCircle(double pixels) { return 8 * int(std::clamp(pixels / 24.0, 2.0, 16.0)); }

}  // namespace cullscope::spherical
