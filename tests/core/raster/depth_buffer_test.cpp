// The software depth buffer: the pixel rule, its picture beside OpenGL's, and that neither threads nor instruction sets change
// it.

#include "core/raster/depth_buffer.h"

#include <cmath>
#include <tuple>

#include "core/mesh/parametric.h"
#include "core/raster/shown_triangles.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/gl_environment.h"
#include "tests/support/pixel_edges.h"
#include "tests/support/random_polygons.h"

namespace cullscope::test::depth_buffer_test {
namespace {

const Viewport kSize{320, 240};

/// A picture of triangles given by their corners in it, all at depth 0.5, numbered from 1.
FinishedPicture pictureOf(const std::vector<std::array<Vec2, 3>>& triangles, const Viewport& size) {
    std::vector<RasterCorner> corners;
    for (const auto& triangle : triangles)
        for (const Vec2& corner : triangle) corners.push_back({corner.x, corner.y, 0.5f});
    return *drawDepthBuffer(cornersOnRaster(corners, size)).picture;
}

uint64_t pixelsOf(const FinishedPicture& picture, uint32_t number) {
    return uint64_t(std::ranges::count(picture.triangle, number));
}

TEST(PixelRule, triangleAndItsComplementHaveTenAndSixPixels) {
    // Case 28 of the battery counts rows as a framebuffer stores them, from its first one: so does the raster.
    const Viewport size{8, 8};
    const std::array triangle{Vec2(.5, .5), Vec2(4.5, .5), Vec2(.5, 4.5)},
        complement{Vec2(4.5, .5), Vec2(4.5, 4.5), Vec2(.5, 4.5)};
    EXPECT_EQ(pixelsOf(pictureOf({triangle}, size), 1), 10u);
    EXPECT_EQ(pixelsOf(pictureOf({complement}, size), 1), 6u);
    const FinishedPicture both = pictureOf({triangle, complement}, size);
    EXPECT_EQ(pixelsOf(both, 1), 10u) << "a pixel belongs to both";
    EXPECT_EQ(pixelsOf(both, 2), 6u);
    EXPECT_EQ(both.triangle[0], 1u) << "the pixel at the corner of the right angle";
}

TEST(PixelRule, trianglesAroundACornerCoverEveryPixelOnce) {
    // Fans around points on and between centres; the order of the corners does not matter.
    const Viewport size{61, 47};
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Vec2 middle(std::floor(random.between(20, 40) * 4) / 4, std::floor(random.between(15, 30) * 4) / 4);
        const int sides = 3 + int(random.between(0, 6));
        std::vector<std::array<Vec2, 3>> fan;
        std::vector<Vec2> rim;
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            rim.push_back(middle + 300.0 * Vec2(std::cos(angle), std::sin(angle)));
        }
        for (size_t side = 0; side < rim.size(); ++side) {
            const Vec2 &a = rim[side], &b = rim[(side + 1) % rim.size()];
            fan.push_back(side % 2 == 0 ? std::array{middle, a, b} : std::array{b, a, middle});
        }
        uint64_t sum = 0;
        for (const auto& triangle : fan) sum += pixelsOf(pictureOf({triangle}, size), 1);
        EXPECT_EQ(sum, 61u * 47u) << "around " << middle.x << ", " << middle.y << " with " << sides << " sides";
        EXPECT_EQ(pixelsOf(pictureOf(fan, size), 0), 0u);
    }
}

TEST(DepthBuffer, firstDrawnStaysAtEqualDepth) {
    const std::array<Vec2, 3> triangle{Vec2(-1, -1), Vec2(40, -1), Vec2(-1, 40)};
    const FinishedPicture picture = pictureOf({triangle, triangle}, {16, 16});
    EXPECT_EQ(pixelsOf(picture, 1), 256u);
}

struct Differences {
    uint64_t pixels = 0, unexplained = 0, depths = 0;
    std::string first;
};

