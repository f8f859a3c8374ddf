// The steps of the painter's algorithm: in its order, with the polygons that it compares.

#include <gmock/gmock.h>

#include <set>

#include "core/frame/named_parts.h"
#include "core/visibility/subject_shape.h"
#include "tests/support/culler.h"
#include "tests/support/cut_scenes.h"

namespace cullscope::test::painters_steps_test {
namespace {

/// Bars of one object each, in a cycle.
struct PaintersSteps : testing::Test {
    const ScenePointer scene = [] {
        const MeshPointer bars = threeBars();
        std::vector<MeshPointer> meshes;
        for (uint32_t bar = 0; bar < 3; ++bar) {
            std::vector<Vec3f> corners;
            for (uint32_t i = 6 * bar; i < 6 * bar + 6; ++i) corners.push_back(Vec3f(bars->position(bars->indices()[i])));
            meshes.push_back(soupMesh(std::move(corners)));
        }
        return sceneOf(std::move(meshes));
    }();
    const CullerPointer painter = makeCuller("painter");
    const View view{{{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120}};
    FrameLog log;
    StructureSnapshot snapshot;

    void SetUp() override {
        painter->build(*scene);
        log = painter->cull(view, Recording::On).log;
        snapshot = painter->snapshot(log);
    }
    [[nodiscard]] const OwnTriangles& own() const { return *std::get<OwnTrianglesPointer>(log.commands.front()); }
};

constexpr int kTakenLine = 2, kDrawLine = 10;

TEST_F(PaintersSteps, eachPolygonIsDrawnWhereItPassesAgainstAllOthers) {
    std::set<uint32_t> drawn;  // own triangles
    uint32_t next = 0;
    size_t comparedAfterADraw = 0, afterADraw = 0;
    std::optional<uint32_t> inHand;
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Fragment) continue;
        if (decision.line == kTakenLine) inHand = decision.subject.number;
        if (decision.line != kDrawLine) {
            comparedAfterADraw += next > 0 && decision.line > kTakenLine ? 1 : 0;
            continue;
        }
        EXPECT_EQ(decision.places.first, next) << "drawn in the order of the algorithm";
        next = decision.places.first + decision.places.count;
        for (uint32_t i = decision.places.first; i < next; ++i) EXPECT_EQ(own().triangles[i], decision.subject.number);
        ++afterADraw;
        EXPECT_TRUE(inHand) << "taken before it is drawn";
    }
    EXPECT_EQ(next, own().triangles.size());
    EXPECT_GT(afterADraw, 6u);
    EXPECT_GT(comparedAfterADraw, 4u) << "comparisons go on after the first polygon is drawn";
}

TEST_F(PaintersSteps, byCentroidSaysNoDepthsAndNoTests) {
    ParameterSet byCentroid(findStrategy("painter").info.parameters);
    byCentroid.setFromText("sort", "centroid");
    const CullerPointer naive = makeCuller("painter", byCentroid);
    naive->build(*scene);
    const FrameLog frame = naive->cull(view, Recording::On).log;
    size_t drawn = 0;
    double farthest = 1e9;
    for (const Decision& decision : frame.decisions) {
        const bool object = decision.subject.kind == Subject::Kind::Object;
        EXPECT_TRUE(object || decision.line == 1 || decision.line == kDrawLine) << int(decision.line);
        const std::string sentence = decision.sentence == nullptr ? "" : decision.sentence;
        for (const char* untrue : {"farthest depth", "Nothing is left", "Test "})
            EXPECT_THAT(sentence, testing::Not(testing::HasSubstr(untrue)));
        if (decision.subject.kind != Subject::Kind::Fragment) continue;
        EXPECT_THAT(sentence, testing::HasSubstr("centroid"));
        ASSERT_EQ(decision.operandCount, 3);
        EXPECT_LE(decision.operands[2], farthest) << "far to near";
        farthest = decision.operands[2];
        ++drawn;
    }
    EXPECT_EQ(drawn, scene->triangleCount());
}

TEST_F(PaintersSteps, whatCoversNoSampleIsNotSaidToHavePassedATest) {
    const View away({{0, 0, 6}, {0, 0, 12}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120});
    for (const Decision& decision : painter->cull(away, Recording::On).log.decisions)
        if (decision.subject.kind == Subject::Kind::Fragment) {
            EXPECT_THAT(decision.sentence, testing::HasSubstr("covers no sample"));
        }
}

TEST_F(PaintersSteps, polygonsInHandAreLitAsTheyAreCompared) {
    size_t both = 0, cut = 0;
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        const Decision& decision = log.decisions[i];
        if (decision.subject.kind != Subject::Kind::Fragment) continue;
        const SubjectShape shape = subjectShape(*scene, log, snapshot, {nullptr, &decision, i});
        EXPECT_TRUE(shape.boxes.empty()) << "the polygon, not the box of its object";
        EXPECT_EQ(shape.object, decision.subject.object);
        if (decision.line == kDrawLine) {
            EXPECT_EQ(shape.triangles.size(), decision.places.count);
            continue;
        }
        ASSERT_EQ(shape.lines.size(), 1u);
        EXPECT_GE(shape.lines[0].size(), 4u);
        EXPECT_EQ(shape.lines[0].front(), shape.lines[0].back());
        const Box3 box = scene->instanceBox(decision.subject.object);
        Box3 lit;
        for (const Vec3& corner : shape.lines[0]) lit.add(corner);
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(lit.min, box.min - 1e-6)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(lit.max, box.max + 1e-6)));
        cut += glm::length(lit.max - lit.min) < 0.9 * glm::length(box.max - box.min) ? 1 : 0;
        EXPECT_EQ(shape.compared.size(), decision.line == kTakenLine ? 0u : 1u) << "Q";
        both += shape.compared.size();
    }
    EXPECT_GT(both, 3u);
    EXPECT_GT(cut, 0u) << "parts are lit as parts";
}

