#include "core/scene/quake/quake_scene.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/base/error.h"
#include "core/scene/hidden.h"
#include "core/scene/quake/bezier_patch.h"
#include "core/scene/quake/level.h"
#include "core/scene/scene_source.h"
#include "tests/support/changed_files.h"
#include "tests/support/ibsp_bytes.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::quake_scene_test {
namespace {

using testing::HasSubstr;

class Quake : public MeshFiles {
protected:
    [[nodiscard]] FileScene read(std::string_view bytes) const { return readQuakeFile(write("a.bsp", bytes)); }
    [[nodiscard]] quake::Level level(std::string_view bytes) const {
        ByteSource source(write("a.bsp", bytes), {}, false);
        return quake::readLevel(source, [](uint64_t) {});
    }
    [[nodiscard]] std::string refused(const IbspBytes& level) const { return refusedBytes(level.bytes()); }
    [[nodiscard]] std::string refusedBytes(std::string_view bytes) const {
        try {
            (void)read(bytes);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            return error.what();
        }
        return {};
    }
};

TEST_F(Quake, drawSurfacesBecomeObjectsNamedByShaderAndNumber) {
    const FileScene read = this->read(ibspSample().bytes());
    std::vector<std::string> names;
    for (const Instance& instance : read.scene->instances()) names.push_back(instance.name);
    EXPECT_THAT(names, testing::ElementsAre("textures/wall #0", "textures/wall #1", "textures/door #4 (func_door *1)"));
    EXPECT_EQ(read.scene->remarks().up, UpAxis::Z);
    EXPECT_EQ(read.scene->triangleCount(), 2u + 2 * quake::kPatchChords * quake::kPatchChords + 1);
    std::vector<std::string> remarks;
    for (const Message& remark : read.report.remarks) remarks.push_back(remark.english());
    EXPECT_THAT(remarks, testing::ElementsAre("Surfaces left out that the game does not draw, or draws as sky: 1.",
                                              "Billboards left out, which have no place of their own: 1."));
}

TEST_F(Quake, modelsStandAtTheOriginOfTheirEntity) {
    const ScenePointer scene = read(ibspSample().bytes()).scene;
    const Box3& door = scene->instanceBox(2);
    EXPECT_NEAR(door.min.x, 100.0, 1e-5);
    EXPECT_NEAR(door.max.x, 108.0, 1e-5);
    IbspBytes twice = ibspSample();
    twice.entities("{ \"model\" \"*1\" \"origin\" \"0 0 50\" \"classname\" \"func_static\" }");
    const ScenePointer both = read(twice.bytes()).scene;
    ASSERT_EQ(both->instances().size(), 4u);
    EXPECT_EQ(both->instances()[2].mesh, both->instances()[3].mesh) << "one mesh at two places";
    IbspBytes nowhere = ibspSample();
    nowhere.model(4, 1);
    EXPECT_THAT(read(nowhere.bytes()).report.remarks.back().english(), HasSubstr("of models that no entity places: 1."));
}

TEST_F(Quake, frontFacesAreCounterClockwiseAsTheirNormalsSay) {
    const ScenePointer scene = read(ibspSample().bytes()).scene;
    for (size_t i = 0; i < scene->instances().size(); ++i) {
        const TriangleMesh& mesh = scene->meshOf(i);
        for (size_t corner = 0; corner < mesh.indices().size(); corner += 3) {
            const Vec3 a = mesh.position(mesh.indices()[corner]), b = mesh.position(mesh.indices()[corner + 1]);
            const Vec3 c = mesh.position(mesh.indices()[corner + 2]);
            EXPECT_GT(glm::cross(b - a, c - a).z, 0.0) << scene->instances()[i].name << ", triangle " << corner / 3;
        }
    }
}

TEST_F(Quake, theFirstViewIsThePlayers) {
    const std::optional<Camera> camera = read(ibspSample().bytes()).scene->remarks().camera;
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->eye, Vec3(1, 2, 29));
    EXPECT_GT(camera->target.y, 3.0);
    EXPECT_NEAR(camera->target.x, 1.0, 1e-9);
}

