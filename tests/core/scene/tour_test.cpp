#include "core/scene/tour.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/scene/scene_source.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::tour_test {
namespace {

/// A ground and boxes on it, in a square of side 2. Free space is known: it is what no box holds.
struct City {
    std::vector<Box3> boxes;  ///< the first one is the ground
    ScenePointer scene;       ///< the boxes turned so that another axis may be up, scaled and moved
    Mat4 place{1.0};
    UpAxis up = UpAxis::Y;
};

/// Towers of all heights, close to each other; every fourth city has a roof over a part of it.
City city(uint64_t seed) {
    Random random(seed);
    City city;
    city.boxes.push_back({{-1, -0.1, -1}, {1, 0, 1}});
    const int count = 10 + int(random.between(0, 60));
    for (int i = 0; i < count; ++i) {
        const Vec3 half(random.between(0.02, 0.12), 0.5 * random.between(0.05, 0.6), random.between(0.02, 0.12));
        const Vec3 at(random.between(-0.85, 0.85), half.y - 0.01, random.between(-0.85, 0.85));
        city.boxes.push_back({at - half, at + half});
    }
    if (seed % 4 == 0) city.boxes.push_back({{-0.7, 0.7, -0.7}, {0.4, 0.75, 0.6}});
    city.up = seed % 2 == 0 ? UpAxis::Z : UpAxis::Y;
    if (city.up == UpAxis::Z) {  // (x, y, z) becomes (x, −z, y)
        city.place[1] = Vec4(0, 0, 1, 0);
        city.place[2] = Vec4(0, -1, 0, 0);
    }
    if (seed % 3 == 0) city.place[0] = -city.place[0];  // mirrored
    const double scale = std::pow(10.0, random.between(-4, 4));
    city.place = translation(scale * 100.0 * random.direction()) * scaling(Vec3(scale)) * city.place;
    std::vector<MeshPointer> meshes;
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < city.boxes.size(); ++i) {
        meshes.push_back(boxMesh(Vec3f(city.boxes[i].min), Vec3f(city.boxes[i].max)));
        instances.push_back({i, city.place, "box"});
    }
    SceneRemarks remarks;
    remarks.up = city.up;
    city.scene = std::make_shared<Scene>("city", meshes, instances, nullptr, remarks);
    return city;
}

TEST(Tour, standsInFreeSpaceAboveTheGround) {
    size_t inside = 0, poses = 0;
    for (uint64_t seed = 1; seed <= howMany(200, 24); ++seed) {
        const City built = city(seed);
        const CameraPath path = tour(*built.scene, 12);
        EXPECT_EQ(path.name, "tour:12");
        ASSERT_EQ(path.poses.size(), 12u);
        const Mat4 back = glm::inverse(built.place);
        for (const CameraPath::Pose& pose : path.poses) {
            const Vec3 eye(back * Vec4(pose.eye, 1.0));
            EXPECT_EQ(pose.up, built.up == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0));
            EXPECT_GT(eye.y, 0.0) << "seed " << seed << ": below the ground";
            EXPECT_LT(std::max(std::abs(eye.x), std::abs(eye.z)), 1.0) << "seed " << seed << ": beside the ground";
            for (const Box3& box : built.boxes)
                inside += glm::all(glm::greaterThan(eye, box.min)) && glm::all(glm::lessThan(eye, box.max)) ? 1 : 0;
            ++poses;
        }
        for (size_t pose = 0; pose < path.poses.size(); ++pose) EXPECT_NO_THROW(validate(path.camera(pose), {640, 480}));
    }
    EXPECT_EQ(inside, 0u) << "of " << poses;
}

TEST(Tour, noSurfaceIsNearerThanTheNearPlane) {
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        const City built = city(seed);
        const double scale = glm::length(Vec3(built.place[0]));
        const CameraPath path = tour(*built.scene, 600);  // goes round again, slightly aside
        for (const CameraPath::Pose& pose : path.poses) {
            const Vec3 eye(glm::inverse(built.place) * Vec4(pose.eye, 1.0));
            for (const Box3& box : built.boxes) {
                const double apart = glm::length(eye - glm::clamp(eye, box.min, box.max));
                EXPECT_GT(apart * scale, 1.5 * path.nearDistance) << "seed " << seed;
            }
        }
    }
}

