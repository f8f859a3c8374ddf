// The boxes that a strategy tests: of objects, and of groups of them.

#include "core/image/overlays.h"

namespace cullscope {
namespace {

constexpr float kBoxWidth = 1.0f;  ///< units; narrower lines show gaps

void addByVerdict(OverlayLines& overlay, const OverlayContext& context, const SnapshotNode& node) {
    const TriangleState state = node.culled ? stateOfCause(node.cause) : TriangleState::Visible;
    addBox(overlay, node.box, context.palette[size_t(state)].colour);
}

}  // namespace

void addBox(OverlayLines& overlay, const Box3& box, const Vec3f& colour) {
    const auto corner = [&](int c) {
        return Vec3((c & 1) != 0 ? box.max.x : box.min.x, (c & 2) != 0 ? box.max.y : box.min.y,
                    (c & 4) != 0 ? box.max.z : box.min.z);
    };
    for (int from = 0; from < 8; ++from)
        for (const int axis : {1, 2, 4})
            if ((from & axis) == 0) overlay.lines.push_back({corner(from), corner(from | axis), colour});
}

bool wasTested(const SnapshotNode& group, const StructureSnapshot& snapshot) {
    return group.parent < 0 || snapshot.nodes[size_t(group.parent)].containment == Containment::Straddles;
}

OverlayLines boxOverlay(const OverlayContext& context, const StructureSnapshot& snapshot) {
    OverlayLines overlay{{}, {kBoxWidth, true}};
    overlay.lines.reserve(snapshot.nodes.size() * 12);
    for (const SnapshotNode& node : snapshot.nodes)
        if (!node.isGroup()) addByVerdict(overlay, context, node);
    return overlay;
}

OverlayLines groupOverlay(const OverlayContext& context, const StructureSnapshot& snapshot) {
    OverlayLines overlay{{}, {kBoxWidth, true}};
    for (const SnapshotNode& node : snapshot.nodes)
        if (node.isGroup() && wasTested(node, snapshot)) addByVerdict(overlay, context, node);
    return overlay;
}

}  // namespace cullscope
