#include "core/scene/plant/plant_scene.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "core/base/error.h"
#include "core/scene/scene_source.h"

namespace cullscope::test::plant_scene_test {
namespace {

ScenePointer plantOf(const std::string& parameters) { return openScene("plant:" + parameters).scene; }

/// One plant for the cases that only look at it.
const ScenePointer& hundred() {
    static const ScenePointer scene = plantOf("pipelines=100,seed=1");
    return scene;
}

TEST(Plant, hasItsPipelinesWithEnoughComponentsAndTriangles) {
    const Scene& scene = *hundred();
    std::map<uint32_t, size_t> perGroup;
    for (const Instance& instance : scene.instances()) ++perGroup[instance.group];
    size_t pipelines = 0, components = 0;
    const std::vector<ObjectGroup>& groups = scene.remarks().components->groups;
    for (uint32_t group = 0; group < groups.size(); ++group) {
        if (!groups[group].name.starts_with("L0")) continue;
        if (!perGroup.contains(group)) continue;
        ++pipelines;
        components += perGroup[group];
        EXPECT_GE(perGroup[group], 12u) << groups[group].name;
    }
    EXPECT_GE(pipelines, 100u);
    EXPECT_GE(scene.instances().size(), 20u * 100u);
    EXPECT_GE(scene.triangleCount(), 1000u * 100u);
    EXPECT_GE(components, 20u * 100u) << "of pipelines alone";
    for (const size_t count : {1u, 19u, 21u})
        EXPECT_GT(plantOf("pipelines=" + std::to_string(count))->instances().size(), 20 * count);
}

TEST(Plant, isBuiltOfAllEighteenPrimitives) {
    const std::map<std::string, uint64_t> counts = plantOf("pipelines=400,seed=1")->partCounts();
    for (size_t kind = 0; kind < primitive::kKinds; ++kind)
        EXPECT_TRUE(counts.contains(primitive::kindName(kind))) << primitive::kindName(kind);
}

TEST(Plant, hasTheComponentsOfAPlant) {
    std::set<std::string> kinds;
    const ScenePointer scene = plantOf("pipelines=200,seed=3");
    for (const MeshPointer& mesh : scene->meshes()) kinds.insert(mesh->name());
    EXPECT_THAT(kinds,
                testing::IsSupersetOf({"pipe", "elbow", "tee", "reducer", "flange", "bolt", "valve", "support", "column", "drum",
                                       "exchanger", "pump", "tank", "platform", "ladder", "beam", "post", "roof rail"}));
}

TEST(Plant, meshesAreClosedAndFaceOutward) {
    for (const MeshPointer& mesh : hundred()->meshes())
        EXPECT_TRUE(mesh->topology().frontFacesSuffice()) << mesh->name() << " " << mesh->topology().nonManifoldEdges;
}

/// How far the triangles of cylinders lie within the surfaces that they stand for, in metres.
double deepestChord(const Scene& scene) {
    double deepest = 0.0;
    for (size_t i = 0; i < scene.instances().size(); ++i)
        for (const MeshPart& part : scene.partsOf(i)) {
            const auto* cylinder = std::get_if<primitive::Cylinder>(&part.solid);
            if (cylinder == nullptr || scene.meshOf(i).name() == "bolt") continue;
            const TriangleMesh& mesh = scene.meshOf(i);
            const Mat4 own = glm::inverse(part.meshFromSolid);
            for (size_t corner = 3 * size_t(part.firstTriangle); corner < 3 * size_t(part.firstTriangle + part.triangleCount);
                 ++corner) {
                const size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
                const Vec3 from(own * Vec4(mesh.position(mesh.indices()[corner]), 1.0));
                const Vec3 to(own * Vec4(mesh.position(mesh.indices()[next]), 1.0));
                // Edges of the caps run inside.
                if (std::abs(from.z - to.z) < 0.5 * cylinder->height) continue;
                deepest = std::max(deepest, cylinder->radius - 0.5 * glm::length(Vec2(from.x + to.x, from.y + to.y)));
            }
        }
    return deepest;
}

TEST(Plant, trianglesLieWithinTheErrorThatIsAskedFor) {
    EXPECT_GT(deepestChord(*hundred()), 0.004) << "the usual chords";
    size_t triangles = hundred()->triangleCount();
    for (const auto& [text, metres] : {std::pair("1", 0.001), {"0.1", 0.0001}}) {
        const ScenePointer scene = plantOf(std::string("pipelines=100,seed=1,chord=") + text);
        EXPECT_LE(deepestChord(*scene), metres * 1.001) << text;
        EXPECT_GT(deepestChord(*scene), 0.2 * metres) << text << ": no finer than needed";
        EXPECT_GT(scene->triangleCount(), triangles);
        triangles = scene->triangleCount();
        EXPECT_EQ(scene->instances().size(), hundred()->instances().size());
        for (const MeshPointer& mesh : scene->meshes())
            EXPECT_TRUE(mesh->topology().frontFacesSuffice()) << text << " " << mesh->name();
    }
}

TEST(Plant, objectsHaveDistinctNamesAndStandOnTheGround) {
    const Scene& scene = *hundred();
    std::set<std::string> names;
    for (const Instance& instance : scene.instances()) {
        EXPECT_TRUE(names.insert(instance.name).second) << instance.name;
        EXPECT_TRUE(instance.name.starts_with(scene.remarks().components->groups[instance.group].name + "/"));
    }
    EXPECT_GT(scene.bounds().min.z, -0.5);
    EXPECT_LT(scene.bounds().max.z, 40.0);
    EXPECT_EQ(scene.remarks().up, UpAxis::Z);
}

TEST(Plant, equalComponentsShareAMesh) {
    const ScenePointer scene = plantOf("pipelines=400,seed=2");
    EXPECT_LT(scene->meshes().size() * 8, scene->instances().size());
    EXPECT_LT(scene->bytes(), 400u * 40'000u);
}

/// The ends of a straight pipe meet another component of the same pipeline.
TEST(Plant, pipesAreConnected) {
    const Scene& scene = *hundred();
    std::map<uint32_t, std::vector<size_t>> ofGroup;
    for (size_t i = 0; i < scene.instances().size(); ++i) ofGroup[scene.instances()[i].group].push_back(i);
    size_t looked = 0;
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        if (scene.meshOf(i).name() != "pipe") continue;
        const auto& pipe = std::get<primitive::Cylinder>(scene.partsOf(i)[0].solid);
        for (const double side : {-0.5, 0.5}) {
            const Vec3 end(instance.worldFromMesh * Vec4(0, 0, side * pipe.height, 1));
            const bool meets = std::ranges::any_of(ofGroup[instance.group], [&](size_t other) {
                const Box3& box = scene.instanceBox(other);
                constexpr double kRoom = 0.002;
                return other != i && glm::all(glm::greaterThan(end, box.min - kRoom)) &&
                       glm::all(glm::lessThan(end, box.max + kRoom));
            });
            EXPECT_TRUE(meets) << instance.name;
            ++looked;
        }
    }
    EXPECT_GT(looked, 1000u);
}

TEST(Plant, isTheSameForASeedOnEveryMachine) {
    EXPECT_EQ(hundred()->sha256(), plantOf("seed=1,pipelines=100")->sha256());
    EXPECT_NE(hundred()->sha256(), plantOf("pipelines=100,seed=2")->sha256());
    EXPECT_EQ(plantOf("pipelines=40,seed=7")->sha256(), "6a0a804216bbe7b91800e41f09f087feaaf341b30e2102f752a92a690054ca73");
}

TEST(Plant, refusesWhatIsNoPlantAndCanBeStopped) {
    EXPECT_THROW((void)plantOf("pipelines=0"), Error);
    EXPECT_THROW((void)plantOf("pipelines=1e9"), Error);
    EXPECT_THROW((void)plantOf("seed=-1"), Error);
    for (const char* chord : {"0", "0.05", "101", "nan"})
        EXPECT_THROW((void)plantOf(std::string("chord=") + chord), Error) << chord;
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    EXPECT_THROW((void)openScene("plant:pipelines=40", {}, progress), Error);
}

}  // namespace
}  // namespace cullscope::test::plant_scene_test
