// The causes that `spherical-lossless` gives for culled cells, checked triangle by triangle.
#include <gmock/gmock.h>

#include <tbb/global_control.h>

#include <numbers>
#include <numeric>

#include "core/scene/camera_path.h"
#include "core/scene/eye_triangle.h"
#include "core/visibility/spherical/cell_walk.h"
#include "core/visibility/triangle_states.h"
#include "tests/support/culler.h"
#include "tests/support/lossless_scenes.h"

namespace cullscope::test::spherical_lossless_test {
namespace {

View around(const Scene& scene, Random& random, double fovyDegrees = 40) {
    const Sphere& sphere = scene.instanceSphere(0);
    const Vec3 away = random.direction(), aside = random.direction(), up = random.direction();
    const double distance = sphere.radius * random.between(1.1, 6.0);
    return {{sphere.centre + distance * away, sphere.centre + 0.5 * sphere.radius * aside, up, Angle::fromDegrees(fovyDegrees),
             1e-3 * sphere.radius, 100 * sphere.radius},
            {300, 200}};
}

/// Whether all corners lie on the outside of one plane.
bool outsideOnePlane(const std::array<Vec3, 3>& corners, const Frustum& frustum) {
    return std::ranges::any_of(frustum.planes, [&](const Plane& plane) {
        return std::ranges::all_of(corners, [&](const Vec3& corner) { return plane.distance(corner) < 0.0; });
    });
}

/// Whether a triangle of the mesh lies between the eye (the origin) and a point.
bool covered(const std::vector<std::array<Vec3, 3>>& triangles, const Vec3& point) {
    return std::ranges::any_of(triangles, [&](const std::array<Vec3, 3>& corners) {
        const std::optional<double> t = hit({Vec3(0.0), point}, corners);
        return t && *t > 0.0 && *t < 1.0 - 1e-9;
    });
}

TEST(SphericalLossless, causeOfALeftOutCellIsTrueOfItsTriangles) {
    std::array<uint64_t, kCauseCount> judged{};
    const std::vector<MeshPointer> meshes{starMesh(7, 16'000), bumpyMesh(3, 16'000, 0.4), knotMesh(4'000), bowlMesh(4'000)};
    for (size_t m = 0; m < meshes.size(); ++m) {
        Random random(m + 1);
        const Mat4 place = m % 2 == 0 ? scaling({-1, 1, 1}) : rotation({1, 2, 3}, 1.0) * scaling({1, 1, 0.4});
        const ScenePointer scene = sceneOf({meshes[m]}, {place});
        const CullerPointer strategy =
            strategyWith("spherical-lossless", {{"facing", "front"}, {"layout", m < 2 ? "octahedral" : "latitude-longitude"}});
        strategy->build(*scene);
        for (int i = 0; i < 12; ++i) {
            const View view = around(*scene, random);
            const Culled frame = strategy->cull(view, Recording::On);
            const InstanceFromEye instance(*scene, 0, view.eye());
            std::vector<std::array<Vec3, 3>> all;
            for (uint64_t t = 0; t < scene->triangleCount(); ++t) all.push_back(instance.corners(t));
            for (const Decision& cell : frame.log.decisions) {
                if (cell.subject.kind != Subject::Kind::Cell || cell.outcome != Decision::Outcome::Culled) continue;
                for (uint32_t p = cell.places.first; p < cell.places.first + cell.places.count; ++p) {
                    const uint64_t triangle = frame.drawList.triangleAt(0, p);
                    ++judged[size_t(cell.cause)];
                    const std::string what =
                        "mesh " + std::to_string(m) + " view " + std::to_string(i) + " triangle " + std::to_string(triangle);
                    if (cell.cause == Cause::OutsideFrustum) {
                        EXPECT_TRUE(outsideOnePlane(all[triangle], view.frustum())) << what;
                    } else if (cell.cause == Cause::BackFacing) {
                        EXPECT_TRUE(instance.facesAway(triangle)) << what;
                    } else if (triangle % 8 == 0) {
                        EXPECT_TRUE(covered(all, all[triangle][triangle / 8 % 3])) << what;
                    }
                }
            }
        }
    }
    // Each cause occurs often enough.
    EXPECT_GT(judged[size_t(Cause::OutsideFrustum)], 1000u);
    EXPECT_GT(judged[size_t(Cause::BackFacing)], 1000u);
    EXPECT_GT(judged[size_t(Cause::Hidden)], 300u);
}

TEST(SphericalLossless, horizonHidesOnlyWhatTheKernelCovers) {
    const MeshPointer mesh = bumpyMesh(11, 20'000, 0.5);
    const InnerKernel kernel(*mesh);
    ASSERT_TRUE(kernel.filled());
    const double radius = mesh->localSphere().radius;
    Random random(5);
    uint64_t hidden = 0, visible = 0;
    const uint64_t views = howMany(30, 30);
    for (uint64_t v = 0; v < views; ++v) {
        const Vec3 eye = random.direction() * (radius * random.between(1.05, 8.0));
        const spherical::KernelHorizon horizon(kernel, eye, radius, 1e-5);
        ASSERT_TRUE(horizon.usable());
        for (int i = 0; i < 400; ++i) {
            const Vec3 point = random.direction() * (radius * random.unit());
            const spherical::KernelHorizon::Reach reach = horizon.compare(point, 1e-3 * radius * random.unit()).reach;
            bool through = false;
            for (int step = 1; step < 4000 && !through; ++step) {
                const Vec3 q = glm::mix(eye, point, step / 4000.0);
                through = glm::length(q) < kernel.radius(octahedralCell(q, kernel.level()));
            }
            EXPECT_TRUE(through || reach != spherical::KernelHorizon::Reach::Hidden) << "view " << v << " point " << i;
            hidden += reach == spherical::KernelHorizon::Reach::Hidden ? 1 : 0;
            visible += reach == spherical::KernelHorizon::Reach::Visible ? 1 : 0;
        }
    }
    EXPECT_GT(hidden, 500 * views / 30);
    EXPECT_GT(visible, 2000 * views / 30);
}

TEST(SphericalLossless, testsAreUsedOnlyWhereTheyHold) {
    const auto parts = [](const MeshPointer& mesh, const char* facing, const Vec3& eye, double near) {
        const ScenePointer scene = sceneOf({mesh});
        const CullerPointer strategy = strategyWith("spherical-lossless", {{"facing", facing}, {"triangles", "false"}});
        strategy->build(*scene);
        const Culled frame = strategy->cull(View({eye, Vec3(0.0), {0, 1, 0.1}, Angle::fromDegrees(40), near, 100}, {200, 200}));
        EXPECT_EQ(frame.parts[0].culledTriangles, frame.culledTriangles[size_t(Cause::OutsideFrustum)]);
        EXPECT_EQ(frame.parts[1].culledTriangles, frame.culledTriangles[size_t(Cause::BackFacing)]);
        EXPECT_EQ(frame.parts[2].culledTriangles, frame.culledTriangles[size_t(Cause::Hidden)]);
        return std::pair(frame.parts[1].objects == 1, frame.parts[2].objects == 1);
    };
    const MeshPointer star = starMesh(2, 40'000);
    using testing::Pair;
    EXPECT_THAT(parts(star, "auto", {0, 0, 5}, 0.1), Pair(true, true));
    EXPECT_THAT(parts(star, "two-sided", {0, 0, 5}, 0.1), Pair(false, true));
    EXPECT_THAT(parts(star, "auto", {0, 0, 0.5}, 0.01), Pair(true, false)) << "with the eye inside";
    EXPECT_THAT(parts(star, "auto", {0, 0, 5}, 4.5), Pair(true, false)) << "where the near plane cuts";
    EXPECT_THAT(parts(sheetMesh(60), "auto", {0, 0, 5}, 0.1), Pair(false, false)) << "open: both sides are drawn";
    EXPECT_THAT(parts(torusMesh(8'000), "auto", {0, 0, 2.5}, 0.1), Pair(true, false)) << "the centre is outside";
    const MeshPointer inverted = changed(*star, kStay, kEvery);
    EXPECT_THAT(parts(inverted, "two-sided", {0, 0, 5}, 0.1), Pair(false, true));
    EXPECT_THAT(parts(inverted, "front", {0, 0, 5}, 0.1), Pair(true, false)) << "its inside is what is drawn";
    const MeshPointer mixed = changed(*star, kStay, [](size_t i) { return i % 5 == 0; });
    EXPECT_THAT(parts(mixed, "auto", {0, 0, 5}, 0.1), Pair(false, false));
    const MeshPointer few = starMesh(2, 8'000);
    EXPECT_THAT(parts(few, "auto", {0, 0, 5}, 0.1), Pair(true, false)) << "all in view: the horizon would hide too little";
    EXPECT_THAT(parts(few, "auto", {0, 0, 2.5}, 0.1), Pair(true, true)) << "cut by the frustum";
    EXPECT_THAT(parts(torusMesh(8'000), "auto", {0, 0, 5}, 0.1), Pair(false, false)) << "all in view: few cells could face away";
}

TEST(SphericalLossless, leavesCellsOutOnlyWhereThatSavesEnough) {
    // Those that face away count half: an object of which less than an eighth would be saved is drawn whole.
    size_t whole = 0, byCells = 0;
    for (const MeshPointer& mesh : {torusMesh(16'000), knotMesh(16'000), bumpyMesh(3, 16'000, 0.2), starMesh(7, 16'000)}) {
        const ScenePointer scene = sceneOf({mesh});
        const CullerPointer strategy = strategyWith("spherical-lossless", {{"facing", "front"}, {"triangles", "false"}});
        strategy->build(*scene);
        Random random(17);
        for (int i = 0; i < 12; ++i) {
            const Culled frame = strategy->cull(around(*scene, random));
            const auto& culled = frame.culledTriangles;
            const uint64_t leftOut = std::accumulate(culled.begin(), culled.end(), uint64_t{0});
            const uint64_t saved = leftOut - culled[size_t(Cause::BackFacing)] / 2;
            EXPECT_TRUE(leftOut == 0 || 8 * saved >= scene->triangleCount()) << saved << " of " << scene->triangleCount();
            ++(leftOut == 0 ? whole : byCells);
        }
    }
    EXPECT_GT(whole, 3u);
    EXPECT_GT(byCells, 10u);
}

TEST(SphericalLossless, leavesTrianglesOutOneByOneWhereThePictureHasFewPixelsForEach) {
    const ScenePointer scene = sceneOf({knotMesh(16'000)});
    const auto frame = [&](const char* triangles, const Viewport& size) {
        const CullerPointer strategy = strategyWith("spherical-lossless", {{"facing", "front"}, {"triangles", triangles}});
        strategy->build(*scene);
        return strategy->cull(View({{0, 1, 5}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 20}, size), Recording::On);
    };
    const Culled coarse = frame("true", {160, 120}), fine = frame("true", {1600, 1200}), cells = frame("false", {160, 120});
    const CullPart& part = coarse.parts[3];
    EXPECT_EQ(part.name, "triangles one by one");
    EXPECT_EQ(part.objects, 1u);
    EXPECT_GT(part.culledTriangles, scene->triangleCount() / 2);
    EXPECT_EQ(coarse.consideredTriangles + part.culledTriangles, cells.consideredTriangles);
    EXPECT_EQ(fine.parts[3].objects, 0u) << "there are 33 pixels for each triangle";
    EXPECT_EQ(fine.consideredTriangles, frame("false", {1600, 1200}).consideredTriangles);
    // The states of the triangles are those that the counters have.
    const TriangleStates states = triangleStates(*scene, coarse.log, std::nullopt);
    const auto count = [&](TriangleState state) { return states.counts[size_t(state)]; };
    uint64_t givenAndAway = 0;  // OpenGL drops those
    for (const DrawRange& range : coarse.drawList.ranges) {
        const InstanceFromEye instance(*scene, 0, coarse.log.camera);
        for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            givenAndAway += instance.facesAway(coarse.drawList.triangleAt(0, place)) ? 1 : 0;
    }
    EXPECT_EQ(count(TriangleState::BackFacing), coarse.culledTriangles[size_t(Cause::BackFacing)] + givenAndAway);
    EXPECT_EQ(count(TriangleState::TooSmall), coarse.culledTriangles[size_t(Cause::NoSample)]);
    EXPECT_EQ(count(TriangleState::Visible) + givenAndAway, coarse.consideredTriangles);
}

TEST(SphericalLossless, answerDoesNotDependOnRecordingOrTheThreads) {
    const ScenePointer scene = copiesOf(starMesh(4, 5'000), [] {
        std::vector<Mat4> places;
        for (int i = 0; i < 36; ++i) places.push_back(translation({3.0 * (i % 6), 0.0, -3.0 * (i / 6)}));
        return places;
    }());
    const CullerPointer strategy = makeCuller("spherical-lossless");
    strategy->build(*scene);
    Random random(3);
    for (int i = 0; i < 10; ++i) {
        const View view = around(*scene, random, 70);
        const Culled plain = strategy->cull(view);
        EXPECT_EQ(strategy->cull(view, Recording::On).drawList.ranges, plain.drawList.ranges);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(strategy->cull(view).drawList.ranges, plain.drawList.ranges);
    }
}

TEST(SphericalLossless, costOfACullDoesNotGrowWithTheObjects) {
    // Four times the objects, the same ones in view.
    std::vector<uint64_t> visited;
    for (const int side : {64, 128, 256}) {
        std::vector<Mat4> places;
        for (int i = 0; i < side * side; ++i) places.push_back(translation({3.0 * (i % side), 0.0, 3.0 * (i / side)}));
        const ScenePointer scene = copiesOf(boxMesh({-1, -1, -1}, {1, 1, 1}), places);
        const CullerPointer strategy = makeCuller("spherical-lossless");
        strategy->build(*scene);
        const View view({{10, 4, 10}, {20, 0, 20}, {0, 1, 0}, Angle::fromDegrees(40), 0.1, 60}, {300, 200});
        const Culled frame = strategy->cull(view);
        visited.push_back(frame.nodesVisited);
        EXPECT_GT(frame.consideredTriangles, 500u);
        EXPECT_EQ(frame.consideredTriangles + frame.culledTriangles[size_t(Cause::OutsideFrustum)], scene->triangleCount());
    }
    EXPECT_LT(visited[2], visited[0] + visited[0] / 2);
}

TEST(SphericalLossless, cullVisitsAsManyCellsOfAFinerMesh) {
    // Sixteen times the triangles with equal cells: the same walk.
    std::vector<uint64_t> visited;
    for (const size_t triangles : {20'000u, 320'000u}) {
        const ScenePointer scene = sceneOf({sphereMesh(triangles)});
        const CullerPointer strategy = strategyWith("spherical-lossless", {{"level", "5"}, {"horizon", "false"}});
        strategy->build(*scene);
        visited.push_back(
            strategy->cull(View({{0, 0.3, 1.5}, {0, 0.5, 0}, {0, 1, 0}, Angle::fromDegrees(20), 0.01, 10}, {300, 200}))
                .nodesVisited);
    }
    EXPECT_NEAR(double(visited[1]) / double(visited[0]), 1.0, 0.1);
}

TEST(SphericalLossless, extremeViewHasAnAnswer) {
    // Cases 11, 13, 17 and 23: corners at the centre, the polar axis, the eye at the centre, fields of 0.01° and 179°.
    const MeshPointer cone = joined({starMesh(1, 3'000), meshOf({{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}}, {0, 1, 2})});
    for (const char* layout : {"octahedral", "latitude-longitude"}) {
        const ScenePointer scene = sceneOf({cone});
        const CullerPointer strategy =
            strategyWith("spherical-lossless", {{"layout", layout}, {"facing", "two-sided"}, {"triangles", "false"}});
        strategy->build(*scene);
        const Vec3 centre = scene->instanceSphere(0).centre;
        for (const Vec3& eye : {centre, centre + Vec3(0, 0, 5), centre - Vec3(0, 0, 5), centre + Vec3(0, 0, 1e9)})
            for (const double fovy : {0.01, 60.0, 179.0})
                for (const Viewport& size : {Viewport{1, 1}, Viewport{16384, 1}, Viewport{300, 200}}) {
                    const View view(
                        {eye, eye + Vec3(0, 0, eye.z > centre.z ? -1.0 : 1.0), {0, 1, 0}, Angle::fromDegrees(fovy), 1e-3, 2e9},
                        size);
                    const Culled frame = strategy->cull(view);
                    uint64_t culled = 0;
                    for (const uint64_t count : frame.culledTriangles) culled += count;
                    EXPECT_EQ(culled + frame.consideredTriangles, scene->triangleCount());
                    EXPECT_GT(frame.consideredTriangles, 0u) << layout << " fovy " << fovy;
                }
    }
}

}  // namespace
}  // namespace cullscope::test::spherical_lossless_test
