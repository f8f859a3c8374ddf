#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/geometry/frustum.h"
#include "core/geometry/frustum_batch_planes.h"

namespace cullscope {

/// The instruction set of a batch test: how many objects it tests at a time. The results are bit-identical on every level.
enum class SimdLevel { Scalar, Avx2, Avx512 };

/// "scalar", "AVX2", "AVX-512".
[[nodiscard]] const char* simdLevelName(SimdLevel level);
/// The levels that this build contains and this processor supports, the fastest last; Scalar always.
[[nodiscard]] std::span<const SimdLevel> availableSimdLevels();
/// The fastest of them.
[[nodiscard]] SimdLevel bestSimdLevel();

/// Objects of kRows doubles each as a structure of arrays, in blocks of kBatchBlock objects; the last block is padded with NaN.
template <size_t kRows>
class ObjectBatch {
public:
    [[nodiscard]] size_t size() const { return m_size; }
    [[nodiscard]] size_t blockCount() const { return m_blocks.size(); }
    /// 64-byte aligned; blockCount() · kRows · kBatchBlock doubles.
    [[nodiscard]] const double* blocks() const { return m_blocks.empty() ? nullptr : m_blocks.front().rows[0]; }
    /// Number of 64-bit words in a bit set over the objects.
    [[nodiscard]] size_t wordCount() const { return (m_size + 63) / 64; }
    [[nodiscard]] size_t bytes() const { return m_blocks.size() * sizeof(Block); }

protected:
    struct alignas(64) Block {
        double rows[kRows][kBatchBlock];
    };
    explicit ObjectBatch(size_t size);
    template <typename Object>
    void fill(std::span<const Object> objects);

private:
    double& at(size_t row, size_t object) { return m_blocks[object / kBatchBlock].rows[row][object % kBatchBlock]; }

    size_t m_size;
    std::vector<Block> m_blocks;
};

/// Boxes in world coordinates, without rounding. A box that is empty (min > max, NaN), not finite or beyond 2^1000 is neither
/// outside nor inside, because its place is not known.
class BoxBatch : public ObjectBatch<kBoxRows> {
public:
    explicit BoxBatch(std::span<const Box3> boxes);
};

/// Spheres in world coordinates. One with a negative radius, or with a number that is not finite or beyond 2^1000, is neither
/// outside nor inside, as with boxes.
class SphereBatch : public ObjectBatch<kSphereRows> {
public:
    explicit SphereBatch(std::span<const Sphere> spheres);
};

/// A view frustum prepared for batch tests in world coordinates.
///
/// The distances to a plane are n·p + (d − n·eye) at the box's p- and n-vertex, which the signs of the normal choose for all
/// boxes at once (Assarsson & Möller 2000): half the operations of the test by centre and extents. The margin is at least
/// marginFromEye of visibility/eye_bounds.h. It uses the 1-norm in place of the length, so it is at most about √3 times as large:
/// with |world| <= |c − eye| + |eye| it is conservativeMargin(m) + (m + 2 |eye|)·2^-49, where m = |c − eye| + reach. The second
/// term is four times the error bound of working in world coordinates: a distance takes four roundings of 2^-53 of |p|, its plane
/// four of |eye|.
class BatchFrustum {
public:
    /// `frustum` is relative to the eye, `eye` is in world coordinates; with an eye beyond 2^1000 no object is outside or inside.
    BatchFrustum(const Frustum& frustum, const Vec3& eye);

    /// The distances that the batch tests compute for one object, bit-identical on every level: it is outside where
    /// farthestInside < −margin for a plane, inside where farthestOutside > margin for all six. NaN where an object is neither by
    /// the rule above.
    [[nodiscard]] BatchDistances distances(FrustumPlane plane, const Box3& box) const;
    [[nodiscard]] BatchDistances distances(FrustumPlane plane, const Sphere& sphere) const;

    [[nodiscard]] const BatchPlanes& planes() const { return m_planes; }

private:
    BatchPlanes m_planes{};
};

/// How far an object reaches inside a plane: the signed distance of its point farthest inside.
struct PlaneReach {
    double farthestInside = 0.0, margin = 0.0;

    [[nodiscard]] bool outside() const { return farthestInside < -margin; }
};

/// Is told of the test of one object against one plane.
using BatchTestTold = std::function<void(uint32_t object, FrustumPlane plane, const PlaneReach& reach)>;

/// Finds the objects that lie outside a plane of the frustum: bit i % 64 of word i / 64 for object i; bits beyond the last object
/// are 0. Conservative: an object that intersects the frustum is never outside. `level` is one of availableSimdLevels().
/// `told`: of every test where it falls, in the order of the level's batches: all objects of a batch against one plane, then
/// against the next, until all of them are outside. Objects whose place is not known are left
/// out. Without it nothing is told, which costs nothing.
void findOutside(const BoxBatch& boxes, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside,
                 const BatchTestTold& told = {});
void findOutside(const SphereBatch& spheres, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside,
                 const BatchTestTold& told = {});

}  // namespace cullscope
