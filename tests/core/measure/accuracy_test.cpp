#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::accuracy_test {
namespace {

/// Two meshes of two triangles each: numbers 0, 1 and 2, 3.
ScenePointer fourTriangles() { return sceneOf({squareMesh(1, 0), squareMesh(1, 1)}); }

/// A reference of 4 × 3 pixels from given depths and triangle numbers + 1, bottom row first.
Reference handMade(std::vector<float> depth, std::vector<uint32_t> triangle) {
    Reference reference;
    reference.size = {4, 3};
    reference.depth = std::move(depth);
    reference.triangle = std::move(triangle);
    for (const uint32_t number : reference.triangle)
        if (number != 0) reference.visibleTriangles.push_back(number - 1);
    reference.coveredPixels = reference.visibleTriangles.size();
    std::ranges::sort(reference.visibleTriangles);
    const auto repeated = std::unique(reference.visibleTriangles.begin(), reference.visibleTriangles.end());
    reference.visibleTriangles.erase(repeated, reference.visibleTriangles.end());
    return reference;
}

Reference someReference() {
    return handMade({.5f, .5f, 0, 0,        //
                     .5f, .5f, .25f, .25f,  //
                     0, 0, .25f, .25f},
                    {1, 1, 0, 0,  //
                     1, 2, 3, 3,  //
                     0, 0, 3, 3});
}

const DrawList kAllFour{Facing::TwoSided, {{0, 0, 6}, {1, 0, 6}}};

TEST(Compare, equalPicturesMissNothing) {
    const Reference reference = someReference();
    const Accuracy accuracy = compare(reference, {reference.depth, {}}, kAllFour, *fourTriangles());
    EXPECT_EQ(accuracy.coveredPixels, 8u);
    EXPECT_EQ(accuracy.missedPixels, 0u);
    EXPECT_EQ(accuracy.extraPixels, 0u);
    EXPECT_EQ(accuracy.largestHolePixels, 0u);
    EXPECT_EQ(accuracy.missedPixelRate(), 0.0);
    EXPECT_EQ(accuracy.visibleTriangles, 3u);
    EXPECT_EQ(accuracy.submittedTriangles, 4u);
    EXPECT_EQ(accuracy.falselyCulledTriangles, 0u);
    EXPECT_EQ(accuracy.needlesslyDrawnTriangles, 1u);
}

TEST(Compare, anotherTriangleWithinTwoRoundingsIsUnresolved) {
    // Case 32. Of pictures that have triangle numbers: without them, any difference of depths counts.
    const Reference reference = someReference();
    const auto moved = [](float depth, int roundings) {
        for (; roundings > 0; --roundings) depth = std::nextafter(depth, 0.0f);
        for (; roundings < 0; ++roundings) depth = std::nextafter(depth, 1.0f);
        return depth;
    };
    std::vector<uint32_t> triangle = reference.triangle;
    std::vector<float> depth = reference.depth;
    for (const size_t pixel : {0, 1, 4, 5, 6}) triangle[pixel] = 4;
    depth[1] = moved(depth[1], 2);   // unresolved, as pixel 0 at the same depth
    depth[4] = moved(depth[4], -1);  // unresolved; a float has half the spacing below 0.5
    depth[5] = moved(depth[5], 8);   // missed
    depth[6] = moved(depth[6], -8);  // extra
    depth[7] = moved(depth[7], 8);   // the same triangle: no difference
    const Accuracy accuracy = compare(reference, {depth, triangle}, kAllFour, *fourTriangles());
    EXPECT_EQ(accuracy.unresolvedPixels, 3u);
    EXPECT_EQ(accuracy.missedPixels, 1u);
    EXPECT_EQ(accuracy.extraPixels, 1u);
    const Accuracy byDepth = compare(reference, {depth, {}}, kAllFour, *fourTriangles());
    EXPECT_EQ(byDepth.unresolvedPixels, 0u);
    EXPECT_EQ(byDepth.missedPixels, 3u);
    EXPECT_EQ(byDepth.extraPixels, 2u);
}

TEST(Compare, missedAndExtraPixelsAreToldApart) {
    const Reference reference = someReference();
    std::vector<float> depth = reference.depth;
    depth[0] = 0.0f;                              // no surface where the reference has one: missed
    depth[4] = .4f;                               // a farther surface: missed
    depth[5] = .6f;                               // a nearer surface: extra
    depth[3] = .1f;                               // a surface where the reference has none: extra
    depth[11] = std::nextafter(depth[11], 0.0f);  // one ulp farther: missed
    const Accuracy accuracy = compare(reference, {depth, {}}, kAllFour, *fourTriangles());
    EXPECT_EQ(accuracy.missedPixels, 3u);
    EXPECT_EQ(accuracy.extraPixels, 2u);
    EXPECT_EQ(accuracy.largestHolePixels, 2u) << "pixels 0 and 4 lie above each other";
    EXPECT_DOUBLE_EQ(accuracy.missedPixelRate(), 3.0 / 8.0);
    EXPECT_EQ(missedMask(reference, {depth, {}}), (std::vector<uint8_t>{1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(Compare, holeGrowsNeitherAcrossACornerNorAroundTheRowsEnd) {
    Reference reference = handMade(std::vector<float>(12, .5f), std::vector<uint32_t>(12, 1));
    const auto hole = [&](std::vector<size_t> missing) {
        std::vector<float> depth = reference.depth;
        for (const size_t pixel : missing) depth[pixel] = 0.0f;
        return compare(reference, {depth, {}}, kAllFour, *fourTriangles()).largestHolePixels;
    };
    EXPECT_EQ(hole({0, 5, 10}), 1u) << "a diagonal";
    EXPECT_EQ(hole({3, 4}), 1u) << "the end of a row and the start of the next";
    EXPECT_EQ(hole({0, 1, 2, 3}), 4u);
    EXPECT_EQ(hole({0, 4, 8, 2, 6}), 3u) << "the larger of two";
    EXPECT_EQ(hole({0, 1, 2, 3, 4, 7, 8, 9, 10, 11}), 10u) << "a ring";
    std::vector<size_t> everything(12);
    for (size_t i = 0; i < 12; ++i) everything[i] = i;
    EXPECT_EQ(hole(everything), 12u);
}

TEST(Compare, onlyTrianglesOfTheListCountAsDrawn) {
    const Reference reference = someReference();  // sees 0, 1 and 2
    const auto counts = [&](std::vector<DrawRange> ranges) {
        const Accuracy accuracy =
            compare(reference, {reference.depth, {}}, {Facing::TwoSided, std::move(ranges)}, *fourTriangles());
        return std::array<uint64_t, 3>{accuracy.submittedTriangles, accuracy.falselyCulledTriangles,
                                       accuracy.needlesslyDrawnTriangles};
    };
    using Counts = std::array<uint64_t, 3>;
    EXPECT_EQ(counts({}), (Counts{0, 3, 0}));
    EXPECT_EQ(counts({{0, 0, 6}}), (Counts{2, 1, 0}));
    EXPECT_EQ(counts({{1, 3, 3}}), (Counts{1, 3, 1}));
    EXPECT_EQ(counts({{1, 0, 6}, {0, 3, 3}}), (Counts{3, 1, 1})) << "in any order";
    EXPECT_EQ(counts({{0, 0, 3}, {0, 0, 6}, {0, 3, 3}}), (Counts{2, 1, 0})) << "what is drawn twice counts once";
    EXPECT_EQ(counts({{0, 0, 0}, {1, 3, 0}}), (Counts{0, 3, 0})) << "an empty range draws nothing";
}

TEST(Compare, pixelThatShowsTheReferencesTriangleIsNoDifferenceWhateverItsDepth) {
    const Reference reference = someReference();
    std::vector<float> depth = reference.depth;
    std::vector<uint32_t> triangle = reference.triangle;
    depth[0] = .4f;  // the same triangle, farther
    depth[1] = .6f;  // the same triangle, nearer
    depth[4] = .4f;  // another one, farther
    triangle[4] = 2;
    depth[5] = .6f;  // another one, nearer
    triangle[5] = 3;
    const ShownPixels shown{depth, triangle};
    const Accuracy accuracy = compare(reference, shown, kAllFour, *fourTriangles());
    EXPECT_EQ(accuracy.missedPixels, 1u);
    EXPECT_EQ(accuracy.extraPixels, 1u);
    EXPECT_EQ(missedMask(reference, shown), (std::vector<uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Compare, emptyReferenceHasRateOfZero) {
    const Reference reference = handMade(std::vector<float>(12, 0.0f), std::vector<uint32_t>(12, 0));
    const Accuracy accuracy = compare(reference, {reference.depth, {}}, {}, *fourTriangles());
    EXPECT_EQ(accuracy.missedPixelRate(), 0.0);
}

View overThree() { return {{{0, 3, 12}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {200, 150}}; }
ScenePointer threeBodies() {
    return sceneOf({knotMesh(4000), starMesh(7, 3000), sphereMesh(1000), sphereMesh(1000)},
                   {translation({-2.5, 0, 0}), translation({2, 0, 0}), translation({0, 0, -5}), translation({50, 0, 0})});
}

TEST(Accuracy, conservativeStrategiesMissNoPixel) {
    const ScenePointer scene = threeBodies();
    const SceneBuffers buffers(scene, Upload::Vbo);
    size_t conservative = 0;
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id);
        strategy->build(*scene);
        if (strategy->promise() == Promise::Approximate) continue;
        const Culled frame = strategy->cull(overThree(), &GlEnvironment::renderer());
        // What makes its picture itself keeps its promise up to the raster's snapping.
        if (!frame.log.drawsScene()) continue;
        ++conservative;
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, overThree(), strategy->facing());
        const Accuracy accuracy =
            compare(reference, {picture(buffers, overThree(), frame.drawList).depth, {}}, frame.drawList, *scene);
        EXPECT_GT(accuracy.coveredPixels, 2000u);
        EXPECT_EQ(accuracy.missedPixels, 0u) << registered.info.id;
        EXPECT_EQ(accuracy.extraPixels, 0u) << registered.info.id;
        EXPECT_EQ(accuracy.falselyCulledTriangles, 0u) << registered.info.id;
        // Parts of triangles count one by one in what was considered.
        EXPECT_EQ(accuracy.submittedTriangles, frame.drawList.triangleCount());
    }
    EXPECT_GE(conservative, 3u);
}

TEST(Accuracy, removedObjectIsCountedExactly) {
    const ScenePointer scene = threeBodies();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, overThree(), Facing::TwoSided);
    for (uint32_t removed = 0; removed < 3; ++removed) {
        DrawList lossy = everything(*scene, Facing::TwoSided);
        std::erase_if(lossy.ranges, [&](const DrawRange& range) { return range.instance == removed; });
        // Counted independently: every pixel whose triangle belongs to the removed object, every different triangle of it.
        uint64_t pixels = 0;
        std::vector<uint32_t> triangles;
        for (const uint32_t number : reference.triangle) {
            if (number == 0 || scene->instanceOf(number - 1) != removed) continue;
            ++pixels;
            triangles.push_back(number);
        }
        std::ranges::sort(triangles);
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());

        const Accuracy accuracy = compare(reference, {picture(buffers, overThree(), lossy).depth, {}}, lossy, *scene);
        EXPECT_GT(pixels, 100u);
        EXPECT_EQ(accuracy.missedPixels, pixels) << removed;
        EXPECT_EQ(accuracy.falselyCulledTriangles, triangles.size()) << removed;
        EXPECT_EQ(accuracy.extraPixels, 0u);
        EXPECT_LE(accuracy.largestHolePixels, pixels);
        EXPECT_GT(accuracy.largestHolePixels, pixels / 4);
        EXPECT_EQ(accuracy.submittedTriangles, scene->triangleCount() - scene->meshOf(removed).triangleCount());
        EXPECT_EQ(accuracy.needlesslyDrawnTriangles,
                  accuracy.submittedTriangles - (reference.visibleTriangles.size() - triangles.size()));
    }
}

TEST(Judge, tellsWhereTheRasterMayHaveMissedAPixel) {
    const ScenePointer scene = sceneOf({knotMesh(400)});
    const View view({{0, 1, 4}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 50}, {96, 72});
    Renderer& renderer = GlEnvironment::renderer();
    const SceneBuffers buffers(scene, Upload::Vbo);
    Framebuffer target(view.viewport());
    struct Expected {
        const char* id;
        bool ownRaster, beyondSnapping;
    };
    for (const auto& [id, ownRaster, beyondSnapping] : {Expected{"all", false, false}, Expected{"backface", false, true},
                                                        Expected{"bsp", true, true}, Expected{"depth-buffer", true, true}}) {
        SCOPED_TRACE(id);
        const CullerPointer culler = makeCuller(id);
        culler->build(*scene);
        const FrameLog log = culler->cull(view, &renderer).log;
        const Reference truth = itemBufferReference(renderer, buffers, view, culler->built()->referenceFacing());
        const JudgedFrame judged = judge(renderer, buffers, log, truth, target);
        EXPECT_EQ(judged.ownRaster, ownRaster);
        EXPECT_EQ(judged.missedBeyondSnapping.has_value(), beyondSnapping);
        EXPECT_EQ(judged.lostPixels(), 0u);
        EXPECT_GT(judged.accuracy.coveredPixels, 500u);
    }
}

TEST(Judge, holesAreOfTheLostPixelsAndNotOfThoseThatSnappingExplains) {
    // A sphere with its inner side out: back-face culling shows its far half from inside, so nearly every pixel is lost. Snapping
    // explains those near an edge, which as missed pixels join all others into one hole.
    const MeshPointer sphere = sphereMesh(5000);
    std::vector<uint32_t> reversed;
    for (size_t triangle = 0; triangle < sphere->triangleCount(); ++triangle)
        for (const size_t corner : {0u, 2u, 1u}) reversed.push_back(sphere->indices()[3 * triangle + corner]);
    const ScenePointer scene = sceneOf({meshOf({sphere->positions().begin(), sphere->positions().end()}, reversed)});
    const View view({{0, 1, 4}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 50}, {96, 72});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Framebuffer target(view.viewport());
    const CullerPointer culler = makeCuller("backface");
    culler->build(*scene);
    const FrameLog log = culler->cull(view, &GlEnvironment::renderer()).log;
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, culler->built()->referenceFacing());
    const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, log, truth, target);
    const uint64_t largestMissed = holes(missedMask(truth, judged.shown), view.viewport()).front().pixels;
    EXPECT_GT(largestMissed, judged.lostPixels()) << "else this test could not fail";
    uint64_t ofHoles = 0;
    for (const Hole& hole : judged.holes(view.viewport())) ofHoles += hole.pixels;
    EXPECT_EQ(ofHoles, judged.lostPixels());
    EXPECT_EQ(judged.accuracy.largestHolePixels, judged.holes(view.viewport()).front().pixels);
    EXPECT_GT(judged.accuracy.largestHolePixels, 100u);
}

TEST(MissedBeyondSnapping, innerPixelsCountAndEdgePixelsDoNot) {
    // A square from (−1, −1) to (1, 1), 64 × 64 pixels of 1/32 each: its diagonal passes through pixel centres, no other
    // edge does.
    const ScenePointer scene = sceneOf({squareMesh(1, -1)});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 10}, {64, 64});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    const auto beyond = [&](size_t x, size_t y) {
        std::vector<float> depth = reference.depth;
        depth[y * 64 + x] = 0.0f;
        return missedBeyondSnapping(reference, {depth, {}}, *scene, view);
    };
    EXPECT_EQ(missedBeyondSnapping(reference, {reference.depth, {}}, *scene, view), 0u);
    EXPECT_EQ(beyond(20, 20), 0u) << "on the diagonal";
    EXPECT_EQ(beyond(20, 40), 1u) << "within the upper triangle";
    EXPECT_EQ(beyond(40, 20), 1u) << "within the lower triangle";
    EXPECT_EQ(missedBeyondSnapping(reference, {std::vector<float>(64 * 64, 0.0f), {}}, *scene, view), 64u * 64u - 64u);
}

