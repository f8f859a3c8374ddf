#include "core/visibility/why.h"

#include <map>

#include "core/mesh/parametric.h"
#include "core/visibility/left_out_triangles.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::why_test {
namespace {

/// A plane built here from the camera's parameters: inside where normal·p + offset > 0, with p relative to the eye.
struct OwnPlane {
    Vec3 normal;
    double offset = 0.0;
};

std::array<OwnPlane, 6> ownPlanes(const Camera& camera, const Viewport& size) {
    const Vec3 forward = glm::normalize(camera.target - camera.eye);
    const Vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const Vec3 up = glm::cross(right, forward);
    const double h = std::tan(camera.fovy.radians() / 2);
    const double w = h * size.width / size.height;
    const auto through = [&](const Vec3& a, const Vec3& b) {
        const Vec3 normal = glm::normalize(glm::cross(a, b));
        return OwnPlane{glm::dot(normal, forward) > 0.0 ? normal : -normal, 0.0};
    };
    const auto corner = [&](int x, int y) { return forward + right * (x * w) + up * (y * h); };
    return {through(corner(-1, -1), corner(-1, 1)),  through(corner(1, -1), corner(1, 1)),
            through(corner(-1, -1), corner(1, -1)),  through(corner(-1, 1), corner(1, 1)),
            OwnPlane{forward, -camera.nearDistance}, OwnPlane{-forward, camera.farDistance}};
}

/// The distances of the sphere's point farthest inside, and of the box's corner farthest inside.
std::pair<double, double> ownDistances(const OwnPlane& plane, const Scene& scene, uint32_t instance, const Vec3& eye) {
    const Box3& box = scene.instanceBox(instance);
    double farthest = -1e300;
    for (int c = 0; c < 8; ++c) {
        const Vec3 corner((c & 1) != 0 ? box.max.x : box.min.x, (c & 2) != 0 ? box.max.y : box.min.y,
                          (c & 4) != 0 ? box.max.z : box.min.z);
        farthest = std::max(farthest, glm::dot(plane.normal, corner - eye) + plane.offset);
    }
    const Sphere& sphere = scene.instanceSphere(instance);
    return {glm::dot(plane.normal, sphere.centre - eye) + plane.offset + sphere.radius, farthest};
}

/// A field of spheres and a camera in it: objects inside, outside and across every side plane.
ScenePointer field() {
    std::vector<Mat4> places;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) places.push_back(translation({(i - 3.5) * 2.5, 0.1 * i, (j - 3.5) * 2.5}));
    return copiesOf(sphereMesh(80), places);
}

std::vector<Camera> cameras() {
    std::vector<Camera> cameras;
    Random random(31);
    for (int i = 0; i < 30; ++i) {
        const double z = random.between(-9, 9), y = random.between(-3, 3), x = random.between(-9, 9);
        const Vec3 eye(x, y, z);
        cameras.push_back({eye, eye + random.direction(), {0, 1, 0}, Angle::fromDegrees(random.between(20, 80)), 0.5, 12});
    }
    return cameras;
}

TEST(Why, planeDistancesAreThoseOfIndependentOnes) {
    const ScenePointer scene = field();
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const Viewport size{200, 150};
    std::map<std::pair<FrustumPlane, Containment>, int> seen;
    for (const Camera& camera : cameras()) {
        const View view(camera, size);
        const std::array<OwnPlane, 6> planes = ownPlanes(camera, size);
        const Culled frame = frustum->cull(view, Recording::On);
        for (uint32_t instance = 0; instance < scene->instances().size(); ++instance) {
            const auto steps = why(*frustum->built(), frame.log, scene->firstTriangle(instance) + 3);
            std::map<FrustumPlane, int> tests;
            for (const WhyStep& step : steps) {
                if (!step.plane) continue;
                ASSERT_TRUE(step.distance && step.bound);
                // The object's sphere is tested first, then its box; where the sphere's batch ended before, the box alone.
                const auto [sphere, box] = ownDistances(planes[size_t(*step.plane)], *scene, instance, camera.eye);
                const bool ofSphere = std::abs(*step.distance - sphere) < 1e-9;
                EXPECT_TRUE(ofSphere || std::abs(*step.distance - box) < 1e-9) << *step.distance;
                EXPECT_LE(++tests[*step.plane], 2);
                EXPECT_GT(*step.bound, 0.0);
                EXPECT_LT(*step.bound, 1e-4) << "a margin, not a distance";
                EXPECT_EQ(step.containment == Containment::Outside, *step.distance < -*step.bound);
                ++seen[{*step.plane, step.containment}];
            }
        }
    }
    for (size_t plane = 0; plane < 6; ++plane)
        for (const Containment c : {Containment::Outside, Containment::Straddles})
            EXPECT_GT((seen[{static_cast<FrustumPlane>(plane), c}]), 0) << plane << " " << int(c) << " never occurs";
}