/// Where the software's picture shows another triangle than OpenGL's item buffer, and where the same one at another depth. A
/// difference is explained by nothing but an edge of one of the two triangles within 1/128 pixel of the centre: triangles in one
/// plane are to be resolved alike too.
Differences differences(const Scene& scene, const Camera& camera, const Viewport& size, const FinishedPicture& picture,
                        const Renderer::ItemBuffer& items) {
    const PixelEdges edges(scene, camera, size);
    Differences found;
    for (size_t pixel = 0; pixel < items.triangle.size(); ++pixel) {
        const uint32_t a = items.triangle[pixel], b = picture.triangle[pixel];
        if (a == b) {
            found.depths += items.depth[pixel] != picture.depth[pixel] ? 1 : 0;
            continue;
        }
        double edge = INFINITY;
        for (const uint32_t number : {a, b})
            if (number != 0) edge = std::min(edge, edges.toEdgeOf(number - 1, pixel));
        ++found.pixels;
        if (edge <= kEdgePixels) continue;
        ++found.unexplained;
        if (found.first.empty())
            found.first = "pixel " + std::to_string(pixel) + ": OpenGL shows " + std::to_string(a) + " at " +
                          std::to_string(items.depth[pixel]) + ", the software " + std::to_string(b) + " at " +
                          std::to_string(picture.depth[pixel]) + ", " + std::to_string(edge) + " pixels from an edge";
    }
    return found;
}

/// Over several scenes.
struct Compared {
    uint64_t pixels = 0, differing = 0, depths = 0;
};

void expectAsOpenGl(const ScenePointer& scene, const Camera& camera, const Viewport& size, Facing facing, Compared& compared) {
    const View view(camera, size);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, everything(*scene, facing));
    const RasterPicture drawn = drawDepthBuffer(trianglesOnRaster(*scene, view, facing));
    const Differences found = differences(*scene, camera, size, *drawn.picture, items);
    EXPECT_LE(double(found.pixels), 0.001 * double(items.triangle.size()));
    EXPECT_EQ(found.unexplained, 0u) << found.first;
    compared.pixels += items.triangle.size();
    compared.differing += found.pixels;
    compared.depths += found.depths;
}

TEST(DepthBuffer, randomPolygonsAreAsOpenGlDrawsThem) {
    constexpr std::array kKinds{"intersecting", "cyclic", "coplanar", "sharing-edges", "touching"};
    std::array<Compared, kMeetings> kinds;
    for (uint64_t seed = 0; seed < howMany(200, 200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expectAsOpenGl(randomPolygons(seed), aroundPolygons(seed), kSize, Facing::TwoSided, kinds[size_t(meetingOf(seed))]);
    }
    for (size_t kind = 0; kind < kinds.size(); ++kind) {
        const Compared& of = kinds[kind];
        const std::string numbers = std::string(kKinds[kind]) + " pixels " + std::to_string(of.pixels) + " differing " +
                                    std::to_string(of.differing) + " same triangle at another depth " + std::to_string(of.depths);
        std::printf("long: depth-buffer-beside-opengl %s\n", numbers.c_str());
        // Mesa's llvmpipe does the same operations: there depths are equal to the bit, and with them which of two triangles in
        // one plane is seen.
        if (GlEnvironment::info().renderer.find("llvmpipe") == std::string::npos) continue;
        EXPECT_EQ(of.differing, 0u) << numbers;
        EXPECT_EQ(of.depths, 0u) << numbers;
    }
}

TEST(DepthBuffer, meshesAreAsOpenGlDrawsThemByBothFacingRules) {
    const ScenePointer scene = sceneOf({starMesh(3, 4'000), torusMesh(2'000)}, {Mat4(1.0), scaling({-1.2, 1.2, 0.7})});
    Compared compared;
    Random random(11);
    for (int i = 0; i < 6; ++i)
        for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
            SCOPED_TRACE(i);
            const double distance = i % 3 == 0 ? 0.4 : 3.0;
            const Camera camera{distance * random.direction(), {0, 0, 0.1}, {0, 1, 0}, Angle::fromDegrees(60), 0.05, 20.0};
            expectAsOpenGl(scene, camera, kSize, facing, compared);
        }
}

