#include "core/visibility/part_view.h"

#include <algorithm>
#include <cmath>

#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

/// An upper bound on the factor by which a vector is lengthened: exact for rotations with a uniform scale, else the root of a
/// bound on the norm of the Gram matrix.
double largestStretch(const Mat3& m) {
    const Mat3 gram = glm::transpose(m) * m;
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        const Vec3 sizes = glm::abs(gram[column]);
        largest = std::max(largest, sizes.x + sizes.y + sizes.z);
    }
    return std::sqrt(largest) * (1.0 + 1e-12);
}

}  // namespace

double frobenius(const Mat3& m) { return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])); }

EyeFromLocal eyeFromLocal(const Scene& scene, uint32_t instance, const Sphere& sphere, const Mat3& meshFromLocal,
                          const Vec3& eye) {
    const Mat4& worldFromMesh = scene.instances()[instance].worldFromMesh;
    EyeFromLocal result;
    result.linear = Mat3(worldFromMesh) * meshFromLocal;
    result.stretch = frobenius(result.linear);
    const Vec3 centre = Vec3(worldFromMesh * Vec4(scene.meshOf(instance).origin() + sphere.centre, 1.0));
    result.centre = centre - eye;
    const double reach = sphere.radius * result.stretch;
    // The rounding of the subtraction grows with the world coordinates, that of the picture with the distance from the eye.
    result.rounding = scene.pictureRounding(scene.instances()[instance]);
    result.margin = marginFromEye(centre, result.centre, reach, eye) + result.rounding;
    return result;
}

void setPlanes(PartView& seen, const View& view, const EyeFromLocal& object) {
    seen.margin = object.margin;
    for (size_t p = 0; p < seen.localPlanes.size(); ++p) {
        const Plane& plane = view.frustum().planes[p];
        seen.localPlanes[p] = {glm::transpose(object.linear) * plane.normal, plane.distance(object.centre)};
    }
    seen.pixelSlope = 2.0 * view.frustum().tanHalfHeight / view.viewport().height;
}

void setEye(PartView& seen, const EyeFromLocal& object, const Mat3& inverse) {
    seen.eye = -(inverse * object.centre);
    seen.eyeKnown = true;
    const double shrink = largestStretch(inverse);
    seen.unevenness = largestStretch(object.linear) * shrink;
    seen.rounding = object.rounding * shrink;
}

PartView partView(const Scene& scene, uint32_t instance, const View& view) {
    const EyeFromLocal object = eyeFromLocal(scene, instance, scene.meshOf(instance).localSphere(), Mat3(1.0), view.eye());
    PartView seen;
    setPlanes(seen, view, object);
    if (view.frustum().parallel()) return seen;
    const Mat3 inverse = glm::inverse(object.linear);
    const double shrink = frobenius(inverse);
    if (std::isfinite(shrink) && object.stretch * shrink <= kMostFlattened) setEye(seen, object, inverse);
    return seen;
}

double snapping(const PartView& view) {
    constexpr double kSteps = 1.0 / 256.0;
    return (kSteps * view.pixelSlope + 0x1p-20) * view.unevenness;
}

}  // namespace cullscope
