#include "tests/support/exact_visibility.h"

#include "tests/support/test_scenes.h"

namespace cullscope::test::exact_visibility_test {
namespace {

/// Camera at the origin looking down −z, 90°, aspect 1, near 0.1, far 10.
ExactVisibility standardView() {
    return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, {100, 100}};
}

ObjectTruth judged(std::vector<Vec3f> corners) {
    const ScenePointer scene = sceneOf({meshOf(std::move(corners), {0, 1, 2})});
    return standardView().judge(*scene, 0);
}

TEST(ExactVisibility, triangleInFrontIsVisible) {
    const ObjectTruth truth = judged({{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}});
    EXPECT_TRUE(truth.visible);
    EXPECT_FALSE(truth.straddles);
}

TEST(ExactVisibility, triangleBehindBesideOrBeyondIsNotVisible) {
    EXPECT_FALSE(judged({{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}}).visible);
    EXPECT_FALSE(judged({{6, -1, -5}, {8, -1, -5}, {7, 1, -5}}).visible);
    EXPECT_FALSE(judged({{-1, -1, -11}, {1, -1, -11}, {0, 1, -11}}).visible);
    EXPECT_FALSE(judged({{-.01f, -.01f, -.05f}, {.01f, -.01f, -.05f}, {0, .01f, -.05f}}).visible);
}

TEST(ExactVisibility, triangleLargerThanTheViewIsVisibleWithoutAVertexInside) {
    const ObjectTruth truth = judged({{-100, -100, -5}, {100, -100, -5}, {0, 100, -5}});
    EXPECT_TRUE(truth.visible);
    EXPECT_TRUE(truth.straddles);
}

TEST(ExactVisibility, triangleAcrossAnEdgeOfTheFrustumIsNotVisibleThoughItPassesEveryPlane) {
    // It crosses the right and the top plane, but beyond their common edge: x + y > 2 · 5 there.
    EXPECT_FALSE(judged({{11, 0, -5}, {0, 11, -5}, {11, 11, -5}}).visible);
    EXPECT_TRUE(judged({{9, 0, -5}, {0, 9, -5}, {9, 9, -5}}).visible);
}

TEST(ExactVisibility, pointsOnAPlaneTouchIt) {
    // 0.1f is larger than the double 0.1 by 1.5e-9, so this lies just beyond the near plane; the other just in front of it.
    EXPECT_TRUE(judged({{0, 0, -0.1f}, {1, 0, 1}, {0, 1, 1}}).visible);
    EXPECT_FALSE(judged({{0, 0, std::nextafter(-0.1f, 0.0f)}, {1, 0, 1}, {0, 1, 1}}).visible);
    EXPECT_TRUE(judged({{0, 0, -10}, {1, 0, -11}, {0, 1, -11}}).visible);
}

TEST(ExactVisibility, planesAgreeWithClosedForms) {
    const ScenePointer scene = sceneOf({meshOf({{3, 0, -4}, {0, 0, -4}, {0, 1, -4}}, {0, 1, 2})});
    const ObjectTruth truth = standardView().judge(*scene, 0);
    EXPECT_NEAR(truth.closest[1], 1.0 / std::sqrt(2.0) / 5.0, 1e-15) << "the right plane: (4 − 3)/√2 from a point 5 away";
}

}  // namespace
}  // namespace cullscope::test::exact_visibility_test
