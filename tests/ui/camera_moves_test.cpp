#include "core/scene/camera_moves.h"
#include "ui/views/orientation_gizmo.h"

#include <gtest/gtest.h>

#include <random>

namespace cullscope::ui::camera_moves_test {
namespace {

constexpr Viewport kSize{640, 480};

/// The projection of a world point, in pixels with y upward.
Vec2 pixelOf(const View& view, const Vec3& point) {
    const Vec4 clip = view.clipFromEyeRelative() * Vec4(point - view.eye(), 1.0);
    return {(clip.x / clip.w * 0.5 + 0.5) * kSize.width, (clip.y / clip.w * 0.5 + 0.5) * kSize.height};
}

bool finite(const Camera& camera) {
    const auto ok = [](const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    return ok(camera.eye) && ok(camera.target) && glm::length(camera.eye - camera.target) > 0.0;
}

TEST(Navigation, zoomKeepsThePointUnderThePointer) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = Vec3(unit(random), unit(random), 3.0 + unit(random));
        const Vec3 point(unit(random), unit(random), unit(random));
        const Vec2 before = pixelOf(View(camera, kSize), point);
        for (const double factor : {0.85, 1.3}) {
            const Vec2 after = pixelOf(View(zoomed(camera, point, factor, 1.0), kSize), point);
            EXPECT_NEAR(before.x, after.x, 1e-6);
            EXPECT_NEAR(before.y, after.y, 1e-6);
        }
    }
}

Camera someParallel(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Camera camera;
    camera.eye = Vec3(unit(random), unit(random), 3.0 + unit(random));
    camera = inParallel(camera);
    camera.height *= 1.5 + unit(random);
    return camera;
}

TEST(ParallelNavigation, zoomAndPanKeepThePointUnderThePointer) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = someParallel(random);
        const View view(camera, kSize);
        const Vec3 point(unit(random), unit(random), unit(random));
        const Vec2 before = pixelOf(view, point);
        for (const double factor : {0.85, 1.3}) {
            const Camera next = zoomed(camera, point, factor, 1.0);
            EXPECT_NEAR(next.height, factor * camera.height, 1e-12);
            EXPECT_NEAR(glm::length(pixelOf(View(next, kSize), point) - before), 0.0, 1e-6);
        }
        const Vec2 to = before + Vec2(31.0, -17.0);
        const double distance = glm::dot(point - view.eye(), view.frustum().forward);
        EXPECT_NEAR(glm::length(pixelOf(View(panned(view, distance, before, to), kSize), point) - to), 0.0, 1e-6);
        // What is under the pixel at that depth is the point.
        EXPECT_NEAR(glm::length(pointUnder(view, before, view.depthFromDistance(distance)) - point), 0.0, 1e-6);
    }
}

TEST(ParallelNavigation, theWholeSceneStaysInTheViewVolumeAndItsPicture) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const Sphere scene{Vec3(unit(random), unit(random), unit(random)) * 10.0, 0.5 + std::abs(unit(random))};
        const Camera some = someParallel(random);
        const Camera camera = withClipPlanes(some, scene, std::nullopt);
        ASSERT_NO_THROW(validate(camera, kSize));
        const View view(camera, kSize);
        const double ahead = glm::dot(scene.centre - camera.eye, view.frustum().forward);
        EXPECT_LE(camera.nearDistance, ahead - scene.radius);
        EXPECT_GE(camera.farDistance, ahead + scene.radius);
        // Its place in the picture does not change by that.
        EXPECT_NEAR(glm::length(pixelOf(view, scene.centre) - pixelOf(View(some, kSize), scene.centre)), 0.0, 1e-6);
        const Camera all = withClipPlanes(framed(camera, UpAxis::Y, scene, 4.0 / 3.0), scene, std::nullopt);
        const View shown(all, kSize);
        const Frustum& f = shown.frustum();
        for (const Vec3& axis : {f.right, -f.right, f.up, -f.up}) {
            const Vec2 pixel = pixelOf(shown, scene.centre + scene.radius * axis);
            EXPECT_TRUE(pixel.x >= 0 && pixel.x <= kSize.width && pixel.y >= 0 && pixel.y <= kSize.height);
        }
    }
}