TEST(DepthBuffer, edgesOnPixelCentresOfALevelCameraBelongToTheTrianglesThatOpenGlGivesThemTo) {
    const ScenePointer sphere = sceneOf({sphereMesh(80), torusMesh(500)}, {Mat4(1.0), translation({2, 0, -3})});
    Compared compared;
    uint64_t onCentres = 0;
    for (const Viewport size : {Viewport{33, 97}, {97, 33}, {33, 96}, {32, 97}, {1, 1}, {65, 1}})
        for (const ScenePointer& scene : {squaresAtEyeHeight(), sphere})
            for (int i = 0; i < 8; ++i) {
                SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", view " + std::to_string(i));
                const Camera camera = levelCamera(i);
                expectAsOpenGl(scene, camera, size, Facing::TwoSided, compared);
                const SceneOnRaster raster = trianglesOnRaster(*scene, View(camera, size), Facing::TwoSided);
                for (size_t band = 0; band < raster.bands(); ++band)
                    for (const ScreenTriangle& triangle : raster.trianglesIn(band))
                        for (int corner = 0; corner < 3; ++corner) {
                            const int next = (corner + 1) % 3;
                            onCentres += triangle.y[corner] == triangle.y[next] && triangle.y[corner] % kSubPixels == 0 ? 1 : 0;
                        }
            }
    EXPECT_GT(onCentres, 100u) << "horizontal edges through centres";
    if (GlEnvironment::info().renderer.find("llvmpipe") == std::string::npos) return;
    EXPECT_EQ(compared.differing, 0u) << "of " << compared.pixels;
    EXPECT_EQ(compared.depths, 0u) << "of " << compared.pixels;
}

TEST(DepthBuffer, threadsAndInstructionSetsChangeNothing) {
    // Also where rows or bands are drawn elsewhere, because their samples are no multiple of a block's.
    for (const Viewport size : {Viewport{157, 99}, {160, 120}, {160, 97}, {5, 3}, {3, 130}})
        for (uint64_t seed = 0; seed < 20; ++seed) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", seed " + std::to_string(seed));
            const ScenePointer scene = randomPolygons(seed);
            const View view(aroundPolygons(seed), size);
            const SceneOnRaster raster = trianglesOnRaster(*scene, view, Facing::TwoSided, false, RasterSimd::Portable);
            const RasterPicture one = drawDepthBuffer(raster, false, RasterSimd::Portable);
            for (const RasterSimd simd : availableRasterSimd())
                for (const bool parallel : {false, true}) {
                    const SceneOnRaster again = trianglesOnRaster(*scene, view, Facing::TwoSided, parallel, simd);
                    const RasterPicture other = drawDepthBuffer(again, parallel, simd);
                    EXPECT_EQ(one.picture->triangle, other.picture->triangle);
                    EXPECT_EQ(one.picture->depth, other.picture->depth);
                    EXPECT_EQ(one.fates, other.fates);
                    EXPECT_EQ(one.total().comparisons, other.total().comparisons);
                    EXPECT_EQ(one.total().written, other.total().written);
                    std::vector<uint8_t> shown = other.fates, expected = other.fates;
                    markShown(*other.picture, shown, parallel, simd);
                    for (const uint32_t number : other.picture->triangle)
                        if (number != 0) expected[number - 1] = kShown;
                    EXPECT_EQ(shown, expected);
                }
        }
}

