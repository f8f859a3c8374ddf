#include "core/raster/scene_triangles.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/raster/in_parallel.h"
#include "core/raster/kernel_choice.h"
#include "core/raster/triangle_setup.h"

namespace cullscope {
namespace {

/// A part has at most so many triangles: then the places of its set-up triangles stay below kSetUp.
constexpr size_t kPartTriangles = 2048;
static_assert(kPartTriangles * kMostPieces < kSetUp);

/// A piece of an instance's vertices or triangles.
struct Piece {
    uint32_t instance;
    size_t first, end;
};

/// Cuts what each instance has into pieces of equal size.
template <typename CountOf>
std::vector<Piece> piecesOf(const Scene& scene, size_t size, const CountOf& countOf) {
    std::vector<Piece> pieces;
    for (uint32_t i = 0; i < scene.instances().size(); ++i)
        for (size_t first = 0, count = countOf(scene.meshOf(i)); first < count; first += size)
            pieces.push_back({i, first, std::min(first + size, count)});
    return pieces;
}

/// Puts the triangles of a part on the raster, one after the other.
class Placing {
public:
    /// `projection` brings the positions to the raster where a triangle must be clipped; null where none must.
    Placing(TrianglesOnRaster& part, const RasterFacing& facing, const Viewport& size, std::vector<uint8_t>& fates,
            const Projection* projection = nullptr, const Vec3f* positions = nullptr)
        : m_part(part),
          m_facing(facing),
          m_size(size),
          m_fates(&fates[part.firstNumber - 1]),
          m_projection(projection),
          m_positions(positions) {
        m_placed.reserve(kPartTriangles);
    }

    /// All triangles of the part.
    void addAll(size_t count, PlacingKernel* kernel) {
        m_part.given = count;
        uint32_t places[kPartTriangles + 8];
        kernel({m_part.vertices, m_part.indices, count, m_size.width, m_size.height, kBandRows, Beyond::Unprojectable,
                m_facing.front, m_facing.mirrored},
               places);
        for (size_t triangle = 0; triangle < count; ++triangle) {
            const uint32_t place = places[triangle];
            switch (place % (1u << kFirstBandShift)) {
                case kPlacedSmall:
                    m_placed.push_back({uint16_t(triangle), uint16_t(place >> kFirstBandShift & kBandMask),
                                        uint16_t(place >> kLastBandShift & kBandMask)});
                    break;
                case kPlacedLarge:
                    addLarge(triangle);
                    break;
                case kPlacedBeyond:
                    addClippedAt(triangle);
                    break;
                case kPlacedOutside:
                    ++m_part.outside;
                    m_fates[triangle] = kOutside;
                    break;
                default:
                    this->count(triangle, place == kPlacedFacingAway ? RasterFate::FacingAway : RasterFate::WithoutSample);
            }
        }
    }

    /// Sorts the part's entries by band.
    void finish(size_t bands) {
        std::vector<uint32_t>& begin = m_part.bandBegin;
        begin.assign(bands + 1, 0);
        for (const Placed& one : m_placed)
            for (size_t band = one.firstBand; band <= one.lastBand; ++band) ++begin[band];
        uint32_t sum = 0;
        for (uint32_t& count : begin) count = std::exchange(sum, sum + count);
        m_part.entries.resize(sum);
        for (const Placed& one : m_placed)
            for (size_t band = one.firstBand; band <= one.lastBand; ++band) m_part.entries[begin[band]++] = one.entry;
        // Each band's beginning is now its end.
        for (size_t band = bands; band > 0; --band) begin[band] = begin[band - 1];
        begin[0] = 0;
        m_part.onRaster = m_placed.size();
    }

private:
    struct Placed {
        uint16_t entry, firstBand, lastBand;
    };

    static constexpr uint32_t kBandMask = (1u << (kLastBandShift - kFirstBandShift)) - 1;

