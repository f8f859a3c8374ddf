#include "core/mesh/triangle_boxes.h"

#include <limits>

#include "core/mesh/embree_handles.h"

namespace cullscope {
namespace {

constexpr std::array<float RTCBounds::*, 3> kLower{&RTCBounds::lower_x, &RTCBounds::lower_y, &RTCBounds::lower_z};
constexpr std::array<float RTCBounds::*, 3> kUpper{&RTCBounds::upper_x, &RTCBounds::upper_y, &RTCBounds::upper_z};

void giveBounds(const RTCBoundsFunctionArguments* arguments) {
    const auto* triangles = static_cast<const TriangleCorners*>(arguments->geometryUserPtr);
    const TriangleCorners& corners = triangles[arguments->primID];
    for (int axis = 0; axis < 3; ++axis) {
        const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        arguments->bounds_o->*kLower[size_t(axis)] = float(least - TriangleBoxes::kBoxRoom);
        arguments->bounds_o->*kUpper[size_t(axis)] = float(most + TriangleBoxes::kBoxRoom);
    }
}

/// A ray that names the triangles whose boxes it meets.
struct NamingRay {
    RTCIntersectContext context;  // first: Embree hands on a pointer to it
    const std::function<void(uint32_t)>* visit = nullptr;
};

void nameTriangle(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    (*reinterpret_cast<const NamingRay*>(arguments->context)->visit)(arguments->primID);
}

void nameOverlapping(void* visitor, RTCCollision* collisions, unsigned count) {
    const auto& visit = *static_cast<const std::function<void(uint32_t, uint32_t)>*>(visitor);
    for (unsigned i = 0; i < count; ++i)
        if (collisions[i].primID0 < collisions[i].primID1) visit(collisions[i].primID0, collisions[i].primID1);
}

}  // namespace

struct TriangleBoxes::Tree {
    EmbreeDevicePointer device;
    EmbreeScenePointer scene;
};

TriangleBoxes::TriangleBoxes(std::span<const TriangleCorners> triangles) {
    EmbreeDevicePointer device(rtcNewDevice(nullptr));
    EmbreeScenePointer scene(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(triangles.size()));
    rtcSetGeometryUserData(geometry, const_cast<TriangleCorners*>(triangles.data()));  // only read
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* arguments) { giveBounds(arguments); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, nameTriangle);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    m_tree = std::make_unique<const Tree>(Tree{std::move(device), std::move(scene)});
}

TriangleBoxes::~TriangleBoxes() = default;

void TriangleBoxes::visitOverlapping(const std::function<void(uint32_t, uint32_t)>& visit) const {
    rtcCollide(m_tree->scene.get(), m_tree->scene.get(), nameOverlapping,
               const_cast<std::function<void(uint32_t, uint32_t)>*>(&visit));  // only called
}

void TriangleBoxes::visitAlong(const Vec3& from, int axis, bool forward, const std::function<void(uint32_t)>& visit) const {
    NamingRay naming{};
    rtcInitIntersectContext(&naming.context);
    naming.visit = &visit;
    const double direction = forward ? 1.0 : -1.0;
    RTCRayHit ray{};
    ray.ray.org_x = float(from.x), ray.ray.org_y = float(from.y), ray.ray.org_z = float(from.z);
    ray.ray.dir_x = axis == 0 ? float(direction) : 0.0F;
    ray.ray.dir_y = axis == 1 ? float(direction) : 0.0F;
    ray.ray.dir_z = axis == 2 ? float(direction) : 0.0F;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = UINT32_MAX;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_tree->scene.get(), &naming.context, &ray);
}

}  // namespace cullscope
