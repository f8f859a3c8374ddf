// The errors in the field's terms: rates of triangles, objects and pixels, popping, differences of pictures and of outlines.
#include "core/measure/field_figures.h"

#include "core/measure/meter.h"
#include "core/measure/summary.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::field_figures_test {
namespace {

/// A judged frame of 100 pixels, all else 0.
FrameMeasurement frameOf() {
    FrameMeasurement frame;
    frame.accuracy = Accuracy{};
    frame.accuracy->pixels = 100;
    return frame;
}

double valueOf(const FieldEstimates& estimates, std::string_view key) {
    const std::optional<RatioEstimate>& estimate = estimates.at(fieldFigurePlace(key));
    return estimate ? estimate->ratio : -1.0;
}

TEST(FieldFigures, ratesAreSumsOverTheViews) {
    std::vector<FrameMeasurement> frames{frameOf(), frameOf()};
    Accuracy &one = *frames[0].accuracy, &two = *frames[1].accuracy;
    one.sceneTriangles = two.sceneTriangles = 50;
    one.sceneObjects = two.sceneObjects = 10;
    one.visibleTriangles = 10, two.visibleTriangles = 30;
    one.falselyCulledTriangles = 1, two.falselyCulledTriangles = 5;
    one.needlesslyDrawnTriangles = 20, two.needlesslyDrawnTriangles = 10;
    one.visibleObjects = 4, two.visibleObjects = 6;
    one.falselyCulledObjects = 1, two.falselyCulledObjects = 0;
    one.needlesslyDrawnObjects = 3, two.needlesslyDrawnObjects = 2;
    frames[0].lostPixels = 4, frames[0].wronglyNearerPixels = 2, frames[1].lostPixels = 1;
    one.outlinePixels = 10, two.outlinePixels = 30;
    one.differentlyCovered = 4, two.differentlyCovered = 0;
    const FieldEstimates estimates = fieldEstimates(frames);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "triangle_false_negative_rate"), 6.0 / 40.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "triangle_false_positive_rate"), 30.0 / 60.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "object_false_negative_rate"), 1.0 / 10.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "object_false_positive_rate"), 5.0 / 10.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "pixel_error_rate"), 7.0 / 200.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "pixel_error_rate_max"), 6.0 / 100.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "silhouette_error_px"), 4.0 / 40.0);
    // The interval of two views holds both views' own rates and nothing beyond them.
    const RatioEstimate& misses = *estimates[fieldFigurePlace("triangle_false_negative_rate")];
    EXPECT_TRUE(misses.hasInterval);
    EXPECT_DOUBLE_EQ(misses.ci95[0], 1.0 / 10.0);
    EXPECT_DOUBLE_EQ(misses.ci95[1], 5.0 / 30.0);
}

TEST(FieldFigures, zeroHasNoIntervalAndNothingToCountNoValue) {
    const std::vector<FrameMeasurement> frames{frameOf(), frameOf(), frameOf()};
    const FieldEstimates estimates = fieldEstimates(frames);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "pixel_error_rate"), 0.0);
    EXPECT_FALSE(estimates[fieldFigurePlace("pixel_error_rate")]->hasInterval);
    EXPECT_FALSE(estimates[fieldFigurePlace("triangle_false_negative_rate")]) << "no triangle is visible";
    EXPECT_FALSE(estimates[fieldFigurePlace("popping_pixels")]) << "there is no event";
    EXPECT_EQ(framesWithLoss(frames), 0u);
    EXPECT_TRUE(fieldEstimates(std::vector<FrameMeasurement>(2)).empty()) << "frames that were not judged";
}

TEST(FieldFigures, noLossBoundsARateWhereThereAreMoreThanThreeViews) {
    EXPECT_EQ(noLossIn(16).english(), "0 (< 3/16)");
    EXPECT_EQ(noLossIn(4).english(), "0 (< 3/4)");
    EXPECT_EQ(noLossIn(3).english(), "0 of 3");
}

TEST(FieldFigures, anEventLastsAsLongAsAnObjectLosesPixels) {
    std::vector<FrameMeasurement> frames(6, frameOf());
    frames[1].lostObjects = {{7, 3}};
    frames[2].lostObjects = {{7, 9}, {4, 1}};
    frames[3].lostObjects = {{7, 2}};
    frames[5].lostObjects = {{7, 5}};
    frames[1].toggledPixels = 3, frames[2].toggledPixels = 7, frames[4].toggledPixels = 2;
    const std::vector<PoppingEvent> events = poppingEvents(frames);
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[0].instance, 7u);
    EXPECT_EQ(events[0].first, 1u);
    EXPECT_EQ(events[0].frames, 3u);
    EXPECT_EQ(events[0].pixels, 9u);
    EXPECT_EQ(events[1].instance, 4u);
    EXPECT_EQ(events[1].frames, 1u);
    EXPECT_EQ(events[2].first, 5u) << "an object that was whole again, and is lost once more";
    const FieldEstimates estimates = fieldEstimates(frames);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "popping_events_per_1000_frames"), 3.0 / 6.0 * 1000.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "popping_pixels"), (9.0 + 1.0 + 5.0) / 3.0);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "popping_frames"), (3.0 + 1.0 + 1.0) / 3.0);
    EXPECT_TRUE(estimates[fieldFigurePlace("popping_pixels")]->hasInterval);
    // Of a single event there is nothing to resample.
    const FieldEstimates ofOne = fieldEstimates(std::span(frames).subspan(4));
    EXPECT_DOUBLE_EQ(valueOf(ofOne, "popping_pixels"), 5.0);
    EXPECT_FALSE(ofOne[fieldFigurePlace("popping_pixels")]->hasInterval);
    EXPECT_DOUBLE_EQ(valueOf(estimates, "popping_pixel_rate"), 12.0 / 600.0);
}

