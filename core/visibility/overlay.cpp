#include "core/visibility/overlay.h"

#include <cmath>
#include <numbers>

namespace cullscope {
namespace {

constexpr int kSides = 12;

}  // namespace

double pixelsOf(const View& viewing, const Vec3& place, double length) {
    const Frustum& frustum = viewing.frustum();
    const double distance = glm::dot(place - viewing.eye(), frustum.forward);
    const double height = viewing.viewport().height;
    return frustum.parallel() || distance > length ? 0.5 * height * length / frustum.halfHeightAt(distance) : height;
}

void addMark(std::vector<LineSegment>& lines, const OverlayContext& context, const Vec3& place, double radius, MarkShape shape,
             const Vec3f& colour) {
    const Frustum& frustum = context.viewing.frustum();
    const double distance = glm::dot(place - context.viewing.eye(), frustum.forward);
    if (!(distance > 0.0)) return;
    const double size = radius * context.style.unit * 2.0 * frustum.halfHeightAt(distance) / context.viewing.viewport().height;
    const auto at = [&](double right, double up) { return place + (frustum.right * right + frustum.up * up) * size; };
    if (shape == MarkShape::Cross) {
        lines.push_back({at(-1.0, -1.0), at(1.0, 1.0), colour});
        lines.push_back({at(-1.0, 1.0), at(1.0, -1.0), colour});
        return;
    }
    // A dot is a ring of half the radius with spokes, which fill it however thin its lines are.
    const double ring = shape == MarkShape::Dot ? 0.5 : 1.0;
    const auto onRing = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        return at(ring * std::cos(angle), ring * std::sin(angle));
    };
    for (int i = 0; i < kSides; ++i) {
        lines.push_back({onRing(i), onRing(i + 1), colour});
        if (shape == MarkShape::Dot) lines.push_back({place, onRing(i), colour});
    }
}

void addBox(OverlayLines& overlay, const Box3& box, const Vec3f& colour) {
    const auto corner = [&](int c) {
        return Vec3((c & 1) != 0 ? box.max.x : box.min.x, (c & 2) != 0 ? box.max.y : box.min.y,
                    (c & 4) != 0 ? box.max.z : box.min.z);
    };
    addBoxEdges(overlay, corner, colour);
}

TriangleState stateOfNode(const SnapshotNode& node) {
    if (node.culled) return stateOfCause(node.cause);
    return node.reached ? TriangleState::Visible : TriangleState::Undecided;
}

void addByVerdict(OverlayLines& overlay, const OverlayContext& context, const SnapshotNode& node) {
    addBox(overlay, node.box, context.palette[size_t(stateOfNode(node))].colour);
}

OverlayLines groupOverlay(const OverlayContext& context, const StructureSnapshot& snapshot) {
    OverlayLines overlay{{}, {kBoxLineWidth, true}};
    for (const SnapshotNode& node : snapshot.nodes)
        if (node.isGroup() && node.tested) addByVerdict(overlay, context, node);
    return overlay;
}

}  // namespace cullscope