TEST_F(Quake, placesHaveLeavesAndClustersSeeWhatTheirBitsSay) {
    const quake::Level level = this->level(ibspSample().bytes());
    const quake::Leaf& left = level.leaves[level.leafAt({0, 0, 0})];
    const quake::Leaf& right = level.leaves[level.leafAt({5, 0, 0})];
    EXPECT_EQ(left.cluster, 0);
    EXPECT_EQ(right.cluster, 1);
    EXPECT_EQ(level.leafAt({4, 0, 0}), level.leafAt({5, 0, 0})) << "a place on the plane is in front";
    EXPECT_THAT(level.surfacesOf(left), testing::ElementsAre(0u, 1u));
    EXPECT_TRUE(level.mayBeSeen(0, 0));
    EXPECT_TRUE(level.mayBeSeen(0, 1));
    EXPECT_FALSE(level.mayBeSeen(1, 0));
    EXPECT_TRUE(level.mayBeSeen(1, 1));
    EXPECT_FALSE(level.mayBeSeen(-1, 0));
}

TEST_F(Quake, sceneHasTheLevelsSetsByObject) {
    const ScenePointer scene = read(ibspSample().bytes()).scene;
    const RegionSetsPointer sets = scene->remarks().visibility;
    ASSERT_NE(sets, nullptr);
    const auto seenFrom = [&](const Vec3& place) {
        std::vector<std::string> names;
        for (const uint32_t object : sets->objectsOf(sets->regionAt(place).value()))
            names.push_back(scene->instances()[object].name);
        return names;
    };
    using testing::ElementsAre, testing::HasSubstr;
    EXPECT_THAT(seenFrom({0, 0, 0}), ElementsAre("textures/wall #0", "textures/wall #1", HasSubstr("func_door")));
    EXPECT_THAT(seenFrom({5, 0, 0}), ElementsAre("textures/wall #0", HasSubstr("func_door")))
        << "cluster 1 does not see cluster 0";
    std::vector<bool> hidden(scene->instances().size(), false);
    hidden[0] = true;
    const RegionSetsPointer rest = withoutInstances(scene, hidden)->remarks().visibility;
    EXPECT_THAT(rest->objectsOf(rest->regionAt({5, 0, 0}).value()), ElementsAre(1u)) << "numbers follow hidden objects";
}

TEST(QuakePatch, cornersLieOnTheExactSurface) {
    std::mt19937 random(20261126);
    std::uniform_real_distribution<float> coordinate(-512.0F, 512.0F);
    for (int round = 0; round < int(howMany(300, 30)); ++round) {
        const uint32_t width = 3 + 2 * (random() % 3), height = 3 + 2 * (random() % 3), chords = 1 + random() % 8;
        std::vector<Vec3f> control(size_t(width) * height);
        for (Vec3f& point : control) point = {coordinate(random), coordinate(random), coordinate(random)};
        const quake::PatchSurface surface = quake::tessellatePatch(control, width, height, chords);
        const uint32_t columns = (width - 1) / 2 * chords + 1, rows = (height - 1) / 2 * chords + 1;
        ASSERT_EQ(surface.positions.size(), size_t(columns) * rows);
        for (uint32_t row = 0; row < rows; ++row)
            for (uint32_t column = 0; column < columns; ++column) {
                const uint32_t left = std::min(column / chords * 2, width - 3), top = std::min(row / chords * 2, height - 3);
                const double u = double(column) / chords - left / 2, v = double(row) / chords - top / 2;
                Vec3 exact(0.0);
                for (uint32_t j = 0; j < 3; ++j)
                    for (uint32_t i = 0; i < 3; ++i) {
                        const auto weight = [](uint32_t k, double t) {
                            return k == 0 ? (1 - t) * (1 - t) : k == 1 ? 2 * t * (1 - t) : t * t;
                        };
                        exact += weight(i, u) * weight(j, v) * Vec3(control[size_t(top + j) * width + left + i]);
                    }
                const Vec3 got(surface.positions[size_t(row) * columns + column]);
                ASSERT_LT(glm::distance(got, exact), 1e-3) << "round " << round << ", row " << row << ", column " << column;
            }
    }
}

