#include "core/image/view_picture.h"

#include "core/gpu/colour.h"
#include "core/mesh/parametric.h"
#include "tests/core/image/shown_picture.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::view_picture_test {
namespace {

TEST(ViewPicture, defaultLookIsTheRenderers) {
    const ScenePointer scene = field(6);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(inTheField(), {320, 240});
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id);
        strategy->build(*scene);
        const Culled frame = strategy->cull(view, &GlEnvironment::renderer());
        const Picture drawn = picture(buffers, view, frame.drawList);
        const Shown look = shown(scene, registered.info.id.c_str(), view, view, {});
        if (!frame.log.drawsScene()) {
            // Parts of triangles are interpolated anew: equal up to rounding, away from edges.
            size_t different = 0;
            for (size_t i = 0; i < drawn.depth.size(); ++i) different += std::abs(look.depth[i] - drawn.depth[i]) > 1e-5f ? 1 : 0;
            EXPECT_LT(different, drawn.depth.size() / 200) << registered.info.id;
            continue;
        }
        EXPECT_EQ(look.colour, drawn.colour) << registered.info.id;
        EXPECT_EQ(look.depth, drawn.depth) << registered.info.id;
    }
}

TEST(ViewPicture, aWireframeHasEdgesAloneAndLeavesTheFrameAsItIs) {
    const ScenePointer scene = copiesOf(sphereMesh(320), {Mat4(1.0)});
    const View view(inTheField(), {320, 240});
    const auto covered = [](const Shown& picture) {
        return std::ranges::count_if(picture.depth, [](float depth) { return depth > 0.0f; });
    };
    for (const RegisteredStrategy& registered : strategies()) {
        const char* id = registered.info.id.c_str();
        const Shown filled = shown(scene, id, view, view, {});
        const Shown edges = shown(scene, id, view, view, {"wireframe"});
        EXPECT_GT(covered(edges), 200) << id;
        EXPECT_LT(covered(edges), covered(filled)) << id << ": the surfaces between them are left out";
        // OpenGL's state is what it was: the next picture is filled.
        EXPECT_EQ(shown(scene, id, view, view, {}).colour, filled.colour) << id;
    }
    const Shown verdicts = shown(scene, "all", view, view, {"verdicts"});
    const Shown verdictEdges = shown(scene, "all", view, view, {"verdicts", "wireframe"});
    EXPECT_LT(covered(verdictEdges), covered(verdicts));
    EXPECT_FALSE(needsDecisions({"wireframe"}));
}

/// Squares of 20 × 20 pixels in a row, one for each state; the centre of state i lies at (20 + 40 i, 20).
ScenePointer rowOfSquares(const Vec3& moved = Vec3(0.0)) {
    std::vector<Mat4> places;
    for (int i = 0; i < int(kTriangleStateCount); ++i)
        places.push_back(translation(moved + Vec3(4 * i - 2 * (int(kTriangleStateCount) - 1), 0, -10)));
    return copiesOf(squareMesh(1, 0), places);
}
View overTheRow(const Vec3& moved = Vec3(0.0)) {
    Camera camera = downMinusZ();
    camera.eye += moved;
    camera.target += moved;
    camera.fovy = Angle::fromRadians(2 * std::atan(0.2));  // 40 pixels are 4 units at distance 10
    return {camera, {40 * int(kTriangleStateCount), 40}};
}
TriangleStates oneOfEach() {
    TriangleStates states;
    for (size_t i = 0; i < kTriangleStateCount; ++i) states.states.insert(states.states.end(), 2, static_cast<TriangleState>(i));
    states.counts.fill(2);
    return states;
}

bool within(const Vec3f& colour, const Vec3f& of, float share) {
    return glm::all(glm::lessThanEqual(glm::abs(colour - of), of * share + 1.0f / 128));
}

Vec3f shaded(const PaletteEntry& entry) { return glm::min(entry.colour * entry.shade, Vec3f(1.0f)); }

