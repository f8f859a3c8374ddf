// The boxes that a strategy tests: of objects, and of groups of them.

#include "core/measure/overlays.h"

namespace cullscope {
namespace {

constexpr float kBoxWidth = 1.0f;  ///< units; narrower lines have gaps

void addBox(OverlayLines& overlay, const OverlayContext& context, const InsideNode& node) {
    const TriangleState state = node.culled ? stateOfCause(node.cause) : TriangleState::Visible;
    const Vec3f colour = context.palette[size_t(state)].colour;
    const auto corner = [&](int c) {
        return Vec3((c & 1) != 0 ? node.box.max.x : node.box.min.x, (c & 2) != 0 ? node.box.max.y : node.box.min.y,
                    (c & 4) != 0 ? node.box.max.z : node.box.min.z);
    };
    for (int from = 0; from < 8; ++from)
        for (const int axis : {1, 2, 4})
            if ((from & axis) == 0) overlay.lines.push_back({corner(from), corner(from | axis), colour});
}

/// A group within one that was decided as a whole was not tested.
bool wasTested(const InsideNode& group, const Inside& inside) {
    return group.parent < 0 || inside.nodes[size_t(group.parent)].containment == Containment::Straddles;
}

}  // namespace

OverlayLines boxOverlay(const OverlayContext& context, const Inside& inside) {
    OverlayLines overlay{{}, {kBoxWidth, true}};
    overlay.lines.reserve(inside.nodes.size() * 12);
    for (const InsideNode& node : inside.nodes)
        if (!node.isGroup()) addBox(overlay, context, node);
    return overlay;
}

OverlayLines groupOverlay(const OverlayContext& context, const Inside& inside) {
    OverlayLines overlay{{}, {kBoxWidth, true}};
    for (const InsideNode& node : inside.nodes)
        if (node.isGroup() && wasTested(node, inside)) addBox(overlay, context, node);
    return overlay;
}

}  // namespace cullscope
