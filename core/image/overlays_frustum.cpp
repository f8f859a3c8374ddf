// The culling camera's frustum and its eye.

#include <algorithm>

#include "core/image/overlays.h"

namespace cullscope {
namespace {

// Widths and radii in units.
constexpr float kFrustumWidth = 1.5f;
constexpr float kEyeWidth = 2.0f;
constexpr double kEyeRadius = 6.0;

/// The forward distance at which the frustum's lines end: the far plane or the scene's farthest corner, whichever is nearer; at
/// least a tenth of the scene's size, also where the scene lies behind the eye.
double cutDistance(const Frustum& frustum, const Vec3& eye, const Box3& bounds) {
    double farthest = 0.1 * bounds.diagonal();
    for (int corner = 0; corner < 8 && !bounds.empty(); ++corner) {
        const Vec3 point((corner & 1) != 0 ? bounds.max.x : bounds.min.x, (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                         (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
        farthest = std::max(farthest, glm::dot(point - eye, frustum.forward));
    }
    return std::clamp(farthest, frustum.nearDistance, frustum.farDistance);
}

std::vector<LineSegment> frustumLines(const View& culling, const Scene& scene, const Vec3f& colour) {
    const std::array<Vec3, 8> corners = shownFrustum(culling, scene).corners();
    std::vector<LineSegment> lines;
    const auto add = [&](size_t a, size_t b) {
        lines.push_back({culling.eye() + corners[a], culling.eye() + corners[b], colour});
    };
    for (size_t i = 0; i < 4; ++i) {
        add(i, (i + 1) % 4);
        add(i, i + 4);
        add(i + 4, (i + 1) % 4 + 4);
    }
    return lines;
}

}  // namespace

Frustum shownFrustum(const View& culling, const Scene& scene) {
    Frustum frustum = culling.frustum();
    frustum.farDistance = cutDistance(frustum, culling.eye(), scene.bounds());
    return frustum;
}

std::vector<OverlayLines> frustumOverlay(const OverlayContext& context, const View& culling) {
    const OverlayLines volume{frustumLines(culling, context.scene, context.contrast), {kFrustumWidth, true}, true};
    if (culling.frustum().parallel()) return {volume};
    OverlayLines eye{{}, {kEyeWidth, false}, true};
    // A dot in the ring; none where the eye lies behind the viewing camera.
    addMark(eye.lines, context, culling.eye(), kEyeRadius, MarkShape::Ring, context.contrast);
    if (!eye.lines.empty()) eye.lines.push_back({culling.eye(), culling.eye(), context.contrast});
    return {volume, std::move(eye)};
}

}  // namespace cullscope