/// Whether a triangle is submitted, by scene triangle number.
std::vector<bool> givenTriangles(const Scene& scene, const DrawList& list) {
    std::vector<bool> given(scene.triangleCount(), false);
    for (const DrawRange& range : list.ranges)
        for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            given[scene.firstTriangle(range.instance) + list.triangleAt(scene.instances()[range.instance].mesh, place)] = true;
    return given;
}

TEST(Why, chainAgreesWithTheDrawList) {
    const ScenePointer scene = field();
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id);
        strategy->build(*scene);
        const std::vector<Camera> all = cameras();
        for (const Camera& camera : std::span(all).first(howMany(all.size(), all.size()))) {
            const View view(camera, {200, 150});
            const Culled frame = strategy->cull(view, Recording::On, &GlEnvironment::renderer());
            const std::vector<bool> given = givenTriangles(*scene, frame.drawList);
            for (uint32_t i = 0; i < scene->instances().size(); i += fewSamples() ? 4 : 1) {
                const bool drawn = given[scene->firstTriangle(i) + i];
                const auto steps = why(*strategy->built(), frame.log, scene->firstTriangle(i) + i);
                std::string chain;
                for (const WhyStep& step : steps) {
                    EXPECT_THAT(step.sentence.english(), testing::Not(testing::HasSubstr("%"))) << "a place without an argument";
                    chain += step.sentence.english() + "\n";
                }
                const bool picture =
                    !frame.log.commands.empty() && std::holds_alternative<FinishedPicturePointer>(frame.log.commands.back());
                const char* end = drawn ? "The triangle is given to OpenGL." : "is not given to OpenGL.";
                if (picture) end = drawn ? "The triangle is in the picture" : "is not in the picture";
                EXPECT_THAT(chain, testing::HasSubstr(end));
                const bool alone = chain.find("leaves the object out: ") != std::string::npos;
                const bool grouped = chain.find("box was tested first: outside the") != std::string::npos ||
                                     chain.find("box was tested first: an axis parts it") != std::string::npos ||
                                     chain.find("is left out with its whole group") != std::string::npos ||
                                     chain.find("box was tested first: what was drawn before hides") != std::string::npos;
                EXPECT_FALSE(alone && grouped) << chain;
                const bool left = alone || grouped;
                const bool inPart = chain.find("draws the object in part") != std::string::npos;
                EXPECT_TRUE(left || inPart || drawn) << chain;
                EXPECT_FALSE(left && drawn) << chain;
                EXPECT_EQ(chain.find("\nOpenGL d") != std::string::npos, drawn && !picture) << chain;
                EXPECT_EQ(chain.find("tested as one box with 80 triangles") != std::string::npos,
                          registered.info.id.starts_with("frustum"));
                EXPECT_TRUE(drawn || steps.back().containment == Containment::Outside);
            }
        }
    }
}

TEST(Why, facingOfTheTriangleIsTold) {
    const ScenePointer scene = sceneOf({squareMesh(1, -5), squareMesh(1, -6)}, {Mat4(1.0), scaling({-1, 1, 1})});
    const View before({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64});
    const View behind({{0, 0, -20}, {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64});
    const auto last = [&](const char* id, const View& view, uint64_t triangle) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const Culled frame = strategy->cull(view, Recording::On);
        return why(*strategy->built(), frame.log, triangle).back().sentence.english();
    };
    for (const uint64_t triangle : {0, 1, 2, 3}) {
        EXPECT_EQ(last("backface", before, triangle), "OpenGL draws the triangle: its front is turned to the eye.") << triangle;
        EXPECT_EQ(last("backface", behind, triangle), "OpenGL drops the triangle: it is back-facing.") << triangle;
        EXPECT_EQ(last("all", behind, triangle), "OpenGL draws the triangle: both sides count.") << triangle;
    }
}

TEST(StructureSnapshot, frustumShowsEveryBoxWithItsResult) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const ScenePointer scene = randomScene(seed);
        const CullerPointer frustum = makeCuller("frustum");
        frustum->build(*scene);
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            const Culled frame = frustum->cull(View(sample.camera, sample.viewport), Recording::On);
            std::vector<bool> drawn(scene->instances().size(), false);
            for (const DrawRange& range : frame.drawList.ranges) drawn[range.instance] = true;
            const StructureSnapshot snapshot = frustum->snapshot(frame.log);
            ASSERT_EQ(snapshot.nodes.size(), scene->instances().size());
            for (const SnapshotNode& node : snapshot.nodes) {
                EXPECT_EQ(node.parent, -1);
                EXPECT_EQ(node.box.min, scene->instanceBox(node.instance).min);
                EXPECT_EQ(node.box.max, scene->instanceBox(node.instance).max);
                EXPECT_EQ(node.triangles, scene->meshOf(node.instance).triangleCount());
                EXPECT_EQ(node.culled, !drawn[node.instance]);
                EXPECT_EQ(node.culled, node.containment == Containment::Outside);
                EXPECT_EQ(node.culled, node.rejectedBy.has_value());
            }
        }
    }
}

