#include "core/geometry/frustum_batch.h"

#include <array>
#include <cmath>
#include <limits>

namespace cullscope {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// Factor that exceeds the rounding of the margin's own sums, so that the computed margin is never below its bound.
constexpr double kRoundedUp = 1.0 + 0x1p-40;
/// Coordinates up to this size have finite sums, so that no test computes infinity − infinity.
constexpr double kLargest = 0x1p1000;

bool within(const Vec3& point) {
    return std::abs(point.x) <= kLargest && std::abs(point.y) <= kLargest && std::abs(point.z) <= kLargest;
}

bool decidable(const Box3& box) { return !box.empty() && within(box.min) && within(box.max); }

bool decidable(const Sphere& sphere) { return within(sphere.centre) && sphere.radius >= 0.0 && sphere.radius <= kLargest; }

std::array<double, kBoxRows> rowsOf(const Box3& box) {
    return {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
}

std::array<double, kSphereRows> rowsOf(const Sphere& sphere) {
    return {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius};
}

/// A block with this object as its first.
template <typename Object>
auto blockOf(const Object& object) {
    const auto rows = rowsOf(object);
    std::array<double, std::tuple_size_v<decltype(rowsOf(object))> * kBatchBlock> block;
    block.fill(kNaN);
    for (size_t row = 0; row < rows.size() && decidable(object); ++row) block[row * kBatchBlock] = rows[row];
    return block;
}

double norm1(const Vec3& vector) { return std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z); }

BatchPlane batchPlane(const Plane& plane, const Vec3& eye) {
    BatchPlane result{};
    result.offset = plane.offset - glm::dot(plane.normal, eye);
    for (int axis = 0; axis < 3; ++axis) {
        const size_t min = size_t(axis) * kBatchBlock, max = size_t(axis + 3) * kBatchBlock;
        const bool towardsMax = plane.normal[axis] >= 0.0;
        result.normal[axis] = plane.normal[axis];
        result.inner[axis] = towardsMax ? max : min;
        result.outer[axis] = towardsMax ? min : max;
    }
    return result;
}

struct LevelTable {
    std::array<SimdLevel, 3> levels{SimdLevel::Scalar};
    size_t count = 1;
};

LevelTable findLevels() {
    LevelTable table;
#ifdef CULLSCOPE_BATCH_AVX
    if (__builtin_cpu_supports("avx2")) table.levels[table.count++] = SimdLevel::Avx2;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) table.levels[table.count++] = SimdLevel::Avx512;
#endif
    return table;
}

BatchKernel* boxKernel(SimdLevel level) {
#ifdef CULLSCOPE_BATCH_AVX
    if (level == SimdLevel::Avx512) return testBoxesAvx512;
    if (level == SimdLevel::Avx2) return testBoxesAvx2;
#endif
    return testBoxesScalar;
}

BatchKernel* sphereKernel(SimdLevel level) {
#ifdef CULLSCOPE_BATCH_AVX
    if (level == SimdLevel::Avx512) return testSpheresAvx512;
    if (level == SimdLevel::Avx2) return testSpheresAvx2;
#endif
    return testSpheresScalar;
}

/// Hands on what a kernel tells: of the objects, not of those that fill the last block.
struct TestTeller {
    const BatchTestTold& told;
    size_t objects;

    static void tell(void* to, const BatchTests& tests) {
        const auto& teller = *static_cast<const TestTeller*>(to);
        for (size_t i = 0; i < tests.count && tests.object + i < teller.objects; ++i)
            if (!std::isnan(tests.inside[i]) && !std::isnan(tests.margin[i]))
                teller.told(uint32_t(tests.object + i), FrustumPlane(tests.plane), {tests.inside[i], tests.margin[i]});
    }
};

template <typename Batch>
void runKernel(BatchKernel* kernel, const Batch& batch, const BatchFrustum& frustum, std::vector<uint64_t>& outside,
               const BatchTestTold& told) {
    outside.resize(batch.wordCount());
    TestTeller teller{told, batch.size()};
    const BatchListener listener{TestTeller::tell, &teller};
    kernel(batch.blocks(), batch.blockCount(), frustum.planes(), outside.data(), told ? &listener : nullptr);
}

}  // namespace

const char* simdLevelName(SimdLevel level) {
    constexpr std::array kNames{"scalar", "AVX2", "AVX-512"};
    return kNames[static_cast<size_t>(level)];
}

std::span<const SimdLevel> availableSimdLevels() {
    static const LevelTable table = findLevels();
    return std::span(table.levels).first(table.count);
}

SimdLevel bestSimdLevel() { return availableSimdLevels().back(); }

template <size_t kRows>
ObjectBatch<kRows>::ObjectBatch(size_t size) : m_size(size), m_blocks((size + kBatchBlock - 1) / kBatchBlock) {
    for (size_t object = size; object < m_blocks.size() * kBatchBlock; ++object)
        for (size_t row = 0; row < kRows; ++row) at(row, object) = kNaN;
}

template <size_t kRows>
template <typename Object>
void ObjectBatch<kRows>::fill(std::span<const Object> objects) {
    for (size_t i = 0; i < objects.size(); ++i) {
        const bool known = decidable(objects[i]);
        const auto values = rowsOf(objects[i]);
        for (size_t row = 0; row < kRows; ++row) at(row, i) = known ? values[row] : kNaN;
    }
}

BoxBatch::BoxBatch(std::span<const Box3> boxes) : ObjectBatch(boxes.size()) { fill(boxes); }

SphereBatch::SphereBatch(std::span<const Sphere> spheres) : ObjectBatch(spheres.size()) { fill(spheres); }

BatchFrustum::BatchFrustum(const Frustum& frustum, const Vec3& eye) {
    for (size_t p = 0; p < frustum.planes.size(); ++p) m_planes.planes[p] = batchPlane(frustum.planes[p], eye);
    for (int axis = 0; axis < 3; ++axis) m_planes.eye[axis] = eye[axis];
    m_planes.marginOfMagnitude = (conservativeMargin(1.0) + 0x1p-49) * kRoundedUp;
    m_planes.marginOfEye = within(eye) ? norm1(eye) * 0x1p-48 * kRoundedUp : kNaN;
}

BatchDistances BatchFrustum::distances(FrustumPlane plane, const Box3& box) const {
    return boxDistances(blockOf(box).data(), m_planes, size_t(plane));
}

BatchDistances BatchFrustum::distances(FrustumPlane plane, const Sphere& sphere) const {
    return sphereDistances(blockOf(sphere).data(), m_planes, size_t(plane));
}

void findOutside(const BoxBatch& boxes, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside,
                 const BatchTestTold& told) {
    runKernel(boxKernel(level), boxes, frustum, outside, told);
}

void findOutside(const SphereBatch& spheres, const BatchFrustum& frustum, SimdLevel level, std::vector<uint64_t>& outside,
                 const BatchTestTold& told) {
    runKernel(sphereKernel(level), spheres, frustum, outside, told);
}

}  // namespace cullscope
