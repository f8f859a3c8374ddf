#include "core/visibility/small_feature/outline_overlay.h"

#include <algorithm>
#include <functional>

#include "core/base/message.h"
#include "core/gpu/colour.h"

namespace cullscope::small_feature {
namespace {

constexpr float kOutlineWidth = 2.0f;  ///< units
/// More boxes hide what they are about.
constexpr size_t kMostComponents = 150;
/// No place is larger than a node so far below the root.
constexpr uint8_t kLeastDepth = 2;

struct Component {
    Box3 box;
    bool leftOut = false;  ///< for its size
};

/// The leaves below a node that the frame decided about, and the box around those that it left out.
struct LeafCounts {
    uint32_t leftOut = 0, drawn = 0;
    Box3 box;
};

/// The boxes of the largest nodes in which everything that was decided was left out.
std::vector<Box3> leftOutPlaces(const GroupTree& tree, std::vector<LeafCounts> counts) {
    // Parents come before their children.
    for (size_t node = counts.size(); node-- > 1;) {
        const int32_t parent = tree.nodes[node].parent;
        if (parent < 0) continue;
        LeafCounts& above = counts[size_t(parent)];
        above.leftOut += counts[node].leftOut;
        above.drawn += counts[node].drawn;
        above.box.add(counts[node].box);
    }
    const auto isPlace = [&](size_t node) {
        return tree.nodes[node].depth >= kLeastDepth && counts[node].leftOut > 0 && counts[node].drawn == 0;
    };
    std::vector<Box3> places;
    for (size_t node = 0; node < counts.size(); ++node) {
        const bool shallowLeaf = tree.nodes[node].leaf() && counts[node].leftOut > 0;
        if (!isPlace(node) && !shallowLeaf) continue;
        const int32_t parent = tree.nodes[node].parent;
        if (parent < 0 || !isPlace(size_t(parent))) places.push_back(counts[node].box);
    }
    return places;
}

/// The `most` components with the largest boxes.
std::vector<Component> largest(std::vector<Component> components, size_t most) {
    if (components.size() <= most) return components;
    const auto middle = components.begin() + std::ptrdiff_t(most);
    std::ranges::nth_element(components, middle, std::greater<>(), [](const Component& one) { return one.box.diagonal(); });
    components.erase(middle, components.end());
    return components;
}

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
    show.meanings = {{CULLSCOPE_TR("outline: always kept"), contrastTo}};
    show.absent = noOutline;
    return show;
}

std::vector<OverlayLines> outlineOverlay(const OverlayContext& context, const FrameLog& log, const GroupTree& small) {
    std::vector<Component> outline, details;
    std::vector<LeafCounts> leaves(small.nodes.size());
    for (const Decision& decision : log.decisions) {
        const bool left = decision.outcome == Decision::Outcome::Culled && decision.cause == Cause::TooSmall;
        if (decision.subject.kind != Subject::Kind::Node || (!left && decision.outcome != Decision::Outcome::Drawn)) continue;
        const bool ofOutline = decision.subject.number < small.firstNumber;
        for (const uint32_t instance : log.objectsOf(decision))
            (ofOutline ? outline : details).push_back({context.scene.instanceBox(instance), left});
        if (ofOutline) continue;
        LeafCounts& leaf = leaves[decision.subject.number - small.firstNumber];
        leaf.leftOut = left ? 1 : 0;
        leaf.drawn = left ? 0 : 1;
        if (left) leaf.box = small.boxOf(decision.subject.number - small.firstNumber);
    }
    const auto colourOf = [&](TriangleState state) { return context.palette[size_t(state)].colour; };
    // The outline comes last, so that it is over the details.
    OverlayLines detailLines{{}, {kBoxLineWidth, true}}, outlineLines{{}, {kBoxLineWidth, true}};
    if (details.size() <= kMostComponents)
        for (const Component& one : details)
            addBox(detailLines, one.box, colourOf(one.leftOut ? TriangleState::TooSmall : TriangleState::Visible));
    else
        for (const Box3& box : leftOutPlaces(small, std::move(leaves)))
            addBox(detailLines, box, colourOf(TriangleState::TooSmall));
    if (outline.size() <= kMostComponents) outlineLines.style.width = kOutlineWidth;
    for (const Component& one : largest(std::move(outline), kMostComponents))
        addBox(outlineLines, one.box, one.leftOut ? colourOf(TriangleState::TooSmall) : context.contrast);
    return {std::move(detailLines), std::move(outlineLines)};
}

}  // namespace cullscope::small_feature
