#include "core/raster/triangle_setup.h"

#include <algorithm>

namespace cullscope {
namespace {

/// The first row or column whose centre lies at, or after, a place on the raster.
int32_t centreFrom(int32_t place) { return (place + kSubPixels - 1) >> 8; }

/// A polygon in clip space: a convex one gets at most one corner more at each plane, and where rounding makes a sliver concave
/// two.
struct ClipPolygon {
    struct Corner {
        Clip clip;
        bool made;  ///< by clipping
    };
    std::array<Corner, kMostPieces + 2> corners;
    size_t count = 0;

    void add(const Corner& corner) {
        if (count < corners.size()) corners[count++] = corner;
    }
};

/// How far a point lies within the plane of a bit of Beyond. Its sign is that of beyond().
float within(int plane, const Clip& clip) {
    const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
    switch (1u << plane) {
        case Beyond::Right:
            return w - x;
        case Beyond::Left:
            return x + w;
        case Beyond::Top:
            return w - y;
        case Beyond::Bottom:
            return y + w;
        case Beyond::Far:
            return z;
        default:
            return w - z;
    }
}

/// The part of a polygon within a plane. A new corner is computed from the end of the edge that is nearer to the plane: so two
/// triangles that share the edge get the same one.
ClipPolygon clippedAt(int plane, const ClipPolygon& polygon) {
    ClipPolygon result;
    for (size_t i = 0; i < polygon.count; ++i) {
        const ClipPolygon::Corner &here = polygon.corners[i], &next = polygon.corners[(i + 1) % polygon.count];
        const float d = within(plane, here.clip), e = within(plane, next.clip);
        if (d >= 0.0f) result.add(here);
        if ((d >= 0.0f) == (e >= 0.0f)) continue;
        const bool fromNext = e < 0.0f ? -e < d : !(-d < e);
        const Clip &from = fromNext ? next.clip : here.clip, &to = fromNext ? here.clip : next.clip;
        const float share = (fromNext ? e : -d) / (e - d);
        result.add({from + share * (to - from), true});
    }
    return result;
}

}  // namespace

RasterProjection Projection::forKernels() const {
    RasterProjection result{};
    for (size_t column = 0; column < 4; ++column)
        for (int axis = 0; axis < 4; ++axis) result.columns[column][axis] = m_columns[column][axis];
    result.halfWidth = m_halfWidth;
    result.halfHeight = m_halfHeight;
    result.right = Beyond::Right;
    result.left = Beyond::Left;
    result.top = Beyond::Top;
    result.bottom = Beyond::Bottom;
    result.far = Beyond::Far;
    result.near = Beyond::Near;
    result.unprojectable = Beyond::Unprojectable;
    return result;
}

uint32_t Projection::beyond(const Clip& clip) {
    const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
    // The comparison is false for what is not a number.
    if (!(std::abs(x) + std::abs(y) + std::abs(z) + std::abs(w) < 0x1p100f)) return Beyond::Unprojectable;
    const uint32_t result = (x > w ? Beyond::Right : 0u) | (x < -w ? Beyond::Left : 0u) | (y > w ? Beyond::Top : 0u) |
                            (y < -w ? Beyond::Bottom : 0u) | (z < 0.0f ? Beyond::Far : 0u) | (z > w ? Beyond::Near : 0u);
    return result == 0 && !(w > 0.0f) ? uint32_t(Beyond::Unprojectable) : result;
}

RasterVertex Projection::vertex(const Clip& clip) const {
    const float inverse = 1.0f / clip[3];
    return {std::fma(clip[0] * inverse, m_halfWidth, m_halfWidth), std::fma(clip[1] * inverse, m_halfHeight, m_halfHeight),
            clip[2] * inverse, beyond(clip)};
}

RasterVertex Projection::clippedVertex(const Clip& clip) const {
    const float inverse = 1.0f / clip[3];
    // Within the picture, but for rounding; where that is large, of triangles of a million times the near distance, still on the
    // raster.
    const auto pixels = [inverse](float coordinate, float half) {
        const float place = coordinate * inverse * half + half;
        return std::isnan(place) ? half : std::clamp(place, -half, 3.0f * half);
    };
    return {pixels(clip[0], m_halfWidth), pixels(clip[1], m_halfHeight), clip[2] * inverse, 0};
}

std::optional<ScreenTriangle> screenTriangle(const RasterCorners& c, int64_t area, uint32_t number, const Viewport& size) {
    static_assert(kSubPixels == 1 << 8);
    ScreenTriangle t;
    t.firstColumn = std::max(0, centreFrom(std::min({c.x[0], c.x[1], c.x[2]})));
    t.endColumn = std::min(size.width, (std::max({c.x[0], c.x[1], c.x[2]}) >> 8) + 1);
    if (t.firstColumn >= t.endColumn) return std::nullopt;
    t.firstRow = std::max(0, centreFrom(std::min({c.y[0], c.y[1], c.y[2]})));
    t.endRow = std::min(size.height, (std::max({c.y[0], c.y[1], c.y[2]}) >> 8) + 1);
    if (t.firstRow >= t.endRow) return std::nullopt;
    const size_t second = area > 0 ? 1 : 2, order[3] = {0, second, 3 - second};
    for (size_t i = 0; i < 3; ++i) {
        t.x[i] = c.x[order[i]];
        t.y[i] = c.y[order[i]];
    }
    t.number = number;
    // The plane, from the corners in clockwise order. The kernels do the same for small triangles.
    const RasterVertex &p = c.vertices[area > 0 ? 1 : 0], &q = c.vertices[area > 0 ? 0 : 1], &r = c.vertices[2];
    const float xToP = p.x - q.x, yToP = p.y - q.y, xToR = r.x - p.x, yToR = r.y - p.y;
    const float toPlane = 1.0f / (xToP * yToR - yToP * xToR);
    const float xToPScaled = xToP * toPlane, yToPScaled = yToP * toPlane, xToRScaled = xToR * toPlane,
                yToRScaled = yToR * toPlane;
    const float depthToP = p.depth - q.depth, depthToR = r.depth - p.depth;
    t.depthPerColumn = depthToP * yToRScaled - depthToR * yToPScaled;
    t.depthPerRow = depthToR * xToPScaled - depthToP * xToRScaled;
    t.depth = p.depth - (t.depthPerColumn * (p.x - 0.5f) + t.depthPerRow * (p.y - 0.5f));
    if (!std::isfinite(std::abs(t.depth) + std::abs(t.depthPerColumn) + std::abs(t.depthPerRow))) t.depth = NAN;
    return t;
}

bool coversCentre(const ScreenTriangle& triangle, int column, int row) {
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        const int64_t dx = triangle.x[next] - triangle.x[i], dy = triangle.y[next] - triangle.y[i];
        const int64_t inside =
            dx * (int64_t(row) * kSubPixels - triangle.y[i]) - dy * (int64_t(column) * kSubPixels - triangle.x[i]);
        // A left edge goes down, one at the bottom goes to the right: these own the centres on them.
        if (inside < 0 || (inside == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) return false;
    }
    return true;
}

RasterFacing::RasterFacing(const Scene& scene, size_t instance, Facing facing)
    : front(dropsBacks(scene, instance, facing)),
      mirrored(glm::determinant(Mat3(scene.instances()[instance].worldFromMesh)) < 0.0) {}

ClippedCorners clippedCorners(const Projection& projection, const std::array<Clip, 3>& corners) {
    ClipPolygon polygon;
    uint32_t beyond = 0;
    for (const Clip& corner : corners) {
        polygon.add({corner, false});
        beyond |= Projection::beyond(corner);
    }
    for (int plane = 0; plane < Beyond::kPlanes && polygon.count >= 3; ++plane)
        if ((beyond & 1u << plane) != 0) polygon = clippedAt(plane, polygon);
    ClippedCorners result;
    for (; result.count < polygon.count; ++result.count) {
        const ClipPolygon::Corner& corner = polygon.corners[result.count];
        result.corners[result.count] = corner.made ? projection.clippedVertex(corner.clip) : projection.vertex(corner.clip);
    }
    return result;
}

RasterFate addClipped(const Projection& projection, const std::array<Clip, 3>& corners, const RasterFacing& facing,
                      uint32_t number, const Viewport& size, std::vector<ScreenTriangle>& triangles) {
    const ClippedCorners clipped = clippedCorners(projection, corners);
    RasterFate fate = RasterFate::WithoutSample;
    for (size_t i = 2; i < clipped.count; ++i) {
        const RasterCorners piece(clipped.corners[i - 1], clipped.corners[i], clipped.corners[0]);
        const int64_t area = piece.twiceArea();
        if (area == 0) continue;
        if (facing.drops(area)) {
            if (fate != RasterFate::OnRaster) fate = RasterFate::FacingAway;
        } else if (const std::optional<ScreenTriangle> triangle = screenTriangle(piece, area, number, size)) {
            triangles.push_back(*triangle);
            fate = RasterFate::OnRaster;
        }
    }
    return fate;
}

}  // namespace cullscope
