// The scan line beside the depth buffer: the same picture to the bit, with fewer comparisons.

#include "core/raster/scan_line.h"

#include <bit>

#include "core/mesh/parametric.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_polygons.h"
#include "tests/support/stopped_work.h"

namespace cullscope::test::scan_line_test {
namespace {

struct Compared {
    RowCounts depthBuffer, scanLine;
};

/// Expects both pictures to be equal to the bit, in turns and in parallel.
Compared expectSame(const Scene& scene, const View& view, Facing facing = Facing::TwoSided) {
    const SceneOnRaster raster = trianglesOnRaster(scene, view, facing);
    const RasterPicture buffer = drawDepthBuffer(raster);
    const ScanLinePicture lines = drawScanLine(raster);
    const auto width = size_t(view.viewport().width);
    for (size_t pixel = 0; pixel < buffer.picture->depth.size(); ++pixel) {
        const float a = buffer.picture->depth[pixel], b = lines.picture->depth[pixel];
        if (buffer.picture->triangle[pixel] == lines.picture->triangle[pixel] &&
            std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b))
            continue;
        ADD_FAILURE() << "pixel " << pixel % width << ", " << pixel / width << ": the depth buffer shows triangle "
                      << buffer.picture->triangle[pixel] << " at " << a << ", the scan line " << lines.picture->triangle[pixel]
                      << " at " << b;
        break;
    }
    const ScanLinePicture serial = drawScanLine(raster, true, false);
    EXPECT_EQ(serial.picture->triangle, lines.picture->triangle);
    EXPECT_EQ(serial.picture->depth, lines.picture->depth);
    EXPECT_EQ(serial.total().comparisons, lines.total().comparisons);
    EXPECT_EQ(serial.total().spans, serial.spans.size());
    EXPECT_EQ(lines.total().covered, buffer.total().covered);
    EXPECT_EQ(lines.total().samples, buffer.total().comparisons);
    return {buffer.total(), lines.total()};
}

TEST(ScanLine, horizontalEdgesOnPixelCentresAreAsTheDepthBufferDrawsThem) {
    for (const Viewport size : {Viewport{33, 97}, {97, 33}, {33, 96}, {65, 1}})
        for (int i = 0; i < 8; ++i) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", view " + std::to_string(i));
            expectSame(*squaresAtEyeHeight(), View(levelCamera(i), size));
        }
}

