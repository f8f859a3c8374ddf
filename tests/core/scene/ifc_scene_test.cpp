#include "core/scene/ifc/ifc_scene.h"

#include <gmock/gmock.h>

#include <random>

#include "core/base/error.h"
#include "core/scene/scene_source.h"
#include "tests/support/ifc_text.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"
#include "tests/support/packed_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/scene_words.h"
#include "tests/support/shared_models.h"

namespace cullscope::test::ifc_scene_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Ifc : public MeshFiles {
protected:
    [[nodiscard]] FileScene read(std::string_view bytes) const { return readIfcFile(write("a.ifc", bytes)); }
    [[nodiscard]] std::string refused(std::string_view bytes) const {
        return refusalOf([&] { (void)read(bytes); }, ErrorKind::Input);
    }
};

void expectBox(const Box3& box, const Vec3& low, const Vec3& high, double within = 1e-5) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], low[axis], within) << "axis " << axis;
        EXPECT_NEAR(box.max[axis], high[axis], within) << "axis " << axis;
    }
}

/// The area of an object, and what it encloses.
struct Size {
    double area = 0.0, volume = 0.0;
};

Size sizeOf(const Scene& scene, size_t instance) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    Size size;
    for (size_t i = 0; i < mesh.indices().size(); i += 3) {
        std::array<Vec3, 3> corners;
        for (size_t k = 0; k < 3; ++k)
            corners[k] = Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.position(mesh.indices()[i + k]), 1.0));
        size.area += 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        size.volume += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6.0;
    }
    return size;
}

/// The sample with an element whose number is 70.
std::string withElement(const std::string& lines) {
    return withLine(withLine(ifcSample(), 52,
                             "#52=IFCRELCONTAINEDINSPATIALSTRUCTURE('000000000000000000000B',#5,$,$,(#26,#44,#51,#70),#14);\n"),
                    51, "#51=IFCWINDOW('000000000000000000000A',#5,'Window',$,$,#47,#50,$,1500.,800.);\n" + lines);
}

TEST_F(Ifc, elementsBecomeObjectsOfTheirClassNameAndIdentifier) {
    const FileScene read = this->read(ifcSample());
    EXPECT_THAT(namesOf(*read.scene),
                ElementsAre("IfcWallStandardCase_Wall_0000000000000000000006", "IfcWindow_Window_0000000000000000000009",
                            "IfcWindow_Window_000000000000000000000A"));
    EXPECT_THAT(remarksOf(read.report), IsEmpty());
    EXPECT_EQ(read.scene->remarks().up, UpAxis::Y);
}

TEST_F(Ifc, elementsOfOneShapeShareItsMesh) {
    const ScenePointer scene = read(ifcSample()).scene;
    EXPECT_EQ(scene->meshes().size(), 2u);
    EXPECT_EQ(scene->instances()[1].mesh, scene->instances()[2].mesh);
}

TEST_F(Ifc, anElementOfSeveralMappedShapesIsAnObjectForEach) {
    const std::string both =
        withLine(ifcSample(), 42, "#42=IFCSHAPEREPRESENTATION(#10,'Body','MappedRepresentation',(#41,#71));\n");
    const std::string twice = withLine(both, 40,
                                       "#40=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#8,1.,$);\n"
                                       "#71=IFCMAPPEDITEM(#39,#72);\n"
                                       "#72=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#73,1.,$);\n"
                                       "#73=IFCCARTESIANPOINT((0.,0.,1500.));\n");
    const ScenePointer scene = read(twice).scene;
    EXPECT_THAT(namesOf(*scene),
                ElementsAre("IfcWallStandardCase_Wall_0000000000000000000006", "IfcWindow_Window_0000000000000000000009",
                            "IfcWindow_Window_0000000000000000000009 (2)", "IfcWindow_Window_000000000000000000000A"));
    EXPECT_EQ(scene->meshes().size(), 2u);
    expectBox(scene->instanceBox(2), {0.6, 2.5, -0.125}, {1.4, 4.0, -0.075});
}

