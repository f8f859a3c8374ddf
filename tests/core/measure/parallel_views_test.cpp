// Parallel views: what is drawn there is right for every strategy, and what a strategy promises holds.

#include <cstdio>

#include "core/frame/named_parts.h"
#include "core/geometry/random.h"
#include "core/measure/accuracy.h"
#include "core/measure/meter.h"
#include "core/measure/render_frame.h"
#include "core/mesh/parametric.h"
#include "core/scene/eye_triangle.h"
#include "core/scene/scene_source.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::parallel_views_test {
namespace {

/// Objects of several sizes and shapes, some of them mirrored, flat or open.
ScenePointer crowd(uint64_t seed) {
    Random random(seed);
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    const int count = 6 + int(random.between(0, 30));
    for (int i = 0; i < count; ++i) {
        switch (int(random.between(0, 4))) {
            case 0:
                meshes.push_back(squareMesh(1, 0));
                break;
            case 1:
                meshes.push_back(torusMesh(200));
                break;
            case 2:
                meshes.push_back(starMesh(uint64_t(i), 200));
                break;
            default:
                meshes.push_back(boxMesh(Vec3f(-1), Vec3f(1)));
        }
        const Vec3 size(std::pow(10.0, random.between(-1.5, 0.4)), std::pow(10.0, random.between(-1.5, 0.4)),
                        random.between(0, 1) < 0.2 ? -0.5 : std::pow(10.0, random.between(-2.0, 0.4)));
        places.push_back(translation(random.direction() * random.between(0.0, 5.0)) * scaling(size));
    }
    return sceneOf(std::move(meshes), places);
}

/// From any side and at any scale: near planes that cut objects, far planes within them, heights from a part of an object to many
/// times the scene.
View viewOf(Random& random, const Scene& scene) {
    constexpr std::array kSizes{Viewport{96, 64}, Viewport{120, 90}, Viewport{33, 97}};
    const Sphere around = scene.boundingSphere();
    Camera camera;
    camera.eye = around.centre + around.radius * random.between(0.0, 3.0) * random.direction();
    camera.target = around.centre + around.radius * random.between(0.0, 0.6) * random.direction();
    camera.up = random.direction();
    camera.nearDistance = around.radius * std::pow(10.0, random.between(-3.0, 0.3));
    camera.farDistance = camera.nearDistance + around.radius * std::pow(10.0, random.between(-0.5, 3.0));
    camera.projection = ProjectionKind::Parallel;
    camera.height = around.radius * std::pow(10.0, random.between(-1.5, 1.0));
    return {camera, kSizes[size_t(random.between(0, double(kSizes.size())))]};
}

struct Drawn {
    BuiltStrategyPointer strategy;
    ViewStatePointer state;
};

std::vector<Drawn> allStrategies(const ScenePointer& scene, StructureStore& store) {
    std::vector<Drawn> all;
    for (const RegisteredStrategy& each : strategies()) {
        if (unavailable(each.info, GlEnvironment::info())) continue;
        const auto add = [&](const ParameterSet& parameters) {
            all.push_back({buildStrategy(each, parameters, scene, store), nullptr});
            all.back().state = all.back().strategy->begin();
        };
        add(ParameterSet(each.info.parameters));
        // Of those that decide by planes each way to do so.
        if (each.info.first(Show::Kind::Planes) == nullptr) continue;
        for (const ParameterDeclaration& declaration : each.info.parameters)
            for (const ParameterDeclaration::Choice& choice : declaration.choices) {
                ParameterSet parameters(each.info.parameters);
                parameters.setFromText(declaration.key, choice.id);
                add(parameters);
            }
    }
    return all;
}

std::string whereOf(const Drawn& drawn, const View& view) {
    return drawn.strategy->id() + " " + described(view.camera(), view.viewport()) + " height " +
           std::to_string(view.camera().height);
}

TEST(ParallelViews, whatPromisesToLoseNothingLosesNoPixel) {
    uint64_t frames = 0, covered = 0, culled = 0;
    for (uint64_t seed = 1; seed <= howMany(200, 24); ++seed) {
        const ScenePointer scene = crowd(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        StructureStore store;
        std::vector<Drawn> all = allStrategies(scene, store);
        Random random(seed * 104729);
        for (int number = 0; number < 6; ++number) {
            const View view = viewOf(random, *scene);
            for (Drawn& each : all) {
                if (each.strategy->promiseAt(view) == Promise::Approximate) continue;
                Framebuffer target(view.viewport());
                const FrameResult frame =
                    renderFrame(GlEnvironment::renderer(), buffers, *each.strategy, *each.state, view, target);
                const Reference reference =
                    itemBufferReference(GlEnvironment::renderer(), buffers, view, each.strategy->referenceFacing());
                const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, frame.log, reference, target);
                EXPECT_EQ(judged.lostPixels(), 0u) << "seed " << seed << " view " << number << ": " << whereOf(each, view);
                ++frames;
                covered += reference.coveredPixels;
                culled += scene->triangleCount() - judged.accuracy.submittedTriangles;
            }
        }
    }
    std::printf("long: parallel-views frames %llu covered %llu culled %llu\n", static_cast<unsigned long long>(frames),
                static_cast<unsigned long long>(covered), static_cast<unsigned long long>(culled));
    EXPECT_GT(covered, frames * 300) << "the views show next to nothing";
    EXPECT_GT(culled, frames * 100) << "next to nothing is culled";
}

TEST(ParallelViews, aStrategyThatNeedsAnEyeDrawsEverythingAndSaysSo) {
    const ScenePointer scene = crowd(3);
    StructureStore store;
    Camera camera;
    camera.projection = ProjectionKind::Parallel;
    camera.height = 0.5;
    size_t unservedOnes = 0;
    for (const RegisteredStrategy& each : strategies()) {
        if (!each.info.needsEyePoint) {
            // Without its file `recorded` decides nothing in any view.
            const std::optional<Message> reason = unserved(each.info, ParameterSet(each.info.parameters), camera);
            EXPECT_EQ(reason.has_value(), !each.info.decidesByFile.empty()) << each.info.id;
            if (reason) {
                EXPECT_NE(reason->english().find("parameter file"), std::string::npos) << reason->english();
            }
            continue;
        }
        ++unservedOnes;
        const BuiltStrategyPointer built = buildStrategy(each, ParameterSet(each.info.parameters), scene, store);
        const ViewStatePointer state = built->begin();
        const FrameLog log = built->decide(View(camera, {64, 48}), *state, true);
        EXPECT_EQ(log.consideredTriangles(), scene->triangleCount()) << each.info.id;
        EXPECT_EQ(built->promiseAt(View(camera, {64, 48})), Promise::Conservative) << each.info.id;
        const auto reason = built->unserved(camera);
        ASSERT_TRUE(reason) << each.info.id;
        EXPECT_NE(reason->english().find(each.info.id), std::string::npos);
        // What it declares to show is asked for without a crash, and says the same.
        (void)built->snapshot(log);
        (void)built->bars(log);
        (void)built->listing(log);
        (void)built->parts(log);
        for (const Show& show : each.info.shows) {
            if (show.absent == nullptr) continue;
            EXPECT_EQ(built->whyNotShown(show.id, {}, log)->english(), reason->english()) << each.info.id << " " << show.id;
        }
        EXPECT_FALSE(built->unserved(inPerspective(camera)));
    }
    EXPECT_GT(unservedOnes, 0u);
    EXPECT_LT(unservedOnes, strategies().size() / 2);
}

TEST(ParallelViews, aTriangleThatTheReferenceShowsOfFrontsTurnsItsFrontAlongTheViewDirection) {
    uint64_t shown = 0, away = 0;
    const uint64_t scenes = howMany(100, 12);
    for (uint64_t seed = 1; seed <= scenes; ++seed) {
        const ScenePointer scene = crowd(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        Random random(seed);
        for (int number = 0; number < 4; ++number) {
            const View view = viewOf(random, *scene);
            const Reference fronts = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::Front);
            const Reference both = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
            const auto facesAway = [&](uint32_t item) {
                const size_t instance = scene->instanceOf(item - 1);
                return InstanceFromEye(*scene, instance, view.camera()).facesAway(item - 1 - scene->firstTriangle(instance));
            };
            for (size_t pixel = 0; pixel < fronts.triangle.size(); ++pixel) {
                const uint32_t item = fronts.triangle[pixel];
                if (item != 0) {
                    ++shown;
                    EXPECT_FALSE(facesAway(item))
                        << "seed " << seed << " triangle " << item - 1 << "; " << described(view.camera(), view.viewport());
                }
                // A surface that only the two-sided picture shows here is a back.
                if (const uint32_t other = both.triangle[pixel]; other != 0 && both.depth[pixel] > fronts.depth[pixel]) {
                    ++away;
                    EXPECT_TRUE(facesAway(other))
                        << "seed " << seed << " triangle " << other - 1 << "; " << described(view.camera(), view.viewport());
                }
            }
        }
    }
    EXPECT_GT(shown, 5'000u);
    EXPECT_GT(away, 30u * scenes);
}

}  // namespace
}  // namespace cullscope::test::parallel_views_test
