// The real models, where their files are installed: counts as stated in their manifest.
#include "tests/support/mesh_files.h"

namespace cullscope::test::real_models_test {
namespace {

const std::filesystem::path kModels = CULLSCOPE_SOURCE_DIR "/../shared/models";

struct Expected {
    const char* file;
    size_t objects;
    size_t faces;
    size_t triangles;
    size_t boundaryEdges;
};

constexpr std::array kExpected{
    Expected{"bunny.obj", 1, 69'666, 69'666, 0},
    Expected{"clean/bunny/bunny-35947v-69451f-binary.ply", 1, 69'451, 69'451, 223},
    Expected{"clean/bunny/bunny-292f-prusa.stl", 1, 292, 292, 0},
    Expected{"clean/topology/adis16480-7436f-ascii.stl", 1, 7'436, 7'436, 0},
    Expected{"clean/topology/pmp-fandisk_quads.off", 1, 764, 1'528, 0},
    Expected{"clean/topology/pmp-beetle-BINARY.off", 1, 9'664, 9'664, 568},
    Expected{"scenes/intel-castle-occluders-114obj.obj", 114, 41'660, 41'660, 2'632},
    Expected{"scenes/fzk-haus-ifc-294obj-35906t.obj", 294, 16'037, 35'906, 3'445},
};

TEST(RealModels, haveTheCountsOfTheirManifest) {
    std::string missing;
    for (const Expected& expected : kExpected) {
        if (!std::filesystem::exists(kModels / expected.file)) {
            missing += std::string(" ") + expected.file;
            continue;
        }
        const LoadedFile file = loadMeshFile(kModels / expected.file);
        size_t triangles = 0;
        size_t boundaryEdges = 0;
        for (const LoadedObject& object : file.objects) {
            triangles += object.mesh->triangleCount();
            boundaryEdges += object.mesh->topology().boundaryEdges;
        }
        EXPECT_EQ(file.objects.size(), expected.objects) << expected.file;
        EXPECT_EQ(file.report.facesRead, expected.faces) << expected.file;
        EXPECT_EQ(triangles, expected.triangles) << expected.file;
        EXPECT_EQ(boundaryEdges, expected.boundaryEdges) << expected.file;
    }
    if (!missing.empty())
        GTEST_SKIP() << "These models are other people's and not part of this repository; each one that ../shared/models has was "
                        "read. Missing:"
                     << missing << ".";
}

TEST(RealModels, thoseThatShowBackFacesHavePocketsThatAreInsideOut) {
    // The first three lose pixels that no rounding explains where back faces are left out; bunny.obj crosses itself, too.
    std::string missing;
    for (const auto& [name, expected] : {std::pair("bunny-5000.obj", Pockets::Found),
                                         {"clean/classics/cow.obj", Pockets::Found},
                                         {"clean/topology/block.off", Pockets::Found},
                                         {"clean/topology/elk.off", Pockets::Found},
                                         {"bunny.obj", Pockets::None},
                                         {"clean/classics/elephant.obj", Pockets::None},
                                         {"clean/topology/knot.off", Pockets::None},
                                         {"clean/topology/cheese.off", Pockets::None}}) {
        if (std::filesystem::exists(kModels / name))
            EXPECT_EQ(loadMeshFile(kModels / name).objects.at(0).mesh->pockets(), expected) << name;
        else
            missing += std::string(" ") + name;
    }
    if (!missing.empty())
        GTEST_SKIP()
            << "These models are other people's and not part of this repository; InsideOut.* makes meshes of both kinds. "
               "Missing:"
            << missing << ".";
}

TEST(RealModels, allCleanFilesLoad) {
    if (!std::filesystem::is_directory(kModels / "clean"))
        GTEST_SKIP()
            << "The models of ../shared/models/clean are other people's and not part of this repository; the readers' own tests "
               "write files of every format.";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kModels / "clean")) {
        if (!entry.is_regular_file()) continue;
        EXPECT_EQ(tryLoading(entry.path()), Outcome::Loaded) << entry.path();
    }
}

}  // namespace
}  // namespace cullscope::test::real_models_test
