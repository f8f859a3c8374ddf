#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace cullscope {

/// Scene and culling arithmetic is in double; only data for the GPU is float.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
using Vec3f = glm::vec3;
using Mat4f = glm::mat4;

}  // namespace cullscope
