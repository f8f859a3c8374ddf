#include "core/gpu/renderer.h"

#include <sys/resource.h>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/peak_memory.h"
#include "tests/support/pixel_edges.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::renderer_test {
namespace {

View lookingAt(const Vec3& eye, const Vec3& target, Viewport size = {160, 120}, double nearDistance = 0.05,
               double farDistance = 100) {
    return {{eye, target, {0, 1, 0}, Angle::fromDegrees(45), nearDistance, farDistance}, size};
}

size_t covered(const std::vector<float>& depth) { return depth.size() - size_t(std::count(depth.begin(), depth.end(), 0.0f)); }

TEST(Renderer, case18NearerOfTwoDistantSurfacesWins) {
    // Near 0.01, far 1e6, squares at 1000 and 1000.01: reversed float depth separates them, in both drawing orders.
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.01, 1e6}, {64, 64});
    const ScenePointer scene = sceneOf({squareMesh(1000, -1000.0f), squareMesh(1000, -1000.01f)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    DrawList list = everything(*scene, Facing::TwoSided);
    for (int order = 0; order < 2; ++order) {
        const Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, list);
        EXPECT_THAT(items.triangle, testing::Each(testing::AnyOf(1u, 2u))) << "order " << order;
        std::reverse(list.ranges.begin(), list.ranges.end());
    }
}

TEST(Renderer, depthGivesTheDistance) {
    const View view = lookingAt({0, 0, 0}, {0, 0, -1}, {64, 48}, 0.1, 1000);
    for (const float distance : {0.125f, 1.0f, 7.0f, 900.0f}) {
        const ScenePointer scene = sceneOf({squareMesh(10 * distance, -distance)});
        for (const float depth : picture(scene, view, Facing::TwoSided).depth)
            ASSERT_NEAR(view.distanceFromDepth(depth), distance, 1e-5 * distance);
    }
}

TEST(Renderer, surfaceOutsideNearAndFarIsNotDrawn) {
    const View view = lookingAt({0, 0, 0}, {0, 0, -1}, {16, 16}, 1, 10);
    EXPECT_EQ(covered(picture(sceneOf({squareMesh(100, -0.999f)}), view, Facing::TwoSided).depth), 0u);
    EXPECT_EQ(covered(picture(sceneOf({squareMesh(100, -10.01f)}), view, Facing::TwoSided).depth), 0u);
    EXPECT_EQ(covered(picture(sceneOf({squareMesh(100, -1.001f)}), view, Facing::TwoSided).depth), 256u);
    EXPECT_EQ(covered(picture(sceneOf({squareMesh(100, -9.99f)}), view, Facing::TwoSided).depth), 256u);
}

TEST(Renderer, backFaceIsDrawnOnlyWhereBothSidesAre) {
    const ScenePointer square = sceneOf({squareMesh(1, 0)});
    EXPECT_GT(covered(picture(square, lookingAt({0, 0, 3}, {0, 0, 0}), Facing::Front).depth), 0u);
    EXPECT_EQ(covered(picture(square, lookingAt({0, 0, -3}, {0, 0, 0}), Facing::Front).depth), 0u);
    EXPECT_GT(covered(picture(square, lookingAt({0, 0, -3}, {0, 0, 0}), Facing::TwoSided).depth), 0u);
}

