#include "core/experiments/occlusion_growth.h"

#include <gmock/gmock.h>

#include <set>

#include "core/base/error.h"
#include "core/experiments/self_test.h"
#include "core/scene/scene_source.h"
#include "tests/support/experiment_faults.h"
#include "tests/support/gl_environment.h"

namespace cullscope::test::occlusion_growth_test {
namespace {

OcclusionGrowthSize quick() {
    OcclusionGrowthSize size;
    size.court = "plant:pipelines=2";
    size.courts = {1, 3};
    size.bunnies = {1, 2};
    size.views = 2;
    size.size = {96, 72};
    size.repetitions = 1;
    return size;
}

double number(const ResultTable& table, size_t row, const char* column) {
    const std::optional<double> value = numberOf(table.value(row, column));
    EXPECT_TRUE(value.has_value()) << column << " in row " << row;
    return value.value_or(-1.0);
}

TEST(OcclusionGrowth, declaresWhatItShows) {
    for (const OcclusionGrowthSize& size : {quick(), OcclusionGrowthSize(), sizeForGraphicsCard()})
        for (const Experiment& experiment : occlusionGrowth(size))
            EXPECT_THAT(experimentFaults(experiment), testing::IsEmpty()) << experiment.id;
    EXPECT_EQ(occlusionGrowth(quick())[0].ofScene("teapot").settings[1].scene, "courts:mesh=teapot,n=3");
}

TEST(OcclusionGrowth, viewsAreTheSameHoweverManyCourtsThereAre) {
    const Experiment experiment = occlusionGrowth(quick())[0];
    std::vector<CameraPath> paths;
    for (const Setting& setting : experiment.settings) {
        const ScenePointer scene = openScene(setting.scene).scene;
        paths.push_back(pathOf(setting, *scene));
        EXPECT_GE(paths.back().farDistance, scene->bounds().diagonal()) << "all of it is before the far plane";
    }
    ASSERT_EQ(paths.size(), 2u);
    ASSERT_EQ(paths[0].poses.size(), 2u);
    for (size_t pose = 0; pose < paths[0].poses.size(); ++pose) {
        EXPECT_EQ(paths[0].poses[pose].eye, paths[1].poses[pose].eye);
        EXPECT_EQ(paths[0].poses[pose].target, paths[1].poses[pose].target);
    }
}

TEST(OcclusionGrowth, otherCourtsAreDrawnByTheFrustumAloneAndNoPixelIsLost) {
    const ResultTable table = runExperiment(occlusionGrowth(quick())[0], {});
    ASSERT_EQ(table.rows.size(), 12u);
    // Triangles drawn in a view of the larger scene less those of the smaller one.
    const auto added = [&](size_t row) { return number(table, row + 6, "submitted") - number(table, row, "submitted"); };
    std::set<std::string> strategies;
    for (size_t row = 0; row < 6; ++row) {
        const std::string strategy = std::get<std::string>(table.value(row, "strategy"));
        SCOPED_TRACE(strategy);
        strategies.insert(strategy);
        EXPECT_EQ(std::get<std::string>(table.value(row + 6, "strategy")), strategy);
        EXPECT_EQ(number(table, row + 6, "copies"), 9.0);
        EXPECT_EQ(number(table, row + 6, "triangles"), 9.0 * number(table, row, "triangles"));
        EXPECT_EQ(number(table, row + 6, "missed_pixels"), 0.0);
        // At their first frames, methods that remember draw what they do not know yet.
        if (strategy == "frustum-octree")
            EXPECT_GT(added(row), 1.3 * number(table, row, "submitted"));
        else
            EXPECT_LT(added(row), 0.5 * added(0));
        EXPECT_EQ(number(table, row, "ratio_to_octree") == 1.0, strategy == "frustum-octree");
    }
    EXPECT_EQ(strategies.size(), 6u);
    ASSERT_EQ(table.plots.size(), 2u);
    for (const LinePlot& plot : table.plots) EXPECT_EQ(plot.lines.size(), 6u);
    EXPECT_TRUE(table.brokenPromises.empty());
}

TEST(SelfTestOfAMachine, refusesACardWhereTheProcessorDraws) {
    GlInfo gl;
    gl.renderer = "llvmpipe";  // a name alone says nothing
    EXPECT_NO_THROW(requireGraphicsCard(gl));
    gl.software = true;
    try {
        requireGraphicsCard(gl);
        FAIL() << "It was taken for a card.";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::OpenGl);
        EXPECT_STREQ(error.what(),
                     "This OpenGL is llvmpipe, which draws on the processor. Leave out --gpu for sizes that suit it, "
                     "or run this where a graphics card draws.");
    }
}

TEST(SelfTestOfAMachine, refusesASceneThatIsNotThereBeforeItBegins) {
    SelfTestRequest request;
    request.court = "gone.obj";
    bool began = false;
    EXPECT_THROW((void)selfTest(request, {}, [&](const std::string&) { began = true; }), Error);
    EXPECT_FALSE(began);
}

TEST(SelfTestOfAMachine, isRightWhereEveryPartIs) {
    SelfTest test;
    EXPECT_TRUE(test.right());
    certify::Certificate certificate;
    certificate.strategy = "frustum";
    test.certificates = {certificate};
    ResultTable table;
    table.experiment = "occlusion-growth";
    table.checks = {{"a value", 1.0, 0.0, 2.0}};
    test.tables = {table};
    EXPECT_TRUE(test.right());
    const std::string json = selfTestJson(test);
    for (const char* part : {"\"cullscope-selftest\"", "\"right\": true", "\"strategy\": \"frustum\"", "\"occlusion-growth\""})
        EXPECT_THAT(json, testing::HasSubstr(part));
    SelfTest failed = test;
    failed.tables[0].checks[0].value = 3.0;
    EXPECT_FALSE(failed.right());
    failed = test;
    failed.tables[0].brokenPromises = {"frustum"};
    EXPECT_FALSE(failed.right());
    failed = test;
    failed.certificates[0].counterexamples.emplace_back();
    EXPECT_FALSE(failed.right());
    EXPECT_THAT(selfTestJson(failed), testing::HasSubstr("\"right\": false"));
}

}  // namespace
}  // namespace cullscope::test::occlusion_growth_test
