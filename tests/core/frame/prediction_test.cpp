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
