// Polygons of one's own: where they lie, how they and the nodes are called, and what is said of a triangle at a step.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/frame/decided_ahead.h"
#include "core/frame/entry_words.h"
#include "core/frame/prediction.h"
#include "core/scene/scene_source.h"
#include "core/visibility/subject_shape.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"

namespace cullscope::test::own_polygons_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

CullerPointer byGivenPlanes() {
    ParameterSet parameters(findStrategy("bsp").info.parameters);
    parameters.setFromText("plane", "given");
    return makeCuller("bsp", parameters);
}

/// A table in the plane E1, a wall beyond it that both planes cut, and a floor below it.
struct OwnPolygons : testing::Test {
    std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "own_polygons_test.polygons";
    ScenePointer scene;
    CullerPointer tree = byGivenPlanes();
    FrameLog log;

    void SetUp() override {
        std::ofstream(file) << "polygon Tisch 0 0 0  2 0 0  2 0 2  0 0 2\n"
                               "polygon Wand -1 -1 -1  3 -1 -1  3 3 -1  -1 3 -1\n"
                               "polygon Boden 0 -1 0  1 -1 0  1 -1 1  0 -1 1\n"
                               "plane E1 0 1 0 0\nplane E2 1 0 0 -1\neye 5 5 5\n";
        scene = openScene(file.string()).scene;
        tree->build(*scene);
        log = tree->cull(View(*scene->remarks().camera, {160, 120}), Recording::On).log;
    }
    void TearDown() override { std::filesystem::remove(file); }

    [[nodiscard]] std::vector<std::string> lines(const FrameLog& of) const {
        const StructureSnapshot snapshot = tree->snapshot(log);
        const FrameEntries entries(of);
        std::vector<std::string> result;
        for (size_t i = 0; i < entries.size(); ++i)
            result.push_back(entryLine(*scene, entries.at(i), entryNames(snapshot, entries.at(i))));
        return result;
    }
    [[nodiscard]] std::vector<std::string> whyAt(size_t entries, uint64_t triangle) const {
        std::vector<std::string> result;
        for (const WhyStep& step : why(*tree->built(), replayUpTo(log, entries), triangle))
            result.push_back(step.sentence.english());
        return result;
    }
};

TEST_F(OwnPolygons, aPlaneInWhichAPolygonLiesIsAPlaceBehindTheLeaves) {
    const NamedParts parts = tree->built()->partsByLeaf(log);
    EXPECT_THAT(parts.places, ElementsAre("C1", "C2", "C3", "C4", "E1"));
    EXPECT_EQ(parts.leaves, 4u);
    const auto table = std::ranges::find(parts.parts, "Tisch", &NamedParts::Part::name);
    ASSERT_NE(table, parts.parts.end());
    EXPECT_EQ(table->place, std::optional<size_t>(4));
    for (const NamedParts::Part& part : parts.parts) EXPECT_TRUE(part.place) << part.name;
}

TEST_F(OwnPolygons, whatWasNotPlacedIsNeverRight) {
    const NamedParts parts = tree->built()->partsByLeaf(log);
    Prediction open{Prediction::Question::Place, Prediction::Items::Parts};
    for (uint64_t part = 0; part < parts.parts.size(); ++part) open.toggle(part);
    EXPECT_EQ(rightRows(answerTo(open, *scene, log, parts)), 0u);
    Prediction placed{Prediction::Question::Place, Prediction::Items::Parts};
    for (uint64_t part = 0; part < parts.parts.size(); ++part) {
        placed.toggle(part);
        placed.place(*parts.parts[part].place);
    }
    EXPECT_EQ(rightRows(answerTo(placed, *scene, log, parts)), parts.parts.size());
}

TEST_F(OwnPolygons, nodesBelowALeafAreCalledByIt) {
    const StructureSnapshot snapshot = tree->snapshot(log);
    for (const SnapshotNode& node : snapshot.nodes) {
        const bool plane = node.name == "E1" || node.name == "E2";
        EXPECT_TRUE(plane || node.name.starts_with("C")) << node.name;
        if (node.parent < 0 || plane) continue;
        const std::string& above = snapshot.nodes[size_t(node.parent)].name;
        if (above.starts_with("C")) {
            EXPECT_EQ(node.name, above.substr(0, above.find('.')) + "." + std::to_string(node.number));
        }
    }
}

TEST_F(OwnPolygons, partsAreSpokenOfOnlyWhereSomethingWasCut) {
    const std::vector<std::string> said = lines(log);
    EXPECT_THAT(said, Contains(HasSubstr("Triangle 0 of Tisch: Triangle 0 (Tisch) is drawn, with node E1.")));
    EXPECT_THAT(said, Contains(HasSubstr("Part Wand1: A part with ")));
    for (const std::string& line : said)
        if (line.find("Tisch") != std::string::npos || line.find("Boden") != std::string::npos) {
            EXPECT_THAT(line, Not(HasSubstr("art"))) << "nothing of it was cut";
        }
}

TEST_F(OwnPolygons, whyAtAStepSpeaksOfTheStep) {
    const uint64_t triangle = 0;  // of the table
    size_t drawn = 0;
    while (log.decisions[drawn].subject != Subject{Subject::Kind::Fragment, 0, 0}) ++drawn;
    const std::vector<std::string> before = whyAt(drawn, triangle), after = whyAt(drawn + 1, triangle);
    EXPECT_EQ(before.back(), "Up to this step nothing of it is decided, and nothing of it is drawn.");
    EXPECT_EQ(after.back(), "Up to this step it is drawn, as a whole or in part; pieces: 1.");
    for (const std::vector<std::string>& said : {before, after})
        for (const std::string& sentence : said) EXPECT_THAT(sentence, Not(HasSubstr("given to OpenGL")));
    EXPECT_EQ(whyAt(log.entries(), triangle).back(), "OpenGL draws the triangle: both sides count.") << "of the whole frame";
}

TEST(EntryWords, countsAreWholeNumbers) {
    Decision decision;
    decision.sentence = "%1 %2 %3";
    decision.operands = {1'003'520, 0.25, 1e20};
    decision.operandCount = 3;
    EXPECT_EQ(entryWords({nullptr, &decision, 0}).english(), "1003520 0.25 1e+20");
    const Command one = DrawList{Facing::TwoSided, {{0, 0, 30}}};
    EXPECT_EQ(entryWords({&one, nullptr, 0}).english(), "Triangles of the scene are drawn: 10 (ranges: 1)");
}

}  // namespace
}  // namespace cullscope::test::own_polygons_test
