#include "core/visibility/small_feature/outline_overlay.h"

#include "core/base/message.h"

namespace cullscope::small_feature {
namespace {

constexpr float kOutlineWidth = 2.0f;  ///< units
constexpr size_t kMostBoxes = 4000;

Message noOutline(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" keeps no outline. Keeping one: %3.", {option, strategy, having}};
}

}  // namespace

Show outlineShow() {
    Show show;
    show.id = kOutlineShow;
    show.help = "of small-feature: the outline's components, and the others by verdict, as boxes";
    show.title = CULLSCOPE_TR("Outline and details");
    show.action = CULLSCOPE_TR("&Outline and details");
    show.explanation = CULLSCOPE_TR(
        "Show in the active view the boxes of the components that are always kept, and those of the others by what became of "
        "them");
    show.legend = {TriangleState::Visible, TriangleState::TooSmall};
    show.contrastWords = CULLSCOPE_TR("outline: always kept");
    show.absent = noOutline;
    return show;
}

std::vector<OverlayLines> outlineOverlay(const OverlayContext& context, const FrameLog& log,
                                         const std::function<OutlineLeaf(uint32_t)>& leafOf) {
    std::vector<const Decision*> leaves;
    size_t components = 0;
    for (const Decision& decision : log.decisions) {
        const bool left = decision.outcome == Decision::Outcome::Culled && decision.cause == Cause::TooSmall;
        if (decision.subject.kind != Subject::Kind::Node || (!left && decision.outcome != Decision::Outcome::Drawn)) continue;
        leaves.push_back(&decision);
        components += decision.objectCount;
    }
    // The outline comes last, so that it is over the details.
    OverlayLines details{{}, {kBoxLineWidth, true}}, outline{{}, {kOutlineWidth, true}};
    for (const Decision* decision : leaves) {
        const OutlineLeaf leaf = leafOf(decision->subject.number);
        const TriangleState state =
            decision->outcome == Decision::Outcome::Drawn ? TriangleState::Visible : TriangleState::TooSmall;
        const Vec3f colour = leaf.ofOutline ? context.contrast : context.palette[size_t(state)].colour;
        OverlayLines& lines = leaf.ofOutline ? outline : details;
        if (components > kMostBoxes)
            addBox(lines, leaf.box, colour);
        else
            for (const uint32_t instance : log.objectsOf(*decision)) addBox(lines, context.scene.instanceBox(instance), colour);
    }
    return {std::move(details), std::move(outline)};
}

}  // namespace cullscope::small_feature
