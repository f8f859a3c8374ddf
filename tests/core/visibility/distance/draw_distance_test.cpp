// The strategy "draw-distance", the worked example of docs/adding-a-strategy.md.
#include "core/visibility/distance/draw_distance.h"

#include "core/frame/listing.h"
#include "core/measure/reference.h"
#include "core/mesh/parametric.h"
#include "core/visibility/overlay.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_views.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::draw_distance_test {
namespace {

/// Five spheres in a row before the eye.
ScenePointer row() {
    std::vector<Mat4> places;
    for (int i = 0; i < 5; ++i) places.push_back(translation({0, 0, -5.0 * (i + 1)}));
    return copiesOf(sphereMesh(80), places);
}

/// A little above the row, so that every sphere is in view.
View overTheRow() { return {{Vec3(0, 4, 0), {0, 0, -14}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {128, 96}}; }

ParameterSet upTo(double distance) {
    ParameterSet parameters(distance::drawDistance().info.parameters);
    parameters.set("distance", distance);
    parameters.setFromText("facing", "two-sided");
    return parameters;
}

/// The distance parameter at which objects are drawn up to a world distance.
ParameterSet upToLength(double length, const Scene& scene) { return upTo(length / scene.boundingSphere().radius); }

using Long = long double;

/// The distance of an object's nearest and farthest vertex from a point.
std::pair<Long, Long> vertexDistances(const Scene& scene, uint32_t instance, const Vec3& eye) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Mat4& placed = scene.instances()[instance].worldFromMesh;
    Long nearest = std::numeric_limits<Long>::infinity(), farthest = 0;
    for (const uint32_t index : mesh.indices()) {
        Long squared = 0;
        for (int axis = 0; axis < 3; ++axis) {
            Long world = Long(placed[3][axis]) - Long(eye[axis]);
            for (int from = 0; from < 3; ++from)
                world += Long(placed[from][axis]) * (Long(mesh.origin()[from]) + Long(mesh.positions()[index][from]));
            squared += world * world;
        }
        nearest = std::min(nearest, std::sqrt(squared));
        farthest = std::max(farthest, std::sqrt(squared));
    }
    return {nearest, farthest};
}

TEST(DrawDistance, drawsWhatIsNearerExactlyAsAllDoes) {
    Random random(20);
    size_t drawn = 0, leftOut = 0;
    for (uint64_t seed = 1; seed <= (longMode() ? 400 : 40); ++seed) {
        const ScenePointer scene = randomScene(seed);
        const CullerPointer all = makeCuller("all");
        all->build(*scene);
        for (int view = 0; view < 10; ++view) {
            const RandomView random_ = randomView(*scene, random);
            const View seen(random_.camera, random_.viewport);
            // About as far as one of the objects.
            const auto chosen = uint32_t(random.bits() % scene->instances().size());
            const double length = double(vertexDistances(*scene, chosen, seen.eye()).first) * (0.5 + random.unit());
            const double multiple = length / scene->boundingSphere().radius;
            if (!(multiple >= 0.0 && multiple <= 1000.0)) continue;
            Culler culler(distance::drawDistance(), upTo(multiple));
            culler.build(*scene);
            const Culled culled = culler.cull(seen);
            std::vector<DrawRange> expected;
            for (const DrawRange& range : all->cull(seen).drawList.ranges) {
                const bool kept = std::ranges::any_of(culled.drawList.ranges,
                                                      [&](const DrawRange& own) { return own.instance == range.instance; });
                if (kept) expected.push_back(range);
                const auto [nearest, farthest] = vertexDistances(*scene, range.instance, seen.eye());
                const Long limit = Long(multiple) * Long(scene->boundingSphere().radius);
                // No triangle of an object comes nearer than its sphere, which may come nearer than its vertices.
                EXPECT_TRUE(kept || nearest > limit) << "seed " << seed << ", view " << view << ", object " << range.instance;
                const Sphere& sphere = scene->instanceSphere(range.instance);
                const double clear = 1e-6 * (glm::length(sphere.centre) + glm::length(seen.eye()) + sphere.radius);
                const bool beyond = glm::length(sphere.centre - seen.eye()) - sphere.radius > double(limit) + clear;
                EXPECT_FALSE(kept && beyond) << "seed " << seed << ", view " << view << ", object " << range.instance;
                ++(kept ? drawn : leftOut);
            }
            EXPECT_EQ(culled.drawList.ranges, expected) << "the same ranges in the same order";
            EXPECT_EQ(culled.drawList.facing, Facing::TwoSided);
        }
    }
    EXPECT_GT(drawn, 100u);
    EXPECT_GT(leftOut, 100u);
}

TEST(DrawDistance, whatItMissesLiesBeyond) {
    const ScenePointer scene = row();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view = overTheRow();
    const double limit = 16.0;
    Culler culler(distance::drawDistance(), upToLength(limit, *scene));
    culler.build(*scene);
    const Culled culled = culler.cull(view, Recording::On);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
    const TriangleStates states = triangleStates(*scene, culled.log, truth.visible());
    size_t missed = 0;
    for (uint32_t i = 0; i < scene->instances().size(); ++i) {
        const bool beyond = vertexDistances(*scene, i, view.eye()).first > limit;
        for (uint64_t triangle = scene->firstTriangle(i); triangle < scene->firstTriangle(i) + 80; ++triangle) {
            const TriangleState state = states.states[triangle];
            missed += state == TriangleState::WronglyCulled ? 1 : 0;
            EXPECT_EQ(state == TriangleState::WronglyCulled || state == TriangleState::TooSmall, beyond) << triangle;
        }
    }
    EXPECT_GT(missed, 20u);
    // A replay of the log shows, at every pixel, the truth or what lies behind an object that was left out.
    const Renderer::ItemBuffer shown =
        GlEnvironment::renderer().drawItemBuffer(buffers, view, culled.log, {0, 0, view.viewport()});
    for (size_t pixel = 0; pixel < shown.triangle.size(); ++pixel) {
        if (shown.triangle[pixel] == truth.triangle[pixel]) continue;
        ASSERT_NE(truth.triangle[pixel], 0u);
        EXPECT_GT(vertexDistances(*scene, uint32_t(scene->instanceOf(truth.triangle[pixel] - 1)), view.eye()).first, limit);
    }
}

TEST(DrawDistance, saysWhyAndAtWhichLine) {
    const ScenePointer scene = row();
    Culler culler(distance::drawDistance(), upToLength(12.0, *scene));
    culler.build(*scene);
    const View view{{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64}};
    const Culled culled = culler.cull(view, Recording::On);
    EXPECT_EQ(culled.drawList.ranges, (std::vector<DrawRange>{{0, 0, 240}, {1, 0, 240}}));
    EXPECT_EQ(culled.culledTriangles[size_t(Cause::TooSmall)], 3u * 80);
    EXPECT_EQ(culler.promise(), Promise::Approximate);
    const StructureSnapshot tree = culler.snapshot(culled.log);
    ASSERT_EQ(tree.nodes.size(), 5u);
    for (const SnapshotNode& node : tree.nodes) EXPECT_EQ(node.culled, node.instance >= 2);
    const std::vector<WhyStep> steps = why(*culler.built(), culled.log, scene->firstTriangle(3));
    const auto says = [&](const std::string& sentence) {
        return std::ranges::any_of(steps, [&](const WhyStep& step) { return step.sentence.english() == sentence; });
    };
    EXPECT_TRUE(says("The object \"copy 3\" is tested as one sphere with 80 triangles."));
    EXPECT_TRUE(says("Its sphere begins 19 from the eye, beyond the distance of 12: so far away it counts as too small."));
    EXPECT_TRUE(says("The strategy leaves the object out: too small."));
    EXPECT_TRUE(says("The triangle is not given to OpenGL."));
    EXPECT_EQ(culler.built()->listing(culled.log), (ListingState{{0, 0, 5, 3, 2}, 4}));
    EXPECT_EQ(culler.built()->listing(culled.log, scene->firstTriangle(3)), (ListingState{{0, 0, 1, 1, 0}, 4}));
    EXPECT_EQ(culler.built()->listing(culled.log, scene->firstTriangle(1)), (ListingState{{0, 0, 1, 0, 1}, 5}));
    EXPECT_EQ(culler.built()->listing(culled.log.upTo(3)), (ListingState{{0, 0, 2, 0, 1}, 3})) << "the test of the second object";
}

TEST(DrawDistance, overlayIsTheDistanceAroundTheCullingEye) {
    const ScenePointer scene = row();
    Culler culler(distance::drawDistance(), upToLength(9.0, *scene));
    culler.build(*scene);
    const View view = overTheRow();
    const Culled culled = culler.cull(view, Recording::On);
    const DrawStyle style;
    const OverlayContext context{*scene, view, style, {}, Vec3f(1.0f)};
    const std::vector<OverlayLines> rings = culler.built()->overlay("distance", context, culled.log);
    ASSERT_EQ(rings.size(), 1u);
    ASSERT_FALSE(rings.front().lines.empty());
    for (const LineSegment& line : rings.front().lines)
        for (const Vec3& end : {line.from, line.to}) EXPECT_NEAR(glm::length(end - view.eye()), 9.0, 1e-9);
    EXPECT_TRUE(culler.built()->overlay("distance", context, FrameLog{}).empty());
}

TEST(DrawDistance, anotherDistanceBuildsNothing) {
    const RegisteredStrategy strategy = distance::drawDistance();
    StructureStore store;
    const ScenePointer scene = row();
    const BuiltStrategyPointer first = buildStrategy(strategy, upTo(2.0), scene, store);
    EXPECT_EQ(buildStrategy(strategy, upTo(3.0), scene, store)->structure(), first->structure());
    EXPECT_EQ(store.built(), 1u);
}

TEST(DrawDistance, isMeasuredWithItsLosses) {
    MeasureRequest request = smallExperiment({});
    request.path = cameraPath("orbit:3", *request.scene);
    for (const double multiple : {2.0, 1000.0}) request.strategies.push_back({"draw-distance", upTo(multiple)});
    const MeasureResult result = measure(request);
    ASSERT_EQ(result.runs.size(), 2u);
    EXPECT_GT(*result.runs[0].summary.missedPixelRate, 0.0);
    EXPECT_GT(result.runs[0].summary.culledFraction, 0.1);
    EXPECT_EQ(result.runs[1].summary.missedPixelRate, 0.0) << "nothing is beyond";
    EXPECT_EQ(result.runs[1].summary.culledFraction, 0.0);
    for (const RunMeasurement& run : result.runs) EXPECT_FALSE(run.promiseBroken()) << "it promises nothing";
}

}  // namespace
}  // namespace cullscope::test::draw_distance_test
