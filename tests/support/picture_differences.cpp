#include "tests/support/picture_differences.h"

#include <array>
#include <cmath>
#include <numeric>

#include "core/spatial/screen_polygon.h"
#include "tests/support/pixel_edges.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {
namespace {

/// One over the forward distance of a triangle's plane at a pixel, as a linear function of the picture.
Vec3 inverseOf(const Scene& scene, const View& view, uint32_t triangle) {
    const size_t instance = scene.instanceOf(triangle);
    const TriangleMesh& mesh = scene.meshOf(instance);
    std::vector<Vec3> corners;
    for (size_t i = 0; i < 3; ++i) {
        const size_t index = mesh.indices()[3 * (triangle - scene.firstTriangle(instance)) + i];
        corners.push_back(Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.position(index), 1.0)) - view.eye());
    }
    return ScreenProjection(view)
        .project(corners, glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])))
        .inverse;
}

/// OpenGL's planes of depth go through corners in 32-bit floats: those of up to 512 pixels are rounded to 2^-15 pixel, and by as
/// much in each of the few operations before. So each plane may be moved by this.
constexpr double kRoundedPixels = 0x1p-12;

/// Whether an edge of a part of a scene triangle, as a frame draws it, passes a pixel's centre within kEdgePixels.
bool isAtEdgeOfPart(const Scene& scene, const View& view, const OwnTriangles& own, uint32_t triangle, size_t pixel) {
    const size_t instance = scene.instanceOf(triangle);
    std::vector<Vec3f> corners;
    for (size_t i = 0; i < own.triangles.size(); ++i)
        if (own.triangles[i] == triangle)
            corners.insert(corners.end(), own.positions.begin() + long(3 * i), own.positions.begin() + long(3 * i + 3));
    if (corners.empty()) return false;
    std::vector<uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    const Mat4 place = scene.instances()[instance].worldFromMesh * translation(scene.meshOf(instance).origin());
    const ScenePointer parts = sceneOf({meshOf(std::move(corners), std::move(indices))}, {place});
    const PixelEdges edges(*parts, view.camera(), view.viewport());
    for (uint64_t part = 0; part < parts->triangleCount(); ++part)
        if (edges.toEdgeOf(part, pixel) <= kEdgePixels) return true;
    return false;
}

bool isAtCut(const Scene& scene, const View& view, const FrameLog& log, const std::array<uint32_t, 2>& numbers, size_t pixel) {
    for (const Command& command : log.commands)
        if (const auto* own = std::get_if<OwnTrianglesPointer>(&command))
            for (const uint32_t number : numbers)
                if (number != 0 && isAtEdgeOfPart(scene, view, **own, number - 1, pixel)) return true;
    return false;
}

}  // namespace

PictureDifferences pictureDifferences(const Scene& scene, const View& view, const Reference& truth, const ShownPixels& shown,
                                      const FrameLog& log) {
    const PixelEdges edges(scene, view.camera(), view.viewport());
    const auto width = size_t(view.viewport().width);
    PictureDifferences found;
    for (size_t pixel = 0; pixel < truth.triangle.size(); ++pixel) {
        const uint32_t is = shown.triangle[pixel], should = truth.triangle[pixel];
        if (is == should) continue;
        ++found.pixels;
        if (is != 0 && edges.toEdgeOf(is - 1, pixel) <= kEdgePixels) continue;
        if (should != 0 && edges.toEdgeOf(should - 1, pixel) <= kEdgePixels) continue;
        if (is != 0 && should != 0) {
            const Vec3 a = inverseOf(scene, view, is - 1), b = inverseOf(scene, view, should - 1), d = a - b;
            const Vec3 at(double(pixel % width) + 0.5, double(pixel / width) + 0.5, 1.0);
            if (std::abs(glm::dot(d, at)) <= glm::length(Vec2(d)) * kEdgePixels +
                                                 (glm::length(Vec2(a)) + glm::length(Vec2(b))) * kRoundedPixels +
                                                 0x1p-22 * std::abs(glm::dot(a, at))) {
                ++found.unresolved;
                continue;
            }
        }
        if (isAtCut(scene, view, log, {is, should}, pixel)) {
            ++found.atCuts;
            continue;
        }
        if (++found.unexplained > 3) continue;
        found.first += "pixel " + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + ": shows " +
                       std::to_string(is) + " in place of " + std::to_string(should) + ", depths " +
                       std::to_string(shown.depth[pixel]) + " and " + std::to_string(truth.depth[pixel]) + "\n";
    }
    return found;
}

}  // namespace cullscope::test
