// `spherical-lossless` loses no pixel of any mesh in any view.
#include <gmock/gmock.h>

#include <cstdio>

#include "core/scene/camera_path.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "tests/support/lossless_views.h"

namespace cullscope::test::lossless_picture_test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 480;
constexpr uint64_t kViewsPerScene = 10;
CullerPointer losslessBySeed(uint64_t seed) {
    constexpr std::array kFacings{"auto", "two-sided", "front", "auto"};
    constexpr std::array kLevels{"0", "0", "4", "6", "9"};
    return strategyWith("spherical-lossless", {{"facing", kFacings[seed % kFacings.size()]},
                                               {"layout", seed % 3 == 1 ? "latitude-longitude" : "octahedral"},
                                               {"level", kLevels[seed % kLevels.size()]}});
}

std::string wordsOf(const Culler& strategy, const char* mesh, uint64_t seed) {
    return std::string(mesh) + " seed " + std::to_string(seed) + " facing " + strategy.parameters().choice("facing") +
           " layout " + strategy.parameters().choice("layout") + " level " + toText(strategy.parameters().value("level"));
}

TEST(LosslessPicture, noMeshLosesAPixel) {
    LosslessProperty property;
    uint64_t withHorizon = 0;
    const std::vector<NamedMesh> meshes = losslessMeshes(longMode());
    // A small sample of fewer than 200 views has not every kind of them.
    const uint64_t views = std::max<uint64_t>(howMany(kAllViews, kSample), 200);
    for (uint64_t first = 0, number = 0; first < views; first += kViewsPerScene, ++number) {
        const NamedMesh& mesh = meshes[number % meshes.size()];
        const uint64_t seed = 100 + number / meshes.size() + number % meshes.size() * 7;
        const ScenePointer scene = sceneOf({mesh.mesh}, {placeOf(seed)});
        const SceneBuffers buffers(scene, Upload::Vbo);
        const CullerPointer strategy = losslessBySeed(number + 5 * (number / meshes.size()));
        strategy->build(*scene);
        ASSERT_EQ(strategy->promise(), Promise::Conservative);
        Random random(seed * 7919);
        for (uint64_t view = 0; view < kViewsPerScene; ++view) {
            // Kinds in which cones and horizon can cull something occur twice.
            constexpr std::array kKinds{Within, Cutting, Touching, Behind, InSphere, AtCentre, Within, Cutting};
            const Kind kind = kKinds[(view + number) % kKinds.size()];
            property.check(*strategy, buffers, randomView(scene->instanceSphere(0), kind, random), kind,
                           wordsOf(*strategy, mesh.name, seed) + " view " + std::to_string(view));
            for (const spherical::SphericalDecision& decision : spherical::decisionsOf(property.log()))
                withHorizon += decision.walk && decision.walk->hiding ? 1 : 0;
        }
    }
    const Tally& t = property.tally();
    const auto share = [&](Cause cause) { return 100.0 * double(t.culled[size_t(cause)]) / double(t.triangles); };
    std::printf(
        "long: spherical-lossless views %llu covered %llu outside %.1f%% back-facing %.1f%% hidden %.1f%% missed %llu extra "
        "%llu\n",
        static_cast<unsigned long long>(t.views), static_cast<unsigned long long>(t.covered), share(Cause::OutsideFrustum),
        share(Cause::BackFacing), share(Cause::Hidden), static_cast<unsigned long long>(t.missed),
        static_cast<unsigned long long>(t.extra));
    // llvmpipe decides the facing of a sliver that its snapping flips by whether another triangle of the same batch is clipped:
    // drawing all triangles in another order gives as many differences. Each was explained above.
    EXPECT_LT(t.extra, 1 + t.covered / 1'000'000);
    // Guards against a vacuous pass: enough pixels must be covered.
    EXPECT_GT(t.covered, t.views * 1000);
    for (const Kind kind : {Within, Cutting, Touching, InSphere, AtCentre}) EXPECT_GT(t.coveredByKind[kind], t.views / 2);
    EXPECT_GT(share(Cause::OutsideFrustum), 10.0);
    EXPECT_GT(share(Cause::BackFacing), 2.0);
    EXPECT_GT(share(Cause::Hidden), 0.1);
    EXPECT_GT(t.withCones, t.views / 10);
    EXPECT_GT(withHorizon, t.views / 40);
}