    void addLarge(size_t triangle) {
        const uint32_t* corners = m_part.indices + 3 * triangle;
        const RasterCorners places(m_part.vertices[corners[0]], m_part.vertices[corners[1]], m_part.vertices[corners[2]]);
        const int64_t area = places.twiceArea();
        if (area == 0) return count(triangle, RasterFate::WithoutSample);
        if (m_facing.drops(area)) return count(triangle, RasterFate::FacingAway);
        const std::optional<ScreenTriangle> large = screenTriangle(places, area, m_part.firstNumber + uint32_t(triangle), m_size);
        if (!large) return count(triangle, RasterFate::WithoutSample);
        m_part.setUp.push_back(*large);
        placeSetUp(m_part.setUp.size() - 1);
    }
    void addClippedAt(size_t triangle) {
        const uint32_t* corners = m_part.indices + 3 * triangle;
        const auto clip = [&](size_t i) { return m_projection->clip(m_positions[corners[i]]); };
        ++m_part.clipped;
        size_t next = m_part.setUp.size();
        count(triangle, addClipped(*m_projection, {clip(0), clip(1), clip(2)}, m_facing, m_part.firstNumber + uint32_t(triangle),
                                   m_size, m_part.setUp));
        for (; next < m_part.setUp.size(); ++next) placeSetUp(next);
    }
    void placeSetUp(size_t number) {
        const ScreenTriangle& triangle = m_part.setUp[number];
        m_placed.push_back(
            {uint16_t(kSetUp | number), uint16_t(triangle.firstRow / kBandRows), uint16_t((triangle.endRow - 1) / kBandRows)});
    }
    void count(size_t triangle, RasterFate fate) {
        if (fate == RasterFate::FacingAway) {
            ++m_part.facingAway;
            m_fates[triangle] = kFacingAway;
        }
        if (fate == RasterFate::WithoutSample) ++m_part.withoutSample;
    }

