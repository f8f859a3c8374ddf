#include "core/frame/submitted.h"

#include <algorithm>

namespace cullscope {
namespace {

/// Adds the triangles of a range that OpenGL draws in an order of their own, as runs of consecutive numbers.
void addOrdered(TriangleIntervals& runs, const DrawList& list, uint32_t mesh, uint64_t first, const DrawRange& range) {
    std::vector<uint32_t> numbers;
    numbers.reserve(range.indexCount / 3);
    for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + uint64_t(range.indexCount)) / 3; ++place)
        numbers.push_back(uint32_t(list.triangleAt(mesh, place)));
    std::ranges::sort(numbers);
    for (const uint32_t number : numbers) {
        if (!runs.empty() && runs.back().second == first + number)
            ++runs.back().second;
        else
            runs.emplace_back(first + number, first + number + 1);
    }
}

}  // namespace

TriangleIntervals submittedIntervals(const Scene& scene, const DrawList& list) {
    TriangleIntervals runs;
    runs.reserve(list.ranges.size());
    for (const DrawRange& range : list.ranges) {
        const uint32_t mesh = scene.instances()[range.instance].mesh;
        const uint64_t first = scene.firstTriangle(range.instance);
        const uint64_t begin = range.firstIndex / 3, end = begin + range.indexCount / 3;
        if (!list.orderOf(mesh).triangles.empty())
            addOrdered(runs, list, mesh, first, range);
        else if (begin < end)
            runs.emplace_back(first + begin, first + end);
    }
    std::ranges::sort(runs);
    TriangleIntervals merged;
    for (const auto& run : runs) {
        if (!merged.empty() && run.first <= merged.back().second)
            merged.back().second = std::max(merged.back().second, run.second);
        else
            merged.push_back(run);
    }
    return merged;
}

uint64_t triangleCount(const TriangleIntervals& intervals) {
    uint64_t count = 0;
    for (const auto& [first, end] : intervals) count += end - first;
    return count;
}

Submitted submittedBy(const Scene& scene, const FrameLog& log) {
    Submitted submitted;
    submitted.triangles = triangleCount(submittedIntervals(scene, drawnTriangles(scene, log)));
    for (const Command& command : log.commands)
        if (const auto* own = std::get_if<OwnTrianglesPointer>(&command)) submitted.fragments += (*own)->triangles.size();
    return submitted;
}

}  // namespace cullscope
