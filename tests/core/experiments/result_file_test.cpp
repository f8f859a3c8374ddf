#include "core/experiments/result_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/cut_scenes.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::result_file_test {
namespace {

using Json = nlohmann::ordered_json;

// The fields that docs/files.md describes.
const std::vector<std::string> kRunFields{"strategy", "promise", "facing", "parameters", "width",
                                          "height",   "windows", "upload", "build_ms",   "structure_bytes"};
const std::vector<std::string> kFrameFields{
    "pose",         "frame_ms",       "cull_ms",         "considered_triangles",   "visible_triangles",   "missed_pixels",
    "extra_pixels", "covered_pixels", "largest_hole_px", "false_culled_triangles", "submitted_triangles", "submitted_fragments"};
const std::vector<std::string> kSummaryFields{"fps_overall",
                                              "fps_mean",
                                              "fps_min",
                                              "fps_max",
                                              "frame_ms_median",
                                              "frame_ms_p95",
                                              "cull_share",
                                              "culled_fraction",
                                              "missed_pixel_rate",
                                              "ratio_to_same_sides",
                                              "ratio_to_same_sides_ci95",
                                              "ratio_to_all",
                                              "ratio_to_all_ci95",
                                              "ratio_to_backface",
                                              "ratio_to_backface_ci95",
                                              "speedup_vs_all",
                                              "speedup_vs_all_ci95",
                                              "speedup_vs_backface",
                                              "speedup_vs_backface_ci95"};

void expectFields(const Json& json, const std::vector<std::string>& fields) {
    for (const std::string& field : fields) EXPECT_TRUE(json.contains(field)) << field;
}

/// The cells of a CSV line; quoted ones may contain commas and doubled quotes.
std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    return cells;
}

