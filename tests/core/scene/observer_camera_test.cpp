// The camera of an observer shows the culling view's frustum and the scene.
#include <gtest/gtest.h>

#include <random>

#include "core/scene/camera_moves.h"

namespace cullscope::observer_camera_test {
namespace {

/// Where a place lies in a view: 1 at the picture's sides.
double outwards(const View& view, const Vec3& place) {
    const Frustum& frustum = view.frustum();
    const Vec3 offset = place - view.eye();
    const double ahead = glm::dot(offset, frustum.forward);
    if (!(ahead > 0.0)) return std::numeric_limits<double>::infinity();
    return std::max(std::abs(glm::dot(offset, frustum.right)) / (ahead * frustum.tanHalfWidth),
                    std::abs(glm::dot(offset, frustum.up)) / (ahead * frustum.tanHalfHeight));
}

TEST(ObserverCamera, hasTheFrustumTheEyeAndTheSceneInItsPictureAndFillsIt) {
    std::mt19937 random(11);
    const auto number = [&](double least, double most) { return std::uniform_real_distribution<double>(least, most)(random); };
    for (int i = 0; i < 1000; ++i) {
        const Sphere scene{Vec3(number(-50, 50), number(-50, 50), number(-50, 50)), number(0.1, 30.0)};
        const UpAxis up = i % 2 == 0 ? UpAxis::Y : UpAxis::Z;
        Camera camera;
        camera.target = scene.centre + scene.radius * 0.3 * Vec3(number(-1, 1), number(-1, 1), number(-1, 1));
        // Outside the scene, and inside it.
        camera.eye = camera.target + number(0.2, 5.0) * scene.radius * glm::normalize(Vec3(number(-1, 1), 0.3, number(-1, 1)));
        camera.up = axisVector(up);
        camera.fovy = Angle::fromDegrees(number(5.0, 90.0));
        camera = withClipPlanes(camera, scene, std::nullopt);
        const View culling(camera, {int(number(100, 1000)), 480});
        const double aspect = number(0.4, 2.5);
        const View seen(observerCamera(culling, scene, up, aspect), {int(480 * aspect), 480});
        const bool wide = std::max(culling.frustum().tanHalfWidth, culling.frustum().tanHalfHeight) > 1.5;
        double most = outwards(seen, camera.eye);
        for (const Vec3& corner : culling.frustum().corners())
            if (!wide) most = std::max(most, outwards(seen, camera.eye + corner));
        for (const Vec3& axis : {seen.frustum().right, seen.frustum().up})
            for (const double side : {-1.0, 1.0})
                most = std::max(most, outwards(seen, scene.centre + side * scene.radius * axis));
        EXPECT_LE(most, 1.01) << "seed 11, case " << i;
        if (!wide) EXPECT_GE(most, 0.8) << "seed 11, case " << i;
    }
}

TEST(ObserverCamera, doesNotFrameWhatALensSeesBeyondTheScene) {
    const Sphere scene{Vec3(0.0), 1.0};
    Camera camera;
    camera.eye = Vec3(0.0, 0.0, 3.0);
    const View near(withClipPlanes(camera, scene, std::nullopt), {640, 480});
    camera.farDistance = 1000.0;
    const View far(camera, {640, 480});
    const Camera beside = observerCamera(near, scene, UpAxis::Y, 4.0 / 3.0),
                 besideFar = observerCamera(far, scene, UpAxis::Y, 4.0 / 3.0);
    EXPECT_NEAR(glm::length(besideFar.eye), glm::length(beside.eye), 0.2 * glm::length(beside.eye));
}

}  // namespace
}  // namespace cullscope::observer_camera_test
