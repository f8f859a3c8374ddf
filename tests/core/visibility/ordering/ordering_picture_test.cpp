// Pictures drawn by order against the GPU's depth buffer: equal away from edges and from depths that it does not resolve.

#include <algorithm>
#include <array>
#include <set>

#include "core/measure/accuracy.h"
#include "core/mesh/parametric.h"
#include "core/scene/scene_source.h"
#include "core/spatial/bsp_tree.h"
#include "tests/support/culler.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/gl_environment.h"
#include "tests/support/picture_differences.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::ordering_picture_test {
namespace {

constexpr Viewport kSize{160, 120};

CullerPointer strategy(const char* id, const std::vector<std::pair<const char*, const char*>>& values) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    for (const auto& [key, value] : values) parameters.setFromText(key, value);
    return makeCuller(id, parameters);
}

/// The pixels of a frame that nothing explains (tests/support/picture_differences.h).
uint64_t unexplained(const SceneBuffers& buffers, const View& view, const FrameLog& log, const Reference& truth,
                     uint64_t* differing) {
    Framebuffer target(view.viewport());
    const PictureDifferences found =
        pictureDifferences(buffers.scene(), view, truth, shownPixels(GlEnvironment::renderer(), buffers, log, target), log);
    *differing += found.pixels;
    if (found.unexplained > 0) {
        std::printf("%s", found.first.c_str());
        for (const NamedFigure& figure : log.counters.figures) std::printf("%s %g ", figure.name.c_str(), figure.value);
    }
    return found.unexplained;
}

uint64_t unexplained(Culler& culler, const SceneBuffers& buffers, const View& view, uint64_t* differing) {
    const Culled frame = culler.cull(view);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, culler.referenceFacing());
    return unexplained(buffers, view, frame.log, truth, differing);
}

View outside(Random& random) {
    const double distance = random.between(2.5, 4.0);
    return {{distance * random.direction(), 0.3 * random.direction(), random.direction(), Angle::fromDegrees(45), 0.05, 100},
            kSize};
}
View within(Random& random) {
    const Vec3 eye = 0.6 * random.direction();
    return {{eye, eye + random.direction(), random.direction(), Angle::fromDegrees(70), 0.05, 100}, kSize};
}

TEST(OrderingPicture, isThatOfTheDepthBufferOnScenesThatAreHardToOrder) {
    const std::vector<std::pair<std::string, CullerPointer>> contestants = [] {
        std::vector<std::pair<std::string, CullerPointer>> result;
        result.emplace_back("painter", strategy("painter", {}));
        for (const char* plane : {"first", "fewest", "balance"})
            result.emplace_back(std::string("bsp ") + plane, strategy("bsp", {{"plane", plane}}));
        result.emplace_back("bsp front to back", strategy("bsp", {{"order", "front-to-back"}}));
        return result;
    }();
    uint64_t differing = 0, cuts = 0;
    for (uint64_t seed = 0; seed < howMany(200, 200); ++seed) {
        const ScenePointer scene = hardScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        Random random(seed);
        const View views[] = {outside(random), within(random)};
        for (const auto& [name, culler] : contestants) {
            culler->build(*scene);
            for (const View& view : views) {
                EXPECT_EQ(unexplained(*culler, buffers, view, &differing), 0u)
                    << name << " seed " << seed << (&view == views ? " from outside" : " from within");
            }
            for (const auto& figure : culler->structure().figures)
                if (figure.name == "cuts") cuts += uint64_t(figure.value);
        }
    }
    EXPECT_GT(cuts, 1000u);
    RecordProperty("differing_pixels", int(differing));
}