TEST(ParallelNavigation, flyingForwardShowsLessAndBackMore) {
    std::mt19937 random(7);
    const Camera camera = someParallel(random);
    const View view(camera, kSize);
    EXPECT_LT(flown(view, {0, 0, 0.5}).height, camera.height);
    EXPECT_GT(flown(view, {0, 0, -0.5}).height, camera.height);
    EXPECT_EQ(flown(view, {0.5, 0.2, 0}).height, camera.height);
}

TEST(Navigation, zoomNeverSticksOrGoesThroughNaN) {
    for (const Vec3& offset : {Vec3(0.0), Vec3(1e7, -1e7, 3e6)}) {
        const Sphere scene{offset, 1.0};
        Camera camera;
        camera.eye += offset;
        camera.target += offset;
        for (int step = 0; step < 1000; ++step) {
            const Camera next = withClipPlanes(zoomed(camera, offset, 0.85, 1.0), scene, std::nullopt);
            ASSERT_TRUE(finite(next)) << step;
            ASSERT_NE(next.eye, camera.eye) << step;
            ASSERT_NO_THROW(validate(next, kSize)) << step;
            camera = next;
        }
        // The camera has passed the point; from there the wheel zooms out again.
        EXPECT_LT(camera.eye.z, offset.z);
        const double before = glm::length(camera.eye - offset);
        for (int step = 0; step < 50; ++step) camera = zoomed(camera, offset, 1.2, 1.0);
        EXPECT_GT(glm::length(camera.eye - offset), before);
    }
}

TEST(Navigation, whatATurnIsAboutKeepsItsPlaceInThePicture) {
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
        const Camera camera = turned({Vec3(3, 2, 1), Vec3(0.0), axisVector(up)}, up, {}, {});
        const Vec3 pivot(0.3, -0.4, 0.2);
        const Vec2 before = pixelOf(View(camera, kSize), pivot);
        Camera moved = camera;
        for (int i = 0; i < 20; ++i) moved = turnedAbout(moved, up, pivot, Angle::fromDegrees(17), Angle::fromDegrees(-4));
        EXPECT_LT(glm::distance(pixelOf(View(moved, kSize), pivot), before), 1e-6);
        EXPECT_NEAR(glm::distance(moved.eye, pivot), glm::distance(camera.eye, pivot), 1e-9);
        // About the target it is the usual turn.
        const Camera usual = turned(camera, up, Angle::fromDegrees(30), Angle::fromDegrees(10));
        const Camera about = turnedAbout(camera, up, camera.target, Angle::fromDegrees(30), Angle::fromDegrees(10));
        EXPECT_LT(glm::distance(about.eye, usual.eye) + glm::distance(about.target, usual.target), 1e-9);
    }
}

TEST(Navigation, zoomWithTheEyeOnThePointStaysFinite) {
    Camera camera;
    EXPECT_TRUE(finite(zoomed(camera, camera.eye, 0.5, 1.0)));
    EXPECT_TRUE(finite(zoomed(camera, camera.eye, 2.0, 1.0)));
}

TEST(Navigation, turntableNeverFlips) {
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
        Camera camera;
        camera.eye = Vec3(1.0, 2.0, 3.0);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> degrees(-400.0, 400.0);
        const double distance = glm::length(camera.eye - camera.target);
        for (int i = 0; i < 1000; ++i) {
            camera = turned(camera, up, Angle::fromDegrees(degrees(random)), Angle::fromDegrees(degrees(random)));
            ASSERT_TRUE(finite(camera));
            EXPECT_NEAR(glm::length(camera.eye - camera.target), distance, 1e-9);
            // The up axis still points up in the picture.
            EXPECT_GT(glm::dot(View(camera, kSize).frustum().up, axisVector(up)), 0.0);
        }
    }
}

TEST(Navigation, turningRightShowsTheOtherSide) {
    Camera camera;
    const Camera half = turned(camera, UpAxis::Y, Angle::fromDegrees(180.0), {});
    EXPECT_NEAR(half.eye.z, -camera.eye.z, 1e-9);
    EXPECT_NEAR(half.eye.x, 0.0, 1e-9);
}

