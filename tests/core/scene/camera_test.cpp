#include "core/scene/camera.h"

#include <cmath>

#include "core/base/error.h"
#include "core/geometry/random.h"

namespace cullscope::camera_test {
namespace {

const Viewport kSize{640, 480};

Camera someCamera(Random& random, double farFromOrigin = 0.0) {
    Camera camera;
    camera.eye = random.direction() * random.between(0, 10) + random.direction() * farFromOrigin;
    camera.target = camera.eye + random.direction() * random.between(0.1, 10);
    camera.up = random.direction();
    camera.fovy = Angle::fromDegrees(random.between(1, 150));
    camera.nearDistance = std::pow(10.0, random.between(-6, 2));
    camera.farDistance = camera.nearDistance * std::pow(10.0, random.between(0.1, 9));
    return camera;
}

/// The error sentence of validate; empty where it accepts.
std::string complaint(const Camera& camera, const Viewport& size = kSize) {
    try {
        validate(camera, size);
        (void)View(camera, size);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        return error.what();
    }
    return {};
}

TEST(View, basisIsOrthonormal) {
    Random random(31);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = someCamera(random);
        const Frustum f = View(camera, kSize).frustum();
        EXPECT_NEAR(glm::dot(f.forward, glm::normalize(camera.target - camera.eye)), 1.0, 1e-14);
        EXPECT_NEAR(glm::dot(f.forward, f.right), 0.0, 1e-14);
        EXPECT_NEAR(glm::length(glm::cross(f.right, f.forward) - f.up), 0.0, 1e-14) << "right, up, backward are right-handed";
        EXPECT_GT(glm::dot(f.up, camera.up), 0.0);
        EXPECT_NEAR(glm::dot(f.right, camera.up), 0.0, 1e-9) << "the picture is rolled";
    }
}

TEST(View, directionAndProjectionAgree) {
    Random random(32);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = someCamera(random);
        const View view(camera, kSize);
        const double x = random.between(0, kSize.width);
        const double y = random.between(0, kSize.height);
        const double distance = camera.nearDistance * std::pow(camera.farDistance / camera.nearDistance, random.unit());
        const Vec3 point = view.direction(x, y) * distance;
        EXPECT_NEAR(glm::dot(point, view.frustum().forward), distance, 1e-12 * distance);
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point, 1.0);
        EXPECT_NEAR(clip.w, distance, 1e-12 * distance);
        EXPECT_NEAR((clip.x / clip.w + 1) / 2 * kSize.width, x, 1e-8);
        EXPECT_NEAR((clip.y / clip.w + 1) / 2 * kSize.height, y, 1e-8);
        EXPECT_NEAR(clip.z / clip.w, view.depthFromDistance(distance), 1e-12);
    }
}

TEST(View, depthAndDistanceAgree) {
    Random random(33);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = someCamera(random);
        const View view(camera, kSize);
        EXPECT_NEAR(view.depthFromDistance(camera.nearDistance), 1.0, 1e-12);
        EXPECT_NEAR(view.depthFromDistance(camera.farDistance), 0.0, 1e-12);
        const double distance = camera.nearDistance * std::pow(camera.farDistance / camera.nearDistance, random.between(0, 0.5));
        EXPECT_NEAR(view.distanceFromDepth(view.depthFromDistance(distance)), distance, 1e-6 * distance);
        EXPECT_GT(view.depthFromDistance(distance), view.depthFromDistance(distance * 1.01)) << "depth is not reversed";
    }
    const View view({}, kSize);
    EXPECT_DOUBLE_EQ(view.distanceFromDepth(1.0), Camera().nearDistance);
    EXPECT_DOUBLE_EQ(view.distanceFromDepth(0.0), Camera().farDistance);
}

TEST(View, frustumHasThePlanesOfTheProjection) {
    Random random(34);
    for (int i = 0; i < 2000; ++i) {
        const View view(someCamera(random), kSize);
        const Frustum& f = view.frustum();
        const Vec3 point = view.direction(random.between(-200, 840), random.between(-200, 680)) *
                           (f.nearDistance * std::pow(f.farDistance / f.nearDistance, random.between(-0.2, 1.2)));
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point, 1.0);
        const std::array<double, 6> inside{clip.w + clip.x, clip.w - clip.x, clip.w + clip.y,
                                           clip.w - clip.y, clip.w - clip.z, clip.z};
        for (size_t plane = 0; plane < 6; ++plane) {
            if (std::abs(inside[plane]) < 1e-9 * clip.w) continue;
            EXPECT_EQ(inside[plane] > 0, f.planes[plane].distance(point) > 0) << "plane " << plane;
        }
    }
}

