#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/frustum.h"
#include "core/geometry/frustum_batch_planes.h"

namespace cullscope {

/// How many objects a batch test takes at a time. The verdicts are the same bits on every level.
enum class SimdLevel { Scalar, Avx2, Avx512 };

/// "scalar", "AVX2", "AVX-512".
[[nodiscard]] const char* simdLevelName(SimdLevel level);
/// What this build has and this processor runs, the fastest last; Scalar always.
[[nodiscard]] std::span<const SimdLevel> availableSimdLevels();
/// The fastest of them.
[[nodiscard]] SimdLevel bestSimdLevel();

/// Objects of kRows doubles each as a structure of arrays, in blocks of kBatchBlock objects; what fills the last block is NaN.
template <size_t kRows>
class ObjectBatch {
public:
    [[nodiscard]] size_t size() const { return m_size; }
    [[nodiscard]] size_t blockCount() const { return m_blocks.size(); }
    /// 64-byte aligned; blockCount() · kRows · kBatchBlock doubles.
    [[nodiscard]] const double* blocks() const { return m_blocks.empty() ? nullptr : m_blocks.front().rows[0]; }
    /// Words of a bit set over the objects.
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

/// Boxes in world coordinates, as they are: nothing is rounded. One that is empty (min > max, NaN), not finite or beyond 2^1000
/// gets no verdict: it is never outside and never inside, as nothing can be said of where it lies.
class BoxBatch : public ObjectBatch<kBoxRows> {
public:
    explicit BoxBatch(std::span<const Box3> boxes);
};

/// Spheres in world coordinates. One with a radius below 0 or a number that is not finite or beyond 2^1000 gets no verdict, as
/// with boxes.
class SphereBatch : public ObjectBatch<kSphereRows> {
public:
    explicit SphereBatch(std::span<const Sphere> spheres);
};

/// A view frustum made ready for batch tests in world coordinates.
///
/// A plane's distances are n·p + (d − n·eye) at the box's p- and n-vertex, which the normal's signs choose for all boxes at once
/// (Assarsson & Möller 2000): half the operations of centre and extents. `margin` is no less than marginFromEye of
/// visibility/eye_bounds.h, with norm 1 in place of the length, hardly more than √3 times it: with |world| <= |c − eye| + |eye|,
/// conservativeMargin(m) + (m + 2 |eye|)·2^-49 where m = |c − eye| + reach. The second term is what working in world coordinates
/// may be wrong by, four times over: a distance takes four roundings of 2^-53 of |p|, its plane four of |eye|.
class BatchFrustum {
public:
    /// `frustum` is relative to the eye, which is given in world coordinates; beyond 2^1000, nothing gets a verdict.
    BatchFrustum(const Frustum& frustum, const Vec3& eye);

    /// What the batch tests compute of one object, to the bit, whatever their level: it is outside where farthestInside < −margin
    /// for a plane, inside where farthestOutside > margin for all six. NaN where it gets no verdict.
    [[nodiscard]] BatchDistances distances(FrustumPlane plane, const Box3& box) const;
    [[nodiscard]] BatchDistances distances(FrustumPlane plane, const Sphere& sphere) const;

    [[nodiscard]] const BatchPlanes& planes() const { return m_planes; }

private:
    BatchPlanes m_planes{};
};

/// Says which objects lie outside a plane of the frustum: bit i % 64 of word i / 64 for object i, 0 beyond the last one.
/// Conservative: an object that reaches into the frustum is never outside. `level` is one of availableSimdLevels().
void findOutside(const BoxBatch& boxes, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside);
void findOutside(const SphereBatch& spheres, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside);

}  // namespace cullscope
