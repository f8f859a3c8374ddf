// The occlusion buffer: what it hides lies behind its occluders at every pixel, and no instruction set changes it.

#include "core/raster/occlusion_buffer.h"

#include <cmath>
#include <numeric>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/raster/depth_buffer.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::occlusion_buffer_test {
namespace {

constexpr std::array kForms{OcclusionForm::Depth, OcclusionForm::Masked};
constexpr std::array kSizes{Viewport{96, 64}, Viewport{1, 1}, Viewport{33, 9}, Viewport{31, 257}, Viewport{1025, 3}};

const View kStandard({Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100});

/// Draws all triangles of all instances.
void drawAll(OcclusionBuffer& buffer, const Scene& scene, const View& view, Facing facing = Facing::TwoSided) {
    buffer.begin(view);
    for (uint32_t i = 0; i < scene.instances().size(); ++i)
        buffer.draw(scene, i, facing, scene.meshOf(i).positions(), scene.meshOf(i).indices());
}

/// Triangles of all sizes around the origin, some across the eye.
ScenePointer randomTriangles(Random& random, int count) {
    std::vector<Vec3f> corners;
    std::vector<uint32_t> indices(size_t(count) * 3);
    std::iota(indices.begin(), indices.end(), 0u);
    for (int i = 0; i < count; ++i) {
        const Vec3 middle = random.direction() * random.between(0, 4);
        const double size = std::pow(10.0, random.between(-1.5, 1.2));
        for (int corner = 0; corner < 3; ++corner) corners.emplace_back(middle + size * random.direction());
    }
    return sceneOf({meshOf(std::move(corners), std::move(indices))});
}

View randomViewOf(Random& random) {
    const double near = std::pow(10.0, random.between(-2.0, 0.3));
    return {{random.direction() * random.between(0, 8), random.direction() * random.between(0, 2), random.direction(),
             Angle::fromDegrees(random.between(5, 130)), near, near + std::pow(10.0, random.between(0.5, 2.5))},
            kSizes[size_t(random.between(0, double(kSizes.size())))]};
}

EyeBox boxFrom(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

bool hides(OcclusionBuffer& buffer, const EyeBox& box) {
    const std::optional<BoxInPicture> place = buffer.place(box, 0.0);
    return place && place->pixels() > 0 && buffer.hides(*place);
}

TEST(OcclusionBuffer, wallHidesWhatLiesBehindItAndNothingElse) {
    const ScenePointer wall = sceneOf({squareMesh(2, -3)});
    for (const OcclusionForm form : kForms) {
        OcclusionBuffer buffer(form);
        buffer.begin(kStandard);
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, -8}))) << "without occluders nothing is hidden";
        drawAll(buffer, *wall, kStandard);
        EXPECT_TRUE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, -8})));
        EXPECT_TRUE(hides(buffer, boxFrom({-1.7, -1.7, -3.2}, {1.7, 1.7, -3.1})));
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, -2.9}))) << "it reaches through the wall";
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -2}, {1, 1, -1.5}))) << "before the wall";
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -9}, {6.5, 1, -8}))) << "it reaches beyond the wall's edge";
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, 1}))) << "around the eye";
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, 3}, {1, 1, 4}))) << "behind the eye";
        EXPECT_FALSE(hides(buffer, boxFrom({90, -1, -9}, {91, 1, -8}))) << "beside the picture";
        EXPECT_FALSE(hides(buffer, boxFrom(Vec3(-INFINITY), Vec3(INFINITY))));
        EXPECT_FALSE(hides(buffer, {Vec3(NAN), Vec3(1.0)}));
    }
}

TEST(OcclusionBuffer, gapOfAPixelHidesNothing) {
    // Two walls with a gap that a column of pixel centres lies in.
    const auto wall = [](float left, float right) {
        return meshOf({{left, -9, -3}, {right, -9, -3}, {right, 9, -3}, {left, 9, -3}}, {0, 1, 2, 0, 2, 3});
    };
    const float gap = 0.02f;
    const ScenePointer closed = sceneOf({wall(-9, 0.03f), wall(0.03f, 9)}),
                       open = sceneOf({wall(-9, 0.03f - gap), wall(0.03f + gap, 9)});
    for (const OcclusionForm form : kForms) {
        OcclusionBuffer buffer(form);
        drawAll(buffer, *closed, kStandard);
        EXPECT_TRUE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, -8})));
        drawAll(buffer, *open, kStandard);
        EXPECT_FALSE(hides(buffer, boxFrom({-1, -1, -9}, {1, 1, -8})));
        EXPECT_TRUE(hides(buffer, boxFrom({0.6, -1, -9}, {1, 1, -8}))) << "beside the gap";
    }
}