TEST(ScanLine, randomPolygonsAreAsTheDepthBufferDrawsThem) {
    Compared sum;
    for (uint64_t seed = 0; seed < howMany(200, 200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = randomPolygons(seed);
        for (const Viewport size : {Viewport{160, 120}, {1, 1}, {16384, 1}, {3, 200}}) {
            const Compared compared = expectSame(*scene, View(aroundPolygons(seed), size));
            if (size.height != 120 || meetingOf(seed) == Meeting::Coplanar) continue;
            sum.depthBuffer.comparisons += compared.depthBuffer.comparisons;
            sum.scanLine.comparisons += compared.scanLine.comparisons;
            sum.scanLine.crossings += compared.scanLine.crossings;
        }
        if (HasFailure()) return;
    }
    EXPECT_LT(10 * sum.scanLine.comparisons, sum.depthBuffer.comparisons);
    EXPECT_GT(sum.scanLine.crossings, 0u);
}

TEST(ScanLine, meshesAreAsTheDepthBufferDrawsThem) {
    const ScenePointer scene = sceneOf({starMesh(3, 3'000), torusMesh(2'000), boxMesh({-.4f, -.4f, -.4f}, {.4f, .4f, .4f})},
                                       {Mat4(1.0), scaling({-1.2, 1.2, 0.7}), translation({0.3, 0.2, 0.4})});
    Random random(5);
    for (int i = 0; i < 12; ++i) {
        SCOPED_TRACE(i);
        const double distance = i % 3 == 0 ? 0.3 : random.between(1.5, 6);
        const Camera camera{distance * random.direction(), {0, 0, 0.1}, {0, 1, 0}, Angle::fromDegrees(60), 0.01, 20.0};
        expectSame(*scene, View(camera, {211, 143}), i % 2 == 0 ? Facing::TwoSided : Facing::Front);
    }
}

TEST(ScanLine, surfacesThatCrossAlongARowSplitItsSpanWhereTheDepthBufferDoes) {
    // Two upright squares that pass through each other in the middle of the picture.
    const ScenePointer scene = sceneOf({meshOf({{-2, -2, -6}, {2, -2, -4}, {2, 2, -4}, {-2, 2, -6}}, {0, 1, 2, 0, 2, 3}),
                                        meshOf({{-2, -2, -4}, {2, -2, -6}, {2, 2, -6}, {-2, 2, -4}}, {0, 1, 2, 0, 2, 3})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(30), 0.1, 10}, {101, 101});
    expectSame(*scene, view);
    const ScanLinePicture lines = drawScanLine(trianglesOnRaster(*scene, view, Facing::TwoSided), true);
    const auto crosses = [](const RowStep& step) { return step.at == RowStep::At::Crosses && step.toFront; };
    EXPECT_GE(std::ranges::count_if(lines.steps, crosses), 99);
    for (const RowStep& step : lines.steps)
        if (crosses(step)) {
            EXPECT_NEAR(step.column, 50, 1) << "row " << step.row;
            EXPECT_GE(step.depth, step.otherDepth);
        }
}

TEST(ScanLine, everyComparisonIsAStepWithItsDepthsAndItsOutcome) {
    size_t ties = 0, lost = 0;
    for (uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = randomPolygons(seed);
        const SceneOnRaster raster = trianglesOnRaster(*scene, View(aroundPolygons(seed), {60, 45}), Facing::TwoSided);
        const ScanLinePicture lines = drawScanLine(raster, true), unwatched = drawScanLine(raster);
        EXPECT_EQ(lines.picture->triangle, unwatched.picture->triangle);
        EXPECT_EQ(lines.picture->depth, unwatched.picture->depth);
        EXPECT_TRUE(unwatched.steps.empty());
        std::vector<uint64_t> compared(45, 0);
        size_t step = 0;
        uint32_t front = 0;  // number + 1
        for (const RowSpan& span : lines.spans) {
            // The last surface that came to the front at the span's begin is its own.
            for (; step < lines.steps.size() && lines.steps[step].row == span.row && lines.steps[step].column <= span.begin;
                 ++step) {
                const RowStep& one = lines.steps[step];
                compared[size_t(one.row)] += one.other != 0 ? 1 : 0;
                if (one.other != 0) {
                    EXPECT_EQ(one.other, front) << "compared with the one in front";
                    EXPECT_TRUE(one.toFront ? one.depth >= one.otherDepth : one.depth <= one.otherDepth);
                }
                ties += one.other != 0 && one.depth == one.otherDepth ? 1 : 0;
                lost += one.toFront ? 0 : 1;
                if (one.toFront) front = one.triangle + 1;
            }
            EXPECT_EQ(front, span.triangle + 1) << "row " << span.row << ", column " << span.begin;
            // Those within the span do not come to the front.
            for (; step < lines.steps.size() && lines.steps[step].row == span.row && lines.steps[step].column < span.end;
                 ++step) {
                EXPECT_FALSE(lines.steps[step].toFront);
                EXPECT_EQ(lines.steps[step].other, front);
                ++compared[size_t(span.row)];
                ++lost;
            }
        }
        EXPECT_EQ(step, lines.steps.size());
        for (const RowCounts& row : lines.rows) EXPECT_EQ(compared[size_t(row.firstRow)], row.comparisons) << row.firstRow;
    }
    EXPECT_GT(ties, 0u);
    EXPECT_GT(lost, 0u);
}

TEST(ScanLine, spansOfARowFollowEachOtherAndShowThePicture) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const ScenePointer scene = randomPolygons(seed);
        const ScanLinePicture lines =
            drawScanLine(trianglesOnRaster(*scene, View(aroundPolygons(seed), {90, 70}), Facing::TwoSided), true);
        std::vector<uint32_t> shown(lines.picture->triangle.size(), 0);
        int row = 0, end = 0;
        for (const RowSpan& span : lines.spans) {
            if (span.row != row) end = 0;
            EXPECT_GE(span.row, row);
            EXPECT_GE(span.begin, end);
            EXPECT_LT(span.begin, span.end);
            row = span.row;
            end = span.end;
            for (int column = span.begin; column < span.end; ++column)
                shown[size_t(row) * 90 + size_t(column)] = span.triangle + 1;
        }
        EXPECT_EQ(shown, lines.picture->triangle) << "seed " << seed;
    }
}

