// Triangles that are left out one by one show nothing in the picture.
#include "core/visibility/sampled_triangles.h"

#include <cstdio>

#include "tests/support/lossless_views.h"
#include "tests/support/random_views.h"

namespace cullscope::test::sampled_triangles_test {
namespace {

/// What is found among all triangles of an object, in the mesh's order.
SampledTriangles::Found foundOf(const Scene& scene, uint32_t instance, const View& view, Facing facing,
                                SimdLevel level = bestSimdLevel()) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const CornerBlocks corners(mesh, mesh.indices());
    const PlaceRun all{0, uint32_t(mesh.triangleCount())};
    return SampledTriangles(scene, instance, corners, view, facing, level).among(std::span(&all, 1), true);
}

/// How many triangles were left out, and at how many pixels they show when they are drawn alone.
struct LeftOut {
    uint64_t facingAway = 0, withoutSample = 0, triangles = 0, shown = 0;

    void add(const SceneBuffers& buffers, const View& view, Facing facing) {
        const Scene& scene = buffers.scene();
        DrawList list{facing, {}};
        for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) {
            const SampledTriangles::Found found = foundOf(scene, instance, view, facing);
            uint64_t kept = 0, others = 0;
            for (const PlaceRun& run : found.kept) kept += run.count;
            for (const LeftOutTriangles::Run& run : found.leftOut) {
                list.ranges.push_back({instance, 3 * run.places.first, 3 * run.places.count});
                others += run.places.count;
            }
            EXPECT_EQ(others, found.facingAway + found.withoutSample);
            EXPECT_EQ(kept + others, scene.meshOf(instance).triangleCount());
            facingAway += found.facingAway;
            withoutSample += found.withoutSample;
        }
        triangles += scene.triangleCount();
        if (list.ranges.empty()) return;
        for (const float depth : picture(buffers, view, list).depth) shown += depth != 0.0f ? 1 : 0;
    }
};

TEST(SampledTriangles, thoseLeftOutOfAnyMeshShowNoPixel) {
    LeftOut sum;
    const std::vector<NamedMesh> meshes = losslessMeshes(longMode());
    const uint64_t scenes = howMany(2'000, 2 * meshes.size());
    for (uint64_t number = 0; number < scenes; ++number) {
        const NamedMesh& mesh = meshes[number % meshes.size()];
        const ScenePointer scene = sceneOf({mesh.mesh}, {placeOf(number)});
        const SceneBuffers buffers(scene, Upload::Vbo);
        Random random(number * 7919 + 1);
        for (const Kind kind : {Within, Within, Cutting, Touching, Behind, InSphere}) {
            const auto [camera, size] = randomView(scene->instanceSphere(0), kind, random);
            const View view(camera, size);
            const Facing facing = number % 3 == 0 ? Facing::TwoSided : number % 3 == 1 ? Facing::Front : Facing::ByObject;
            const uint64_t before = sum.shown;
            sum.add(buffers, view, facing);
            ASSERT_EQ(sum.shown, before) << mesh.name << " scene " << number << " kind " << kind;
        }
    }
    std::printf("long: sampled triangles: %llu of %llu left out facing away, %llu without a pixel centre\n",
                static_cast<unsigned long long>(sum.facingAway), static_cast<unsigned long long>(sum.triangles),
                static_cast<unsigned long long>(sum.withoutSample));
    EXPECT_GT(sum.facingAway, sum.triangles / 20) << "else this test could hardly fail";
    EXPECT_GT(sum.withoutSample, sum.triangles / 20);
}

TEST(SampledTriangles, thoseLeftOutInExtremeViewsShowNoPixel) {
    LeftOut sum;
    for (uint64_t seed = 1; seed <= howMany(5'000, 300); ++seed) {
        const ScenePointer scene = randomScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        Random random(seed);
        const certify::RandomView view = certify::randomView(*scene, random, certify::Sizes::UpTo1025);
        const uint64_t before = sum.shown;
        sum.add(buffers, View(view.camera, view.viewport), seed % 2 == 0 ? Facing::Front : Facing::TwoSided);
        ASSERT_EQ(sum.shown, before) << "seed " << seed;
    }
    EXPECT_GT(sum.facingAway, sum.triangles / 400);
    EXPECT_GT(sum.withoutSample, sum.triangles / 50);
}

TEST(SampledTriangles, everyInstructionSetFindsTheSame) {
    const ScenePointer scene = sceneOf({knotMesh(3'000)});
    Random random(5);
    for (const Kind kind : {Within, Cutting, Touching, InSphere}) {
        const auto [camera, size] = randomView(scene->instanceSphere(0), kind, random);
        const View view(camera, size);
        const SampledTriangles::Found scalar = foundOf(*scene, 0, view, Facing::Front, SimdLevel::Scalar);
        for (const SimdLevel level : availableSimdLevels()) {
            const SampledTriangles::Found found = foundOf(*scene, 0, view, Facing::Front, level);
            EXPECT_EQ(found.kept, scalar.kept) << simdLevelName(level);
            EXPECT_EQ(found.facingAway, scalar.facingAway);
        }
    }
}

/// A triangle with these corners in pixels, in a picture of 8 × 8 pixels of 1/4 unit each at the triangle.
SampledTriangles::Found ofPixels(const std::vector<Vec2>& corners, Facing facing) {
    std::vector<Vec3f> positions;
    for (const Vec2& corner : corners) positions.emplace_back(float(corner.x / 4 - 1), float(corner.y / 4 - 1), 0.0f);
    const ScenePointer scene = sceneOf({meshOf(positions, {0, 1, 2})});
    Camera camera{{0, 0, 1}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(90), 0.5, 10};
    return foundOf(*scene, 0, View(camera, {8, 8}), facing);
}

TEST(SampledTriangles, aTriangleIsLeftOutByItsCentresAndItsSide) {
    using Corners = std::vector<Vec2>;
    const Corners around{{3.1, 3.1}, {3.9, 3.1}, {3.5, 3.9}}, between{{3.6, 3.6}, {4.4, 3.6}, {4.0, 4.4}};
    const Corners beside{{3.1, 3.1}, {3.9, 3.1}, {3.1, 3.7}};  // its rectangle holds the centre (3.5, 3.5), it does not
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
        EXPECT_EQ(ofPixels(around, facing).kept.size(), 1u);
        EXPECT_EQ(ofPixels(between, facing).withoutSample, 1u);
        EXPECT_EQ(ofPixels(beside, facing).withoutSample, 1u);
    }
    const Corners back{around[0], around[2], around[1]};
    EXPECT_EQ(ofPixels(back, Facing::Front).facingAway, 1u);
    EXPECT_EQ(ofPixels(back, Facing::TwoSided).kept.size(), 1u);
    const Corners nearly{{3.1, 3.1}, {3.9, 3.1}, {3.1, 3.899}};  // the hypotenuse passes the centre within what snapping may move
    EXPECT_EQ(ofPixels(nearly, Facing::TwoSided).kept.size(), 1u);
}

}  // namespace
}  // namespace cullscope::test::sampled_triangles_test
