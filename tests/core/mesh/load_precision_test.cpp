#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "core/mesh/parametric.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::load_precision_test {
namespace {

class Precision : public MeshFiles {
protected:
    /// Random points in a box of the given size about the given place, and triangles over them.
    static std::vector<Vec3> points(const Vec3& place, double size) {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> spread(-0.5 * size, 0.5 * size);
        std::vector<Vec3> all(300);
        for (Vec3& point : all) point = place + Vec3(spread(random), spread(random), spread(random));
        return all;
    }
    static void expectBack(const LoadedFile& file, const std::vector<Vec3>& expected, double size) {
        const TriangleMesh& mesh = *file.objects.at(0).mesh;
        ASSERT_EQ(mesh.vertexCount(), expected.size());
        for (size_t i = 0; i < expected.size(); ++i) EXPECT_LE(glm::length(mesh.position(i) - expected[i]), 1e-7 * size) << i;
    }
    static std::string obj(const std::vector<Vec3>& all, const char* format) {
        std::string text;
        for (const Vec3& p : all) text += fmt::format(fmt::runtime(format), p.x, p.y, p.z);
        for (size_t i = 1; i <= all.size(); i += 3) text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
        return text;
    }
    static std::string off(const std::vector<Vec3>& all) {
        std::string text = fmt::format("OFF\n{} {} 0\n", all.size(), all.size() / 3);
        for (const Vec3& p : all) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
        for (size_t i = 0; i < all.size(); i += 3) text += fmt::format("3 {} {} {}\n", i, i + 1, i + 2);
        return text;
    }
    static std::string ply(const std::vector<Vec3>& all) {
        std::string bytes = fmt::format(
            "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
            "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
            all.size(), all.size() / 3);
        for (const Vec3& p : all) append(bytes, p);
        for (int32_t i = 0; i < static_cast<int32_t>(all.size()); i += 3) append(bytes, uint8_t{3}, std::array{i, i + 1, i + 2});
        return bytes;
    }
};

TEST_F(Precision, coordinatesAtTenMillionComeBackFromEveryDoubleFormat) {
    for (const double size : {1.0, 0.25}) {
        const std::vector<Vec3> all = points({1e7, -1e7, 0.7e7}, size);
        expectBack(load("a.obj", obj(all, "v {} {} {}\n")), all, size);
        expectBack(load("b.obj", obj(all, "v {:.17e} {:.17e} {:.17e}\n")), all, size);
        expectBack(load("a.off", off(all)), all, size);
        expectBack(load("a.ply", ply(all)), all, size);
    }
}

TEST_F(Precision, verySmallAndVeryLargeMeshesComeBack) {
    for (const double size : {1e-18, 1e18}) {
        const std::vector<Vec3> all = points(Vec3(0.0), size);
        const LoadedFile file = load("a.obj", obj(all, "v {} {} {}\n"));
        expectBack(file, all, size);
        EXPECT_EQ(file.report.trianglesMade, 100U);
        for (const Vec3f& normal : file.objects[0].mesh->normals()) EXPECT_NEAR(glm::length(Vec3(normal)), 1.0, 1e-5);
    }
}

/// A sphere, and a triangle of its own size that lies `away` from it in all three directions.
std::string sphereAndATriangle(double away, bool asObject) {
    const MeshPointer sphere = sphereMesh(2'000);
    std::string text;
    for (const Vec3f& p : sphere->positions()) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const int corner : {0, 1, 2})
        text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", away, away + (corner == 1 ? 1 : 0), away + (corner == 2 ? 1 : 0));
    for (size_t i = 0; i < sphere->indices().size(); i += 3)
        text += fmt::format("f {} {} {}\n", sphere->indices()[i] + 1, sphere->indices()[i + 1] + 1, sphere->indices()[i + 2] + 1);
    const size_t first = sphere->vertexCount() + 1;
    return text + fmt::format("{}f {} {} {}\n", asObject ? "o far\n" : "", first, first + 1, first + 2);
}

TEST_F(Precision, verticesFarAwayCostTheOthersNothing) {
    const MeshPointer sphere = sphereMesh(2'000);
    for (const double away : {1e3, 1e5, 1e8, 1e12}) {
        const LoadedFile file = load("far.obj", sphereAndATriangle(away, false));
        const TriangleMesh& mesh = *file.objects.at(0).mesh;
        const auto place = [&](size_t corner) { return mesh.position(mesh.indices()[corner]); };
        const size_t corners = sphere->indices().size();
        ASSERT_EQ(mesh.indices().size(), corners + 3);
        std::set<std::array<double, 3>> places;
        for (size_t corner = 0; corner < corners; ++corner) {
            const Vec3 read = place(corner), written(sphere->positions()[sphere->indices()[corner]]);
            places.insert({read.x, read.y, read.z});
            ASSERT_LE(glm::length(read - written), 4e-7) << corner << ", " << away;
        }
        EXPECT_EQ(places.size(), sphere->vertexCount()) << away;
        EXPECT_LE(glm::length(place(corners) - Vec3(away)), 2e-7 * away);
        EXPECT_EQ(file.report.bentByRounding, away > 1e7 ? 1u : 0u) << away << ": the far triangle's corners are one place";
    }
}

TEST_F(Precision, trianglesThatFloatsCannotHoldAreCountedAndSaid) {
    // Two spheres in one object: no place is near to both.
    const std::vector<Vec3> near = points(Vec3(0.0), 1.0), far = points(Vec3(1e9, 0.0, 0.0), 1.0);
    std::vector<Vec3> both = near;
    both.insert(both.end(), far.begin(), far.end());
    const LoadedFile file = load("two.obj", obj(both, "v {:.17g} {:.17g} {:.17g}\n"));
    EXPECT_GE(file.report.bentByRounding, 190u) << "some of the 200 hardly reach in the direction that is lost";
    const std::vector<Message> sentences = file.report.sentences();
    EXPECT_TRUE(std::ranges::any_of(sentences, [&](const Message& each) {
        return each.english().find("too large beside them for floats: " + std::to_string(file.report.bentByRounding)) !=
               std::string::npos;
    }));
    // As objects of their own both are as in the file.
    EXPECT_TRUE(load("apart.obj", sphereAndATriangle(1e9, true)).report.clean());
    EXPECT_TRUE(load("one.obj", obj(near, "v {:.17g} {:.17g} {:.17g}\n")).report.clean());
}

TEST_F(Precision, meshesTooSmallForFloatsAreRefused) {
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n"), testing::HasSubstr("smaller than 1e-30"));
}

}  // namespace
}  // namespace cullscope::test::load_precision_test
