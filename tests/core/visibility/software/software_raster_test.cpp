// The strategies that make their picture on the processor: what they promise, what they say, and what they count.

#include "core/visibility/software/software_raster.h"

#include "core/frame/decided_ahead.h"
#include "core/measure/accuracy.h"
#include "core/mesh/parametric.h"
#include "core/raster/depth_buffer.h"
#include "core/visibility/subject_shape.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_polygons.h"
#include "tests/support/random_views.h"

namespace cullscope::test::software_raster_test {
namespace {

const std::array kIds{"depth-buffer", "scan-line"};

const FinishedPicture& pictureOf(const FrameLog& log) { return *std::get<FinishedPicturePointer>(log.commands.at(0)); }

uint64_t figure(const FrameLog& log, const std::string& name) {
    for (const NamedFigure& one : log.counters.figures)
        if (one.name == name) return uint64_t(one.value);
    ADD_FAILURE() << "no figure " << name;
    return 0;
}

uint64_t bar(const Culler& culler, const FrameLog& log, size_t number) {
    return culler.built()->bars(log).at(0).bars.at(number).value;
}

CullerPointer built(const char* id, const ScenePointer& scene, const char* facing = "auto", bool parallel = true) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    parameters.setFromText("facing", facing);
    parameters.set("parallel", parallel);
    CullerPointer culler = makeCuller(id, parameters);
    culler->build(*scene);
    return culler;
}

TEST(SoftwareRaster, promiseOfAnExactPictureIsKeptOnRandomScenes) {
    const Viewport size{120, 90};
    for (uint64_t seed = 0; seed < howMany(200, 30); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = seed % 3 == 0 ? randomScene(seed + 1) : randomPolygons(seed);
        Random random(seed);
        Camera camera = aroundPolygons(seed);
        if (seed % 3 == 0) camera = randomView(*scene, random).camera;
        const View view(camera, size);
        const SceneBuffers buffers(scene, Upload::Vbo);
        Framebuffer target(size);
        for (const char* id : kIds) {
            const CullerPointer culler = built(id, scene);
            const FrameLog log = culler->cull(view).log;
            const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, culler->referenceFacing());
            const ShownPixels shown = shownPixels(GlEnvironment::renderer(), buffers, log, target);
            EXPECT_EQ(missedBeyondSnapping(truth, shown, *scene, view), 0u) << id;
            EXPECT_EQ(extraBeyondSnapping(truth, shown, *scene, view), 0u) << id;
            EXPECT_EQ(culler->promise(), Promise::Exact);
        }
    }
}