TEST(OrderingPicture, barsInACycleAreCutAndRight) {
    const ScenePointer scene = sceneOf({threeBars()});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view({{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
    for (const char* id : {"painter", "bsp"}) {
        const CullerPointer culler = strategy(id, {});
        culler->build(*scene);
        uint64_t differing = 0;
        EXPECT_EQ(unexplained(*culler, buffers, view, &differing), 0u) << id;
        EXPECT_GT(culler->cull(view).consideredTriangles, scene->triangleCount()) << id << " cuts nothing";
    }
    const CullerPointer naive = strategy("painter", {{"sort", "centroid"}});
    naive->build(*scene);
    uint64_t differing = 0;
    EXPECT_GT(unexplained(*naive, buffers, view, &differing), 20u) << "centroids alone get the cycle wrong";
    EXPECT_EQ(naive->promise(), Promise::Approximate);
}

TEST(OrderingPicture, closedMeshesShowNoGaps) {
    // Cut edges of neighbours have their corners in common: the background never shows through.
    const ScenePointer scene = sceneOf({knotMesh(3000), starMesh(7, 1500)}, {Mat4(1.0), translation({0.8, 0.2, 0.3})});
    const SceneBuffers buffers(scene, Upload::Vbo);
    for (const char* id : {"painter", "bsp"}) {
        const CullerPointer culler = strategy(id, {});
        culler->build(*scene);
        Random random(4);
        uint64_t differing = 0;
        for (uint64_t i = 0; i < howMany(40, 8); ++i) {
            EXPECT_EQ(unexplained(*culler, buffers, outside(random), &differing), 0u) << id << " view " << i;
        }
        RecordProperty(std::string(id) + "_differing_pixels", int(differing));
    }
}

/// Expects that neither method loses a pixel of a scene, as the meter counts them, nor shows one that nothing explains. Returns
/// how many pixels differ from the depth buffer's, of both.
uint64_t expectNothingLost(const ScenePointer& scene, const std::vector<View>& views) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    uint64_t differing = 0;
    for (const char* id : {"painter", "bsp"}) {
        const CullerPointer culler = strategy(id, {{"facing", "two-sided"}});
        culler->build(*scene);
        for (size_t i = 0; i < views.size(); ++i) {
            const View& view = views[i];
            const FrameLog log = culler->cull(view).log;
            const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
            Framebuffer target(view.viewport());
            EXPECT_EQ(judge(GlEnvironment::renderer(), buffers, log, truth, target).lostPixels(), 0u) << id << " view " << i;
            EXPECT_EQ(unexplained(buffers, view, log, truth, &differing), 0u) << id << " view " << i;
        }
    }
    return differing;
}

TEST(OrderingPicture, sliversAmongLargeTrianglesLoseNothing) {
    uint64_t differing = 0;
    for (const float width : {1e-7f, 1e-5f})
        for (uint64_t seed = 0; seed < howMany(60, 15); ++seed) {
            SCOPED_TRACE("width " + std::to_string(width) + ", seed " + std::to_string(seed));
            const ScenePointer scene = sliversAmongTriangles(seed, width);
            Random random(seed);
            std::vector<View> views;
            for (int i = 0; i < 4; ++i) {
                const Vec3 eye = random.between(2.5, 4.0) * random.direction();
                const Camera camera{eye, 0.3 * random.direction(), random.direction(), Angle::fromDegrees(45), 0.05, 100};
                views.emplace_back(camera, Viewport{320, 240});
            }
            differing += expectNothingLost(scene, views);
        }
    RecordProperty("differing_pixels", int(differing));
}

TEST(OrderingPicture, manyPolygonsInOnePlaneLoseNothingAtAnySize) {
    uint64_t differing = 0;
    for (uint64_t seed = 0; seed < howMany(40, 10); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        std::vector<Vec3f> corners;
        for (int i = 0; i < 3 * 60; ++i) corners.emplace_back(random.between(-1, 1), random.between(-1, 1), 0.25f);
        std::vector<View> views;
        for (int i = 0; i < (fewSamples() ? 4 : 8); ++i) {
            const bool level = i % 2 == 0;  // on a walk along the plane, else from anywhere
            const Vec3 walker(random.between(-.5, .5), 0.0, random.between(0.4, 1.5));
            const Vec3 eye = level ? walker : random.between(1.5, 4.0) * random.direction();
            const Vec3 target = level ? eye + Vec3(random.between(-1, 1), 0.0, -1.0) : 0.3 * random.direction();
            const Camera camera{eye, target, {0, 1, 0}, Angle::fromDegrees(45), 0.005, 10};
            views.emplace_back(camera, i % 4 < 2 ? Viewport{33, 97} : Viewport{160, 121});
        }
        differing += expectNothingLost(sceneOf({soupMesh(std::move(corners))}), views);
    }
    EXPECT_GT(differing, 100u) << "OpenGL's depths of one plane differ by more than none";
}

TEST(OrderingPicture, wrongOrderOfSteepParallelPlanesIsFound) {
    // Two floors seen at a flat angle, one below the other by a ten-thousandth of the eye's height: in depth that is less than
    // the slope of either over 1/128 pixel.
    std::vector<Vec3f> corners;
    for (const float y : {-0.1f, -0.10001f}) {
        const Vec3f a(-5, y, -1), b(5, y, -1), c(5, y, -9), d(-5, y, -9);
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
    const ScenePointer scene = sceneOf({soupMesh(std::move(corners))});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(20), 0.1, 100}, kSize);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    for (const char* id : {"painter", "bsp"}) {
        const CullerPointer culler = strategy(id, {{"facing", "two-sided"}});
        culler->build(*scene);
        FrameLog log = culler->cull(view).log;
        uint64_t differing = 0;
        EXPECT_EQ(unexplained(buffers, view, log, truth, &differing), 0u) << id;
        auto wrong = std::make_shared<OwnTriangles>(*std::get<OwnTrianglesPointer>(log.commands.front()));
        ASSERT_EQ(wrong->runs.size(), 1u);
        std::ranges::reverse(wrong->positions);
        std::ranges::reverse(wrong->normals);
        std::ranges::reverse(wrong->triangles);
        log.commands.front() = OwnTrianglesPointer(wrong);
        EXPECT_GT(2 * unexplained(buffers, view, log, truth, &differing), truth.coveredPixels) << id;
    }
}

/// What a frame draws, whatever its order: of each own triangle its number and corners.
std::vector<std::array<float, 10>> drawnParts(const FrameLog& log) {
    const OwnTriangles& own = *std::get<OwnTrianglesPointer>(log.commands.front());
    std::vector<std::array<float, 10>> parts(own.triangles.size());
    for (size_t i = 0; i < parts.size(); ++i) {
        parts[i][0] = float(own.triangles[i]);
        for (size_t corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) parts[i][1 + 3 * corner + size_t(axis)] = own.positions[3 * i + corner][axis];
    }
    std::ranges::sort(parts);
    return parts;
}

TEST(OrderingPicture, treeIsTheSameWhereverTheEyeIsAndOnlyItsOrderChanges) {
    const ScenePointer scene = sceneOf({randomTriangles(8, howMany(10'000, 1'500), 0.2)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer culler = strategy("bsp", {});
    culler->build(*scene);
    Random random(6);
    uint64_t differing = 0;
    std::vector<std::array<float, 10>> first;
    std::set<std::vector<uint32_t>> orders;
    const uint64_t views = howMany(1'000, 40);
    for (uint64_t i = 0; i < views; ++i) {
        const View view = i % 2 == 0 ? outside(random) : within(random);
        const FrameLog log = culler->cull(view).log;
        const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, culler->referenceFacing());
        ASSERT_EQ(unexplained(buffers, view, log, truth, &differing), 0u) << "view " << i;
        if (i == 0) first = drawnParts(log);
        ASSERT_TRUE(drawnParts(log) == first) << "another tree in view " << i;
        if (i < 10) orders.insert(std::get<OwnTrianglesPointer>(log.commands.front())->triangles);
    }
    EXPECT_EQ(orders.size(), 10u);
}

TEST(OrderingPicture, treeOfTheBunnyIsDrawnRightFromAnyEye) {
    const ScenePointer scene = fewSamples() ? sceneOf({bumpyMesh(3, 5'000, 0.4)}) : openScene("mesh:bunny").scene;
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer culler = strategy("bsp", {{"plane", "fewest"}});
    culler->build(*scene);
    const Sphere sphere = scene->boundingSphere();
    const auto placed = [&](const View& view) {
        Camera camera = view.camera();
        camera.eye = sphere.centre + sphere.radius * camera.eye;
        camera.target = sphere.centre + sphere.radius * camera.target;
        camera.nearDistance *= sphere.radius;
        camera.farDistance *= sphere.radius;
        return View(camera, kSize);
    };
    Random random(9);
    uint64_t differing = 0;
    for (uint64_t i = 0; i < howMany(1'000, 4); ++i) {
        const View view = placed(i % 2 == 0 ? outside(random) : within(random));
        ASSERT_EQ(unexplained(*culler, buffers, view, &differing), 0u) << "view " << i;
    }
    RecordProperty("differing_pixels", int(differing));
}

TEST(OrderingPicture, quizIsDrawnInTheOrderOfItsPlanes) {
    const ScenePointer scene = openScene("quiz").scene;
    const CullerPointer culler = strategy("bsp", {{"plane", "given"}});
    culler->build(*scene);
    const View view(*scene->remarks().camera, kSize);
    const FrameLog log = culler->cull(view, Recording::On).log;
    std::string order;
    for (const OwnTriangles::Run& run : std::get<OwnTrianglesPointer>(log.commands.front())->runs)
        order += scene->instances()[run.instance].name;
    EXPECT_EQ(order, "BAC") << "runs of one object are one";
    size_t sides = 0;
    for (const Decision& decision : log.decisions) sides += decision.line == 2 ? 1 : 0;
    EXPECT_EQ(sides, 7u) << "the planes above eight leaves";
}

}  // namespace
}  // namespace cullscope::test::ordering_picture_test
