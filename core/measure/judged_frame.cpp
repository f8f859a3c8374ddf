// What the raster's snapping explains, and a frame beside the truth.
#include "core/measure/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cullscope {
namespace {

/// A triangle in raster coordinates: corners in pixels (y upward) with their reversed depth in z. Clipped at the near plane it
/// has none, three or four.
struct RasterTriangle {
    std::array<Vec3, 4> corners;
    size_t count = 0;
};

RasterTriangle rasterised(const View& view, const std::array<Vec3, 3>& fromEye) {
    std::array<Vec4, 3> clip;
    for (size_t i = 0; i < 3; ++i) clip[i] = view.clipFromEyeRelative() * Vec4(fromEye[i], 1.0);
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

/// A point of an instance's mesh, from the eye.
Vec3 fromEye(const Scene& scene, const View& view, size_t instance, const Vec3& point) {
    return Vec3(scene.instances()[instance].worldFromMesh * Vec4(point, 1.0)) - view.eye();
}

/// The corners of a scene's triangle, from the eye.
std::array<Vec3, 3> cornersFromEye(const Scene& scene, const View& view, uint64_t triangle) {
    const size_t number = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(number);
    const uint64_t first = 3 * (triangle - scene.firstTriangle(number));
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = fromEye(scene, view, number, mesh.position(mesh.indices()[first + i]));
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

constexpr double kNearAnEdge = 1.0 / 64;
constexpr double kShift = 1.0 / 128;

/// The reversed depth of a triangle's plane at a pixel's centre, and its change from one column and row to the next. In double:
/// a raster's floats err by far more where a triangle is a sliver.
struct DepthOfPlane {
    double depth;
    Vec2 perPixel;
};

DepthOfPlane depthOfPlaneAt(const Scene& scene, const View& view, uint64_t triangle, const Vec2& centre) {
    const std::array<Vec3, 3> corners = cornersFromEye(scene, view, triangle);
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double offset = glm::dot(normal, corners[0]);
    const auto depthAt = [&](double x, double y) { return view.depthOfPlane(normal, offset, x, y); };
    const double depth = depthAt(centre.x, centre.y);
    return {depth, {depthAt(centre.x + 1.0, centre.y) - depth, depthAt(centre.x, centre.y + 1.0) - depth}};
}

/// Whether the plane of a triangle that a raster found nearer is not: that of the other one is nearer at the pixel's centre,
/// meets it within 1/128 pixel of there, where both surfaces are cut, or has a depth that a float does not tell apart, as of
/// polygons in one plane.
bool isNotNearer(const Scene& scene, const View& view, uint64_t nearer, uint64_t other, const Vec2& centre) {
    const DepthOfPlane a = depthOfPlaneAt(scene, view, nearer, centre), b = depthOfPlaneAt(scene, view, other, centre);
    const double gap = a.depth - b.depth;
    return gap <= kTwoRoundings * std::max(a.depth, b.depth) || gap <= kShift * glm::length(a.perPixel - b.perPixel);
}

/// Whether the raster's snapping, the rounding of two depths to float, or that of a sliver's plane, explains that a triangle is
/// shown at a pixel, or is not; `gap` is its depth beside the other's, `depth` the larger of them. `other`: the scene's triangle
/// there in the other picture, counted from 1; 0: none, or not known.
bool snappingExplains(const Scene& scene, const View& view, uint32_t item, uint32_t other, const Vec2& centre, double gap,
                      double depth) {
    if (gap <= kTwoRoundings * depth) return true;
    const RasterTriangle triangle = rasterised(view, cornersFromEye(scene, view, item - 1));
    if (triangle.count > 0 && (distanceToEdges(triangle, centre) <= kNearAnEdge || gap <= kShift * depthPerPixel(triangle)))
        return true;
    if (other == 0) return false;
    const RasterTriangle before = rasterised(view, cornersFromEye(scene, view, other - 1));
    return (before.count > 0 && distanceToEdges(before, centre) <= kNearAnEdge) ||
           isNotNearer(scene, view, item - 1, other - 1, centre);
}

/// The parts of triangles that a frame drew in place of the scene's, by triangle.
class DrawnParts {
public:
    DrawnParts(const Scene& scene, const FrameLog& log) : m_scene(scene) {
        for (const Command& command : log.commands) {
            const auto* const own = std::get_if<OwnTrianglesPointer>(&command);
            if (own == nullptr) continue;
            for (const OwnTriangles::Run& run : (*own)->runs)
                for (uint32_t i = run.first; i < run.first + run.count; ++i)
                    m_parts.push_back({(*own)->triangles[i], run.instance, &(*own)->positions[3 * size_t(i)]});
        }
        std::ranges::sort(m_parts, {}, &Part::triangle);
    }

    /// Whether a pixel's centre lies within 1/64 pixel of an edge of one of a triangle's parts. Where parts meet and only one has
    /// a corner, each is snapped by itself: they may leave a pixel to neither.
    [[nodiscard]] bool edgeNear(const View& view, uint32_t triangle, const Vec2& centre) const {
        const auto first = std::ranges::lower_bound(m_parts, triangle, {}, &Part::triangle);
        const auto end = std::ranges::upper_bound(first, m_parts.end(), triangle, {}, &Part::triangle);
        return std::any_of(first, end, [&](const Part& part) {
            const Vec3 origin = m_scene.meshOf(part.instance).origin();
            std::array<Vec3, 3> corners;
            for (size_t i = 0; i < 3; ++i) corners[i] = fromEye(m_scene, view, part.instance, origin + Vec3(part.corners[i]));
            const RasterTriangle raster = rasterised(view, corners);
            return raster.count > 0 && distanceToEdges(raster, centre) <= kNearAnEdge;
        });
    }

private:
    struct Part {
        uint32_t triangle, instance;
        const Vec3f* corners;
    };
    const Scene& m_scene;
    std::vector<Part> m_parts;
};

/// The centre of a tile's pixel in the whole picture.
Vec2 centreOf(size_t pixel, const PictureTile& tile) {
    const auto width = static_cast<size_t>(tile.size.width);
    return {double(tile.x) + double(pixel % width) + 0.5, double(tile.y) + double(pixel / width) + 0.5};
}

/// What a picture shows at a pixel as a triangle of the scene, counted from 1; 0: nothing, not known, or surfaces in place of the
/// scene's.
uint32_t sceneTriangleAt(const ShownPixels& shown, size_t pixel) {
    return shown.triangle.empty() || shown.objects ? 0 : shown.triangle[pixel];
}

}  // namespace

std::vector<uint32_t> pixelsMissedBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene,
                                                 const View& view, const std::optional<PictureTile>& tile) {
    const PictureTile part = tile.value_or(PictureTile{0, 0, view.viewport()});
    std::vector<uint32_t> beyond;
    for (size_t pixel = 0; pixel < shown.depth.size(); ++pixel) {
        if (pixelDifference(reference, shown, pixel) != PixelDifference::Missed || reference.triangle[pixel] == 0) continue;
        const double gap = double(reference.depth[pixel]) - double(shown.depth[pixel]);
        const uint32_t other = sceneTriangleAt(shown, pixel);
        const Vec2 centre = centreOf(pixel, part);
        if (!snappingExplains(scene, view, reference.triangle[pixel], other, centre, gap, reference.depth[pixel]))
            beyond.push_back(uint32_t(pixel));
    }
    return beyond;
}

std::vector<uint32_t> pixelsMissedBeyondSnapping(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log,
                                                 const Reference& reference, const ShownPixels& shown, const PictureTile& tile) {
    const View view(log.camera, log.size);
    std::vector<uint32_t> beyond = pixelsMissedBeyondSnapping(reference, shown, buffers.scene(), view, tile);
    if (!beyond.empty() && shown.triangle.empty()) {
        const ShownPixels named{shown.depth, renderer.drawItemBuffer(buffers, view, log, tile).triangle, {}};
        beyond = pixelsMissedBeyondSnapping(reference, named, buffers.scene(), view, tile);
    }
    if (beyond.empty() || log.drawsScene()) return beyond;
    const DrawnParts parts(buffers.scene(), log);
    std::erase_if(beyond,
                  [&](uint32_t pixel) { return parts.edgeNear(view, reference.triangle[pixel] - 1, centreOf(pixel, tile)); });
    return beyond;
}

std::vector<uint32_t> trianglesAt(const Reference& reference, const std::vector<uint32_t>& pixels) {
    std::vector<uint32_t> triangles;
    for (const uint32_t pixel : pixels)
        if (reference.triangle[pixel] != 0) triangles.push_back(reference.triangle[pixel] - 1);
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
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
        const Vec2 centre = centreOf(pixel, {0, 0, view.viewport()});
        if (!snappingExplains(scene, view, shown.triangle[pixel], other, centre, gap, shown.depth[pixel])) ++beyond;
    }
    return beyond;
}