TEST(SoftwareRaster, bothMakeTheSamePictureByBothFacingRules) {
    const ScenePointer scene = sceneOf({starMesh(3, 2'000), sphereMesh(500)}, {Mat4(1.0), translation({1, 0.5, 0.5})});
    for (const char* facing : {"two-sided", "front"}) {
        const View view({{0, 1, 4}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {150, 110});
        const FrameLog reference = built(kIds[0], scene, facing)->cull(view).log;
        for (const char* id : kIds)
            for (const bool parallel : {false, true}) {
                const FrameLog log = built(id, scene, facing, parallel)->cull(view).log;
                EXPECT_EQ(pictureOf(log).triangle, pictureOf(reference).triangle) << id;
                EXPECT_EQ(pictureOf(log).depth, pictureOf(reference).depth) << id;
            }
    }
}

TEST(SoftwareRaster, barsAreTheCountersOfTheFrame) {
    const ScenePointer scene = randomPolygons(1);
    for (const Viewport size : {Viewport{40, 30}, {320, 240}}) {
        const View view(aroundPolygons(1), size);
        const CullerPointer buffer = built(kIds[0], scene), lines = built(kIds[1], scene);
        const FrameLog a = buffer->cull(view, Recording::On).log, b = lines->cull(view, Recording::On).log;
        EXPECT_EQ(bar(*buffer, a, 0), figure(a, "comparisons"));
        EXPECT_EQ(bar(*buffer, a, 1), figure(a, "written"));
        EXPECT_EQ(bar(*lines, b, 0), figure(b, "comparisons"));
        EXPECT_EQ(bar(*lines, b, 1), bar(*buffer, a, 0)) << "what a depth buffer compares";
        EXPECT_LT(bar(*lines, b, 0), bar(*buffer, a, 0));
        // Of the first decisions: a part.
        EXPECT_LT(bar(*lines, b.upTo(b.entries() / 8), 0), bar(*lines, b, 0));
        EXPECT_EQ(bar(*lines, b.upTo(0), 0), 0u);
    }
}

TEST(SoftwareRaster, scanLineSaysEverySpanOfASmallPictureAndTheRowsOfALargeOne) {
    const ScenePointer scene = randomPolygons(5);
    const auto spansOf = [](const FrameLog& log) {
        return std::ranges::count_if(log.decisions, [](const Decision& one) { return one.subject.kind == Subject::Kind::Span; });
    };
    // Consecutive empty rows are one decision.
    const auto rowsOf = [](const FrameLog& log) {
        uint64_t pixels = 0;
        for (const Decision& one : log.decisions) pixels += one.subject.kind == Subject::Kind::Rows ? one.places.count : 0;
        return pixels / uint64_t(log.size.width);
    };
    const FrameLog small = built(kIds[1], scene)->cull(View(aroundPolygons(5), {40, 30}), Recording::On).log;
    EXPECT_GT(spansOf(small), 30);
    for (const Decision& decision : small.decisions)
        if (decision.subject.kind == Subject::Kind::Span) {
            EXPECT_EQ(decision.subject.object, 0u);
        }
    EXPECT_EQ(rowsOf(small), 30u) << "as a whole";
    const FrameLog large = built(kIds[1], scene)->cull(View(aroundPolygons(5), {1600, 2400}), Recording::On).log;
    EXPECT_EQ(spansOf(large), 0);
    EXPECT_EQ(rowsOf(large), 2400u);
}

TEST(SoftwareRaster, scanLineSaysTheComparisonsThatItMakesAndNoOthers) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = randomPolygons(seed);
        const CullerPointer culler = built(kIds[1], scene);
        const View view(aroundPolygons(seed), {48, 36});
        const FrameLog log = culler->cull(view, Recording::On).log, unrecorded = culler->cull(view).log;
        EXPECT_EQ(pictureOf(log).triangle, pictureOf(unrecorded).triangle);
        EXPECT_EQ(pictureOf(log).depth, pictureOf(unrecorded).depth);
        uint64_t compared = 0;
        for (const Decision& one : log.decisions) {
            const std::string sentence = one.sentence == nullptr ? "" : one.sentence;
            if (sentence.find("is compared with %3") == std::string::npos) continue;
            ++compared;
            ASSERT_EQ(one.operandCount, 3u);
            const bool nearer = sentence.find("it is nearer") != std::string::npos;
            const bool farther = sentence.find("it is farther") != std::string::npos;
            const bool equal = sentence.find("they are equal") != std::string::npos;
            EXPECT_EQ(nearer, one.operands[1] > one.operands[2]);
            EXPECT_EQ(farther, one.operands[1] < one.operands[2]);
            EXPECT_EQ(equal, one.operands[1] == one.operands[2]);
        }
        EXPECT_EQ(compared, figure(log, "comparisons"));
        EXPECT_EQ(compared, figure(unrecorded, "comparisons"));
    }
}

TEST(SoftwareRaster, depthBufferSaysEveryTriangleOfASmallSceneAndTheBandsOfALargeOne) {
    // A square, a triangle before it, and one behind it.
    const ScenePointer scene = sceneOf({squareMesh(2, -5), meshOf({{-1, -1, -4}, {0, -1, -4}, {0, 1, -4}}, {0, 1, 2}),
                                        meshOf({{-1, -1, -8}, {1, -1, -8}, {0, 1, -8}}, {0, 1, 2})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(60), 1, 10}, {64, 64});
    const CullerPointer culler = built(kIds[0], scene);
    const FrameLog log = culler->cull(view, Recording::On).log;
    std::vector<const Decision*> about;
    for (const Decision& decision : log.decisions)
        if (decision.subject.kind == Subject::Kind::Triangles && decision.outcome != Decision::Outcome::Culled)
            about.push_back(&decision);
    ASSERT_EQ(about.size(), 8u) << "two of each triangle";
    // Reversed depths at 5, 4 and 8 units with planes at 1 and 10.
    const auto depthAt = [](double distance) { return (10 / distance - 1) / 9; };
    const Decision &second = *about[5], &behind = *about[7];
    EXPECT_EQ(second.outcome, Decision::Outcome::Drawn);
    EXPECT_NEAR(second.operands[2], depthAt(4), 1e-6);
    EXPECT_NEAR(second.operands[3], depthAt(5), 1e-6);
    EXPECT_EQ(second.operands[1], 0.0) << "the square was there before";
    EXPECT_EQ(behind.outcome, Decision::Outcome::Open);
    EXPECT_NEAR(behind.operands[0], depthAt(8), 1e-6);
    EXPECT_GE(behind.operands[1], depthAt(5) - 1e-6);
    EXPECT_EQ(bar(*culler, log, 2), drawDepthBuffer(trianglesOnRaster(*scene, view, Facing::TwoSided)).total().covered);

    const FrameLog large =
        built(kIds[0], sceneOf({sphereMesh(20'000)}))
            ->cull(View({{0, 0, 4}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(40), 0.1, 100}, {320, 240}), Recording::On)
            .log;
    EXPECT_EQ(std::ranges::count_if(large.decisions, [](const auto& one) { return one.subject.kind == Subject::Kind::Rows; }), 8);
}

TEST(SoftwareRaster, whyNamesTheFateOfAnObjectsTriangles) {
    const ScenePointer scene =
        copiesOf(sphereMesh(80), {translation({0, 0, -5}), translation({0, 0, -9}), translation({90, 0, -5})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(40), 0.1, 100}, {64, 64});
    for (const char* id : kIds) {
        const CullerPointer culler = built(id, scene);
        const FrameLog log = culler->cull(view, Recording::On).log;
        for (const auto& [object, words] :
             {std::pair{0u, "draws the object in part"}, {1u, "hidden"}, {2u, "outside the frustum"}}) {
            std::string chain;
            for (const WhyStep& step : why(*culler->built(), log, scene->firstTriangle(object) + 7))
                chain += step.sentence.english() + "\n";
            EXPECT_THAT(chain, testing::HasSubstr(words)) << id << ", object " << object;
            EXPECT_THAT(chain, testing::HasSubstr("Of its 80 triangles")) << id;
        }
    }
}

TEST(SoftwareRaster, surfacesOneRoundingApartAreResolvedAsByOpenGl) {
    // Case 32: two slanted squares in one place, cut along different diagonals, so that their depths differ by roundings.
    const std::vector<Vec3f> corners{{-9, -5, -4}, {7, -6, -9}, {9, 8, -11}, {-7, 9, -6}};
    std::vector<Vec3f> flat = corners;
    // The fourth corner in the plane of the others, and the second square one rounding farther away.
    flat[3] = corners[0] + corners[2] - corners[1];
    std::vector<Vec3f> farther = flat;
    for (Vec3f& corner : farther) corner.z = std::nextafter(corner.z, -100.0f);
    const ScenePointer scene = sceneOf({meshOf(flat, {0, 1, 2, 0, 2, 3}), meshOf(farther, {1, 2, 3, 1, 3, 0})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Framebuffer target(view.viewport());
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    for (const char* id : kIds) {
        const CullerPointer culler = built(id, scene, "two-sided");
        const FrameLog log = culler->cull(view).log;
        const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, log, truth, target);
        // Depths are equal to the bit (docs/methods/software.md), so that none of 19,200 ties falls otherwise.
        EXPECT_EQ(judged.accuracy.unresolvedPixels, 0u) << id;
        EXPECT_EQ(judged.lostPixels(), 0u) << id;
        EXPECT_EQ(extraBeyondSnapping(truth, judged.shown, *scene, view), 0u) << id;
        const Accuracy& accuracy = judged.accuracy;
        uint64_t others = 0;
        for (size_t pixel = 0; pixel < truth.triangle.size(); ++pixel)
            others += pictureOf(log).triangle[pixel] != truth.triangle[pixel] ? 1 : 0;
        EXPECT_EQ(others, accuracy.unresolvedPixels + accuracy.missedPixels + accuracy.extraPixels) << id;
    }
}

TEST(SoftwareRaster, triangleThatCoversNoSampleHasACauseOfItsOwn) {
    // Of one object: two triangles that fill the view, a small one between four pixel centres before them, and one behind them.
    // Of another one nothing but such a small triangle.
    const auto small = [](float x) { return std::array{Vec3f(x, 0, -1), Vec3f(x + .005f, 0, -1), Vec3f(x, .005f, -1)}; };
    const auto a = small(0.0f), b = small(0.25f);
    const ScenePointer scene = sceneOf(
        {meshOf({{-9, -9, -2}, {9, -9, -2}, {9, 9, -2}, {-9, 9, -2}, a[0], a[1], a[2], {-1, 0, -3}, {1, 0, -3}, {0, 1, -3}},
                {0, 1, 2, 0, 2, 3, 4, 5, 6, 7, 8, 9}),
         meshOf({b[0], b[1], b[2]}, {0, 1, 2})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, {64, 64});
    for (const char* id : kIds) {
        const CullerPointer culler = built(id, scene);
        const Culled frame = culler->cull(view, Recording::On);
        EXPECT_EQ(frame.culledTriangles[size_t(Cause::NoSample)], 2u) << id;
        EXPECT_EQ(frame.culledTriangles[size_t(Cause::Hidden)], 1u) << id;
        const auto reasons = [&](uint64_t triangle) {
            std::string chain;
            for (const WhyStep& step : why(*culler->built(), frame.log, triangle)) chain += step.sentence.english() + "\n";
            return chain;
        };
        EXPECT_THAT(reasons(2), testing::HasSubstr("covers no sample: no centre of a pixel lies in it")) << id;
        EXPECT_THAT(reasons(2), testing::Not(testing::HasSubstr("another surface is in front"))) << id;
        EXPECT_THAT(reasons(3), testing::HasSubstr("another surface is in front")) << id;
        EXPECT_THAT(reasons(4), testing::HasSubstr("leaves the object out: covers no sample")) << id;
        // Not recorded, the counts are the same.
        EXPECT_EQ(culler->cull(view).culledTriangles, frame.culledTriangles) << id;
    }
}

TEST(SoftwareRaster, rowInHandIsLitWithItsActiveEdges) {
    const ScenePointer scene = sceneOf({squareMesh(2, -5), meshOf({{-1, -1, -4}, {0, -1, -4}, {0, 1, -4}}, {0, 1, 2})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(60), 1, 10}, {64, 48});
    const CullerPointer culler = built(kIds[1], scene);
    const FrameLog log = culler->cull(view, Recording::On).log;
    const StructureSnapshot snapshot = culler->snapshot(log);
    constexpr uint8_t kRowLine = 2;
    size_t rows = 0, full = 0, edges = 0;
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        const Decision& decision = log.decisions[i];
        if (decision.line != kRowLine) continue;
        const FrameEntry entry{nullptr, &decision, i};
        const SubjectShape shape = subjectShape(*scene, log, snapshot, entry);
        const std::string line = entryLine(*scene, entry, entryNames(snapshot, entry));
        if (decision.subject.kind == Subject::Kind::Triangles) {
            ++edges;
            ASSERT_EQ(shape.lines.size(), 1u);
            EXPECT_EQ(shape.triangles.size(), 1u) << "with its triangle";
            // The edge passes x in the row's middle.
            const auto inPicture = [&](const Vec3& place) {
                const Vec4 clip = view.clipFromEyeRelative() * Vec4(place - view.eye(), 1.0);
                return Vec2((clip.x / clip.w * 0.5 + 0.5) * 64 - 0.5, (clip.y / clip.w * 0.5 + 0.5) * 48 - 0.5);
            };
            const Vec2 a = inPicture(shape.lines[0][0]), b = inPicture(shape.lines[0][1]);
            EXPECT_NEAR(a.x + (b.x - a.x) * (decision.operands[0] - a.y) / (b.y - a.y), decision.operands[1], 0.02);
            // On a side of its triangle, up to the raster's 1/256 pixel.
            for (const Vec3& end : shape.lines[0]) {
                double nearest = 1e9;
                for (const Vec3& corner : shape.triangles[0]) nearest = std::min(nearest, glm::distance(corner, end));
                EXPECT_LT(nearest, 2e-3);
            }
            EXPECT_EQ(line.substr(0, 9), "Triangle ") << line;
            continue;
        }
        const auto row = double(decision.subject.number);
        ASSERT_TRUE(shape.pixels);
        EXPECT_EQ((*shape.pixels)[0], Vec2(0, row));
        EXPECT_EQ((*shape.pixels)[1], Vec2(64, row + 1));
        EXPECT_EQ(double(shape.lines.size()), decision.operands[1]) << "all its edges";
        EXPECT_EQ(line.substr(0, 4), "Row ") << line;
        EXPECT_NE(line.find("at x = "), std::string::npos) << line;
        if (rows++ == 0) {
            // It is not shown before it is done.
            const FrameLog part = replayUpTo(log, i + 1);
            const auto* picture = part.commands.empty() ? nullptr : std::get_if<FinishedPicturePointer>(&part.commands.back());
            EXPECT_TRUE(picture == nullptr || std::ranges::count((*picture)->triangle, 0u) == 64 * 48)
                << "all rows before are empty";
        }
        // Both triangles of the square, and the one before it.
        if (decision.operands[2] < 3.0) continue;
        ++full;
        EXPECT_NE(line.find("; 2: "), std::string::npos) << "by the triangle's number in the scene: " << line;
        EXPECT_NE(line.find(" 0: "), std::string::npos) << line;
        EXPECT_NE(line.find(" 1: "), std::string::npos) << line;
    }
    EXPECT_GT(full, 5u);
    EXPECT_GT(edges, 2 * rows);
}

TEST(SoftwareRaster, severalRowsAndTrianglesAreCalledByTheFirstAndTheLast) {
    // Triangles beyond the far plane, behind each other, follow a visible one.
    const ScenePointer scene = sceneOf({squareMesh(1, -50), meshOf({{-1, -1, -4},
                                                                    {1, -1, -4},
                                                                    {0, 1, -4},  //
                                                                    {-1, -1, -40},
                                                                    {1, -1, -40},
                                                                    {0, 1, -40},
                                                                    {2, 1, -40},
                                                                    {-.1f, -.1f, -5},
                                                                    {.1f, -.1f, -5},
                                                                    {0, .1f, -5}},
                                                                   {0, 1, 2, 3, 4, 5, 4, 6, 5, 7, 8, 9})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(60), 1, 10}, {64, 64});
    const CullerPointer culler = built(kIds[0], scene);
    FrameLog log = culler->cull(view, Recording::On).log;
    const StructureSnapshot snapshot = culler->snapshot(log);
    const auto has = [&](const std::string& words) {
        for (size_t i = 0; i < log.decisions.size(); ++i) {
            const FrameEntry entry{nullptr, &log.decisions[i], i};
            if (entryLine(*scene, entry, entryNames(snapshot, entry)).starts_with(words)) return true;
        }
        return false;
    };
    const std::string name = scene->instances()[1].name;
    EXPECT_TRUE(has("Triangles 3–4 of " + name + ": ")) << "by their numbers in the scene";
    EXPECT_TRUE(has("Triangle 5 of " + name + ": "));
    EXPECT_TRUE(has("Triangle 2 of " + name + ": "));
    EXPECT_FALSE(has("Cell"));
    Decision band = log.decisions.front();
    band.subject = {Subject::Kind::Rows, 32, Subject::kNoObject};
    band.places = {32 * 64, 32 * 64};
    const FrameEntry entry{nullptr, &band, 0};
    EXPECT_EQ(subjectWords(*scene, band.subject, entryNames(snapshot, entry)).english(), "Rows 32–63 of the picture");
}

}  // namespace
}  // namespace cullscope::test::software_raster_test
