#include <sys/stat.h>

#include "core/base/error.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::load_refusals_test {
namespace {

class Refusals : public MeshFiles {};

TEST_F(Refusals, saysWhatToDoWithFilesThatAreNoMeshThemselves) {
    EXPECT_THAT(refusal("a.zip", "PK\x03\x04"), testing::HasSubstr("Unpack it first"));
    EXPECT_THAT(refusal("a.stl", "version https://git-lfs.github.com/spec/v1\n"), testing::HasSubstr("git lfs pull"));
    EXPECT_THAT(refusal("a.obj", std::string("\xFF\xFEv\0 \0", 6)), testing::HasSubstr("UTF-16"));
    EXPECT_THAT(refusal("a.obj", std::string("\0v\0 \0 0\0 \0 0", 13)), testing::HasSubstr("a.obj"));
    EXPECT_THAT(refusal("a.obj", ""), testing::HasSubstr("empty"));
    EXPECT_THAT(refusal("a.txt", "hello"), testing::HasSubstr(".obj, .ply, .stl, .off, .om"));
}

TEST_F(Refusals, foldersPipesAndMissingFilesAreNamed) {
    EXPECT_THAT(refusalOf(m_folder), testing::HasSubstr("folder"));
    EXPECT_THAT(refusalOf(m_folder / "none.obj"), testing::HasSubstr("cannot be opened"));
    const std::filesystem::path pipe = m_folder / "pipe.obj";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(refusalOf(pipe), testing::HasSubstr("not a regular file"));
}

TEST_F(Refusals, filesWithoutFacesAreRefused) {
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\np 1\n"), testing::HasSubstr("no faces"));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nf 1 1 1\n"), testing::HasSubstr("no usable face"));
    EXPECT_THAT(refusal("a.off", "OFF\n1 0 0\n0 0 0\n"), testing::HasSubstr("no faces"));
}

TEST_F(Refusals, theContentDecidesOverTheExtension) {
    EXPECT_EQ(
        load("really-ply.obj",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            .report.trianglesMade,
        1U);
    EXPECT_EQ(load("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").report.trianglesMade, 1U);
}

TEST_F(Refusals, memoryLimitIsHeldBeforeAllocating) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 100000\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n";
    bytes.resize(bytes.size() + 1'200'000);
    LoadOptions options;
    options.memoryLimitBytes = 1'000'000;
    try {
        (void)loadMeshFile(write("a.ply", bytes), options);
        FAIL() << "was not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("of memory"));
    }
}

TEST_F(Refusals, linesWithoutEndAreRefused) {
    EXPECT_THAT(refusal("a.obj", "f " + std::string(size_t{9} << 20, '1')), testing::HasSubstr("longer than 8 MB"));
    std::string continued;
    for (int line = 0; line < 3000; ++line) continued.append(4000, ' ').append("\\\n");
    EXPECT_THAT(refusal("b.obj", "f " + continued), testing::HasSubstr("goes on for more than 8 MB"));
}

TEST_F(Refusals, hashIsThatOfTheWholeFile) {
    const std::string bytes = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(load("a.obj", bytes).sha256, "697b00ab13410c52a542d2e9c63711fcc04e9cbf6c0d3439a9b43cc812e6e713");
    LoadOptions options;
    options.hash = false;
    EXPECT_EQ(loadMeshFile(write("b.obj", bytes), options).sha256, "");
}

}  // namespace
}  // namespace cullscope::test::load_refusals_test
