#include "core/raster/scene_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "core/raster/in_parallel.h"

namespace cullscope {
namespace {

using Clip = float __attribute__((vector_size(16)));  // x, y, z, w

/// Triangles reach at most so many pixels from the picture's lower left corner: with 1/256 pixel less than 2^23.
constexpr float kRange = 32000.0f;

/// Beyond which planes a vertex lies, and beyond which limits of the raster.
enum Beyond : uint32_t { Left = 1, Right = 2, Bottom = 4, Top = 8, Near = 16, Far = 32, Range = 64, Nowhere = 128 };
constexpr uint32_t kFrustum = Left | Right | Bottom | Top | Near | Far;
constexpr uint32_t kNeedsClipping = Near | Range;

struct Vertex {
    int32_t x, y;
    float depth;
    uint32_t beyond;
};

/// From the positions of an instance's mesh to the raster.
class Projection {
public:
    Projection(const View& view, const Scene& scene, size_t instance)
        : m_halfWidth(0.5f * float(view.viewport().width)),
          m_halfHeight(0.5f * float(view.viewport().height)),
          m_rangeX(kRange / m_halfWidth - 1.0f),
          m_rangeY(kRange / m_halfHeight - 1.0f) {
        const Mat4f matrix = view.clipFromPositions(scene.instances()[instance].worldFromMesh, scene.meshOf(instance).origin());
        for (int c = 0; c < 4; ++c) m_columns[size_t(c)] = Clip{matrix[c].x, matrix[c].y, matrix[c].z, matrix[c].w};
    }

    [[nodiscard]] Clip clip(const Vec3f& position) const {
        return ((m_columns[0] * position.x + m_columns[1] * position.y) + m_columns[2] * position.z) + m_columns[3];
    }

    [[nodiscard]] Vertex vertex(const Clip& clip) const {
        const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        Vertex vertex{0, 0, 0.0f, beyond(clip)};
        if ((vertex.beyond & (kNeedsClipping | Nowhere)) != 0) return vertex;
        const float inverse = 1.0f / w;
        vertex.x = snapped(x * inverse * m_halfWidth + m_halfWidth);
        vertex.y = snapped(y * inverse * m_halfHeight + m_halfHeight);
        vertex.depth = z * inverse;
        return vertex;
    }

    /// How far a point lies within a limit of the raster: 0 is the near plane, 1 to 4 the range to the left, right, bottom, top.
    [[nodiscard]] double within(int limit, const Clip& clip) const {
        const double x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        switch (limit) {
            case 0:
                return w - z;
            case 1:
                return double(m_rangeX) * w + x;
            case 2:
                return double(m_rangeX) * w - x;
            case 3:
                return double(m_rangeY) * w + y;
            default:
                return double(m_rangeY) * w - y;
        }
    }
    static constexpr int kLimits = 5;

private:
    [[nodiscard]] uint32_t beyond(const Clip& clip) const {
        const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        // The comparisons are false for what is not a number.
        if (!(std::abs(x) + std::abs(y) + std::abs(z) + std::abs(w) < 0x1p100f)) return Nowhere;
        uint32_t result = (x < -w ? Left : 0u) | (x > w ? Right : 0u) | (y < -w ? Bottom : 0u) | (y > w ? Top : 0u) |
                          (z > w ? Near : 0u) | (z < 0.0f ? Far : 0u);
        // Nearly all are within the range by far; for the others in double, as `within`: both must agree on every vertex.
        if (!(std::abs(x) <= w && std::abs(y) <= w) &&
            (std::abs(double(x)) > double(m_rangeX) * w || std::abs(double(y)) > double(m_rangeY) * w || !(w > 0.0f)))
            result |= Range;
        if (!(w > 0.0f)) result |= Range;
        return result;
    }
    [[nodiscard]] static int32_t snapped(float pixels) { return int32_t(std::lrintf((pixels - 0.5f) * float(kSubPixels))); }

