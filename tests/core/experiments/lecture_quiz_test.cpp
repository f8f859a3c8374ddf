#include "core/experiments/lecture_quiz.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/experiments/experiment_list.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/scene_source.h"

namespace cullscope::test::lecture_quiz_test {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

TEST(LectureQuiz, leavesAndOrderAreThoseOfTheKey) {
    const ScenePointer scene = openScene("quiz").scene;
    const LectureCells cells = lectureCells(*scene, scene->remarks().camera->eye);
    EXPECT_THAT(cells.leaves, ElementsAre("B", "A2", "NULL", "A1", "NULL", "C2", "NULL", "C1"));
    EXPECT_THAT(cells.order, ElementsAre("B", "A2", "A1", "C2", "C1"));
}

TEST(LectureQuiz, exampleIsDrawnAsInTheLecture) {
    const ScenePointer scene = openScene("example").scene;
    EXPECT_THAT(lectureCells(*scene, scene->remarks().camera->eye).order, ElementsAre("B", "D", "A", "C"));
}

TEST(LectureQuiz, orderFollowsTheEyeThroughAllEightCells) {
    const ScenePointer scene = openScene("quiz").scene;
    const std::vector<std::string> leaves = lectureCells(*scene, Vec3(0.0)).leaves;
    int cells = 0;
    // Before or behind P1 (x), P2 (z) and P3 (x + 2y + z + 2): the height puts the eye on the wanted side of P3.
    for (int sides = 0; sides < 8; ++sides) {
        const bool p1 = (sides & 4) != 0, p2 = (sides & 2) != 0, p3 = (sides & 1) != 0;
        const Vec3 eye(p1 ? 5 : -5, p3 ? 20 : -20, p2 ? 5 : -5);
        // The leaves far from the eye come first: at each plane the side without the eye.
        std::vector<std::string> expected;
        for (int step = 0; step < 8; ++step) {
            const int leaf = step ^ (p1 ? 0 : 4) ^ (p2 ? 0 : 2) ^ (p3 ? 0 : 1);
            if (leaves[size_t(leaf)] != "NULL") expected.push_back(leaves[size_t(leaf)]);
        }
        EXPECT_EQ(lectureCells(*scene, eye).order, expected) << "sides " << sides;
        ++cells;
    }
    EXPECT_EQ(cells, 8);
}

TEST(LectureQuiz, experimentsAgreeWithTheKey) {
    for (const char* id : {"quiz", "example"}) {
        const ResultTable table = runExperiment(findExperiment(id), {});
        EXPECT_FALSE(table.checkFailed()) << tableText(table);
        ASSERT_EQ(table.checks.size(), 1u);
        EXPECT_EQ(table.checks.front().value, 0.0);
    }
    EXPECT_EQ(runExperiment(findExperiment("quiz"), {}).rows.size(), 9u);
}

TEST(LectureQuiz, sceneOfTheLecturersOwnIsComputedWithoutTheKey) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "lecturer.polygons";
    std::ofstream(file) << "polygon wall -1 0 0  1 0 0  1 1 0  -1 1 0\npolygon lamp -1 0 -2  -0.5 0 -2  -0.5 1 -2\n"
                           "plane left 1 0 0 0\nplane behind 0 0 1 1\neye 3 0.5 5\n";
    const ResultTable table = runExperiment(findExperiment("quiz").ofScene(file.string()), {});
    const auto computed = [&](size_t row) { return std::get<std::string>(table.rows[row][1]); };
    ASSERT_EQ(table.rows.size(), 5u);
    EXPECT_EQ(computed(0), "lamp");
    EXPECT_EQ(computed(1), "wall2");
    EXPECT_EQ(computed(2), "NULL");
    EXPECT_EQ(computed(3), "wall1");
    EXPECT_EQ(computed(4), "lamp, wall2, wall1");
    EXPECT_TRUE(table.checks.empty());
    for (const ResultColumn& column : table.columns) EXPECT_TRUE(column.key != "key" && column.key != "differs");
    try {
        (void)runExperiment(findExperiment("quiz").ofScene("torus:triangles=200"), {});
        FAIL() << "without planes";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("takes the planes that a scene has"), std::string::npos) << error.what();
    }
    std::ofstream(file) << "polygon wall -1 0 0  1 0 0  1 1 0\nplane left 1 0 0 0\n";
    try {
        (void)runExperiment(findExperiment("example").ofScene(file.string()), {});
        FAIL() << "without an eye";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("names no camera"), std::string::npos) << error.what();
    }
}

TEST(LectureQuiz, partsAreNamedUniquely) {
    const auto order = [](const char* text) {
        const ScenePointer scene = readPolygonText(text, "own").scene;
        return lectureCells(*scene, scene->remarks().camera->eye).order;
    };
    EXPECT_THAT(order("polygon A -1 0 0  1 0 0  1 1 0  -1 1 0\npolygon A1 -1 0 1  -0.5 0 1  -0.5 1 1\n"
                      "plane P1 1 0 0 0\neye 3 2 6"),
                UnorderedElementsAre("A.1", "A.2", "A1"));
    EXPECT_THAT(order("polygon A -1 0 0  1 0 0  1 1 0  -1 1 0\npolygon A.1 -1 0 1  -0.5 0 1  -0.5 1 1\n"
                      "polygon A11 -1 0 2  -0.5 0 2  -0.5 1 2\nplane P1 1 0 0 0\neye 3 2 6"),
                UnorderedElementsAre("A..1", "A..2", "A.1", "A11"));
}

TEST(LectureQuiz, whatLiesInAPlaneIsARow) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "wall.polygons";
    std::ofstream(file) << "polygon Wall -2 0 0.3  -0.7 0 0.3  -0.7 1 0.3  -2 1 0.3\n"
                           "polygon Door -0.7 0 0.3  0.7 0 0.3  0.7 1 0.3  -0.7 1 0.3\n"
                           "polygon Side 0.7 0 -2  0.7 0 2  0.7 1 2  0.7 1 -2\n"
                           "plane P1 1 0 0 -0.7\nplane P2 0 0 1 -0.3\ncamera 4 3 7  0 0 0\n";
    const ResultTable table = runExperiment(findExperiment("quiz").ofScene(file.string()), {});
    std::vector<std::string> rows;
    for (const auto& row : table.rows) rows.push_back(std::get<std::string>(row[0]) + ": " + std::get<std::string>(row[1]));
    EXPECT_THAT(rows, ElementsAre("C1: NULL", "C2: NULL", "C3: NULL", "C4: NULL", "in P1: Side", "in P2: Wall+Door",
                                  "order: Door, Wall, Side"));
}

}  // namespace
}  // namespace cullscope::test::lecture_quiz_test
