#include "core/visibility/small_feature/occupancy_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::small_feature {
namespace {

/// Classes below and above the split.
constexpr int kBelow = 7, kAbove = 4;

/// The class of a value: from 0, the first one from 0 and the last one to infinity.
size_t classOf(double value, double split) {
    if (!(value > 0.0)) return 0;
    const double octaves = std::ceil(std::log2(value / split)) - 1.0;
    return size_t(std::clamp(int(std::clamp(octaves, -1e6, 1e6)), -kBelow, kAbove - 1) + kBelow);
}

std::string nameOf(size_t number, double split) {
    const auto edge = [&](size_t i) { return split * std::exp2(double(i) - kBelow); };
    // By the names of the octrees: the split is where S ends and L begins.
    const char* octree = number < kBelow ? "S" : "L";
    if (number == 0) return fmt::format("{}  ≤ {:.3g}", octree, edge(1));
    if (number + 1 == kBelow + kAbove) return fmt::format("{}  > {:.3g}", octree, edge(number));
    return fmt::format("{}  {:.3g} … {:.3g}", octree, edge(number), edge(number + 1));
}

}  // namespace

Show occupancyBarsShow() { return barsShow("occupancy", CULLSCOPE_TR("Components by occupancy value")); }

Bars occupancyBars(std::span<const double> values, double split, const Scene& scene, const FrameLog& log) {
    // Where every component is in the outline, the classes are around the middle value of 1.
    const double divided = split > 0.0 ? split : 1.0;
    struct Class {
        uint64_t components = 0, tooSmall = 0;
    };
    std::array<Class, kBelow + kAbove> classes;
    for (size_t i = 0; i < values.size(); ++i)
        if (scene.meshOf(i).triangleCount() > 0) ++classes[classOf(values[i], divided)].components;
    for (const SnapshotNode& object : objectNodes(log, scene).nodes)
        if (object.culled && object.cause == Cause::TooSmall) ++classes[classOf(values[object.instance], divided)].tooSmall;
    Bars bars;
    for (size_t i = 0; i < classes.size(); ++i) {
        const bool most = 2 * classes[i].tooSmall > classes[i].components;
        bars.bars.push_back(
            {nameOf(i, divided), classes[i].components, most ? std::optional(TriangleState::TooSmall) : std::nullopt});
    }
    return bars;
}

}  // namespace cullscope::small_feature
