#include "core/measure/ray_reference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "core/base/error.h"
#include "core/scene/scene_rays.h"

namespace cullscope {
namespace {

/// The corners of one scene triangle relative to the eye, in double.
std::array<Vec3, 3> cornersFromEye(const Scene& scene, size_t instance, uint64_t triangle, const Vec3& eye) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Mat4& place = scene.instances()[instance].worldFromMesh;
    const Vec3 origin = Vec3(place[3]) - eye + Mat3(place) * mesh.origin();
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = origin + Mat3(place) * Vec3(mesh.positions()[mesh.indices()[3 * triangle + i]]);
    return corners;
}

/// The depth of a triangle's plane at a pixel, and its change over one pixel. Reversed depth is affine in pixel coordinates.
struct PlaneDepth {
    double depth;
    double perPixel;
};

PlaneDepth depthOnPlane(const std::array<Vec3, 3>& corners, const View& view, double x, double y) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double c = glm::dot(normal, corners[0]);
    const auto depthAt = [&](double column, double row) { return view.depthOfPlane(normal, c, column, row); };
    const double depth = depthAt(x, y);
    return {depth, std::abs(depthAt(x + 1.0, y) - depth) + std::abs(depthAt(x, y + 1.0) - depth)};
}

}  // namespace

RayReference rayReference(const Scene& scene, const View& view, Facing facing, const Progress& progress) {
    if (scene.triangleCount() > uint64_t{UINT32_MAX} - 1)
        throwUsage(CULLSCOPE_TR("The scene has too many triangles for the ray reference."));
    const SceneRays rays(
        scene, view.eye(), [&](uint32_t instance) { return dropsBacks(scene, instance, facing); }, progress);

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
                // The direction has forward component 1, so that the ray's parameter is the forward distance.
                const double column = double(x) + 0.5, line = double(y) + 0.5;
                const Vec3 from = view.eye() + view.sightOrigin(column, line);
                const std::optional<SceneRays::Hit> hit =
                    rays.first(from, view.direction(column, line), view.camera().nearDistance, view.camera().farDistance);
                if (!hit) continue;
                const size_t pixel = y * width + x;
                const auto corners = cornersFromEye(scene, hit->instance, hit->triangle, view.eye());
                const PlaneDepth plane = depthOnPlane(corners, view, column, line);
                reference.triangle[pixel] = static_cast<uint32_t>(scene.firstTriangle(hit->instance) + hit->triangle + 1);
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
