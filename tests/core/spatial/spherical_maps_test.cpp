// Each triangle is in one cell of the centroid map and in every cell of the index map that it touches.
#include "core/spatial/spherical_maps.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/spatial/spherical_triangle.h"
#include "tests/support/spherical_meshes.h"
#include "tests/support/stopped_work.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::spherical_maps_test {
namespace {

/// Visits points of a triangle: its corners, points along its edges and inside; more densely near the extreme θ of an arc.
template <typename Visit>
void forPoints(const std::array<Vec3, 3>& corners, Random& random, int count, const Visit& visit) {
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        visit(a);
        for (int step = 1; step < count; ++step) visit(a + double(step) / count * (b - a));
        // An arc has its extreme θ where its plane's normal, the axis and the point are coplanar.
        const Vec3 normal = glm::cross(a, b);
        const Vec3 top = glm::cross(normal, glm::cross(normal, Vec3(0.0, 0.0, 1.0)));
        // The point on the edge: a + s (b − a) parallel to top.
        const Vec3 side = glm::cross(normal, top);
        const double from = glm::dot(side, a), way = glm::dot(side, b - a);
        if (way == 0.0) continue;
        for (const double shift : {-1e-6, -1e-9, 0.0, 1e-9, 1e-6})
            if (const double s = -from / way + shift; s >= 0.0 && s <= 1.0) visit(a + s * (b - a));
    }
    for (int i = 0; i < count; ++i) {
        double u = random.unit(), v = random.unit();
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        visit(corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]));
    }
}

TEST(SphericalTriangle, touchesEveryCellThatAPointOfItLiesIn) {
    Random random(21);
    for (const MeshPointer& mesh : {awkwardTriangles(), randomTriangles(31, uint32_t(howMany(20'000, 2'000)))})
        for (const SphericalGrid& grid : {SphericalGrid(), SphericalGrid(24, 12), SphericalGrid(5, 3)})
            for (size_t triangle = 0; triangle < mesh->triangleCount(); ++triangle) {
                std::array<Vec3, 3> corners;
                for (size_t i = 0; i < 3; ++i) corners[i] = Vec3(mesh->positions()[mesh->indices()[3 * triangle + i]]);
                std::set<uint32_t> touched;
                SphericalTriangle(corners[0], corners[1], corners[2]).forEachCell(grid, [&](const SphericalGrid::Cell& cell) {
                    EXPECT_TRUE(touched.insert(grid.number(cell)).second) << "twice, triangle " << triangle;
                });
                forPoints(corners, random, 40, [&](const Vec3& point) {
                    const SphericalGrid::Cell cell = grid.cellOf(point);
                    ASSERT_TRUE(point == Vec3(0.0) || touched.count(grid.number(cell)) > 0)
                        << "triangle " << triangle << " of " << mesh->triangleCount() << ", row " << cell.row << ", column "
                        << cell.column << " of " << grid.columns() << " × " << grid.rows();
                });
            }
}

