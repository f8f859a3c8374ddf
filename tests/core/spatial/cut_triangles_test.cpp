// Triangles that planes cut: on which side they lie, what becomes of their areas, corners and neighbours.
#include "core/spatial/cut_triangles.h"

#include <gmock/gmock.h>

#include "tests/support/cut_scenes.h"
#include "tests/support/long_mode.h"
#include "tests/support/stopped_work.h"

namespace cullscope::test::cut_triangles_test {
namespace {

using Place = CutTriangles::Place;

constexpr uint32_t kOwnPlane = 0x80000000;  ///< numbers of planes that no triangle has

/// The plane through x, whose front is where x is larger.
CuttingPlane across(double x, uint32_t id = kOwnPlane) { return planeThrough({x, 0, 0}, {x, 1, 0}, {x, 0, 1}, id); }

/// Twice the area of what is drawn of a triangle.
double drawnArea(const OwnTriangles& own) {
    double area = 0.0;
    for (size_t i = 0; i < own.triangles.size(); ++i) {
        const Vec3 a(own.positions[3 * i]), b(own.positions[3 * i + 1]), c(own.positions[3 * i + 2]);
        area += glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

TEST(CutTriangles, placeIsExact) {
    const ScenePointer scene = sceneOf({soupMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}})});
    CutTriangles triangles(*scene);
    ASSERT_EQ(triangles.polygons().size(), 2u);
    EXPECT_EQ(triangles.place(0, across(0.5, kOwnPlane)), Place::Across);
    EXPECT_EQ(triangles.place(0, across(0.0, kOwnPlane + 1)), Place::Front) << "it touches the plane with an edge";
    EXPECT_EQ(triangles.place(0, across(1.0, kOwnPlane + 2)), Place::Back) << "and with a corner";
    EXPECT_EQ(triangles.place(0, across(std::nextafter(1.0, 0.0), kOwnPlane + 3)), Place::Across);
    EXPECT_EQ(triangles.place(1, across(2.0, kOwnPlane + 4)), Place::On);
    EXPECT_EQ(triangles.place(1, triangles.planeOf(1)), Place::On);
}

TEST(CutTriangles, partsLieOnTheirSidesAndHaveTheWholeArea) {
    const ScenePointer scene = sceneOf({soupMesh({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}})});
    CutTriangles triangles(*scene);
    const auto [front, back] = triangles.cut(0, across(1.0));
    EXPECT_EQ(triangles.place(front, across(1.0)), Place::Front);
    EXPECT_EQ(triangles.place(back, across(1.0)), Place::Back);
    EXPECT_EQ(triangles.cuts(), 1u);
    triangles.finish();
    EXPECT_NEAR(triangles.share(front), 9.0 / 16.0, 1e-12) << "similar to the whole, with three quarters of its length";
    EXPECT_NEAR(triangles.share(front) + triangles.share(back), 1.0, 1e-12);
    for (const uint32_t part : {front, back})
        for (const CutTriangles::Corner& corner : triangles.cornersOf(part))
            EXPECT_EQ(triangles.position(corner.vertex).x == 1.0, triangles.side(corner.vertex, across(1.0)) == 0);
}

TEST(CutTriangles, areasAreConservedByAnyCuts) {
    for (uint64_t seed = 0; seed < howMany(50, 12); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ScenePointer scene = hardScene(seed);
        CutTriangles triangles(*scene);
        Random random(seed + 1000);
        std::vector<uint32_t> whole;
        for (uint32_t i = 0; i < triangles.polygons().size(); ++i) whole.push_back(i);
        for (uint32_t cut = 0; cut < 12; ++cut) {
            const Vec3 at = 0.5 * random.direction();
            const CuttingPlane plane = planeThrough(at, at + random.direction(), at + random.direction(), kOwnPlane + cut);
            std::vector<uint32_t> parts;
            for (const uint32_t polygon : whole) {
                if (triangles.place(polygon, plane) != Place::Across) {
                    parts.push_back(polygon);
                    continue;
                }
                const auto [front, back] = triangles.cut(polygon, plane);
                parts.insert(parts.end(), {front, back});
            }
            whole = parts;
        }
        EXPECT_GT(triangles.cuts(), 20u);
        triangles.finish();
        std::vector<double> shares(scene->triangleCount(), 0.0);
        for (const uint32_t polygon : whole) {
            const double share = triangles.share(polygon);
            EXPECT_GE(share, -1e-12) << "a part is turned over";
            shares[triangles.polygons()[polygon].triangle] += share;
        }
        for (const double share : shares) EXPECT_NEAR(share, 1.0, 1e-9);
    }
}