TEST_F(Ifc, lengthsAreMetresAndYIsUp) {
    const ScenePointer scene = read(ifcSample()).scene;
    expectBox(scene->instanceBox(0), {0, 0, -0.2}, {4, 3, 0});
    expectBox(scene->instanceBox(1), {0.6, 1, -0.125}, {1.4, 2.5, -0.075});
    expectBox(scene->instanceBox(2), {5.6, 1, -0.125}, {6.4, 2.5, -0.075});
    const ScenePointer metres = read(withLine(ifcSample(), 6, "#6=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n")).scene;
    expectBox(metres->instanceBox(0), {0, 0, -200}, {4000, 3000, 0}, 1e-2);
    const FileScene feet = read(withLine(ifcSample(), 6,
                                         "#6=IFCCONVERSIONBASEDUNIT(#906,.LENGTHUNIT.,'FOOT',#907);\n"
                                         "#906=IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0);\n"
                                         "#907=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(0.3048),#908);\n"
                                         "#908=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n"));
    EXPECT_THAT(remarksOf(feet.report), testing::Contains(HasSubstr("Lengths in FOOT are taken for metres")));
    EXPECT_THAT(remarksOf(read(ifcSample()).report), testing::Not(testing::Contains(HasSubstr("Lengths in"))));
}

TEST_F(Ifc, openingsAreCutThroughTheWall) {
    const ScenePointer scene = read(ifcSample()).scene;
    const Size wall = sizeOf(*scene, 0);
    EXPECT_NEAR(wall.area, 26.8 - 2 * 1.2 + 0.92, 1e-5) << "a box without two rectangles, and the sides of the hole";
    EXPECT_NEAR(wall.volume, 2.4 - 0.24, 1e-5);
    const ScenePointer whole = read(withLine(ifcSample(), 35, "")).scene;
    EXPECT_EQ(whole->meshOf(0).triangleCount(), 12u);
    EXPECT_NEAR(sizeOf(*whole, 0).volume, 2.4, 1e-5);
}

TEST_F(Ifc, whatIsNotShownIsSaid) {
    EXPECT_THAT(remarksOf(read(withElement("#70=IFCBUILDINGELEMENTPROXY('000000000000000000000C',#5,'Line',$,$,#12,#71,$,$);\n"
                                           "#71=IFCPRODUCTDEFINITIONSHAPE($,$,(#72));\n"
                                           "#72=IFCSHAPEREPRESENTATION(#10,'Axis','Curve2D',(#73));\n"
                                           "#73=IFCPOLYLINE((#8,#20));\n"))
                              .report),
                ElementsAre("Shapes left out of kinds that are not read: 1 (IfcPolyline)."));
    const std::string upward = withLine(withLine(ifcSample(), 29, "#29=IFCRECTANGLEPROFILEDEF(.AREA.,$,#19,800.,400.);\n"), 30,
                                        "#30=IFCEXTRUDEDAREASOLID(#29,#9,#17,1500.);\n");
    EXPECT_THAT(remarksOf(read(upward).report),
                ElementsAre("Elements whose openings are not all cut, because of their shape: 1 (the first is #23)."));
}

TEST_F(Ifc, filesAreReadByTheirNameAndCompressedToo) {
    const std::string sha = read(ifcSample()).scene->sha256();
    EXPECT_TRUE(isIfcFile("HOUSE.IFC"));
    EXPECT_EQ(openScene(write("A.IFC", ifcSample()).string()).scene->sha256(), sha);
    EXPECT_EQ(openScene(write("b.ifc.xz", xzPacked(ifcSample())).string()).scene->sha256(), sha);
    EXPECT_EQ(openScene(write("c.ifc.gz", gzipped(ifcSample())).string()).scene->sha256(), sha);
}

TEST_F(Ifc, otherFilesAreRefusedWithASentence) {
    std::string other = ifcSample();
    other.replace(other.find("IFC2X3"), 6, "IFC4");
    EXPECT_THAT(refused(other), AllOf(HasSubstr("a.ifc has the schema IFC4"), HasSubstr("only IFC 2x3 is read")));
    other.replace(other.find("IFC4"), 4, "CONFIG_CONTROL_DESIGN");
    EXPECT_THAT(refused(other), HasSubstr("a.ifc has the schema CONFIG_CONTROL_DESIGN"));
    EXPECT_THAT(refused("solid a\nendsolid a\n"), HasSubstr("a.ifc is no IFC file of the kind that is read"));
    EXPECT_THAT(refused("<?xml version=\"1.0\"?><ifcXML/>"), HasSubstr("not .ifcXML or .ifcZIP"));
    EXPECT_THAT(refused(""), HasSubstr("a.ifc"));
}

TEST_F(Ifc, truncatedFilesAreRefused) {
    const std::string good = ifcSample();
    for (size_t length = good.size() - 2; length > 20; length -= std::min<size_t>(length - 20, 97))
        EXPECT_THAT(refused(std::string_view(good).substr(0, length)), HasSubstr("a.ifc breaks off")) << length;
    EXPECT_EQ(refused("\xef\xbb\xbf \r\n" + good + "\n\n"), "") << "what stands around it does not matter";
}