TEST(ScanLine, hiddenSurfaceCostsAComparisonARowAndNoMore) {
    // One square far before another one: each row has one comparison for each of their triangles' beginnings and ends.
    const ScenePointer scene = sceneOf({squareMesh(2, -8), squareMesh(1, -2)});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(40), 0.1, 10}, {400, 300});
    const Compared compared = expectSame(*scene, view);
    EXPECT_LE(compared.scanLine.comparisons, 5u * 300);
    EXPECT_GT(compared.depthBuffer.comparisons, 100'000u);
    EXPECT_EQ(compared.scanLine.crossings, 0u);
}

TEST(ScanLine, stopsAtTheNextLookWhereverItIs) {
    const ScenePointer scenes[] = {sceneOf({randomTriangles(1, 10'000, 2.0)}),
                                   coplanarTriangles(longMode() ? 1'000'000 : 60'000)};
    for (const ScenePointer& scene : scenes) {
        const View view({{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(40), 0.1, 100}, {640, 480});
        const SceneOnRaster raster = trianglesOnRaster(*scene, view, Facing::TwoSided);
        for (const uint64_t steps : {uint64_t(1), uint64_t(20'000)}) {
            const StoppedWork stopped =
                stoppedAfter(steps, [&](const Progress& progress) { (void)drawScanLine(raster, true, false, progress); });
            EXPECT_TRUE(stopped.interrupted) << steps;
            EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
        }
        // In parallel too, and the other stages of such a frame.
        std::stop_source stop;
        stop.request_stop();
        const Progress stopped{nullptr, stop.get_token()};
        EXPECT_THROW((void)drawScanLine(raster, true, true, stopped), Error);
        EXPECT_THROW((void)drawDepthBuffer(raster, true, availableRasterSimd().back(), stopped), Error);
        EXPECT_THROW((void)trianglesOnRaster(*scene, view, Facing::TwoSided, true, availableRasterSimd().back(), stopped), Error);
    }
}

TEST(ScanLine, looksForAStopRequestEveryFewMilliseconds) {
    const ScenePointer scene = coplanarTriangles(howMany(1'000'000, 60'000));
    const View view({{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(40), 0.1, 100}, {640, 480});
    const SceneOnRaster raster = trianglesOnRaster(*scene, view, Facing::TwoSided);
    const WatchedWork watched;
    (void)drawScanLine(raster, true, false);
    EXPECT_LT(watched.longestGap(), fewSamples() ? 1000.0 : 100.0) << "milliseconds";
}

TEST(ScanLine, activeEdgesBoundTheSurfacesOfEachRow) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = randomPolygons(seed);
        const SceneOnRaster raster = trianglesOnRaster(*scene, View(aroundPolygons(seed), {90, 70}), Facing::TwoSided);
        const ScanLinePicture lines = drawScanLine(raster, true);
        std::vector<uint64_t> inRow(70, 0);
        for (const RowEdge& edge : lines.edges) {
            ++inRow[size_t(edge.row)];
            EXPECT_GE(edge.column, edge.x - 1e-9) << "the first column whose centre is not left of it";
            EXPECT_LT(edge.column - 1, edge.x);
            const auto& [a, b] = edge.ends;
            EXPECT_NEAR(a.x + (double(b.x) - a.x) * (edge.row - a.y) / (double(b.y) - a.y), edge.x,
                        1e-3 * (1.0 + std::abs(edge.x)));
            EXPECT_TRUE(std::min(a.y, b.y) <= float(edge.row) && float(edge.row) <= std::max(a.y, b.y));
        }
        for (const RowCounts& row : lines.rows) EXPECT_EQ(inRow[size_t(row.firstRow)], row.edges) << row.firstRow;
        for (const RowSpan& span : lines.spans) {
            const auto bounds = [&](bool begins) {
                return std::ranges::any_of(lines.edges, [&](const RowEdge& edge) {
                    const bool of = edge.row == span.row && edge.triangle == span.triangle && edge.begins == begins;
                    return of && (begins ? edge.column <= span.begin : edge.column >= span.end);
                });
            };
            EXPECT_TRUE(bounds(true) && bounds(false)) << "row " << span.row << ", column " << span.begin;
        }
        EXPECT_TRUE(drawScanLine(raster).edges.empty()) << "nothing is kept where it is not asked for";
    }
}

}  // namespace
}  // namespace cullscope::test::scan_line_test