TEST(ViewPicture, everyStateHasItsColourAndLook) {
    const TriangleStates states = oneOfEach();
    for (const Vec3f& background : {kLight.background, DrawStyle{}.background}) {
        const DrawStyle style{background};
        const auto palette = verdictPalette(background);
        const Shown look = shown(rowOfSquares(), "all", overTheRow(), overTheRow(), {"verdicts"}, style, &states);
        for (int i = 0; i < int(kTriangleStateCount); ++i) {
            const auto state = static_cast<TriangleState>(i);
            // Off the diagonal, where the wireframe has an edge.
            const Vec3f inner = look.at(20 + 40 * i + 5, 20);
            if (state == TriangleState::OutsideFrustum) {
                EXPECT_TRUE(within(inner, background, 0)) << "a wireframe is filled";
                EXPECT_GT(look.count(look.at(20 + 40 * i, 20)), 60u) << "four edges of 20 pixels and a diagonal";
                EXPECT_TRUE(within(look.at(20 + 40 * i, 20), palette[size_t(i)].colour * palette[size_t(i)].shade, 0));
            } else if (state == TriangleState::WronglyCulled) {
                size_t mark = 0, hatch = 0;
                for (int y = 11; y < 29; ++y)
                    for (int x = 11 + 40 * i; x < 29 + 40 * i; ++x) {
                        mark += within(look.at(x, y), palette[size_t(i)].colour, 0.1f) ? 1 : 0;
                        hatch += within(look.at(x, y), Vec3f(0.0f), 0) || within(look.at(x, y), Vec3f(1.0f), 0) ? 1 : 0;
                    }
                EXPECT_EQ(mark + hatch, 18u * 18u);
                EXPECT_NEAR(double(hatch) / (18 * 18), background.x > 0.5f ? 8.0 / 16 : 6.0 / 16, 0.05);
                EXPECT_TRUE(within(look.at(20 + 40 * i, 30), palette[size_t(i)].colour, 0)) << "the edge itself, outside";
                EXPECT_TRUE(within(look.at(20 + 40 * i, 32), contrastTo(background), 0)) << "the halo around it";
                EXPECT_TRUE(within(look.at(20 + 40 * i, 35), background, 0)) << "the halo ends";
            } else {
                EXPECT_TRUE(within(inner, shaded(palette[size_t(i)]), 0.1f)) << triangleStateName(state);
            }
        }
    }
}

TEST(ViewPicture, drawnOnlyHidesWhatWasCulled) {
    const TriangleStates states = oneOfEach();
    ViewLook drawnOnly{"verdicts"};
    drawnOnly.show("culled_too", false);
    const Shown look = shown(rowOfSquares(), "all", overTheRow(), overTheRow(), drawnOnly, kLight, &states);
    const size_t all = look.size.width * size_t(look.size.height);
    EXPECT_EQ(look.count(kLight.background), all - 2 * 20 * 20) << "only the two squares that were drawn";
}

TEST(ViewPicture, wronglyCulledTriangleWithoutAPixelIsSeen) {
    // A thousandth of a pixel wide, between pixel centres.
    const ScenePointer scene = sceneOf({squareMesh(1e-4f, 0)}, {translation({0.0, 0.0, -10})});
    TriangleStates states;
    states.states.assign(2, TriangleState::WronglyCulled);
    const View view = overTheRow();
    const auto palette = verdictPalette(kLight.background);
    const Shown look = shown(scene, "all", view, view, {"verdicts"}, kLight, &states);
    const size_t mark = look.count(palette[size_t(TriangleState::WronglyCulled)].colour);
    const size_t halo = look.count(contrastTo(kLight.background));
    EXPECT_GE(mark, 4u);
    EXPECT_GE(mark + halo, 25u);
    EXPECT_LE(mark + halo, 81u);
    EXPECT_TRUE(look.near(view, {0, 0, -10}, palette[size_t(TriangleState::WronglyCulled)].colour));
    states.states.assign(2, TriangleState::Visible);
    const Shown plain = shown(scene, "all", view, view, {"verdicts"}, kLight, &states);
    EXPECT_EQ(plain.count(kLight.background), 40 * kTriangleStateCount * 40) << "it covers a pixel: the test shows nothing";
}

TEST(ViewPicture, haloOfAHiddenTriangleDoesNotShowThrough) {
    // A marked square directly behind a larger one that is drawn.
    const ScenePointer scene = sceneOf({squareMesh(2, -10), squareMesh(.5f, -12)});
    TriangleStates states;
    states.states = {TriangleState::Visible, TriangleState::Visible, TriangleState::WronglyCulled, TriangleState::WronglyCulled};
    const View view(downMinusZ(), {100, 100});
    const Shown look = shown(scene, "all", view, view, {"verdicts"}, kLight, &states);
    EXPECT_EQ(look.count(verdictPalette(kLight.background)[size_t(TriangleState::WronglyCulled)].colour), 0u);
    EXPECT_EQ(look.count(contrastTo(kLight.background)), 0u);
}