TEST(CutTriangles, neighbourOfACutTriangleHasItsCorner) {
    // Two triangles with an edge in common; only the first is cut.
    const ScenePointer scene = sceneOf({meshOf({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}}, {0, 1, 2, 2, 1, 3})});
    CutTriangles triangles(*scene);
    const auto [front, back] = triangles.cut(0, across(0.7));
    triangles.finish();
    OwnTriangles neighbour, parts;
    triangles.draw(1, neighbour);
    EXPECT_GT(neighbour.triangles.size(), 1u);
    for (const uint32_t part : {front, back}) triangles.draw(part, parts);
    const auto has = [](const OwnTriangles& own, const Vec3f& corner) {
        return std::ranges::find(own.positions, corner) != own.positions.end();
    };
    bool shared = false;
    for (const CutTriangles::Corner& corner : triangles.cornersOf(front)) {
        const Vec3f at(triangles.position(corner.vertex));
        if (at.x == 0.7f && at.y > 1.0f) shared = has(neighbour, at) && has(parts, at);
    }
    EXPECT_TRUE(shared) << "the cut's end on the common edge is a corner of all three";
    OwnTriangles whole;
    triangles.drawWhole(1, whole);
    EXPECT_NEAR(drawnArea(neighbour), drawnArea(whole), 1e-6);
}

TEST(CutTriangles, uncutTriangleIsDrawnAsTheSceneHasIt) {
    const ScenePointer scene = sceneOf({randomTriangles(3, 5, 1.0)});
    CutTriangles triangles(*scene);
    triangles.finish();
    OwnTriangles own;
    for (uint32_t polygon = 0; polygon < 5; ++polygon) triangles.draw(polygon, own);
    const TriangleMesh& mesh = scene->meshOf(0);
    ASSERT_EQ(own.positions.size(), 15u);
    for (size_t i = 0; i < 15; ++i) EXPECT_EQ(own.positions[i], mesh.positions()[mesh.indices()[i]]);
}

TEST(CutTriangles, trianglesWithoutAreaArePolygonsOfNoPlane) {
    const ScenePointer scene = sceneOf({soupMesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
    const CutTriangles triangles(*scene);
    EXPECT_THAT(triangles.flat(), testing::ElementsAre(0));
    ASSERT_EQ(triangles.polygons().size(), 1u);
    EXPECT_EQ(triangles.polygons()[0].triangle, 1u);
}

TEST(CutTriangles, readingAndFinishingStopAtTheNextLook) {
    const ScenePointer scene = sceneOf({randomTriangles(5, 4'000, 2.0)});
    const StoppedWork reading = stoppedAfter(5'000, [&](const Progress& progress) { (void)CutTriangles(*scene, progress); });
    EXPECT_TRUE(reading.interrupted);
    EXPECT_LE(reading.stepsAfter, WorkCheck::kBetween);
    CutTriangles triangles(*scene);
    for (uint32_t polygon = 0; polygon < 4'000; ++polygon)
        if (triangles.place(polygon, across(0.1)) == Place::Across) (void)triangles.cut(polygon, across(0.1));
    ASSERT_GT(triangles.cuts(), 1'000u);
    const StoppedWork finishing = stoppedAfter(1, [&](const Progress& progress) { triangles.finish(progress); });
    EXPECT_TRUE(finishing.interrupted);
    EXPECT_LE(finishing.stepsAfter, WorkCheck::kBetween);
}

TEST(CutTriangles, endsSoonAfterAStopAlsoWhereNoCornerIsShared) {
    const uint64_t count = howMany(1'000'000, 200'000);
    std::vector<Vec3f> corners;
    for (uint64_t i = 0; i < count; ++i) {
        const Vec3f at(float(i % 1000), float(i / 1000), 0.0f);
        corners.insert(corners.end(), {at, at + Vec3f(0.5f, 0, 0), at + Vec3f(0, 0.5f, 0)});
    }
    const ScenePointer scene = sceneOf({soupMesh(std::move(corners))});
    for (const uint64_t steps : {count, 2 * count, 3 * count - 10'000, 5 * count}) {
        const StoppedWork stopped = stoppedAfter(steps, [&](const Progress& progress) { (void)CutTriangles(*scene, progress); });
        EXPECT_TRUE(stopped.interrupted) << steps;
        EXPECT_LE(stopped.endMilliseconds, fewSamples() ? 1000.0 : 100.0) << steps;
    }
}

}  // namespace
}  // namespace cullscope::test::cut_triangles_test
