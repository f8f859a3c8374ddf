// Cases 12 to 17 of the battery of extreme cases and other requirements on `spherical` and `spherical-horizon`, without pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/visibility/spherical/map_details.h"
#include "core/visibility/spherical/object_space_view.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/slope_horizon.h"
#include "core/visibility/spherical/visible_region.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/spherical_views.h"

namespace cullscope::test::spherical_test {
namespace {

constexpr double kPi = std::numbers::pi;

spherical::SphericalDecision decisionOf(Culler& strategy, const View& view, size_t instance = 0) {
    const Culled frame = strategy.cull(view, Recording::On);
    return spherical::decisionsOf(frame.log).at(instance);
}

/// An eye at 3 R from a unit sphere at a latitude: case 12.
Vec3 atLatitude(double degrees) {
    const double latitude = degrees * kPi / 180.0;
    // At an azimuth that is no boundary of a map.
    return 3.0 * Vec3(std::cos(latitude) * std::cos(2.1), std::cos(latitude) * std::sin(2.1), std::sin(latitude));
}

/// The share of the picture's rays whose hit on the unit sphere lies in none of the region's boxes.
double shareOutsideBoxes(const spherical::VisibleRegion& region, const SphericalGrid& grid, const View& view) {
    int outside = 0, all = 0;
    const Viewport size = view.viewport();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Ray ray{view.eye(), view.direction(x + 0.5, y + 0.5)};
            const std::optional<Span> span = throughSphere(ray, 1.0);
            if (!span) continue;
            const SphericalGrid::Cell cell = grid.cellOf(ray.at(span->from));
            const bool snapshot = std::any_of(region.boxes.begin(), region.boxes.end(), [&](const spherical::CellBox& box) {
                return box.firstRow <= cell.row && cell.row <= box.lastRow && box.firstColumn <= cell.column &&
                       cell.column <= box.lastColumn;
            });
            ++all;
            outside += snapshot ? 0 : 1;
        }
    return double(outside) / all;
}

/// The map of a unit sphere, independent of the mesh's facets: hits are moved to the sphere itself.
double shareLost(double latitude, spherical::Join join) {
    static const SphericalMaps maps(sphereMesh(2000), fewSamples() ? SphericalGrid(3600, 1800) : SphericalGrid(7200, 3600));
    const View view = lookingAt(atLatitude(latitude), Vec3(0.0), 20.0, {200, 200});
    std::array<spherical::CornerRay, 4> corners;
    const std::array<Vec3, 8> directions = view.frustum().corners();
    for (size_t i = 0; i < 4; ++i) {
        corners[i].ray = {view.eye(), directions[i]};
        corners[i].point = corners[i].ray.at(throughSphere(corners[i].ray, 1.0)->from);
    }
    return shareOutsideBoxes(spherical::visibleRegion(maps, corners, join, std::nullopt), maps.grid(), view);
}

TEST(Spherical, case12CornerBoxLosesTheSharesThatAreKnown) {
    // Case 12: 0, 10 and 25 % of the rays at 3 R and 20°. At 75° the corners' box alone would lose 64 % and at 80° 81 %; there
    // the pole is in view, so that case 1 draws full rows.
    EXPECT_NEAR(shareLost(0.0, spherical::Join::Chart), 0.0, 0.005);
    EXPECT_NEAR(shareLost(45.0, spherical::Join::Chart), 0.10, 0.01);
    EXPECT_NEAR(shareLost(60.0, spherical::Join::Chart), 0.25, 0.015);
    for (const double latitude : {75.0, 80.0, 90.0}) EXPECT_EQ(shareLost(latitude, spherical::Join::Chart), 0.0) << latitude;
    // Great-circle arcs reach extremes between the corners.
    for (const double latitude : {45.0, 60.0})
        EXPECT_LT(shareLost(latitude, spherical::Join::Arcs), shareLost(latitude, spherical::Join::Chart));
}

TEST(Spherical, casesBoxesAndRangesAreThoseOfTheView) {
    const ScenePointer scene = sceneOf({sphereMesh(80'000)});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    struct Expected {
        Vec3 eye;
        int number;
        size_t boxes;
    };
    for (const Expected& expected : {Expected{{0, 0, 3}, 1, 1}, Expected{{0.1, -0.1, -3}, 1, 1}, Expected{{-3, 0, 0}, 2, 1},
                                     Expected{{0, 3, 0.5}, 2, 1}, Expected{{3, 0, 0}, 3, 2}, Expected{{3, 0.2, -0.5}, 3, 2}}) {
        const View view = lookingAt(expected.eye, Vec3(0.0), 20.0);
        const Culled frame = strategy->cull(view);
        const spherical::SphericalDecision decision = decisionOf(*strategy, view);
        ASSERT_EQ(decision.relation, spherical::SphereRelation::Cut);
        EXPECT_EQ(frame.caseNumber, expected.number) << expected.eye.x << " " << expected.eye.y << " " << expected.eye.z;
        EXPECT_EQ(decision.region->caseNumber, expected.number);
        EXPECT_EQ(decision.region->boxes.size(), expected.boxes);
        for (const spherical::CornerRay& ray : decision.rays) EXPECT_TRUE(ray.hit && ray.span && !ray.walkedCells.empty());
        // Full rows are one range; case 2 has one range for each row; case 3 has two.
        const size_t rows = decision.region->boxes[0].lastRow - decision.region->boxes[0].firstRow + 1;
        EXPECT_EQ(decision.drawn.size(), expected.number == 1 ? 1 : expected.number == 2 ? rows : 2 * rows);
    }
}

TEST(Spherical, viewAlongThePolarAxisGivesFullRows) {
    // Case 13: the cap around the pole, all azimuths.
    const ScenePointer scene = sceneOf({sphereMesh(80'000)});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    for (const double side : {1.0, -1.0}) {
        const spherical::SphericalDecision decision = decisionOf(*strategy, lookingAt({0, 0, 3 * side}, Vec3(0.0), 20.0));
        ASSERT_EQ(decision.region->boxes.size(), 1u);
        const spherical::CellBox box = decision.region->boxes[0];
        EXPECT_EQ(box.firstColumn, 0u);
        EXPECT_EQ(box.lastColumn, 359u);
        if (side > 0) {
            EXPECT_EQ(box.firstRow, 0u);
            EXPECT_THAT(double(box.lastRow), testing::AllOf(testing::Ge(32.0), testing::Le(34.0)));
        } else {
            EXPECT_EQ(box.lastRow, 179u);
        }
        for (const Vec2& point : decision.region->outline) EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
    }
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer whole = makeCuller(id);
        whole->build(*scene);
        const Culled frame = whole->cull(lookingAt({0, 0, 3}, Vec3(0.0), 60.0));
        EXPECT_GT(frame.consideredTriangles, 20'000u) << id;
        EXPECT_LT(frame.consideredTriangles, 60'000u) << id;
    }
}

TEST(Spherical, partlyVisibleSphereThatAllCornerRaysMissIsDrawn) {
    // Case 14: far 100, sphere (11, 0, −10), r 2.
    const ScenePointer scene = sceneOf({sphereMesh(5'000)}, {translation({11, 0, -10}) * scaling(Vec3(2.0))});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, {64, 64});
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const spherical::SphericalDecision decision = decisionOf(*strategy, view);
        EXPECT_EQ(decision.relation, spherical::SphereRelation::Cut) << id;
        EXPECT_GT(strategy->cull(view).consideredTriangles, 0u) << id;
        for (const spherical::CornerRay& ray : decision.rays) {
            if (std::string_view(id) != "spherical") continue;
            EXPECT_FALSE(ray.hit);
            EXPECT_FALSE(ray.span);
            EXPECT_NEAR(glm::length(ray.point), 1.0, 1e-3);
        }
    }
}

TEST(Spherical, eyeInsideTheSphereLosesNothing) {
    // Case 17: inside, and exactly at the centre: the result is that of `frustum`.
    const ScenePointer scene = sceneOf({sphereMesh(5'000)});
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        for (const Vec3& eye : {Vec3(0.5, 0.2, 0.1), Vec3(0.0), scene->boundingSphere().centre, Vec3(0.9999, 0.0, 0.0)}) {
            const View view = lookingAt(eye, eye + Vec3(0.3, 1.0, 0.2), 70.0);
            EXPECT_EQ(strategy->cull(view).consideredTriangles, scene->triangleCount()) << id;
            EXPECT_EQ(decisionOf(*strategy, view).relation, spherical::SphereRelation::AroundEye) << id;
        }
    }
}

TEST(Spherical, instancesShareTheirMeshsMaps) {
    std::vector<Mat4> places;
    for (int i = 0; i < 25; ++i) places.push_back(translation({3.0 * (i % 5), 0.0, 3.0 * (i / 5)}));
    const ScenePointer one = sceneOf({sphereMesh(2'000)}), many = copiesOf(sphereMesh(2'000), places);
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*one);
        const uint64_t bytes = strategy->structure().bytes;
        strategy->build(*many);
        EXPECT_EQ(strategy->structure().bytes, bytes) << id;
        // Each instance has its own relation to the frustum.
        const View view = lookingAt({6, 0.3, -5}, {6, 0, 6}, 30.0);
        const Culled frame = strategy->cull(view, Recording::On);
        std::set<spherical::SphereRelation> relations;
        for (const spherical::SphericalDecision& decision : spherical::decisionsOf(frame.log))
            relations.insert(decision.relation);
        EXPECT_THAT(relations, testing::IsSupersetOf({spherical::SphereRelation::Outside, spherical::SphereRelation::Cut,
                                                      spherical::SphereRelation::Within}))
            << id;
        EXPECT_LT(frame.consideredTriangles, many->triangleCount() / 2) << id;
        const StructureSnapshot snapshot = strategy->snapshot(frame.log);
        const std::vector<spherical::MapSnapshot>& maps = spherical::mapsOf(snapshot);
        ASSERT_EQ(maps.size(), 25u);
        for (const spherical::MapSnapshot& map : maps) EXPECT_EQ(map.maps, maps[0].maps);
    }
}

/// Every range in the list's order, no triangle twice, as many triangles as considered.
void expectSound(const Culled& frame, const Scene& scene, const std::string& where) {
    std::vector<uint8_t> times(scene.triangleCount(), 0);
    for (const DrawRange& range : frame.drawList.ranges) {
        const uint32_t mesh = scene.instances()[range.instance].mesh;
        ASSERT_EQ(range.firstIndex % 3, 0u);
        ASSERT_LE((range.firstIndex + range.indexCount) / 3, scene.meshOf(range.instance).triangleCount()) << where;
        for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            ASSERT_EQ(times[scene.firstTriangle(range.instance) + frame.drawList.triangleAt(mesh, place)]++, 0) << where;
    }
    uint64_t drawn = 0, culled = 0;
    for (const uint8_t time : times) drawn += time;
    for (const uint64_t count : frame.culledTriangles) culled += count;
    EXPECT_EQ(drawn, frame.consideredTriangles) << where;
    EXPECT_EQ(drawn + culled, scene.triangleCount()) << where;
}

TEST(Spherical, everyTriangleIsDrawnOnceAtMostAndInSoundRanges) {
    Random random(99);
    for (uint64_t seed = 1; seed <= (longMode() ? 200u : 30u); ++seed) {
        const ScenePointer scene = randomScene(seed);
        for (const char* id : {"spherical", "spherical-horizon"}) {
            const CullerPointer strategy = strategyWith(id, {{"rows", "30"}});
            strategy->build(*scene);
            for (int i = 0; i < 10; ++i) {
                const RandomView view = randomView(*scene, random);
                const Culled frame = strategy->cull(View(view.camera, view.viewport), Recording::On);
                expectSound(frame, *scene, id + std::string(" seed ") + std::to_string(seed) + " view " + std::to_string(i));
                EXPECT_EQ(frame.drawList.ranges, strategy->cull(View(view.camera, view.viewport)).drawList.ranges);
            }
        }
    }
}

TEST(Spherical, cornerRaysPassWhatTheNearPlaneCutsAway) {
    // Two walls with the near plane between them: the rays must reach the second.
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (const float z : {1.0f, -1.0f})
        for (const auto& [x, y] : {std::pair(-5.f, -5.f), {5.f, -5.f}, {5.f, 5.f}, {-5.f, 5.f}}) positions.emplace_back(x, y, z);
    for (const uint32_t base : {0u, 4u})
        for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(base + corner);
    const ScenePointer scene = sceneOf({meshOf(positions, indices)});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    const spherical::SphericalDecision decision =
        decisionOf(*strategy, View({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(20), 10.0, 100}, {64, 64}));
    ASSERT_EQ(decision.relation, spherical::SphereRelation::Cut);
    for (const spherical::CornerRay& ray : decision.rays) {
        ASSERT_TRUE(ray.hit);
        EXPECT_GE(ray.hit->triangle, 2u);
    }
}

TEST(Spherical, mapsOfManySmallMeshesStaySmall) {
    std::vector<MeshPointer> meshes(200, nullptr);
    for (MeshPointer& mesh : meshes) mesh = boxMesh({-1, -1, -1}, {1, 1, 1});
    const ScenePointer scene = sceneOf(std::move(meshes));
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        EXPECT_LT(strategy->structure().bytes, scene->triangleCount() * 1000) << id;
    }
}

TEST(Spherical, bandsAreFromNearToFar) {
    const ScenePointer scene = sceneOf({sphereMesh(80'000)});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    const spherical::SphericalDecision decision = decisionOf(*strategy, lookingAt({0, -4, 1}, Vec3(0.0), 60.0));
    ASSERT_EQ(decision.relation, spherical::SphereRelation::Within);
    const spherical::ContourBands& bands = *decision.bands;
    EXPECT_EQ(bands.bands, 36u);
    EXPECT_EQ(bands.sectors, 36u);
    EXPECT_LT(glm::distance(bands.axis, glm::normalize(Vec3(0, -4, 1))), 1e-3);
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        // S = R sin α grows up to 90°, and no S beyond exceeds it.
        for (uint32_t band = 0; band < 18; ++band) EXPECT_TRUE(bands.at(band, sector).drawn);
        for (uint32_t band = 19; band < 36; ++band) EXPECT_FALSE(bands.at(band, sector).drawn) << band << " " << sector;
        EXPECT_NEAR(bands.at(9, sector).size, std::sin(50.0 * kPi / 180.0), 0.04);
    }
    // Angles and directions are inverse functions.
    const Vec2 angles = bands.anglesOf(bands.direction(1.2, 4.0));
    EXPECT_NEAR(angles.x, 1.2, 1e-12);
    EXPECT_NEAR(angles.y, 4.0, 1e-12);
}

TEST(Spherical, quickAnglesAreWithinTheirError) {
    for (int i = -100'000; i <= 100'000; ++i) {
        const double x = i / 100'000.0;
        ASSERT_NEAR(spherical::quickAcos(x), std::acos(x), spherical::kQuickAngleError) << x;
        const double angle = (x + 1.0) * kPi;
        const double error = std::remainder(spherical::quickAzimuth(std::sin(angle), std::cos(angle)) - angle, 2.0 * kPi);
        ASSERT_LT(std::abs(error), spherical::kQuickAngleError) << angle;
    }
    EXPECT_EQ(spherical::quickAzimuth(0.0, 0.0), 0.0);
}

TEST(Spherical, whyNamesCaseAndCause) {
    const ScenePointer scene = sceneOf({sphereMesh(5'000)});
    const CullerPointer strategy = makeCuller("spherical");
    strategy->build(*scene);
    const auto sentences = [&](const View& view, uint64_t triangle) {
        const Culled frame = strategy->cull(view, Recording::On);
        std::string text;
        for (const WhyStep& step : why(*strategy->built(), frame.log, triangle)) text += step.sentence.english() + "\n";
        return text;
    };
    const auto nearest = [&](const Vec3& direction) {
        uint64_t best = 0;
        double most = -1.0;
        for (uint64_t triangle = 0; triangle < scene->triangleCount(); ++triangle) {
            const Vec3 corner(scene->meshOf(0).positions()[scene->meshOf(0).indices()[3 * triangle]]);
            if (glm::dot(corner, direction) > most) best = triangle;
            most = std::max(most, glm::dot(corner, direction));
        }
        return best;
    };
    const View close = lookingAt({-3, 0, 0}, Vec3(0.0), 15.0), whole = lookingAt({-3, 0, 0}, Vec3(0.0), 60.0);
    EXPECT_THAT(sentences(close, nearest({-1, 0, 0})), testing::HasSubstr("boxes (case 2)"));
    EXPECT_THAT(sentences(close, nearest({-1, 0, 0})), testing::HasSubstr("is given to OpenGL"));
    EXPECT_THAT(sentences(close, nearest({1, 0, 0})), testing::HasSubstr("outside the visible region's boxes"));
    EXPECT_THAT(sentences(whole, nearest({1, 0, 0})), testing::HasSubstr("the largest before it: hidden"));
    EXPECT_THAT(sentences(whole, nearest({-1, 0, 0})), testing::HasSubstr("in the near half"));
}

}  // namespace
}  // namespace cullscope::test::spherical_test