    std::array<Clip, 4> m_columns;
    float m_halfWidth, m_halfHeight;
    float m_rangeX, m_rangeY;  ///< in units of w
};

using Corners = std::array<Vertex, 3>;

/// Twice the area in units of 1/256 pixel, above 0 where the corners are in counter-clockwise order.
int64_t area(const Corners& c) {
    return int64_t(c[1].x - c[0].x) * (c[2].y - c[0].y) - int64_t(c[2].x - c[0].x) * (c[1].y - c[0].y);
}

/// The first row or column whose centre lies at, or after, a place on the raster.
int32_t centreFrom(int32_t place) { return (place + kSubPixels - 1) >> 8; }

std::optional<ScreenTriangle> screenTriangle(const Corners& c, int64_t twiceArea, uint32_t number, const Viewport& size) {
    static_assert(kSubPixels == 1 << 8);
    ScreenTriangle t;
    t.firstColumn = std::max(0, centreFrom(std::min({c[0].x, c[1].x, c[2].x})));
    t.endColumn = std::min(size.width, (std::max({c[0].x, c[1].x, c[2].x}) >> 8) + 1);
    if (t.firstColumn >= t.endColumn) return std::nullopt;
    t.firstRow = std::max(0, centreFrom(std::min({c[0].y, c[1].y, c[2].y})));
    t.endRow = std::min(size.height, (std::max({c[0].y, c[1].y, c[2].y}) >> 8) + 1);
    if (t.firstRow >= t.endRow) return std::nullopt;
    const size_t second = twiceArea > 0 ? 1 : 2;
    const std::array<const Vertex*, 3> ordered{&c[0], &c[second], &c[3 - second]};
    for (size_t i = 0; i < 3; ++i) {
        t.x[i] = ordered[i]->x;
        t.y[i] = ordered[i]->y;
    }
    t.number = number;
    const double depths[2] = {double(ordered[1]->depth) - double(ordered[0]->depth),
                              double(ordered[2]->depth) - double(ordered[0]->depth)};
    const double toPixels = double(kSubPixels) / double(std::abs(twiceArea));
    t.depthPerColumn = (depths[0] * (t.y[2] - t.y[0]) - depths[1] * (t.y[1] - t.y[0])) * toPixels;
    t.depthPerRow = (depths[1] * (t.x[1] - t.x[0]) - depths[0] * (t.x[2] - t.x[0])) * toPixels;
    t.depth = double(ordered[0]->depth) + t.depthPerColumn * (t.firstColumn - t.x[0] / double(kSubPixels)) +
              t.depthPerRow * (t.firstRow - t.y[0] / double(kSubPixels));
    return t;
}

/// A polygon in clip space: a triangle gets one corner more at each limit, and where rounding makes a sliver concave two.
struct Polygon {
    std::array<Clip, 3 + 2 * Projection::kLimits> corners;
    size_t count = 0;

