// Experiments after the papers' tables, run on small scenes.
#include <gtest/gtest.h>

#include "core/experiments/experiment_list.h"
#include "core/measure/statistics.h"
#include "core/scene/scene_source.h"
#include "core/spatial/spherical_maps.h"
#include "tests/support/table_cells.h"

namespace cullscope::test::reproduce_test {
namespace {

/// An experiment over generated scenes: two settings of three poses.
Experiment smallTable() {
    Experiment experiment = findExperiment("table-2");
    experiment.settings.resize(2);
    for (Setting& setting : experiment.settings) {
        setting.scene = "star:seed=7,triangles=500";
        setting.strategies = {"all", "backface", "frustum"};
        setting.path = "fibonacci:3";
        setting.views = {};
        setting.size = {64, 48};
    }
    return experiment;
}

TEST(Reproduce, measuresWhatIsDeclared) {
    std::vector<size_t> rowsSeen;
    const ResultTable table =
        runExperiment(smallTable(), {{}, 1}, {}, [&](const ResultTable& soFar) { rowsSeen.push_back(soFar.rows.size()); });
    EXPECT_EQ(rowsSeen, (std::vector<size_t>{3, 6}));
    EXPECT_FALSE(table.interrupted);
    EXPECT_FALSE(table.gl.renderer.empty());
    EXPECT_EQ(number(table, 0, "considered_triangles"), double(table.triangles));
    for (size_t row = 0; row < table.rows.size(); ++row) EXPECT_EQ(number(table, row, "poses"), 3.0);
    EXPECT_DOUBLE_EQ(std::get<RatioEstimate>(valueOf(table, 0, "ratio_to_all")).ratio, 1.0);
}

TEST(Reproduce, stopKeepsRows) {
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    const ResultTable table = runExperiment(smallTable(), {{}, 1}, progress, [&](const ResultTable&) { stop.request_stop(); });
    EXPECT_TRUE(table.interrupted);
    EXPECT_EQ(table.rows.size(), 3u) << "the first setting was measured whole";
}

TEST(Reproduce, stopInTheMiddleOfASettingKeepsItsPoses) {
    std::stop_source stop;
    double last = 0.0;
    const Progress progress{[&](double share, std::string_view) {
                                EXPECT_GE(share, last);
                                last = share;
                                // The start of the second setting's second pose.
                                if (share > 0.5 + 0.5 * (0.05 + 0.95 / 3) - 1e-9) stop.request_stop();
                            },
                            stop.get_token()};
    const ResultTable table = runExperiment(smallTable(), {{}, 1}, progress);
    EXPECT_TRUE(table.interrupted);
    ASSERT_EQ(table.rows.size(), 6u);
    EXPECT_EQ(number(table, 2, "poses"), 3.0);
    EXPECT_EQ(number(table, 5, "poses"), 1.0);
}

TEST(Reproduce, sizesOfTheMapsAreThoseOfTheStructures) {
    Experiment experiment = findExperiment("table-1");
    experiment.settings[0].scene = "sphere:triangles=5000";
    const ResultTable table = runExperiment(experiment, {});
    ASSERT_EQ(table.rows.size(), 5u);
    const std::vector<double> paper{4.3, 6.7, 0.51};
    double sum = 0.0;
    for (size_t map = 0; map < 3; ++map) {
        EXPECT_EQ(number(table, map + 1, "paper_megabytes"), paper[map]);
        EXPECT_GT(number(table, map + 1, "bytes"), 0.0);
        sum += number(table, map + 1, "bytes");
    }
    // Table 1: 4 floats a face; 2 floats a cell and face; of the bunny's 144,046 faces 2.3 MB and 74.7 GB.
    const auto faces = double(table.triangles);
    EXPECT_DOUBLE_EQ(number(table, 1, "paper_formula_megabytes"), 16e-6 * faces);
    EXPECT_NEAR(number(table, 2, "paper_formula_megabytes"), 8e-6 * 360 * 180 * faces, 1e-6);
    EXPECT_DOUBLE_EQ(number(table, 3, "paper_formula_megabytes"), 1.0368);
    EXPECT_EQ(number(table, 4, "bytes"), sum);
    EXPECT_NEAR(number(table, 4, "paper_megabytes"), 11.5, 0.02);
}

TEST(Reproduce, layoutsOfTable1AreMultiplesOfWhatTheyHold) {
    const ResultTable table = runExperiment(findExperiment("table-1-layouts").ofScene("star:seed=3,triangles=2000"), {});
    ASSERT_GT(table.rows.size(), 10u);
    const ScenePointer scene = openScene("star:seed=3,triangles=2000").scene;
    const SphericalMaps maps(scene->meshes().front(), SphericalGrid());
    const auto bytesOf = [&](const char* layout) {
        for (size_t row = 0; row < table.rows.size(); ++row)
            if (table.value(row, "layout") == CellValue(std::string(layout))) return *numberOf(table.value(row, "bytes"));
        return 0.0;
    };
    const auto faces = double(scene->triangleCount()), vertices = double(scene->meshes().front()->vertexCount());
    EXPECT_EQ(bytesOf("a vertex: position, normal; a face: 3 indices"), 24 * vertices + 12 * faces);
    EXPECT_EQ(bytesOf("a face: 3 corners with position and normal"), 72 * faces);
    EXPECT_EQ(bytesOf("index and R an entry"), 8.0 * double(maps.indexEntries()));
    EXPECT_EQ(bytesOf("start and count a cell"), 8.0 * 64'800);
}

}  // namespace
}  // namespace cullscope::test::reproduce_test
