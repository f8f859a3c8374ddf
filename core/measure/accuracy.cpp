#include "core/measure/accuracy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "core/frame/submitted.h"
#include "core/measure/field_figures.h"

namespace cullscope {
namespace {

uint64_t countMembers(const std::vector<uint32_t>& ascending, const TriangleIntervals& intervals) {
    uint64_t members = 0;
    auto interval = intervals.begin();
    for (const uint32_t triangle : ascending) {
        while (interval != intervals.end() && interval->second <= triangle) ++interval;
        if (interval != intervals.end() && interval->first <= triangle) ++members;
    }
    return members;
}

}  // namespace

ShownPixels shownPixels(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, Framebuffer& target) {
    const View view(log.camera, log.size);
    if (!log.drawsScene()) {
        Renderer::ItemBuffer items = renderer.drawItemBuffer(buffers, view, log, target.tile());
        return {std::move(items.depth), std::move(items.triangle),
                log.grain() == Grain::Object ? buffers.scenePointer() : nullptr};
    }
    renderer.draw(buffers, view, log, target);
    return {target.readDepth(), {}, {}};
}

PixelDifference pixelDifference(const Reference& reference, const ShownPixels& shown, size_t pixel) {
    const float truth = reference.depth[pixel], depth = shown.depth[pixel];
    if (shown.triangle.empty()) return pixelDifference(truth, depth);
    if (shown.objects && shown.triangle[pixel] != reference.triangle[pixel])
        return pixelDifference(truth, comparedItem(*shown.objects, Grain::Object, reference.triangle[pixel]), depth,
                               comparedItem(*shown.objects, Grain::Object, shown.triangle[pixel]));
    return pixelDifference(truth, reference.triangle[pixel], depth, shown.triangle[pixel]);
}

PixelDifference pixelDifference(float truth, uint32_t should, float depth, uint32_t is) {
    if (is == should) return PixelDifference::None;
    const bool unresolved =
        is != 0 && should != 0 && std::abs(double(truth) - double(depth)) <= kTwoRoundings * double(std::max(truth, depth));
    return unresolved ? PixelDifference::Unresolved : pixelDifference(truth, depth);
}

namespace {

/// The triangles that `compare` counts, by object.
void countByObject(Accuracy& accuracy, const Reference& reference, const DrawList& drawn, const Scene& scene) {
    TriangleIntervals objects;
    for (const DrawRange& range : drawn.ranges)
        objects.emplace_back(scene.firstTriangle(range.instance), scene.firstTriangle(range.instance + 1));
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    accuracy.falselyCulledTriangles = accuracy.visibleTriangles - countMembers(reference.visibleTriangles, objects);
    for (const DrawRange& range : drawn.ranges) {
        const auto first = std::ranges::lower_bound(reference.visibleTriangles, uint32_t(scene.firstTriangle(range.instance)));
        const bool seen = first != reference.visibleTriangles.end() && *first < scene.firstTriangle(range.instance + 1);
        if (!seen) accuracy.needlesslyDrawnTriangles += range.indexCount / 3;
    }
}

}  // namespace

Accuracy compare(const Reference& reference, const ShownPixels& shown, const DrawList& drawn, const Scene& scene) {
    Accuracy accuracy;
    accuracy.coveredPixels = reference.coveredPixels;
    for (size_t i = 0; i < shown.depth.size(); ++i) {
        const PixelDifference difference = pixelDifference(reference, shown, i);
        if (difference == PixelDifference::Extra) ++accuracy.extraPixels;
        if (difference == PixelDifference::Unresolved) ++accuracy.unresolvedPixels;
    }
    std::vector<uint8_t> mask = missedMask(reference, shown);
    accuracy.missedPixels = static_cast<uint64_t>(std::count(mask.begin(), mask.end(), uint8_t{1}));
    if (accuracy.missedPixels > 0) accuracy.largestHolePixels = holes(std::move(mask), reference.size).front().pixels;

    const TriangleIntervals given = submittedIntervals(scene, drawn);
    countForFieldFigures(accuracy, reference, shown, given, scene);
    accuracy.submittedTriangles = triangleCount(given);
    accuracy.visibleTriangles = reference.visibleTriangles.size();
    if (shown.objects) {
        countByObject(accuracy, reference, drawn, scene);
        return accuracy;
    }
    const uint64_t visibleAndDrawn = countMembers(reference.visibleTriangles, given);
    accuracy.falselyCulledTriangles = accuracy.visibleTriangles - visibleAndDrawn;
    accuracy.needlesslyDrawnTriangles = accuracy.submittedTriangles - visibleAndDrawn;
    return accuracy;
}

std::vector<uint8_t> missedMask(const Reference& reference, const ShownPixels& shown) {
    std::vector<uint8_t> mask(shown.depth.size());
    for (size_t i = 0; i < mask.size(); ++i) mask[i] = pixelDifference(reference, shown, i) == PixelDifference::Missed ? 1 : 0;
    return mask;
}

std::vector<LostObject> lostObjects(const Scene& scene, const Reference& reference, const std::vector<uint32_t>& pixels) {
    std::map<uint32_t, uint64_t> counts;
    for (const uint32_t pixel : pixels)
        if (reference.triangle[pixel] != 0) ++counts[uint32_t(scene.instanceOf(reference.triangle[pixel] - 1))];
    std::vector<LostObject> objects;
    for (const auto& [instance, count] : counts) objects.push_back({instance, count});
    std::ranges::stable_sort(objects, std::ranges::greater(), &LostObject::pixels);
    return objects;
}

std::vector<Hole> holes(std::vector<uint8_t> mask, const Viewport& size) {
    std::vector<Hole> found;
    std::vector<size_t> open;
    const auto width = static_cast<size_t>(size.width);
    for (size_t start = 0; start < mask.size(); ++start) {
        if (mask[start] == 0) continue;
        Hole hole{static_cast<int>(start % width), static_cast<int>(start / width), 0};
        mask[start] = 0;
        open.push_back(start);
        const auto visit = [&](size_t pixel) {
            if (mask[pixel] == 0) return;
            mask[pixel] = 0;
            open.push_back(pixel);
        };
        while (!open.empty()) {
            const size_t pixel = open.back();
            open.pop_back();
            ++hole.pixels;
            if (pixel % width > 0) visit(pixel - 1);
            if (pixel % width + 1 < width) visit(pixel + 1);
            if (pixel >= width) visit(pixel - width);
            if (pixel + width < mask.size()) visit(pixel + width);
        }
        found.push_back(hole);
    }
    std::stable_sort(found.begin(), found.end(), [](const Hole& a, const Hole& b) { return a.pixels > b.pixels; });
    return found;
}

}  // namespace cullscope