TEST(OcclusionBuffer, backFacesThatAreNotDrawnHideNothing) {
    const ScenePointer square = sceneOf({squareMesh(2, -3)}, {scaling(Vec3(1, 1, -1))});
    const View behind({{0, 0, 6}, Vec3(0.0), Vec3(0, 1, 0), Angle::fromDegrees(60), 0.1, 100}, {64, 64});
    for (const OcclusionForm form : kForms) {
        OcclusionBuffer buffer(form);
        // The square lies at z = 3, and is mirrored: its front is seen from behind, at smaller z.
        for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
            drawAll(buffer, *square, behind, facing);
            EXPECT_EQ(hides(buffer, boxFrom({-0.2, -0.2, -9}, {0.2, 0.2, -8})), facing == Facing::TwoSided);
        }
    }
}

TEST(OcclusionBuffer, trianglesNarrowerThanAPixelHideNothing) {
    std::vector<Vec3f> corners;
    std::vector<uint32_t> indices;
    // A wall of strips of half a pixel.
    for (int i = 0; i < 400; ++i) {
        const float left = -6.0f + 0.03f * float(i), right = left + 0.03f;
        for (const Vec3f& corner : {Vec3f(left, -9, -3), Vec3f(right, -9, -3), Vec3f(right, 9, -3)}) {
            indices.push_back(uint32_t(corners.size()));
            corners.push_back(corner);
        }
    }
    const ScenePointer strips = sceneOf({meshOf(std::move(corners), std::move(indices))});
    for (const OcclusionForm form : kForms) {
        OcclusionBuffer buffer(form);
        drawAll(buffer, *strips, kStandard);
        EXPECT_EQ(buffer.counts(), (OccluderCounts{400, 0}));
        EXPECT_TRUE(buffer.empty());
    }
}

TEST(OcclusionBuffer, instructionSetsAreAlikeToTheBit) {
    Random random(17);
    for (int i = 0; i < 60; ++i) {
        const ScenePointer scene = randomTriangles(random, 40);
        const View view = randomViewOf(random);
        for (const OcclusionForm form : kForms) {
            OcclusionBuffer portable(form, RasterSimd::Portable);
            drawAll(portable, *scene, view);
            for (const RasterSimd simd : availableRasterSimd()) {
                OcclusionBuffer buffer(form, simd);
                drawAll(buffer, *scene, view);
                EXPECT_EQ(buffer.counts(), portable.counts());
                ASSERT_EQ(buffer.depths(), portable.depths())
                    << "scene " << i << "; " << described(view.camera(), view.viewport());
            }
        }
    }
}

TEST(OcclusionBuffer, isNowhereNearerThanTheDepthBuffer) {
    Random random(23);
    uint64_t pixels = 0, covered = 0, masked = 0;
    for (int i = 0; i < 120; ++i) {
        const ScenePointer scene = randomTriangles(random, 1 + i % 30);
        const View view = randomViewOf(random);
        const FinishedPicture truth = *drawDepthBuffer(trianglesOnRaster(*scene, view, Facing::TwoSided)).picture;
        OcclusionBuffer depth(OcclusionForm::Depth), both(OcclusionForm::Masked);
        drawAll(depth, *scene, view);
        drawAll(both, *scene, view);
        const std::vector<float> ofDepth = depth.depths(), ofMasked = both.depths();
        ASSERT_EQ(ofDepth.size(), truth.depth.size());
        for (size_t pixel = 0; pixel < ofDepth.size(); ++pixel) {
            ASSERT_LE(std::min(ofDepth[pixel], 1.0f), truth.depth[pixel])
                << "scene " << i << " pixel " << pixel << "; " << described(view.camera(), view.viewport());
            ASSERT_LE(std::min(ofMasked[pixel], 1.0f), truth.depth[pixel])
                << "scene " << i << " pixel " << pixel << "; " << described(view.camera(), view.viewport());
            pixels += truth.depth[pixel] > 0.0f ? 1 : 0;
            covered += ofDepth[pixel] > 0.0f ? 1 : 0;
            masked += ofMasked[pixel] > 0.0f ? 1 : 0;
        }
    }
    EXPECT_GT(double(covered), 0.97 * double(pixels)) << "only narrow triangles are left out";
    EXPECT_GT(double(masked), 0.9 * double(covered));
}

TEST(OcclusionBuffer, hidesWhatIsFartherAtEveryPixelOfABox) {
    Random random(29);
    uint64_t hidden = 0, asked = 0;
    for (int i = 0; i < 60; ++i) {
        const ScenePointer scene = randomTriangles(random, 30);
        const View view = randomViewOf(random);
        for (const OcclusionForm form : kForms) {
            OcclusionBuffer buffer(form);
            drawAll(buffer, *scene, view);
            for (int box = 0; box < 200; ++box) {
                const EyeBox of{random.direction() * random.between(0, 12), Vec3(std::pow(10.0, random.between(-2, 0.5)))};
                const std::optional<BoxInPicture> place = buffer.place(of, 0.0);
                if (!place || place->pixels() == 0) continue;
                ++asked;
                const bool all = buffer.farthestIn(*place) > place->depth;
                ASSERT_EQ(buffer.hides(*place), all && !buffer.empty()) << described(view.camera(), view.viewport());
                hidden += all ? 1 : 0;
            }
        }
    }
    EXPECT_GT(hidden, asked / 20);
    EXPECT_LT(hidden, asked);
}

