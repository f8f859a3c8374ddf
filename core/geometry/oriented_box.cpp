#include "core/geometry/oriented_box.h"

namespace cullscope {

double OrientedBox::farthest() const {
    return glm::length(centre) + glm::length(axes[0]) + glm::length(axes[1]) + glm::length(axes[2]) + room;
}

OrientedBox orientedBox(const Box3& meshBox, const Mat4& worldFromMesh, const Vec3& eye, const Vec3& meshOrigin) {
    const Vec3 centre = meshBox.centre();
    const Vec3 half = meshBox.halfExtent();
    OrientedBox box;
    // The origin before the offsets: the large terms cancel against the eye first.
    box.centre = Vec3(worldFromMesh[3]) - eye + Mat3(worldFromMesh) * meshOrigin;
    Vec3 magnitude = glm::abs(Vec3(worldFromMesh[3])) + glm::abs(eye);
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 column(worldFromMesh[axis]);
        box.centre += column * centre[axis];
        box.axes[size_t(axis)] = column * half[axis];
        magnitude += glm::abs(column) * (glm::abs(meshOrigin[axis]) + glm::abs(centre[axis]) + half[axis]);
    }
    // Fewer than twelve roundings of half an ulp of the magnitude in the centre, three in an axis.
    box.room = glm::length(magnitude) * 0x1p-49;
    return box;
}

Containment classify(const Frustum& frustum, const OrientedBox& box, double margin) {
    Containment result = Containment::Inside;
    for (const Plane& plane : frustum.planes) {
        if (pVertexDistance(plane, box) < -margin) return Containment::Outside;
        if (!(nVertexDistance(plane, box) > margin)) result = Containment::Straddles;
    }
    return result;
}

Containment classify(const Frustum& frustum, const OrientedBox& box) {
    return classify(frustum, box, conservativeMargin(box.farthest()));
}

}  // namespace cullscope
