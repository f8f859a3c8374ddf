// cullbench render --overlay: content, camera, and refused combinations.

#include "core/image/picture_file.h"
#include "tests/support/cullbench_contract.h"

namespace overlay_test {
namespace {

using cullscope::readPicture;
using cullscope::test::cullbench;
using cullscope::test::ProcessResult;
using testing::HasSubstr;

class CullbenchOverlay : public cullscope::test::CullbenchContract {
protected:
    [[nodiscard]] ProcessResult render(const std::string& scene, const std::string& strategy, const std::string& name,
                                       const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"render", scene, "-s", strategy, "--size", "160x120", "-o", file(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return cullbench(arguments);
    }
    /// A frustum in the scene's field, seen from above.
    [[nodiscard]] std::vector<uint8_t> observed(const std::string& name, const std::vector<std::string>& overlays) const {
        std::vector<std::string> more{"--eye",       "0,0.5,3", "--target",      "3,0,0", "--background", "FFFFFF",
                                      "--view-eye",  "2,20,18", "--view-target", "0,0,0", "--view-up",    "0,1,0",
                                      "--view-fovy", "40"};
        for (const std::string& overlay : overlays) {
            more.emplace_back("--overlay");
            more.push_back(overlay);
        }
        const ProcessResult result = render("field:mesh=teapot,n=4,spacing=2.5", "frustum", name, more);
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        return readPicture(file(name)).rgba;
    }
};

void expectRefusal(const ProcessResult& result, const std::string& mentions) {
    cullscope::test::expectRefusal(result, 2, mentions);
}

TEST_F(CullbenchOverlay, unknownOrUnavailableOneIsRefused) {
    const std::string sphere = "sphere:triangles=200";
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "verdict"}),
                  "Known: verdicts, wireframe, ghost, back-sides, boxes, frustum");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "tree"}), "There is no overlay \"tree\"");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "index-map"}), "\"frustum\" has no index map");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "bands"}), "\"frustum\" has no contour bands");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "sizes"}), "\"frustum\" has no contour bands");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "kernel"}), "\"frustum\" has no quadtree and no inner kernel");
    expectRefusal(render(sphere, "spherical", "a.png", {"--overlay", "kernel"}), "\"spherical\" has no quadtree");
    expectRefusal(render(sphere, "spherical-lossless", "a.png", {"--overlay", "bands"}), "has no contour bands");
    expectRefusal(render(sphere, "all", "a.png", {"--overlay", "boxes"}), "tests no boxes");
    expectRefusal(render(sphere, "frustum", "a.png", {"--drawn-only"}), "--overlay verdicts");
    expectRefusal(render(sphere, "frustum", "a.png", {"--box-colouring", "plane"}), "--overlay boxes");
    expectRefusal(render(sphere, "frustum", "a.png", {"--overlay", "boxes", "--box-colouring", "red"}), "--box-colouring");
    for (const char* id : {"spherical", "spherical-lossless", "bsp", "frustum-select"})
        expectRefusal(render(sphere, id, "a.png", {"--overlay", "boxes", "--box-colouring", "plane"}),
                      "--box-colouring plane: \"" + std::string(id) + "\" tests no box against a plane");
    expectRefusal(render(sphere, "frustum", "a.png", {"--view-eye", "1,2"}), "--view-eye");
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
}

TEST_F(CullbenchOverlay, boxesAreColouredByPlaneWhereAStrategyTestsThemAgainstPlanes) {
    for (const char* id : {"frustum", "frustum-octree", "octree-query", "small-feature"}) {
        const ProcessResult result =
            render("field:mesh=teapot,n=4,spacing=2.5", id, "a.png", {"--overlay", "boxes", "--box-colouring", "plane"});
        EXPECT_EQ(result.exitStatus, 0) << id << ": " << result.err;
    }
}

TEST_F(CullbenchOverlay, whatCannotBeShownIsRefused) {
    const std::string knot = "knot:triangles=2000";
    const auto refused = [&](const std::vector<std::string>& more, const std::string& mentions) {
        expectRefusal(render(knot, "spherical", "a.png", more), mentions);
    };
    refused({"--overlay", "index-map", "--overlay", "spherical-model"}, "give it without --overlay spherical-model");
    refused({"--overlay", "boxes", "--overlay", "spherical-model"}, "give it without --overlay boxes");
    refused({"--overlay", "index-map", "--map-colouring", "red"}, "Known: entries, radius, state");
    refused({"--map-colouring", "state"}, "give both");
    // The frustum cuts the object, or the object lies outside it.
    const std::vector<std::string> close{"--overlay", "bands", "--eye", "0,0,3", "--target", "1.5,0,0", "--fovy", "20"};
    refused(close, "is cut by the frustum, and only one inside the frustum has contour bands");
    refused({"--overlay", "bands", "--eye", "0,0,9", "--target", "0,0,20"}, "is outside the frustum");
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
}