/// A parallel camera at the place of a perspective one, with a height and a depth of its own.
Camera parallelCamera(Random& random) {
    Camera camera = inParallel(someCamera(random));
    camera.height *= random.between(0.2, 5.0);
    camera.nearDistance = camera.height * std::pow(10.0, random.between(-2, 1));
    camera.farDistance = camera.nearDistance + camera.height * std::pow(10.0, random.between(-1, 3));
    return camera;
}

TEST(ParallelView, linesOfSightProjectToTheirPixelsAtEveryDistance) {
    Random random(35);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = parallelCamera(random);
        const View view(camera, kSize);
        const double x = random.between(0, kSize.width), y = random.between(0, kSize.height);
        const double distance = random.between(camera.nearDistance, camera.farDistance);
        const Vec3 point = view.sightOrigin(x, y) + distance * view.direction(x, y);
        EXPECT_NEAR(glm::dot(point, view.frustum().forward), distance, 1e-11 * camera.farDistance);
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point, 1.0);
        EXPECT_EQ(clip.w, 1.0);
        const double tolerance = 1e-9 * std::max(1.0, camera.farDistance / camera.height) * kSize.width;
        EXPECT_NEAR((clip.x + 1) / 2 * kSize.width, x, tolerance);
        EXPECT_NEAR((clip.y + 1) / 2 * kSize.height, y, tolerance);
        EXPECT_NEAR(clip.z, view.depthFromDistance(distance), 1e-9);
        EXPECT_NEAR(view.distanceFromDepth(clip.z), distance, 1e-9 * camera.farDistance);
        // A plane through the point has its depth there.
        const Vec3 normal = random.direction();
        EXPECT_NEAR(view.depthOfPlane(normal, glm::dot(normal, point), x, y), clip.z, 1e-6);
    }
}

TEST(ParallelView, frustumHasThePlanesOfTheProjection) {
    Random random(36);
    for (int i = 0; i < 2000; ++i) {
        const View view(parallelCamera(random), kSize);
        const Frustum& f = view.frustum();
        const double distance = f.nearDistance + (f.farDistance - f.nearDistance) * random.between(-0.2, 1.2);
        const double x = random.between(-200, 840), y = random.between(-200, 680);
        const Vec3 point = view.sightOrigin(x, y) + distance * f.forward;
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point, 1.0);
        const std::array<double, 6> inside{1 + clip.x, 1 - clip.x, 1 + clip.y, 1 - clip.y, 1 - clip.z, clip.z};
        for (size_t plane = 0; plane < 6; ++plane) {
            // Near and far lie farther out by their room.
            if (std::abs(inside[plane]) < 1e-5) continue;
            EXPECT_EQ(inside[plane] > 0, f.planes[plane].distance(point) > 0) << "plane " << plane;
        }
        for (const Vec3& corner : f.corners())
            for (const Plane& plane : f.planes) EXPECT_GT(plane.distance(corner), -1e-9 * f.farDistance);
    }
}

TEST(ParallelView, showsTheTargetAsLargeAsThePerspectiveViewThatItComesFrom) {
    Random random(37);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = someCamera(random), parallel = inParallel(camera), back = inPerspective(parallel);
        const double size = heightAtTarget(camera);
        EXPECT_NEAR(heightAtTarget(parallel), size, 1e-12 * size);
        EXPECT_NEAR(heightAtTarget(back), size, 1e-9 * size);
        EXPECT_NEAR(glm::length(back.eye - camera.eye), 0.0, 1e-9 * glm::length(camera.eye - camera.target));
        EXPECT_EQ(inPerspective(camera), camera);
    }
}

TEST(View, gpuMatrixLosesNoDigitsFarFromTheOrigin) {
    // A point of a mesh whose coordinates are about 1e7: the float matrix must place it as if it were at the origin.
    const Vec3 far(1e7, -1e7, 1e7);
    Camera camera;
    camera.eye = far + Vec3(0, 0, 3);
    camera.target = far;
    const View view(camera, kSize);
    const View atOrigin({Vec3(0, 0, 3), Vec3(0.0)}, kSize);
    Mat4 there(1.0);
    there[3] = Vec4(far, 1.0);
    const Mat4f wanted = atOrigin.clipFromPositions(Mat4(1.0), Vec3(0.0));
    EXPECT_EQ(view.clipFromPositions(there, Vec3(0.0)), wanted) << "moved by the transform";
    EXPECT_EQ(view.clipFromPositions(Mat4(1.0), far), wanted) << "moved by the mesh's origin";
    EXPECT_EQ(view.sightFromPositions(there, Vec3(0.0)), atOrigin.sightFromPositions(Mat4(1.0), Vec3(0.0)));
}