TEST(SphericalTriangle, touchesHardlyMoreThanItsOwnCells) {
    const SphericalGrid grid(72, 36);
    Random random(22);
    uint64_t touched = 0, confirmed = 0;
    const MeshPointer mesh = randomTriangles(41, 300);
    for (size_t triangle = 0; triangle < mesh->triangleCount(); ++triangle) {
        std::array<Vec3, 3> corners;
        for (size_t i = 0; i < 3; ++i) corners[i] = Vec3(mesh->positions()[mesh->indices()[3 * triangle + i]]);
        std::set<uint32_t> found;
        forPoints(corners, random, 4'000, [&](const Vec3& point) { found.insert(grid.number(grid.cellOf(point))); });
        SphericalTriangle(corners[0], corners[1], corners[2]).forEachCell(grid, [&](const SphericalGrid::Cell&) { ++touched; });
        confirmed += found.size();
    }
    EXPECT_GE(touched, confirmed);
    // Beside corners, three half-spaces and a cap give a few cells too many; samples give a few too few.
    EXPECT_LT(double(touched), 1.25 * double(confirmed));
}

/// A cone of slivers that meet at the pole of the maps: its apex lies above the middle of its base, which is flat.
MeshPointer coneOfSlivers(uint32_t sides) {
    std::vector<Vec3f> positions{{0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -1.0f}};
    std::vector<uint32_t> indices;
    for (uint32_t side = 0; side < sides; ++side) {
        const double turn = 2.0 * std::numbers::pi * side / sides;
        positions.emplace_back(Vec3(std::cos(turn), std::sin(turn), -1.0));
        const uint32_t here = 2 + side, next = 2 + (side + 1) % sides;
        indices.insert(indices.end(), {0, here, next, 1, next, here});
    }
    return meshOf(std::move(positions), std::move(indices));
}

TEST(SphericalTriangle, visitsTheCellsThatItTouchesAndNoOther) {
    for (const MeshPointer& mesh : {awkwardTriangles(), randomTriangles(51, howMany(2'000, 300)), coneOfSlivers(40)})
        for (const SphericalGrid& grid : {SphericalGrid(48, 24), SphericalGrid(5, 3), SphericalGrid(4, 2), SphericalGrid(31, 64)})
            for (size_t triangle = 0; triangle < mesh->triangleCount(); ++triangle) {
                std::array<Vec3, 3> corners;
                for (size_t i = 0; i < 3; ++i) corners[i] = Vec3(mesh->positions()[mesh->indices()[3 * triangle + i]]);
                const SphericalTriangle directions(corners[0], corners[1], corners[2]);
                std::vector<uint32_t> visited, touched;
                directions.forEachCell(grid, [&](const SphericalGrid::Cell& cell) { visited.push_back(grid.number(cell)); });
                for (uint32_t number = 0; number < grid.cellCount(); ++number)
                    if (directions.touches(grid, grid.cell(number))) touched.push_back(number);
                std::ranges::sort(visited);
                ASSERT_EQ(visited, touched) << "triangle " << triangle << " on " << grid.columns() << " × " << grid.rows();
            }
}

TEST(SphericalTriangle, sliverAtAPoleIsTestedInProportionToTheCellsItTouches) {
    const MeshPointer mesh = coneOfSlivers(300'000);
    const SphericalGrid grid;
    for (size_t triangle = 0; triangle < mesh->triangleCount(); triangle += 10'007) {
        std::array<Vec3, 3> corners;
        for (size_t i = 0; i < 3; ++i) corners[i] = Vec3(mesh->positions()[mesh->indices()[3 * triangle + i]]);
        uint64_t touched = 0;
        const uint64_t tested =
            SphericalTriangle(corners[0], corners[1], corners[2]).forEachCell(grid, [&](const SphericalGrid::Cell&) {
                ++touched;
            });
        EXPECT_GT(touched, 360u) << "all columns of the row at the pole";
        EXPECT_LT(tested, 8 * touched) << "triangle " << triangle << " touches " << touched << " of " << grid.cellCount();
    }
}

TEST(SphericalMaps, everyTriangleIsInItsCentroidsCellOnce) {
    for (const MeshPointer& mesh : mapTestMeshes()) {
        const SphericalMaps maps(mesh, SphericalGrid());
        std::vector<int> times(mesh->triangleCount(), 0);
        for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell) {
            float before = 0.0f;
            for (const uint32_t triangle : maps.centroids(cell)) {
                const std::array<Vec3, 3> corners = maps.corners(triangle);
                const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
                const float radius = maps.centroidRadius(triangle), expected = float(glm::length(centroid));
                // One condition a triangle, for there are many.
                if (maps.grid().number(maps.grid().cellOf(centroid)) != cell || radius < before ||
                    std::abs(radius - expected) > 4e-7f * expected)
                    ADD_FAILURE() << mesh->name() << ", triangle " << triangle << ", cell " << cell << ": " << radius << " for "
                                  << expected << " after " << before;
                before = maps.centroidRadius(triangle);
                ++times[triangle];
            }
        }
        EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int count) { return count == 1; })) << mesh->name();
    }
}

TEST(SphericalMaps, everyTriangleIsInEveryCellThatItTouches) {
    Random random(23);
    for (const MeshPointer& mesh : mapTestMeshes()) {
        const SphericalMaps maps(mesh, SphericalGrid());
        const size_t stride = longMode() ? 1 : std::max<size_t>(1, mesh->triangleCount() / 1'000);
        for (uint32_t triangle = 0; triangle < mesh->triangleCount(); triangle += uint32_t(stride))
            forPoints(maps.corners(triangle), random, 12, [&](const Vec3& point) {
                if (point == Vec3(0.0)) return;
                const uint32_t cell = maps.grid().number(maps.grid().cellOf(point));
                const auto found = maps.triangles(cell);
                ASSERT_NE(std::find(found.begin(), found.end(), triangle), found.end())
                    << mesh->name() << ", triangle " << triangle << ", cell " << cell;
                const auto radius = float(glm::length(point));
                EXPECT_LE(maps.extent(cell).nearest, radius * (1.0f + 1e-6f) + 1e-12f);
                EXPECT_GE(maps.extent(cell).farthest, radius * (1.0f - 1e-6f));
            });
    }
}

TEST(SphericalMaps, aRunOfCellsIsOneRangeOfTheIndexBuffer) {
    const MeshPointer mesh = starMesh(3, 20'000);
    const SphericalMaps maps(mesh, SphericalGrid());
    ASSERT_EQ(maps.indices().size(), mesh->indices().size());
    const auto [first, count] = maps.run(0, maps.grid().cellCount());
    EXPECT_EQ(first, 0u);
    EXPECT_EQ(count, mesh->triangleCount());
    uint64_t place = 0;
    for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell) {
        EXPECT_EQ(maps.run(cell, cell + 1), (std::pair<uint64_t, uint64_t>(place, maps.centroids(cell).size())));
        for (const uint32_t triangle : maps.centroids(cell)) {
            EXPECT_EQ(maps.triangleAt(place), triangle);
            for (size_t i = 0; i < 3; ++i) ASSERT_EQ(maps.indices()[3 * place + i], mesh->indices()[3 * size_t(triangle) + i]);
            ++place;
        }
    }
}

TEST(SphericalMaps, theNumberOfThreadsChangesNothing) {
    const MeshPointer mesh = knotMesh(60'000);
    const auto made = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return std::make_unique<SphericalMaps>(mesh, SphericalGrid());
    };
    const auto one = made(1), four = made(4);
    ASSERT_EQ(one->indexEntries(), four->indexEntries());
    for (uint32_t cell = 0; cell < one->grid().cellCount(); ++cell) {
        const auto a = one->triangles(cell), b = four->triangles(cell);
        ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << cell;
    }
    EXPECT_TRUE(std::equal(one->indices().begin(), one->indices().end(), four->indices().begin(), four->indices().end()));
}

TEST(SphericalMaps, areNoLargerThanThePapersTable1) {
    const SphericalMaps maps(starMesh(7, 144'046), SphericalGrid());
    const SphericalMaps::Bytes bytes = maps.bytes();
    RecordProperty("bytes", std::to_string(bytes.all()));
    EXPECT_LE(bytes.all(), 8'000'000u) << bytes.centroidMap << " " << bytes.indexMap << " " << bytes.accessMap;
}

TEST(SphericalMaps, storageByEntriesGivesTheSameAnswers) {
    for (const MeshPointer& mesh : {starMesh(3, 20'000), awkwardTriangles(), randomTriangles(8, 500), coneOfSlivers(40)})
        for (const SphericalGrid& grid : {SphericalGrid(), SphericalGrid(12, 6)}) {
            const SphericalMaps cells(mesh, grid);
            const SphericalMaps entries(mesh, grid, {mesh->localSphere()}, MapStorage::Entries);
            Random random(17);
            uint64_t narrowed = 0;
            for (uint32_t cell = 0; cell < grid.cellCount(); ++cell) {
                ASSERT_TRUE(std::ranges::equal(cells.triangles(cell), entries.triangles(cell))) << cell;
                ASSERT_EQ(cells.extent(cell).nearest, entries.extent(cell).nearest) << cell;
                ASSERT_EQ(cells.extent(cell).farthest, entries.extent(cell).farthest) << cell;
                const auto last = uint32_t(random.between(cell, grid.cellCount()));
                ASSERT_EQ(cells.run(cell, last + 1), entries.run(cell, last + 1)) << cell << " to " << last;
                // Every triangle with a point between the distances is among those that are looked at.
                const double nearest = random.between(0.0, mesh->localSphere().radius),
                             farthest = nearest * random.between(1.0, 1.1);
                const auto found = entries.trianglesBetween(cell, nearest, farthest);
                narrowed += entries.triangles(cell).size() - found.size();
                for (const uint32_t triangle : entries.triangles(cell)) {
                    ASSERT_EQ(cells.centroidRadius(triangle), entries.centroidRadius(triangle));
                    double least = std::numeric_limits<double>::infinity(), most = 0.0;
                    for (const Vec3& corner : entries.corners(triangle)) {
                        least = std::min(least, glm::length(corner));
                        most = std::max(most, glm::length(corner));
                    }
                    if (least <= farthest && most >= nearest)
                        ASSERT_TRUE(std::ranges::count(found, triangle)) << triangle << " in " << cell;
                }
            }
            EXPECT_GT(narrowed, 0u);
        }
}

TEST(SphericalMaps, storageByEntriesHasTheBytesOfThePapersFormulas) {
    const MeshPointer mesh = starMesh(7, 20'000);
    const SphericalGrid grid;
    const SphericalMaps cells(mesh, grid), entries(mesh, grid, {mesh->localSphere()}, MapStorage::Entries);
    const uint64_t starts = 4 * (grid.cellCount() + 1), triangles = mesh->triangleCount();
    EXPECT_EQ(entries.bytes().centroidMap, 4 * 4 * triangles + starts);
    EXPECT_EQ(entries.bytes().indexMap, 2 * 4 * entries.indexEntries() + starts);
    EXPECT_EQ(entries.bytes().accessMap, 4 * 4 * grid.cellCount() + 12 * triangles) << "and the vertices in the cells' order";
    EXPECT_EQ(cells.bytes().indexMap, 4 * cells.indexEntries() + 8 * grid.cellCount() + starts);
}

TEST(SphericalMaps, anIndexMapThatWouldNotFitIsRefused) {
    const MeshPointer mesh = starMesh(7, 5'000);
    const uint64_t entries = SphericalMaps(mesh, SphericalGrid()).indexEntries();
    EXPECT_NO_THROW(SphericalMaps(mesh, SphericalGrid(), {}, entries));
    EXPECT_THROW(SphericalMaps(mesh, SphericalGrid(), {}, entries - 1), Error);
}

TEST(SphericalMaps, stopIsHeard) {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    EXPECT_THROW(SphericalMaps(starMesh(7, 5'000), SphericalGrid(), progress), Error);
}

TEST(SphericalMaps, stopIsHeardWhileListsAreSorted) {
    const MeshPointer mesh = coneOfSlivers(2'000);
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const StoppedWork work =
        stoppedAfter(500'000, [&](const Progress& progress) { (void)SphericalMaps(mesh, SphericalGrid(), progress); });
    EXPECT_TRUE(work.interrupted);
    EXPECT_GE(work.stepsBefore, 500'000u) << "the row at the pole alone has 1.4 million entries";
    EXPECT_LE(work.stepsAfter, 2 * WorkCheck::kBetween);
}

}  // namespace
}  // namespace cullscope::test::spherical_maps_test
