#include <fmt/format.h>

#include <random>

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

TEST_F(Precision, meshesTooSmallForFloatsAreRefused) {
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n"), testing::HasSubstr("smaller than 1e-30"));
}

}  // namespace
}  // namespace cullscope::test::load_precision_test
