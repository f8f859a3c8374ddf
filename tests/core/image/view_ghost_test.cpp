// Ghosts of whole objects, and back sides in a colour of their own.
#include "core/image/view_picture.h"
#include "tests/core/image/shown_picture.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::view_ghost_test {
namespace {

/// A square at z = −10 whose front side faces the origin, or its back.
MeshPointer square(bool facing) {
    return meshOf({{-1, -1, -10}, {1, -1, -10}, {1, 1, -10}, {-1, 1, -10}},
                  facing ? std::vector<uint32_t>{0, 1, 2, 0, 2, 3} : std::vector<uint32_t>{0, 2, 1, 0, 3, 2});
}

TEST(ViewPicture, backSidesHaveAColourOfTheirOwn) {
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(20), 0.1, 100}, {100, 100});
    for (const Vec3f& background : {Vec3f(1.0f), Vec3f(0.05f)}) {
        const DrawStyle style{background, 1.0f, Vec3f(0.6f)};
        const ScenePointer front = sceneOf({square(true)}), back = sceneOf({square(false)});
        const Shown plain = shown(front, "all", view, view, {}, style);
        EXPECT_EQ(shown(front, "all", view, view, {"back-sides"}, style).colour, plain.colour);
        EXPECT_EQ(shown(back, "all", view, view, {}, style).colour, plain.colour) << "both sides look the same without it";
        const Shown tinted = shown(back, "all", view, view, {"back-sides"}, style);
        EXPECT_LT(glm::distance(tinted.at(50, 50), backColour(background)), 0.02f);
        EXPECT_EQ(tinted.depth, plain.depth);
        // A mirrored object has as its front what its transform makes of it.
        const ScenePointer mirrored = sceneOf({square(true)}, {scaling({-1.0, 1.0, 1.0})});
        EXPECT_LT(glm::distance(shown(mirrored, "all", view, view, {"back-sides"}, style).at(50, 50), plain.at(50, 50)), 0.02f);
    }
}

TEST(ViewPicture, aGhostSurroundsWhatWasDrawn) {
    std::vector<Mat4> places;
    for (int i = 0; i < 36; ++i) places.push_back(translation({(i / 6 - 2.5) * 2.5, 0, (i % 6 - 2.5) * 2.5}));
    const ScenePointer scene = copiesOf(sphereMesh(320), places);
    const View culling({{0, .5, 4}, {.5, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100}, {320, 240});
    const View viewing({{3, 18, 22}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 1, 100}, {320, 240});
    const Shown plain = shown(scene, "frustum", culling, viewing, {}, kLight);
    const Shown whole = shown(scene, "all", culling, viewing, {}, kLight);
    const Shown ghost = shown(scene, "frustum", culling, viewing, {"ghost"}, kLight);
    size_t before = 0, around = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            const size_t pixel = size_t(y) * 320 + size_t(x);
            if (plain.depth[pixel] > 0.0f) {
                EXPECT_EQ(ghost.at(x, y), plain.at(x, y)) << "what was drawn lies before the ghost";
                ++before;
            } else if (whole.depth[pixel] > 0.0f) {
                // Nearly unshaded: ± 10 %.
                EXPECT_LT(glm::distance(ghost.at(x, y), ghostColour(kLight)), 0.2f * glm::length(ghostColour(kLight)))
                    << x << ", " << y;
                ++around;
            } else {
                EXPECT_EQ(ghost.at(x, y), plain.at(x, y));
            }
        }
    EXPECT_GT(before, 200u);
    EXPECT_GT(around, 1000u);
    EXPECT_EQ(ghost.depth, plain.depth);
}

}  // namespace
}  // namespace cullscope::test::view_ghost_test