TEST(QuakePatch, neighboursHaveTheSameCornersAtTheirBorder) {
    std::mt19937 random(20261126);
    std::uniform_real_distribution<float> coordinate(-4096.0F, 4096.0F);
    for (int round = 0; round < int(howMany(3000, 300)); ++round) {
        std::vector<Vec3f> first(9), second(9);
        for (Vec3f& point : first) point = {coordinate(random), coordinate(random), coordinate(random)};
        for (Vec3f& point : second) point = {coordinate(random), coordinate(random), coordinate(random)};
        // The last column of the first is the first row of the second, backwards.
        for (size_t i = 0; i < 3; ++i) second[i] = first[3 * (2 - i) + 2];
        const quake::PatchSurface a = quake::tessellatePatch(first, 3, 3), b = quake::tessellatePatch(second, 3, 3);
        const uint32_t side = quake::kPatchChords + 1;
        for (uint32_t i = 0; i < side; ++i)
            ASSERT_EQ(a.positions[size_t(i) * side + side - 1], b.positions[side - 1 - i])
                << "round " << round << ", corner " << i;
    }
}

TEST_F(Quake, malformedFilesAreRefusedWithTheByte) {
    const std::string good = ibspSample().bytes();
    EXPECT_THAT(refusedBytes("VBSP, of another game"), HasSubstr("does not begin with IBSP"));
    EXPECT_THAT(refusedBytes(good.substr(0, 100)), HasSubstr("ends at byte 100"));
    EXPECT_THAT(refused(ibspSample().version(47)), HasSubstr("a level of version 47; only version 46"));
    EXPECT_THAT(refusedBytes(good.substr(0, good.size() - 1)), HasSubstr("byte 136: an array of the level is to end at byte"));
    const auto at = [](IbspBytes::Lump lump, size_t record) {
        return "byte " + std::to_string(ibspSample().placeOf(lump) + record) + ":";
    };
    std::string odd = good;
    odd[8 + 8 * IbspBytes::Planes + 4] = 15;
    EXPECT_THAT(refusedBytes(odd), HasSubstr("byte 24: an array of the level ends within a record"));
    EXPECT_THAT(refused(ibspSample().surface(3, 1, 0, 4, 0, 6)),
                HasSubstr("names 1 items from number 3 on, but the file has 3 of"));
    EXPECT_THAT(refused(ibspSample().surface(0, 5, 0, 4, 0, 6)), HasSubstr("there is no surface of kind 5"));
    EXPECT_THAT(refused(ibspSample().surface(0, 1, 10, 4, 0, 6)),
                HasSubstr("names 4 items from number 10 on, but the file has 13 of"));
    EXPECT_THAT(refused(ibspSample().surface(0, 1, 0, 4, -1, 6)),
                HasSubstr("names 6 items from number -1 on, but the file has 6 of"));
    EXPECT_THAT(refused(ibspSample().surface(0, 2, 0, 4, 0, 0, 2, 2)), HasSubstr("a patch has 2 × 2 control points"));
    EXPECT_THAT(refused(ibspSample().surface(0, 2, 0, 9, 0, 0, 3, 5)), HasSubstr("a patch has 3 × 5 control points"));
    EXPECT_THAT(refused(ibspSample().model(0, 6)), HasSubstr("names 6 items from number 0 on, but the file has 5 of"));
    EXPECT_THAT(refused(ibspSample().leafSurface(5)), HasSubstr("names 1 items from number 5 on, but the file has 5 of"));
    EXPECT_THAT(refused(ibspSample().leaf(0, 0, 4)), HasSubstr("names 4 items from number 0 on, but the file has 3 of"));
    EXPECT_THAT(refused(ibspSample().leaf(2, 0, 0)), HasSubstr("names 1 items from number 2 on, but the file has 2 of"));
    EXPECT_THAT(refused(ibspSample().node(1, -1, -1)), HasSubstr("names 1 items from number 1 on, but the file has 1 of"));
    EXPECT_THAT(refused(ibspSample().node(0, -3, -1)), HasSubstr("names 1 items from number 2 on, but the file has 2 of"));
    EXPECT_THAT(refused(ibspSample().node(0, 0, -1)), HasSubstr("the node 0 of the BSP tree has two parents"));
    EXPECT_THAT(refused(ibspSample().entities("{ \"model")), HasSubstr("the text of the level's entities"));
    EXPECT_THAT(refused(ibspSample().entities("x")), HasSubstr(at(IbspBytes::Shaders, 0).substr(0, 5)));
    std::string unseen = good;
    unseen[unseen.size() - 10] = 100;
    EXPECT_THAT(refusedBytes(unseen), HasSubstr("no room for which of 100 clusters see which"));
    EXPECT_THAT(refused(IbspBytes().shader("a").model(0, 0)), HasSubstr("holds no faces"));
}

