#include "core/scene/gltf/gltf_scene.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/scene/scene_source.h"
#include "tests/support/changed_files.h"
#include "tests/support/gltf_model.h"
#include "tests/support/mesh_files.h"
#include "tests/support/packed_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/scene_words.h"

namespace cullscope::test::gltf_scene_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class Gltf : public MeshFiles {
protected:
    [[nodiscard]] FileScene read(const GltfModel& model) const { return readGltfFile(write("a.glb", model.glb())); }
    [[nodiscard]] std::string refused(std::string_view bytes, const std::string& name = "a.glb") const {
        return refusalOf([&] { (void)readGltfFile(write(name, bytes)); }, ErrorKind::Input);
    }
    [[nodiscard]] std::string refused(const GltfModel& model) const { return refused(model.glb()); }
};

void expectBox(const Box3& box, const Vec3& low, const Vec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], low[axis], 1e-5) << "axis " << axis;
        EXPECT_NEAR(box.max[axis], high[axis], 1e-5) << "axis " << axis;
    }
}

TEST_F(Gltf, nodesBecomeObjectsThatShareTheirMeshes) {
    const ScenePointer scene = read(gltfSample()).scene;
    EXPECT_THAT(namesOf(*scene), ElementsAre("hand", "square", "hand (2)"));
    EXPECT_EQ(scene->meshes().size(), 2u);
    EXPECT_EQ(scene->instances()[0].mesh, scene->instances()[1].mesh);
    EXPECT_EQ(scene->remarks().up, UpAxis::Y);
    expectBox(scene->instanceBox(0), {10, 0, 0}, {12, 2, 0});
    expectBox(scene->instanceBox(1), {14, 0, 0}, {15, 1, 0});
    expectBox(scene->instanceBox(2), {14, -1, 0}, {15, 0, 0});
}

TEST_F(Gltf, whatIsNotShownIsSaid) {
    EXPECT_THAT(remarksOf(read(gltfSample()).report),
                ElementsAre("Points and lines left out, which have no surface: 1 primitives.",
                            "Skins are not applied; objects that stand as they were modelled: 1.",
                            "Morph targets are not applied; primitives that have some: 1.", "Animations are not played: 1."));
    GltfModel plain;
    gltfSquare(plain, "square");
    plain.node({{"mesh", 0}});
    const FileScene read = this->read(plain);
    EXPECT_TRUE(read.report.clean());
    EXPECT_THAT(namesOf(*read.scene), ElementsAre("square"));
}

TEST_F(Gltf, buffersLieInTheFileInDataUrisAndBesideIt) {
    const GltfModel model = gltfSample();
    const std::string sha = read(model).scene->sha256();
    EXPECT_EQ(readGltfFile(write("a.gltf", model.text())).scene->sha256(), sha);
    (void)write("the buffer.bin", model.binary);
    EXPECT_EQ(readGltfFile(write("a.gltf", model.text("the%20buffer.bin"))).scene->sha256(), sha);
    EXPECT_EQ(openScene(write("A.GLB", model.glb()).string()).scene->sha256(), sha);
    EXPECT_EQ(openScene(write("a.glb.xz", xzPacked(model.glb())).string()).scene->sha256(), sha);
}

TEST_F(Gltf, buffersOutsideOfTheFolderAreRefused) {
    const GltfModel model = gltfSample();
    std::filesystem::create_directory(m_folder / "inner");
    (void)write("outside.bin", model.binary);
    std::filesystem::create_symlink(m_folder / "outside.bin", m_folder / "inner/link.bin");
    for (const std::string& uri : {std::string("../outside.bin"), (m_folder / "outside.bin").string(), std::string("link.bin"),
                                   std::string("%2e%2e/outside.bin"), std::string("http://example.org/outside.bin"),
                                   std::string("file:///etc/passwd"), std::string("/etc/passwd")})
        EXPECT_THAT(refused(model.text(uri), "inner/a.gltf"), HasSubstr("which is not in its own folder or below")) << uri;
    EXPECT_THAT(refused(model.text("missing.bin"), "inner/a.gltf"), HasSubstr("\"missing.bin\", which does not exist"));
    (void)write("inner/short.bin", "short");
    EXPECT_THAT(refused(model.text("short.bin"), "inner/a.gltf"), HasSubstr("File size mismatch"));
    (void)write("inner/whole.bin", model.binary);
    EXPECT_EQ(refused(model.text("whole.bin"), "inner/a.gltf"), "");
}

