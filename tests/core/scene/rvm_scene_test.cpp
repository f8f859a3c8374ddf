#include "core/scene/rvm/rvm_scene.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/base/error.h"
#include "core/scene/rvm/rvm_records.h"
#include "core/scene/scene_source.h"
#include "tests/support/changed_files.h"
#include "tests/support/mesh_files.h"
#include "tests/support/rvm_bytes.h"

namespace cullscope::test::rvm_scene_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class Rvm : public MeshFiles {
protected:
    [[nodiscard]] FileScene read(std::string_view bytes) const { return readRvmFile(write("a.rvm", bytes)); }
    [[nodiscard]] std::string refused(std::string_view bytes) const {
        try {
            (void)read(bytes);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            return error.what();
        }
        return {};
    }
};

TEST_F(Rvm, primitivesBecomePartsOfTheirGroups) {
    const FileScene read = this->read(rvmSample());
    const Scene& scene = *read.scene;
    std::vector<std::string> names;
    for (const Instance& instance : scene.instances()) names.push_back(instance.name);
    EXPECT_THAT(names, testing::ElementsAre("/PUMP", "/VESSEL", "/PIPE", "/PIPE (2)", "/PIPE (3)", "/PLATE"));
    using testing::Pair;
    EXPECT_THAT(scene.partCounts(),
                testing::UnorderedElementsAre(Pair("frustum of a pyramid", 1u), Pair("box", 1u), Pair("rectangular torus", 1u),
                                              Pair("circular torus", 1u), Pair("ellipsoidal dish", 1u),
                                              Pair("spherical dish", 1u), Pair("eccentric cone", 1u), Pair("cylinder", 3u),
                                              Pair("sphere", 1u), Pair("facet group", 1u), Pair("line", 1u)));
    EXPECT_EQ(scene.remarks().up, UpAxis::Z);
    const std::vector<ObjectGroup>& groups = scene.remarks().components->groups;
    EXPECT_EQ(groups[scene.instances()[0].group].name, "/PUMP");
    EXPECT_EQ(groups[groups[scene.instances()[0].group].parent].name, "/SITE");
    const auto& snout = std::get<primitive::EccentricCone>(scene.partsOf(1)[2].solid);
    EXPECT_EQ(snout.bottomRadius, 500.0);
    EXPECT_EQ(snout.offset, Vec2(100, 0));
    EXPECT_NEAR(snout.top.y.radians(), -0.1, 1e-7);
    EXPECT_TRUE(read.report.remarks.empty());
}

TEST_F(Rvm, equalPipesShareAMeshAndMirroredOnesFaceOutward) {
    const ScenePointer read = this->read(rvmSample()).scene;
    const Scene& scene = *read;
    EXPECT_EQ(scene.instances()[2].mesh, scene.instances()[3].mesh);
    EXPECT_NE(scene.instances()[2].mesh, scene.instances()[4].mesh);
    EXPECT_TRUE(scene.meshOf(4).topology().frontFacesSuffice());
    EXPECT_NEAR(scene.instanceBox(3).max.z, 6.0, 1e-5) << "a pipe of 2 m about z = 5 m";
    EXPECT_NEAR(scene.instanceBox(3).halfExtent().x, 0.05, 1e-5);
}

TEST_F(Rvm, holesOfFacetsAreHoles) {
    const ScenePointer read = this->read(rvmSample()).scene;
    const Scene& scene = *read;
    const TriangleMesh& plate = scene.meshOf(5);
    double area = 0.0;
    for (size_t i = 0; i < plate.indices().size(); i += 3) {
        const Vec3 a = plate.position(plate.indices()[i]);
        const Vec3 doubled = glm::cross(plate.position(plate.indices()[i + 1]) - a, plate.position(plate.indices()[i + 2]) - a);
        EXPECT_GE(doubled.z, 0.0) << "as the outline turns";
        area += 0.5 * doubled.z;
    }
    EXPECT_NEAR(area, 0.75, 1e-6) << "a square metre without the quarter";
}

TEST_F(Rvm, impossibleSolidsAreLeftOutWithARemark) {
    RvmBytes file;
    file.head().group("/A").primitive(2, {1, 1, 1}).primitive(8, {-5, 100}).primitive(4, {10, 20, 1}).endGroup().finish();
    const FileScene read = this->read(file.bytes());
    EXPECT_EQ(read.scene->partCounts().size(), 1u);
    ASSERT_EQ(read.report.remarks.size(), 1u);
    EXPECT_THAT(read.report.remarks[0].english(),
                HasSubstr("no such solid exists: 2. The first, at byte 316: cylinder: its lengths"));
}

TEST_F(Rvm, whatLiesBeyondAllNumbersIsLeftOutAndMemoryIsLimited) {
    RvmBytes far;
    far.head()
        .group("/A")
        .primitive(2, {1, 1, 1})
        .primitive(2, {1e29, 1, 1}, {3e38, 0, 0})
        .primitive(8, {1e20, 1e20})
        .endGroup()
        .finish();
    const FileScene read = this->read(far.bytes());
    ASSERT_EQ(read.report.remarks.size(), 1u);
    EXPECT_THAT(read.report.remarks[0].english(), HasSubstr("exists: 1. The first, at byte 316: It lies beyond 1e30."));
    EXPECT_LT(read.scene->triangleCount(), 1000u) << "a cylinder of any size";
    RvmBytes many;
    many.head().group("/A");
    for (int i = 0; i < 100; ++i) many.primitive(9, {1e9 + 1e6 * i});
    many.endGroup().finish();
    LoadOptions options;
    options.memoryLimitBytes = 10'000'000;
    try {
        (void)readRvmFile(write("a.rvm", many.bytes()), options);
        FAIL() << "was not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("of memory"));
    }
}