TEST_F(Quake, cornersOfNoVertexAndSurfacesBeyondTheMemoryAreTold) {
    EXPECT_EQ(read(ibspSample().corners({0, 1, 4}).surface(0, 1, 0, 4, 6, 3).model(5, 1).entities("{\"model\" \"*2\"}").bytes())
                  .report.outOfRangeFaces,
              1u);
    LoadOptions options;
    options.memoryLimitBytes = 4000;
    try {
        (void)readQuakeFile(write("a.bsp", ibspSample().bytes()), options);
        FAIL() << "was not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("of memory"));
    }
}

TEST_F(Quake, everyTruncationAndEverySeededMutationLoadsOrIsRefused) {
    EXPECT_TRUE(
        everyChangeLoadsOrIsRefused(ibspSample().bytes(), "a.bsp", [&](std::string_view bytes) { return read(bytes).scene; }));
}

const std::filesystem::path kScenes = CULLSCOPE_SOURCE_DIR "/../shared/models/scenes";
const std::filesystem::path kLevel = kScenes / "openarena-oa_minia.bsp.xz";

class QuakeLevel : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kLevel))
            GTEST_SKIP() << "The level " << kLevel
                         << " is other people's and not part of this repository; the cases above write files.";
    }
    static quake::Level readIt() {
        ByteSource source(kLevel, {}, false);
        return quake::readLevel(source, [](uint64_t) {});
    }
};

/// The triangles of a scene by their corners in eighths of the unit, sorted: that mesh has
/// the curved surfaces with their back sides in front.
std::map<std::array<int, 9>, int> trianglesOf(const Scene& scene) {
    std::map<std::array<int, 9>, int> triangles;
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        const TriangleMesh& mesh = scene.meshOf(i);
        for (size_t at = 0; at < mesh.indices().size(); at += 3) {
            std::array<std::array<int, 3>, 3> corners{};
            for (size_t k = 0; k < 3; ++k) {
                const Vec3 place = mesh.position(mesh.indices()[at + k]);
                for (int axis = 0; axis < 3; ++axis) corners[k][size_t(axis)] = int(std::lround(8.0 * place[axis]));
            }
            std::sort(corners.begin(), corners.end());
            std::array<int, 9> key{};
            for (size_t k = 0; k < 9; ++k) key[k] = corners[k / 3][k % 3];
            ++triangles[key];
        }
    }
    return triangles;
}

