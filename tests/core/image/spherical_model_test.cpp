#include "core/image/spherical_model.h"

#include "core/gpu/colour.h"
#include "core/image/view_picture.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/hand_made_map.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::spherical_model_test {
namespace {

constexpr Viewport kSize{440, 400};  // the map 360 × 180: one pixel for each degree
constexpr int kLeft = 40, kBottom = 110;

std::vector<uint8_t> shown(const ScenePointer& scene, const char* id, const View& view, const ViewLook& look,
                           const DrawStyle& style) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = makeCuller(id);
    strategy->build(*scene);
    const Culled frame = strategy->cull(view, needsDecisions(look) ? Recording::On : Recording::Off);
    Framebuffer target(view.viewport());
    drawViewPicture(GlEnvironment::renderer(), buffers, *strategy->built(), frame.log, view, nullptr, look, style, target);
    EXPECT_TRUE(std::ranges::all_of(target.readDepth(), [](float depth) { return depth == 0.0f; })) << "left depth";
    return target.readColour();
}

TEST(SphericalModelPicture, pickIsWhatIsShown) {
    // The first of two objects is shown; the strategy has an order of its own, so that numbers must be those of the mesh.
    const ScenePointer scene = sceneOf({knotMesh(4000), sphereMesh(80)}, {translation({5, 1, 2}) * scaling(Vec3(3.0))});
    const View view({{5, 1, 20}, {5, 1, 2}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    const DrawStyle style{Vec3f(1.0f)};
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    const DrawList list = strategy->cull(view).drawList;
    ASSERT_EQ(sphericalModelInstance(list), 0u);
    const std::vector<uint8_t> rgba = shown(scene, "spherical", view, {"spherical-model"}, style);
    const int step = fewSamples() ? 9 : 3;
    size_t picked = 0, disagreeing = 0;
    for (int y = kBottom + 1; y < kBottom + 179; y += step)
        for (int x = kLeft + 1; x < kLeft + 359; x += step) {
            const uint8_t* pixel = &rgba[4 * (size_t(y) * size_t(kSize.width) + size_t(x))];
            const bool covered = pixel[0] != 255 || pixel[1] != 255 || pixel[2] != 255;
            const std::optional<DirectionPick> pick = pickSphericalModel(*scene, list, kSize, style, x, y);
            disagreeing += covered != pick.has_value() ? 1 : 0;
            if (!pick) continue;
            ++picked;
            ASSERT_LT(pick->triangle, scene->firstTriangle(1));
            // The point lies in the pixel's direction from the centre, and in the triangle's plane.
            const Vec3 centre = Vec3(5, 1, 2) + 3.0 * scene->meshOf(0).localSphere().centre;
            const Vec3 expected = directionOf(180.0 - (y - kBottom + 0.5), x - kLeft + 0.5);
            ASSERT_NEAR(glm::dot(glm::normalize(pick->point - centre), expected), 1.0, 1e-9);
        }
    EXPECT_GT(picked, fewSamples() ? 150u : 1500u);
    EXPECT_LE(disagreeing, 3u) << "but for pixels on an edge";
    EXPECT_FALSE(pickSphericalModel(*scene, list, kSize, style, 3, 100)) << "beside the map";
    EXPECT_FALSE(pickSphericalModel(*scene, DrawList{}, kSize, style, 100, 100));
}

TEST(SphericalModelPicture, showsOnlyWhatWasDrawn) {
    const ScenePointer scene = sceneOf({sphereMesh(20000)});
    const View view({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    const DrawStyle style{Vec3f(1.0f)};
    const auto covered = [&](const char* id) {
        const std::vector<uint8_t> rgba = shown(scene, id, view, {"spherical-model"}, style);
        size_t pixels = 0;
        for (int y = kBottom + 2; y < kBottom + 178; ++y)
            for (int x = kLeft + 2; x < kLeft + 358; ++x)
                pixels += rgba[4 * (size_t(y) * size_t(kSize.width) + size_t(x)) + 2] != 255 ? 1 : 0;
        return pixels;
    };
    EXPECT_EQ(covered("all"), 176u * 356u);
    // From above the pole, about the northern half.
    EXPECT_LT(covered("spherical-horizon"), 176u * 356u * 2 / 3);
    EXPECT_GT(covered("spherical-horizon"), 176u * 356u / 3);
}

TEST(SphericalModelPicture, coloursGetLighterWithTheDistance) {
    const std::array<Vec3f, 5> relief = reliefColours();
    for (size_t i = 1; i < relief.size(); ++i) EXPECT_LT(relativeLuminance(relief[i - 1]), relativeLuminance(relief[i]));
}

TEST(SphericalModelPicture, overlaysAreNotDrawnOverIt) {
    const ScenePointer scene = sceneOf({knotMesh(3000)});
    const View view({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    const DrawStyle style;
    const ViewLook all{"verdicts", "frustum", "boxes", "bands", "spherical-model"};
    EXPECT_FALSE(needsDecisions(all));
    const std::vector<uint8_t> alone = shown(scene, "spherical", view, {"spherical-model"}, style);
    EXPECT_EQ(shown(scene, "spherical", view, all, style), alone);
    const Vec3f frame = contrastTo(style.background);
    const auto at = [&](size_t y) { return alone[4 * (y * size_t(kSize.width) + 200)]; };
    EXPECT_EQ(std::max(at(kBottom - 1), at(kBottom)), 255.0f * frame.x) << "the frame";
}

TEST(SphericalModelPicture, anglesHaveTicks) {
    const ScenePointer scene = sceneOf({knotMesh(3000)});
    const View view({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    const std::vector<uint8_t> rgba = shown(scene, "spherical", view, {"spherical-model"}, {Vec3f(1.0f)});
    // A tick is one pixel wide and lies on either side of its position.
    const auto marked = [&](int x, int y, int alongX, int alongY) {
        const auto dark = [&](int column, int row) {
            return rgba[4 * (size_t(row) * size_t(kSize.width) + size_t(column))] < 128;
        };
        return dark(x, y) || dark(x - alongX, y - alongY);
    };
    for (int degrees = 0; degrees <= 360; degrees += 15) {
        EXPECT_EQ(marked(kLeft + degrees, kBottom - 3, 1, 0), degrees % 30 == 0) << degrees;
        EXPECT_EQ(marked(kLeft + degrees, kBottom - 5, 1, 0), degrees % 90 == 0) << degrees;
        if (degrees > 180) continue;
        EXPECT_EQ(marked(kLeft - 3, kBottom + 180 - degrees, 0, 1), degrees % 30 == 0) << degrees;
        EXPECT_EQ(marked(kLeft - 5, kBottom + 180 - degrees, 0, 1), degrees % 90 == 0) << degrees;
    }
}

TEST(SphericalModelPicture, partIsNotTakenForTheWhole) {
    const ScenePointer scene = sceneOf({sphereMesh(2000), knotMesh(3000)});
    const View view({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    const auto whole = [&](const char* id) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        return hasWholeModel(*scene, strategy->cull(view).drawList);
    };
    EXPECT_TRUE(whole("all"));
    EXPECT_FALSE(whole("spherical"));
    EXPECT_FALSE(hasWholeModel(*scene, DrawList{}));
}

}  // namespace
}  // namespace cullscope::test::spherical_model_test