std::vector<Hole> JudgedFrame::holes(const Viewport& size) const {
    if (lost.empty()) return {};
    std::vector<uint8_t> mask(size_t(size.width) * size_t(size.height));
    for (const uint32_t pixel : lost) mask[pixel] = 1;
    return cullscope::holes(std::move(mask), size);
}

JudgedFrame judge(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, const Reference& reference,
                  Framebuffer& target) {
    const Scene& scene = buffers.scene();
    JudgedFrame judged;
    judged.shown = shownPixels(renderer, buffers, log, target);
    judged.accuracy = compare(reference, judged.shown, drawnTriangles(scene, log), scene);
    judged.ownRaster = !log.drawsScene();
    if (snappingMayExplain(log, reference.facing)) {
        const View view(log.camera, log.size);
        judged.lost = pixelsMissedBeyondSnapping(renderer, buffers, log, reference, judged.shown, target.tile());
        judged.missedBeyondSnapping = judged.lost.size();
        judged.lostTriangles = trianglesAt(reference, judged.lost);
        if (judged.ownRaster) judged.extraBeyondSnapping = extraBeyondSnapping(reference, judged.shown, scene, view);
    } else if (judged.accuracy.missedPixels > 0) {
        const std::vector<uint8_t> missed = missedMask(reference, judged.shown);
        for (size_t pixel = 0; pixel < missed.size(); ++pixel)
            if (missed[pixel] != 0) judged.lost.push_back(uint32_t(pixel));
    }
    const std::vector<Hole> holes = judged.holes(reference.size);
    judged.accuracy.largestHolePixels = holes.empty() ? 0 : holes.front().pixels;
    return judged;
}

bool snappingMayExplain(const FrameLog& log, Facing truth) { return !log.drawsScene() || log.facing != truth; }

TriangleStates judgedStates(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, Facing truth) {
    const Reference reference = itemBufferReference(renderer, buffers, View(log.camera, log.size), truth);
    Framebuffer target(log.size);
    const JudgedFrame judged = judge(renderer, buffers, log, reference, target);
    return triangleStates(buffers.scene(), log, reference.visible(), judged.lostTriangles);
}

}  // namespace cullscope
