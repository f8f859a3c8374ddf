// The command line's contract (docs/command-line.md): exit status, fields, files written completely or not at all.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/image/picture_file.h"
#include "tests/support/cullbench_contract.h"

namespace cullbench_contract_test {
namespace {

using cullscope::test::cullbench;
using cullscope::test::CullbenchContract;
using cullscope::test::expectRefusal;
using cullscope::test::ProcessResult;
using cullscope::test::runProcess;
using nlohmann::json;
using testing::HasSubstr;

TEST_F(CullbenchContract, sceneMayStandAfterTheStrategies) {
    const ProcessResult result = cullbench({"measure", "--path", "fibonacci:1", "--size", "16x16", "--repeat", "1", "--models",
                                            file("nowhere"), "-s", "all,backface", "sphere:triangles=80"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
}

TEST_F(CullbenchContract, stepsOfAFrameAreDrawnAndPrintedAndOthersRefused) {
    const std::vector<std::string> quiz{"render", "quiz", "-s", "bsp:plane=given", "--size", "64x48", "-o", file("quiz.png")};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = quiz;
        all.insert(all.end(), more.begin(), more.end());
        return cullbench(all);
    };
    const ProcessResult printed = with({"--steps"});
    ASSERT_EQ(printed.exitStatus, 0) << printed.err;
    EXPECT_THAT(printed.out, HasSubstr("line 1"));
    EXPECT_EQ(with({"--step", "0"}).exitStatus, 0);
    for (const char* step : {"-1", "999999"}) {
        const ProcessResult refused = with({"--step", step});
        EXPECT_EQ(refused.exitStatus, 2) << step;
        EXPECT_THAT(refused.err, HasSubstr(std::string("--step ") + step + ": this frame has the steps 0 to "));
    }
    EXPECT_EQ(with({"--step", "first"}).exitStatus, 2);
}

TEST_F(CullbenchContract, coarserStepsSaySoAndCountsAreWhole) {
    const ProcessResult printed = cullbench(
        {"render", "sphere:triangles=1000000", "-s", "depth-buffer", "--size", "64x48", "--steps", "-o", file("sphere.png")});
    ASSERT_EQ(printed.exitStatus, 0) << printed.err;
    EXPECT_THAT(printed.out,
                HasSubstr("The method itself records this frame coarser:\n  by bands of rows, above 2000 triangles\n"));
    EXPECT_THAT(printed.out, HasSubstr("Of its 1003520 triangles"));
}

TEST_F(CullbenchContract, horizontalFieldOfViewIsForThePicturesSize) {
    const std::string path = file("path.json"), size = "200x100";
    ASSERT_EQ(cullbench({"path", "orbit:2", "sphere:triangles=80", "--fovx", "90", "--size", size, "-o", path}).exitStatus, 0);
    std::ifstream in(path);
    const double fovy = json::parse(in)["fovy_deg"];
    EXPECT_NEAR(fovy, 53.1301, 1e-4);
    const auto picture = [&](const std::vector<std::string>& field) {
        std::vector<std::string> words{"render", "sphere:triangles=80", "-s", "all", "--size", size, "-o", "-"};
        words.insert(words.end(), field.begin(), field.end());
        const ProcessResult drawn = cullbench(words);
        EXPECT_EQ(drawn.exitStatus, 0) << drawn.err;
        return drawn.out;
    };
    EXPECT_EQ(picture({"--path", path}), picture({"--path", "orbit:2", "--fovx", "90"}));
    for (const char* command : {"measure", "sweep"}) {
        std::vector<std::string> words{
            command, "sphere:triangles=80", "-s", "all", "--path", "orbit:2", "--repeat", "1", "--size", size, "--fovx", "90"};
        if (words[0] == "sweep") words[3] = "draw-distance";
        EXPECT_EQ(cullbench(words).exitStatus, 0) << command;
        words.back() = "180";
        expectRefusal(cullbench(words), 2, "--fovx");
    }
    expectRefusal(cullbench({"render", "sphere:triangles=80", "-s", "all", "--fovx", "9", "--fovy", "9", "-o", "-"}), 2, "--fov");
}

// As where a program was copied without the rest of the installation.
TEST_F(CullbenchContract, aProgramWithoutItsPictureFormatsSaysSoAndMeasures) {
    const std::string program = file("bin/cullbench");
    std::filesystem::create_directories(file("bin"));
    std::filesystem::copy_file(CULLBENCH, program);
    const ProcessResult picture =
        runProcess({program, "render", "sphere:triangles=80", "-s", "all", "--size", "16x16", "-o", file("a.png")});
    expectRefusal(picture, 2, "lib/cullscope/picture_formats.so");
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
    const ProcessResult measured = runProcess(
        {program, "measure", "sphere:triangles=80", "-s", "all", "--path", "fibonacci:1", "--size", "16x16", "--repeat", "1"});
    EXPECT_EQ(measured.exitStatus, 0) << measured.err;
}

TEST_F(CullbenchContract, measureGivesEveryField) {
    const ProcessResult result = cullbench({"measure", "sphere:triangles=2000", "-s", "all,backface,frustum", "--path",
                                            "fibonacci:3", "--size", "64x48", "--repeat", "2", "--json", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    const json root = json::parse(result.out);
    for (const char* field : {"name", "version", "commit"}) EXPECT_TRUE(root["tool"].contains(field)) << field;
    for (const char* field : {"cpu", "gl_renderer", "gl_version"}) EXPECT_TRUE(root["machine"].contains(field)) << field;
    EXPECT_EQ(root["scene"]["triangles"], 2000);
    EXPECT_EQ(root["scene"]["instances"], 1);
    EXPECT_EQ(root["scene"]["sha256"].get<std::string>().size(), 64u);
    ASSERT_EQ(root["runs"].size(), 3u);
    for (const json& run : root["runs"]) {
        for (const char* field : {"strategy", "promise", "facing", "parameters", "width", "height", "windows", "upload",
                                  "build_ms", "structure_bytes"})
            EXPECT_TRUE(run.contains(field)) << field;
        ASSERT_EQ(run["frames"].size(), 3u);
        for (const char* field :
             {"pose", "frame_ms", "cull_ms", "considered_triangles", "visible_triangles", "missed_pixels", "extra_pixels",
              "covered_pixels", "largest_hole_px", "false_culled_triangles", "culled_outside_frustum", "culled_back_facing",
              "culled_hidden", "culled_too_small", "culled_no_sample"})
            EXPECT_TRUE(run["frames"][0].contains(field)) << field;
        for (const char* field : {"fps_overall", "fps_mean", "fps_min", "fps_max", "frame_ms_median", "frame_ms_p95",
                                  "cull_share", "culled_fraction", "missed_pixel_rate", "ratio_to_all", "ratio_to_all_ci95",
                                  "speedup_vs_all", "speedup_vs_all_ci95", "speedup_vs_backface"})
            EXPECT_TRUE(run["summary"].contains(field)) << field;
    }
    EXPECT_EQ(root["runs"][0]["summary"]["missed_pixel_rate"], 0.0);
    EXPECT_GT(root["runs"][0]["frames"][0]["covered_pixels"], 100);
    EXPECT_DOUBLE_EQ(root["runs"][0]["summary"]["speedup_vs_all"], 1.0);
    EXPECT_DOUBLE_EQ(root["runs"][0]["summary"]["ratio_to_all"], 1.0);
}

TEST_F(CullbenchContract, csvHasTheFieldsOfJsonAndARowAFrame) {
    const ProcessResult result = cullbench({"measure", "torus:triangles=500", "-s", "all,frustum", "--path", "orbit:2", "--size",
                                            "32x32", "--repeat", "1", "--json", file("r.json"), "--csv", file("r.csv")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    std::ifstream csv(file("r.csv"));
    std::string header, row;
    std::getline(csv, header);
    int rows = 0;
    while (std::getline(csv, row)) ++rows;
    EXPECT_EQ(rows, 4);
    const json root = json::parse(std::ifstream(file("r.json")));
    for (const auto& [name, value] : root["runs"][0]["frames"][0].items())
        EXPECT_THAT("," + header + ",", HasSubstr("," + name + ","));
    EXPECT_EQ(filesWritten(), 2u);
}

TEST_F(CullbenchContract, wrongUsageIsStatus2) {
    expectRefusal(cullbench({"measure", "sphere", "-s", "nonsense"}), 2, "frustum");
    expectRefusal(cullbench({"measure", "nonsense", "-s", "all"}), 2, "teapot");
    expectRefusal(cullbench({"measure", "sphere:triangels=5", "-s", "all"}), 2, "triangels");
    expectRefusal(cullbench({"measure", "sphere", "-s", "frustum", "-p", "box=cube"}), 2, "p-vertex");
    expectRefusal(cullbench({"measure", "sphere", "-s", "frustum", "-p", "bux=length"}), 2, "bux");
    expectRefusal(cullbench({"render", "sphere", "-s", "all", "--size", "0x5", "-o", file("a.png")}), 2, "0x5");
    expectRefusal(cullbench({"render", "sphere:triangles=20", "-s", "all", "--eye", "1,2", "-o", file("a.png")}), 2, "--eye");
    expectRefusal(cullbench({"frobnicate"}), 2, "");
    EXPECT_EQ(filesWritten(), 0u);
}

TEST_F(CullbenchContract, unreadableInputIsStatus3) {
    expectRefusal(cullbench({"measure", file("absent.obj"), "-s", "all"}), 3, "absent.obj");
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", file("absent.json")}), 3, "absent.json");
    std::ofstream(file("huge.json")) << R"({"near": 1e400, "poses": [{"eye": [0,0,3], "target": [0,0,0], "up": [0,1,0]}]})";
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", file("huge.json")}), 3, "huge.json");
    std::ofstream(file("broken.ply")) << "ply\nformat ascii 1.0\nelement vertex 4000000000\n";
    expectRefusal(cullbench({"measure", file("broken.ply"), "-s", "all"}), 3, "broken.ply");
    std::ofstream(file("path.json")) << R"({"fovy_deg": 45, "poses": [{"eye": [0,0,3], "target": [0,0,0]}]})";
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", file("path.json")}), 3, "\"up\"");
}

TEST_F(CullbenchContract, missingOpenGlIsStatus4) {
    const std::vector<std::string> noDriver{"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent/egl.json"};
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all"}, noDriver), 4, "OpenGL");
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all"}, {"MESA_GL_VERSION_OVERRIDE=4.3"}), 4, "has 4.3");
}

TEST_F(CullbenchContract, interruptKeepsWhatWasMeasured) {
    // On a busy machine nothing may be measured after four seconds; then no file is written.
    for (double seconds = 4.0; !std::filesystem::exists(file("partial.json")); seconds *= 2.0) {
        ASSERT_LT(seconds, 100.0);
        const ProcessResult result = cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", "fibonacci:1000000",
                                                "--size", "16x16", "--repeat", "1", "--json", file("partial.json")},
                                               {}, seconds);
        ASSERT_EQ(result.exitStatus, 130) << result.err;
    }
    const json root = json::parse(std::ifstream(file("partial.json")));
    EXPECT_EQ(root["interrupted"], true);
    EXPECT_GT(root["runs"][0]["frames"].size(), 0u);
    EXPECT_LT(root["runs"][0]["frames"].size(), 1000000u);
}

TEST_F(CullbenchContract, unwritablePlaceIsRefusedAndLeavesNoFile) {
    expectRefusal(cullbench({"render", "sphere:triangles=20", "-s", "all", "-o", file("none/a.png")}), 2, "a.png");
    expectRefusal(cullbench({"render", "sphere:triangles=20", "-s", "all", "-o", file("a.xyz")}), 2, "a.xyz");
    EXPECT_EQ(filesWritten(), 0u);
}

TEST_F(CullbenchContract, fullDiskIsNoticed) {
    for (const char* ending : {"png", "jpg"})
        EXPECT_EQ(
            cullbench({"render", "sphere:triangles=20", "-s", "all", "-o", std::string("/dev/full/x.") + ending}).exitStatus, 2);
    const ProcessResult result =
        runProcess({"/bin/sh", "-c", "'" CULLBENCH "' path orbit:3 sphere:triangles=20 -o - > /dev/full"});
    EXPECT_EQ(result.exitStatus, 2);
    EXPECT_THAT(result.err, HasSubstr("standard output"));
    EXPECT_EQ(runProcess({"/bin/sh", "-c", "'" CULLBENCH "' list > /dev/full"}).exitStatus, 2);
}

TEST_F(CullbenchContract, unwritableResultIsFoundBeforeTheMeasurement) {
    const ProcessResult result =
        cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", "fibonacci:1000000", "--json", file("none/x.json")});
    EXPECT_EQ(result.exitStatus, 2) << result.err;
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--json", "-", "--csv", "-"}), 2, "standard output");
}

TEST_F(CullbenchContract, eyeFarAwayOrCloseBySeesTheSurface) {
    const auto shades = [&](const std::string& eye, const std::string& fovy) {
        EXPECT_EQ(cullbench({"render", "sphere:triangles=2000", "-s", "all", "--eye", eye, "--target", "0,0,0", "--fovy", fovy,
                             "--size", "64x64", "-o", file("far.png")})
                      .exitStatus,
                  0);
        const cullscope::Picture picture = cullscope::readPicture(file("far.png"));
        return std::set<uint8_t>(picture.rgba.begin(), picture.rgba.end()).size();
    };
    EXPECT_GT(shades("0,0,1000", "0.2"), 8u);
    EXPECT_GT(shades("0,0,1.001", "60"), 2u);
}

TEST_F(CullbenchContract, backfaceInsideAMeshPromisesToBeApproximate) {
    const ProcessResult result = cullbench({"measure", "sphere:triangles=500", "-s", "backface", "--path", "walk:2", "--size",
                                            "32x32", "--repeat", "1", "--json", "-"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    const json run = json::parse(result.out)["runs"][0];
    EXPECT_EQ(run["promise"], "approximate");
    EXPECT_GT(run["summary"]["missed_pixel_rate"], 0.5);
}

TEST_F(CullbenchContract, interruptEndsAFrameThatSortsForMinutes) {
    std::ofstream soup(file("soup.obj"));
    for (int i = 0; i < 2'000; ++i) {
        for (int corner = 0; corner < 3; ++corner)
            soup << "v " << std::sin(3 * i + corner) << ' ' << std::cos(7 * i + 2 * corner) << ' '
                 << std::sin(11 * i + 5 * corner) << '\n';
        soup << "f -3 -2 -1\n";
    }
    soup.close();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"measure", file("soup.obj"), "-s", "painter:limit=100000000", "--path", "fibonacci:1"},
          {"render", file("soup.obj"), "-s", "painter", "-p", "limit=100000000", "-o", file("soup.png")}}) {
        const ProcessResult result = cullbench(command, {}, 3.0);
        EXPECT_EQ(result.exitStatus, 130) << command[0] << result.err;
    }
    EXPECT_FALSE(std::filesystem::exists(file("soup.png")));
}

TEST_F(CullbenchContract, interruptEndsAGenerator) {
    for (const char* scene : {"sphere:triangles=5e7", "teapot:triangles=5e7", "star:triangles=5e7", "knot:triangles=5e7"})
        EXPECT_EQ(cullbench({"inspect", scene, "-s", "all"}, {}, 0.5).exitStatus, 130) << scene;
}

TEST_F(CullbenchContract, exportedSceneRendersToTheSamePicture) {
    ASSERT_EQ(cullbench({"export", "torus:triangles=5000", "-o", file("torus.obj")}).exitStatus, 0);
    const std::vector<std::string> camera{"--eye", "1,2,3", "--target", "0,0,0", "--up", "0,1,0", "--size", "80x60"};
    const auto render = [&](const std::string& scene, const std::string& picture) {
        std::vector<std::string> arguments{"render", scene, "-s", "backface", "-o", file(picture)};
        arguments.insert(arguments.end(), camera.begin(), camera.end());
        return cullbench(arguments);
    };
    ASSERT_EQ(render("torus:triangles=5000", "a.png").exitStatus, 0);
    ASSERT_EQ(render(file("torus.obj"), "b.png").exitStatus, 0);
    const cullscope::Picture direct = cullscope::readPicture(file("a.png"));
    const cullscope::Picture exported = cullscope::readPicture(file("b.png"));
    EXPECT_EQ(direct.rgba, exported.rgba);
    EXPECT_NE(std::set<uint8_t>(direct.rgba.begin(), direct.rgba.end()).size(), 1u) << "an empty picture shows nothing";
    EXPECT_FALSE(direct.metadata.empty());
}

TEST_F(CullbenchContract, splitSceneLooksLikeTheWhole) {
    const auto render = [&](const std::string& scene, const std::string& picture) {
        EXPECT_EQ(cullbench({"render", scene, "-s", "all", "--size", "120x90", "-o", file(picture)}).exitStatus, 0) << scene;
        return cullscope::readPicture(file(picture)).rgba;
    };
    const std::vector<uint8_t> whole = render("knot:triangles=20000", "whole.png");
    EXPECT_EQ(render("split:mesh=knot:triangles=20000,by=clusters,triangles=700", "clusters.png"), whole);
    EXPECT_EQ(render("split:mesh=knot:triangles=20000", "components.png"), whole);
}

TEST_F(CullbenchContract, hiddenObjectsAreLeftOut) {
    const std::string field = "field:mesh=sphere:triangles=500,n=3";
    const auto scene = [&](const std::string& hide) {
        return json::parse(cullbench({"inspect", field, "-s", "all", "--hide", hide, "--json", "-"}).out)["scene"];
    };
    EXPECT_EQ(scene("3,7-8")["instances"], 6);
    EXPECT_EQ(scene("0-8")["triangles"], 0);
    ASSERT_EQ(cullbench({"export", field, "--hide", "0-4,6-8", "-o", file("one.obj")}).exitStatus, 0);
    EXPECT_EQ(json::parse(cullbench({"inspect", file("one.obj"), "-s", "all", "--json", "-"}).out)["scene"]["instances"], 1);
    const ProcessResult measured = cullbench({"measure", field, "-s", "frustum", "--hide", "4", "--path", "orbit:1", "--size",
                                              "32x32", "--repeat", "1", "--json", "-"});
    EXPECT_EQ(json::parse(measured.out)["scene"]["instances"], 8) << measured.err;
    ASSERT_EQ(cullbench({"render", field, "-s", "all", "--hide", "0-8", "--size", "32x32", "-o", file("none.png")}).exitStatus,
              0);
    const cullscope::Picture none = cullscope::readPicture(file("none.png"));
    EXPECT_EQ(std::set<uint8_t>(none.rgba.begin(), none.rgba.end()).size(), 4u) << "the background alone";
    EXPECT_EQ(cullbench({"path", "walk:3", field, "--hide", "0-8", "-o", file("walk.json")}).exitStatus, 0);
    expectRefusal(cullbench({"measure", field, "-s", "all", "--hide", "0-8"}), 2, "no triangles");
    expectRefusal(cullbench({"inspect", field, "-s", "all", "--hide", "3,9"}), 2, "no object 9 to hide: the scene has 9 objects");
    expectRefusal(cullbench({"inspect", field, "-s", "all", "--hide", "three"}), 2, "3,7-9");
}

TEST_F(CullbenchContract, exrHoldsDepthAndTriangles) {
    ASSERT_EQ(cullbench({"render", "sphere:triangles=2000", "-s", "backface", "--eye", "0,0,5", "--target", "0,0,0", "--size",
                         "41x31", "-o", file("a.exr")})
                  .exitStatus,
              0);
    const cullscope::Picture picture = cullscope::readPicture(file("a.exr"));
    ASSERT_EQ(picture.depth.size(), 41u * 31);
    ASSERT_EQ(picture.triangle.size(), 41u * 31);
    const size_t centre = 15 * 41 + 20;
    EXPECT_NEAR(picture.depth[centre], 4.0F, 0.01) << "forward distance to the unit sphere";
    EXPECT_THAT(picture.triangle[centre], testing::AllOf(testing::Ge(1u), testing::Le(2000u)));
    EXPECT_EQ(picture.depth[0], std::numeric_limits<float>::infinity());
    EXPECT_EQ(picture.triangle[0], 0u);
    EXPECT_FALSE(picture.metadata.empty());
}

TEST_F(CullbenchContract, listShowsStrategiesAndScenes) {
    const json root = json::parse(cullbench({"list", "--json"}).out);
    std::vector<std::string> strategies, scenes;
    for (const json& each : root["strategies"]) strategies.push_back(each["id"]);
    for (const json& each : root["scenes"]) scenes.push_back(each["id"]);
    EXPECT_THAT(strategies, testing::IsSupersetOf({"all", "backface", "frustum"}));
    EXPECT_THAT(scenes, testing::IsSupersetOf({"teapot", "sphere", "torus", "knot", "star", "bunny", "field", "mesh", "split"}));
    EXPECT_EQ(json::parse(cullbench({"list", "strategies", "--json"}).out).size(), 1u);
    std::map<std::string, std::string> asks;
    for (const json& strategy : root["strategies"]) asks[strategy["id"]] = strategy["asks"];
    EXPECT_EQ(asks["frustum-octree"], "nothing");
    EXPECT_EQ(asks["frustum-query"], "opengl");
    EXPECT_EQ(asks["frustum-select"], "compatibility-profile");
    EXPECT_THAT(cullbench({"list", "strategies"}).out, testing::HasSubstr("needs OpenGL's compatibility profile"));
}

TEST_F(CullbenchContract, inspectShowsBytesAndFigures) {
    const json root = json::parse(cullbench({"inspect", "sphere:triangles=500", "-s", "frustum", "--json", "-"}).out);
    EXPECT_GT(root["structure_bytes"], 0);
    EXPECT_EQ(root["figures"]["objects"], 1);
}

}  // namespace
}  // namespace cullbench_contract_test
