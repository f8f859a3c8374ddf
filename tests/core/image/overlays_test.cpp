// The positions of overlay lines in the world.

#include "core/image/overlays.h"

#include <map>

#include "core/gpu/colour.h"
#include "core/image/view_picture.h"
#include "core/visibility/spherical/map_overlays.h"
#include "tests/support/hand_made_map.h"
#include "tests/support/line_distance.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::overlays_test {
namespace {

/// One map over a mesh that is moved, rotated and enlarged, as seen from a viewing camera.
struct Seen {
    explicit Seen(const spherical::MapSnapshot& map) {
        maps = {map};
        scene = sceneOf({std::make_shared<TriangleMesh>(dataOf(map.maps->mesh()))}, {place});
    }
    static TriangleMesh::Data dataOf(const TriangleMesh& mesh) {
        TriangleMesh::Data data;
        data.positions.assign(mesh.positions().begin(), mesh.positions().end());
        data.indices.assign(mesh.indices().begin(), mesh.indices().end());
        return data;
    }
    /// A point in the map's coordinates, transformed to the world.
    [[nodiscard]] Vec3 world(const Vec3& point) const { return Vec3(place * Vec4(maps[0].maps->sphere().centre + point, 1.0)); }
    [[nodiscard]] Vec3 local(const Vec3& point) const {
        return Vec3(glm::inverse(place) * Vec4(point, 1.0)) - maps[0].maps->sphere().centre;
    }
    [[nodiscard]] OverlayContext context() const {
        return {
            *scene, view, style, verdictPalette(style.background), contrastTo(style.background), planePalette(style.background)};
    }
    [[nodiscard]] double radius() const { return maps[0].maps->sphere().radius; }