// What explains an extra pixel above: sides of 3, 4 and 5 pixels have an inscribed circle of radius 1.
TEST(LosslessPicture, sliverIsToldByItsInscribedCircle) {
    const auto radiusOf = [](const std::vector<Vec3f>& corners) {
        const ScenePointer scene = sceneOf({meshOf(corners, {0, 1, 2})});
        const Camera camera{{0, 0, 1}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(90), 0.1, 10};
        return PixelEdges(*scene, camera, {100, 100}).inscribedRadius(0);
    };
    EXPECT_NEAR(radiusOf({{0, 0, 0}, {0.06f, 0, 0}, {0, 0.08f, 0}}), 1.0, 1e-5);
    EXPECT_LT(radiusOf({{0, 0, 0}, {0.5f, 0, 0}, {0.25f, 1e-4f, 0}}), kGrid);
    EXPECT_EQ(radiusOf({{0, 0, 2}, {0.06f, 0, 2}, {0, 0.08f, 2}}), 0.0) << "behind the eye";
}

uint64_t missedOf(const ScenePointer& scene, const std::vector<Camera>& cameras, const Viewport& size,
                  const std::vector<std::pair<const char*, const char*>>& parameters, uint64_t& covered) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = strategyWith("spherical-lossless", parameters);
    strategy->build(*scene);
    uint64_t missed = 0;
    for (const Camera& camera : cameras) {
        const View view(camera, size);
        const DrawList list = strategy->cull(view).drawList;
        const Reference reference = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy->referenceFacing());
        const Accuracy accuracy = compare(reference, {picture(buffers, view, list).depth, {}}, list, *scene);
        missed += accuracy.missedPixels;
        covered += accuracy.coveredPixels;
    }
    return missed;
}

void expectNothingLostOf(const ScenePointer& scene) {
    std::vector<Camera> cameras;
    for (const char* name : {"walk:6", "fibonacci:4"}) {
        const CameraPath path = cameraPath(name, *scene);
        for (size_t pose = 0; pose < path.poses.size(); ++pose) cameras.push_back(path.camera(pose));
    }
    uint64_t covered = 0;
    EXPECT_EQ(missedOf(scene, cameras, {240, 180}, {}, covered), 0u) << scene->name();
    EXPECT_GT(covered, 10'000u);
}

TEST(LosslessPicture, fieldOfManyObjectsLosesNoPixel) {
    const int side = fewSamples() ? 10 : 20;
    std::vector<Mat4> field;
    for (int i = 0; i < side * side; ++i)
        field.push_back(translation(2.5 * Vec3(i % side - 0.5 * (side - 1), 0.0, i / side - 0.5 * (side - 1))));
    expectNothingLostOf(copiesOf(bumpyMesh(4, longMode() ? 5'000 : 1'500, 0.3), field));
}

/// 114 open and closed objects of four kinds that stand in each other, like the walls and towers of the castle.
ScenePointer courtyard() {
    const std::vector<MeshPointer> kinds{boxMesh(Vec3f(-1.0f), Vec3f(1.0f)), bowlMesh(1'200), knotMesh(1'600),
                                         bumpyMesh(4, 1'500, 0.3)};
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int i = 0; i < 114; ++i) {
        meshes.push_back(kinds[size_t(i) % kinds.size()]);
        places.push_back(translation({1.6 * (i % 12 - 5.5), 0.4 * (i % 5), 1.6 * (i / 12 - 4.5)}));
    }
    return sceneOf(meshes, places);
}

TEST(LosslessPicture, castleOfManyObjectsLosesNoPixel) {
    const std::string castle = CULLSCOPE_SOURCE_DIR "/../shared/models/scenes/intel-castle-occluders-114obj.obj";
    // The castle's file is not part of this repository: where it is missing, a scene of its kind is judged.
    expectNothingLostOf(std::filesystem::exists(castle) ? openScene(castle).scene : courtyard());
}

TEST(LosslessPicture, openAndClosedObjectsThatCutEachOtherLoseNoPixel) { expectNothingLostOf(courtyard()); }

}  // namespace
}  // namespace cullscope::test::lossless_picture_test