std::vector<std::string> lines(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(ResultJson, everyFieldOfTheContractIsThere) {
    const MeasureRequest experiment = smallExperiment({"frustum", "all"});
    const Json json = Json::parse(resultJson(measure(experiment)));
    expectFields(json["tool"], {"name", "version", "commit"});
    expectFields(json["machine"], {"cpu", "gl_renderer", "gl_version"});
    expectFields(json["scene"], {"name", "sha256", "triangles", "instances"});
    EXPECT_EQ(json["scene"]["triangles"], experiment.scene->triangleCount());
    EXPECT_EQ(json["scene"]["instances"], 9);
    EXPECT_EQ(json["scene"]["sha256"], experiment.scene->sha256());
    ASSERT_EQ(json["runs"].size(), 2u);
    for (const Json& run : json["runs"]) {
        expectFields(run, kRunFields);
        expectFields(run["summary"], kSummaryFields);
        EXPECT_EQ(run["summary"]["speedup_vs_all_ci95"].size(), 2u);
        EXPECT_EQ(run["summary"]["ratio_to_all_ci95"].size(), 2u);
        ASSERT_EQ(run["frames"].size(), 3u);
        for (const Json& frame : run["frames"]) {
            expectFields(frame, kFrameFields);
            EXPECT_EQ(frame["missed_pixels"], 0);
            EXPECT_FALSE(frame.contains("case")) << "of a strategy that tells no case";
        }
    }
    EXPECT_EQ(json["runs"][0]["strategy"], "frustum");
    EXPECT_EQ(json["runs"][0]["parameters"], (Json{{"facing", "auto"}, {"box", "p-vertex"}, {"planes", "basis"}}));
    EXPECT_EQ(json["runs"][0]["promise"], "conservative");
    EXPECT_EQ(json["runs"][0]["facing"], "front") << "closed meshes";
    EXPECT_EQ(json["runs"][1]["facing"], "two-sided");
    EXPECT_EQ(json["runs"][0]["width"], 64);
    EXPECT_EQ(json["runs"][0]["upload"], "vbo");
}

TEST(ResultJson, figureThatWasNotMeasuredIsNull) {
    MeasureRequest experiment = smallExperiment({"all"});
    experiment.accuracy = false;
    const Json json = Json::parse(resultJson(measure(experiment)));
    for (const char* field : {"visible_triangles", "missed_pixels", "covered_pixels", "false_culled_triangles"})
        EXPECT_TRUE(json["runs"][0]["frames"][0][field].is_null()) << field;
    EXPECT_TRUE(json["runs"][0]["summary"]["missed_pixel_rate"].is_null());
}

TEST(ResultJson, fieldsThatAStrategyCountsBesidesStandInTheDocs) {
    std::ifstream file(std::filesystem::path(CULLSCOPE_SOURCE_DIR) / "docs" / "files.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    MeasureRequest experiment = smallExperiment({});
    experiment.scene = copiesOf(threeBars(), {translation({-2, 0, 0}), translation({2, 0, 0})});
    experiment.path = cameraPath("fibonacci:2", *experiment.scene);
    experiment.leaveOutUnavailable = true;
    for (const RegisteredStrategy& strategy : strategies()) experiment.strategies.push_back(request(strategy.info.id));
    size_t fields = 0;
    for (const RunMeasurement& run : measure(experiment).runs)
        for (const NamedFigure& figure : run.frames.front().figures) {
            // Those of Newell's tests are named by the first and the last one.
            const bool between = figure.name.starts_with("test_");
            EXPECT_TRUE(between || page.find('`' + figure.name + '`') != std::string::npos)
                << run.strategy.id << ": " << figure.name;
            ++fields;
        }
    EXPECT_GT(fields, 10u);
}

TEST(ResultJson, caseIsKept) {
    MeasureResult result = measure(smallExperiment({"frustum"}));
    result.runs[0].frames[1].figures = {{"case", 3.0}};
    const Json frames = Json::parse(resultJson(result))["runs"][0]["frames"];
    EXPECT_FALSE(frames[0].contains("case"));
    EXPECT_EQ(frames[1]["case"], 3);
    const std::vector<std::string> rows = lines(resultCsv(result));
    EXPECT_EQ(cells(rows[0]).back(), "case");
    EXPECT_EQ(cells(rows[1]).back(), "");
    EXPECT_EQ(cells(rows[2]).back(), "3");
}

TEST(ResultJson, interruptedMeasurementIsJson) {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    const MeasureResult result = measure(smallExperiment({"all"}), progress);
    const Json json = Json::parse(resultJson(result));
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_TRUE(json["runs"][0]["frames"].empty());
    EXPECT_EQ(lines(resultCsv(result)).size(), 1u) << "the names alone";
}

TEST(ResultJson, nameOfTheSceneDoesNotBreakTheText) {
    MeasureRequest experiment = smallExperiment({"all"});
    experiment.scene = std::make_shared<Scene>("quote \" comma , newline \n bad utf-8 \xff", experiment.scene->meshes(),
                                               experiment.scene->instances());
    const MeasureResult result = measure(experiment);
    EXPECT_TRUE(Json::accept(resultJson(result)));
    std::string csv;
    EXPECT_NO_THROW(csv = resultCsv(result));
    EXPECT_THAT(csv, testing::HasSubstr("quote \"\" comma , newline"));
}

TEST(ResultCsv, everyFrameHasARowWithEveryCell) {
    const MeasureResult result = measure(smallExperiment({"frustum", "all"}));
    const std::vector<std::string> rows = lines(resultCsv(result));
    ASSERT_EQ(rows.size(), 1u + 2u * 3u) << "a row a frame below the names";
    const std::vector<std::string> names = cells(rows[0]);
    for (const auto* fields : {&kRunFields, &kFrameFields})
        for (const std::string& field : *fields) EXPECT_THAT(names, testing::Contains(field));
    const auto column = [&](const std::string& name) { return size_t(std::ranges::find(names, name) - names.begin()); };
    for (size_t row = 1; row < rows.size(); ++row) {
        const std::vector<std::string> frame = cells(rows[row]);
        ASSERT_EQ(frame.size(), names.size()) << rows[row];
        EXPECT_EQ(frame[column("strategy")], row <= 3 ? "frustum" : "all");
        EXPECT_EQ(frame[column("pose")], std::to_string((row - 1) % 3));
        EXPECT_EQ(frame[column("missed_pixels")], "0");
    }
}

TEST(ResultFile, toolAndMachineHaveNames) {
    EXPECT_EQ(toolVersion().name, "cullscope");
    EXPECT_FALSE(toolVersion().version.empty());
    EXPECT_FALSE(toolVersion().commit.empty());
    EXPECT_FALSE(cpuName().empty());
}

}  // namespace
}  // namespace cullscope::test::result_file_test