    TrianglesOnRaster& m_part;
    const RasterFacing& m_facing;
    const Viewport& m_size;
    uint8_t* m_fates;  ///< of the part's triangles
    const Projection* m_projection;
    const Vec3f* m_positions;
    std::vector<Placed> m_placed;
};

PlacingKernel* placingKernelOf(RasterSimd simd) { return kernelFor<PlacingKernel>(simd, CULLSCOPE_VARIANTS(place)); }

}  // namespace

std::span<const RasterSimd> availableRasterSimd() {
    static constexpr std::array kAll{RasterSimd::Portable, RasterSimd::Avx2, RasterSimd::Avx512};
#ifdef CULLSCOPE_RASTER_AVX
    static const bool kAvx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    static const bool kAvx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                                __builtin_cpu_supports("avx512vl") != 0;
    if (kAvx2) return std::span(kAll).first(kAvx512 ? 3 : 2);
#endif
    return std::span(kAll).first(1);
}

PartInBand TrianglesOnRaster::inBand(size_t band) const {
    return {
        vertices, indices, firstNumber, setUp.data(), entries.data() + bandBegin[band], bandBegin[band + 1] - bandBegin[band]};
}

size_t SceneOnRaster::triangleCount() const {
    size_t count = 0;
    for (const TrianglesOnRaster& part : parts) count += part.onRaster;
    return count;
}

std::vector<ScreenTriangle> SceneOnRaster::trianglesIn(size_t band, const Progress& progress) const {
    std::vector<ScreenTriangle> triangles;
    size_t count = 0;
    for (const TrianglesOnRaster& part : parts) count += part.inBand(band).count;
    triangles.reserve(count);
    for (const TrianglesOnRaster& part : parts) {
        progress.check();
        const PartInBand inBand = part.inBand(band);
        for (const uint16_t entry : std::span(inBand.entries, inBand.count)) {
            if ((entry & kSetUp) != 0) {
                triangles.push_back(part.setUp[entry & ~kSetUp]);
                continue;
            }
            const uint32_t* corners = part.indices + 3 * size_t(entry);
            const RasterCorners places(part.vertices[corners[0]], part.vertices[corners[1]], part.vertices[corners[2]]);
            const int64_t area = places.twiceArea();
            triangles.push_back(*screenTriangle(places, area, part.firstNumber + entry, size));
        }
    }
    return triangles;
}

uint64_t SceneOnRaster::bytes() const {
    uint64_t sum = vertexCount * sizeof(RasterVertex) + ownIndices.capacity() * sizeof(uint32_t) + fates.capacity();
    for (const TrianglesOnRaster& part : parts)
        sum += sizeof part + part.setUp.capacity() * sizeof(ScreenTriangle) + part.entries.capacity() * sizeof(uint16_t) +
               part.bandBegin.capacity() * sizeof(uint32_t);
    return sum;
}

SceneOnRaster trianglesOnRaster(const Scene& scene, const View& view, Facing facing, bool parallel, RasterSimd simd,
                                const Progress& progress) {
    if (scene.triangleCount() >= UINT32_MAX)
        throwUsage(CULLSCOPE_TR("The scene has %1 triangles; the item buffer numbers at most 4294967294. Measure a part of it."),
                   {std::to_string(scene.triangleCount())});
    const size_t instances = scene.instances().size();
    std::vector<Projection> projections;
    std::vector<RasterFacing> facings;
    std::vector<size_t> firstVertex{0};
    projections.reserve(instances);
    for (size_t i = 0; i < instances; ++i) {
        projections.emplace_back(view, scene, i);
        facings.emplace_back(scene, i, facing);
        firstVertex.push_back(firstVertex.back() + scene.meshOf(i).vertexCount());
    }
    SceneOnRaster result;
    result.size = view.viewport();
    result.vertexCount = firstVertex.back();
    result.vertices.reset(new RasterVertex[result.vertexCount]);
    constexpr size_t kPartVertices = 4096;
    ProjectionKernel* const project = kernelFor<ProjectionKernel>(simd, CULLSCOPE_VARIANTS(project));
    const std::vector<Piece> ofVertices =
        piecesOf(scene, kPartVertices, [](const TriangleMesh& mesh) { return mesh.vertexCount(); });
    forEachOf(ofVertices.size(), parallel, [&](size_t i) {
        progress.check();
        const Piece& piece = ofVertices[i];
        const Projection projection = projections[piece.instance];
        const Vec3f* positions = scene.meshOf(piece.instance).positions().data();
        RasterVertex* to = &result.vertices[firstVertex[piece.instance]];
        project(projection.forKernels(), &positions[piece.first].x, piece.end - piece.first, to + piece.first);
    });

    const std::vector<Piece> ofTriangles =
        piecesOf(scene, kPartTriangles, [](const TriangleMesh& mesh) { return mesh.triangleCount(); });
    result.parts.resize(ofTriangles.size());
    result.fates.resize(scene.triangleCount(), kNoSample);
    forEachOf(ofTriangles.size(), parallel, [&](size_t i) {
        progress.check();
        const Piece& piece = ofTriangles[i];
        TrianglesOnRaster part;
        part.instance = piece.instance;
        const TriangleMesh& mesh = scene.meshOf(piece.instance);
        part.indices = mesh.indices().data() + 3 * piece.first;
        part.vertices = &result.vertices[firstVertex[piece.instance]];
        part.firstNumber = uint32_t(scene.firstTriangle(piece.instance) + piece.first) + 1;
        Placing placing(part, facings[piece.instance], result.size, result.fates, &projections[piece.instance],
                        mesh.positions().data());
        placing.addAll(piece.end - piece.first, placingKernelOf(simd));
        placing.finish(result.bands());
        result.parts[i] = std::move(part);
    });
    return result;
}

SceneOnRaster cornersOnRaster(std::span<const RasterCorner> corners, const Viewport& size) {
    SceneOnRaster result;
    result.size = size;
    result.vertexCount = corners.size();
    result.vertices.reset(new RasterVertex[corners.size()]);
    for (size_t i = 0; i < corners.size(); ++i) {
        result.vertices[i] = {float(corners[i].x), float(corners[i].y), corners[i].depth, 0};
        result.ownIndices.push_back(uint32_t(i));
    }
    result.fates.resize(corners.size() / 3, kNoSample);
    const RasterFacing bothSides;
    for (size_t first = 0, count = corners.size() / 3; first < count; first += kPartTriangles) {
        TrianglesOnRaster& part = result.parts.emplace_back();
        part.firstNumber = uint32_t(first) + 1;
        part.indices = &result.ownIndices[3 * first];
        part.vertices = result.vertices.get();
        Placing placing(part, bothSides, result.size, result.fates);
        placing.addAll(std::min(kPartTriangles, count - first), placingKernelOf(availableRasterSimd().back()));
        placing.finish(result.bands());
    }
    return result;
}

}  // namespace cullscope