TEST(ViewPicture, observerColoursByTheCullingCamera) {
    // Without truth: triangles outside the culling camera's frustum are wireframes, for every position of the observer.
    const ScenePointer scene = field(6);
    const View culling(inTheField(), {320, 240});
    const View observer(above(), {320, 240});
    const auto palette = verdictPalette(kLight.background);
    const Shown look = shown(scene, "frustum", culling, observer, {"verdicts"}, kLight);
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const Culled frame = frustum->cull(culling, Recording::On);
    size_t culled = 0;
    for (const SnapshotNode& node : frustum->snapshot(frame.log).nodes) {
        const auto [x, y] = Shown::pixelOf(observer, node.box.centre());
        const Vec3f centre = look.at(x, y);
        const bool drawn = within(centre, shaded(palette[size_t(TriangleState::Visible)]), 0.1f) ||
                           within(centre, shaded(palette[size_t(TriangleState::BackFacing)]), 0.1f);
        EXPECT_EQ(drawn, !node.culled) << node.instance;
        culled += node.culled ? 1 : 0;
    }
    EXPECT_GT(culled, 5u);
    EXPECT_LT(culled, 31u);
}

/// Numbers are multiples of 2^-20, so that moving all of them is exact.
TEST(ViewPicture, farFromTheOriginStatesAndLinesAreTheSame) {
    const Vec3 moved(1e7, -1e7, 1e7);
    const TriangleStates states = oneOfEach();
    const ViewLook look{"verdicts", "boxes"};
    const Shown here = shown(rowOfSquares(), "frustum", overTheRow(), overTheRow(), look, kLight, &states);
    const Shown there = shown(rowOfSquares(moved), "frustum", overTheRow(moved), overTheRow(moved), look, kLight, &states);
    const auto differing = [](const Shown& a, const Shown& b) {
        size_t pixels = 0;
        for (size_t i = 0; i < a.colour.size(); i += 4)
            pixels += std::equal(&a.colour[i], &a.colour[i] + 4, &b.colour[i]) ? 0 : 1;
        return pixels;
    };
    EXPECT_LE(differing(here, there), 12u);

    const auto observed = [&](const Vec3& by) {
        std::vector<Mat4> places;
        for (int i = 0; i < 30; ++i) places.push_back(translation(by + Vec3(2.5 * (i % 6) - 6, 0, 2.5 * (i / 6) - 6)));
        const auto at = [&](Camera camera) {
            camera.eye += by;
            camera.target += by;
            return View(camera, {320, 240});
        };
        return shown(copiesOf(sphereMesh(320), places), "frustum", at(inTheField()), at(above()),
                     {"verdicts", "frustum", "boxes"}, kLight);
    };
    const Shown near = observed(Vec3(0.0));
    EXPECT_GT(near.count(contrastTo(kLight.background)), 200u) << "no frustum to compare";
    EXPECT_LE(differing(near, observed(moved)), 320u * 240u / 200u);
}

TEST(ViewPicture, decisionsAreNeededForVerdictsAndBoxes) {
    EXPECT_FALSE(needsDecisions({}));
    EXPECT_FALSE(needsDecisions({"frustum"}));
    EXPECT_TRUE(needsDecisions({"verdicts"}));
    EXPECT_TRUE(needsDecisions({"boxes"}));
}

TEST(VerdictPalette, backgroundChoosesTheColours) {
    const auto light = verdictPalette(Vec3f(1.0f));
    const auto dark = verdictPalette(DrawStyle{}.background);
    EXPECT_EQ(light[0].colour, Vec3f(0x1F, 0xC3, 0xE3) / 255.0f);
    EXPECT_EQ(dark[6].colour, Vec3f(0xE7, 0x12, 0x0E) / 255.0f);
    EXPECT_EQ(verdictPalette(Vec3f(0.7f))[0].colour, light[0].colour);
    EXPECT_EQ(verdictPalette(Vec3f(0.2f))[0].colour, dark[0].colour);
}

}  // namespace
}  // namespace cullscope::test::view_picture_test
