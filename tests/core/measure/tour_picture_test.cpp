// What the poses of `tour:N` show of scenes that one stands in, by item buffer; and that they lie outside solids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "core/geometry/random.h"
#include "core/geometry/triangle.h"
#include "core/measure/reference.h"
#include "core/scene/eye_triangle.h"
#include "core/scene/split_scene.h"
#include "core/scene/tour.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/shared_models.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::tour_picture_test {
namespace {

/// The largest share of a picture's pixels that lie in one plane, to within a thousandth of the scene's radius.
double largestPlane(const Scene& scene, const View& view, const Reference& truth) {
    struct Plane {
        Vec3 normal;
        double offset;
        size_t pixels;
    };
    std::vector<Plane> planes;
    std::vector<uint32_t> triangles = truth.triangle;
    std::ranges::sort(triangles);
    for (size_t i = 0, end = 0; i < triangles.size(); i = end) {
        end = size_t(std::upper_bound(triangles.begin() + std::ptrdiff_t(i), triangles.end(), triangles[i]) - triangles.begin());
        if (triangles[i] == 0) continue;
        const size_t instance = scene.instanceOf(triangles[i] - 1);
        const auto [a, b, c] =
            InstanceFromEye(scene, instance, view.eye()).corners(triangles[i] - 1 - scene.firstTriangle(instance));
        const Vec3 across = glm::cross(b - a, c - a);
        if (!(glm::length(across) > 0.0)) continue;
        const Vec3 normal = glm::normalize(across);
        const double offset = glm::dot(normal, a);
        const auto same = std::ranges::find_if(planes, [&](const Plane& plane) {
            return std::abs(glm::dot(normal, plane.normal)) > 0.9999 &&
                   std::abs(std::abs(offset) - std::abs(plane.offset)) < 1e-3 * scene.boundingSphere().radius;
        });
        if (same != planes.end())
            same->pixels += end - i;
        else
            planes.push_back({normal, offset, end - i});
    }
    size_t most = 0;
    for (const Plane& plane : planes) most = std::max(most, plane.pixels);
    return double(most) / double(truth.triangle.size());
}

/// Whether a point lies inside a closed object: the sum of solid angles.
bool insideSolid(const Scene& scene, const Vec3& point) {
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        if (!scene.frontFacesSuffice(i)) continue;
        const Box3& box = scene.instanceBox(i);
        if (glm::any(glm::lessThan(point, box.min)) || glm::any(glm::greaterThan(point, box.max))) continue;
        const InstanceFromEye instance(scene, i, point);
        double sum = 0.0;
        for (uint64_t triangle = 0; triangle < scene.meshOf(i).triangleCount(); ++triangle)
            sum += solidAngle(instance.corners(triangle));
        if (std::abs(sum) > 2.0 * kPi) return true;
    }
    return false;
}

void expectGoodTour(const std::string& name, const ScenePointer& scene) {
    constexpr size_t kPoses = 24;
    constexpr double kMostOfPlane = 0.6, kMostOfObject = 0.85;
    const CameraPath path = tour(*scene, kPoses);
    const SceneBuffers buffers(scene, Upload::Vbo);
    size_t seen = 0, fewest = SIZE_MAX;
    double widestPlane = 0.0, widestObject = 0.0;
    for (size_t pose = 0; pose < kPoses; ++pose) {
        EXPECT_FALSE(insideSolid(*scene, path.poses[pose].eye)) << name << ", pose " << pose;
        const View view(path.camera(pose), {320, 240});
        const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
        std::vector<size_t> pixels(scene->instances().size(), 0);
        for (const uint32_t item : truth.triangle)
            if (item != 0) ++pixels[scene->instanceOf(item - 1)];
        const size_t objects = pixels.size() - size_t(std::ranges::count(pixels, size_t{0}));
        seen += objects;
        fewest = std::min(fewest, objects);
        widestPlane = std::max(widestPlane, largestPlane(*scene, view, truth));
        widestObject = std::max(widestObject, double(*std::ranges::max_element(pixels)) / double(truth.triangle.size()));
    }
    std::printf("tour: %s: %.1f objects a pose, at least %zu; widest plane %.2f, widest object %.2f of the picture\n",
                name.c_str(), double(seen) / kPoses, fewest, widestPlane, widestObject);
    EXPECT_GE(double(seen) / kPoses, std::min(20.0, 0.5 * double(scene->instances().size()))) << name;
    EXPECT_LE(widestPlane, kMostOfPlane) << name;
    if (scene->instances().size() > 1) EXPECT_LE(widestObject, kMostOfObject) << name;
}

TEST(TourPicture, showsManyObjectsAndNoWallOfAGeneratedTown) {
    // Blocks of houses along streets, on one ground.
    std::vector<MeshPointer> meshes{boxMesh({-14, -0.2f, -14}, {14, 0, 14})};
    std::vector<Mat4> places{Mat4(1.0)};
    Random random(5);
    for (int x = -6; x < 6; ++x)
        for (int z = -6; z < 6; ++z) {
            meshes.push_back(boxMesh({-0.7f, 0, -0.7f}, {0.7f, 1, 0.7f}));
            places.push_back(translation({2.2 * x + 1.1, 0, 2.2 * z + 1.1}) * scaling({1, random.between(0.3, 3.0), 1}));
        }
    const ScenePointer town = sceneOf(meshes, places);
    EXPECT_TRUE(isStoodIn(*town));
    expectGoodTour("town", town);
}

class SharedScene : public testing::TestWithParam<const char*> {};

TEST_P(SharedScene, isShownByItsTour) {
    const std::optional<ScenePointer> scene = sharedScene(GetParam());
    if (!scene)
        GTEST_SKIP() << GetParam() << " is other people's and not part of this repository; the case above generates a town.";
    EXPECT_TRUE(isStoodIn(**scene));
    expectGoodTour(GetParam(), *scene);
}

/// Small samples leave out the largest ones: their code is that of the others.
std::vector<const char*> sharedScenes() {
    std::vector<const char*> files{"openarena-oa_minia.obj",
                                   "fzk-haus-ifc-294obj-35906t.obj",
                                   "pcb-pic_programmer-57obj.obj.xz",
                                   "openarena-oasago2.obj",
                                   "openarena-czest2ctf.obj",
                                   "openarena-ctf_compromise.obj",
                                   "sponza-262267t.obj.xz",
                                   "intel-castle-2114obj-1070891t.obj.xz",
                                   "pcb-kit-dev-coldfire-xilinx_5213-159obj.obj.xz"};
    if (fewSamples()) files.resize(3);
    return files;
}

INSTANTIATE_TEST_SUITE_P(TourPicture, SharedScene, testing::ValuesIn(sharedScenes()));

}  // namespace
}  // namespace cullscope::test::tour_picture_test
