#include "core/mesh/resample.h"

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::resample_test {
namespace {

MeshPointer bunnyOrKnot() {
    if (fewSamples()) return knotMesh(15'000);
    const std::filesystem::path bunny = CULLSCOPE_SOURCE_DIR "/../shared/models/bunny.obj";
    return std::filesystem::exists(bunny) ? loadMeshFile(bunny).objects[0].mesh : knotMesh(69'666);
}

class Resample : public MeshFiles {};

TEST_F(Resample, closedMeshHitsSmallerAndLargerCountsExactlyAndStaysClosed) {
    const MeshPointer mesh = bunnyOrKnot();
    for (const size_t triangles : {size_t{5'000}, fewSamples() ? size_t{35'000} : size_t{144'046}}) {
        const MeshPointer changed = resampled(*mesh, triangles);
        EXPECT_EQ(changed->triangleCount(), triangles);
        EXPECT_TRUE(changed->topology().frontFacesSuffice());
        EXPECT_LE(glm::length(changed->localBounds().centre() - mesh->localBounds().centre()),
                  0.02 * mesh->localBounds().diagonal());
        EXPECT_NEAR(changed->localBounds().diagonal() / mesh->localBounds().diagonal(), 1.0, 0.02);
    }
}

/// A square sheet of 2 · 20 · 20 triangles.
std::string sheet(double offset) {
    std::string text;
    for (int row = 0; row <= 20; ++row)
        for (int column = 0; column <= 20; ++column)
            text += "v " + std::to_string(offset + column) + " " + std::to_string(row) + " " +
                    std::to_string((row * column) % 3) + "\n";
    for (int row = 0; row < 20; ++row)
        for (int column = 1; column <= 20; ++column) {
            const int corner = row * 21 + column;
            text += "f " + std::to_string(corner) + " " + std::to_string(corner + 1) + " " + std::to_string(corner + 22) + " " +
                    std::to_string(corner + 21) + "\n";
        }
    return text;
}

TEST_F(Resample, openMeshHitsOddCountsToo) {
    const MeshPointer mesh = load("a.obj", sheet(0)).objects[0].mesh;
    for (const size_t triangles : {size_t{101}, size_t{500}, size_t{799}, size_t{1'001}})
        EXPECT_EQ(resampled(*mesh, triangles)->triangleCount(), triangles);
    EXPECT_EQ(resampled(*mesh, 800)->triangleCount(), 800U);
}

TEST_F(Resample, farFromTheOriginNothingIsLost) {
    const MeshPointer mesh = load("a.obj", sheet(1e7)).objects[0].mesh;
    const MeshPointer changed = resampled(*mesh, 400);
    EXPECT_EQ(changed->triangleCount(), 400U);
    EXPECT_EQ(changed->origin(), mesh->origin());
    EXPECT_NEAR(changed->localBounds().max.x, 10.0, 1e-5);
}

TEST_F(Resample, surplusTrianglesAtAnEdgeAreKept) {
    const MeshPointer mesh =
        load("a.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 2 1 6\n")
            .objects[0]
            .mesh;
    EXPECT_EQ(mesh->topology().nonManifoldEdges, 1U);
    EXPECT_EQ(resampled(*mesh, 16)->triangleCount(), 16U);
}

TEST_F(Resample, countsThatCannotBeReachedAreRefused) {
    std::string text;
    for (int i = 0; i < 50; ++i)
        text += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " 1 0\nv " + std::to_string(i) + " 0 1\nf -1 -2 -3\n";
    const MeshPointer mesh = load("a.obj", text).objects[0].mesh;
    for (const size_t triangles : {size_t{0}, size_t{10}, size_t{1} << 60}) {
        try {
            (void)resampled(*mesh, triangles);
            ADD_FAILURE() << triangles;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
        }
    }
}

TEST_F(Resample, aStopEndsSimplifyingAndSubdividing) {
    const MeshPointer mesh = bunnyOrKnot();
    for (const size_t triangles : {size_t{5'000}, size_t{250'000}}) {
        std::stop_source source;
        size_t told = 0;
        Progress progress;
        progress.stop = source.get_token();
        progress.report = [&](double, std::string_view) {
            if (++told == 2) source.request_stop();
        };
        try {
            (void)resampled(*mesh, triangles, progress);
            ADD_FAILURE() << triangles;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
        }
    }
}

}  // namespace
}  // namespace cullscope::test::resample_test
