#include "core/scene/scene_rays.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/triangle.h"
#include "core/mesh/embree_handles.h"
#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// A power of two that scales the scene to a distance of at most about 1 from the origin: Embree multiplies three lengths in
/// float, which overflows or underflows for scenes of 1e13 or 1e-13 units.
double scaleToUnit(const Scene& scene, const Vec3& origin) {
    const Box3& bounds = scene.bounds();
    if (bounds.empty()) return 1.0;
    const Vec3 reach = glm::max(glm::abs(bounds.min - origin), glm::abs(bounds.max - origin));
    const double largest = std::max({reach.x, reach.y, reach.z});
    return largest > 0.0 ? std::exp2(-std::ilogb(largest)) : 1.0;
}

void addInstance(RTCDevice device, RTCScene target, const Scene& scene, uint32_t number, const Vec3& origin, double scale) {
    const TriangleMesh& mesh = scene.meshOf(number);
    if (mesh.triangleCount() == 0) return;
    const Mat4& place = scene.instances()[number].worldFromMesh;
    const Vec3 moved = Vec3(place[3]) - origin + Mat3(place) * mesh.origin();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.vertexCount()));
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(uint32_t), mesh.triangleCount()));
    for (size_t v = 0; v < mesh.vertexCount(); ++v)
        vertices[v] = Vec3f(scale * (moved + Mat3(place) * Vec3(mesh.positions()[v])));
    std::copy(mesh.indices().begin(), mesh.indices().end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(target, geometry, number);
    rtcReleaseGeometry(geometry);
}

/// Embree's normal is (v1 − v0) × (v2 − v0): a face is a front face where the normal points against the ray; the opposite for
/// mirrored instances.
void rejectBackFaces(const RTCFilterFunctionNArguments* arguments) {
    const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    const auto* scene = static_cast<const Scene*>(arguments->geometryUserPtr);
    const Mat3 linear(scene->instances()[hit->geomID].worldFromMesh);
    const double facing = double(hit->Ng_x) * ray->dir_x + double(hit->Ng_y) * ray->dir_y + double(hit->Ng_z) * ray->dir_z;
    const double mirrored = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    if (facing * mirrored >= 0.0) arguments->valid[0] = 0;
}

/// Notes the smallest numbers of what a ray meets, and lets it pass.
struct SmallestNumber {
    RTCIntersectContext context;  // first: Embree hands on a pointer to it
    uint32_t instance = RTC_INVALID_GEOMETRY_ID, triangle = RTC_INVALID_GEOMETRY_ID;
};

void noteSmallest(const RTCFilterFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    auto* smallest = reinterpret_cast<SmallestNumber*>(arguments->context);
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    if (std::pair(hit->geomID, hit->primID) < std::pair(smallest->instance, smallest->triangle))
        smallest->instance = hit->geomID, smallest->triangle = hit->primID;
    arguments->valid[0] = 0;
}

/// A power of two that brings a direction's largest component to about 1: Embree refuses lengths of 1e19 and rounds those of
/// 1e-19 away. Distances along it are divided by it.
double stretchToUnit(const Vec3& direction) {
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    return largest > 0.0 && std::isfinite(largest) ? std::exp2(-std::ilogb(largest)) : 1.0;
}

RTCRayHit rayOf(const Vec3& from, const Vec3& direction, double nearest, double farthest) {
    RTCRayHit ray{};
    ray.ray.org_x = float(from.x), ray.ray.org_y = float(from.y), ray.ray.org_z = float(from.z);
    ray.ray.dir_x = float(direction.x), ray.ray.dir_y = float(direction.y), ray.ray.dir_z = float(direction.z);
    ray.ray.tnear = float(nearest);
    ray.ray.tfar = float(farthest);
    ray.ray.mask = UINT32_MAX;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

}  // namespace

struct SceneRays::Tree {
    const Scene& scene;
    Vec3 origin;
    double scale;
    EmbreeDevicePointer device;
    EmbreeScenePointer rtc;