/// A square of two triangles at z = −1 that faces the eye, and a second one of triangles 3 and 4: what is lost where the picture
/// shows triangle 4 at a pixel of the first square, at a share of the true depth.
uint64_t lostToTriangle4(const MeshPointer& second, double share) {
    constexpr size_t kPixel = 36 * 64 + 32;  // no edge passes near its centre, (1/64, 9/64) at z = −1
    const ScenePointer scene = sceneOf({squareMesh(1, -1), second});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 10}, {64, 64});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    reference.triangle[kPixel] = 2;  // also where the second square is the nearer one, as of a raster that errs
    ShownPixels shown{reference.depth, reference.triangle};
    shown.triangle[kPixel] = 4;
    shown.depth[kPixel] = float(share * reference.depth[kPixel]);
    EXPECT_EQ(pixelDifference(reference, shown, kPixel), PixelDifference::Missed);
    return missedBeyondSnapping(reference, shown, *scene, view);
}

TEST(MissedBeyondSnapping, lineInWhichTwoSurfacesMeetIsAnEdgeOfBoth) {
    // A steep square: it passes through the first one so many pixels beside the centre, where it lies at distance 1 + beside.
    const auto lost = [](double beside) {
        const auto corner = [&](double across, double y) {
            return Vec3f(Vec3((0.5 + beside) / 32 + across, y, -1.0 + 64 * across));
        };
        const MeshPointer steep =
            meshOf({corner(-.01, -.5), corner(.01, -.5), corner(.01, .5), corner(-.01, .5)}, {0, 1, 2, 0, 2, 3});
        return lostToTriangle4(steep, (10 / (1 + beside) - 1) / 9);
    };
    EXPECT_EQ(lost(1.0 / 200), 0u);
    EXPECT_EQ(lost(1.0 / 50), 1u) << "beyond 1/128 pixel";
}