    void add(const Clip& corner) {
        if (count < corners.size()) corners[count++] = corner;
    }
};

/// The part of a polygon within a limit. A new corner is computed from the edge's inner to its outer end, so that two triangles
/// that share the edge get the same one.
Polygon clippedAt(const Projection& projection, int limit, const Polygon& polygon) {
    Polygon result;
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

/// Sets up the triangles of a part.
class Setup {
public:
    Setup(const Scene& scene, const Projection& projection, Facing facing, const Viewport& size, TrianglesOnRaster& part)
        : m_projection(projection),
          m_size(size),
          m_part(part),
          m_front(facing == Facing::Front),
          m_mirrored(glm::determinant(Mat3(scene.instances()[part.instance].worldFromMesh)) < 0.0) {}

    /// `corner(i)` gives a position.
    template <typename Corner>
    void add(const Corners& corners, uint32_t number, const Corner& corner) {
        ++m_part.given;
        const uint32_t any = corners[0].beyond | corners[1].beyond | corners[2].beyond;
        if ((corners[0].beyond & corners[1].beyond & corners[2].beyond & kFrustum) != 0 || (any & Nowhere) != 0) {
            ++m_part.outside;
        } else if ((any & kNeedsClipping) != 0) {
            addClipped(corner, number);
        } else {
            count(addWhole(corners, number));
        }
    }

private:
    enum class Fate { Added, FacingAway, WithoutSample };

    Fate addWhole(const Corners& corners, uint32_t number) {
        const int64_t twiceArea = area(corners);
        if (twiceArea == 0) return Fate::WithoutSample;
        if (m_front && (twiceArea < 0) != m_mirrored) return Fate::FacingAway;
        const std::optional<ScreenTriangle> triangle = screenTriangle(corners, twiceArea, number, m_size);
        if (!triangle) return Fate::WithoutSample;
        m_part.triangles.push_back(*triangle);
        return Fate::Added;
    }

    template <typename Corner>
    void addClipped(const Corner& corner, uint32_t number) {
        ++m_part.clipped;
        Polygon polygon;
        for (size_t i = 0; i < 3; ++i) polygon.corners[polygon.count++] = m_projection.clip(corner(i));
        for (int limit = 0; limit < Projection::kLimits && polygon.count >= 3; ++limit)
            polygon = clippedAt(m_projection, limit, polygon);
        if (polygon.count < 3) return count(Fate::WithoutSample);
        std::array<Vertex, 3 + 2 * Projection::kLimits> vertices;
        for (size_t i = 0; i < polygon.count; ++i) vertices[i] = cornerOf(polygon.corners[i]);
        Fate fate = Fate::WithoutSample;
        for (size_t i = 2; i < polygon.count; ++i) {
            const Fate one = addWhole({vertices[0], vertices[i - 1], vertices[i]}, number);
            if (fate != Fate::Added && one != Fate::WithoutSample) fate = one;
        }
        count(fate);
    }

    /// A corner of a clipped polygon, which rounding may have moved beyond a limit by a little.
    [[nodiscard]] Vertex cornerOf(Clip clip) const {
        clip[3] = std::max(clip[3], std::numeric_limits<float>::min());
        Vertex vertex = m_projection.vertex(clip);
        if ((vertex.beyond & (kNeedsClipping | Nowhere)) == 0) return vertex;
        clip[2] = std::min(clip[2], clip[3]);
        for (int axis = 0; axis < 2; ++axis) {
            // One rounding of a float within the range.
            const double reach = m_projection.within(axis == 0 ? 1 : 3, Clip{0, 0, 0, clip[3]}) * (1.0 - 0x1p-23);
            clip[axis] = float(std::clamp(double(clip[axis]), -reach, reach));
        }
        return m_projection.vertex(clip);
    }

    void count(Fate fate) {
        if (fate == Fate::FacingAway) ++m_part.facingAway;
        if (fate == Fate::WithoutSample) ++m_part.withoutSample;
    }

    const Projection& m_projection;
    const Viewport& m_size;
    TrianglesOnRaster& m_part;
    bool m_front, m_mirrored;
};

/// A piece of an instance's vertices or triangles.
struct Piece {
    uint32_t instance;
    size_t first, end;
};

/// Cuts what each instance has into pieces of equal size.
template <typename CountOf>
std::vector<Piece> piecesOf(const Scene& scene, const CountOf& countOf) {
    constexpr size_t kPiece = 4096;
    std::vector<Piece> pieces;
    for (uint32_t i = 0; i < scene.instances().size(); ++i)
        for (size_t first = 0, count = countOf(scene.meshOf(i)); first < count; first += kPiece)
            pieces.push_back({i, first, std::min(first + kPiece, count)});
    return pieces;
}

}  // namespace

size_t SceneOnRaster::triangleCount() const {
    size_t count = 0;
    for (const TrianglesOnRaster& part : parts) count += part.triangles.size();
    return count;
}

SceneOnRaster trianglesOnRaster(const Scene& scene, const View& view, Facing facing, bool parallel) {
    if (scene.triangleCount() >= UINT32_MAX)
        throwUsage(CULLSCOPE_TR("The scene has %1 triangles; the item buffer numbers at most 4294967294. Measure a part of it."),
                   {std::to_string(scene.triangleCount())});
    const size_t instances = scene.instances().size();
    std::vector<Projection> projections;
    std::vector<size_t> firstVertex{0};
    projections.reserve(instances);
    for (size_t i = 0; i < instances; ++i) {
        projections.emplace_back(view, scene, i);
        firstVertex.push_back(firstVertex.back() + scene.meshOf(i).vertexCount());
    }
    const std::unique_ptr<Vertex[]> vertices(new Vertex[firstVertex.back()]);
    const std::vector<Piece> ofVertices = piecesOf(scene, [](const TriangleMesh& mesh) { return mesh.vertexCount(); });
    forEachOf(ofVertices.size(), parallel, [&](size_t i) {
        const Piece& piece = ofVertices[i];
        const Projection projection = projections[piece.instance];
        const Vec3f* positions = scene.meshOf(piece.instance).positions().data();
        Vertex* to = &vertices[firstVertex[piece.instance]];
        for (size_t v = piece.first; v < piece.end; ++v) to[v] = projection.vertex(projection.clip(positions[v]));
    });

    const std::vector<Piece> ofTriangles = piecesOf(scene, [](const TriangleMesh& mesh) { return mesh.triangleCount(); });
    SceneOnRaster result{view.viewport(), std::vector<TrianglesOnRaster>(ofTriangles.size())};
    forEachOf(ofTriangles.size(), parallel, [&](size_t i) {
        const Piece& piece = ofTriangles[i];
        TrianglesOnRaster part;
        part.instance = piece.instance;
        const TriangleMesh& mesh = scene.meshOf(piece.instance);
        const uint32_t* indices = mesh.indices().data();
        const Vertex* from = &vertices[firstVertex[piece.instance]];
        const auto first = uint32_t(scene.firstTriangle(piece.instance)) + 1;
        part.triangles.reserve((piece.end - piece.first) / 4);
        Setup setup(scene, projections[piece.instance], facing, result.size, part);
        for (size_t t = piece.first; t < piece.end; ++t) {
            const uint32_t* corners = indices + 3 * t;
            setup.add({from[corners[0]], from[corners[1]], from[corners[2]]}, first + uint32_t(t),
                      [&](size_t corner) { return mesh.positions()[corners[corner]]; });
        }
        result.parts[i] = std::move(part);
    });
    return result;
}

std::optional<ScreenTriangle> triangleOnRaster(const RasterCorner (&corners)[3], uint32_t number, const Viewport& size) {
    Corners vertices;
    for (size_t i = 0; i < 3; ++i)
        vertices[i] = {int32_t(std::lrint((corners[i].x - 0.5) * kSubPixels)),
                       int32_t(std::lrint((corners[i].y - 0.5) * kSubPixels)), corners[i].depth, 0};
    const int64_t twiceArea = area(vertices);
    return twiceArea == 0 ? std::nullopt : screenTriangle(vertices, twiceArea, number, size);
}

RasterBins::RasterBins(const SceneOnRaster& scene, int rows, bool parallel) {
    const size_t bandCount = (size_t(scene.size.height) + size_t(rows) - 1) / size_t(rows), parts = scene.parts.size();
    // By band, then part: how many triangles, then where the first of them is stored.
    std::vector<size_t> places(bandCount * parts, 0);
    const auto forBands = [&](size_t part, const auto& work) {
        for (const ScreenTriangle& triangle : scene.parts[part].triangles)
            for (size_t band = size_t(triangle.firstRow) / size_t(rows); band <= size_t(triangle.endRow - 1) / size_t(rows);
                 ++band)
                work(triangle, band);
    };
    forEachOf(parts, parallel,
              [&](size_t part) { forBands(part, [&](const ScreenTriangle&, size_t band) { ++places[band * parts + part]; }); });
    size_t sum = 0;
    for (size_t band = 0; band < bandCount; ++band) {
        m_begin.push_back(sum);
        for (size_t part = 0; part < parts; ++part) {
            const size_t count = places[band * parts + part];
            places[band * parts + part] = sum;
            sum += count;
        }
    }
    m_begin.push_back(sum);
    m_triangles.resize(sum);
    forEachOf(parts, parallel, [&](size_t part) {
        forBands(part,
                 [&](const ScreenTriangle& triangle, size_t band) { m_triangles[places[band * parts + part]++] = &triangle; });
    });
}

}  // namespace cullscope
