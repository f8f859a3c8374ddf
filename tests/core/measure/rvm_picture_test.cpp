// What an RVM file shows, against an OBJ that another program made of the same file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/measure/reference.h"
#include "core/mesh/save.h"
#include "core/scene/camera_moves.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"
#include "tests/support/random_views.h"
#include "tests/support/rvm_bytes.h"

namespace cullscope::test::rvm_picture_test {
namespace {

const std::filesystem::path kScenes = CULLSCOPE_SOURCE_DIR "/../shared/models/scenes";
const std::filesystem::path kPlant = kScenes / "huldra-WD1-PSUP.RVM";
const std::filesystem::path kPackedObj = kScenes / "huldra-WD1-PSUP-2185obj-110836t.obj.xz";

/// The OBJ cuts every circle into 24 chords, which lie up to 0.86 % of the radius inside it, and fills holes of facets. Its tubes
/// have radii of up to 0.2 m.
constexpr double kApart = 2e-3;

/// The forward distance of a reversed depth.
double distanceOf(const Camera& camera, float depth) {
    const double near = camera.nearDistance, far = camera.farDistance;
    return near * far / (double(depth) * (far - near) + near);
}

/// From all sides: every second one of the whole plant, the others from within it.
View viewOf(const Scene& scene, int number) {
    Random random(uint64_t(number) + 1);
    const Sphere& sphere = scene.boundingSphere();
    Vec3 direction = random.direction();
    direction.z = std::abs(direction.z);
    Camera camera;
    camera.fovy = Angle::fromDegrees(40.0);
    camera.target = sphere.centre + (number % 2 == 0 ? 0.0 : 0.3) * sphere.radius * random.direction();
    camera.eye = camera.target + (number % 2 == 0 ? 3.0 : 0.6) * sphere.radius * direction;
    camera.up = axisVector(UpAxis::Z);
    fitDepthRange(camera, scene);
    return {camera, {480, 360}};
}

struct Agreement {
    uint64_t pixels = 0, covered = 0, same = 0, sameObject = 0;

    [[nodiscard]] double share() const { return double(same) / double(pixels); }
    [[nodiscard]] double shareOfCovered() const { return 1.0 - double(pixels - same) / double(covered); }
};

/// The objects' names as both files can write them.
std::vector<std::string> namesOf(const Scene& scene) {
    std::vector<std::string> names;
    for (const Instance& instance : scene.instances()) {
        std::string name = instance.name.substr(0, instance.name.rfind(" ("));
        std::ranges::replace(name, ' ', '_');
        names.push_back(std::move(name));
    }
    return names;
}

void compare(const SceneBuffers& plant, const SceneBuffers& obj, const View& view, Agreement& total) {
    const Reference a = itemBufferReference(GlEnvironment::renderer(), plant, view, Facing::TwoSided);
    const Reference b = itemBufferReference(GlEnvironment::renderer(), obj, view, Facing::TwoSided);
    const std::vector<std::string> plantNames = namesOf(plant.scene()), objNames = namesOf(obj.scene());
    total.pixels += a.triangle.size();
    for (size_t i = 0; i < a.triangle.size(); ++i) {
        if (a.triangle[i] == 0 && b.triangle[i] == 0) {
            ++total.same;
            continue;
        }
        ++total.covered;
        if (a.triangle[i] == 0 || b.triangle[i] == 0) continue;
        const double apart = distanceOf(view.camera(), a.depth[i]) - distanceOf(view.camera(), b.depth[i]);
        const bool sameObject =
            plantNames[plant.scene().instanceOf(a.triangle[i] - 1)] == objNames[obj.scene().instanceOf(b.triangle[i] - 1)];
        if (std::abs(apart) < kApart || sameObject) ++total.same;
        if (sameObject) ++total.sameObject;
    }
}

class RvmPicture : public MeshFiles {};

TEST_F(RvmPicture, isThatOfTheObjThatIsExportedOfIt) {
    const ScenePointer scene = openScene(write("a.rvm", rvmSample()).string()).scene;
    std::vector<PlacedMesh> placed;
    for (uint32_t i = 0; i < scene->instances().size(); ++i)
        placed.push_back({scene->instances()[i].name, &scene->meshOf(i), scene->instances()[i].worldFromMesh});
    const std::filesystem::path file = write("a.obj", "");
    saveMeshFile(file, placed);
    const SceneBuffers rvm(scene, Upload::Vbo), obj(openScene(file.string()).scene, Upload::Vbo);
    ASSERT_EQ(rvm.scene().instances().size(), obj.scene().instances().size());
    EXPECT_EQ(rvm.scene().triangleCount(), obj.scene().triangleCount());
    Agreement total;
    for (int number = 0; number < 4; ++number) compare(rvm, obj, viewOf(*scene, number), total);
    EXPECT_GT(total.covered, 3'000u);
    EXPECT_GE(total.shareOfCovered(), 0.999);
}

TEST(RvmOfAPlatform, showsWhatAnObjOfTheSameFileShows) {
    if (!std::filesystem::exists(kPlant) || !std::filesystem::exists(kPackedObj))
        GTEST_SKIP() << "The plant " << kPlant << " and its OBJ are other people's and not part of this repository; "
                     << "the case above writes files of the same kinds.";
    const SceneBuffers plant(openScene(kPlant.string()).scene, Upload::Vbo);
    const SceneBuffers obj(openScene(kPackedObj.string()).scene, Upload::Vbo);
    ASSERT_EQ(plant.scene().instances().size(), obj.scene().instances().size());
    EXPECT_EQ(obj.scene().upAxis(), UpAxis::Z) << "guessed of the OBJ, as the RVM file says";
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(plant.scene().bounds().min[axis], obj.scene().bounds().min[axis], 2e-3);
        EXPECT_NEAR(plant.scene().bounds().max[axis], obj.scene().bounds().max[axis], 2e-3);
    }
    Agreement total;
    const int views = int(howMany(20, 2));
    for (int number = 0; number < views; ++number) compare(plant, obj, viewOf(plant.scene(), number), total);
    std::printf("%d views: %.3f %% of %llu pixels agree, %.3f %% of the %llu covered ones; the same object in %.3f %%\n", views,
                100.0 * total.share(), static_cast<unsigned long long>(total.pixels), 100.0 * total.shareOfCovered(),
                static_cast<unsigned long long>(total.covered), 100.0 * double(total.sameObject) / double(total.covered));
    EXPECT_GT(total.covered, total.pixels / 100);
    EXPECT_GE(total.share(), 0.999);
    EXPECT_GE(total.shareOfCovered(), 0.998);
}

}  // namespace
}  // namespace cullscope::test::rvm_picture_test
