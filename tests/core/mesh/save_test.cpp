#include "core/mesh/save.h"

#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::save_test {
namespace {

class Save : public MeshFiles {
protected:
    /// A tetrahedron that faces outward, at a place where floats alone would not resolve it.
    [[nodiscard]] MeshPointer tetrahedron() const {
        return load("t.obj",
                    "v 10000000.1 0 0\nv 10000001.1 0 0.3\nv 10000000.1 1 0\nv 10000000.1 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 "
                    "4\n")
            .objects[0]
            .mesh;
    }
};

TEST_F(Save, objAndPlyGiveEveryCoordinateBackExactly) {
    const MeshPointer mesh = tetrahedron();
    for (const char* name : {"a.obj", "a.ply"}) {
        const PlacedMesh placed{"thing", mesh.get()};
        saveMeshFile(m_folder / name, {&placed, 1});
        const LoadedFile back = loadMeshFile(m_folder / name);
        const TriangleMesh& again = *back.objects[0].mesh;
        ASSERT_EQ(again.vertexCount(), mesh->vertexCount());
        EXPECT_TRUE(std::ranges::equal(again.indices(), mesh->indices()));
        for (size_t i = 0; i < mesh->vertexCount(); ++i) {
            EXPECT_LE(glm::length(again.position(i) - mesh->position(i)), 1e-8) << name;
            EXPECT_LE(glm::length(again.normals()[i] - mesh->normals()[i]), 1e-6F) << name;
        }
        EXPECT_TRUE(again.topology().frontFacesSuffice());
    }
}

TEST_F(Save, stlKeepsTheSurface) {
    const MeshPointer mesh = tetrahedron();
    const PlacedMesh placed{"thing", mesh.get(), glm::translate(Mat4(1.0), Vec3(-1e7, 0, 0))};
    saveMeshFile(m_folder / "a.stl", {&placed, 1});
    const MeshPointer again = loadMeshFile(m_folder / "a.stl").objects[0].mesh;
    EXPECT_EQ(again->triangleCount(), 4U);
    EXPECT_TRUE(again->topology().frontFacesSuffice());
}

TEST_F(Save, objectsKeepTheirNamesAndPlaces) {
    const MeshPointer mesh = tetrahedron();
    const std::array placed{PlacedMesh{"one", mesh.get()},
                            PlacedMesh{"two\nlines", mesh.get(), glm::translate(Mat4(1.0), Vec3(0, 5, 0))}};
    saveMeshFile(m_folder / "a.obj", placed);
    const LoadedFile back = loadMeshFile(m_folder / "a.obj");
    ASSERT_EQ(back.objects.size(), 2U);
    EXPECT_EQ(back.objects[1].name, "two_lines");
    EXPECT_NEAR(back.objects[1].mesh->origin().y, 5.5, 1e-12);
}

TEST_F(Save, mirroringTurnsTrianglesOverSoThatTheyStillFaceOutward) {
    const MeshPointer mesh = tetrahedron();
    const PlacedMesh placed{"mirrored", mesh.get(), glm::scale(Mat4(1.0), Vec3(-1, 2, 1))};
    saveMeshFile(m_folder / "a.ply", {&placed, 1});
    EXPECT_TRUE(loadMeshFile(m_folder / "a.ply").objects[0].mesh->topology().frontFacesSuffice());
}

TEST_F(Save, otherEndingsAndUnwritablePlacesAreRefused) {
    const MeshPointer mesh = tetrahedron();
    const PlacedMesh placed{"thing", mesh.get()};
    for (const auto& path : {m_folder / "a.gltf", m_folder / "none" / "a.obj"}) {
        try {
            saveMeshFile(path, {&placed, 1});
            ADD_FAILURE() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
        }
    }
}

TEST_F(Save, aStopLeavesNoFileBehind) {
    const MeshPointer mesh = tetrahedron();
    const PlacedMesh placed{"thing", mesh.get()};
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    EXPECT_THROW(saveMeshFile(m_folder / "a.obj", {&placed, 1}, progress), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder), {}), 1);  // t.obj
}

}  // namespace
}  // namespace cullscope::test::save_test
