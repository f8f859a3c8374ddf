#include "core/raster/occlusion_buffer.h"

#include <algorithm>
#include <cmath>

#include "core/raster/kernel_choice.h"
#include "core/raster/triangle_setup.h"

namespace cullscope {
namespace {

/// Beyond every depth: of pixels that lie beyond the picture.
constexpr float kBeyondPicture = 2.0f;

int32_t tilesAlong(int32_t pixels, int32_t ofTile) { return (pixels + ofTile - 1) / ofTile; }

/// The pixels of a block that lie in a rectangle given from the block's lower left pixel.
uint32_t blockBits(int32_t firstColumn, int32_t endColumn, int32_t firstRow, int32_t endRow) {
    const auto limited = [](int32_t value, int32_t most) { return uint32_t(std::clamp(value, 0, most)); };
    const uint32_t left = limited(firstColumn, kBlockColumns), right = limited(endColumn, kBlockColumns);
    const uint32_t low = limited(firstRow, kBlockRows), high = limited(endRow, kBlockRows);
    if (left >= right || low >= high) return 0;
    const uint32_t ofRow = (1u << right) - (1u << left);
    const uint32_t rows = uint32_t((uint64_t{1} << 8 * high) - (uint64_t{1} << 8 * low));
    return ofRow * 0x01010101u & rows;
}

}  // namespace

OcclusionBuffer::OcclusionBuffer(OcclusionForm form, RasterSimd simd) : m_form(form), m_simd(simd) {}

void OcclusionBuffer::begin(const View& view) {
    m_view.emplace(view);
    m_counts = {};
    m_cleared = false;
}

/// A picture without occluders costs nothing: only the first one clears it.
void OcclusionBuffer::clear() {
    m_cleared = true;
    const int32_t width = m_view->viewport().width, height = m_view->viewport().height;
    m_tilesInRow = tilesAlong(width, kOcclusionColumns);
    const auto tiles = size_t(m_tilesInRow) * size_t(tilesAlong(height, kOcclusionRows));
    if (m_form == OcclusionForm::Masked) return m_masked.assign(tiles, MaskedTile{});
    m_depths.assign(tiles, DepthTile{});
    m_farthest.assign(tiles, 0.0f);
    for (int32_t row = 0; row < tilesAlong(height, kOcclusionRows) * kOcclusionRows; ++row)
        for (int32_t column = row < height ? width : 0; column < m_tilesInRow * kOcclusionColumns; ++column)
            m_depths[tileAt(column, row)].depth[row % kOcclusionRows * kOcclusionColumns + column % kOcclusionColumns] =
                kBeyondPicture;
}

void OcclusionBuffer::draw(const Scene& scene, uint32_t instance, Facing facing, std::span<const Vec3f> positions,
                           std::span<const uint32_t> indices) {
    const size_t count = indices.size() / 3;
    m_counts.given += count;
    if (count == 0) return;
    const Viewport& size = m_view->viewport();
    const Projection projection(*m_view, scene, instance);
    const RasterFacing sides(scene, instance, facing);
    m_vertices.resize(positions.size());
    kernelFor<ProjectionKernel>(m_simd, CULLSCOPE_VARIANTS(project))(projection.forKernels(), &positions.front().x,
                                                                     positions.size(), m_vertices.data());
    m_places.resize(std::max(m_places.size(), count + 8));
    // Bands of rows are of no use here: one has them all.
    kernelFor<PlacingKernel>(m_simd, CULLSCOPE_VARIANTS(place))(
        {m_vertices.data(), indices.data(), count, size.width, size.height, 1 << 14, Beyond::Unprojectable, sides.front,
         sides.mirrored},
        m_places.data());
    m_onRaster.resize(std::max(m_onRaster.size(), 3 * (count + kMostPieces)));
    size_t end = 0;
    for (size_t i = 0; i < count; ++i) {
        const uint32_t* corners = &indices[3 * i];
        switch (m_places[i] % (1u << kFirstBandShift)) {
            case kPlacedSmall:
            case kPlacedLarge:
                std::copy_n(corners, 3, &m_onRaster[end]);
                end += 3;
                break;
            case kPlacedBeyond: {
                const auto clip = [&](size_t corner) { return projection.clip(positions[corners[corner]]); };
                end = addPieces(clippedCorners(projection, {clip(0), clip(1), clip(2)}), end);
                m_onRaster.resize(std::max(m_onRaster.size(), end + 3 * (count - i + kMostPieces)));
                break;
            }
            default:
                break;
        }
    }
    m_triangles.resize(std::max(m_triangles.size(), end / 3));
    const size_t drawn = kernelFor<OccluderSetupKernel>(m_simd, CULLSCOPE_VARIANTS(setUpOccluders))(
        {m_vertices.data(), m_onRaster.data(), end / 3, size.width, size.height, sides.front, sides.mirrored},
        m_triangles.data());
    if (drawn == 0) return;
    if (!m_cleared) clear();
    m_counts.drawn += drawn;
    kernelFor<OccluderKernel>(m_simd, CULLSCOPE_VARIANTS(drawOccluders))(
        m_triangles.data(), drawn,
        {m_form == OcclusionForm::Depth ? m_depths.data() : nullptr, m_farthest.data(),
         m_form == OcclusionForm::Masked ? m_masked.data() : nullptr, m_tilesInRow, size.width, size.height});
}

/// The pieces of a clipped triangle have vertices of their own, after those of the mesh. Their corners are stored from `end`;
/// returns where they end.
size_t OcclusionBuffer::addPieces(const ClippedCorners& clipped, size_t end) {
    const auto first = uint32_t(m_vertices.size());
    m_vertices.insert(m_vertices.end(), clipped.corners.begin(), clipped.corners.begin() + ptrdiff_t(clipped.count));
    for (uint32_t i = 2; i < clipped.count; ++i)
        for (const uint32_t corner : {first + i - 1, first + i, first}) m_onRaster[end++] = corner;
    return end;
}

std::optional<BoxInPicture> OcclusionBuffer::place(const EyeBox& grown, double towardsEye) const {
    const Frustum& frustum = m_view->frustum();
    const Viewport& size = m_view->viewport();
    const double nearest =
        glm::dot(frustum.forward, grown.centre) - glm::dot(glm::abs(frustum.forward), grown.halfExtent) - towardsEye;
    if (!(nearest > frustum.nearDistance)) return std::nullopt;
    const Mat4& matrix = m_view->clipFromEyeRelative();
    const auto clipOf = [&](const Vec3& p) {
        return Vec3(matrix[0].x * p.x + matrix[1].x * p.y + matrix[2].x * p.z,
                    matrix[0].y * p.x + matrix[1].y * p.y + matrix[2].y * p.z,
                    matrix[0].w * p.x + matrix[1].w * p.y + matrix[2].w * p.z);
    };
    const Vec3 centre = clipOf(grown.centre) + Vec3(matrix[3].x, matrix[3].y, matrix[3].w);
    const Vec3 alongX = clipOf({grown.halfExtent.x, 0, 0}), alongY = clipOf({0, grown.halfExtent.y, 0}),
               alongZ = clipOf({0, 0, grown.halfExtent.z});
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 clip = centre + ((corner & 1) != 0 ? alongX : -alongX) + ((corner & 2) != 0 ? alongY : -alongY) +
                          ((corner & 4) != 0 ? alongZ : -alongZ);
        const double inverse = 1.0 / clip.z, x = clip.x * inverse, y = clip.y * inverse;
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    // The pixels whose centres the box covers, where corners are rounded to 1/256 pixel or a little farther, and one around them.
    // The comparisons are false for what is not a number.
    constexpr double kRoom = 1.0 / 64.0;
    const auto place = [](double clip, int32_t pixels) {
        return std::clamp((clip + 1.0) * 0.5 * pixels - 0.5, -4.0, double(pixels) + 4.0);
    };
    if (!(left <= right) || !(low <= high)) return std::nullopt;
    BoxInPicture box;
    box.firstColumn = std::max(int32_t(std::ceil(place(left, size.width) - kRoom)) - 1, 0);
    box.endColumn = std::min(int32_t(std::floor(place(right, size.width) + kRoom)) + 2, size.width);
    box.firstRow = std::max(int32_t(std::ceil(place(low, size.height) - kRoom)) - 1, 0);
    box.endRow = std::min(int32_t(std::floor(place(high, size.height) + kRoom)) + 2, size.height);
    // OpenGL's depths are rounded by parts of their largest term: in perspective near / distance, else 1.
    const double rounding = frustum.parallel() ? 0x1p-20 : 0x1p-19 * frustum.nearDistance / nearest;
    box.depth = std::nextafter(float(m_view->depthFromDistance(nearest) + rounding), INFINITY);
    return box;
}

/// The farthest depth of a tile's pixels, which is kept until a triangle is drawn there.
float OcclusionBuffer::farthestOf(size_t tile) {
    float& farthest = m_farthest[tile];
    if (farthest == kUnknownFarthest) farthest = *std::ranges::min_element(m_depths[tile].depth);
    return farthest;
}

void OcclusionBuffer::settle() {
    if (m_form != OcclusionForm::Depth || empty()) return;
    for (size_t tile = 0; tile < m_farthest.size(); ++tile) farthestOf(tile);
}

bool OcclusionBuffer::hides(const BoxInPicture& box) {
    if (empty()) return false;
    if (m_form == OcclusionForm::Masked) return maskedHides(box);
    return depthHides(box, [this](size_t tile) { return farthestOf(tile); });
}

bool OcclusionBuffer::hides(const BoxInPicture& box) const {
    if (empty()) return false;
    if (m_form == OcclusionForm::Masked) return maskedHides(box);
    // Of a tile that nothing is known of every pixel is looked at.
    return depthHides(box, [this](size_t tile) { return m_farthest[tile]; });
}

template <typename FarthestInTile>
bool OcclusionBuffer::depthHides(const BoxInPicture& box, const FarthestInTile& farthest) const {
    static_assert(kUnknownFarthest < 0.0f, "no box lies behind it");
    for (int32_t row = box.firstRow & -kOcclusionRows; row < box.endRow; row += kOcclusionRows)
        for (int32_t column = box.firstColumn & -kOcclusionColumns; column < box.endColumn; column += kOcclusionColumns) {
            const size_t number = tileAt(column, row);
            if (farthest(number) > box.depth) continue;
            const DepthTile& tile = m_depths[number];
            const int32_t firstRow = std::max(box.firstRow - row, 0), endRow = std::min(box.endRow - row, kOcclusionRows);
            const int32_t first = std::max(box.firstColumn - column, 0),
                          end = std::min(box.endColumn - column, kOcclusionColumns);
            for (int32_t r = firstRow; r < endRow; ++r) {
                float least = kBeyondPicture;
                for (int32_t c = first; c < end; ++c) least = std::min(least, tile.depth[r * kOcclusionColumns + c]);
                if (!(least > box.depth)) return false;
            }
        }
    return true;
}

bool OcclusionBuffer::maskedHides(const BoxInPicture& box) const {
    for (int32_t row = box.firstRow & -kOcclusionRows; row < box.endRow; row += kOcclusionRows)
        for (int32_t column = box.firstColumn & -kOcclusionColumns; column < box.endColumn; column += kOcclusionColumns) {
            const MaskedTile& tile = m_masked[tileAt(column, row)];
            uint32_t farther = 0;
            for (int32_t block = 0; block < kBlocks; ++block) farther |= uint32_t(!(tile.whole[block] > box.depth)) << block;
            for (int32_t block = 0; farther != 0; ++block, farther >>= 1) {
                if ((farther & 1) == 0) continue;
                const int32_t left = column + block % kBlocksInRow * kBlockColumns, low = row + block / kBlocksInRow * kBlockRows;
                const uint32_t asked =
                    blockBits(box.firstColumn - left, box.endColumn - left, box.firstRow - low, box.endRow - low);
                if (asked != 0 && ((asked & ~tile.mask[block]) != 0 || !(tile.part[block] > box.depth))) return false;
            }
        }
    return true;
}

float OcclusionBuffer::depthAt(int32_t column, int32_t row) const {
    if (!m_cleared) return 0.0f;
    const size_t number = tileAt(column, row);
    const int32_t c = column % kOcclusionColumns, r = row % kOcclusionRows;
    if (m_form == OcclusionForm::Depth) return m_depths[number].depth[r * kOcclusionColumns + c];
    const MaskedTile& tile = m_masked[number];
    const int32_t block = r / kBlockRows * kBlocksInRow + c / kBlockColumns;
    const bool masked = (tile.mask[block] >> (r % kBlockRows * kBlockColumns + c % kBlockColumns) & 1) != 0;
    return masked ? tile.part[block] : tile.whole[block];
}

float OcclusionBuffer::farthestIn(const BoxInPicture& box) const {
    float farthest = kBeyondPicture;
    for (int32_t row = box.firstRow; row < box.endRow; ++row)
        for (int32_t column = box.firstColumn; column < box.endColumn; ++column)
            farthest = std::min(farthest, depthAt(column, row));
    return farthest;
}

std::vector<float> OcclusionBuffer::depths() const {
    const Viewport& size = m_view->viewport();
    std::vector<float> result;
    result.reserve(size_t(size.width) * size_t(size.height));
    for (int32_t row = 0; row < size.height; ++row)
        for (int32_t column = 0; column < size.width; ++column) result.push_back(depthAt(column, row));
    return result;
}

uint64_t OcclusionBuffer::bytes() const {
    return m_depths.size() * sizeof(DepthTile) + m_farthest.size() * sizeof(float) + m_masked.size() * sizeof(MaskedTile);
}

}  // namespace cullscope