TEST(DepthBuffer, pictureDrawnTriangleByTriangleIsTheSameToTheBit) {
    uint64_t followed = 0;
    for (const Viewport size : {Viewport{157, 99}, {160, 120}, {5, 3}, {3, 130}})
        for (uint64_t seed = 0; seed < 20; ++seed) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", seed " + std::to_string(seed));
            const ScenePointer scene = randomPolygons(seed);
            const SceneOnRaster raster = trianglesOnRaster(*scene, View(aroundPolygons(seed), size), Facing::TwoSided);
            const RasterPicture one = drawDepthBuffer(raster);
            const std::optional<FollowedPicture> other = followDepthBuffer(raster);
            ASSERT_TRUE(other);
            EXPECT_EQ(one.picture->triangle, other->drawn.picture->triangle);
            EXPECT_EQ(one.picture->depth, other->drawn.picture->depth);
            EXPECT_EQ(one.fates, other->drawn.fates);
            ASSERT_EQ(one.rows.size(), other->drawn.rows.size());
            for (size_t band = 0; band < one.rows.size(); ++band) {
                const RowCounts &a = one.rows[band], &b = other->drawn.rows[band];
                EXPECT_EQ(std::tie(a.firstRow, a.endRow, a.triangles, a.samples, a.comparisons, a.written, a.covered),
                          std::tie(b.firstRow, b.endRow, b.triangles, b.samples, b.comparisons, b.written, b.covered));
            }
            followed += other->triangles.size();
        }
    EXPECT_GT(followed, 1000u);
}

TEST(DepthBuffer, smallTrianglesAreSetUpAsLargeOnesAre) {
    // A triangle of each size around that from which on they are set up one by one, at many places: its samples are those whose
    // centres lie inside by whole numbers, and depths change evenly.
    Random random(8);
    const Viewport size{160, 128};
    for (int i = 0; i < 300; ++i) {
        const double reach = i % 3 == 0 ? 2.0 : i % 3 == 1 ? 20.0 : 70.0;
        RasterCorner corners[3];
        const Vec2 middle(random.between(-10, 170), random.between(-10, 138));
        for (RasterCorner& corner : corners) {
            corner.x = std::round((middle.x + random.between(-reach, reach)) * 256) / 256;
            corner.y = std::round((middle.y + random.between(-reach, reach)) * 256) / 256;
            corner.depth = float(random.between(0.2, 0.8));
        }
        const SceneOnRaster raster = cornersOnRaster(corners, size);
        const RasterPicture drawn = drawDepthBuffer(raster);
        std::vector<uint32_t> expected(drawn.picture->triangle.size(), 0);
        std::vector<float> depths(expected.size(), 0.0f);
        if (raster.triangleCount() > 0) {
            ScreenTriangle triangle{};
            for (size_t band = 0; band < raster.bands(); ++band)
                for (const ScreenTriangle& one : raster.trianglesIn(band)) triangle = one;
            for (int row = triangle.firstRow; row < triangle.endRow; ++row)
                for (int column = triangle.firstColumn; column < triangle.endColumn; ++column) {
                    bool inside = true;
                    for (int e = 0; e < 3; ++e) {
                        const int next = (e + 1) % 3;
                        const int64_t dx = triangle.x[next] - triangle.x[e], dy = triangle.y[next] - triangle.y[e];
                        const int64_t value = dx * (row * 256 - triangle.y[e]) - dy * (column * 256 - triangle.x[e]);
                        inside = inside && (value > 0 || (value == 0 && (dy < 0 || (dy == 0 && dx < 0))));
                    }
                    if (!inside) continue;
                    const size_t pixel = size_t(row) * size_t(size.width) + size_t(column);
                    expected[pixel] = 1;
                    depths[pixel] = std::fma(triangle.depthPerRow, float(row),
                                             std::fma(triangle.depthPerColumn, float(column), triangle.depth));
                }
        }
        EXPECT_EQ(drawn.picture->triangle, expected) << i;
        EXPECT_EQ(drawn.picture->depth, depths) << i;
        EXPECT_EQ(drawn.fates[0] == kCovers, std::ranges::count(expected, 1u) > 0) << i;
    }
}

