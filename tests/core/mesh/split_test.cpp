#include "core/mesh/split.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/base/error.h"
#include "core/mesh/parametric.h"

namespace cullscope::test::split_test {
namespace {

/// A corner's position and normal, independent of its vertex number.
using Corner = std::array<float, 6>;
using Corners = std::array<Corner, 3>;

std::vector<Corners> trianglesOf(const TriangleMesh& mesh) {
    std::vector<Corners> triangles(mesh.triangleCount());
    for (size_t i = 0; i < mesh.indices().size(); ++i) {
        const Vec3f& p = mesh.positions()[mesh.indices()[i]];
        const Vec3f& n = mesh.normals()[mesh.indices()[i]];
        triangles[i / 3][i % 3] = {p.x, p.y, p.z, n.x, n.y, n.z};
    }
    return triangles;
}

std::vector<Corners> sortedTrianglesOf(const std::vector<MeshPointer>& meshes) {
    std::vector<Corners> all;
    for (const MeshPointer& mesh : meshes) {
        const std::vector<Corners> triangles = trianglesOf(*mesh);
        all.insert(all.end(), triangles.begin(), triangles.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Several meshes joined into one, far from the origin; with `soup` every triangle has vertices of its own.
MeshPointer joined(const std::vector<MeshPointer>& meshes, bool soup) {
    TriangleMesh::Data data;
    data.name = "joined";
    data.origin = {4e6, -2e6, 100.0625};
    for (const MeshPointer& mesh : meshes) {
        const auto first = static_cast<uint32_t>(data.positions.size());
        if (!soup) data.positions.insert(data.positions.end(), mesh->positions().begin(), mesh->positions().end());
        for (const uint32_t index : mesh->indices()) {
            if (soup) data.positions.push_back(mesh->positions()[index]);
            data.indices.push_back(soup ? static_cast<uint32_t>(data.positions.size() - 1) : first + index);
        }
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

MeshPointer moved(const MeshPointer& mesh, const Vec3f& by) {
    TriangleMesh::Data data;
    data.positions.assign(mesh->positions().begin(), mesh->positions().end());
    for (Vec3f& position : data.positions) position += by;
    data.indices.assign(mesh->indices().begin(), mesh->indices().end());
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// Expects every triangle with its exact coordinates and normals, the mesh's origin, and the mesh's order within each part.
void expectSameSurface(const MeshPointer& mesh, const std::vector<MeshPointer>& parts) {
    EXPECT_EQ(sortedTrianglesOf(parts), sortedTrianglesOf({mesh}));
    const std::vector<Corners> whole = trianglesOf(*mesh);
    for (const MeshPointer& part : parts) {
        EXPECT_EQ(part->origin(), mesh->origin());
        auto place = whole.begin();
        for (const Corners& triangle : trianglesOf(*part)) {
            place = std::find(place, whole.end(), triangle);
            ASSERT_NE(place, whole.end()) << part->name() << " has its triangles in another order";
            ++place;
        }
        std::set<uint32_t> used(part->indices().begin(), part->indices().end());
        EXPECT_EQ(used.size(), part->vertexCount()) << part->name() << " carries vertices that it does not use";
    }
}

Progress stopped() {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    return progress;
}

TEST(Components, fallApartByPosition) {
    const MeshPointer sphere = sphereMesh(500);
    const MeshPointer torus = torusMesh(2000);
    const std::vector<MeshPointer> bodies{sphere, moved(torus, {3, 0, 0}), moved(sphere, {6, 0, 0})};
    for (const bool soup : {false, true}) {
        const MeshPointer mesh = joined(bodies, soup);
        const std::vector<MeshPointer> parts = components(mesh);
        ASSERT_EQ(parts.size(), 3u);
        EXPECT_EQ(parts[0]->triangleCount(), torus->triangleCount()) << "the largest comes first";
        EXPECT_LT(parts[1]->localBounds().max.x, 1.1) << "among equals the one that came first";
        EXPECT_GT(parts[2]->localBounds().min.x, 4.9);
        EXPECT_EQ(parts[0]->name(), "joined 1");
        EXPECT_EQ(parts[2]->name(), "joined 3");
        for (const MeshPointer& part : parts) EXPECT_TRUE(part->topology().frontFacesSuffice());
        expectSameSurface(mesh, parts);
    }
}

TEST(Components, meshOfOnePartIsNotCopied) {
    const MeshPointer knot = knotMesh(1000);
    EXPECT_EQ(components(knot), std::vector<MeshPointer>{knot});
    EXPECT_EQ(clusters(knot, knot->triangleCount()), std::vector<MeshPointer>{knot});
    const MeshPointer nothing = std::make_shared<TriangleMesh>(TriangleMesh::Data{});
    EXPECT_EQ(components(nothing), std::vector<MeshPointer>{nothing});
    EXPECT_EQ(clusters(nothing, 10), std::vector<MeshPointer>{nothing});
}

TEST(Components, holdTogetherByACornerAndAMinusZero) {
    TriangleMesh::Data data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 1, 0}, {-1, 1, 0}, {-1, 2, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    data.indices = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(components(std::make_shared<TriangleMesh>(std::move(data))).size(), 2u);
}

TEST(Clusters, areAsFewAsCanBeAndOfLikeSizeAndCompact) {
    for (const MeshPointer& mesh : {knotMesh(4000), joined({starMesh(3, 3000), torusMesh(777)}, true)})
        for (const size_t most : {size_t{1}, size_t{7}, size_t{100}, size_t{999}, mesh->triangleCount() - 1}) {
            const std::vector<MeshPointer> parts = clusters(mesh, most);
            EXPECT_EQ(parts.size(), (mesh->triangleCount() + most - 1) / most);
            size_t largest = 0, smallest = mesh->triangleCount();
            for (const MeshPointer& part : parts) {
                largest = std::max(largest, part->triangleCount());
                smallest = std::min(smallest, part->triangleCount());
            }
            EXPECT_LE(largest, most);
            EXPECT_GE(2 * smallest, largest) << "pieces of like size";
            if (most < 2000) expectSameSurface(mesh, parts);
        }
    // 40 parts of a sphere's surface: each extends over a fraction of it.
    for (const MeshPointer& part : clusters(sphereMesh(8000), 200))
        EXPECT_LT(part->localBounds().diagonal(), 1.4) << part->name() << " of a sphere of diameter 2";
}

TEST(Clusters, areTheSameInEveryRunAndDivideEqualCentroids) {
    TriangleMesh::Data data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < 100; ++i) data.indices.insert(data.indices.end(), {0, 1, 2});
    EXPECT_EQ(clusters(std::make_shared<TriangleMesh>(std::move(data)), 9).size(), 12u);

    const MeshPointer star = starMesh(11, 5000);
    const std::vector<MeshPointer> once = clusters(star, 300);
    const std::vector<MeshPointer> again = clusters(star, 300);
    ASSERT_EQ(once.size(), again.size());
    for (size_t i = 0; i < once.size(); ++i) EXPECT_EQ(trianglesOf(*once[i]), trianglesOf(*again[i]));
}

TEST(Split, morePartsThanASceneMayHaveAreRefused) {
    const MeshPointer mesh = sphereMesh(200'000);
    try {
        (void)clusters(mesh, 1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(mesh->triangleCount())));
    }
}

TEST(Split, stopIsAnswered) {
    const MeshPointer mesh = sphereMesh(20'000);
    for (const auto& split : {std::function([&] { (void)components(mesh, stopped()); }),
                              std::function([&] { (void)clusters(mesh, 100, stopped()); })})
        try {
            split();
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
        }
}

TEST(Split, progressNeverGoesBackOrBeyondTheEnd) {
    const MeshPointer mesh = sphereMesh(20'000);
    for (const bool byClusters : {false, true}) {
        double last = 0.0;
        Progress progress;
        progress.report = [&](double share, std::string_view) {
            EXPECT_GE(share, last);
            EXPECT_LE(share, 1.0);
            last = share;
        };
        (void)(byClusters ? clusters(mesh, 100, progress) : components(joined({mesh, moved(mesh, {3, 0, 0})}, true), progress));
        EXPECT_GT(last, 0.0);
    }
}

}  // namespace
}  // namespace cullscope::test::split_test
