#pragma once

#include "core/image/view_picture.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

// Pictures of views as drawViewPicture() makes them, and what is seen in them.
namespace cullscope::test {

inline const DrawStyle kLight{Vec3f(1.0f), 1.0f, Vec3f(0.2f)};

/// At the origin, looking down −z; a square of half size 1 at z = −10 is 10 pixels wide in a picture of 100.
inline Camera downMinusZ() { return {Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}; }

/// The result of drawViewPicture for one strategy, including the cull.
struct Shown {
    std::vector<uint8_t> colour;
    std::vector<float> depth;
    Viewport size;

    [[nodiscard]] Vec3f at(int x, int y) const {
        const uint8_t* pixel = &colour[4 * (size_t(y) * size_t(size.width) + size_t(x))];
        return Vec3f(pixel[0], pixel[1], pixel[2]) / 255.0f;
    }
    /// The position of a world point in pixels.
    [[nodiscard]] static std::pair<int, int> pixelOf(const View& view, const Vec3& point) {
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point - view.eye(), 1.0);
        return {int(std::floor((clip.x / clip.w + 1) / 2 * view.viewport().width)),
                int(std::floor((clip.y / clip.w + 1) / 2 * view.viewport().height))};
    }
    /// Whether a colour occurs in the 3 × 3 pixels around a world point.
    [[nodiscard]] bool near(const View& view, const Vec3& point, const Vec3f& wanted) const {
        const auto [x, y] = pixelOf(view, point);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int px = x + dx, py = y + dy;
                if (px >= 0 && py >= 0 && px < size.width && py < size.height && glm::distance(at(px, py), wanted) < 0.01f)
                    return true;
            }
        return false;
    }
    [[nodiscard]] size_t count(const Vec3f& wanted) const {
        size_t pixels = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) pixels += glm::distance(at(x, y), wanted) < 0.01f ? 1 : 0;
        return pixels;
    }
};

inline Shown shown(const ScenePointer& scene, const char* id, const View& culling, const View& viewing, const ViewLook& look,
                   const DrawStyle& style = {}, const TriangleStates* known = nullptr) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = makeCuller(id);
    strategy->build(*scene);
    const Culled frame =
        strategy->cull(culling, needsDecisions(look) ? Recording::On : Recording::Off, &GlEnvironment::renderer());
    Framebuffer target(viewing.viewport());
    drawViewPicture(GlEnvironment::renderer(), buffers, *strategy->built(), frame.log, viewing, known, look, style, target);
    return {target.readColour(), target.readDepth(), viewing.viewport()};
}

inline ScenePointer field(int n) {
    std::vector<Mat4> places;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) places.push_back(translation({(i - (n - 1) / 2.0) * 2.5, 0, (j - (n - 1) / 2.0) * 2.5}));
    return copiesOf(sphereMesh(320), places);
}

inline Camera inTheField() { return {{0, .5, 4}, {.5, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100}; }
inline Camera above() { return {{3, 18, 22}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 1, 100}; }

}  // namespace cullscope::test