/// Two squares across the view at distances a and b, drawn in this order; which one is seen everywhere.
uint32_t seenOf(double a, double b, double nearDistance, double farDistance) {
    const float half = float(4 * std::max(a, b));
    const ScenePointer scene = sceneOf({squareMesh(half, float(-a)), squareMesh(half, float(-b))});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), nearDistance, farDistance}, {64, 64});
    const RasterPicture drawn = drawDepthBuffer(trianglesOnRaster(*scene, view, Facing::TwoSided));
    const auto inFirst = std::ranges::count_if(drawn.picture->triangle, [](uint32_t n) { return n == 1 || n == 2; });
    const auto inSecond = std::ranges::count_if(drawn.picture->triangle, [](uint32_t n) { return n == 3 || n == 4; });
    EXPECT_EQ(inFirst + inSecond, 64 * 64) << "a hole";
    return inFirst == 64 * 64 ? 1 : inSecond == 64 * 64 ? 2 : 0;
}

TEST(DepthBuffer, nearerOfTwoSquaresWinsOverAWideDepthRange) {
    EXPECT_EQ(seenOf(1000, 1000.01, .01, 1e6), 1u);
    EXPECT_EQ(seenOf(1000.01, 1000, .01, 1e6), 2u);
}

TEST(DepthBuffer, surfacesOneRoundingApartAreResolvedTheSameEverywhere) {
    // Case 32: the positions differ by one unit in the last place of a float, their depths perhaps by none.
    const double next = std::nextafter(5.0f, 6.0f);
    for (const auto& [a, b] : {std::pair{5.0, next}, std::pair{next, 5.0}, std::pair{5.0, 5.0}}) {
        const uint32_t seen = seenOf(a, b, 0.1, 10);
        EXPECT_TRUE(seen == 1 || (seen == 2 && b < a)) << a << " and " << b << ": " << seen;
    }
}

TEST(DepthBuffer, whatLiesBeyondTheFarPlaneOrBeforeTheNearPlaneIsNotShown) {
    const Camera camera{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 1.0, 10.0};
    for (const auto& [z, pixels] : {std::pair{-0.5f, 0u}, {-1.001f, 1024u}, {-9.99f, 1024u}, {-10.01f, 0u}, {5.0f, 0u}}) {
        const ScenePointer scene = sceneOf({squareMesh(100, z)});
        const RasterPicture drawn = drawDepthBuffer(trianglesOnRaster(*scene, View(camera, {32, 32}), Facing::TwoSided));
        EXPECT_EQ(drawn.total().covered, pixels) << z;
    }
}

TEST(DepthBuffer, groundThatReachesBeneathTheEyeFillsTheLowerHalf) {
    // Corners behind the eye, and others thousands of pixels away, at the largest and the smallest windows.
    const ScenePointer scene =
        sceneOf({meshOf({{-1e6, -1, -1e6}, {1e6, -1, -1e6}, {1e6, -1, 1e6}, {-1e6, -1, 1e6}}, {0, 1, 2, 0, 2, 3})});
    for (const Viewport size : {Viewport{64, 64}, {16384, 2}, {2, 16384}, {1, 2}, {16384, 64}}) {
        const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.001, 1e7}, size);
        const RasterPicture drawn = drawDepthBuffer(trianglesOnRaster(*scene, view, Facing::TwoSided));
        const size_t half = size_t(size.width) * size_t(size.height) / 2;
        // The row below the horizon may show sky: the ground ends a million units away.
        EXPECT_GE(drawn.total().covered + size_t(size.width), half) << size.width << " x " << size.height;
        EXPECT_LE(drawn.total().covered, half) << size.width << " x " << size.height;
    }
}

TEST(DepthBuffer, emptyScenesAndTrianglesWithoutAreaShowNothing) {
    const View view({}, {33, 17});
    const ScenePointer none = sceneOf({});
    EXPECT_EQ(drawDepthBuffer(trianglesOnRaster(*none, view, Facing::TwoSided)).total().covered, 0u);
    const ScenePointer line = sceneOf({meshOf({{0, 0, 0}, {1, 1, 0}, {.5f, .5f, 0}}, {0, 1, 2})});
    const SceneOnRaster raster = trianglesOnRaster(*line, view, Facing::TwoSided);
    EXPECT_EQ(raster.triangleCount(), 0u);
    EXPECT_EQ(raster.parts.at(0).withoutSample, 1u);
}

}  // namespace
}  // namespace cullscope::test::depth_buffer_test