TEST(StructureSnapshot, containmentIsWhatWasTestedAndTheRejectingPlaneIsRight) {
    const ScenePointer scene = copiesOf(sphereMesh(80), {translation({0, 0, -5}), translation({0, 0, 5}), translation({5, 0, -5}),
                                                         translation({-20, 0, -5}), translation({0, 0, -30})});
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const Culled frame =
        frustum->cull({{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 20}, {100, 100}}, Recording::On);
    const StructureSnapshot snapshot = frustum->snapshot(frame.log);
    ASSERT_EQ(snapshot.nodes.size(), 5u);
    using enum Containment;
    // Whether what does not lie outside lies inside as a whole is no question of this strategy.
    const std::array expected{Straddles, Outside, Straddles, Outside, Outside};
    for (size_t i = 0; i < 5; ++i) EXPECT_EQ(snapshot.nodes[i].containment, expected[i]) << i;
    EXPECT_EQ(snapshot.nodes[1].rejectedBy, FrustumPlane::Left) << "behind the eye it lies outside the first plane tested";
    EXPECT_EQ(snapshot.nodes[3].rejectedBy, FrustumPlane::Left);
    EXPECT_EQ(snapshot.nodes[4].rejectedBy, FrustumPlane::Far);
}

/// The culled triangles of a frame by cause, as its decisions name them. Of an object whose cells or triangles were decided,
/// theirs.
std::array<uint64_t, kCauseCount> namedCauses(const Scene& scene, const Culled& frame) {
    std::vector<uint64_t> missing(scene.instances().size());
    for (size_t i = 0; i < missing.size(); ++i) missing[i] = scene.meshOf(i).triangleCount();
    for (const DrawRange& range : standingFor(frame.drawList, scene).ranges) missing[range.instance] -= range.indexCount / 3;
    std::array<uint64_t, kCauseCount> named{};
    forEachLeftOut(frame.log, [&](uint32_t instance, const LeftOutTriangles& triangles) {
        for (const LeftOutTriangles::Run& run : triangles.runs) {
            named[size_t(run.cause)] += run.places.count;
            missing[instance] -= run.places.count;
        }
    });
    for (const Decision& decision : frame.log.decisions) {
        if (decision.outcome != Decision::Outcome::Culled && decision.outcome != Decision::Outcome::PartlyDrawn) continue;
        const auto name = [&](uint32_t instance, uint64_t triangles) {
            named[size_t(decision.cause)] += triangles;
            missing[instance] -= triangles;
        };
        if (decision.subject.kind == Subject::Kind::Cell || decision.subject.kind == Subject::Kind::Triangles)
            name(decision.subject.object, decision.places.count);
        forObjectsOf(frame.log, decision, [&](uint32_t instance) { name(instance, missing[instance]); });
    }
    EXPECT_THAT(missing, testing::Each(0u)) << "left out without a decision";
    return named;
}

TEST(Decisions, everyTriangleNotSubmittedHasACause) {
    for (uint64_t seed = 1; seed <= howMany(20, 8); ++seed) {
        const ScenePointer scene = randomScene(seed);
        std::vector<CullerPointer> built;
        for (const RegisteredStrategy& registered : strategies()) {
            built.push_back(coarse(registered));
            built.back()->build(*scene);
        }
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            for (const CullerPointer& strategy : built) {
                SCOPED_TRACE(strategy->built()->info().id + " seed " + std::to_string(seed) + " view " + std::to_string(i));
                const Culled frame =
                    strategy->cull(View(sample.camera, sample.viewport), Recording::On, &GlEnvironment::renderer());
                EXPECT_EQ(namedCauses(*scene, frame), frame.culledTriangles) << "decisions and counters disagree";
                std::vector<int> drawn(scene->instances().size(), 0);
                for (const DrawRange& range : frame.drawList.ranges) drawn[range.instance] = 1;
                const std::vector<int> culled = timesDecided(frame.log, Decision::Outcome::Culled, drawn.size());
                for (size_t instance = 0; instance < drawn.size(); ++instance)
                    EXPECT_EQ(culled[instance], 1 - drawn[instance]) << "culled once, alone or with its group: " << instance;
            }
        }
    }
}

}  // namespace
}  // namespace cullscope::test::why_test
