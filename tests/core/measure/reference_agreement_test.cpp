#include <cmath>
#include <cstdio>

#include "core/geometry/random.h"
#include "core/measure/accuracy.h"
#include "core/measure/ray_reference.h"
#include "core/measure/reference.h"
#include "core/mesh/parametric.h"
#include "core/scene/scene_source.h"
#include "tests/support/gl_environment.h"
#include "tests/support/pixel_edges.h"
#include "tests/support/test_scenes.h"

// The item buffer against Embree's rays. They share no code, so what both agree on is taken as correct. They agree at a pixel
// where their depths differ by no more than a shift of 1/256 pixel (the raster's snapping) and float's rounding of a depth
// explain, or where neither hits a triangle. Where they differ, the nearer of the two results is a triangle that the other did
// not hit: the pixel's centre must then lie within 1/128 pixel of an edge of that triangle. Two surfaces nearer to each other
// than the tolerance count as an agreement.

namespace cullscope::test::reference_agreement_test {
namespace {

const Viewport kSize{320, 240};

struct Tally {
    uint64_t views = 0, covered = 0, pixels = 0, disagreements = 0, failures = 0;
    double worstShare = 0.0;  ///< of a view's covered pixels
};

class Comparison {
public:
    Comparison(std::string name, ScenePointer scene)
        : m_name(std::move(name)), m_scene(std::move(scene)), m_buffers(m_scene, Upload::Vbo) {}

    void compare(const Camera& camera, Facing facing) {
        const View view(camera, kSize);
        const Reference items = itemBufferReference(GlEnvironment::renderer(), m_buffers, view, facing);
        const RayReference rays = rayReference(*m_scene, view, facing);
        const PixelEdges edges(*m_scene, camera, kSize);
        uint64_t disagreements = 0;
        for (size_t pixel = 0; pixel < items.depth.size(); ++pixel) {
            if (agree(items, rays, pixel, camera.projection)) continue;
            ++disagreements;
            const bool itemNearer = double(items.depth[pixel]) > rays.depth[pixel];
            const uint32_t nearer = itemNearer ? items.triangle[pixel] : rays.triangle[pixel];
            const double edge = nearer == 0 ? INFINITY : edges.toEdgeOf(nearer - 1, pixel);
            if (edge > kEdgePixels) report(camera, facing, pixel, items, rays, edge);
        }
        EXPECT_GT(items.coveredPixels, 1000u) << m_name << ": nothing to compare; " << described(camera);
        const double share = double(disagreements) / double(std::max(items.coveredPixels, uint64_t{1}));
        EXPECT_LE(share, 0.001) << m_name << ": " << described(camera);
        ++m_tally.views;
        m_tally.covered += items.coveredPixels;
        m_tally.pixels += items.depth.size();
        m_tally.disagreements += disagreements;
        m_tally.worstShare = std::max(m_tally.worstShare, share);
    }

