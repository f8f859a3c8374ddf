// Potentially visible sets against the picture of all objects: conservative sets lose no sample from anywhere in a cell; what
// sampled ones lose is little.

#include <cstdio>

#include "core/measure/accuracy.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/room_scene.h"

namespace cullscope::test::pvs_picture_test {
namespace {

CullerPointer pvsWith(const std::map<std::string, std::string>& settings) {
    ParameterSet parameters(findStrategy("pvs").info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    return makeCuller("pvs", parameters);
}

/// A view from a place in the scene's box; now and then one whose near plane cuts off much, or whose pixels are coarse.
View viewInside(const Scene& scene, Random& random) {
    const Box3& bounds = scene.bounds();
    Camera camera;
    const double x = random.unit(), y = random.unit(), z = random.unit();
    camera.eye = bounds.min + (bounds.max - bounds.min) * Vec3(x, y, z);
    camera.target = camera.eye + random.direction();
    camera.up = random.direction();
    camera.fovy = Angle::fromDegrees(random.between(20.0, 110.0));
    const double diagonal = bounds.diagonal();
    camera.nearDistance = diagonal * (random.unit() < 0.1 ? random.between(1e-3, 0.1) : std::exp(random.between(-9.7, -7.5)));
    camera.farDistance = diagonal * random.between(0.5, 3.0);
    const int width = 16 + int(random.bits() % 240), height = 16 + int(random.bits() % 160);
    return {camera, {width, height}};
}

struct Losses {
    uint64_t views = 0, covered = 0, hidden = 0, different = 0;
};

void look(const SceneBuffers& buffers, Culler& culler, const View& view, Losses& losses) {
    const Culled frame = culler.cull(view, &GlEnvironment::renderer());
    const std::vector<float> truth = picture(buffers, view, everything(buffers.scene(), frame.log.facing)).depth;
    const std::vector<float> shown = picture(buffers, view, frame.drawList).depth;
    ++losses.views;
    losses.hidden += frame.culledTriangles[size_t(Cause::Hidden)];
    for (size_t pixel = 0; pixel < truth.size(); ++pixel) {
        losses.covered += truth[pixel] > 0.0f ? 1 : 0;
        losses.different += truth[pixel] != shown[pixel] ? 1 : 0;
    }
}

std::string viewText(const View& view) {
    char text[400];
    const Camera& camera = view.camera();
    std::snprintf(text, sizeof text, "eye %.17g %.17g %.17g, target %.17g %.17g %.17g, fovy %g, near %g, %d x %d", camera.eye.x,
                  camera.eye.y, camera.eye.z, camera.target.x, camera.target.y, camera.target.z, camera.fovy.degrees(),
                  camera.nearDistance, view.viewport().width, view.viewport().height);
    return text;
}

const std::vector<std::map<std::string, std::string>> kConservative{
    {{"sets", "conservative"}, {"cells", "6"}, {"halvings", "2"}, {"rays", "300"}},
    // Without rays what is in a set is what could not be proven to be hidden.
    {{"sets", "conservative"}, {"cells", "9"}, {"halvings", "0"}, {"rays", "0"}},
    {{"sets", "conservative"}, {"cells", "6"}, {"halvings", "1"}, {"rays", "300"}, {"facing", "two-sided"}},
    // On closed slabs.
    {{"sets", "conservative"}, {"cells", "6"}, {"halvings", "1"}, {"rays", "300"}, {"facing", "front"}}};

TEST(PvsPicture, conservativeSetsLoseNoSampleFromAnywhereInACell) {
    Losses all;
    for (uint64_t seed = 1; seed <= howMany(12, 3); ++seed) {
        Random random(seed);
        const Vec3 origin = seed % 3 == 0 ? Vec3(1e6, -2e6, 5e5) : Vec3(0.0);
        const ScenePointer open = roomScene(3 + int(seed % 2), random, origin, seed % 2 == 0 ? 0.0 : 0.04);
        const ScenePointer closed = slabRoomScene(3 + int(seed % 2), random);
        for (const auto& settings : kConservative) {
            const ScenePointer& scene = settings.contains("facing") && settings.at("facing") == "front" ? closed : open;
            const SceneBuffers buffers(scene, Upload::Vbo);
            const CullerPointer culler = pvsWith(settings);
            culler->build(*scene);
            Losses losses;
            for (uint64_t i = 0; i < howMany(400, 60); ++i) {
                const View view = viewInside(*scene, random);
                const uint64_t before = losses.different;
                look(buffers, *culler, view, losses);
                ASSERT_EQ(losses.different, before)
                    << "seed " << seed << ", rays " << settings.at("rays") << ", " << viewText(view);
            }
            EXPECT_GT(losses.hidden, 0u) << "seed " << seed << ": nothing is hidden, so nothing is tested";
            all.views += losses.views;
            all.covered += losses.covered;
            all.hidden += losses.hidden;
        }
    }
    std::printf("%llu views, %llu covered pixels, %llu triangles left out as hidden\n", (unsigned long long)all.views,
                (unsigned long long)all.covered, (unsigned long long)all.hidden);
}

TEST(PvsPicture, conservativeSetsLoseNoSampleOfRandomScenes) {
    Random random(77);
    const auto anyView = [&](const Scene& scene) {
        const certify::RandomView view = certify::randomView(scene, random, certify::Sizes::UpTo1025);
        return View(view.camera, view.viewport);
    };
    for (uint64_t round = 0; round < howMany(60, 8); ++round) {
        const ScenePointer scene = randomScene(round);
        const SceneBuffers buffers(scene, Upload::Vbo);
        const CullerPointer culler = pvsWith({{"sets", "conservative"}, {"cells", "5"}, {"halvings", "1"}, {"rays", "50"}});
        culler->build(*scene);
        for (int i = 0; i < 12; ++i) {
            Losses losses;
            const View view = i % 2 == 0 ? viewInside(*scene, random) : anyView(*scene);
            look(buffers, *culler, view, losses);
            ASSERT_EQ(losses.different, 0u) << "round " << round << ", " << viewText(view);
        }
    }
}

TEST(PvsPicture, sampledSetsLoseLittle) {
    Random random(5);
    const ScenePointer scene = roomScene(4, random);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer few = pvsWith({{"rays", "20"}, {"neighbours", "false"}}), many = pvsWith({{"rays", "20000"}});
    few->build(*scene);
    many->build(*scene);
    Losses byFew, byMany;
    for (uint64_t i = 0; i < howMany(2000, 300); ++i) {
        const View view = viewInside(*scene, random);
        look(buffers, *few, view, byFew);
        look(buffers, *many, view, byMany);
    }
    EXPECT_GT(byMany.hidden, 0u);
    EXPECT_LE(double(byMany.different), 1e-4 * double(byMany.covered));
    EXPECT_GT(byFew.different, 100 * byMany.different) << "few rays lose much, so the views show losses";
}

}  // namespace
}  // namespace cullscope::test::pvs_picture_test
