// Arrays of glTF files: their kinds of numbers, orders of triangles, and compressed meshes.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "core/base/error.h"
#include "core/scene/gltf/gltf_scene.h"
#include "tests/support/changed_files.h"
#include "tests/support/draco_bytes.h"
#include "tests/support/gltf_model.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"
#include "tests/support/refusal.h"

namespace cullscope::test::gltf_numbers_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using Corners = std::array<std::array<float, 3>, 3>;

/// The triangles of a scene's first object by their corners, the smallest corner first; turned, not reversed.
std::vector<Corners> trianglesOf(const Scene& scene) {
    const TriangleMesh& mesh = scene.meshOf(0);
    std::vector<Corners> triangles;
    for (size_t at = 0; at < mesh.indices().size(); at += 3) {
        Corners corners{};
        for (size_t k = 0; k < 3; ++k) {
            const Vec3f place(mesh.position(mesh.indices()[at + k]));
            corners[k] = {place.x, place.y, place.z};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

std::vector<Corners> trianglesOf(const std::vector<Vec3f>& positions, const std::vector<uint32_t>& triangles) {
    std::vector<Corners> all;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        Corners corners{};
        for (size_t k = 0; k < 3; ++k) {
            const Vec3f& place = positions[triangles[i + k]];
            corners[k] = {place.x, place.y, place.z};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        all.push_back(corners);
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// A grid of side × side squares in the plane z = 0, whose coordinates are whole numbers.
struct Grid {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> triangles;
};

Grid gridOf(uint32_t side) {
    Grid grid;
    for (uint32_t y = 0; y <= side; ++y)
        for (uint32_t x = 0; x <= side; ++x) grid.positions.emplace_back(float(x), float(y), 0.0F);
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = y * (side + 1) + x, b = a + side + 1;
            grid.triangles.insert(grid.triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    return grid;
}

class GltfNumbers : public MeshFiles {
protected:
    [[nodiscard]] FileScene read(const GltfModel& model) const { return readGltfFile(write("a.glb", model.glb())); }
    [[nodiscard]] std::string refused(const GltfModel& model) const {
        return refusalOf([&] { (void)read(model); }, ErrorKind::Input);
    }
    /// A file of one mesh with one primitive.
    [[nodiscard]] static GltfModel modelOf(GltfModel model, const json& primitive) {
        model.node({{"mesh", model.mesh(json::array({primitive}), "mesh")}});
        return model;
    }
};

template <typename Value>
std::string converted(const std::vector<uint32_t>& values) {
    return GltfModel::bytesOf(std::vector<Value>(values.begin(), values.end()));
}

TEST_F(GltfNumbers, listsStripsAndFansHaveTheTrianglesOfTheSpecification) {
    const std::vector<Vec3f> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}, {3, 3, 0}};
    std::mt19937 random(20261126);
    for (int round = 0; round < int(howMany(400, 60)); ++round) {
        const int mode = 4 + int(random() % 3), kind = std::array{5121, 5123, 5125}[random() % 3];
        std::vector<uint32_t> corners(3 + random() % 9);
        for (uint32_t& corner : corners) corner = random() % uint32_t(places.size());
        GltfModel model;
        json primitive{{"mode", mode}, {"attributes", {{"POSITION", model.positions(places)}}}};
        if (random() % 4 == 0) {
            corners.clear();
            for (uint32_t i = 0; i < places.size(); ++i) corners.push_back(i);
        } else {
            const std::string bytes = kind == 5121   ? converted<uint8_t>(corners)
                                      : kind == 5123 ? converted<uint16_t>(corners)
                                                     : converted<uint32_t>(corners);
            primitive["indices"] = model.accessor(model.view(bytes), kind, corners.size(), "SCALAR");
        }
        std::vector<uint32_t> expected;
        const auto add = [&](size_t a, size_t b, size_t c) {
            const std::array three{corners[a], corners[b], corners[c]};
            const Vec3f from = places[three[0]];
            if (glm::cross(Vec3(places[three[1]] - from), Vec3(places[three[2]] - from)).z != 0.0)
                expected.insert(expected.end(), three.begin(), three.end());
        };
        for (size_t i = 0; i + 2 < corners.size(); ++i) {
            if (mode == 4 && i % 3 == 0) add(i, i + 1, i + 2);
            if (mode == 5) add(i, i + (1 + i % 2), i + (2 - i % 2));
            if (mode == 6) add(i + 1, i + 2, 0);
        }
        // Triangles that are twice there are dropped with a count.
        std::vector<Corners> wanted = trianglesOf(places, expected);
        wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
        if (wanted.empty()) continue;
        ASSERT_EQ(trianglesOf(*read(modelOf(model, primitive)).scene), wanted) << "round " << round << ", mode " << mode;
    }
}

/// Positions of a kind of whole numbers, and what they mean.
template <typename Value>
void expectPositions(int kind, bool normalised, double most, const std::function<FileScene(const GltfModel&)>& read) {
    std::mt19937 random(20261126);
    std::vector<Value> numbers;
    std::vector<Vec3f> meant;
    const size_t padding = (4 - 3 * sizeof(Value) % 4) % 4 / sizeof(Value);
    for (int vertex = 0; vertex < 30; ++vertex) {
        Vec3f place(0.0F);
        for (int axis = 0; axis < 3; ++axis) {
            const auto number = Value(random());
            numbers.push_back(number);
            place[axis] = float(normalised ? std::max(double(number) / most, -1.0) : double(number));
        }
        numbers.insert(numbers.end(), padding, Value(0));
        meant.push_back(place);
    }
    GltfModel model;
    const int view = model.view(GltfModel::bytesOf(numbers), int((3 + padding) * sizeof(Value)));
    const int mesh = model.mesh({{{"attributes", {{"POSITION", model.accessor(view, kind, 30, "VEC3", normalised)}}}}});
    model.node({{"mesh", mesh}});
    const ScenePointer scene = read(model).scene;
    const std::vector<Corners> got = trianglesOf(*scene);
    std::vector<uint32_t> all(30);
    for (uint32_t i = 0; i < 30; ++i) all[i] = i;
    const std::vector<Corners> wanted = trianglesOf(meant, all);
    ASSERT_EQ(got.size(), wanted.size()) << "kind " << kind;
    const double rounding = scene->bounds().diagonal() * 1e-6;
    for (size_t i = 0; i < got.size(); ++i)
        for (size_t k = 0; k < 3; ++k)
            for (size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(got[i][k][axis], wanted[i][k][axis], rounding) << "kind " << kind << ", triangle " << i;
}

TEST_F(GltfNumbers, quantisedPositionsMeanFractionsOrWholeNumbers) {
    const auto read = [&](const GltfModel& model) { return this->read(model); };
    for (const bool normalised : {false, true}) {
        expectPositions<int8_t>(GltfKind::Byte, normalised, 127.0, read);
        expectPositions<uint8_t>(GltfKind::UnsignedByte, normalised, 255.0, read);
        expectPositions<int16_t>(GltfKind::Short, normalised, 32767.0, read);
        expectPositions<uint16_t>(GltfKind::UnsignedShort, normalised, 65535.0, read);
    }
}

TEST_F(GltfNumbers, sparseAccessorsReplaceElements) {
    for (const bool overNothing : {false, true}) {
        GltfModel model;
        const int positions = model.positions({{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {9, 9, 9}});
        const int places = model.view(GltfModel::bytesOf(std::vector<uint16_t>{1, 2}));
        const int values = model.view(GltfModel::bytesOf(std::vector<Vec3f>{{7, 0, 0}, {0, 8, 0}}));
        const json primitive{{"attributes", {{"POSITION", positions}}}, {"indices", model.indices({0, 1, 2})}};
        json& accessor = model.json["accessors"][size_t(positions)];
        accessor["sparse"] = {
            {"count", 2}, {"indices", {{"bufferView", places}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
        if (overNothing) accessor.erase("bufferView");
        const Box3 box = read(modelOf(model, primitive)).scene->bounds();
        EXPECT_LT(glm::distance(box.min, Vec3(0, 0, 0)), 1e-9);
        EXPECT_LT(glm::distance(box.max, Vec3(7, 8, 0)), 1e-9);
        accessor["count"] = 2;
        EXPECT_THAT(refused(modelOf(model, primitive)), HasSubstr("accessor 0 replaces an element that it does not have"));
        accessor["sparse"]["count"] = 3;
        EXPECT_THAT(refused(modelOf(model, primitive)), HasSubstr("accessor 0 replaces elements in a way"));
    }
}

TEST_F(GltfNumbers, primitivesThatShareVerticesKeepThemOnce) {
    GltfModel model;
    const Grid grid = gridOf(10);
    const int positions = model.positions(grid.positions);
    json primitives = json::array();
    for (size_t i = 0; i < grid.triangles.size(); i += 30) {
        const std::vector<uint16_t> part(grid.triangles.begin() + std::ptrdiff_t(i),
                                         grid.triangles.begin() + std::ptrdiff_t(i + 30));
        primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"indices", model.indices(part)}});
    }
    model.node({{"mesh", model.mesh(primitives)}});
    const FileScene read = this->read(model);
    EXPECT_EQ(read.scene->meshOf(0).vertexCount(), grid.positions.size());
    EXPECT_EQ(read.scene->triangleCount(), 200u);
    EXPECT_TRUE(read.report.clean());
}

TEST_F(GltfNumbers, cornersOfNoVertexAndPrimitivesWithoutPositionsAreTold) {
    GltfModel model;
    const int positions = model.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const json whole{{"attributes", {{"POSITION", positions}}}, {"indices", model.indices({0, 1, 2, 0, 1, 3})}};
    const json bare{{"attributes", {{"NORMAL", positions}}}};
    model.node({{"mesh", model.mesh({whole, bare})}});
    const LoadReport report = read(model).report;
    EXPECT_EQ(report.outOfRangeFaces, 1u);
    ASSERT_EQ(report.remarks.size(), 1u);
    EXPECT_EQ(report.remarks[0].english(), "Primitives left out that have no positions: 1.");
}

TEST_F(GltfNumbers, accessorsThatReachBeyondTheirViewsAreRefused) {
    const auto with = [](const char* place, const json& value) {
        GltfModel model;
        gltfSquare(model, "square");
        model.node({{"mesh", 0}});
        model.json[json::json_pointer(place)] = value;
        return model;
    };
    EXPECT_EQ(refused(with("/accessors/0/name", "as it is")), "");
    EXPECT_THAT(refused(with("/accessors/0/count", 5)), HasSubstr("the accessor 0 has more elements than its buffer view"));
    EXPECT_THAT(refused(with("/accessors/0/count", 4294967296)), HasSubstr("the accessor 0"));
    EXPECT_THAT(refused(with("/accessors/0/count", 18446744073709551615ULL)), HasSubstr("a.glb"));
    EXPECT_THAT(refused(with("/accessors/0/byteOffset", 4)), HasSubstr("the accessor 0 has more elements than"));
    EXPECT_THAT(refused(with("/accessors/0/byteOffset", 1000000)), HasSubstr("the accessor 0 has more elements than"));
    EXPECT_THAT(refused(with("/accessors/0/bufferView", 9)), HasSubstr("the accessor 0 takes its numbers from where"));
    EXPECT_THAT(refused(with("/bufferViews/0/buffer", 3)), HasSubstr("the accessor 0 takes its numbers from where"));
    EXPECT_THAT(refused(with("/bufferViews/0/byteLength", 1000)), HasSubstr("the accessor 0 takes its numbers from where"));
    EXPECT_THAT(refused(with("/bufferViews/0/byteOffset", 1000)), HasSubstr("the accessor 0 takes its numbers from where"));
    EXPECT_THAT(refused(with("/accessors/0/type", "VEC2")), HasSubstr("the accessor 0 does not have 3 numbers an element"));
    EXPECT_THAT(refused(with("/accessors/0/componentType", 5130)), HasSubstr("the accessor 0 does not have 3 numbers"));
    EXPECT_THAT(refused(with("/accessors/1/componentType", 5122)), HasSubstr("the accessor 1 has to have whole numbers"));
    EXPECT_THAT(refused(with("/meshes/0/primitives/0/indices", 8)), HasSubstr("accessor out of bounds"));
    // Without a view an accessor is of zeros, as many as it says.
    GltfModel zeros = with("/accessors/0/count", 1'000'000'000'000ULL);
    zeros.json["accessors"][0].erase("bufferView");
    EXPECT_THAT(refused(zeros), HasSubstr("of memory"));
}

TEST_F(GltfNumbers, meshesThatAreCompressedWithDracoHaveTheirTriangles) {
    const Grid grid = gridOf(12);
    for (const bool edgebreaker : {false, true})
        for (const int bits : {0, 14}) {
            GltfModel model;
            const int view = model.view(dracoBytes(grid.positions, grid.triangles, edgebreaker, bits));
            const json draco{{"bufferView", view}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
            const json primitive{{"attributes", json::object()}, {"extensions", {{"KHR_draco_mesh_compression", draco}}}};
            model.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
            const FileScene read = this->read(modelOf(model, primitive));
            EXPECT_TRUE(read.report.clean());
            std::vector<Corners> got = trianglesOf(*read.scene);
            for (Corners& corners : got)
                for (auto& corner : corners)
                    for (float& number : corner) {
                        EXPECT_NEAR(number, std::round(number), 12.0 / 16384.0) << "half a step of 14 bits";
                        number = std::round(number) + 0.0F;
                    }
            for (Corners& corners : got)
                std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::sort(got.begin(), got.end());
            EXPECT_EQ(got, trianglesOf(grid.positions, grid.triangles)) << (edgebreaker ? "edgebreaker" : "sequential");
        }
}

TEST_F(GltfNumbers, damagedDracoMeshesAreRefused) {
    const Grid grid = gridOf(3);
    for (const bool edgebreaker : {false, true}) {
        const std::string good = dracoBytes(grid.positions, grid.triangles, edgebreaker, 10);
        const auto modelWith = [&](std::string_view bytes) {
            GltfModel model;
            const json draco{{"bufferView", model.view(std::string(bytes))}, {"attributes", {{"POSITION", 0}}}};
            return modelOf(model, {{"attributes", json::object()}, {"extensions", {{"KHR_draco_mesh_compression", draco}}}});
        };
        EXPECT_THAT(refused(modelWith(good.substr(0, 8))), HasSubstr("a version of Draco that is not read"));
        EXPECT_THAT(refused(modelWith(good.substr(0, good.size() / 2))), HasSubstr("compressed with Draco cannot be decoded"));
        std::string huge = good;
        huge.replace(edgebreaker ? 12 : 11, 2, "\xff\xff\xff\xff\x0f");
        EXPECT_THAT(refused(modelWith(huge)), HasSubstr("a.glb"));
        EXPECT_TRUE(
            everyChangeLoadsOrIsRefused(good, "a.glb", [&](std::string_view bytes) { return read(modelWith(bytes)).scene; }));
    }
}

}  // namespace
}  // namespace cullscope::test::gltf_numbers_test