    void print() const {
        std::printf(
            "long: reference-agreement %s views %llu covered-pixels %llu disagreeing %llu (worst view %.5f of its covered "
            "pixels) unexplained %llu\n",
            m_name.c_str(), static_cast<unsigned long long>(m_tally.views), static_cast<unsigned long long>(m_tally.covered),
            static_cast<unsigned long long>(m_tally.disagreements), m_tally.worstShare,
            static_cast<unsigned long long>(m_tally.failures));
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    static bool agree(const Reference& items, const RayReference& rays, size_t pixel, ProjectionKind projection) {
        const bool item = items.triangle[pixel] != 0;
        const bool ray = rays.triangle[pixel] != 0;
        if (!item || !ray) return item == ray;
        const double snapping = rays.depthPerPixel[pixel] / 256.0;
        const double rounding =
            0x1p-20 * std::abs(rays.depth[pixel]) + 0x1p-22 * rays.depthPerPixel[pixel] * std::max(kSize.width, kSize.height);
        // In a parallel view the depth is rounded as a number near 1, however small it is.
        const double ofRange = projection == ProjectionKind::Parallel ? 0x1p-22 : 0.0;
        return std::abs(double(items.depth[pixel]) - rays.depth[pixel]) <= snapping + rounding + ofRange;
    }

    static std::string described(const Camera& camera) {
        std::array<char, 400> text{};
        std::snprintf(text.data(), text.size(),
                      "eye (%.17g, %.17g, %.17g) target (%.17g, %.17g, %.17g) fovy %.17g rad near %.17g far %.17g", camera.eye.x,
                      camera.eye.y, camera.eye.z, camera.target.x, camera.target.y, camera.target.z, camera.fovy.radians(),
                      camera.nearDistance, camera.farDistance);
        return text.data();
    }

    void report(const Camera& camera, Facing facing, size_t pixel, const Reference& items, const RayReference& rays,
                double edge) {
        if (++m_tally.failures > 5) return;
        const auto width = static_cast<size_t>(kSize.width);
        ADD_FAILURE() << m_name
                      << (facing == Facing::Front      ? " front"
                          : facing == Facing::TwoSided ? " two-sided"
                                                       : " by object")
                      << " pixel " << pixel % width << "," << pixel / width << ": item buffer triangle " << items.triangle[pixel]
                      << " depth " << items.depth[pixel] << ", rays triangle " << rays.triangle[pixel] << " depth "
                      << rays.depth[pixel] << " per pixel " << rays.depthPerPixel[pixel]
                      << "; nearest edge of the nearer triangle " << edge << " px; " << described(camera);
    }

    std::string m_name;
    ScenePointer m_scene;
    SceneBuffers m_buffers;
    Tally m_tally;
};

/// Views from all sides of a scene.
std::vector<Camera> around(const Scene& scene, size_t count, uint64_t seed) {
    Random random(seed);
    const Sphere sphere = scene.boundingSphere();
    std::vector<Camera> cameras;
    for (size_t i = 0; i < count; ++i) {
        Camera camera;
        camera.eye = sphere.centre + random.direction() * (sphere.radius * random.between(1.5, 3.0));
        camera.target = sphere.centre + random.direction() * (0.2 * sphere.radius);
        camera.up = random.direction();
        camera.fovy = Angle::fromDegrees(random.between(20, 60));
        camera.nearDistance = 0.01 * sphere.radius;
        camera.farDistance = 100 * sphere.radius;
        cameras.push_back(camera);
    }
    return cameras;
}

void compareAround(const std::string& name, const ScenePointer& scene, size_t views, size_t allViews) {
    Comparison comparison(name, scene);
    for (const Camera& camera : around(*scene, longMode() ? allViews : views, 51))
        for (const Facing facing : {Facing::TwoSided, Facing::Front, Facing::ByObject}) comparison.compare(camera, facing);
    comparison.print();
}

TEST(ReferenceAgreement, holdsForSolids) {
    compareAround("knot", sceneOf({knotMesh(20000)}), 3, 40);
    compareAround("torus", sceneOf({torusMesh(5000)}), 3, 40);
    compareAround("star", sceneOf({starMesh(7, 10000)}), 3, 40);
    compareAround("sphere-fine", sceneOf({sphereMesh(200000)}), 1, 10);
}

TEST(ReferenceAgreement, holdsInParallelViews) {
    for (const auto& [name, scene] : {std::pair<const char*, ScenePointer>{"knot-parallel", sceneOf({knotMesh(20000)})},
                                      {"instances-parallel", sceneOf({starMesh(7, 3000), torusMesh(2000)},
                                                                     {scaling({-1, 1, 1}), translation({2.5, 0, 0})})}}) {
        Comparison comparison(name, scene);
        for (Camera camera : around(*scene, longMode() ? 40 : 4, 54)) {
            camera = inParallel(camera);
            camera.farDistance = 0.1 * camera.farDistance;
            for (const Facing facing : {Facing::TwoSided, Facing::Front, Facing::ByObject}) comparison.compare(camera, facing);
        }
        comparison.print();
    }
}

TEST(ReferenceAgreement, holdsForTheTeapot) { compareAround("teapot", sceneOf({teapotMesh(20000)}), 3, 40); }

TEST(ReferenceAgreement, holdsForTheBunny) {
    ASSERT_TRUE(findBunny({}).has_value()) << "glmark2-data is in packaging/packages.txt and not installed";
    compareAround("bunny", openScene("bunny").scene, 3, 40);
}

/// llvmpipe covers a pixel of this view with a needle in the order in which a whole mesh is drawn, and not in the order in which
/// triangles are numbered.
TEST(ItemBuffer, aPixelHasADepthWhereItHasATriangle) {
    ASSERT_TRUE(findBunny({}).has_value()) << "glmark2-data is in packaging/packages.txt and not installed";
    const ScenePointer scene = openScene("mesh:bunny,triangles=144046").scene;
    const Vec3 target(6.744265556335449e-05, 0.00033026933670043945, 9.655952453613281e-06);
    Camera camera{Vec3(1.950444382579561, 3.525426392674593, 9.655952453613281e-06), target, {0, 1, 0}};
    camera.fovy = Angle::fromDegrees(9.99461242673982);
    camera.nearDistance = 0.013428937612715781;
    camera.farDistance = 134.28937612715782;
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer renderer;
    for (const Facing facing : {Facing::Front, Facing::TwoSided}) {
        const Renderer::ItemBuffer items = renderer.drawItemBuffer(buffers, View(camera, {640, 480}), everything(*scene, facing));
        for (size_t pixel = 0; pixel < items.depth.size(); ++pixel)
            EXPECT_EQ(items.depth[pixel] > 0.0F, items.triangle[pixel] > 0) << pixel << " " << int(facing);
    }
}

TEST(ReferenceAgreement, holdsForMirroredAndFlattenedInstances) {
    compareAround("instances",
                  sceneOf({starMesh(7, 3000), knotMesh(3000), torusMesh(2000), teapotMesh(3000)},
                          {scaling({-1, 1, 1}), translation({2.5, 0, 0}) * scaling({1, 1, .1}),
                           translation({-2.5, 0, 0}) * scaling({1, -2, .5}), translation({0, 3, 0}) * scaling(Vec3(-.4))}),
                  4, 40);
}

ScenePointer boxField() {
    Random random(52);
    std::vector<MeshPointer> boxes;
    for (int i = 0; i < 200; ++i) {
        const Vec3 centre = random.direction() * (10.0 * std::cbrt(random.unit()));
        const Vec3 half(random.between(0.02, 0.8), random.between(0.02, 0.8), random.between(0.02, 0.8));
        boxes.push_back(boxMesh(Vec3f(centre - half), Vec3f(centre + half)));
    }
    return sceneOf(std::move(boxes));
}

TEST(ReferenceAgreement, holdsForAFieldOfBoxesThatCutEachOther) { compareAround("boxes", boxField(), 4, 40); }

TEST(ReferenceAgreement, holdsForSurfacesCutByTheNearPlane) {
    // From inside: the eye near or inside objects, the near plane through some of them.
    for (const auto& [name, scene] :
         {std::pair<const char*, ScenePointer>{"boxes-within", boxField()}, {"knot-within", sceneOf({knotMesh(20000)})}}) {
        Comparison comparison(name, scene);
        Random random(53);
        const Sphere sphere = scene->boundingSphere();
        for (size_t i = 0; i < (longMode() ? 60u : 6u); ++i) {
            Camera camera;
            camera.eye = sphere.centre + random.direction() * (0.7 * sphere.radius * random.unit());
            camera.target = sphere.centre + random.direction() * (0.1 * sphere.radius);
            camera.fovy = Angle::fromDegrees(random.between(50, 100));
            camera.nearDistance = sphere.radius * random.between(0.02, 0.3);
            camera.farDistance = sphere.radius * random.between(1.0, 5.0);
            for (const Facing facing : {Facing::TwoSided, Facing::Front, Facing::ByObject}) comparison.compare(camera, facing);
        }
        comparison.print();
    }
}

TEST(ReferenceAgreement, holdsFarFromTheOrigin) {
    const Vec3 far(1e7, -1e7, 1e7);
    compareAround("far-by-transform",
                  sceneOf({knotMesh(5000), starMesh(7, 3000)}, {translation(far), translation(far + Vec3(2, 0, 1))}), 2, 20);
    compareAround("far-by-origin",
                  sceneOf({withOrigin(*knotMesh(5000), far), withOrigin(*starMesh(7, 3000), far + Vec3(2, 0, 1))}), 2, 20);
}

TEST(ReferenceAgreement, holdsForTinyAndHugeScenes) {
    // Case 20: at either scale alone no digits are lost.
    for (const double scale : {1e-18, 1e-6, 1e6, 1e18})
        compareAround("scale-" + std::to_string(int(std::round(std::log10(scale)))),
                      sceneOf({knotMesh(5000)}, {scaling(Vec3(scale))}), 1, 10);
}

TEST(RayReference, stopIsAnswered) {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    const ScenePointer scene = sceneOf({squareMesh(1, -5)});
    EXPECT_ANY_THROW((void)rayReference(*scene, View({Vec3(0.0), {0, 0, -1}}, kSize), Facing::TwoSided, progress));
}

TEST(RayReference, emptySceneHasNoSurfaces) {
    const Scene scene("empty", {}, {});
    const RayReference rays = rayReference(scene, View({Vec3(0.0), {0, 0, -1}}, kSize), Facing::Front);
    EXPECT_EQ(rays.coveredPixels, 0u);
    EXPECT_THAT(rays.triangle, testing::Each(0u));
}

}  // namespace
}  // namespace cullscope::test::reference_agreement_test