TEST_F(PaintersSteps, partsAreCalledAsInQuestions) {
    const NamedParts parts = painter->built()->parts(log);
    std::set<std::string> called;
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        const Decision& decision = log.decisions[i];
        if (decision.line != kDrawLine) continue;
        const EntryNames names = entryNames(snapshot, {nullptr, &decision, i});
        called.insert(names.subject);
        EXPECT_EQ(names.operands[1], std::to_string(decision.subject.number) + " (" + names.subject + ")");
    }
    std::set<std::string> expected;
    for (const NamedParts::Part& part : parts.parts) expected.insert(part.name);
    EXPECT_EQ(called, expected);
    EXPECT_GT(called.size(), 3u);
}

TEST_F(PaintersSteps, everyTestIsSaidAsItFallsWithBothNumbers) {
    constexpr uint8_t kFirstTest = 3, kLastTest = 7, kCut = 8, kSwap = 9;
    std::array<uint64_t, kDrawLine + 1> decided{};  // by line
    uint8_t failed = 0;                             // the line of the last test, where it failed
    size_t failures = 0;
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        const Decision& decision = log.decisions[i];
        if (decision.subject.kind != Subject::Kind::Fragment) continue;
        const bool test = decision.line >= kFirstTest && decision.line <= kLastTest;
        if (!test && decision.line != kCut && decision.line != kSwap) {
            EXPECT_EQ(failed, 0) << "a comparison goes on until something decides it";
            continue;
        }
        EXPECT_EQ(decision.operandCount, 4) << "P, Q, and what is compared";
        EXPECT_GE(decision.line, failed) << "in the order of the tests";
        const FrameEntry entry{nullptr, &decision, i};
        const std::string words = entryLine(*scene, entry, entryNames(snapshot, entry));
        EXPECT_EQ(words.find('%'), std::string::npos) << words;
        if (test && decision.containment != Containment::Inside) {
            failed = decision.line;
            ++failures;
        } else {
            ++decided[decision.line];
            failed = 0;
        }
    }
    const auto figure = [&](const char* name) {
        return uint64_t(std::ranges::find(log.counters.figures, name, &NamedFigure::name)->value);
    };
    EXPECT_EQ(decided[3], figure("test_depth"));
    EXPECT_EQ(decided[4], figure("test_1_x") + figure("test_2_y"));
    EXPECT_EQ(decided[5], figure("test_3_behind"));
    EXPECT_EQ(decided[6], figure("test_4_before"));
    EXPECT_EQ(decided[7], figure("test_5_projection"));
    EXPECT_EQ(decided[kCut], figure("cycles") + figure("pierced"));
    EXPECT_EQ(decided[kSwap], figure("swaps"));
    EXPECT_GT(failures, 3 * (decided[kCut] + decided[kSwap])) << "all before these failed";
    const Bars bars = painter->built()->bars(log).at(0);
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(bars.bars[i].value, decided[5 + i]) << "what failed is not counted";
}

}  // namespace
}  // namespace cullscope::test::painters_steps_test