    [[nodiscard]] Vec3 inside(const Vec3& point) const { return scale * (point - origin); }
};

SceneRays::SceneRays(const Scene& scene, const Vec3& origin, const std::function<bool(uint32_t)>& frontOnly,
                     const Progress& progress) {
    EmbreeDevicePointer device(rtcNewDevice(nullptr));
    EmbreeScenePointer rtc(rtcNewScene(device.get()));
    // Filters that a ray brings along are asked besides those of the triangles.
    rtcSetSceneFlags(rtc.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcSetSceneBuildQuality(rtc.get(), RTC_BUILD_QUALITY_MEDIUM);
    const double scale = scaleToUnit(scene, origin);
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        progress.check();
        addInstance(device.get(), rtc.get(), scene, i, origin, scale);
        if (!frontOnly || scene.meshOf(i).triangleCount() == 0 || !frontOnly(i)) continue;
        RTCGeometry geometry = rtcGetGeometry(rtc.get(), i);
        rtcSetGeometryUserData(geometry, const_cast<Scene*>(&scene));  // only read
        rtcSetGeometryIntersectFilterFunction(geometry, rejectBackFaces);
        rtcCommitGeometry(geometry);
    }
    rtcCommitScene(rtc.get());
    m_tree = std::make_unique<const Tree>(Tree{scene, origin, scale, std::move(device), std::move(rtc)});
}

SceneRays::~SceneRays() = default;

std::optional<SceneRays::Hit> SceneRays::first(const Vec3& from, const Vec3& direction, double nearest, double farthest) const {
    // Distances are scaled with the scene, and against the direction.
    const double stretch = stretchToUnit(direction), scale = m_tree->scale / stretch;
    RTCRayHit ray = rayOf(m_tree->inside(from), stretch * direction, scale * nearest, scale * farthest);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(m_tree->rtc.get(), &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{ray.hit.geomID, ray.hit.primID, double(ray.ray.tfar) / scale};
}

std::optional<SceneRays::Hit> SceneRays::firstByNumber(const Vec3& from, const Vec3& direction) const {
    constexpr double kSame = 1e-5;  // of the distance
    std::optional<Hit> hit = first(from, direction);
    if (!hit) return hit;
    SmallestNumber smallest;
    rtcInitIntersectContext(&smallest.context);
    smallest.context.filter = noteSmallest;
    const double stretch = stretchToUnit(direction), distance = m_tree->scale / stretch * hit->distance;
    RTCRayHit ray = rayOf(m_tree->inside(from), stretch * direction, distance * (1.0 - kSame), distance * (1.0 + kSame));
    rtcIntersect1(m_tree->rtc.get(), &smallest.context, &ray);
    if (smallest.instance != RTC_INVALID_GEOMETRY_ID) hit->instance = smallest.instance, hit->triangle = smallest.triangle;
    return hit;
}

double SceneRays::clearance(const Vec3& point) const {
    struct Asked {
        const Scene& scene;
        Vec3 point;
        double scale;
        double nearest = std::numeric_limits<double>::infinity();
    } asked{m_tree->scene, point, m_tree->scale};
    RTCPointQuery query{};
    const Vec3 inside = m_tree->inside(point);
    query.x = float(inside.x), query.y = float(inside.y), query.z = float(inside.z);
    query.radius = std::numeric_limits<float>::infinity();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto ask = [](RTCPointQueryFunctionArguments* arguments) {
        auto* of = static_cast<Asked*>(arguments->userPtr);
        const InstanceFromEye instance(of->scene, arguments->geomID, of->point);
        const double distance = nearestDistance(instance.corners(arguments->primID));
        if (!(distance < of->nearest)) return false;
        of->nearest = distance;
        // Rounded up: Embree's boxes are floats, and none that holds the nearest triangle may be left out.
        arguments->query->radius = std::nextafter(float(of->scale * distance * 1.0001), HUGE_VALF);
        return true;
    };
    rtcPointQuery(m_tree->rtc.get(), &query, &context, ask, &asked);
    return asked.nearest;
}

}  // namespace cullscope
