#include "core/measure/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
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

/// A triangle in raster coordinates: corners in pixels (y upward) with their reversed depth in z. Clipped at the near plane it
/// has none, three or four.
struct RasterTriangle {
    std::array<Vec3, 4> corners;
    size_t count = 0;
};

RasterTriangle rasterised(const Scene& scene, const View& view, uint64_t triangle) {
    const size_t number = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(number);
    const uint64_t first = 3 * (triangle - scene.firstTriangle(number));
    std::array<Vec4, 3> clip;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 world(scene.instances()[number].worldFromMesh * Vec4(mesh.position(mesh.indices()[first + i]), 1.0));
        clip[i] = view.clipFromEyeRelative() * Vec4(world - view.eye(), 1.0);
    }
    RasterTriangle result;
    const auto add = [&](const Vec4& corner) {
        result.corners[result.count++] = {(corner.x / corner.w + 1.0) * 0.5 * view.viewport().width,
                                          (corner.y / corner.w + 1.0) * 0.5 * view.viewport().height, corner.z / corner.w};
    };
    for (size_t i = 0; i < 3; ++i) {
        const Vec4 &here = clip[i], &next = clip[(i + 1) % 3];
        const double d = here.w - here.z, e = next.w - next.z;  // how far before the near plane
        if (d >= 0.0) add(here);
        if ((d >= 0.0) != (e >= 0.0)) add(here + (next - here) * (d / (d - e)));
    }
    return result;
}

double distanceToSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::length(point - a - along * t);
}

double distanceToEdges(const RasterTriangle& triangle, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < triangle.count; ++i)
        nearest = std::min(nearest,
                           distanceToSegment(point, Vec2(triangle.corners[i]), Vec2(triangle.corners[(i + 1) % triangle.count])));
    return nearest;
}

/// An upper bound on the change of the depth of the triangle's plane over one pixel: |∂z/∂x| + |∂z/∂y|.
double depthPerPixel(const RasterTriangle& triangle) {
    const auto& [a, b, c, d] = triangle.corners;
    const Vec3 normal = glm::cross(b - a, c - a);
    return (std::abs(normal.x) + std::abs(normal.y)) / std::abs(normal.z);
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

namespace {

/// Of a depth: two units in the last place of a float.
constexpr double kTwoRoundings = 0x1p-22;

}  // namespace

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

/// The same of triangles as `compare` counts them, by object: `given` is what was drawn.
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

std::vector<LostObject> lostObjects(const Scene& scene, const Reference& reference, const std::vector<uint8_t>& missed) {
    std::vector<uint32_t> pixels;
    for (size_t i = 0; i < missed.size(); ++i)
        if (missed[i] != 0) pixels.push_back(uint32_t(i));
    return lostObjects(scene, reference, pixels);
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

namespace {

constexpr double kNearAnEdge = 1.0 / 64;
constexpr double kShift = 1.0 / 128;

/// The reversed depth of a triangle's plane at a pixel's centre, and its change from one column and row to the next. In double:
/// a raster's floats err by far more where a triangle is a sliver.
struct DepthOfPlane {
    double depth;
    Vec2 perPixel;
};

DepthOfPlane depthOfPlaneAt(const Scene& scene, const View& view, uint64_t triangle, const Vec2& centre) {
    const size_t number = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(number);
    const uint64_t first = 3 * (triangle - scene.firstTriangle(number));
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i)
        corners[i] =
            Vec3(scene.instances()[number].worldFromMesh * Vec4(mesh.position(mesh.indices()[first + i]), 1.0)) - view.eye();
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double offset = glm::dot(normal, corners[0]);
    const auto depthAt = [&](double x, double y) { return view.depthOfPlane(normal, offset, x, y); };
    const double depth = depthAt(centre.x, centre.y);
    return {depth, {depthAt(centre.x + 1.0, centre.y) - depth, depthAt(centre.x, centre.y + 1.0) - depth}};
}

/// Whether two triangles' planes meet within 1/128 pixel of a pixel's centre, where both surfaces are cut, or have depths there
/// that a float does not tell apart, as polygons in one plane.
bool planesMeetAt(const Scene& scene, const View& view, uint64_t one, uint64_t other, const Vec2& centre) {
    const DepthOfPlane a = depthOfPlaneAt(scene, view, one, centre), b = depthOfPlaneAt(scene, view, other, centre);
    const double gap = std::abs(a.depth - b.depth);
    return gap <= kTwoRoundings * std::max(a.depth, b.depth) || gap <= kShift * glm::length(a.perPixel - b.perPixel);
}

/// Whether the raster's snapping, or the rounding of two depths to float, explains that a triangle is shown at a pixel, or is
/// not; `gap` is its depth beside the other's, `depth` the larger of them. `other`: the scene's triangle there in the other
/// picture, counted from 1; 0: none, or not known.
bool snappingExplains(const Scene& scene, const View& view, uint32_t item, uint32_t other, size_t pixel, double gap,
                      double depth) {
    if (gap <= kTwoRoundings * depth) return true;
    const auto width = static_cast<size_t>(view.viewport().width);
    const RasterTriangle triangle = rasterised(scene, view, item - 1);
    const Vec2 centre(double(pixel % width) + 0.5, double(pixel / width) + 0.5);
    if (triangle.count > 0 && (distanceToEdges(triangle, centre) <= kNearAnEdge || gap <= kShift * depthPerPixel(triangle)))
        return true;
    if (other == 0) return false;
    const RasterTriangle before = rasterised(scene, view, other - 1);
    return (before.count > 0 && distanceToEdges(before, centre) <= kNearAnEdge) ||
           planesMeetAt(scene, view, item - 1, other - 1, centre);
}

/// What a picture shows at a pixel as a triangle of the scene, counted from 1; 0: nothing, not known, or surfaces in place of the
/// scene's.
uint32_t sceneTriangleAt(const ShownPixels& shown, size_t pixel) {
    return shown.triangle.empty() || shown.objects ? 0 : shown.triangle[pixel];
}

}  // namespace

std::vector<uint32_t> pixelsMissedBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene,
                                                 const View& view) {
    std::vector<uint32_t> beyond;
    for (size_t pixel = 0; pixel < shown.depth.size(); ++pixel) {
        if (pixelDifference(reference, shown, pixel) != PixelDifference::Missed || reference.triangle[pixel] == 0) continue;
        const double gap = double(reference.depth[pixel]) - double(shown.depth[pixel]);
        const uint32_t other = sceneTriangleAt(shown, pixel);
        if (!snappingExplains(scene, view, reference.triangle[pixel], other, pixel, gap, reference.depth[pixel]))
            beyond.push_back(uint32_t(pixel));
    }
    return beyond;
}

