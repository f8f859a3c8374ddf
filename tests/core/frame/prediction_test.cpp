#include "core/frame/prediction.h"

#include <gmock/gmock.h>

#include "core/scene/scene_source.h"

namespace cullscope::prediction_test {
namespace {

using testing::ElementsAre;
using Question = Prediction::Question;

/// Four spheres; the third and the first one are drawn, in this order, and the first one again.
struct PredictionTest : testing::Test {
    ScenePointer scene = openScene("field:mesh=sphere:triangles=80,n=2").scene;
    FrameLog log;
    void SetUp() override {
        ASSERT_EQ(scene->instances().size(), 4u);
        log.commands = {DrawList{Facing::TwoSided, {{2, 0, 30}}}, DrawList{Facing::TwoSided, {{0, 30, 6}, {3, 0, 0}}},
                        DrawList{Facing::TwoSided, {{0, 0, 30}}}};
    }
};

TEST_F(PredictionTest, vanishIsWhatTheFrameDrawsNothingOf) {
    Prediction prediction;
    for (const uint64_t item : {1, 2}) prediction.toggle(item);
    const std::vector<PredictionRow> rows = answerTo(prediction, *scene, log);
    EXPECT_THAT(rows,
                ElementsAre(PredictionRow{0, 0, 0}, PredictionRow{1, 1, 1}, PredictionRow{2, 1, 0}, PredictionRow{3, 0, 1}));
    EXPECT_EQ(rightRows(rows), 2u);
}

TEST_F(PredictionTest, orderIsThatOfTheFirstDrawnTriangles) {
    Prediction prediction{Question::Order};
    for (const uint64_t item : {2, 1, 0}) prediction.toggle(item);
    EXPECT_THAT(answerTo(prediction, *scene, log),
                ElementsAre(PredictionRow{0, 3, 2}, PredictionRow{1, 2, std::nullopt}, PredictionRow{2, 1, 1},
                            PredictionRow{3, std::nullopt, std::nullopt}));
    prediction.toggle(1);
    EXPECT_EQ(rightRows(answerTo(prediction, *scene, log)), 4u) << "a second click takes an item back";
}

TEST_F(PredictionTest, trianglesAreAskedAboutOnlyWhereTheyWereNamed) {
    Prediction prediction{Question::Vanish, Prediction::Items::Triangles};
    const uint64_t first = scene->firstTriangle(0);
    prediction.toggle(first + 11);
    prediction.toggle(first + 12);
    const std::vector<PredictionRow> rows = answerTo(prediction, *scene, log);
    EXPECT_THAT(rows, ElementsAre(PredictionRow{first + 11, 1, 0}, PredictionRow{first + 12, 1, 1}));
}

TEST_F(PredictionTest, trianglesWhoseBackTheEyeSeesVanishFromFrontSidesAlone) {
    const auto all = [&](Facing facing) {
        log.camera.eye = scene->instanceBox(0).centre() + Vec3(0, 0, 50);
        log.commands = {DrawList{facing, {{0, 0, uint32_t(3 * scene->meshOf(0).triangleCount())}}}};
        Prediction prediction{Question::Vanish, Prediction::Items::Triangles};
        std::vector<uint64_t> items;
        for (uint64_t i = 0; i < scene->meshOf(0).triangleCount(); ++i) items.push_back(scene->firstTriangle(0) + i);
        prediction.toggle(items);
        return rightRows(answerTo(prediction, *scene, log));
    };
    EXPECT_EQ(all(Facing::TwoSided), 0u);
    EXPECT_GT(all(Facing::Front), 30u);
    EXPECT_LT(all(Facing::Front), 50u) << "about half of 80";
}

TEST_F(PredictionTest, severalItemsAreNamedOrTakenBackTogether) {
    Prediction prediction{Question::Order};
    prediction.toggle(uint64_t{2});
    prediction.toggle(std::vector<uint64_t>{0, 2, 3});
    EXPECT_THAT(prediction.items, ElementsAre(2, 0, 3)) << "what was named keeps its place";
    prediction.toggle(std::vector<uint64_t>{0, 2});
    EXPECT_THAT(prediction.items, ElementsAre(3));
    Prediction placed{Question::Place, Prediction::Items::Parts};
    placed.toggle(uint64_t{1});
    placed.place(4);
    placed.toggle(std::vector<uint64_t>{5, 6});
    placed.toggle(std::vector<uint64_t>{5});
    EXPECT_THAT(placed.items, ElementsAre(1, 6));
    EXPECT_THAT(placed.places, ElementsAre(std::optional<size_t>(4), std::nullopt));
}

TEST_F(PredictionTest, ofAFinishedPictureSomeVanishAndNoneHasAnOrder) {
    auto picture = std::make_shared<FinishedPicture>();
    picture->triangle = {0, uint32_t(scene->firstTriangle(1)) + 1};
    log.commands = {FinishedPicturePointer(picture)};
    EXPECT_EQ(answerTo({Question::Vanish}, *scene, log)[1].actual, 0u);
    EXPECT_EQ(answerTo({Question::Vanish}, *scene, log)[0].actual, 1u);
    EXPECT_EQ(answerTo({Question::Order}, *scene, log)[1].actual, std::nullopt);
}

}  // namespace
}  // namespace cullscope::prediction_test