TEST(FieldFigures, differenceOfPicturesIsTheMeanOfTheChannels) {
    // Four pixels: equal but for opacity, 30 in one channel, 255 in all, equal.
    const std::vector<uint8_t> one{10, 20, 30, 0, 50, 50, 50, 255, 0, 0, 0, 255, 9, 9, 9, 9};
    const std::vector<uint8_t> other{10, 20, 30, 255, 50, 80, 50, 255, 255, 255, 255, 255, 9, 9, 9, 9};
    const std::vector<uint32_t> differences = pictureDifferences(one, other);
    EXPECT_EQ(differences[0], 2u);
    EXPECT_EQ(differences[30], 1u);
    EXPECT_EQ(differences[765], 1u);
    EXPECT_DOUBLE_EQ(meanDifference(differences), (30.0 + 765.0) / 765.0 / 4.0);
    EXPECT_DOUBLE_EQ(differenceQuantile(differences, 0.5), 0.0);
    EXPECT_DOUBLE_EQ(differenceQuantile(differences, 0.75), 30.0 / 765.0);
    EXPECT_DOUBLE_EQ(differenceQuantile(differences, 0.99), 1.0);
    EXPECT_EQ(meanDifference({}), 0.0);
}

TEST(FieldFigures, objectsAndOutlinesAreCountedAgainstTheTruth) {
    // Three squares of two triangles; the picture is 4 × 3 pixels. Triangles 0 and 2 show, so objects 0 and 1.
    const ScenePointer scene = sceneOf({squareMesh(1, 0), squareMesh(1, 1), squareMesh(1, 2)});
    Reference reference;
    reference.size = {4, 3};
    reference.triangle = {1, 1, 3, 0,  //
                          1, 1, 3, 0,  //
                          1, 1, 3, 0};
    for (const uint32_t item : reference.triangle) reference.depth.push_back(item != 0 ? 0.5f : 0.0f);
    reference.visibleTriangles = {0, 2};
    reference.coveredPixels = 9;
    // Objects 0 and 2 are drawn: the right column of the truth is missing.
    std::vector<float> depth = reference.depth;
    for (const size_t pixel : {2, 6, 10}) depth[pixel] = 0.0f;
    const Accuracy errors = compare(reference, {depth, {}}, {Facing::TwoSided, {{0, 0, 6}, {2, 0, 6}}}, *scene);
    EXPECT_EQ(errors.pixels, 12u);
    EXPECT_EQ(errors.sceneTriangles, 6u);
    EXPECT_EQ(errors.sceneObjects, 3u);
    EXPECT_EQ(errors.visibleObjects, 2u);
    EXPECT_EQ(errors.submittedObjects, 2u);
    EXPECT_EQ(errors.falselyCulledObjects, 1u);
    EXPECT_EQ(errors.needlesslyDrawnObjects, 1u);
    EXPECT_EQ(errors.outlinePixels, 3u) << "the third column: the picture's own edge is no outline";
    EXPECT_EQ(errors.differentlyCovered, 3u);
}

TEST(FieldFigures, aStrategyThatLosesHasThemAllAndOneThatDoesNotHasZeros) {
    MeasureRequest experiment = smallExperiment({"all", "draw-distance"});
    // From three times the scene's radius only the nearer objects are drawn.
    experiment.path = cameraPath("orbit:3", *experiment.scene);
    experiment.strategies[1].parameters.setFromText("distance", "2.9");
    experiment.timing.fixedRepetitions = 1;
    const MeasureResult result = measure(experiment);
    const Summary &none = result.runs[0].summary, &some = result.runs[1].summary;
    ASSERT_EQ(none.field.size(), fieldFigures().size());
    EXPECT_EQ(valueOf(none.field, "triangle_false_negative_rate"), 0.0);
    EXPECT_EQ(valueOf(none.field, "triangle_false_positive_rate"), 1.0) << "everything that is hidden is drawn";
    EXPECT_EQ(valueOf(none.field, "image_difference_mean"), 0.0);
    EXPECT_DOUBLE_EQ(none.lossBelow.value(), 3.0 / 3.0);
    EXPECT_FALSE(some.lossBelow);
    for (const char* const key :
         {"triangle_false_negative_rate", "object_false_negative_rate", "pixel_error_rate", "popping_events_per_1000_frames",
          "popping_pixels", "popping_frames", "image_difference_mean", "silhouette_error_px", "pixel_error_rate_max"})
        EXPECT_GT(valueOf(some.field, key), 0.0) << key;
    EXPECT_LT(valueOf(some.field, "triangle_false_positive_rate"), 1.0);
    // By definition: every pixel that is lost is an error, and nothing else is here.
    double lost = 0.0;
    for (const FrameMeasurement& frame : result.runs[1].frames) lost += double(frame.accuracy->missedPixels);
    EXPECT_DOUBLE_EQ(valueOf(some.field, "pixel_error_rate"), lost / (3.0 * 64.0 * 48.0));
    MeasureRequest timeOnly = experiment;
    timeOnly.accuracy = false;
    EXPECT_TRUE(measure(timeOnly).runs[1].summary.field.empty());
}

}  // namespace
}  // namespace cullscope::test::field_figures_test