TEST(OcclusionBuffer, placesABoxWithThePixelsAroundIt) {
    // One unit is 50 pixels at distance 1; the centre of the picture lies between pixels 49 and 50.
    OcclusionBuffer buffer(OcclusionForm::Depth);
    buffer.begin(kStandard);
    const std::optional<BoxInPicture> place = buffer.place(boxFrom({-0.1, -0.2, -2}, {0.1, 0.2, -1}), 0.0);
    ASSERT_TRUE(place);
    // It covers the centres of columns 45 to 54 and rows 40 to 59.
    EXPECT_EQ(place->firstColumn, 44);
    EXPECT_EQ(place->endColumn, 56);
    EXPECT_EQ(place->firstRow, 39);
    EXPECT_EQ(place->endRow, 61);
    EXPECT_GE(place->depth, float(kStandard.depthFromDistance(1.0)));
    EXPECT_NEAR(place->depth, kStandard.depthFromDistance(1.0), 1e-5);
    EXPECT_NEAR(buffer.place(boxFrom({-0.1, -0.2, -2}, {0.1, 0.2, -1}), 0.5)->depth, kStandard.depthFromDistance(0.5), 1e-5);
}

TEST(OcclusionBuffer, blockThatIsFullKeepsTheNearerPixelsDepth) {
    // The edge of a near wall ends in the middle of the blocks of columns 48 to 55. The far one makes them full, but for those
    // that its diagonal crosses.
    const ScenePointer scene = sceneOf({squareMesh(2, -2), squareMesh(4, -4)}, {translation({-1.96, 0, 0}), Mat4(1.0)});
    OcclusionBuffer masked(OcclusionForm::Masked);
    drawAll(masked, *scene, kStandard);
    const std::vector<float> depths = masked.depths();
    const auto between = float(kStandard.depthFromDistance(3.0));
    size_t near = 0, behindEdge = 0;
    for (size_t row = 0; row < 100; ++row) {
        near += depths[100 * row + 49] > between ? 1 : 0;
        behindEdge += depths[100 * row + 54] > between ? 1 : 0;
        EXPECT_GT(depths[100 * row + 54], 0.0f) << row;
    }
    EXPECT_GE(near, 90u);
    EXPECT_EQ(behindEdge, 0u);
}

TEST(OcclusionBuffer, trianglesOfAMeshAreEachPlacedWhereTheyLieHoweverManyThereAre) {
    // 66,000 small triangles ahead; after them large ones, some across the eye.
    Random random(31);
    std::vector<Vec3f> corners;
    const auto add = [&](const Vec3& middle, double size) {
        for (int corner = 0; corner < 3; ++corner) corners.emplace_back(middle + size * random.direction());
    };
    constexpr size_t kFirst = 66'000;
    for (size_t i = 0; i < kFirst; ++i) add({random.between(-4, 4), random.between(-4, 4), -5}, 0.3);
    for (size_t i = 0; i < 200; ++i) add(random.direction() * random.between(0, 4), 3.0);
    std::vector<uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    const ScenePointer scene = sceneOf({meshOf(corners, indices)});
    const TriangleMesh& mesh = scene->meshOf(0);
    for (const OcclusionForm form : kForms) {
        OcclusionBuffer atOnce(form), inParts(form);
        drawAll(atOnce, *scene, kStandard);
        inParts.begin(kStandard);
        for (const auto part : {std::span(mesh.indices()).first(3 * kFirst), std::span(mesh.indices()).subspan(3 * kFirst)})
            inParts.draw(*scene, 0, Facing::TwoSided, mesh.positions(), part);
        EXPECT_EQ(atOnce.counts(), inParts.counts());
        EXPECT_EQ(atOnce.depths(), inParts.depths());
    }
}

TEST(OcclusionBuffer, maskedOneHas96BytesFor256Pixels) {
    const ScenePointer wall = sceneOf({squareMesh(2, -3)});
    const View view(kStandard.camera(), {1920, 1080});
    OcclusionBuffer masked(OcclusionForm::Masked), depth(OcclusionForm::Depth);
    drawAll(masked, *wall, view);
    drawAll(depth, *wall, view);
    EXPECT_EQ(masked.bytes(), 60u * 135u * 96u);
    EXPECT_LE(masked.bytes(), 779'000u);
    EXPECT_GT(depth.bytes(), 1920u * 1080u * 4u);
}

}  // namespace
}  // namespace cullscope::test::occlusion_buffer_test
