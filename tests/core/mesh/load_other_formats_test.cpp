#include "tests/support/mesh_files.h"

namespace cullscope::test::load_other_formats_test {
namespace {

class LoadStl : public MeshFiles {};
class LoadOff : public MeshFiles {};
class LoadOm : public MeshFiles {};

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 0\n outer loop\n vertex " + a + "\n vertex " + b + "\n vertex " + c + "\n endloop\nendfacet\n";
}

std::string binaryStl(const std::string& header, uint32_t claimed, uint32_t written) {
    std::string bytes = header + std::string(80 - header.size(), '\0');
    append(bytes, claimed);
    for (uint32_t i = 0; i < written; ++i)
        append(bytes, std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, static_cast<float>(i)}, uint16_t{0});
    return bytes;
}

TEST_F(LoadStl, everySolidIsAnObjectAndCornersAtEqualPositionsAreOneVertex) {
    const LoadedFile file =
        load("a.stl", "solid one\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "1 1 0", "-0 1 0") +
                          "endsolid one\nsolid empty\nendsolid\nSOLID two\n" + facet("0 0 1", "1 0 1", "0 1 1") + "endsolid\n");
    ASSERT_EQ(file.objects.size(), 2U);
    EXPECT_EQ(file.objects[0].name, "one");
    EXPECT_EQ(file.objects[0].mesh->vertexCount(), 4U);
    EXPECT_EQ(file.objects[1].name, "two");
}

TEST_F(LoadStl, binaryFileThatBeginsWithSolidIsReadAsBinary) {
    EXPECT_EQ(load("a.stl", binaryStl("solid facet", 2, 2)).report.trianglesMade, 2U);
}

TEST_F(LoadStl, binaryCountBeyondTheFileIsRefusedAndBytesAfterItAreRemarkedOn) {
    EXPECT_THAT(refusal("a.stl", binaryStl("x", 4'000'000'000, 2)), testing::HasSubstr("byte 80 promises 4000000000 triangles"));
    EXPECT_EQ(load("a.stl", binaryStl("x", 1, 2)).report.remarks.size(), 1U);
}

TEST_F(LoadStl, manyEqualNotANumbersTakeNoTimeToSpeakOf) {
    std::string bytes = binaryStl("x", 100'001, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 100'000; ++i)
        append(bytes, std::array<float, 12>{nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan}, uint16_t{0});
    EXPECT_EQ(load("a.stl", bytes).report.nonFiniteVertices, 300'000U);
}

TEST_F(LoadStl, endWithinAFacetAndUnknownWordsAreRefusedWithTheirLine) {
    EXPECT_THAT(refusal("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
                testing::HasSubstr("ends after line 4"));
    EXPECT_THAT(refusal("a.stl", "solid a\nfacet normal 0 0 1\nhello\n"), testing::HasSubstr("line 3: \"hello\""));
}

TEST_F(LoadOff, headerVariantsCommentsAndColoursAreRead) {
    const std::string body = "3 1 # edges are missing\n\n# a comment\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n";
    EXPECT_EQ(load("a.off", "OFF\n" + body).report.trianglesMade, 1U);
    EXPECT_EQ(load("b.off", "OFF " + body).report.trianglesMade, 1U);
    EXPECT_EQ(load("c.off", body).report.trianglesMade, 1U);
    EXPECT_EQ(
        load("d.off", "STCOFF\n3 1 0\n0 0 0 1 1 1 1 0 0\n1 0 0 1 1 1 1 0 0\n0 1 0 1 1 1 1 0 0\n3 0 1 2\n").report.trianglesMade,
        1U);
    const LoadedFile normals = load("e.off", "CNOFF\n3 1 0\n0 0 0 0 1 0 9 9 9\n1 0 0 0 1 0 9 9 9\n0 1 0 0 1 0 9 9 9\n3 0 1 2\n");
    EXPECT_EQ(normals.objects[0].mesh->normals()[0], Vec3f(0, 1, 0));
}

TEST_F(LoadOff, binaryFilesOfBothByteOrdersAreRead) {
    std::string little = "OFF BINARY\n";
    append(little, std::array<int32_t, 3>{4, 1, 0}, std::array<float, 12>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
           std::array<int32_t, 5>{4, 0, 1, 2, 3});
    EXPECT_EQ(load("a.off", little).report.trianglesMade, 2U);
    std::string big = little.substr(0, 11);
    for (size_t at = 11; at < little.size(); at += 4) big += {little[at + 3], little[at + 2], little[at + 1], little[at]};
    big += std::string("\0\0\0\1", 4) + "COLR";  // one colour component after the face
    EXPECT_EQ(load("b.off", big).report.trianglesMade, 2U);
}

TEST_F(LoadOff, claimsOfBillionsAndOtherDimensionsAreRefused) {
    EXPECT_THAT(refusal("a.off", "OFF\n353535235358 6 0\n0 0 0\n"), testing::HasSubstr("promises 353535235358 vertices"));
    EXPECT_THAT(refusal("a.off", "4OFF\n1 1 0\n"), testing::HasSubstr("number of dimensions"));
}

TEST_F(LoadOff, byteOrderMarkBeforeTextIsPassedOver) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(load("a.off", mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").report.trianglesMade, 1U);
    EXPECT_EQ(load("a.stl", mark + "solid one\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid one\n").report.trianglesMade, 1U);
    EXPECT_EQ(load("a.ply", mark + "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                   "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
                  .report.trianglesMade,
              1U);
    EXPECT_EQ(load("b.stl", binaryStl(mark + "a header that begins like text", 2, 2)).report.facesRead, 2U);
}

TEST_F(LoadOm, filesOfOpenMeshAreReadWithTheirNormalsAndInDouble) {
    const std::filesystem::path data = CULLSCOPE_SOURCE_DIR "/tests/core/mesh/data";
    const LoadedFile quad = loadMeshFile(data / "quad.om");
    EXPECT_EQ(quad.report.facesRead, 1U);
    EXPECT_EQ(quad.report.trianglesMade, 2U);
    EXPECT_GT(quad.objects[0].mesh->normals()[0].z, 0.99F);
    EXPECT_TRUE(quad.objects[0].mesh->topology().consistentlyOriented);
    const LoadedFile wide = loadMeshFile(data / "triangle-double.om");
    EXPECT_NEAR(wide.objects[0].mesh->localBounds().max.x + wide.objects[0].mesh->origin().x, 10'000'000.125, 0.5);
    EXPECT_EQ(wide.objects[0].mesh->origin().x, 5'000'000.5625);  // floats would lose the fraction
}

}  // namespace
}  // namespace cullscope::test::load_other_formats_test
