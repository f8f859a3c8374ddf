#include "tests/support/mesh_files.h"

namespace cullscope::test::load_obj_test {
namespace {

class LoadObj : public MeshFiles {};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(LoadObj, objectsAndGroupsWithFacesBecomeObjectsWithNamesOfTheirOwn) {
    const LoadedFile file =
        load("a.obj", kSquare + "f 1 2 3\no wall\ng empty\ng wall\nf 1 2 3\no wall\nf 1 3 4\ng top left\nf 1 2 4\n");
    ASSERT_EQ(file.objects.size(), 4U);
    EXPECT_EQ(file.objects[0].name, "a");
    EXPECT_EQ(file.objects[1].name, "wall");
    EXPECT_EQ(file.objects[2].name, "wall (2)");
    EXPECT_EQ(file.objects[3].name, "top left");
    EXPECT_EQ(file.objects[1].mesh->vertexCount(), 3U);
    EXPECT_TRUE(file.report.clean());
}

TEST_F(LoadObj, eachObjectHasAnOriginOfItsOwn) {
    const LoadedFile file =
        load("a.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 100 0 0\nv 104 0 0\nv 100 4 0\no a\nf 1 2 3\no b\nf 4 5 6\n");
    EXPECT_EQ(file.objects[0].mesh->origin(), Vec3(1, 1, 0));
    EXPECT_EQ(file.objects[1].mesh->origin(), Vec3(102, 2, 0));
    EXPECT_EQ(file.objects[1].mesh->position(1), Vec3(104, 0, 0));
}

TEST_F(LoadObj, negativeIndicesCountBackAndIndicesOutOfRangeAreDroppedAndCounted) {
    const LoadedFile file =
        load("a.obj", kSquare + "f -4 -3 -2\nf 1 2 5\nf 0 1 2\nf -5 1 2\nf 1 2 99999999999999999999\nf 4 1 3\n");
    EXPECT_EQ(file.report.facesRead, 6U);
    EXPECT_EQ(file.report.outOfRangeFaces, 4U);
    EXPECT_EQ(file.objects[0].mesh->triangleCount(), 2U);
}

TEST_F(LoadObj, facesMayComeBeforeTheirVertices) { EXPECT_EQ(load("a.obj", "f 1 2 3\n" + kSquare).report.trianglesMade, 1U); }

TEST_F(LoadObj, everyKindOfDamageIsCountedOnce) {
    const LoadedFile file = load("a.obj",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv nan 0 0\nv 1e999 0 0\nv 2 0 0\nv 9 9 9\nv 0 -1 0\n"
                                 "f 1 2 3\n"    // good
                                 "f 2 3 1\n"    // duplicate
                                 "f 1 3 2\n"    // the other side: kept
                                 "f 1 2 4\n"    // makes 1-2 non-manifold
                                 "f 1 2 5\n"    // NaN
                                 "f 1 6 2\n"    // infinite
                                 "f 1 2 7\n"    // no area
                                 "f 1 1 2\n"    // repeated corner
                                 "f 1 2\n"      // two corners
                                 "f 2 1 9\n");  // a fourth triangle at 1-2
    EXPECT_EQ(file.report.facesRead, 10U);
    EXPECT_EQ(file.report.duplicateFaces, 1U);
    EXPECT_EQ(file.report.degenerateFaces, 3U);
    EXPECT_EQ(file.report.nonFiniteVertices, 2U);
    EXPECT_EQ(file.report.unreferencedVertices, 1U);
    EXPECT_EQ(file.report.nonManifoldEdges, 1U);
    EXPECT_EQ(file.report.outOfRangeFaces, 0U);
    EXPECT_EQ(file.report.trianglesMade, 4U);
    EXPECT_EQ(file.report.sentences().size(), 5U);
    EXPECT_FALSE(file.report.clean());
}

TEST_F(LoadObj, coordinatesTooLargeForFloatsAreDroppedAndCounted) {
    const LoadedFile file = load("a.obj", kSquare + "v 1e31 0 0\nf 1 2 3\nf 1 2 5\n");
    EXPECT_EQ(file.report.nonFiniteVertices, 1U);
    EXPECT_EQ(file.report.trianglesMade, 1U);
}

TEST_F(LoadObj, aPositionWithSeveralNormalsBecomesSeveralVertices) {
    const LoadedFile file = load("a.obj", kSquare + "vn 0 0 1\nvn 0 0 2\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//3 4//1\n");
    const TriangleMesh& mesh = *file.objects[0].mesh;
    EXPECT_EQ(mesh.vertexCount(), 6U);  // 1 and 3 twice; normals are normalised afterwards
    EXPECT_EQ(mesh.normals()[0], Vec3f(0, 0, 1));
    EXPECT_EQ(file.report.normalsMade, 0U);
}

TEST_F(LoadObj, missingAndUnusableNormalsAreMade) {
    const LoadedFile file = load("a.obj", kSquare + "vn 0 0 0\nvn nan 0 0\nvn 0 1 0\nf 1//1 2//2 3//3\nf 1//9 3//3 4\n");
    EXPECT_EQ(file.report.normalsMade, 4U);
    for (const Vec3f& normal : file.objects[0].mesh->normals()) EXPECT_TRUE(normal == Vec3f(0, 0, 1) || normal == Vec3f(0, 1, 0));
}

TEST_F(LoadObj, concavePolygonIsCutInsideItsOutline) {
    // An L-shape with area 3; a fan from the first corner would cover more.
    const LoadedFile file = load("a.obj", "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n");
    const TriangleMesh& mesh = *file.objects[0].mesh;
    EXPECT_EQ(mesh.triangleCount(), 4U);
    double area = 0.0;
    for (size_t i = 0; i < 12; i += 3) {
        const Vec3 a = mesh.position(mesh.indices()[i]);
        const double part =
            0.5 * glm::cross(mesh.position(mesh.indices()[i + 1]) - a, mesh.position(mesh.indices()[i + 2]) - a).z;
        EXPECT_GT(part, 0.0);
        area += part;
    }
    EXPECT_NEAR(area, 3.0, 1e-12);
}

TEST_F(LoadObj, continuedLinesCarriageReturnsAndByteOrderMarkAreRead) {
    EXPECT_EQ(load("a.obj", "\xEF\xBB\xBFv 0 0 0\r\nv 1 \\\r\n0 0\r\nv 0 1 0\r\nf 1 2 \\\r\n3\r\n").report.trianglesMade, 1U);
    EXPECT_EQ(load("b.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").report.trianglesMade, 1U);
}

TEST_F(LoadObj, unknownKeywordsArePassedOverWithARemark) {
    const LoadedFile file = load("a.obj", kSquare + "hello world\nusemtl x\nmtllib /dev/zero\nf 1 2 3\n");
    ASSERT_EQ(file.report.remarks.size(), 1U);
    EXPECT_THAT(file.report.remarks[0].english(), testing::HasSubstr("line 5"));
}

TEST_F(LoadObj, whatIsNoNumberIsRefusedWithItsLine) {
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 zero 0\n"), testing::HasSubstr("line 2: \"zero\" is not a number"));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 2\n"), testing::HasSubstr("line 2: a vertex or normal has only 2"));
    EXPECT_THAT(refusal("a.obj", kSquare + "f 1 2 three\n"), testing::HasSubstr("line 5: \"three\" is not a corner"));
    EXPECT_THAT(refusal("a.obj", "v 1.0.0 0 0\n"), testing::HasSubstr("1.0.0"));
}

TEST_F(LoadObj, oddButCompleteNumbersAreRead) {
    const LoadedFile file = load("a.obj", "v -.5 +1e+00 0.\nv 5.e-1 1 0\nv 0 2E0 0\nf 1 2 3\n");
    EXPECT_EQ(file.objects[0].mesh->position(0), Vec3(-0.5, 1, 0));
    EXPECT_EQ(file.objects[0].mesh->position(1), Vec3(0.5, 1, 0));
}

TEST_F(LoadObj, aPositionWithAHundredThousandNormalsTakesNoTimeToSpeakOf) {
    std::string text = kSquare;
    constexpr int kNormals = 100'000;
    for (int i = 0; i < kNormals; ++i) text += "vn " + std::to_string(i + 1) + " 1 0\n";
    for (int i = 1; i <= kNormals; ++i) text += "f 1//" + std::to_string(i) + " 2//1 3//1\n";
    EXPECT_EQ(load("a.obj", text).report.trianglesMade, size_t{kNormals});
}

}  // namespace
}  // namespace cullscope::test::load_obj_test