TEST_F(CullbenchOverlay, kernelThatIsNotThereIsRefused) {
    const auto refused = [&](const std::string& scene, const std::vector<std::string>& more, const std::string& mentions) {
        expectRefusal(render(scene, "spherical-lossless", "a.png", more), mentions);
    };
    const std::vector<std::string> kernel{"--overlay", "kernel"};
    refused("knot:triangles=4000", kernel, "the centre of the bounding sphere lies outside the solid");
    refused("knot:triangles=4000", {"--overlay", "index-map", "--map-colouring", "kernel"}, "--map-colouring kernel: the object");
    refused("bowl:triangles=4000", kernel, "\"bowl\" has no inner kernel");
    refused("sphere:triangles=200", kernel, "too few triangles");
    refused("sphere:triangles=4000", {"--overlay", "kernel", "-p", "horizon=false"}, "horizon is off");
    refused("sphere:triangles=4000", {"--overlay", "kernel", "--eye", "0,0,9", "--target", "0,0,20"}, "is outside the frustum");
    expectRefusal(render("sphere:triangles=200", "spherical", "a.png", {"--below", "index-map", "--map-colouring", "level"}),
                  "--map-colouring level: the strategy \"spherical\" has no quadtree");
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
}

TEST_F(CullbenchOverlay, picturesOfQuadtreeAndKernelAllDiffer) {
    const std::vector<std::vector<std::string>> figures{{},
                                                        {"--overlay", "boxes"},
                                                        {"--overlay", "kernel"},
                                                        {"--overlay", "kernel", "--overlay", "boxes"},
                                                        {"--overlay", "index-map", "--map-colouring", "state"},
                                                        {"--overlay", "index-map", "--map-colouring", "level"},
                                                        {"--overlay", "index-map", "--map-colouring", "kernel"}};
    std::vector<std::vector<uint8_t>> pictures;
    for (size_t i = 0; i < figures.size(); ++i) {
        const std::string name = std::to_string(i) + ".png";
        const ProcessResult result = render("star:seed=3,triangles=20000", "spherical-lossless", name, figures[i]);
        ASSERT_EQ(result.exitStatus, 0) << result.err;
        pictures.push_back(readPicture(file(name)).rgba);
        if (i > 0) {
            EXPECT_THAT(result.out,
                        testing::ContainsRegex("is inside the frustum; [1-9][0-9]* nodes visited; planes: 0 outside the "
                                               "frustum; cones: [1-9][0-9]* back-facing; horizon: [0-9]+ hidden"));
        }
    }
    for (size_t i = 0; i < pictures.size(); ++i)
        for (size_t j = i + 1; j < pictures.size(); ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " " << j;
    using Pair = std::pair<std::string, std::string>;
    EXPECT_THAT(readPicture(file("3.png")).metadata, testing::Contains(Pair("cullscope:overlay", "boxes,kernel")));
    EXPECT_THAT(readPicture(file("5.png")).metadata, testing::Contains(Pair("cullscope:map_colouring", "level")));
    // For an open mesh no triangle is known to be hidden or back-facing.
    EXPECT_THAT(
        render("bowl:triangles=4000", "spherical-lossless", "a.png", {"--overlay", "boxes", "-p", "facing=two-sided"}).out,
        HasSubstr("cones: not used; horizon: not used"));
}

TEST_F(CullbenchOverlay, figuresOfThePaperAllDiffer) {
    const std::string knot = "knot:triangles=2000";
    const std::vector<std::string> cut{"--eye", "0,0,3", "--target", "1.5,0,0", "--fovy", "20"};
    const std::vector<std::vector<std::string>> figures{{},
                                                        {"--overlay", "boxes"},
                                                        {"--overlay", "bands"},
                                                        {"--overlay", "bands", "--overlay", "verdicts"},
                                                        {"--overlay", "spherical-model"},
                                                        {"--overlay", "index-map"},
                                                        {"--overlay", "index-map", "--map-colouring", "radius"},
                                                        {"--overlay", "index-map", "--map-colouring", "state"}};
    std::vector<std::vector<uint8_t>> pictures;
    for (size_t i = 0; i < figures.size(); ++i) {
        const std::string name = std::to_string(i) + ".png";
        const ProcessResult result = render(knot, "spherical", name, figures[i]);
        ASSERT_EQ(result.exitStatus, 0) << result.err;
        pictures.push_back(readPicture(file(name)).rgba);
        if (i == 2 || i == 3) continue;
        std::vector<std::string> more = figures[i];
        more.insert(more.end(), cut.begin(), cut.end());
        ASSERT_EQ(render(knot, "spherical", "cut.png", more).exitStatus, 0);
        pictures.push_back(readPicture(file("cut.png")).rgba);
    }
    for (size_t i = 0; i < pictures.size(); ++i)
        for (size_t j = i + 1; j < pictures.size(); ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " " << j;
    using Pair = std::pair<std::string, std::string>;
    EXPECT_THAT(readPicture(file("7.png")).metadata,
                testing::IsSupersetOf({Pair("cullscope:overlay", "index-map"), Pair("cullscope:map_colouring", "state")}));
    EXPECT_THAT(readPicture(file("4.png")).metadata, testing::Contains(Pair("cullscope:overlay", "spherical-model")));
    EXPECT_THAT(readPicture(file("3.png")).metadata, testing::Contains(Pair("cullscope:overlay", "verdicts,bands")));
}

TEST_F(CullbenchOverlay, picturesOfDirectionsHaveNoDepths) {
    for (const char* name : {"index-map", "spherical-model"}) {
        ASSERT_EQ(render("sphere:triangles=200", "spherical", "a.exr", {"--overlay", name}).exitStatus, 0);
        const cullscope::Picture picture = readPicture(file("a.exr"));
        EXPECT_TRUE(picture.depth.empty() && picture.triangle.empty()) << name;
    }
    ASSERT_EQ(render("sphere:triangles=200", "spherical", "b.exr", {"--overlay", "boxes"}).exitStatus, 0);
    EXPECT_FALSE(readPicture(file("b.exr")).depth.empty());
}

TEST_F(CullbenchOverlay, mapIsOfTheFirstObjectInTheFrustum) {
    // From above only the last of sixteen objects is in view; alone it has the same map.
    const std::vector<std::string> place{"--overlay",   "index-map", "--eye", "3.75,12,3.75", "--target",
                                         "3.75,0,3.75", "--up",      "0,0,1", "--fovy",       "6"};
    std::vector<std::string> alone = place;
    alone.insert(alone.end(), {"--hide", "0-14"});
    ASSERT_EQ(render("field:mesh=teapot,n=4,spacing=2.5", "spherical", "a.png", place).exitStatus, 0);
    ASSERT_EQ(render("field:mesh=teapot,n=4,spacing=2.5", "spherical", "b.png", alone).exitStatus, 0);
    EXPECT_EQ(readPicture(file("a.png")).rgba, readPicture(file("b.png")).rgba);
}

TEST_F(CullbenchOverlay, everyOverlayChangesThePicture) {
    const std::vector<std::vector<std::string>> sets{{}, {"verdicts"}, {"boxes"}, {"frustum"}, {"verdicts", "boxes", "frustum"}};
    std::vector<std::vector<uint8_t>> pictures;
    for (size_t i = 0; i < sets.size(); ++i) pictures.push_back(observed(std::to_string(i) + ".png", sets[i]));
    for (size_t i = 0; i < pictures.size(); ++i)
        for (size_t j = i + 1; j < pictures.size(); ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " " << j;
    const cullscope::Picture last = readPicture(file("4.png"));
    using Pair = std::pair<std::string, std::string>;
    EXPECT_THAT(last.metadata, testing::IsSupersetOf({Pair("cullscope:overlay", "verdicts,boxes,frustum"),
                                                      Pair("cullscope:view_eye", "2,20,18"), Pair("cullscope:eye", "0,0.5,3")}));
}

TEST_F(CullbenchOverlay, verdictsAreCountedWhereTheyAreShown) {
    // Closed and convex, from outside: about half of the triangles are visible, about half back-facing.
    const ProcessResult result = render("sphere:triangles=2000", "frustum", "a.png", {"--overlay", "verdicts"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(" drawn and visible"));
    EXPECT_THAT(result.out, HasSubstr(" back-facing"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("wrongly culled")));
    const ProcessResult plain = render("sphere:triangles=2000", "frustum", "b.png", {});
    EXPECT_THAT(plain.out, testing::Not(HasSubstr("drawn and visible")));
}

TEST_F(CullbenchOverlay, drawnOnlyHidesWhatWasCulled) {
    const auto background = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"--overlay", "verdicts",   "--background", "FFFFFF",        "--eye",
                                     "0,0,3",     "--view-eye", "0,0,-3",       "--view-target", "0,0,0"};
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(render("sphere:triangles=2000", "backface", "a.png", all).exitStatus, 0);
        const std::vector<uint8_t> rgba = readPicture(file("a.png")).rgba;
        size_t pixels = 0;
        for (size_t i = 0; i < rgba.size(); i += 4) pixels += rgba[i] == 255 && rgba[i + 1] == 255 && rgba[i + 2] == 255 ? 1 : 0;
        return pixels;
    };
    // From behind: where the near half was culled, the inner side of the far half is visible, slightly smaller than the ball.
    EXPECT_LT(background({}), background({"--drawn-only"}));
}

TEST_F(CullbenchOverlay, observerSeesWhatACameraThereSees) {
    const std::vector<std::string> place{"--eye", "2,3,4", "--target", "0,0,0"};
    const std::vector<std::string> observer{"--eye", "0,0,5", "--view-eye", "2,3,4", "--view-target", "0,0,0"};
    ASSERT_EQ(render("torus:triangles=2000", "all", "a.png", place).exitStatus, 0);
    ASSERT_EQ(render("torus:triangles=2000", "all", "b.png", observer).exitStatus, 0);
    EXPECT_EQ(readPicture(file("a.png")).rgba, readPicture(file("b.png")).rgba);
}

TEST_F(CullbenchOverlay, oneCallDrawsAFigureOfTwoParts) {
    const auto rgba = [&](const std::vector<std::string>& more) {
        const ProcessResult result = render("torus:triangles=2000", "spherical", "a.png", more);
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        return readPicture(file("a.png")).rgba;
    };
    const std::vector<uint8_t> scene = rgba({"--overlay", "bands"}), map = rgba({"--overlay", "index-map"});
    const std::vector<uint8_t> model = rgba({"--overlay", "spherical-model"});
    // Rows count from the bottom, so the second picture's rows come first.
    const auto stacked = [&](std::vector<uint8_t> below) {
        below.insert(below.end(), scene.begin(), scene.end());
        return below;
    };
    EXPECT_EQ(rgba({"--overlay", "bands", "--below", "index-map"}), stacked(map));
    EXPECT_EQ(rgba({"--overlay", "bands", "--below", "spherical-model"}), stacked(model));
    const std::vector<uint8_t> both = rgba({"--overlay", "bands", "--below", "behind"});
    ASSERT_EQ(both.size(), 2 * scene.size());
    EXPECT_TRUE(std::equal(scene.begin(), scene.end(), both.begin() + std::ptrdiff_t(scene.size())));
    EXPECT_FALSE(std::equal(scene.begin(), scene.end(), both.begin()));
    const std::string sphere = "sphere:triangles=200";
    expectRefusal(render(sphere, "spherical", "a.png", {"--below", "above"}), "--below above");
    expectRefusal(render(sphere, "spherical", "a.png", {"--overlay", "index-map", "--below", "behind"}), "no other side");
    expectRefusal(render(sphere, "frustum", "a.png", {"--below", "index-map"}), "has no index map");
}

TEST_F(CullbenchOverlay, mapSaysHowItsObjectLies) {
    const auto words = [&](const std::vector<std::string>& place) {
        std::vector<std::string> more{"--overlay", "index-map"};
        more.insert(more.end(), place.begin(), place.end());
        return render("sphere:triangles=2000", "spherical", "a.png", more).out;
    };
    EXPECT_THAT(words({"--eye", "50,0,0", "--target", "100,0,0"}), HasSubstr("outside the frustum"));
    EXPECT_THAT(words({"--eye", "0,0,0.1", "--target", "1,0,0"}), HasSubstr("around the eye"));
    EXPECT_THAT(words({"--eye", "0,0,3", "--target", "0,0,0", "--fovy", "15"}), HasSubstr("cut by the frustum, case 1"));
}

}  // namespace
}  // namespace overlay_test
