#include "core/visibility/spherical/visible_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

constexpr size_t kStepsOfAnArc = 16;  // of the displayed outline; boxes use the exact extreme

/// The angle from `from` to `to` in [−π, π].
double turn(double from, double to) { return std::remainder(to - from, kTurn); }

/// The zenith angle and azimuth of the point of a great-circle arc nearest to a pole; none where it is one of the arc's ends.
std::optional<Vec2> extremeOfArc(const Vec3& from, const Vec3& to) {
    const Vec3 normal = glm::cross(from, to);
    const double length = glm::length(normal);
    if (!(length > 1e-12 * glm::length(from) * glm::length(to))) return std::nullopt;
    const Vec3 n = normal / length;
    Vec3 top = Vec3(0, 0, 1) - n.z * n;
    // Between the two, the arc bends to the side of its middle direction.
    if (glm::dot(top, from) + glm::dot(top, to) < 0.0) top = -top;
    const bool between = glm::dot(glm::cross(from, top), n) > 0.0 && glm::dot(glm::cross(top, to), n) > 0.0;
    if (!between) return std::nullopt;
    const SphericalPoint point = sphericalPoint(top);
    return Vec2(point.theta, point.phi);
}

/// The outline through the corners with azimuths continued over the seam, and the ranges of θ and φ that its boxes must contain.
struct Outline {
    std::vector<Vec2> points;
    double leastTheta = kPi, mostTheta = 0.0;
    double leastPhi = 1e9, mostPhi = -1e9;
    double turned = 0.0;  ///< sum of azimuth changes around the outline

    [[nodiscard]] bool winds() const { return std::abs(turned) > kPi; }
    [[nodiscard]] bool wholeTurn() const { return mostPhi - leastPhi >= kTurn; }

    void take(double theta, double phi) {
        leastTheta = std::min(leastTheta, theta);
        mostTheta = std::max(mostTheta, theta);
        leastPhi = std::min(leastPhi, phi);
        mostPhi = std::max(mostPhi, phi);
    }
};

void addArc(Outline& outline, const Vec3& from, const Vec3& to, double phi) {
    const Vec3 a = glm::normalize(from), b = glm::normalize(to);
    double before = phi;
    for (size_t step = 1; step < kStepsOfAnArc; ++step) {
        const double share = double(step) / kStepsOfAnArc;
        const SphericalPoint point = sphericalPoint((1.0 - share) * a + share * b);
        before += turn(before, point.phi);
        outline.points.emplace_back(point.theta, before);
    }
    if (const std::optional<Vec2> extreme = extremeOfArc(a, b)) outline.take(extreme->x, phi + turn(phi, extreme->y));
}

Outline outlineOf(std::span<const CornerRay> corners, Join join) {
    Outline outline;
    double phi = sphericalPoint(corners[0].point).phi;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3& from = corners[i].point;
        const Vec3& to = corners[(i + 1) % corners.size()].point;
        const SphericalPoint point = sphericalPoint(from);
        outline.points.emplace_back(point.theta, phi);
        outline.take(point.theta, phi);
        if (join == Join::Arcs) addArc(outline, from, to, phi);
        const double step = turn(point.phi, sphericalPoint(to).phi);
        phi += step;
        outline.turned += step;
    }
    outline.points.emplace_back(outline.points.front().x, phi);
    return outline;
}

/// Extends the region by the centroids of the hit triangles, whose cells belong to it.
void takeHits(Outline& outline, const SphericalMaps& maps, std::span<const CornerRay> corners) {
    const double middle = (outline.leastPhi + outline.mostPhi) / 2;
    for (const CornerRay& corner : corners) {
        if (!corner.hit) continue;
        const auto [a, b, c] = maps.corners(corner.hit->triangle);
        const SphericalPoint centroid = sphericalPoint(a + b + c);
        outline.take(centroid.theta, middle + turn(middle, centroid.phi));
    }
}

/// The pole around which the outline winds.
Pole poleOf(const Outline& outline, std::span<const CornerRay> corners) {
    if (!outline.winds()) return Pole::None;
    double height = 0.0;
    for (const CornerRay& corner : corners) height += corner.point.z / std::max(glm::length(corner.point), 1e-300);
    return height >= 0.0 ? Pole::North : Pole::South;
}

std::vector<CellBox> boxesOf(const SphericalGrid& grid, const Outline& outline, int caseNumber) {
    const uint32_t firstRow = grid.rowOf(outline.leastTheta), lastRow = grid.rowOf(outline.mostTheta);
    const uint32_t last = grid.columns() - 1;
    if (caseNumber == 1 || outline.wholeTurn()) return {{firstRow, lastRow, 0, last}};
    const auto column = [&](double phi) {
        const double inTurn = phi - kTurn * std::floor(phi / kTurn);
        return grid.columnOf(inTurn < kTurn ? inTurn : 0.0);
    };
    const uint32_t from = column(outline.leastPhi), to = column(outline.mostPhi);
    if (caseNumber == 2) return {{firstRow, lastRow, from, to}};
    // The azimuths cover almost a whole turn, so that the two ranges of a row overlap.
    if (from <= to) return {{firstRow, lastRow, 0, last}};
    return {{firstRow, lastRow, from, last}, {firstRow, lastRow, 0, to}};
}

/// The mesh's box, relative to the centre of the maps.
Box3 boxOf(const SphericalMaps& maps) {
    const Box3& box = maps.mesh().localBounds();
    // The axes of the maps are those of the mesh in another order, so that a box stays one.
    const Vec3 a = (box.min - maps.sphere().centre) * maps.meshFromMap(),
               b = (box.max - maps.sphere().centre) * maps.meshFromMap();
    return {glm::min(a, b), glm::max(a, b)};
}

