#include "core/visibility/spherical/object_space_view.h"

#include <algorithm>
#include <cmath>

#include "core/visibility/eye_bounds.h"
#include "core/visibility/spherical/recorded_decisions.h"

namespace cullscope::spherical {
namespace {

/// The affine map from map coordinates to world axes with the origin at the eye: linear · p + centre.
struct EyeFromMap {
    Mat3 linear{1.0};
    Vec3 centre{0.0};
    double margin = 0.0;   ///< of plane tests
    double stretch = 0.0;  ///< upper bound on the factor by which it lengthens a vector
};

double frobenius(const Mat3& m) { return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])); }

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

EyeFromMap eyeFromMap(const Scene& scene, uint32_t instance, const MapFrame& frame, const Vec3& eye) {
    const Sphere& sphere = frame.sphere;
    const Mat4& worldFromMesh = scene.instances()[instance].worldFromMesh;
    EyeFromMap result;
    result.linear = Mat3(worldFromMesh) * frame.meshFromMap;
    result.stretch = frobenius(result.linear);
    const Vec3 centre = Vec3(worldFromMesh * Vec4(scene.meshOf(instance).origin() + sphere.centre, 1.0));
    result.centre = centre - eye;
    const double reach = sphere.radius * result.stretch;
    // The rounding of the subtraction grows with the world coordinates, that of the picture with the distance from the eye.
    result.margin = marginFromEye(centre, result.centre, reach, eye) + scene.pictureRounding(scene.instances()[instance]);
    return result;
}

ObjectSpaceView::PlaneTest test(const Plane& plane, const EyeFromMap& object, double radius) {
    const double centre = plane.distance(object.centre);
    const double reach = radius * glm::length(glm::transpose(object.linear) * plane.normal);
    ObjectSpaceView::PlaneTest result;
    result.distance = centre + reach;
    result.outer = centre - reach;
    result.bound = object.margin;
    if (result.distance < -object.margin)
        result.containment = Containment::Outside;
    else if (result.outer > object.margin)
        result.containment = Containment::Inside;
    return result;
}

ObjectSpaceView seenFrom(const View& view, const EyeFromMap& object, double radius, ObjectRecord* record, uint8_t line) {
    ObjectSpaceView result;
    bool within = true;
    for (const Plane& plane : view.frustum().planes) {
        const auto number = FrustumPlane(result.planesTested);
        const ObjectSpaceView::PlaneTest tested = result.planes[result.planesTested++] = test(plane, object, radius);
        if (record != nullptr)
            record->say(atLine(line, planeTest(record->subject(), number, tested.distance, tested.outer, tested.bound)));
        within = within && tested.containment == Containment::Inside;
        if (tested.containment != Containment::Outside) continue;
        result.relation = SphereRelation::Outside;
        return result;
    }
    result.margin = object.margin;
    for (size_t p = 0; p < result.planesOnMap.size(); ++p) {
        const Plane& plane = view.frustum().planes[p];
        result.planesOnMap[p] = {glm::transpose(object.linear) * plane.normal, plane.distance(object.centre)};
    }
    result.pixelSlope = 2.0 * view.frustum().tanHalfHeight / view.viewport().height;
    result.beyondNear = result.planes[size_t(FrustumPlane::Near)].containment == Containment::Inside;
    const Mat3 inverse = glm::inverse(object.linear);
    const double shrink = frobenius(inverse);
    // A flattened object has no inside, so directions from its centre are not defined.
    if (!std::isfinite(shrink) || object.stretch * shrink > 1e9 || radius <= 0.0) return result;
    result.eye = -(inverse * object.centre);
    result.eyeKnown = true;
    result.unevenness = largestStretch(object.linear) * largestStretch(inverse);
    const std::array<Vec3, 8> corners = view.frustum().corners();
    std::transform(corners.begin(), corners.begin() + 4, result.cornerDirections.begin(),
                   [&](const Vec3& corner) { return inverse * corner; });
    // A pixel covers the largest angle in the middle of the picture.
    const double farthest = glm::length(object.centre) + radius * object.stretch;
    result.pixelReach = result.pixelSlope * farthest * shrink;
    // With the eye at the sphere itself, the slopes and ray parameters lose all their digits.
    if (glm::length(result.eye) <= radius * (1.0 + 1e-6)) return result;
    result.relation = within ? SphereRelation::Within : SphereRelation::Cut;
    return result;
}

}  // namespace

ObjectSpaceView objectSpaceView(const Scene& scene, uint32_t instance, const MapFrame& frame, const View& view,
                                ObjectRecord* record, uint8_t line) {
    const ObjectSpaceView seen =
        seenFrom(view, eyeFromMap(scene, instance, frame, view.eye()), frame.sphere.radius, record, line);
    if (record != nullptr) record->attach(std::make_shared<SphereDetail>(seen.relation, seen.eye));
    return seen;
}

}  // namespace cullscope::spherical