TEST(Navigation, panKeepsTheGrabbedPointUnderThePointer) {
    const View view(Camera{}, kSize);
    const Vec3 point(0.3, -0.2, 0.5);
    const Vec2 from = pixelOf(view, point);
    const Vec2 to = from + Vec2(37.0, -81.0);
    const double distance = glm::dot(point - view.eye(), view.frustum().forward);
    const Vec2 after = pixelOf(View(panned(view, distance, from, to), kSize), point);
    EXPECT_NEAR(after.x, to.x, 1e-6);
    EXPECT_NEAR(after.y, to.y, 1e-6);
}

TEST(Navigation, centredPointStandsInTheMiddleAtTheSameDepth) {
    const View view(Camera{}, kSize);
    const Vec3 point(0.4, 0.3, -0.6);
    const Camera camera = centredOn(view, point);
    const Vec2 after = pixelOf(View(camera, kSize), point);
    EXPECT_NEAR(after.x, 320.0, 1e-6);
    EXPECT_NEAR(after.y, 240.0, 1e-6);
    EXPECT_EQ(camera.target, point);
    EXPECT_NEAR(glm::length(point - camera.eye), glm::dot(point - view.eye(), view.frustum().forward), 1e-9);
}

TEST(Navigation, pointUnderReadsBackADepthSample) {
    const View view(Camera{}, kSize);
    const Vec3 point(0.1, 0.2, 0.3);
    const double distance = glm::dot(point - view.eye(), view.frustum().forward);
    const Vec3 found = pointUnder(view, pixelOf(view, point), view.depthFromDistance(distance));
    EXPECT_NEAR(glm::length(found - point), 0.0, 1e-6);
    // Where no surface is drawn, the point lies in the plane of the target.
    EXPECT_NEAR(pointUnder(view, Vec2(320.0, 240.0), 0.0).z, 0.0, 1e-9);
}

TEST(Navigation, framedSceneLiesInThePicture) {
    const Sphere sphere{Vec3(5.0, -3.0, 100.0), 7.0};
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const Camera camera = framed(Camera{}, UpAxis::Y, sphere, aspect);
        const double distance = glm::length(camera.eye - sphere.centre);
        const double halfHeight = camera.fovy.radians() / 2.0;
        const double halfWidth = std::atan(std::tan(halfHeight) * aspect);
        EXPECT_GE(distance * std::sin(std::min(halfHeight, halfWidth)), sphere.radius);
    }
}

TEST(Navigation, clipPlanesHoldTheScene) {
    const Sphere scene{Vec3(0.0), 2.0};
    Camera camera;
    camera.eye = Vec3(0.0, 0.0, 10.0);
    const Camera set = withClipPlanes(camera, scene, std::nullopt);
    EXPECT_LT(set.nearDistance, 8.0);
    EXPECT_GT(set.farDistance, 12.0);
    EXPECT_DOUBLE_EQ(withClipPlanes(camera, scene, 9.0).nearDistance, 9.0);
    EXPECT_LT(withClipPlanes(camera, scene, 1e9).nearDistance, set.farDistance);
}

TEST(Axes, aClickOnAnEndLooksFromThere) {
    const Camera start{{3.0, 2.0, 4.0}, {0.5, -0.5, 0.25}, {0.0, 1.0, 0.0}};
    const QRectF picture(10.0, 20.0, 400.0, 300.0);
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                Vec3 direction(0.0);
                direction[axis] = sign;
                const Camera camera = seenFrom(start, up, direction);
                const double length = glm::length(start.eye - start.target);
                EXPECT_NEAR(glm::length(camera.eye - camera.target), length, 1e-12);
                // The turntable stops at 89.5°, half a degree before the pole.
                EXPECT_GT(glm::dot(camera.eye - camera.target, direction) / length, 0.9999);
                EXPECT_EQ(camera.target, start.target);
                // From the new camera this end lies in the middle of the gizmo and in front of all others.
                const OrientationGizmo gizmo(View(camera, {400, 300}), picture);
                const std::optional<Vec3> hit = gizmo.directionAt(picture.bottomLeft() + QPointF(48.84, -48.84));
                ASSERT_TRUE(hit);
                EXPECT_EQ(*hit, direction);
            }
    const OrientationGizmo gizmo(View(start, {400, 300}), picture);
    EXPECT_FALSE(gizmo.directionAt(picture.center()));
}

}  // namespace
}  // namespace cullscope::ui::camera_moves_test