TEST_F(Rvm, malformedFilesAreRefusedWithTheByte) {
    const std::string good = rvmSample();
    EXPECT_THAT(refused("HEAD, but as a text of some length"), HasSubstr("a.rvm, byte 0: no record"));
    EXPECT_THAT(refused(good.substr(0, 10)), HasSubstr("byte 0: the file breaks off"));
    RvmBytes file;
    EXPECT_THAT(refused(RvmBytes().begin("MODL").end().bytes()), HasSubstr("begins with a record HEAD"));
    EXPECT_THAT(refused(RvmBytes().begin("HEAD").end().begin("CNTB").end().bytes()),
                HasSubstr("byte 24: the record MODL is missing"));
    EXPECT_THAT(refused(RvmBytes().head().group("/A").finish().bytes()), HasSubstr("ends within a group"));
    EXPECT_THAT(refused(RvmBytes().head().endGroup().bytes()), HasSubstr("a group ends that has not begun"));
    EXPECT_THAT(refused(RvmBytes().head().begin("WHAT").end().bytes()), HasSubstr("the record \"WHAT\" is unknown"));
    EXPECT_THAT(refused(RvmBytes().head().group("/A").primitive(12, {1}).bytes()), HasSubstr("there is no primitive of kind 12"));
    EXPECT_THAT(refused(RvmBytes().head().group("/A").primitive(2, {1, 1}).bytes()), HasSubstr("the record PRIM is too short"));
    EXPECT_THAT(refused(RvmBytes().head().primitive(2, {1, 1, 1}).bytes()), HasSubstr("outside of all groups"));
    EXPECT_THAT(refused(RvmBytes().head().group("/A").endGroup().finish().bytes()), HasSubstr("no surface"));
    EXPECT_THAT(refused(RvmBytes().head().group("/A").primitive(2, {1, 1, std::nan("")}).bytes()), HasSubstr("infinity or NaN"));
    const auto facets = [](uint32_t polygons, uint32_t contours, uint32_t corners) {
        return RvmBytes()
            .head()
            .group("/A")
            .beginPrimitive(11, Vec3(0))
            .whole(polygons)
            .whole(contours)
            .whole(corners)
            .end()
            .bytes();
    };
    EXPECT_THAT(refused(facets(0xffffffff, 1, 1)), HasSubstr("4294967295 items, more than the record"));
    EXPECT_THAT(refused(facets(1, 0x40000000, 1)), HasSubstr("1073741824 items"));
    EXPECT_THAT(refused(facets(1, 1, 178956971)), HasSubstr("178956971 items"));
    EXPECT_THAT(refused(RvmBytes().head().begin("CNTB").whole(2).whole(0x7fffffff).end().bytes()),
                HasSubstr("too long to be one"));
    std::string wrongEnd = good;
    wrongEnd[16] = '\x7f';
    EXPECT_THAT(refused(wrongEnd), HasSubstr("byte 16: the next record is said to begin at byte 2130706"));
    RvmBytes deep;
    deep.head();
    for (int i = 0; i < 2000; ++i) deep.group("/A");
    EXPECT_THAT(refused(deep.bytes()), HasSubstr("groups lie deeper"));
}

TEST_F(Rvm, everyTruncationAndEverySeededMutationLoadsOrIsRefused) {
    EXPECT_TRUE(everyChangeLoadsOrIsRefused(
        rvmSample(), "a.rvm", [&](std::string_view bytes) { return readRvmFile(write("a.rvm", bytes), {}, {}, 0.1).scene; }));
}

const std::filesystem::path kHuldra = CULLSCOPE_SOURCE_DIR "/../shared/models/scenes/huldra-WD1-PSUP.RVM";

TEST(RvmOfAPlatform, hasItsPrimitivesByKindAndKeepsTheFilesOwnBoxes) {
    if (!std::filesystem::exists(kHuldra))
        GTEST_SKIP() << "The plant " << kHuldra
                     << " is other people's and not part of this repository; the cases above write files.";
    const OpenedScene opened = openScene(kHuldra.string());
    using testing::Pair;
    EXPECT_THAT(opened.scene->partCounts(),
                testing::UnorderedElementsAre(Pair("box", 936u), Pair("cylinder", 624u), Pair("frustum of a pyramid", 472u),
                                              Pair("facet group", 334u), Pair("rectangular torus", 262u), Pair("line", 129u)));
    EXPECT_EQ(opened.scene->instances().size(), 2185u) << "groups that own primitives with a surface";
    // Every primitive's box, and that of its triangles, within 3 % of what the file states.
    ByteSource source(kHuldra, {}, false);
    size_t looked = 0;
    double worst = 0.0;
    rvm::readRecords(
        source, {[](const std::string&) {}, [] {},
                 [&](rvm::Record&& record) {
                     if (record.kind == rvm::Record::Kind::Line) return;
                     Box3 box;
                     if (record.kind == rvm::Record::Kind::Solid) box = primitive::bounds(record.solid);
                     for (const rvm::Polygon& polygon : record.polygons)
                         for (const std::vector<Vec3>& contour : polygon.contours)
                             for (const Vec3& corner : contour) box.add(corner);
                     const Vec3 size = record.box.max - record.box.min;
                     const double largest = std::max({size.x, size.y, size.z});
                     for (int axis = 0; axis < 3; ++axis)
                         for (const double away : {box.min[axis] - record.box.min[axis], box.max[axis] - record.box.max[axis]})
                             worst = std::max(worst, std::abs(away) / largest);
                     ++looked;
                 }});
    EXPECT_EQ(looked, 2628u);
    EXPECT_LT(worst, 0.03);
}

}  // namespace
}  // namespace cullscope::test::rvm_scene_test
