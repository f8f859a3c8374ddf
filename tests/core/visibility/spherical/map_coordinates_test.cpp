// Polar axis and origin of the maps of `spherical`.
#include "core/visibility/spherical/map_coordinates.h"

#include <gmock/gmock.h>

#include "core/visibility/spherical/recorded_decisions.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/spherical_views.h"

namespace cullscope::test::map_coordinates_test {
namespace {

using namespace spherical;

constexpr std::array kAxes{"z", "x", "y"};
constexpr std::array kOrigins{"sphere", "box", "centroid"};

SphericalDecision decisionOf(const CullerPointer& culler, const View& view) {
    return decisionsOf(culler->cull(view, Recording::On).log).at(0);
}

View randomView(Random& random) {
    const Vec3 eye = random.between(1.3, 4.0) * random.direction();
    return lookingAt(eye, 0.5 * random.direction(), random.between(5.0, 60.0), {64, 48});
}

/// A mesh with its axes in another order: what was `axis` is z.
ScenePointer turned(const MeshPointer& mesh, const Mat3& meshFromMap) {
    TriangleMesh::Data data;
    for (const Vec3f& position : mesh->positions()) data.positions.emplace_back(Vec3(position) * meshFromMap);
    data.indices.assign(mesh->indices().begin(), mesh->indices().end());
    return sceneOf({std::make_shared<const TriangleMesh>(std::move(data))});
}

TEST(MapCoordinates, framesHoldTheMeshAndTheirAxesAreARotation) {
    const MeshPointer mesh = bumpyMesh(6, 4'000, 0.4);
    for (const PolarAxis axis : {PolarAxis::Z, PolarAxis::X, PolarAxis::Y})
        for (const MapOrigin origin : {MapOrigin::Sphere, MapOrigin::Box, MapOrigin::Centroid}) {
            const MapFrame frame = mapFrame(*mesh, {axis, origin});
            EXPECT_NEAR(glm::determinant(frame.meshFromMap), 1.0, 1e-12);
            const Vec3 pole = frame.meshFromMap * Vec3(0, 0, 1);
            EXPECT_EQ(pole, axis == PolarAxis::Z ? Vec3(0, 0, 1) : axis == PolarAxis::X ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
            for (const Vec3f& position : mesh->positions())
                EXPECT_LE(glm::length(Vec3(position) - frame.sphere.centre), frame.sphere.radius * (1.0 + 1e-6));
        }
}

TEST(MapCoordinates, anotherPolarAxisIsTheMeshTurned) {
    // Of all of it in view as well as of parts: the same triangles, by the same case.
    const MeshPointer mesh = bumpyMesh(6, 4'000, 0.4);
    const ScenePointer scene = sceneOf({mesh});
    Random random(77);
    size_t regions = 0, bands = 0;
    for (const auto& [axis, number] : {std::pair("x", PolarAxis::X), {"y", PolarAxis::Y}}) {
        const Mat3 meshFromMap = mapFrame(*mesh, {number, MapOrigin::Sphere}).meshFromMap;
        const ScenePointer other = turned(mesh, meshFromMap);
        const CullerPointer here = strategyWith("spherical", {{"axis", axis}}), there = strategyWith("spherical", {});
        here->build(*scene);
        there->build(*other);
        for (int i = 0; i < 60; ++i) {
            const View view = randomView(random);
            Camera camera = view.camera();
            for (Vec3* each : {&camera.eye, &camera.target, &camera.up}) *each = *each * meshFromMap;
            const SphericalDecision a = decisionOf(here, view), b = decisionOf(there, View(camera, view.viewport()));
            SCOPED_TRACE(testing::Message() << axis << ", view " << i);
            ASSERT_EQ(a.relation, b.relation);
            ASSERT_EQ(a.region.has_value(), b.region.has_value());
            if (a.region) EXPECT_EQ(a.region->caseNumber, b.region->caseNumber);
            // A triangle's cell may be the neighbour's where its centroid lies on their border.
            EXPECT_NEAR(double(a.drawnTriangles), double(b.drawnTriangles), 0.02 * double(mesh->triangleCount()));
            regions += a.region ? 1 : 0;
            bands += a.bands ? 1 : 0;
        }
    }
    EXPECT_GT(regions, 10u);
    EXPECT_GT(bands, 10u);
}

TEST(MapCoordinates, raysHitTheSameTrianglesInAnyCoordinates) {
    const ScenePointer scene = sceneOf({bumpyMesh(6, 4'000, 0.4)}, {translation({3.0, -1.0, 2.0}) * scaling({1.5, 1.0, 0.7})});
    std::vector<CullerPointer> cullers;
    for (const char* axis : kAxes)
        for (const char* origin : kOrigins) {
            cullers.push_back(strategyWith("spherical", {{"axis", axis}, {"origin", origin}}));
            cullers.back()->build(*scene);
        }
    Random random(5);
    size_t hits = 0;
    for (int i = 0; i < 40; ++i) {
        View view = randomView(random);
        Camera camera = view.camera();
        camera.eye += Vec3(3.0, -1.0, 2.0);
        camera.target += Vec3(3.0, -1.0, 2.0);
        view = View(camera, view.viewport());
        const SphericalDecision first = decisionOf(cullers.front(), view);
        for (size_t other = 1; other < cullers.size(); ++other) {
            const SphericalDecision decision = decisionOf(cullers[other], view);
            for (size_t ray = 0; ray < 4; ++ray) {
                if (!first.rays[ray].followed || !decision.rays[ray].followed) continue;
                ASSERT_EQ(first.rays[ray].hit.has_value(), decision.rays[ray].hit.has_value()) << i << ", " << other;
                if (!first.rays[ray].hit) continue;
                EXPECT_EQ(first.rays[ray].hit->triangle, decision.rays[ray].hit->triangle) << i << ", " << other;
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 100u);
}

}  // namespace
}  // namespace cullscope::test::map_coordinates_test
