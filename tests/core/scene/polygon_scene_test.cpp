// Files of named polygons, planes and a camera.
#include "core/scene/polygon_scene.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/base/error.h"
#include "core/scene/scene_source.h"

namespace cullscope::test::polygon_scene_test {
namespace {

TEST(PolygonScene, polygonsBecomeObjectsOfTheirNames) {
    const FileScene read = readPolygonText(
        "# two polygons\n"
        "polygon floor  0 0 0  4 0 0  4 4 0  2 5 0  0 4 0   # five corners\n"
        "\n"
        "polygon A\t1 1 1  2 1 1  1 2 1\n"
        "plane P1 1 0 0 -2\n"
        "plane P2  0 3 0  0 2 0\n"
        "eye 0 0 9\n",
        "a room");
    const Scene& scene = *read.scene;
    ASSERT_EQ(scene.instances().size(), 2u);
    EXPECT_EQ(scene.instances()[0].name, "floor");
    EXPECT_EQ(scene.instances()[1].name, "A");
    EXPECT_EQ(scene.meshOf(0).triangleCount(), 3u);
    EXPECT_EQ(scene.meshOf(1).triangleCount(), 1u);
    ASSERT_EQ(scene.planes().size(), 2u);
    EXPECT_EQ(scene.planes()[0].name, "P1");
    EXPECT_EQ(scene.planes()[0].normal, Vec3(1, 0, 0));
    EXPECT_EQ(scene.planes()[0].offset, -2.0);
    EXPECT_EQ(scene.planes()[1].normal, Vec3(0, 2, 0));
    EXPECT_EQ(scene.planes()[1].offset, -6.0);
    ASSERT_TRUE(scene.remarks().camera);
    EXPECT_EQ(scene.remarks().camera->eye, Vec3(0, 0, 9));
    EXPECT_EQ(scene.remarks().camera->target, scene.boundingSphere().centre);
    EXPECT_EQ(read.report.facesRead, 2u);
}

std::string refusal(const std::string& text) {
    try {
        (void)readPolygonText(text, "x.polygons");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        return error.what();
    }
    return "nothing was refused";
}

TEST(PolygonScene, badLinesAreNamedWithWhatIsWrong) {
    const std::string good = "polygon A 0 0 0 1 0 0 0 1 0\n";
    using testing::HasSubstr;
    EXPECT_THAT(refusal(good + "poligon B 0 0 0"), HasSubstr("x.polygons, line 2: \"poligon\" is none of"));
    EXPECT_THAT(refusal(good + "polygon A 0 0 0 1 0 0 0 1 0"), HasSubstr("line 2: the name \"A\" is used twice"));
    EXPECT_THAT(refusal("polygon 0 0 0 1 0 0 0 1 0"), HasSubstr("line 1: a name is missing"));
    EXPECT_THAT(refusal(good + "\npolygon B 0 0 0 1 0 0"), HasSubstr("line 3: a polygon has three coordinates"));
    EXPECT_THAT(refusal("polygon B 0 0 0 1 0 x 0 1 0"), HasSubstr("\"x\" is not a usable number. Write one from -1e30 to 1e30"));
    EXPECT_THAT(refusal("polygon B 0 0 0 1 0 nan 0 1 0"), HasSubstr("\"nan\" is not a usable number"));
    EXPECT_THAT(refusal("polygon B 0 0 0 1 0 0 2 0 0"), HasSubstr("has no area. Give it corners"));
    EXPECT_THAT(refusal("polygon B 0 0 0 1 0 0 1 1 1 0 1 0"), HasSubstr("do not lie in one plane"));
    EXPECT_THAT(refusal(good + "plane P 0 0 0 1"), HasSubstr("the plane's normal is 0. At least one"));
    EXPECT_THAT(refusal(good + "plane P 1 0 0"), HasSubstr("a plane is written as a b c d"));
    EXPECT_THAT(refusal(good + "eye 1 2"), HasSubstr("an eye has three numbers"));
    EXPECT_THAT(refusal(good + "eye 1 2 3\ncamera 0 0 0 1 1 1"), HasSubstr("line 3: the file has a camera already"));
    EXPECT_THAT(refusal(good + "camera 1 1 1 1 1 1"), HasSubstr("line 2: the camera looks at its own place"));
    for (const char* empty : {"plane P 1 0 0 0", "plane P 1 0 0 0\neye 1 2 3", "# nothing", ""})
        EXPECT_THAT(refusal(empty), HasSubstr("x.polygons names no polygon. Write at least one line such as")) << empty;
}

TEST(PolygonScene, fileIsOpenedLikeAnyScene) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "own.polygons";
    // As some editors save it: with a byte-order mark and lines of Windows.
    std::ofstream(file) << "\xEF\xBB\xBF"
                        << "polygon A 0 0 0 1 0 0 0 1 0\r\nplane P1 1 0 0 -0.5\r\n";
    const OpenedScene opened = openScene(file.string());
    EXPECT_EQ(opened.scene->triangleCount(), 1u);
    EXPECT_EQ(opened.scene->planes().size(), 1u);
    EXPECT_EQ(opened.scene->name(), "own.polygons");
    EXPECT_TRUE(opened.report);
    for (const char* lecture : {"quiz", "example"}) {
        EXPECT_GE(openScene(lecture).scene->instances().size(), 3u);
        EXPECT_THROW((void)openScene(std::string(lecture) + ":n=3"), Error);
    }
}

}  // namespace
}  // namespace cullscope::test::polygon_scene_test