    // Rotated by a right angle about x, twice as large, moved.
    Mat4 place = translation({100, -50, 25}) * Mat4(Vec4(2, 0, 0, 0), Vec4(0, 0, 2, 0), Vec4(0, -2, 0, 0), Vec4(0, 0, 0, 1));
    std::vector<spherical::MapSnapshot> maps;
    StructureSnapshot snapshot;
    ScenePointer scene;
    View view{{Vec3(100, -50, 37), Vec3(100, -50, 25), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {640, 480}};
    DrawStyle style{Vec3f(1.0f)};
};

constexpr double kPixel = 0.02;  ///< size of a pixel in the world, at the object

TEST(SphereOverlay, circlesAreGreatCircles) {
    spherical::MapSnapshot map = sphereMap();
    map.decision.relation = spherical::SphereRelation::Within;
    const Seen seen(map);
    const std::vector<OverlayLines> overlays = spherical::sphereOverlay(seen.context(), seen.maps);
    for (const LineSegment& line : overlays[0].lines) {
        const Vec3 point = seen.local(line.from);
        EXPECT_NEAR(glm::length(point), seen.radius(), 1e-9);
        EXPECT_LT(std::min({std::abs(point.x), std::abs(point.y), std::abs(point.z)}), 1e-9);
    }
    for (int angle = 0; angle < 360; angle += 10) {
        EXPECT_LT(distanceTo(overlays[0].lines, seen.world(seen.radius() * directionOf(90, angle))), kPixel);
        EXPECT_LT(distanceTo(overlays[0].lines, seen.world(seen.radius() * directionOf(angle, 0))), kPixel);
        EXPECT_LT(distanceTo(overlays[0].lines, seen.world(seen.radius() * directionOf(angle, 90))), kPixel);
    }
    EXPECT_TRUE(overlays[1].lines.empty() && overlays[2].lines.empty());
}

TEST(SphereOverlay, objectOutsideHasNoLines) {
    const Seen seen(sphereMap());
    for (const OverlayLines& overlay : spherical::sphereOverlay(seen.context(), seen.maps)) EXPECT_TRUE(overlay.lines.empty());
}

TEST(SphereOverlay, regionAndRaysLieInTheirPlaces) {
    for (const auto& [left, right] : {std::pair(100.0, 200.0), std::pair(320.0, 400.0)}) {
        const spherical::MapSnapshot map = cutMap(left, right);
        const Seen seen(map);
        const std::vector<OverlayLines> overlays = spherical::sphereOverlay(seen.context(), seen.maps);
        const auto onSphere = [&](double theta, double phi) { return seen.world(seen.radius() * directionOf(theta, phi)); };
        for (double phi = left; phi <= right; phi += 4.0) {
            EXPECT_LT(distanceTo(overlays[1].lines, onSphere(60, phi)), kPixel);
            EXPECT_LT(distanceTo(overlays[1].lines, onSphere(100, phi)), kPixel);
        }
        EXPECT_GT(distanceTo(overlays[1].lines, onSphere(75, left - 20.0)), 0.2);
        for (const spherical::CornerRay& ray : map.decision.rays) {
            EXPECT_LT(distanceTo(overlays[1].lines, seen.world(0.5 * (map.decision.eye + ray.point))), 1e-6);
            ASSERT_TRUE(ray.span);
            EXPECT_LT(distanceTo(overlays[2].lines, seen.world(ray.ray.at(ray.span->from))), 0.2) << "no mark at the entry";
            EXPECT_LT(distanceTo(overlays[2].lines, seen.world(ray.point)), 1e-6) << "no mark at the end";
        }
        EXPECT_EQ(overlays[2].lines.size(), 4u * 12 + 3 * 24 + 2) << "rings where they enter, dots where they hit, one cross";
    }
}

TEST(GroupOverlay, exactlyTheTestedGroupsHaveABox) {
    Seen seen(sphereMap());
    const auto node = [](int32_t parent, uint32_t instance, double size, Containment containment) {
        SnapshotNode made;
        made.parent = parent;
        made.instance = instance;
        made.box = {Vec3(-size), Vec3(size)};
        made.containment = containment;
        made.culled = containment == Containment::Outside;
        // Those of these sizes were decided with their groups.
        made.tested = size != 7 && size != 5;
        return made;
    };
    using enum Containment;
    constexpr uint32_t kGroup = SnapshotNode::kGroup;
    // A root that straddles; below it a group outside and one inside, each containing a group that was decided with it.
    seen.snapshot.nodes = {node(4, 0, 1, Outside),      node(5, 1, 2, Inside),       node(-1, kGroup, 10, Straddles),
                           node(2, kGroup, 8, Outside), node(3, kGroup, 7, Outside), node(6, kGroup, 5, Inside),
                           node(2, kGroup, 6, Inside)};
    const OverlayContext context = seen.context();
    const auto colours = [&](const OverlayLines& overlay, double size) {
        std::vector<Vec3f> found;
        for (const LineSegment& line : overlay.lines)
            if (std::abs(line.from.x) == size) found.push_back(line.colour);
        return found;
    };
    const auto twelve = [&](TriangleState state) { return std::vector<Vec3f>(12, context.palette[size_t(state)].colour); };
    const OverlayLines groups = groupOverlay(context, seen.snapshot), boxes = boxOverlay(context, seen.snapshot);
    EXPECT_EQ(groups.lines.size(), 36u);
    EXPECT_EQ(colours(groups, 10), twelve(TriangleState::Visible));
    EXPECT_EQ(colours(groups, 8), twelve(TriangleState::OutsideFrustum));
    EXPECT_EQ(colours(groups, 6), twelve(TriangleState::Visible));
    EXPECT_EQ(boxes.lines.size(), 24u) << "of the objects, and of them only";
    EXPECT_EQ(colours(boxes, 1), twelve(TriangleState::OutsideFrustum));
}

TEST(BoxesByPlane, boxHasTheColourOfItsPlane) {
    Seen seen(sphereMap());
    const auto node = [](int32_t parent, uint32_t instance, double size, std::optional<FrustumPlane> plane) {
        SnapshotNode made;
        made.parent = parent;
        made.instance = instance;
        made.box = {Vec3(-size), Vec3(size)};
        made.culled = size > 1;
        made.containment = made.culled ? Containment::Outside : Containment::Straddles;
        made.rejectedBy = plane;
        made.tested = size != 4;
        return made;
    };
    // Kept; rejected by a plane; rejected, but by no single plane; and a group with one object that was decided with it.
    seen.snapshot.nodes = {node(-1, 0, 1, {}), node(-1, 1, 2, FrustumPlane::Top), node(-1, 2, 3, {}),
                           node(-1, SnapshotNode::kGroup, 5, FrustumPlane::Near),
                           node(3, SnapshotNode::kGroup, 4, FrustumPlane::Near)};
    const OverlayContext context = seen.context();
    const std::vector<OverlayLines> overlays = boxOverlayByPlane(context, seen.snapshot);
    std::map<double, std::vector<Vec3f>> colours;
    std::map<double, float> widths;
    for (const OverlayLines& overlay : overlays)
        for (const LineSegment& line : overlay.lines) {
            colours[std::abs(line.from.x)].push_back(line.colour);
            widths[std::abs(line.from.x)] = overlay.style.width;
        }
    const auto twelve = [](const Vec3f& colour) { return std::vector<Vec3f>(12, colour); };
    EXPECT_EQ(colours[1], twelve(context.palette[size_t(TriangleState::Visible)].colour));
    EXPECT_EQ(colours[2], twelve(context.planes[size_t(FrustumPlane::Top)]));
    EXPECT_EQ(colours[3], twelve(context.palette[size_t(TriangleState::OutsideFrustum)].colour));
    EXPECT_EQ(colours[5], twelve(context.planes[size_t(FrustumPlane::Near)]));
    EXPECT_TRUE(colours[4].empty()) << "it was not tested";
    EXPECT_GT(widths[2], widths[1]);
}

TEST(PlaneOverlay, bordersLieOnTheirPlanes) {
    const Seen seen(sphereMap());
    const OverlayContext context = seen.context();
    Frustum frustum = shownFrustum(seen.view, *seen.scene);
    frustum = makeFrustum(frustum.forward, frustum.right, frustum.up, frustum.tanHalfWidth, frustum.tanHalfHeight,
                          frustum.nearDistance, frustum.farDistance);
    const OverlayLines overlay = planeOverlay(context, seen.view);
    ASSERT_EQ(overlay.lines.size(), 24u);
    for (size_t line = 0; line < overlay.lines.size(); ++line) {
        const size_t plane = line / 4;
        EXPECT_EQ(overlay.lines[line].colour, context.planes[plane]);
        for (size_t other = 0; other < frustum.planes.size(); ++other) {
            const double distance = frustum.planes[other].distance(overlay.lines[line].from - seen.view.eye());
            if (other == plane)
                EXPECT_NEAR(distance, 0.0, 1e-9) << plane;
            else
                EXPECT_GT(distance, 0.0) << "the border of plane " << plane << " does not lie within its face";
        }
    }
}

TEST(BandOverlay, circlesLieAtTheirAngles) {
    const Seen seen(bandedMap(directionOf(50, 70)));
    const spherical::ContourBands& bands = *seen.maps[0].decision.bands;
    const std::vector<OverlayLines> overlays = spherical::bandOverlay(seen.context(), seen.maps);
    const auto palette = seen.context().palette;
    for (const LineSegment& line : overlays[0].lines) {
        const Vec3 point = seen.local(line.from);
        EXPECT_NEAR(glm::length(point), seen.radius(), 1e-9);
        const double band = bands.anglesOf(point).x / bands.width;
        EXPECT_NEAR(band, std::round(band), 1e-6);
        EXPECT_EQ(line.colour, palette[size_t(band < 6.5 ? TriangleState::Visible : TriangleState::Hidden)].colour) << band;
        EXPECT_GT(std::abs(band - 6.0), 0.5) << "the one at 90° is drawn by itself";
    }
    for (uint32_t band = 1; band < bands.bands; ++band)
        for (int beta = 0; beta < 360; beta += 15)
            EXPECT_LT(distanceTo(overlays[band == 6 ? 1 : 0].lines,
                                 seen.world(seen.radius() * bands.direction(band * bands.width, beta * kDegree))),
                      kPixel)
                << band;
    EXPECT_GT(overlays[1].style.width, overlays[0].style.width);
    EXPECT_LT(distanceTo(overlays[2].lines, seen.world(Vec3(0.0))), 1e-9) << "the axis";
    EXPECT_LT(distanceTo(overlays[3].lines, seen.world(seen.radius() * bands.axis)), 1e-6) << "the start's dot";
}

TEST(BandOverlay, smallObjectHasFewerLines) {
    const spherical::MapSnapshot map = bandedMap(directionOf(50, 70));
    Seen seen(map);
    size_t near = 0, far = 0;
    for (const OverlayLines& overlay : spherical::bandOverlay(seen.context(), seen.maps)) near += overlay.lines.size();
    Camera camera = seen.view.camera();
    camera.eye.z += 200.0;
    seen.view = View(camera, seen.view.viewport());
    for (const OverlayLines& overlay : spherical::bandOverlay(seen.context(), seen.maps)) far += overlay.lines.size();
    EXPECT_LT(far, near / 4);
    EXPECT_GT(far, 0u);
}

TEST(BandOverlay, objectWithoutBandsHasNoLines) {
    const Seen seen(cutMap(100, 200));
    for (const OverlayLines& overlay : spherical::bandOverlay(seen.context(), seen.maps)) EXPECT_TRUE(overlay.lines.empty());
}

TEST(Marks, sizeIsTheSameAtEveryDistance) {
    const Seen seen(sphereMap());
    for (const double distance : {1.0, 10.0, 1000.0})
        for (const MarkShape shape : {MarkShape::Ring, MarkShape::Cross}) {
            std::vector<LineSegment> lines;
            addMark(lines, seen.context(), seen.view.eye() + Vec3(0, 0, -distance), 10.0, shape, Vec3f(0.0f));
            double reach = 0.0;
            for (const LineSegment& line : lines)
                reach =
                    std::max(reach, pixelsOf(seen.view, seen.view.eye() + Vec3(0, 0, -distance), std::abs(line.from.x - 100.0)));
            EXPECT_NEAR(reach, 10.0, 1e-6);
            lines.clear();
            addMark(lines, seen.context(), seen.view.eye() + Vec3(0, 0, distance), 10.0, shape, Vec3f(0.0f));
            EXPECT_TRUE(lines.empty()) << "behind the viewer";
        }
}

/// Bands draw dots of radius 5 with lines of width 2.
TEST(Marks, dotIsFilledByLinesThinnerThanItsRadius) {
    constexpr double kRadius = 5.0, kHalfWidth = 1.0;
    const Seen seen(sphereMap());
    const Vec3 place = seen.view.eye() + Vec3(0, 0, -10);
    std::vector<LineSegment> lines;
    addMark(lines, seen.context(), place, kRadius, MarkShape::Dot, Vec3f(0.0f));
    const double pixel = 1.0 / pixelsOf(seen.view, place, 1.0);
    for (double y = -kRadius / 2; y <= kRadius / 2; y += 0.25)
        for (double x = -kRadius / 2; x <= kRadius / 2; x += 0.25)
            if (std::hypot(x, y) <= kRadius / 2)
                EXPECT_LE(distanceTo(lines, place + pixel * Vec3(x, y, 0.0)), kHalfWidth * pixel) << x << " " << y;
}

}  // namespace
}  // namespace cullscope::test::overlays_test
