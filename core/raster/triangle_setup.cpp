#include "core/raster/triangle_setup.h"

#include <algorithm>
#include <limits>

namespace cullscope {
namespace {

/// The first row or column whose centre lies at, or after, a place on the raster.
int32_t centreFrom(int32_t place) { return (place + kSubPixels - 1) >> 8; }

/// A polygon in clip space: a triangle gets one corner more at each limit, and where rounding makes a sliver concave two.
struct ClipPolygon {
    std::array<Clip, 3 + 2 * Projection::kLimits> corners;
    size_t count = 0;

    void add(const Clip& corner) {
        if (count < corners.size()) corners[count++] = corner;
    }
};

/// The part of a polygon within a limit. A new corner is computed from the edge's inner to its outer end, so that two triangles
/// that share the edge get the same one.
ClipPolygon clippedAt(const Projection& projection, int limit, const ClipPolygon& polygon) {
    ClipPolygon result;
    for (size_t i = 0; i < polygon.count; ++i) {
        const Clip &here = polygon.corners[i], &next = polygon.corners[(i + 1) % polygon.count];
        const double d = projection.within(limit, here), e = projection.within(limit, next);
        if (d >= 0.0) result.add(here);
        if ((d >= 0.0) == (e >= 0.0)) continue;
        const Clip &inner = d >= 0.0 ? here : next, &outer = d >= 0.0 ? next : here;
        const double share = std::max(d, e) / (std::max(d, e) - std::min(d, e));
        Clip corner{};
        for (int axis = 0; axis < 4; ++axis)
            corner[axis] = float(double(inner[axis]) + share * (double(outer[axis]) - double(inner[axis])));
        if (limit == 0) corner[2] = corner[3];
        result.add(corner);
    }
    return result;
}

}  // namespace

std::optional<ScreenTriangle> screenTriangle(const RasterCorners& c, int64_t area, uint32_t number, const Viewport& size) {
    static_assert(kSubPixels == 1 << 8);
    ScreenTriangle t;
    t.firstColumn = std::max(0, centreFrom(std::min({c[0].x, c[1].x, c[2].x})));
    t.endColumn = std::min(size.width, (std::max({c[0].x, c[1].x, c[2].x}) >> 8) + 1);
    if (t.firstColumn >= t.endColumn) return std::nullopt;
    t.firstRow = std::max(0, centreFrom(std::min({c[0].y, c[1].y, c[2].y})));
    t.endRow = std::min(size.height, (std::max({c[0].y, c[1].y, c[2].y}) >> 8) + 1);
    if (t.firstRow >= t.endRow) return std::nullopt;
    const size_t second = area > 0 ? 1 : 2;
    const std::array<const RasterVertex*, 3> ordered{&c[0], &c[second], &c[3 - second]};
    for (size_t i = 0; i < 3; ++i) {
        t.x[i] = ordered[i]->x;
        t.y[i] = ordered[i]->y;
    }
    t.number = number;
    const double depths[2] = {double(ordered[1]->depth) - double(ordered[0]->depth),
                              double(ordered[2]->depth) - double(ordered[0]->depth)};
    const double toPixels = double(kSubPixels) / double(std::abs(area));
    t.depthPerColumn = (depths[0] * (t.y[2] - t.y[0]) - depths[1] * (t.y[1] - t.y[0])) * toPixels;
    t.depthPerRow = (depths[1] * (t.x[1] - t.x[0]) - depths[0] * (t.x[2] - t.x[0])) * toPixels;
    t.depth = double(ordered[0]->depth) + t.depthPerColumn * (t.firstColumn - t.x[0] / double(kSubPixels)) +
              t.depthPerRow * (t.firstRow - t.y[0] / double(kSubPixels));
    return t;
}

RasterFacing::RasterFacing(const Scene& scene, size_t instance, Facing facing)
    : front(facing == Facing::Front), mirrored(glm::determinant(Mat3(scene.instances()[instance].worldFromMesh)) < 0.0) {}

RasterVertex Projection::clippedVertex(Clip clip) const {
    clip[3] = std::max(clip[3], std::numeric_limits<float>::min());
    RasterVertex moved = vertex(clip);
    if ((moved.beyond & (Beyond::kNeedsClipping | Beyond::Nowhere)) == 0) return moved;
    clip[2] = std::min(clip[2], clip[3]);
    for (int axis = 0; axis < 2; ++axis) {
        // One rounding of a float within the range.
        const double reach = within(axis == 0 ? 1 : 3, Clip{0, 0, 0, clip[3]}) * (1.0 - 0x1p-23);
        clip[axis] = float(std::clamp(double(clip[axis]), -reach, reach));
    }
    return vertex(clip);
}

RasterFate addClipped(const Projection& projection, const std::array<Clip, 3>& corners, const RasterFacing& facing,
                      uint32_t number, const Viewport& size, std::vector<ScreenTriangle>& triangles) {
    ClipPolygon polygon;
    for (const Clip& corner : corners) polygon.add(corner);
    for (int limit = 0; limit < Projection::kLimits && polygon.count >= 3; ++limit)
        polygon = clippedAt(projection, limit, polygon);
    std::array<RasterVertex, 3 + 2 * Projection::kLimits> vertices;
    for (size_t i = 0; i < polygon.count; ++i) vertices[i] = projection.clippedVertex(polygon.corners[i]);
    RasterFate fate = RasterFate::WithoutSample;
    for (size_t i = 2; i < polygon.count; ++i) {
        const RasterCorners part{vertices[0], vertices[i - 1], vertices[i]};
        const int64_t area = twiceArea(part[0], part[1], part[2]);
        if (area == 0) continue;
        if (facing.drops(area)) {
            if (fate != RasterFate::OnRaster) fate = RasterFate::FacingAway;
        } else if (const std::optional<ScreenTriangle> triangle = screenTriangle(part, area, number, size)) {
            triangles.push_back(*triangle);
            fate = RasterFate::OnRaster;
        }
    }
    return fate;
}

}  // namespace cullscope
