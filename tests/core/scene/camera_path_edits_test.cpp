#include "core/scene/camera_path_edits.h"

#include <gtest/gtest.h>

#include "core/geometry/random.h"

namespace cullscope::test::camera_path_edits_test {
namespace {

/// A straight flight along x, each pose shaken by a hand.
CameraPath shaken(double by) {
    Random random(3);
    CameraPath path;
    path.name = "mine";
    for (int i = 0; i < 40; ++i) {
        const Vec3 eye = Vec3(i, 0, 0) + by * random.direction();
        path.poses.push_back({eye, eye + Vec3(0, 0, -5) + by * random.direction(), Vec3(0, 1, 0)});
    }
    return path;
}

/// The sum of the eyes' changes of velocity.
double jerks(const CameraPath& path) {
    double sum = 0.0;
    for (size_t i = 1; i + 1 < path.poses.size(); ++i)
        sum += glm::length(path.poses[i - 1].eye - 2.0 * path.poses[i].eye + path.poses[i + 1].eye);
    return sum;
}

TEST(CameraPathEdits, trimmedKeepsTheNamedPosesAndTheLens) {
    CameraPath path = shaken(0.1);
    path.fovy = Angle::fromDegrees(33);
    const CameraPath part = trimmed(path, 5, 7);
    ASSERT_EQ(part.poses.size(), 3u);
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(part.poses[i].eye, path.poses[5 + i].eye);
    EXPECT_EQ(part.fovy, path.fovy);
    EXPECT_EQ(part.name, "mine");
    EXPECT_EQ(trimmed(path, 0, 39).poses.size(), 40u);
    EXPECT_EQ(trimmed(path, 4, 4).poses.size(), 1u);
}

TEST(CameraPathEdits, smoothedHasFewerJerksAndTheSameEnds) {
    const CameraPath path = shaken(0.3), once = smoothed(path), twice = smoothed(once);
    ASSERT_EQ(once.poses.size(), path.poses.size());
    EXPECT_LT(jerks(once), 0.5 * jerks(path));
    EXPECT_LT(jerks(twice), jerks(once));
    for (const CameraPath* smooth : {&once, &twice}) {
        EXPECT_EQ(smooth->poses.front().eye, path.poses.front().eye);
        EXPECT_EQ(smooth->poses.back().target, path.poses.back().target);
    }
    // A straight flight has none, and stays.
    const CameraPath straight = shaken(0.0), same = smoothed(straight);
    for (size_t i = 0; i < straight.poses.size(); ++i) EXPECT_LT(glm::length(same.poses[i].eye - straight.poses[i].eye), 1e-12);
}

TEST(CameraPathEdits, smoothedLeavesEveryPoseACamera) {
    // Poses that look in opposite directions from one place: the mean of what they look at is the place itself.
    CameraPath path;
    for (const double x : {1.0, -1.0, 1.0, -1.0, 1.0}) path.poses.push_back({Vec3(0.0), Vec3(x, 0, 0), Vec3(0, 1, 0)});
    for (int i = 0; i < 3; ++i) {
        path = smoothed(path);
        for (size_t pose = 0; pose < path.poses.size(); ++pose) EXPECT_NO_THROW(validate(path.camera(pose), {640, 480}));
    }
    EXPECT_TRUE(smoothed(CameraPath{}).poses.empty());
}

}  // namespace
}  // namespace cullscope::test::camera_path_edits_test
