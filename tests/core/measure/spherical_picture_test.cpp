// The pixels that the spherical strategies lose: none with spherical-horizon on star-shaped meshes, and the known losses with
// `spherical`.
#include <gmock/gmock.h>

#include <cstdio>

#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/scene/camera_path.h"
#include "core/scene/frustum_share.h"
#include "core/scene/scene_source.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::spherical_picture_test {
namespace {

constexpr uint64_t kAllViews = 5'000;
constexpr uint64_t kSample = 250;
constexpr uint64_t kViewsPerScene = 10;

Accuracy accuracyOf(Culler& strategy, const SceneBuffers& buffers, const View& view, const Culled& frame) {
    const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy.referenceFacing());
    ShownPixels shown{picture(buffers, view, frame.drawList).depth, {}};
    Accuracy accuracy = compare(reference, shown, frame.drawList, buffers.scene());
    if (accuracy.extraPixels == 0) return accuracy;
    // Snapping may turn a sliver's front into its back. Mesa decides before or after it, by what else lies in the same batch of
    // vertices: alone, such a triangle is drawn, and among others it is not.
    const Reference bothSides = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    shown.triangle.resize(shown.depth.size());
    accuracy.extraPixels = 0;
    for (size_t pixel = 0; pixel < shown.depth.size(); ++pixel) {
        if (shown.depth[pixel] == bothSides.depth[pixel]) shown.triangle[pixel] = bothSides.triangle[pixel];
        const bool extra = pixelDifference(reference.depth[pixel], shown.depth[pixel]) == PixelDifference::Extra;
        if (extra && shown.triangle[pixel] == 0) ++accuracy.extraPixels;
    }
    accuracy.extraPixels += extraBeyondSnapping(reference, shown, buffers.scene(), view);
    return accuracy;
}

Accuracy accuracyOf(Culler& strategy, const SceneBuffers& buffers, const View& view) {
    return accuracyOf(strategy, buffers, view, strategy.cull(view));
}