TEST_F(Ifc, filesWithoutASurfaceAreRefused) {
    std::string none = ifcSample();
    for (const int element : {26, 44, 51}) none = withLine(none, element, "");
    none = withLine(withLine(none, 52, ""), 35, "");
    EXPECT_THAT(refused(none), AllOf(HasSubstr("a.ifc cannot be read as IFC"), HasSubstr("no element has a surface")));
    EXPECT_THAT(refused(withLine(ifcSample(), 11, "")), HasSubstr("missing IfcProject entity"));
}

TEST_F(Ifc, filesThatMakeTheReaderCrashAreRefused) {
    EXPECT_THAT(refused(withLine(ifcSample(), 22, "")), AllOf(HasSubstr("a.ifc cannot be read"), HasSubstr("crash")));
}

TEST_F(Ifc, filesBeyondTheMemoryAreRefused) {
    LoadOptions options;
    options.memoryLimitBytes = 1000;
    EXPECT_THAT(refusalOf([&] { (void)readIfcFile(write("a.ifc", ifcSample()), options); }, ErrorKind::Input),
                AllOf(HasSubstr("a.ifc"), HasSubstr("memory")));
}

TEST_F(Ifc, aStopRequestEndsTheConversion) {
    std::stop_source source;
    Progress progress;
    progress.stop = source.get_token();
    progress.report = [&](double, std::string_view stage) {
        if (stage == "Converting") source.request_stop();
    };
    EXPECT_NE(refusalOf([&] { (void)readIfcFile(write("a.ifc", ifcSample()), {}, progress); }, ErrorKind::Interrupted), "");
}

/// A few bytes of another kind, or lines that others refer to.
std::string mutated(std::string text, std::mt19937& random) {
    for (size_t change = 1 + random() % 3; change > 0; --change) {
        const size_t at = random() % text.size();
        const size_t line = text.find('\n', at) + 1;
        if (random() % 2 == 0)
            text[at] = "0123456789#$*(),.;'-E\n\xff"[random() % 23];
        else
            text.erase(line, text.find('\n', line) - line);
    }
    return text;
}

TEST_F(Ifc, everySeededMutationLoadsOrIsRefused) {
    constexpr unsigned kSeconds = 240;
    EXPECT_TRUE(succeedsInChild(
        [&] {
            std::mt19937 random(20261128);
            for (uint64_t round = 0; round < howMany(3000, 200); ++round) {
                const std::string text = mutated(ifcSample(), random);
                try {
                    const ScenePointer scene = read(text).scene;
                    if (scene->triangleCount() > 0) continue;
                } catch (const Error& error) {
                    if (error.kind() == ErrorKind::Input && std::string(error.what()).find("a.ifc") != std::string::npos)
                        continue;
                }
                std::fprintf(stderr, "round %d\n", int(round));
                return false;
            }
            return true;
        },
        kSeconds));
}

TEST(IfcOfAHouse, hasTheTrianglesAndBoundsOfItsExport) {
    const std::optional<ScenePointer> read = sharedScene("AC14-FZK-Haus.ifc.xz");
    const std::optional<ScenePointer> other = sharedScene("fzk-haus-ifc-294obj-35906t.obj");
    if (!read || !other)
        GTEST_SKIP() << "The house is other people's and not part of this repository; the cases above write files.";
    EXPECT_EQ((*read)->instances().size(), 110u);
    EXPECT_EQ((*read)->meshes().size(), 59u);
    EXPECT_EQ((*other)->triangleCount(), 35'906u);
    EXPECT_LE((*read)->triangleCount(), (*other)->triangleCount());
    EXPECT_GT((*read)->triangleCount(), (*other)->triangleCount() - 10) << "degenerate ones are dropped";
    Box3 otherBox;
    Box3 box;
    for (size_t i = 0; i < (*read)->instances().size(); ++i) box.add((*read)->instanceBox(i));
    for (size_t i = 0; i < (*other)->instances().size(); ++i) otherBox.add((*other)->instanceBox(i));
    expectBox(box, otherBox.min, otherBox.max, 1e-4);
    for (const Instance& instance : (*read)->instances()) {
        EXPECT_THAT(instance.name, testing::StartsWith("Ifc"));
        EXPECT_THAT(instance.name, testing::Not(testing::EndsWith("_node")));
    }
}

}  // namespace
}  // namespace cullscope::test::ifc_scene_test
