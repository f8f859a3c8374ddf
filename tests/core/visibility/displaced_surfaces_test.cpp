// Where a picture that a strategy computes on the processor is promised: OpenGL's floats must move no surface in view.

#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::displaced_surfaces_test {
namespace {

constexpr Viewport kSize{160, 120};

/// The promise of a strategy for a ball of radius 1 at `centre`, whose surface lies `gap` before the eye.
Promise promiseBefore(const char* id, double gap, double fieldOfView, const Vec3& centre = Vec3(0.0)) {
    const ScenePointer scene = sceneOf({sphereMesh(2000)}, {translation(centre)});
    const CullerPointer culler = makeCuller(id);
    culler->build(*scene);
    const Camera camera{centre + Vec3(1.0 + gap, 0.0, 0.0), centre, {0, 1, 0}, Angle::fromDegrees(fieldOfView), 0.5 * gap, 100};
    return culler->promiseAt(View(camera, kSize));
}

TEST(DisplacedSurfaces, picturesArePromisedWhereFloatsMoveNoSurfaceByAPixel) {
    using enum Promise;
    for (const auto& [id, promise] :
         {std::pair{"painter", Conservative}, {"bsp", Conservative}, {"depth-buffer", Exact}, {"scan-line", Exact}}) {
        EXPECT_EQ(promiseBefore(id, 2.0, 45.0), promise) << id;
        EXPECT_EQ(promiseBefore(id, 0.05, 70.0), promise) << id << " close by";
        EXPECT_EQ(promiseBefore(id, 2.0, 45.0, Vec3(1e7)), promise) << id << " far from the origin";
        EXPECT_EQ(promiseBefore(id, 1e-5, 70.0), Approximate) << id << " just before the surface";
        EXPECT_EQ(promiseBefore(id, 2.0, 0.01), Approximate) << id << " through a telescope";
    }
}

TEST(DisplacedSurfaces, picturesFarAsideInAWideFieldOfViewArePromisedFromFartherAhead) {
    // Balls of radius 1, 20 aside: what moves one by a millionth moves its picture by that over the square of what it is ahead.
    const auto promise = [](double fieldOfView, double ahead) {
        const ScenePointer scene = sceneOf({sphereMesh(2000)}, {translation(Vec3(ahead, 0.0, 20.0))});
        const CullerPointer culler = makeCuller("backface");
        culler->build(*scene);
        return culler->promiseAt(
            View(Camera{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Angle::fromDegrees(fieldOfView), 0.01, 100}, {1600, 1200}));
    };
    EXPECT_EQ(promise(179.0, 0.5), Promise::Approximate) << "it passes the eye's plane";
    EXPECT_EQ(promise(179.0, 1.01), Promise::Approximate);
    EXPECT_EQ(promise(179.0, 3.0), Promise::Conservative);
    EXPECT_EQ(promise(60.0, 0.5), Promise::Conservative) << "out of view";
}

TEST(DisplacedSurfaces, parallelPicturesArePromisedWherePixelsAreWiderThanFloatsMove) {
    const ScenePointer scene = sceneOf({sphereMesh(2000)}, {translation(Vec3(0.0))});
    for (const char* id : {"depth-buffer", "scan-line", "backface"}) {
        const CullerPointer culler = makeCuller(id);
        culler->build(*scene);
        const auto promise = [&](double distance, double height, double aside) {
            Camera camera{Vec3(distance, aside, 0.0), Vec3(0.0, aside, 0.0), {0, 0, 1}, Angle::fromDegrees(45), 0.5, 1e6};
            camera.projection = ProjectionKind::Parallel;
            camera.height = height;
            return culler->promiseAt(View(camera, kSize));
        };
        EXPECT_NE(promise(3.0, 2.5, 0.0), Promise::Approximate) << id;
        EXPECT_NE(promise(1e5, 2.5, 0.0), Promise::Approximate) << id << ": the distance ahead moves nothing aside";
        EXPECT_EQ(promise(3.0, 1e-6, 0.0), Promise::Approximate) << id << " through a microscope";
        EXPECT_NE(promise(3.0, 1e-6, 5.0), Promise::Approximate) << id << " beside it";
    }
}

TEST(DisplacedSurfaces, picturesArePromisedWhereALargeWallPassesTheEyeOutOfView) {
    // A wall that reaches from far behind the eye to far ahead, 0.001 beside it, comes into view 10 ahead.
    std::vector<Vec3f> corners{{0.001F, -5, 20}, {0.001F, 5, 20}, {0.001F, 0, -60}};
    const ScenePointer scene = sceneOf({soupMesh(corners)});
    const CullerPointer culler = makeCuller("bsp");
    culler->build(*scene);
    const auto promise = [&](const Vec3& target) {
        const Camera camera{{0, 0, 0}, target, {0, 1, 0}, Angle::fromDegrees(5), 1e-4, 100};
        return culler->promiseAt(View(camera, kSize));
    };
    EXPECT_EQ(promise({-1, 0, -0.1}), Promise::Conservative) << "looking away from it";
    EXPECT_EQ(promise({1, 0, 0}), Promise::Approximate) << "looking at it from a thousandth of a unit";
}

}  // namespace
}  // namespace cullscope::test::displaced_surfaces_test
