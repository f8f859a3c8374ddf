#pragma once

#include "core/scene/camera.h"

namespace cullscope::test {

/// A view from `eye` to `target` with +z up, or +y where it looks along z; the field of view in degrees.
inline View lookingAt(const Vec3& eye, const Vec3& target, double fovy, Viewport size = {64, 64}) {
    return {{eye, target, std::abs(glm::normalize(target - eye).z) > 0.999 ? Vec3(0, 1, 0) : Vec3(0, 0, 1),
             Angle::fromDegrees(fovy), 0.01, 1000},
            size};
}

}  // namespace cullscope::test
