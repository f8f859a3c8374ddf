#include "core/visibility/spherical/object_space_view.h"

#include <algorithm>
#include <cmath>

#include "core/visibility/spherical/recorded_decisions.h"

namespace cullscope::spherical {
namespace {

ObjectSpaceView::PlaneTest test(const Plane& plane, const EyeFromLocal& object, double radius) {
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

ObjectSpaceView seenFrom(const View& view, const EyeFromLocal& object, double radius, ObjectRecord* record, uint8_t line) {
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
    setPlanes(result, view, object);
    result.beyondNear = result.planes[size_t(FrustumPlane::Near)].containment == Containment::Inside;
    const Mat3 inverse = glm::inverse(object.linear);
    const double shrink = frobenius(inverse);
    // A flattened object has no inside, so directions from its centre are not defined.
    if (!std::isfinite(shrink) || object.stretch * shrink > kMostFlattened || radius <= 0.0) return result;
    setEye(result, object, inverse);
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
    const ObjectSpaceView seen = seenFrom(view, eyeFromLocal(scene, instance, frame.sphere, frame.meshFromMap, view.eye()),
                                          frame.sphere.radius, record, line);
    if (record != nullptr) record->attach(std::make_shared<SphereDetail>(seen.relation, seen.eye));
    return seen;
}

}  // namespace cullscope::spherical