TEST(Tour, isTheSameEveryTimeAndHasDifferentPoses) {
    const City built = city(7);
    const CameraPath first = tour(*built.scene, 700), second = tour(*built.scene, 700);
    EXPECT_EQ(first.nearDistance, second.nearDistance);
    std::vector<std::array<double, 6>> views;
    for (size_t i = 0; i < first.poses.size(); ++i) {
        const CameraPath::Pose &a = first.poses[i], &b = second.poses[i];
        EXPECT_EQ(a.eye, b.eye);
        EXPECT_EQ(a.target, b.target);
        views.push_back({a.eye.x, a.eye.y, a.eye.z, a.target.x, a.target.y, a.target.z});
    }
    std::ranges::sort(views);
    EXPECT_TRUE(std::ranges::adjacent_find(views) == views.end()) << "two poses are the same";
}

TEST(Tour, staysInTheRoomsOfABuildingWhoseWallsHaveOneSide) {
    // A hall of six walls that face inward, with columns: outside it only back faces are to be seen.
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    const MeshPointer hall = boxMesh({-3, 0, -2}, {3, 2, 2});
    std::vector<uint32_t> inward(hall->indices().begin(), hall->indices().end());
    for (size_t i = 0; i < inward.size(); i += 3) std::swap(inward[i], inward[i + 1]);
    meshes.push_back(meshOf({hall->positions().begin(), hall->positions().end()}, inward));
    for (int i = 0; i < 12; ++i) {
        meshes.push_back(boxMesh({-0.1f, 0, -0.1f}, {0.1f, 1.5f, 0.1f}));
        places.push_back(translation({-2.5 + i % 6, 0, i < 6 ? -1.0 : 1.0}));
    }
    places.insert(places.begin(), Mat4(1.0));
    const ScenePointer scene = sceneOf(meshes, places);
    EXPECT_TRUE(isStoodIn(*scene));
    for (const CameraPath::Pose& pose : tour(*scene, 24).poses) {
        EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(pose.eye - Vec3(0, 1, 0)), Vec3(3, 1, 2)))) << "outside the hall";
    }
}

TEST(Tour, goesAroundWhatHasNoFloor) {
    for (const ScenePointer& scene :
         {sceneOf({squareMesh(1, 0)}), sceneOf({meshOf({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {0, 1, 2})}),
          ScenePointer(std::make_shared<Scene>("empty", std::vector<MeshPointer>{}, std::vector<Instance>{}))}) {
        const CameraPath path = tour(*scene, 5), around = cameraPath("orbit:5", *scene);
        ASSERT_EQ(path.poses.size(), 5u);
        for (size_t i = 0; i < 5; ++i) EXPECT_EQ(path.poses[i].eye, around.poses[i].eye);
        EXPECT_EQ(path.name, "tour:5");
    }
}

TEST(Tour, isTheDefaultWhereOneStandsInTheScene) {
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const City built = city(seed);
        if (built.boxes.size() < 40) continue;
        EXPECT_TRUE(isStoodIn(*built.scene)) << seed;
        EXPECT_EQ(defaultPathName(*built.scene), "tour:16") << seed;
    }
    for (const char* around : {"teapot", "sphere:triangles=2000", "torus:triangles=2000", "knot:triangles=4000",
                               "star:seed=7,triangles=3000", "field:mesh=teapot:triangles=1000,n=5"})
        EXPECT_FALSE(isStoodIn(*openScene(around).scene)) << around;
}

TEST(Tour, stopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const City built = city(3);
    try {
        (void)tour(*built.scene, 12, {nullptr, source.get_token()});
        FAIL() << "the tour was made";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
    }
}

}  // namespace
}  // namespace cullscope::test::tour_test
