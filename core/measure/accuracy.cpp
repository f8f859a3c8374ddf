#include "core/measure/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cullscope {
namespace {

/// Ranges of triangle numbers [first, end), ascending and disjoint.
using Intervals = std::vector<std::pair<uint64_t, uint64_t>>;

Intervals submitted(const DrawList& list, const Scene& scene) {
    Intervals runs;
    runs.reserve(list.ranges.size());
    for (const DrawRange& range : list.ranges) {
        const uint32_t mesh = scene.instances()[range.instance].mesh;
        const uint64_t first = scene.firstTriangle(range.instance);
        const uint64_t begin = range.firstIndex / 3, end = begin + range.indexCount / 3;
        if (list.orderOf(mesh).triangles.empty()) {
            if (begin < end) runs.emplace_back(first + begin, first + end);
            continue;
        }
        for (uint64_t place = begin; place < end; ++place) {
            const uint64_t triangle = first + list.triangleAt(mesh, place);
            runs.emplace_back(triangle, triangle + 1);
        }
    }
    std::sort(runs.begin(), runs.end());
    Intervals merged;
    for (const auto& run : runs) {
        if (!merged.empty() && run.first <= merged.back().second)
            merged.back().second = std::max(merged.back().second, run.second);
        else
            merged.push_back(run);
    }
    return merged;
}

uint64_t countMembers(const std::vector<uint32_t>& ascending, const Intervals& intervals) {
    uint64_t members = 0;
    auto interval = intervals.begin();
    for (const uint32_t triangle : ascending) {
        while (interval != intervals.end() && interval->second <= triangle) ++interval;
        if (interval != intervals.end() && interval->first <= triangle) ++members;
    }
    return members;
}

/// A triangle in raster coordinates: corners in pixels (y upward) with their reversed depth in z.
using RasterTriangle = std::array<Vec3, 3>;

/// The projected triangle; none where a corner lies behind the eye.
std::optional<RasterTriangle> rasterised(const Scene& scene, const View& view, uint64_t triangle) {
    const size_t number = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(number);
    const uint64_t first = 3 * (triangle - scene.firstTriangle(number));
    RasterTriangle corners;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 world(scene.instances()[number].worldFromMesh * Vec4(mesh.position(mesh.indices()[first + i]), 1.0));
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(world - view.eye(), 1.0);
        if (!(clip.w > 0.0)) return std::nullopt;
        corners[i] = {(clip.x / clip.w + 1.0) * 0.5 * view.viewport().width,
                      (clip.y / clip.w + 1.0) * 0.5 * view.viewport().height, clip.z / clip.w};
    }
    return corners;
}

double distanceToSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::length(point - a - along * t);
}

double distanceToEdges(const RasterTriangle& triangle, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < 3; ++i)
        nearest = std::min(nearest, distanceToSegment(point, Vec2(triangle[i]), Vec2(triangle[(i + 1) % 3])));
    return nearest;
}

/// An upper bound on the change of the depth of the triangle's plane over one pixel: |∂z/∂x| + |∂z/∂y|.
double depthPerPixel(const RasterTriangle& triangle) {
    const Vec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    return (std::abs(normal.x) + std::abs(normal.y)) / std::abs(normal.z);
}

}  // namespace

Accuracy compare(const Reference& reference, const std::vector<float>& depth, const DrawList& list, const Scene& scene) {
    Accuracy accuracy;
    accuracy.coveredPixels = reference.coveredPixels;
    for (size_t i = 0; i < depth.size(); ++i)
        if (pixelDifference(reference.depth[i], depth[i]) == PixelDifference::Extra) ++accuracy.extraPixels;
    std::vector<uint8_t> mask = missedMask(reference, depth);
    accuracy.missedPixels = static_cast<uint64_t>(std::count(mask.begin(), mask.end(), uint8_t{1}));
    if (accuracy.missedPixels > 0) accuracy.largestHolePixels = holes(std::move(mask), reference.size).front().pixels;

    const Intervals drawn = submitted(list, scene);
    for (const auto& [first, end] : drawn) accuracy.submittedTriangles += end - first;
    accuracy.visibleTriangles = reference.visibleTriangles.size();
    const uint64_t visibleAndDrawn = countMembers(reference.visibleTriangles, drawn);
    accuracy.falselyCulledTriangles = accuracy.visibleTriangles - visibleAndDrawn;
    accuracy.needlesslyDrawnTriangles = accuracy.submittedTriangles - visibleAndDrawn;
    return accuracy;
}

std::vector<uint8_t> missedMask(const Reference& reference, const std::vector<float>& depth) {
    std::vector<uint8_t> mask(depth.size());
    for (size_t i = 0; i < depth.size(); ++i)
        mask[i] = pixelDifference(reference.depth[i], depth[i]) == PixelDifference::Missed ? 1 : 0;
    return mask;
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

uint64_t missedBeyondSnapping(const Reference& reference, const std::vector<float>& depth, const Scene& scene, const View& view) {
    constexpr double kNearAnEdge = 1.0 / 64;
    constexpr double kShift = 1.0 / 128;
    uint64_t beyond = 0;
    const auto width = static_cast<size_t>(reference.size.width);
    for (size_t pixel = 0; pixel < depth.size(); ++pixel) {
        const bool missed = pixelDifference(reference.depth[pixel], depth[pixel]) == PixelDifference::Missed;
        if (!missed || reference.triangle[pixel] == 0) continue;
        const auto triangle = rasterised(scene, view, reference.triangle[pixel] - 1);
        const Vec2 centre(double(pixel % width) + 0.5, double(pixel / width) + 0.5);
        const double gap = double(reference.depth[pixel]) - double(depth[pixel]);
        const bool explained =
            triangle && (distanceToEdges(*triangle, centre) <= kNearAnEdge || gap <= kShift * depthPerPixel(*triangle));
        if (!explained) ++beyond;
    }
    return beyond;
}

}  // namespace cullscope
