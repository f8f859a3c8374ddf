#include "tests/support/mesh_files.h"

namespace cullscope::test::load_ply_test {
namespace {

class LoadPly : public MeshFiles {};

const std::string kFloats = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";

std::string asciiHeader(int vertices, const std::string& rest) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) + "\n" + kFloats + rest + "end_header\n";
}

TEST_F(LoadPly, stripsTurnEverySecondTriangleAndRestartAtMinusOne) {
    const LoadedFile file = load("a.ply", asciiHeader(6, "element tristrips 1\nproperty list int int vertex_indices\n") +
                                              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n5 5 0\n10 0 1 2 3 4 -1 3 1 5 -1\n");
    const TriangleMesh& mesh = *file.objects[0].mesh;
    ASSERT_EQ(mesh.triangleCount(), 4U);
    EXPECT_EQ(file.report.facesRead, 4U);
    for (size_t i = 0; i < 9; i += 3) {
        const Vec3 a = mesh.position(mesh.indices()[i]);
        EXPECT_GT(glm::cross(mesh.position(mesh.indices()[i + 1]) - a, mesh.position(mesh.indices()[i + 2]) - a).z, 0.0) << i;
    }
}

TEST_F(LoadPly, binaryStripsAreRead) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 4\n" + kFloats +
                        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    append(bytes, std::array<float, 12>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, std::array<int32_t, 7>{6, 0, 1, 2, 3, -1, 0});
    EXPECT_EQ(load("a.ply", bytes).report.trianglesMade, 2U);
}

TEST_F(LoadPly, repeatedCornersOfAStripOnlyJoinItsPieces) {
    const LoadedFile file = load("a.ply", asciiHeader(4, "element tristrips 1\nproperty list int int vertex_indices\n") +
                                              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n7 0 1 2 2 2 1 3\n");
    EXPECT_EQ(file.report.trianglesMade, 2U);
    EXPECT_EQ(file.report.degenerateFaces, 0U);
    EXPECT_TRUE(file.objects[0].mesh->topology().consistentlyOriented);
}

TEST_F(LoadPly, unknownElementsAndPropertiesArePassedOver) {
    const LoadedFile file = load(
        "a.ply",
        "ply\r\nformat ascii 1.0\r\nelement odd 2\r\nproperty list uchar float things\r\nproperty int n\r\nelement vertex 3\r\n"
        "property uchar red\r\nproperty double z\r\nproperty short y\r\nproperty list uchar int l\r\nproperty float x\r\n"
        "element face 1\r\nproperty float quality\r\nproperty list int uint vertex_index\r\nproperty list uchar float uv\r\n"
        "end_header\r\n2 1.5 2.5 7\r\n0 8\r\n255 0.5 0 0 1\r\n255 0.5 0 1 9 2\r\n255 0.5 3 0 1\r\n0.5 3 0 1 2 2 0.0 1.0\r\n");
    const TriangleMesh& mesh = *file.objects[0].mesh;
    EXPECT_EQ(mesh.position(0), Vec3(1, 0, 0.5));
    EXPECT_EQ(mesh.position(2), Vec3(1, 3, 0.5));
    EXPECT_EQ(file.report.trianglesMade, 1U);
}

TEST_F(LoadPly, headersMayEndTheirLinesInThreeWaysAndTheBodyMayBeginWithALineFeed) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string bytes =
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
            "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
        for (size_t at = bytes.find('\n'); at != std::string::npos; at = bytes.find('\n', at + end.size()))
            bytes.replace(at, 1, end);
        bytes += std::string("\n\r\0\1\0\0\0\1\0\3\0\1\2", 13);
        const LoadedFile file = load("a.ply", bytes);
        EXPECT_EQ(file.objects[0].mesh->position(0), Vec3(10, 13, 0));
        EXPECT_EQ(file.report.trianglesMade, 1U);
    }
}

TEST_F(LoadPly, normalsOfTheFileAreKept) {
    const LoadedFile file = load("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + kFloats +
                                              "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n" +
                                              kFaces + "end_header\n0 0 0 0 1 0\n1 0 0 0 3 0\n0 1 0 nan 0 0\n3 0 1 2\n");
    EXPECT_EQ(file.objects[0].mesh->normals()[1], Vec3f(0, 1, 0));
    EXPECT_EQ(file.objects[0].mesh->normals()[2], Vec3f(0, 0, 1));
    EXPECT_EQ(file.report.normalsMade, 1U);
}

TEST_F(LoadPly, countsThatTheFileCannotHoldAreRefusedBeforeAnythingIsTaken) {
    EXPECT_THAT(
        refusal("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" + kFloats + "end_header\n1234"),
        testing::HasSubstr("line 3 promises 4000000000 of \"vertex\", but only 4 bytes follow"));
    EXPECT_THAT(refusal("a.ply", asciiHeader(1, "element face 999999999999\n" + kFaces) + "0 0 0\n"),
                testing::HasSubstr("promises 999999999999"));
    EXPECT_THAT(refusal("a.ply", asciiHeader(3, "element face 1\n" + kFaces) + "0 0 0\n0 1 0\n1 0 0\n9999999999 1 2 3\n"),
                testing::HasSubstr("cannot have 9999999999 values"));
}

TEST_F(LoadPly, facesWithoutAListOfVertexNumbersAreRefused) {
    EXPECT_THAT(refusal("a.ply", asciiHeader(1, "element face 1\nproperty int vertex_indices\n") + "0 0 0\n0\n"),
                testing::HasSubstr("line 7"));
    EXPECT_THAT(refusal("a.ply", asciiHeader(1, "element face 1\nproperty list uchar float vertex_indices\n") + "0 0 0\n0\n"),
                testing::HasSubstr("vertex_indices"));
}

TEST_F(LoadPly, missingCoordinatesAreRefused) {
    EXPECT_THAT(
        refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n"),
        testing::HasSubstr("no x, y and z"));
}

TEST_F(LoadPly, bytesAfterTheMeshAreRemarkedOn) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kFloats + "element face 1\n" + kFaces + "end_header\n";
    append(bytes, std::array<float, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0}, uint8_t{3}, std::array<int32_t, 3>{0, 1, 2});
    EXPECT_TRUE(load("a.ply", bytes).report.clean());
    EXPECT_THAT(load("b.ply", bytes + "12345").report.sentences()[0].english(), testing::HasSubstr(": 5."));
}

TEST_F(LoadPly, analysisIsNotMadeAboveItsLimitAndSaysSo) {
    const uint32_t faces = static_cast<uint32_t>(kOptionalAnalysisLimit) + 1;
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kFloats + "element face " +
                        std::to_string(faces) + "\nproperty list uchar uchar vertex_indices\nend_header\n";
    append(bytes, std::array<float, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (uint32_t face = 0; face < faces; ++face) bytes.append("\3\0\1\2", 4);
    const LoadedFile file = load("a.ply", bytes);
    EXPECT_FALSE(file.report.analysed);
    EXPECT_EQ(file.report.duplicateFaces, 0U);
    EXPECT_EQ(file.report.remarks.size(), 1U);
}

}  // namespace
}  // namespace cullscope::test::load_ply_test