TEST(View, upAlongTheViewGivesABasisAllTheSame) {
    for (const Vec3& forward : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, -2), Vec3(1, 1, 1)}) {
        Camera camera;
        camera.eye = Vec3(1, 2, 3);
        camera.target = camera.eye + forward;
        camera.up = forward * 2.0;
        const Frustum f = View(camera, kSize).frustum();
        EXPECT_NEAR(glm::length(f.right), 1.0, 1e-14);
        EXPECT_NEAR(glm::dot(f.right, f.forward), 0.0, 1e-14);
        EXPECT_NEAR(glm::length(f.up), 1.0, 1e-14);
    }
}

TEST(Validate, cameraThatMakesNoPictureIsRefused) {
    EXPECT_EQ(complaint({}), "");
    const auto changed = [](auto change) {
        Camera camera;
        change(camera);
        return complaint(camera);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    using testing::HasSubstr;
    EXPECT_THAT(changed([&](Camera& c) { c.eye.x = nan; }), HasSubstr("finite"));
    EXPECT_THAT(changed([&](Camera& c) { c.up.z = infinite; }), HasSubstr("finite"));
    EXPECT_THAT(changed([&](Camera& c) { c.target = c.eye; }), HasSubstr("same point"));
    EXPECT_THAT(changed([&](Camera& c) { c.up = Vec3(0.0); }), HasSubstr("up vector"));
    for (const double degrees : {0.0, -1.0, 180.0, 181.0, nan, infinite})
        EXPECT_THAT(changed([&](Camera& c) { c.fovy = Angle::fromDegrees(degrees); }), HasSubstr("field of view")) << degrees;
    for (const double distance : {0.0, -1.0, 1000.0, 1001.0, nan})
        EXPECT_THAT(changed([&](Camera& c) { c.nearDistance = distance; }), HasSubstr("near distance")) << distance;
    EXPECT_THAT(changed([&](Camera& c) { c.farDistance = infinite; }), HasSubstr("near distance"));
    for (const double height : {0.0, -1.0, nan, infinite}) {
        EXPECT_THAT(changed([&](Camera& c) { c.projection = ProjectionKind::Parallel, c.height = height; }), HasSubstr("height"));
        EXPECT_EQ(changed([&](Camera& c) { c.height = height; }), "") << "in perspective it has no effect";
    }
    for (const Viewport& size : {Viewport{0, 1}, Viewport{1, 0}, Viewport{-1, 1}, Viewport{16385, 1}, Viewport{1, 16385}})
        EXPECT_THAT(complaint({}, size), HasSubstr("16384")) << size.width << "x" << size.height;
}

TEST(Validate, extremeCameraIsTaken) {
    // Case 23: fields of view of 0.01° and 179°, viewports of 1 × 1 and 16384 × 1.
    for (const double degrees : {0.01, 179.0})
        for (const Viewport& size : {Viewport{1, 1}, Viewport{16384, 1}, Viewport{1, 16384}, Viewport{16384, 16384}}) {
            Camera camera;
            camera.fovy = Angle::fromDegrees(degrees);
            camera.nearDistance = 1e-6;
            camera.farDistance = 1e9;
            EXPECT_EQ(complaint(camera, size), "");
            const Mat4 clip = View(camera, size).clipFromEyeRelative();
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(static_cast<float>(clip[column][row])));
        }
}

TEST(Validate, tinyAndHugeVectorsAreRefusedOrMakeTheRightView) {
    for (const double size : {1e-200, 1e-100, 1e100, 1e150}) {
        Camera camera;
        camera.eye = Vec3(0.0);
        camera.target = Vec3(0, 0, -size);
        camera.up = Vec3(0, size, 0);
        if (!complaint(camera).empty()) continue;
        const Frustum f = View(camera, kSize).frustum();
        EXPECT_NEAR(glm::length(f.forward - Vec3(0, 0, -1)), 0.0, 1e-12) << size;
        EXPECT_NEAR(glm::length(f.right - Vec3(1, 0, 0)), 0.0, 1e-12) << size;
    }
}

}  // namespace
}  // namespace cullscope::camera_test