TEST(Renderer, aSectionShowsExactlyWhatLiesOnTheKeptSideOfItsPlane) {
    const ScenePointer scene = sceneOf({knotMesh(3000), boxMesh(Vec3f(-1), Vec3f(1)), starMesh(3, 800)},
                                       {Mat4(1.0), translation({1.5, 0, 0}) * scaling({-0.5, 0.8, 1}), translation({0, 1.2, 0})});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Random random(11);
    uint64_t kept = 0, cut = 0, snapped = 0;
    for (int i = 0; i < 40; ++i) {
        Camera camera{4.0 * random.direction(), 0.3 * random.direction(), {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100};
        if (i % 3 == 0) camera = inParallel(camera);
        View view(camera, {96, 72});
        const View whole = view;
        const Vec3 normal = random.direction();
        const Plane plane{normal, -glm::dot(normal, random.direction())};
        view.cutBy(plane);
        const DrawList list = everything(*scene, Facing::TwoSided);
        const auto all = GlEnvironment::renderer().drawItemBuffer(buffers, whole, list);
        const auto shown = GlEnvironment::renderer().drawItemBuffer(buffers, view, list);
        EXPECT_EQ(picture(buffers, view, list).depth, shown.depth) << "the picture and the item buffer are cut alike";
        const auto sideOf = [&](float depth, size_t pixel) {
            const double x = double(pixel % 96) + 0.5, y = double(pixel / 96) + 0.5;
            return plane.distance(view.pointAt(x, y, view.distanceFromDepth(double(depth))));
        };
        for (size_t pixel = 0; pixel < all.depth.size(); ++pixel) {
            if (shown.triangle[pixel] != 0)
                EXPECT_GT(sideOf(shown.depth[pixel], pixel), -1e-3) << i << ": shows what is cut away";
            if (all.triangle[pixel] == 0) {
                EXPECT_EQ(shown.triangle[pixel], 0u);
                continue;
            }
            const double side = sideOf(all.depth[pixel], pixel);
            if (std::abs(side) < 1e-2) continue;
            (side > 0.0 ? kept : cut) += 1;
            // A surface in front that is kept stays in front; one that is cut away is not shown, but what lies behind. At an edge
            // of a triangle that is cut the raster snaps anew.
            if (side > 0.0)
                snapped += shown.triangle[pixel] == all.triangle[pixel] ? 0 : 1;
            else
                EXPECT_LT(shown.depth[pixel], all.depth[pixel]) << i << " pixel " << pixel;
        }
        // Front faces alone are no obstacle: a section shows the insides.
        EXPECT_EQ(picture(buffers, view, everything(*scene, Facing::Front)).depth, shown.depth);
    }
    EXPECT_GT(kept, 5000u);
    EXPECT_GT(cut, 5000u);
    EXPECT_LT(snapped, kept / 1000);
}

// A software OpenGL gets small ranges gathered into one; indices have 16 bits in the small meshes and 32 in the large one.
TEST(Renderer, rangesOfAnySizeGiveTheWhole) {
    const View view = lookingAt({0, 0, 6}, Vec3(0.0));
    for (const size_t triangles : {size_t{3000}, size_t{200'000}}) {
        const ScenePointer scene = copiesOf(knotMesh(triangles), {Mat4(1.0), translation({0.5, 0.4, 0})});
        const SceneBuffers buffers(scene, Upload::Vbo);
        const DrawList whole = everything(*scene, Facing::Front);
        const Picture truth = picture(buffers, view, whole);
        const auto items = [&](const DrawList& list) {
            return GlEnvironment::renderer().drawItemBuffer(buffers, view, list).triangle;
        };
        for (const uint32_t size : {30u, 300u, 1500u}) {
            DrawList parts{Facing::Front, {}};
            for (const DrawRange& range : whole.ranges)
                for (uint32_t first = 0; first < range.indexCount; first += size)
                    parts.ranges.push_back({range.instance, first, std::min(size, range.indexCount - first)});
            ASSERT_GT(parts.ranges.size(), 10u);
            EXPECT_EQ(picture(buffers, view, parts), truth) << size / 3 << " triangles a range";
            if (triangles == 3000) {
                EXPECT_EQ(items(parts), items(whole)) << size / 3 << " triangles a range";
            }
        }
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(Renderer, onlyRangesOfTheListAreDrawn) {
    const ScenePointer scene = sceneOf({squareMesh(10, -5)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view = lookingAt({0, 0, 0}, {0, 0, -1});
    const Picture half = picture(buffers, view, {Facing::TwoSided, {{0, 3, 3}}});
    EXPECT_GT(covered(half.depth), half.depth.size() / 3);
    EXPECT_LT(covered(half.depth), half.depth.size() * 2 / 3);
    const Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, {Facing::TwoSided, {{0, 3, 3}}});
    EXPECT_THAT(items.triangle, testing::Each(testing::AnyOf(0u, 2u))) << "numbers count in the scene, not in the range";
    EXPECT_EQ(covered(picture(buffers, view, {}).depth), 0u);
}

TEST(Renderer, vertexArraysDrawTheSamePicturesAsBuffers) {
    if (!GlEnvironment::info().compatibilityProfile)
        FAIL() << "no compatibility profile: the listed Mesa has one (LIBGL_ALWAYS_SOFTWARE=1)";
    const ScenePointer scene = sceneOf({knotMesh(3000), teapotMesh(2000), starMesh(7, 2000)},
                                       {Mat4(1.0), translation({3, 0, 0}), translation({-3, 0, 0}) * scaling({-1, 1, .4})});
    const View view = lookingAt({1, 2, 9}, Vec3(0.0));
    for (const Facing facing : {Facing::TwoSided, Facing::Front})
        EXPECT_EQ(picture(scene, view, facing, Upload::VertexArray), picture(scene, view, facing, Upload::Vbo));
    const SceneBuffers client(scene, Upload::VertexArray);
    const SceneBuffers buffer(scene, Upload::Vbo);
    const DrawList list = everything(*scene, Facing::TwoSided);
    Renderer& renderer = GlEnvironment::renderer();
    EXPECT_EQ(renderer.drawItemBuffer(client, view, list).triangle, renderer.drawItemBuffer(buffer, view, list).triangle);
}

TEST(Renderer, sceneWithoutTrianglesOrWithAnEmptyMeshIsDrawn) {
    const View view = lookingAt({0, 0, 0}, {0, 0, -1});
    EXPECT_EQ(covered(picture(std::make_shared<Scene>("empty", std::vector<MeshPointer>{}, std::vector<Instance>{}), view,
                              Facing::Front)
                          .depth),
              0u);
    const ScenePointer scene = sceneOf({meshOf({{0, 0, 0}}, {}), squareMesh(10, -5)});
    EXPECT_EQ(covered(picture(scene, view, Facing::Front).depth), 160u * 120u);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// Counts the pixels at which front faces alone show another colour than both sides, away from the edges of the visible surface.
uint64_t lostBesideEdges(const ScenePointer& scene, const Camera& camera, const Viewport& size, uint64_t& pixels) {
    const View view(camera, size);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Renderer::ItemBuffer both =
        GlEnvironment::renderer().drawItemBuffer(buffers, view, everything(*scene, Facing::TwoSided));
    const std::vector<float> front = picture(buffers, view, everything(*scene, Facing::Front)).depth;
    pixels += covered(both.depth);
    const PixelEdges edges(*scene, camera, size);
    uint64_t lost = 0;
    for (size_t pixel = 0; pixel < front.size(); ++pixel)
        if (front[pixel] != both.depth[pixel] && edges.toEdgeOf(both.triangle[pixel] - 1, pixel) > kEdgePixels) ++lost;
    return lost;
}

TEST(Renderer, case30MirroredOrFlattenedInstanceLosesNoFrontFace) {
    uint64_t pixels = 0;
    const std::vector<MeshPointer> meshes{sphereMesh(2000), torusMesh(2000), knotMesh(4000), starMesh(7, 2000)};
    for (const Vec3& scale :
         {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, 1, .1), Vec3(-1, 1, .1), Vec3(-1, -1, 1), Vec3(-1, -1, -1), Vec3(-3, .01, 1)})
        for (const MeshPointer& mesh : meshes)
            for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(.5, .7, -.3), Vec3(-1, .01, 0)}) {
                const ScenePointer scene = sceneOf({mesh}, {translation({3, -2, 1}) * scaling(scale)});
                const Vec3 target(3, -2, 1);
                const Camera camera{target + glm::normalize(direction) * (4.0 * std::max(1.0, std::abs(scale.x))),
                                    target,
                                    {0, 1, 0},
                                    Angle::fromDegrees(45),
                                    0.05,
                                    100};
                EXPECT_EQ(lostBesideEdges(scene, camera, {160, 120}, pixels), 0u)
                    << mesh->name() << " scaled by " << scale.x << "," << scale.y << "," << scale.z << " from " << direction.x
                    << "," << direction.y;
            }
    EXPECT_GT(pixels, 100'000u);
}

TEST(Renderer, mirroredInstanceIsLitLikeItsMirrorImage) {
    // Looking down −z at a body mirrored in x: the mirror image of the picture, up to rounding of colours and snapping at edges.
    const MeshPointer star = starMesh(7, 4000);
    const Viewport size{120, 120};
    const View view = lookingAt({0, 0, 4}, Vec3(0.0), size);
    const Picture plain = picture(sceneOf({star}), view, Facing::Front);
    const Picture mirrored = picture(sceneOf({star}, {scaling({-1, 1, 1})}), view, Facing::Front);
    size_t different = 0;
    for (size_t y = 0; y < 120; ++y)
        for (size_t x = 0; x < 120; ++x) {
            const int a = plain.colour[4 * (y * 120 + x)];
            const int b = mirrored.colour[4 * (y * 120 + 119 - x)];
            if (std::abs(a - b) > 3) ++different;
        }
    EXPECT_LT(different, 120u * 120u / 200);
}

/// Pages that this process has been given by the system so far.
long pageFaults() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

TEST(Renderer, aSoftwareOpenGlFindsTheMemoryOfTheLastFrameAgain) {
    if (!memoryIsTheWorks() || !GlEnvironment::info().software) return;
    // Shaded, its vertices take some ten megabytes, 2,500 pages a frame.
    const ScenePointer scene = sceneOf({knotMesh(200'000)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const DrawList list = everything(*scene, Facing::Front);
    const View view = lookingAt({0, 0, 4}, {0, 0, 0});
    Framebuffer target(view.viewport());
    const auto draw = [&](int frames) {
        for (int i = 0; i < frames; ++i) GlEnvironment::renderer().draw(buffers, view, list, target);
        waitForGpu();
    };
    draw(3);
    const long before = pageFaults();
    constexpr int kFrames = 20;
    draw(kFrames);
    EXPECT_LT((pageFaults() - before) / kFrames, 100);
}

}  // namespace
}  // namespace cullscope::test::renderer_test