TEST_F(Gltf, theDefaultSceneIsShown) {
    GltfModel model;
    gltfSquare(model, "square");
    model.node({{"mesh", 0}, {"name", "first"}});
    model.node({{"mesh", 0}, {"name", "second"}});
    model.add("scenes", {{"nodes", {0}}});
    model.add("scenes", {{"nodes", {1}}});
    EXPECT_THAT(namesOf(*read(model).scene), ElementsAre("first"));
    model.json["scene"] = 1;
    const FileScene read = this->read(model);
    EXPECT_THAT(namesOf(*read.scene), ElementsAre("second"));
    EXPECT_THAT(remarksOf(read.report), ElementsAre(HasSubstr("not shown, because one at a time is: 1.")));
    model.json["scene"] = 2;
    EXPECT_THAT(refused(model), HasSubstr("names the scene 2, which it does not have"));
}

TEST_F(Gltf, instancesOfANodeStandWhereItsAttributesSay) {
    GltfModel model;
    gltfSquare(model, "square");
    const int places = model.positions({{0, 0, 0}, {0, 0, 5}});
    const int scales = model.positions({{1, 1, 1}, {3, 1, 1}});
    const int turns = model.accessor(model.view(GltfModel::bytesOf(std::vector<int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0})),
                                     GltfKind::Short, 2, "VEC4", true);
    const json attributes{{"TRANSLATION", places}, {"SCALE", scales}, {"ROTATION", turns}};
    model.node({{"mesh", 0},
                {"name", "tree"},
                {"translation", {100, 0, 0}},
                {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
    model.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const ScenePointer scene = read(model).scene;
    EXPECT_THAT(namesOf(*scene), ElementsAre("tree", "tree (2)"));
    EXPECT_EQ(scene->meshes().size(), 1u);
    expectBox(scene->instanceBox(0), {100, 0, 0}, {101, 1, 0});
    expectBox(scene->instanceBox(1), {97, -1, 5}, {100, 0, 5});
    model.json["accessors"][size_t(scales)]["count"] = 1;
    EXPECT_THAT(refused(model), HasSubstr("the instances of the node 0 have transforms of different numbers"));
}

TEST_F(Gltf, malformedContainersAreRefusedWithTheByte) {
    const std::string good = gltfSample().glb();
    const auto changed = [&](size_t byte, uint32_t value) {
        std::string bytes = good;
        bytes.replace(byte, 4, reinterpret_cast<const char*>(&value), 4);
        return bytes;
    };
    EXPECT_THAT(refused(good.substr(0, 15)), HasSubstr("ends at byte 15"));
    EXPECT_THAT(refused(changed(4, 1)), HasSubstr("byte 4: this is glTF of version 1"));
    EXPECT_THAT(refused(good.substr(0, good.size() - 1)), HasSubstr("byte 8: the file is to have"));
    EXPECT_THAT(refused(changed(12, 0x7fffffff)), HasSubstr("byte 12: a chunk is to have 2147483647 bytes"));
    EXPECT_THAT(refused(changed(12, 5)), HasSubstr("byte 12: the chunk has 5 bytes, which is no multiple of 4"));
    EXPECT_THAT(refused(changed(16, 0)), HasSubstr("byte 12: a chunk of JSON must stand here"));
    uint32_t json = 0;
    std::memcpy(&json, good.data() + 12, 4);
    for (const uint32_t more : {4U, 8U, 100U}) {
        uint32_t binary = 0;
        std::memcpy(&binary, good.data() + 20 + json, 4);
        EXPECT_THAT(refused(changed(20 + json, binary + more)),
                    HasSubstr("byte " + std::to_string(20 + json) + ": a chunk is to"));
    }
    const std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(100000, '[');
    EXPECT_THAT(refused(deep, "a.gltf"), HasSubstr("byte 99: objects and arrays lie deeper in each other than 64"));
    EXPECT_THAT(refused("{\"asset\"", "a.gltf"), HasSubstr("cannot be read as glTF 2.0"));
    EXPECT_THAT(refused("\"", "a.gltf"), HasSubstr("cannot be read as glTF 2.0"));
}

TEST_F(Gltf, malformedScenesAreRefused) {
    const auto with = [](const char* place, const json& value) {
        GltfModel model = gltfSample();
        model.json[json::json_pointer(place)] = value;
        return model;
    };
    EXPECT_THAT(refused(with("/nodes/3/children", json::array({0}))), HasSubstr("the node 0 has two parents"));
    EXPECT_THAT(refused(with("/scenes/0/nodes", json::array({9}))), HasSubstr("names the node 9"));
    EXPECT_THAT(refused(with("/nodes/1/mesh", 7)), HasSubstr("names the mesh 7"));
    EXPECT_THAT(refused(with("/nodes/1/scale", json::array({1, 2}))), HasSubstr("the transform of the node 1"));
    EXPECT_THAT(refused(with("/nodes/2/matrix/3", 1)), HasSubstr("the matrix of the node 2 is not affine"));
    EXPECT_THAT(refused(with("/scenes/0/nodes", json::array({4}))), HasSubstr("holds no faces"));
    EXPECT_THAT(refused(with("/scenes/0/nodes", json::array())), HasSubstr("holds no faces"));
    EXPECT_THAT(refused(with("/extensionsRequired", json::array({"EXT_meshopt_compression"}))),
                HasSubstr("requires the extension \"EXT_meshopt_compression\", which is not read"));
    GltfModel compressed = with("/extensionsRequired", json::array({"EXT_meshopt_compression"}));
    compressed.json["bufferViews"][0]["byteStride"] = 3;
    EXPECT_THAT(refused(compressed), HasSubstr("\"EXT_meshopt_compression\"")) << "whatever else is wrong then";
    EXPECT_EQ(refused(with("/extensionsRequired", json::array({"KHR_materials_unlit", "KHR_texture_transform"}))), "");
    EXPECT_THAT(remarksOf(read(with("/nodes/1/translation", json::array({1e31, 0, 0}))).report),
                testing::Contains("Objects left out that lie beyond 1e30: 1."));
    LoadOptions options;
    options.memoryLimitBytes = 20000;
    EXPECT_THAT(refusalOf([&] { (void)readGltfFile(write("a.glb", gltfSample().glb()), options); }, ErrorKind::Input),
                HasSubstr("of memory"));
}

TEST_F(Gltf, manyBuffersOfOneChunkAreBoundedByTheMemory) {
    GltfModel model = gltfSample();
    model.binary.resize(1'000'000);
    std::string bytes = model.glb();
    const std::string one = "\"buffers\":[{\"byteLength\":1000000}";
    const size_t at = bytes.find(one);
    ASSERT_NE(at, std::string::npos);
    std::string more;
    for (int i = 0; i < 400; ++i) more += ",{\"byteLength\":1000000}";
    bytes.insert(at + one.size(), more);
    for (const size_t place : {size_t{8}, size_t{12}}) {
        uint32_t length = 0;
        std::memcpy(&length, bytes.data() + place, 4);
        length += uint32_t(more.size());
        std::memcpy(bytes.data() + place, &length, 4);
    }
    ASSERT_EQ(more.size() % 4, 0u);
    LoadOptions options;
    options.memoryLimitBytes = 100'000'000;
    EXPECT_THAT(refusalOf([&] { (void)readGltfFile(write("a.glb", bytes), options); }, ErrorKind::Input), HasSubstr("of memory"));
}

TEST_F(Gltf, everyTruncationAndEverySeededMutationLoadsOrIsRefused) {
    for (const auto& [name, good] : {std::pair(std::string("a.glb"), gltfSample().glb()), {"a.gltf", gltfSample().text()}})
        EXPECT_TRUE(everyChangeLoadsOrIsRefused(
            good, name, [&, file = name](std::string_view bytes) { return readGltfFile(write(file, bytes)).scene; }));
}

}  // namespace
}  // namespace cullscope::test::gltf_scene_test
