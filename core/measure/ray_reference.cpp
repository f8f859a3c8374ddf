#include "core/measure/ray_reference.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <memory>

#include "core/base/error.h"

namespace cullscope {
namespace {

template <typename Handle, void (*Release)(Handle)>
struct Releaser {
    using pointer = Handle;
    void operator()(Handle handle) const { Release(handle); }
};
using DevicePointer = std::unique_ptr<RTCDevice, Releaser<RTCDevice, rtcReleaseDevice>>;
using ScenePointerRtc = std::unique_ptr<RTCScene, Releaser<RTCScene, rtcReleaseScene>>;

/// The corners of one scene triangle relative to the eye, in double.
std::array<Vec3, 3> cornersFromEye(const Scene& scene, size_t instance, uint64_t triangle, const Vec3& eye) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Mat4& place = scene.instances()[instance].worldFromMesh;
    const Vec3 origin = Vec3(place[3]) - eye + Mat3(place) * mesh.origin();
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = origin + Mat3(place) * Vec3(mesh.positions()[mesh.indices()[3 * triangle + i]]);
    return corners;
}

/// A power of two that scales the scene to a distance of at most about 1 from the eye: Embree multiplies three lengths in float,
/// which overflows or underflows for scenes of 1e13 or 1e-13 units.
double scaleToUnit(const Scene& scene, const Vec3& eye) {
    const Box3& bounds = scene.bounds();
    if (bounds.empty()) return 1.0;
    const Vec3 reach = glm::max(glm::abs(bounds.min - eye), glm::abs(bounds.max - eye));
    const double largest = std::max({reach.x, reach.y, reach.z});
    return largest > 0.0 ? std::exp2(-std::ilogb(largest)) : 1.0;
}

void addInstance(RTCDevice device, RTCScene target, const Scene& scene, uint32_t number, const Vec3& eye, double scale) {
    const TriangleMesh& mesh = scene.meshOf(number);
    if (mesh.triangleCount() == 0) return;
    const Mat4& place = scene.instances()[number].worldFromMesh;
    const Vec3 origin = Vec3(place[3]) - eye + Mat3(place) * mesh.origin();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.vertexCount()));
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(uint32_t), mesh.triangleCount()));
    for (size_t v = 0; v < mesh.vertexCount(); ++v)
        vertices[v] = Vec3f(scale * (origin + Mat3(place) * Vec3(mesh.positions()[v])));
    std::copy(mesh.indices().begin(), mesh.indices().end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(target, geometry, number);
    rtcReleaseGeometry(geometry);
}

/// Embree's normal is (v1 − v0) × (v2 − v0): a face is a front face where the normal points against the ray; the opposite for
/// mirrored instances.
struct FrontFilter {
    const Scene* scene;
};

void rejectBackFaces(const RTCFilterFunctionNArguments* arguments) {
    const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    const auto* filter = static_cast<const FrontFilter*>(arguments->geometryUserPtr);
    const Mat3 linear(filter->scene->instances()[hit->geomID].worldFromMesh);
    const double facing = double(hit->Ng_x) * ray->dir_x + double(hit->Ng_y) * ray->dir_y + double(hit->Ng_z) * ray->dir_z;
    const double mirrored = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    if (facing * mirrored >= 0.0) arguments->valid[0] = 0;
}

/// The depth of a triangle's plane at a pixel, and its change over one pixel. Reversed depth is affine in pixel coordinates: with
/// the plane n·p = c the forward distance along direction d is c / n·d, and 1/distance is linear in d.
struct PlaneDepth {
    double depth;
    double perPixel;
};

PlaneDepth depthOnPlane(const std::array<Vec3, 3>& corners, const View& view, const Vec3& direction) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double c = glm::dot(normal, corners[0]);
    const Frustum& f = view.frustum();
    const double inverse = glm::dot(normal, direction) / c;
    const double acrossX = std::abs(glm::dot(normal, f.right) * (2.0 * f.tanHalfWidth / view.viewport().width) / c);
    const double acrossY = std::abs(glm::dot(normal, f.up) * (2.0 * f.tanHalfHeight / view.viewport().height) / c);
    const double scale = f.nearDistance * f.farDistance / (f.farDistance - f.nearDistance);
    return {view.depthFromDistance(1.0 / inverse), scale * (acrossX + acrossY)};
}

}  // namespace

RayReference rayReference(const Scene& scene, const View& view, Facing facing, const Progress& progress) {
    if (scene.triangleCount() > uint64_t{UINT32_MAX} - 1)
        throwUsage(CULLSCOPE_TR("The scene has too many triangles for the ray reference."));
    const DevicePointer device(rtcNewDevice(nullptr));
    const ScenePointerRtc tracer(rtcNewScene(device.get()));
    rtcSetSceneFlags(tracer.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(tracer.get(), RTC_BUILD_QUALITY_MEDIUM);
    FrontFilter filter{&scene};
    const double scale = scaleToUnit(scene, view.eye());
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        progress.check();
        addInstance(device.get(), tracer.get(), scene, i, view.eye(), scale);
        if (facing != Facing::Front || scene.meshOf(i).triangleCount() == 0) continue;
        RTCGeometry geometry = rtcGetGeometry(tracer.get(), i);
        rtcSetGeometryUserData(geometry, &filter);
        rtcSetGeometryIntersectFilterFunction(geometry, rejectBackFaces);
        rtcCommitGeometry(geometry);
    }
    rtcCommitScene(tracer.get());

    const auto width = static_cast<size_t>(view.viewport().width);
    const auto height = static_cast<size_t>(view.viewport().height);
    RayReference reference;
    reference.size = view.viewport();
    reference.facing = facing;
    reference.triangle.assign(width * height, 0);
    reference.depth.assign(width * height, 0.0);
    reference.depthPerPixel.assign(width * height, 0.0);
    std::atomic<uint64_t> covered{0};
    tbb::parallel_for(tbb::blocked_range<size_t>(0, height), [&](const tbb::blocked_range<size_t>& rows) {
        for (size_t y = rows.begin(); y < rows.end() && !progress.stopRequested(); ++y)
            for (size_t x = 0; x < width; ++x) {
                // The direction has forward component 1, so that the ray's parameter is the forward distance (scaled).
                const Vec3 direction = view.direction(double(x) + 0.5, double(y) + 0.5);
                RTCRayHit ray{};
                ray.ray.dir_x = float(direction.x);
                ray.ray.dir_y = float(direction.y);
                ray.ray.dir_z = float(direction.z);
                ray.ray.tnear = float(scale * view.camera().nearDistance);
                ray.ray.tfar = float(scale * view.camera().farDistance);
                ray.ray.mask = UINT32_MAX;
                ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                RTCIntersectContext context;
                rtcInitIntersectContext(&context);
                rtcIntersect1(tracer.get(), &context, &ray);
                if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
                const size_t pixel = y * width + x;
                const auto corners = cornersFromEye(scene, ray.hit.geomID, ray.hit.primID, view.eye());
                const PlaneDepth plane = depthOnPlane(corners, view, direction);
                reference.triangle[pixel] = static_cast<uint32_t>(scene.firstTriangle(ray.hit.geomID) + ray.hit.primID + 1);
                reference.depth[pixel] = plane.depth;
                reference.depthPerPixel[pixel] = plane.perPixel;
                covered.fetch_add(1, std::memory_order_relaxed);
            }
    });
    progress.check();
    reference.coveredPixels = covered;
    return reference;
}

}  // namespace cullscope