TEST(MissedBeyondSnapping, polygonsInOnePlaneAreUnresolvedHoweverOpenGlRoundsTheirDepths) {
    EXPECT_EQ(lostToTriangle4(squareMesh(0.75f, -1), 1 - 0x1p-18), 0u);
    EXPECT_EQ(lostToTriangle4(squareMesh(0.75f, -1.00002f), 1 - 0x1p-16), 1u) << "another plane";
}

TEST(MissedBeyondSnapping, nearerPlaneIsNoLossThoughARasterMisplacedItsDepth) {
    EXPECT_EQ(lostToTriangle4(squareMesh(0.75f, -0.99f), 0.99), 0u);
    EXPECT_EQ(lostToTriangle4(squareMesh(0.75f, -1.01f), 0.99), 1u) << "the farther one";
}

TEST(MissedBeyondSnapping, backFaceCullingLosesNoSurfaceOfAClosedMesh) {
    for (const MeshPointer& mesh : {knotMesh(20000), torusMesh(20000), starMesh(7, 20000), sphereMesh(50000)}) {
        const ScenePointer scene = sceneOf({mesh});
        const SceneBuffers buffers(scene, Upload::Vbo);
        for (const Vec3& eye : {Vec3(0, 0, 5), Vec3(3, 2, -2), Vec3(-4, .1, 0)}) {
            const View view({eye, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {320, 240});
            const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
            EXPECT_EQ(missedBeyondSnapping(reference, {picture(buffers, view, everything(*scene, Facing::Front)).depth, {}},
                                           *scene, view),
                      0u)
                << mesh->name();
        }
    }
}

}  // namespace
}  // namespace cullscope::test::accuracy_test
