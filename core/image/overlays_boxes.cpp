// The boxes of the objects that a strategy tests.

#include "core/image/overlays.h"

namespace cullscope {

OverlayLines boxOverlay(const OverlayContext& context, const StructureSnapshot& snapshot) {
    OverlayLines overlay{{}, {kBoxLineWidth, true}};
    overlay.lines.reserve(snapshot.nodes.size() * 12);
    for (const SnapshotNode& node : snapshot.nodes)
        if (!node.isGroup()) addByVerdict(overlay, context, node);
    return overlay;
}

}  // namespace cullscope
