#include "core/geometry/random.h"

#include <cmath>
#include <numbers>

namespace cullscope {

Vec3 Random::direction() {
    const double z = between(-1.0, 1.0);
    const double azimuth = between(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

}  // namespace cullscope