uint64_t missedBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene, const View& view) {
    return pixelsMissedBeyondSnapping(reference, shown, scene, view).size();
}

uint64_t extraBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene, const View& view) {
    uint64_t beyond = 0;
    for (size_t pixel = 0; pixel < shown.triangle.size(); ++pixel) {
        if (pixelDifference(reference, shown, pixel) != PixelDifference::Extra || shown.triangle[pixel] == 0) continue;
        const double gap = double(shown.depth[pixel]) - double(reference.depth[pixel]);
        const uint32_t other = shown.objects ? 0 : reference.triangle[pixel];
        if (!snappingExplains(scene, view, shown.triangle[pixel], other, pixel, gap, shown.depth[pixel])) ++beyond;
    }
    return beyond;
}

JudgedFrame judge(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, const Reference& reference,
                  Framebuffer& target) {
    const Scene& scene = buffers.scene();
    JudgedFrame judged;
    judged.shown = shownPixels(renderer, buffers, log, target);
    judged.accuracy = compare(reference, judged.shown, drawnTriangles(scene, log), scene);
    judged.ownRaster = !log.drawsScene();
    if (judged.ownRaster || log.facing != reference.facing) {
        const View view(log.camera, log.size);
        judged.lost = pixelsMissedBeyondSnapping(reference, judged.shown, scene, view);
        judged.missedBeyondSnapping = judged.lost.size();
        if (judged.ownRaster) judged.extraBeyondSnapping = extraBeyondSnapping(reference, judged.shown, scene, view);
    } else if (judged.accuracy.missedPixels > 0) {
        const std::vector<uint8_t> missed = missedMask(reference, judged.shown);
        for (size_t pixel = 0; pixel < missed.size(); ++pixel)
            if (missed[pixel] != 0) judged.lost.push_back(uint32_t(pixel));
    }
    return judged;
}

}  // namespace cullscope