TEST_F(QuakeLevel, hasTheTrianglesThatAnotherProgramMadeOfIt) {
    const std::filesystem::path mesh = kScenes / "openarena-oa_minia.obj";
    if (!std::filesystem::exists(mesh))
        GTEST_SKIP() << "The mesh " << mesh << " is other people's and not part of this repository.";
    const ScenePointer read = openScene(kLevel.string()).scene, other = openScene(mesh.string()).scene;
    EXPECT_EQ(read->instances().size(), other->instances().size());
    std::map<std::array<int, 9>, int> mine = trianglesOf(*read);
    size_t common = 0, missing = 0;
    for (const auto& [corners, count] : trianglesOf(*other)) {
        const auto found = mine.find(corners);
        const int both = found == mine.end() ? 0 : std::min(count, found->second);
        common += size_t(both);
        missing += size_t(count - both);
        if (found != mine.end()) found->second -= both;
    }
    size_t more = 0;
    for (const auto& [corners, count] : mine) more += size_t(count);
    std::printf("%zu triangles in both, %zu in the other program's mesh alone, %zu here alone\n", common, missing, more);
    EXPECT_EQ(common + missing, other->triangleCount());
    // Their mesh rounds coordinates; those at the border of an eighth differ.
    EXPECT_LT(missing, other->triangleCount() / 100);
    EXPECT_LT(more, read->triangleCount() / 100);
}

TEST_F(QuakeLevel, frontsAreWhereTheNormalsOfTheFilePoint) {
    const quake::Level level = readIt();
    const ScenePointer scene = openScene(kLevel.string()).scene;
    std::map<quake::Surface::Kind, std::array<size_t, 2>> agree;
    for (size_t i = 0; i < scene->instances().size(); ++i) {
        const std::string& name = scene->instances()[i].name;
        const quake::Surface& surface = level.surfaces[std::stoul(name.substr(name.rfind('#') + 1))];
        const TriangleMesh& mesh = scene->meshOf(i);
        double together = 0.0;
        for (size_t at = 0; at < mesh.indices().size(); at += 3) {
            const Vec3 a = mesh.position(mesh.indices()[at]);
            const Vec3 facing = glm::cross(mesh.position(mesh.indices()[at + 1]) - a, mesh.position(mesh.indices()[at + 2]) - a);
            for (uint32_t vertex = 0; vertex < surface.vertexCount; ++vertex) {
                const quake::Vertex& given = level.vertices[surface.firstVertex + vertex];
                if (glm::distance(a, Vec3(given.position)) < 1e-3) together += glm::dot(facing, Vec3(given.normal));
            }
        }
        ++agree[surface.kind][together > 0.0 ? 1 : 0];
    }
    for (const auto& [kind, counts] : agree)
        EXPECT_LE(counts[0] * 50, counts[1]) << counts[0] << " surfaces of kind " << int(kind) << " face away from their normals";
    EXPECT_EQ(agree.size(), 2u) << "polygons and patches";
}

TEST_F(QuakeLevel, placesOfPlayersSeeThemselvesAndSomethingElse) {
    const quake::Level level = readIt();
    EXPECT_EQ(level.clusters, 2140u);
    EXPECT_EQ(level.surfaces.size(), 2555u);
    size_t players = 0;
    for (const quake::Entity& entity : level.entities) {
        if (entity.value("classname") != "info_player_deathmatch") continue;
        ++players;
        const int32_t cluster = level.leaves[level.leafAt(entity.origin())].cluster;
        ASSERT_GE(cluster, 0) << "a player stands within the level";
        EXPECT_TRUE(level.mayBeSeen(cluster, cluster));
        size_t seen = 0;
        for (uint32_t other = 0; other < level.clusters; ++other) seen += level.mayBeSeen(cluster, int32_t(other)) ? 1 : 0;
        EXPECT_GT(seen, 1u);
        EXPECT_LT(seen, level.clusters);
    }
    EXPECT_GT(players, 0u);
}

}  // namespace
}  // namespace cullscope::test::quake_scene_test
