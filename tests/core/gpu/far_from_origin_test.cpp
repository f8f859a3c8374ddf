#include <cstdio>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/pixel_edges.h"
#include "tests/support/test_scenes.h"

// Case 21: the whole scene moved by (1e7, −1e7, 1e7), by its instances' transforms and by the meshes' own coordinates.

namespace cullscope::test::far_from_origin_test {
namespace {

constexpr Vec3 kFar(1e7, -1e7, 1e7);

std::vector<MeshPointer> meshes() { return {knotMesh(3000), starMesh(7, 2000), torusMesh(1000), teapotMesh(2000)}; }

const std::vector<Mat4>& places() {
    static const std::vector<Mat4> kPlaces{Mat4(1.0), translation({3, 0, -2}), translation({-3, .5, -1}) * scaling({-1, 1, 1}),
                                           translation({0, -2, 2}) * scaling(Vec3(.3))};
    return kPlaces;
}

ScenePointer atOrigin() { return sceneOf(meshes(), places()); }

ScenePointer movedByTransforms() {
    std::vector<Mat4> moved;
    for (const Mat4& place : places()) moved.push_back(translation(kFar) * place);
    return sceneOf(meshes(), moved);
}

/// Moved by the coordinates: each mesh has an origin of its own there, about which it is rotated and scaled.
ScenePointer movedByOrigins() {
    std::vector<MeshPointer> moved;
    for (const MeshPointer& mesh : meshes()) moved.push_back(withOrigin(*mesh, kFar));
    std::vector<Mat4> around;
    for (Mat4 place : places()) {
        place[3] += Vec4(kFar - Mat3(place) * kFar, 0.0);
        around.push_back(place);
    }
    return sceneOf(std::move(moved), around);
}

/// Views whose numbers are multiples of 2^-20, so that moving eye and target is exact.
std::vector<Camera> cameras(size_t count) {
    Random random(21);
    const auto rounded = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
    std::vector<Camera> cameras;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 eye = random.direction() * random.between(2, 12);
        const Vec3 target = random.direction();
        cameras.push_back({{rounded(eye.x), rounded(eye.y), rounded(eye.z)},
                           {rounded(target.x), rounded(target.y), rounded(target.z)},
                           {0, 1, 0},
                           Angle::fromDegrees(random.between(20, 100)),
                           0.05,
                           100});
    }
    return cameras;
}

Camera moved(Camera camera) {
    camera.eye += kFar;
    camera.target += kFar;
    return camera;
}

class FarFromOrigin : public testing::TestWithParam<ScenePointer (*)()> {};

TEST_P(FarFromOrigin, case21PictureIsTheSameAwayFromEdges) {
    const ScenePointer near = atOrigin();
    const ScenePointer far = GetParam()();
    const SceneBuffers nearBuffers(near, Upload::Vbo);
    const SceneBuffers farBuffers(far, Upload::Vbo);
    const Viewport size{320, 240};
    uint64_t pixels = 0, different = 0, failures = 0;
    const std::vector<Camera> views = cameras(longMode() ? 100 : 10);
    for (const Camera& camera : views)
        for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
            const auto a = GlEnvironment::renderer().drawItemBuffer(nearBuffers, View(camera, size), everything(*near, facing));
            const auto b =
                GlEnvironment::renderer().drawItemBuffer(farBuffers, View(moved(camera), size), everything(*far, facing));
            const PixelEdges edges(*near, camera, size);
            for (size_t pixel = 0; pixel < a.triangle.size(); ++pixel) {
                pixels += a.triangle[pixel] != 0 ? 1 : 0;
                if (a.triangle[pixel] == b.triangle[pixel]) {
                    ASSERT_NEAR(a.depth[pixel], b.depth[pixel], 1e-4 * a.depth[pixel]) << "the same triangle elsewhere";
                    continue;
                }
                ++different;
                double nearest = 1e9;
                for (const uint32_t triangle : {a.triangle[pixel], b.triangle[pixel]})
                    if (triangle != 0) nearest = std::min(nearest, edges.toEdgeOf(triangle - 1, pixel));
                if (nearest <= kEdgePixels) continue;
                if (++failures <= 5)
                    ADD_FAILURE() << "pixel " << pixel % 320 << "," << pixel / 320 << " triangle " << a.triangle[pixel]
                                  << " at the origin, " << b.triangle[pixel] << " far away; nearest edge " << nearest;
            }
        }
    std::printf("long: far-from-origin views %zu pixels %llu different %llu failures %llu\n", 2 * views.size(),
                static_cast<unsigned long long>(pixels), static_cast<unsigned long long>(different),
                static_cast<unsigned long long>(failures));
    EXPECT_EQ(failures, 0u);
    EXPECT_GT(pixels, 10'000u * views.size());
}

TEST_P(FarFromOrigin, case21FrustumDrawsTheSameObjects) {
    const ScenePointer near = atOrigin();
    const ScenePointer far = GetParam()();
    for (const char* id : {"all", "frustum"}) {
        const CullerPointer here = makeCuller(id);
        const CullerPointer there = makeCuller(id);
        here->build(*near);
        there->build(*far);
        for (const Camera& camera : cameras(200))
            EXPECT_EQ(here->cull(View(camera, {320, 240})).drawList.ranges,
                      there->cull(View(moved(camera), {320, 240})).drawList.ranges);
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, FarFromOrigin, testing::Values(movedByTransforms, movedByOrigins),
                         [](const auto& way) { return way.param == &movedByTransforms ? "byTransforms" : "byOrigins"; });

}  // namespace
}  // namespace cullscope::test::far_from_origin_test
