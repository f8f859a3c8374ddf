#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/lossless_scenes.h"
#include "tests/support/pixel_edges.h"

namespace cullscope::test {

/// The raster's grid, in pixels.
inline constexpr double kGrid = 1.0 / 256;

/// How a random view lies to an object.
enum Kind { Within, Cutting, Touching, Behind, InSphere, AtCentre, KindCount };
inline constexpr std::array kKindNames{"within", "cutting", "touching", "behind", "in the sphere", "at the centre"};

/// The transform of a mesh by seed: identity, rotated, unevenly scaled, mirrored, flattened (case 30), far away (case 21).
inline Mat4 placeOf(uint64_t seed) {
    Random random(seed * 31 + 5);
    const Vec3 axis = random.direction();
    const Mat4 turn = rotation(axis, random.between(0.0, 6.0));
    switch (seed % 6) {
        case 0:
            return Mat4(1.0);
        case 1:
            return turn;
        case 2:
            return turn * scaling({-1, 1, 1});
        case 3:
            return turn * scaling({1, 1, 0.1});
        case 4:
            return translation({1e6, -1e6, 1e6}) * turn * scaling({0.5, 2, 1});
        default:
            return turn * scaling(Vec3(random.between(0.01, 100.0)));
    }
}

inline Camera aimed(const Vec3& eye, const Vec3& target, double fovyDegrees, double near, double far, const Vec3& up) {
    return {eye, target, up, Angle::fromDegrees(fovyDegrees), near, far};
}

inline std::pair<Camera, Viewport> randomView(const Sphere& sphere, Kind kind, Random& random) {
    const Viewport size{int(random.between(40.0, 200.0)), int(random.between(40.0, 160.0))};
    const double R = sphere.radius;
    const Vec3 away = random.direction(), up = random.direction(), aside = random.direction();
    const double distance = R * (1.0 + std::pow(10.0, random.between(-2.0, 1.5)));
    const Vec3 eye = sphere.centre + distance * away;
    const double whole = 2.0 * std::asin(R / distance) * 180.0 / std::numbers::pi;
    const double near = random.unit() < 0.3 ? distance * random.between(0.2, 1.1) : std::max(distance - 1.01 * R, 1e-3 * R) * 0.9;
    const double far = 10.0 * distance;
    switch (kind) {
        case Within:
            return {aimed(eye, sphere.centre, std::min(1.15 * whole, 170.0), std::max(distance - 1.01 * R, 1e-4 * R), far, up),
                    size};
        case Cutting:
            return {aimed(eye, sphere.centre + R * random.unit() * aside,
                          std::clamp(whole * random.between(0.05, 0.8), 0.2, 150.0), near, far, up),
                    size};
        case Touching: {
            // The lower plane passes the sphere, or cuts it, by a very small distance.
            const Vec3 upward = glm::normalize(glm::cross(aside, away));
            const double fovy = random.between(5.0, 100.0);
            const double angle = 0.5 * fovy * std::numbers::pi / 180.0 + std::asin(R / distance) * random.between(0.96, 1.001);
            const Vec3 forward = -std::cos(angle) * away + std::sin(angle) * upward;
            return {aimed(eye, eye + forward, fovy, 1e-3 * R, far, upward), size};
        }
        case Behind:
            return {aimed(eye, eye + away + 0.8 * aside, random.between(10.0, 150.0), near, far, up), size};
        case InSphere:
            return {aimed(sphere.centre + R * std::cbrt(random.unit()) * away, sphere.centre + 2.0 * R * aside,
                          random.between(5.0, 160.0), R * std::pow(10.0, random.between(-4.0, -0.5)), 10.0 * R, up),
                    size};
        default:
            return {aimed(sphere.centre, sphere.centre + R * aside, random.between(5.0, 160.0),
                          R * std::pow(10.0, random.between(-4.0, -0.5)), 10.0 * R, up),
                    size};
    }
}

/// What views of one strategy found together.
struct Tally {
    uint64_t views = 0, covered = 0, missed = 0, extra = 0, withCones = 0;
    std::array<uint64_t, kCauseCount> culled{};
    std::array<uint64_t, KindCount> coveredByKind{};
    uint64_t triangles = 0;
};

/// That a view of one object loses no pixel, and that its triangles are drawn or left out for a cause. Every other frame is
/// recorded.
class LosslessProperty {
public:
    void check(Culler& strategy, const SceneBuffers& buffers, const std::pair<Camera, Viewport>& random, Kind kind,
               const std::string& what) {
        const View view(random.first, random.second);
        const Culled frame = strategy.cull(view, m_tally.views % 2 == 0 ? Recording::On : Recording::Off);
        m_tally.withCones += std::ranges::any_of(
            frame.parts, [](const CullPart& part) { return part.name == "normal cones" && part.objects > 0; });
        m_log = frame.log;
        uint64_t culled = 0;
        for (size_t cause = 0; cause < kCauseCount; ++cause) {
            m_tally.culled[cause] += frame.culledTriangles[cause];
            culled += frame.culledTriangles[cause];
        }
        ASSERT_EQ(culled + frame.consideredTriangles, buffers.scene().triangleCount()) << what;
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy.referenceFacing());
        const Accuracy accuracy =
            compare(reference, {picture(buffers, view, frame.drawList).depth, {}}, frame.drawList, buffers.scene());
        ++m_tally.views;
        m_tally.triangles += buffers.scene().triangleCount();
        m_tally.covered += accuracy.coveredPixels;
        m_tally.coveredByKind[kind] += accuracy.coveredPixels;
        m_tally.missed += accuracy.missedPixels;
        if (accuracy.extraPixels > 0) explainExtra(buffers, random, frame.drawList, reference, what);
        m_tally.extra += accuracy.extraPixels;
        EXPECT_EQ(accuracy.missedPixels, 0u)
            << "pixels lost: " << what << ", " << kKindNames[kind] << "; " << described(random.first, random.second);
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }
    /// Of the last view.
    [[nodiscard]] const FrameLog& log() const { return m_log; }

private:
    /// An extra pixel shows a triangle that the reference has, too, and takes for turned away there: its facing is not certain,
    /// because the raster's grid of 1/256 pixel can turn it around.
    static void explainExtra(const SceneBuffers& buffers, const std::pair<Camera, Viewport>& random, const DrawList& list,
                             const Reference& reference, const std::string& what) {
        EXPECT_EQ(list.facing, reference.facing) << what;
        const PixelEdges edges(buffers.scene(), random.first, random.second);
        const View view(random.first, random.second);
        const Renderer::ItemBuffer shown = GlEnvironment::renderer().drawItemBuffer(buffers, view, list);
        for (size_t pixel = 0; pixel < shown.depth.size(); ++pixel) {
            if (pixelDifference(reference.depth[pixel], shown.depth[pixel]) != PixelDifference::Extra) continue;
            EXPECT_LT(edges.inscribedRadius(shown.triangle[pixel] - 1), kGrid)
                << "an extra pixel of a triangle that no snapping turns: " << what << ", pixel " << pixel << ", triangle "
                << shown.triangle[pixel] - 1 << "; " << described(random.first, random.second);
        }
    }

    Tally m_tally;
    FrameLog m_log;
};

}  // namespace cullscope::test