MeshPointer starShaped(uint64_t seed) {
    switch (seed % 6) {
        case 0:
            return starMesh(seed, 4'000);
        case 1:
            return sphereMesh(3'000);
        case 2:
            return boxMesh({-1, -0.3f, -0.7f}, {0.9f, 0.4f, 0.8f});
        case 3:
            return bumpyMesh(seed, 5'000, 0.15);
        case 4:
            return bumpyMesh(seed, 20'000, 0.5);
        default:
            return starMesh(seed, 20'000);
    }
}

/// One to three objects, rotated, unevenly scaled and mirrored; some far from the origin.
ScenePointer starScene(uint64_t seed) {
    Random random(seed * 31 + 5);
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    const Vec3 home = seed % 7 == 3 ? Vec3(1e6, -1e6, 1e6) : Vec3(0.0);
    const auto objects = size_t(random.between(1.0, 3.99));
    for (size_t i = 0; i < objects; ++i) {
        meshes.push_back(starShaped(seed + i));
        const Vec3 axis = random.direction();
        const double angle = random.between(0.0, 6.0);
        Vec3 size(1.0);
        if (seed % 3 == 1)
            for (int c = 0; c < 3; ++c) size[c] = random.between(0.3, 2.0);
        if (seed % 4 == 2) size.x = -size.x;
        const Vec3 aside = 4.0 * random.direction() * double(i);
        places.push_back(translation(home + aside) * rotation(axis, angle) * scaling(size));
    }
    return sceneOf(std::move(meshes), places);
}

/// A view from just outside an object's bounding sphere up to far away, of the whole object or a part of it.
std::pair<Camera, Viewport> starView(const Scene& scene, Random& random) {
    const auto object = size_t(random.between(0.0, double(scene.instances().size()) - 1e-9));
    const Sphere& sphere = scene.instanceSphere(object);
    Camera camera;
    const double distance = sphere.radius * (1.0 + std::pow(10.0, random.between(-2.0, 1.3)));
    camera.eye = sphere.centre + random.direction() * distance;
    camera.target = sphere.centre + random.direction() * (sphere.radius * random.unit() * random.unit());
    camera.up = random.direction();
    const double whole = 2.0 * std::asin(std::min(1.0, sphere.radius / distance)) * 180.0 / std::numbers::pi;
    camera.fovy = Angle::fromDegrees(std::clamp(whole * random.between(0.1, 1.6), 0.5, 150.0));
    camera.nearDistance = random.unit() < 0.2 ? distance : std::max(distance - 1.02 * sphere.radius, 1e-3 * distance) * 0.9;
    camera.farDistance = distance * 10.0;
    return {camera, {int(random.between(40.0, 200.0)), int(random.between(40.0, 160.0))}};
}

struct Tally {
    uint64_t views = 0, cut = 0, within = 0, around = 0, covered = 0, culled = 0, triangles = 0, missed = 0;
};

class HorizonPicture {
public:
    void run(uint64_t views) {
        for (uint64_t first = 0; first < views; first += kViewsPerScene) runScene(2000 + first / kViewsPerScene);
    }
    void runScene(uint64_t seed) {
        const ScenePointer scene = starScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        const CullerPointer strategy = strategyWith("spherical-horizon", {{"rows", seed % 2 == 0 ? "90" : "0"}});
        strategy->build(*scene);
        ASSERT_EQ(strategy->promise(), Promise::Conservative) << "seed " << seed;
        Random random(seed * 7919);
        for (uint64_t view = 0; view < kViewsPerScene; ++view) check(*strategy, buffers, starView(*scene, random), seed, view);
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    void check(Culler& strategy, const SceneBuffers& buffers, const std::pair<Camera, Viewport>& random, uint64_t seed,
               uint64_t number) {
        const View view(random.first, random.second);
        const Culled frame = strategy.cull(view, Recording::On);
        ++m_tally.views;
        for (const spherical::SphericalDecision& decision : spherical::decisionsOf(frame.log)) {
            m_tally.cut += decision.relation == spherical::SphereRelation::Cut ? 1 : 0;
            m_tally.within += decision.relation == spherical::SphereRelation::Within ? 1 : 0;
            m_tally.around += decision.relation == spherical::SphereRelation::AroundEye ? 1 : 0;
        }
        m_tally.culled += frame.culledTriangles[size_t(Cause::Hidden)];
        m_tally.triangles += buffers.scene().triangleCount();
        const Accuracy accuracy = accuracyOf(strategy, buffers, view, frame);
        m_tally.covered += accuracy.coveredPixels;
        m_tally.missed += accuracy.missedPixels;
        EXPECT_EQ(accuracy.missedPixels + accuracy.extraPixels, 0u)
            << "pixels lost: scene seed " << seed << " view " << number << "; " << described(random.first, random.second);
    }

    Tally m_tally;
};

TEST(SphericalPicture, horizonLosesNoPixelOfAStarShapedMesh) {
    HorizonPicture property;
    property.run(howMany(kAllViews, kSample));
    property.runScene(2453);  // a sliver at an outline, whose front is drawn alone and dropped among others
    const Tally& t = property.tally();
    std::printf("long: spherical-horizon views %llu cut %llu within %llu around %llu covered %llu hidden %.1f%% missed %llu\n",
                static_cast<unsigned long long>(t.views), static_cast<unsigned long long>(t.cut),
                static_cast<unsigned long long>(t.within), static_cast<unsigned long long>(t.around),
                static_cast<unsigned long long>(t.covered), 100.0 * double(t.culled) / double(t.triangles),
                static_cast<unsigned long long>(t.missed));
    // Guards against a vacuous pass: enough objects must be cut by the frustum.
    EXPECT_GT(t.cut, t.views / 3);
    EXPECT_GT(t.within, t.views / 10);
    EXPECT_GT(t.covered, t.views * 1000);
    EXPECT_GT(double(t.culled), 0.12 * double(t.triangles));
}

/// The share of covered pixels that are lost over a path.
double lossOver(const char* strategyId, const ScenePointer& scene, const std::vector<Camera>& cameras,
                const std::vector<std::pair<const char*, const char*>>& parameters = {}) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = strategyWith(strategyId, parameters);
    strategy->build(*scene);
    uint64_t missed = 0, covered = 0;
    for (const Camera& camera : cameras) {
        const Accuracy accuracy = accuracyOf(*strategy, buffers, View(camera, {240, 240}));
        missed += accuracy.missedPixels;
        covered += accuracy.coveredPixels;
    }
    return double(missed) / double(covered);
}

Camera from(const Vec3& eye, double fovy, const Vec3& up = {0, 1, 0.1}) {
    return {eye, Vec3(0.0), up, Angle::fromDegrees(fovy), 0.1, 1000};
}

TEST(SphericalPicture, knownLossesOfSAndSlopeAreUnchanged) {
    // Case 16: a torus (1, 0.25) whose axis is tilted by 60° from the sight line, far away, and a thick bowl seen into its
    // opening. These losses are expected; the test detects a change.
    const ScenePointer torus = sceneOf({torusMesh(40'000)}, {rotation({1, 0, 0}, std::numbers::pi / 6)});
    const ScenePointer bowl = sceneOf({bowlMesh(60'000)});
    const std::vector<Camera> far{from({0, 0, 40}, 6)}, into{from({0, 0, 6}, 25)};
    const double torusByS = lossOver("spherical", torus, far), torusBySlope = lossOver("spherical-horizon", torus, far);
    const double bowlByS = lossOver("spherical", bowl, into), bowlBySlope = lossOver("spherical-horizon", bowl, into);
    std::printf("long: spherical loss torus %.1f%% bowl %.1f%%; spherical-horizon torus %.1f%% bowl %.1f%%\n", 100 * torusByS,
                100 * bowlByS, 100 * torusBySlope, 100 * bowlBySlope);
    EXPECT_NEAR(torusByS, 0.17, 0.04);
    EXPECT_GT(bowlByS, 0.8);
    EXPECT_GT(bowlBySlope, 0.2);
}

TEST(SphericalPicture, lossAtHighLatitudesIsOfSphericalAlone) {
    // Case 12 in pixels: `spherical` loses pixels, spherical-horizon none.
    const ScenePointer scene = sceneOf({sphereMesh(40'000)});
    const auto at = [](double degrees) {
        const double latitude = degrees * std::numbers::pi / 180.0;
        return from(3.0 * Vec3(std::cos(latitude), 0.0, std::sin(latitude)), 20.0, {0, 0.01, 1});
    };
    EXPECT_GT(lossOver("spherical", scene, {at(60)}), 0.15);
    EXPECT_LT(lossOver("spherical", scene, {at(60)}, {{"joined", "arcs"}}), 0.1);
    for (const double latitude : {0.0, 45.0, 60.0, 75.0, 90.0})
        EXPECT_EQ(lossOver("spherical-horizon", scene, {at(latitude)}), 0.0) << latitude;
}

TEST(SphericalPicture, whereNoCornerRayHitsItLosesWhatItsBandsLose) {
    // An orbit at 45 degrees from 1.6 to 2.7 radii: the frustum cuts the bounding sphere, and the four rays pass the object by.
    const bool bunny = std::filesystem::exists(CULLSCOPE_SOURCE_DIR "/../shared/models/bunny.obj") && !fewSamples();
    const ScenePointer scene = bunny ? openScene("mesh:bunny").scene : sceneOf({bumpyMesh(4, 20'000, 0.3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer text = makeCuller("spherical"), appendix = strategyWith("spherical", {{"branch", "appendix"}});
    text->build(*scene);
    appendix->build(*scene);
    const Sphere& around = scene->boundingSphere();
    Random random(2008);
    uint64_t missed = 0, missedByAppendix = 0, covered = 0, views = 0;
    for (uint64_t i = 0; i < howMany(240, 24); ++i) {
        const Vec3 eye = around.centre + random.between(1.6, 2.7) * around.radius * random.direction();
        const View view(
            {eye, around.centre, random.direction(), Angle::fromDegrees(45), 0.05 * around.radius, 10 * around.radius},
            {640, 480});
        const spherical::SphericalDecision decision = spherical::decisionsOf(text->cull(view, Recording::On).log).at(0);
        if (std::ranges::any_of(decision.rays, [](const spherical::CornerRay& ray) { return ray.hit.has_value(); })) continue;
        ASSERT_TRUE(decision.bands);
        ++views;
        const Accuracy own = accuracyOf(*text, buffers, view);
        missed += own.missedPixels;
        covered += own.coveredPixels;
        missedByAppendix += accuracyOf(*appendix, buffers, view).missedPixels;
    }
    std::printf("long: spherical without hits views %llu missed %llu by the appendix %llu of %llu pixels\n",
                static_cast<unsigned long long>(views), static_cast<unsigned long long>(missed),
                static_cast<unsigned long long>(missedByAppendix), static_cast<unsigned long long>(covered));
    EXPECT_GT(views, fewSamples() ? 3u : 15u);
    EXPECT_LE(double(missed), 0.06 * double(covered));
    EXPECT_GT(missedByAppendix, missed) << "Appendix 1 makes corners of rays that miss";
}

TEST(SphericalPicture, pathsShowThePapersCases) {
    const std::string file = CULLSCOPE_SOURCE_DIR "/../shared/models/bunny.obj";
    // Without the bunny's file, and for a small sample, a body of its proportions is used.
    const bool bunny = std::filesystem::exists(file) && !fewSamples();
    const std::string faces = fewSamples() ? "20000" : "144046";
    const ScenePointer scene = bunny ? openScene("mesh:" + file + ",triangles=" + faces).scene
                                     : sceneOf({bumpyMesh(4, std::stoul(faces), 0.03)}, {scaling({1.2, 1.0, 0.9})});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    const std::array<double, 3> considered{13508.0 / 144078.0, 16434.0 / 144078.0, 26308.0 / 144078.0};
    for (int number = 1; number <= 3; ++number) {
        const CameraPath path = cameraPath("case-" + std::to_string(number), *scene);
        ASSERT_GE(path.poses.size(), 10u);
        for (size_t pose = 0; pose < path.poses.size(); pose += longMode() ? 1 : 5) {
            const View view(path.camera(pose), {320, 240});
            const Culled frame = strategy->cull(view, Recording::On);
            const auto inFrustum = double(trianglesInFrustum(*scene, view));
            const std::string where = path.name + " pose " + std::to_string(pose);
            EXPECT_EQ(frame.caseNumber, number) << where;
            EXPECT_NEAR(inFrustum / double(scene->triangleCount()) / considered[size_t(number - 1)], 1.0, 0.1) << where;
            EXPECT_LE(double(frame.consideredTriangles), 1.5 * inFrustum) << where;
            EXPECT_GT(frame.consideredTriangles, 0u) << where;
            const spherical::SphericalDecision decision = spherical::decisionsOf(frame.log).at(0);
            for (const spherical::CornerRay& ray : decision.rays) EXPECT_TRUE(ray.hit.has_value()) << where;
            const Accuracy accuracy = accuracyOf(*strategy, buffers, view);
            EXPECT_GE(accuracy.coveredPixels, 320u * 240u * 6 / 10) << where;
        }
    }
}

TEST(SphericalPicture, upsideOfAnInstanceIsLookedUpInTheMeshsOwnAxes) {
    // The case depends on the map, not on the world: a rotated instance has its pole in another direction.
    const ScenePointer scene = sceneOf({sphereMesh(20'000)}, {rotation({1, 0, 0}, std::numbers::pi / 2) * scaling({2, 2, -2})});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    EXPECT_EQ(strategy->cull(View(from({0, 6, 0.01}, 20), {64, 64})).caseNumber, 1);
    EXPECT_EQ(strategy->cull(View(from({0, 0, 6}, 20), {64, 64})).caseNumber, 2);
    EXPECT_EQ(strategy->cull(View(from({6, 0, 0}, 20), {64, 64})).caseNumber, 3);
}

}  // namespace
}  // namespace cullscope::test::spherical_picture_test
