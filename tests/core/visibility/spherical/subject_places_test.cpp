// Where rays, cells, regions and bands lie that the steps of the spherical strategies speak of.

#include "core/visibility/spherical/map_details.h"
#include "core/visibility/spherical/recorded_tests.h"
#include "core/visibility/subject_shape.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::subject_places_test {
namespace {

/// A star away from the origin of the world, turned and stretched.
ScenePointer star(size_t triangles) {
    Mat4 place = translation({1.0, -2.0, 0.5}) * scaling({1.5, 1.5, 1.5});
    return sceneOf({starMesh(7, triangles)}, {place});
}

struct Stepped {
    Stepped(const char* id, double distance, double degrees, size_t triangles = 8'000)
        : scene(star(triangles)), culler(makeCuller(id)) {
        culler->build(*scene);
        const Sphere& around = scene->instanceSphere(0);
        centre = around.centre;
        radius = around.radius;
        // Beside the poles of the map, so that the region is no cap around one.
        eye = centre + Vec3(distance, 0.1, 0.3);
        const View view({eye, centre, {0, 1, 0}, Angle::fromDegrees(degrees), 0.05, 60}, {160, 120});
        log = culler->cull(view, Recording::On).log;
        snapshot = culler->snapshot(log);
    }

    /// Calls `use(decision, shape)` for each decision about a kind of subject; returns their number.
    template <typename Use>
    size_t each(Subject::Kind kind, const Use& use) const {
        size_t count = 0;
        for (const Decision& decision : log.decisions) {
            if (decision.subject.kind != kind) continue;
            use(decision, subjectShape(*scene, log, snapshot, {nullptr, &decision, 0}));
            ++count;
        }
        return count;
    }
    [[nodiscard]] bool onSphere(const std::vector<Vec3>& line) const {
        return std::ranges::all_of(
            line, [&](const Vec3& point) { return std::abs(glm::distance(point, centre) - radius) < 1e-5 * radius; });
    }

    ScenePointer scene;
    CullerPointer culler;
    Vec3 centre{0.0}, eye{0.0};
    double radius = 0.0;
    FrameLog log;
    StructureSnapshot snapshot;
};

TEST(SubjectPlaces, rayIsALineFromTheEyeToTheTriangleThatItHits) {
    const Stepped stepped("spherical", 3.0, 20.0);
    size_t hits = 0;
    const size_t rays = stepped.each(Subject::Kind::Ray, [&](const Decision& decision, const SubjectShape& shape) {
        ASSERT_EQ(shape.object, 0u);
        EXPECT_TRUE(shape.boxes.empty()) << "the object's box is not what is in hand";
        ASSERT_FALSE(shape.lines.empty());
        ASSERT_GE(shape.lines.front().size(), 2u);
        EXPECT_LT(glm::distance(shape.lines.front().front(), stepped.eye), 1e-5);
        if (decision.containment != Containment::Inside) return;
        ++hits;
        ASSERT_TRUE(shape.triangle);
        ASSERT_EQ(shape.triangles.size(), 1u);
        Box3 box;
        for (const Vec3& corner : shape.triangles.front()) box.add(corner);
        const Vec3 end = shape.lines.front().back();
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GT(end[axis], box.min[axis] - 1e-4);
            EXPECT_LT(end[axis], box.max[axis] + 1e-4);
        }
    });
    EXPECT_EQ(rays, 8u) << "each enters the sphere and has a result";
    EXPECT_GT(hits, 0u);
}

TEST(SubjectPlaces, objectIsItsSphereWhichIsComparedWithThePlanes) {
    const Stepped stepped("spherical", 3.0, 20.0);
    const size_t objects = stepped.each(Subject::Kind::Object, [&](const Decision& /*decision*/, const SubjectShape& shape) {
        EXPECT_EQ(shape.object, 0u);
        EXPECT_TRUE(shape.boxes.empty()) << "the planes are not compared with its box";
        ASSERT_EQ(shape.lines.size(), 3u);
        for (const std::vector<Vec3>& circle : shape.lines) EXPECT_TRUE(stepped.onSphere(circle));
    });
    EXPECT_GT(objects, 0u);
}

TEST(SubjectPlaces, walkedCellIsOutlinedOnTheSphereAndOnTheMap) {
    const Stepped stepped("spherical", 3.0, 20.0);
    const spherical::MapSnapshot& map = spherical::mapsOf(stepped.snapshot).front();
    const SphericalGrid& grid = map.maps->grid();
    const size_t cells = stepped.each(Subject::Kind::Cell, [&](const Decision& decision, const SubjectShape& shape) {
        const SphericalGrid::Cell cell = grid.cell(decision.subject.number);
        ASSERT_EQ(shape.lines.size(), 2u) << "the ray and the cell";
        EXPECT_FALSE(stepped.onSphere(shape.lines.front()));
        EXPECT_TRUE(stepped.onSphere(shape.lines.back()));
        ASSERT_EQ(shape.mapLines.size(), 2u);
        for (const Vec2& point : shape.mapLines.back()) {
            EXPECT_GE(point.x, grid.thetaOf(cell.row));
            EXPECT_LE(point.x, grid.thetaOf(cell.row + 1));
            EXPECT_GE(point.y, grid.phiOf(cell.column));
            EXPECT_LE(point.y, grid.phiOf(cell.column + 1));
        }
    });
    EXPECT_GT(cells, 8u);
}

TEST(SubjectPlaces, regionBoxesAndRangesAreOutlined) {
    const Stepped stepped("spherical", 3.0, 20.0);
    const spherical::MapSnapshot& map = spherical::mapsOf(stepped.snapshot).front();
    const spherical::CellGroups groups(map.decision);
    size_t regions = 0, boxes = 0, ranges = 0;
    stepped.each(Subject::Kind::Cells, [&](const Decision& decision, const SubjectShape& shape) {
        ASSERT_FALSE(shape.mapLines.empty());
        for (const std::vector<Vec3>& line : shape.lines) EXPECT_TRUE(stepped.onSphere(line));
        EXPECT_EQ(shape.lines.size(), shape.mapLines.size());
        const uint32_t number = decision.subject.number;
        regions += number == spherical::CellGroups::kRegion ? 1 : 0;
        boxes += groups.boxOf(number) ? 1 : 0;
        ranges += groups.rangeOf(number) ? 1 : 0;
        EXPECT_EQ(groups.rangeOf(number).has_value(), decision.outcome == Decision::Outcome::Drawn);
        EXPECT_LE(shape.mapLines.size(), 3u) << "a range is whole rows and two parts of rows at most";
    });
    EXPECT_EQ(regions, 1u);
    EXPECT_EQ(boxes, map.decision.region->boxes.size());
    EXPECT_GT(ranges, 5u);
}

TEST(SubjectPlaces, bandIsAContourLineAndAnIntervalOfItsSectorsCurve) {
    for (const char* id : {"spherical", "spherical-horizon"}) {
        SCOPED_TRACE(id);
        const Stepped stepped(id, 8.0, 60.0);
        const spherical::MapSnapshot& map = spherical::mapsOf(stepped.snapshot).front();
        ASSERT_TRUE(map.decision.bands);
        const spherical::ContourBands& bands = *map.decision.bands;
        const size_t tested = stepped.each(Subject::Kind::Band, [&](const Decision& decision, const SubjectShape& shape) {
            EXPECT_TRUE(shape.boxes.empty());
            ASSERT_EQ(shape.lines.size(), 2u);
            for (const std::vector<Vec3>& line : shape.lines) EXPECT_TRUE(stepped.onSphere(line));
            ASSERT_TRUE(shape.onCurve);
            EXPECT_EQ(shape.onCurve->part, decision.subject.number % bands.sectors + 1);
            EXPECT_EQ(double(shape.onCurve->part), decision.operands[3]);
            const double to = std::min(180.0, decision.operands[2]);
            EXPECT_NEAR(shape.onCurve->to, to, 1e-9);
            EXPECT_NEAR(shape.onCurve->from, decision.operands[2] - bands.width * 180.0 / std::numbers::pi, 1e-9);
            ASSERT_EQ(shape.mapLines.size(), 2u);
            for (const Vec2& point : shape.mapLines.front()) {
                const Vec3 direction(std::sin(point.x) * std::cos(point.y), std::sin(point.x) * std::sin(point.y),
                                     std::cos(point.x));
                EXPECT_NEAR(bands.anglesOf(direction).x * 180.0 / std::numbers::pi, to, 0.01);
            }
            for (const std::vector<Vec2>& line : shape.mapLines)
                for (const Vec2& point : line) EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
        });
        EXPECT_GT(tested, 100u);
    }
}

TEST(SubjectPlaces, cellOfATreeIsOutlinedOnTheMapBesideItsTriangles) {
    const Stepped stepped("spherical-lossless", 3.0, 20.0);
    size_t outlined = 0;
    stepped.each(Subject::Kind::Cell, [&](const Decision& /*decision*/, const SubjectShape& shape) {
        EXPECT_FALSE(shape.boxes.empty() && shape.triangles.empty());
        outlined += shape.mapLines.empty() ? 0 : 1;
    });
    EXPECT_GT(outlined, 10u);
}

TEST(SubjectPlaces, pixelsAreSeenFromOutsideAsThePyramidThroughThem) {
    for (const char* id : {"scan-line", "depth-buffer"}) {
        SCOPED_TRACE(id);
        const Stepped stepped(id, 4.0, 40.0, std::string(id) == "depth-buffer" ? 8'000 : 100);
        const auto kind = std::string(id) == "scan-line" ? Subject::Kind::Span : Subject::Kind::Rows;
        const View view(stepped.log.camera, stepped.log.size);
        const size_t count = stepped.each(kind, [&](const Decision& decision, const SubjectShape& shape) {
            ASSERT_EQ(shape.pixels.has_value(), decision.places.count > 0);
            ASSERT_EQ(shape.sight.size(), decision.places.count > 0 ? 5u : 0u);
            if (shape.sight.empty()) return;
            const Vec3 end = shape.sight.front().back();
            EXPECT_EQ(shape.sight.front().front(), view.eye());
            const double distance = glm::dot(end - view.eye(), view.frustum().forward);
            EXPECT_GT(distance, glm::distance(view.eye(), stepped.centre)) << "to the end of the scene";
            const Vec3 expected = view.eye() + distance * view.direction((*shape.pixels)[0].x, (*shape.pixels)[0].y);
            EXPECT_LT(glm::distance(end, expected), 1e-9 * distance);
        });
        EXPECT_GT(count, 1u);
    }
}

}  // namespace
}  // namespace cullscope::test::subject_places_test
