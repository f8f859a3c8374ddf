// The planes of the culling camera's frustum in one colour each, and the boxes in the colour of the plane that rejected them.

#include "core/image/overlays.h"

namespace cullscope {
namespace {

// Widths in units.
constexpr float kRejectedWidth = 2.0f;
constexpr float kKeptWidth = 1.0f;
constexpr float kPlaneWidth = 2.5f;
/// The distance of a plane's outline from its face's border, as a share of the way to the face's middle.
constexpr double kInset = 0.06;

/// Corners of each face in the order of FrustumPlane, as Frustum::corners numbers them.
constexpr std::array<std::array<size_t, 4>, kFrustumPlaneCount> kFaces{
    {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};

}  // namespace

std::vector<OverlayLines> boxOverlayByPlane(const OverlayContext& context, const StructureSnapshot& snapshot) {
    OverlayLines kept{{}, {kKeptWidth, true}}, rejected{{}, {kRejectedWidth, true}};
    for (const SnapshotNode& node : snapshot.nodes) {
        if (node.isGroup() && !node.tested) continue;
        if (node.culled && node.rejectedBy)
            addBox(rejected, node.box, context.planes[size_t(*node.rejectedBy)]);
        else
            addBox(kept, node.box, context.palette[size_t(stateOfNode(node))].colour);
    }
    return {std::move(kept), std::move(rejected)};
}

OverlayLines planeOverlay(const OverlayContext& context, const View& culling) {
    OverlayLines overlay{{}, {kPlaneWidth, true}, true};
    const std::array<Vec3, 8> corners = shownFrustum(culling, context.scene).corners();
    for (size_t plane = 0; plane < kFaces.size(); ++plane) {
        std::array<Vec3, 4> face;
        Vec3 middle(0.0);
        for (size_t i = 0; i < face.size(); ++i) middle += 0.25 * (face[i] = culling.eye() + corners[kFaces[plane][i]]);
        for (Vec3& corner : face) corner += kInset * (middle - corner);
        for (size_t i = 0; i < face.size(); ++i)
            overlay.lines.push_back({face[i], face[(i + 1) % face.size()], context.planes[plane]});
    }
    return overlay;
}

}  // namespace cullscope