/// The ray parameters at which a ray enters and leaves a box; none where it misses. The entry is at least 0.
std::optional<Span> throughBox(const Ray& ray, const Box3& box) {
    Span span{0.0, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double from = ray.origin[axis], step = ray.direction[axis];
        if (step == 0.0) {
            if (from < box.min[axis] || from > box.max[axis]) return std::nullopt;
            continue;
        }
        const double one = (box.min[axis] - from) / step, other = (box.max[axis] - from) / step;
        span.from = std::max(span.from, std::min(one, other));
        span.to = std::min(span.to, std::max(one, other));
    }
    return span.from <= span.to ? std::optional(span) : std::nullopt;
}

/// The point of the sphere, or of the box, nearest to a ray that misses it: of the sphere exactly, of the box as that nearest to
/// the ray's point that is nearest to the centre.
Vec3 nearestTo(const Ray& ray, const SphericalMaps& maps, RayStart start) {
    const double t = std::max(0.0, -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction));
    const Vec3 nearest = ray.at(t);
    if (start == RayStart::Sphere) return nearest * (maps.sphere().radius / glm::length(nearest));
    const Box3 box = boxOf(maps);
    return glm::clamp(nearest, box.min, box.max);
}

CornerRay cornerOf(const SphericalMaps& maps, const Ray& ray, uint32_t number, RayStart start, ObjectRecord* record) {
    CornerRay corner;
    corner.followed = true;
    corner.ray = ray;
    const bool box = start == RayStart::Box;
    corner.span = box ? throughBox(ray, boxOf(maps)) : throughSphere(ray, maps.sphere().radius);
    if (!corner.span) {
        corner.point = nearestTo(ray, maps, start);
        return corner;
    }
    // A little larger than the bounds, because they are rounded.
    const double more = 1e-6 * maps.sphere().radius / glm::length(ray.direction);
    const Span searched{std::max(0.0, corner.span->from - more), corner.span->to + more};
    if (record == nullptr) {
        corner.hit = searchTriangle(maps, ray, searched);
    } else {
        sayEntry(corner, number, box, *record);
        corner.hit = searchTriangle(maps, ray, searched, [&](const WalkedCell& walked) {
            corner.walkedCells.push_back(walked);
            sayWalkedCell(maps, walked, number, *record);
        });
    }
    corner.point = ray.at(corner.hit ? corner.hit->t : corner.span->from);
    return corner;
}

/// R of the outermost surface in a row of cells, 0 where there is none.
double outermost(const SphericalMaps& maps, uint32_t row) {
    double result = 0.0;
    for (uint32_t column = 0; column < maps.grid().columns(); ++column) {
        const SphericalMaps::Extent extent = maps.extent(maps.grid().number({row, column}));
        if (!extent.empty()) result = std::max(result, double(extent.farthest));
    }
    return result;
}

}  // namespace

CornerRay followCorner(const SphericalMaps& maps, const Ray& ray, uint32_t number, RayStart start, ObjectRecord* record) {
    CornerRay corner = cornerOf(maps, ray, number, start, record);
    if (record != nullptr) sayRay(corner, number, *record);
    return corner;
}

Pole poleInView(const SphericalMaps& maps, const ObjectSpaceView& view) {
    for (const Pole pole : {Pole::North, Pole::South}) {
        const Vec3 up(0.0, 0.0, pole == Pole::North ? 1.0 : -1.0);
        const Vec3 point = outermost(maps, pole == Pole::North ? 0 : maps.grid().rows() - 1) * up;
        const bool seen = glm::dot(view.eye - point, up) > 0.0;
        if (seen && std::ranges::all_of(view.localPlanes, [&](const Plane& plane) { return plane.distance(point) >= 0.0; }))
            return pole;
    }
    return Pole::None;
}

VisibleRegion visibleRegion(const SphericalMaps& maps, std::span<const CornerRay> corners, Join join, std::optional<Pole> pole) {
    Outline outline = outlineOf(corners, join);
    takeHits(outline, maps, corners);
    VisibleRegion region;
    region.winds = outline.winds();
    const Pole within = pole ? *pole : poleOf(outline, corners);
    if (within == Pole::North) outline.leastTheta = 0.0;
    if (within == Pole::South) outline.mostTheta = kPi;
    const bool overSeam = std::floor(outline.leastPhi / kTurn) != std::floor(outline.mostPhi / kTurn);
    region.caseNumber = within != Pole::None ? 1 : overSeam && !outline.wholeTurn() ? 3 : 2;
    region.boxes = boxesOf(maps.grid(), outline, region.caseNumber);
    region.outline = std::move(outline.points);
    return region;
}

std::vector<CellRun> runsOf(const SphericalGrid& grid, const VisibleRegion& region) {
    std::vector<CellRun> runs;
    const CellBox& first = region.boxes.front();
    if (region.caseNumber == 1) return {{grid.number({first.firstRow, 0}), grid.number({first.lastRow, 0}) + grid.columns()}};
    for (uint32_t row = first.firstRow; row <= first.lastRow; ++row)
        for (auto box = region.boxes.rbegin(); box != region.boxes.rend(); ++box)
            runs.push_back({grid.number({row, box->firstColumn}), grid.number({row, box->lastColumn}) + 1});
    return runs;
}

}  // namespace cullscope::spherical
