// What a batch test tells: every test that it makes, with the numbers that it compares, in the order of its batches.

#include <cmath>

#include "core/geometry/frustum_batch.h"
#include "core/geometry/random.h"

namespace cullscope::frustum_batch_order_test {
namespace {

constexpr size_t kObjects = 237;  // three words of 64 and a rest that fills no group

struct ToldTest {
    uint32_t object = 0;
    FrustumPlane plane = FrustumPlane::Left;
    double inside = 0.0, margin = 0.0;

    bool operator==(const ToldTest&) const = default;
};

/// How many objects a level tests together, and after how many planes it looks whether all are outside.
struct Group {
    size_t objects = 1, planes = 1;
};

Group groupOf(SimdLevel level) {
    if (level == SimdLevel::Scalar) return {};
    return level == SimdLevel::Avx2 ? Group{16, 2} : Group{32, 2};
}

/// The first objects of the groups, which begin anew with every 64 objects; the rest of these has groups of kBatchBlock.
std::vector<std::pair<size_t, size_t>> groupsOf(size_t objects, size_t group) {
    std::vector<std::pair<size_t, size_t>> groups;
    const size_t padded = (objects + kBatchBlock - 1) / kBatchBlock * kBatchBlock;
    for (size_t word = 0; word < padded; word += 64)
        for (size_t first = word; first < std::min(word + 64, padded);) {
            const size_t count = std::min(word + 64, padded) - first >= group ? group : kBatchBlock;
            groups.emplace_back(first, count);
            first += count;
        }
    return groups;
}

/// The tests of a level, made here from the distances of single objects.
template <typename Object>
std::vector<ToldTest> ownTests(const std::vector<Object>& objects, const BatchFrustum& frustum, SimdLevel level) {
    const Group group = groupOf(level);
    std::vector<ToldTest> tests;
    for (const auto& [first, count] : groupsOf(objects.size(), group.objects)) {
        std::vector<bool> outside(count, false);
        for (size_t plane = 0; plane < 6 && std::ranges::find(outside, false) != outside.end(); plane += group.planes)
            for (size_t p = plane; p < plane + group.planes; ++p)
                for (size_t i = 0; i < count && first + i < objects.size(); ++i) {
                    const BatchDistances own = frustum.distances(FrustumPlane(p), objects[first + i]);
                    if (std::isnan(own.farthestInside)) continue;
                    tests.push_back({uint32_t(first + i), FrustumPlane(p), own.farthestInside, own.margin});
                    outside[i] = outside[i] || own.farthestInside < -own.margin;
                }
    }
    return tests;
}

template <typename Batch, typename Object>
void expectOwnOrder(const std::vector<Object>& objects, const Frustum& frustum, const Vec3& eye) {
    const Batch batch(objects);
    const BatchFrustum prepared(frustum, eye);
    for (const SimdLevel level : availableSimdLevels()) {
        SCOPED_TRACE(simdLevelName(level));
        std::vector<ToldTest> told;
        std::vector<uint64_t> plain, listened;
        findOutside(batch, prepared, level, plain);
        findOutside(batch, prepared, level, listened, [&](uint32_t object, FrustumPlane plane, const PlaneReach& reach) {
            told.push_back({object, plane, reach.farthestInside, reach.margin});
        });
        EXPECT_EQ(listened, plain) << "listening changes no answer";
        EXPECT_EQ(told, ownTests(objects, prepared, level));
        EXPECT_LT(told.size(), 6 * objects.size()) << "groups that are left before their last plane";
    }
}

Frustum frustumAhead() { return makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.4, 0.1, 40.0); }

/// A place in the frustum or around it; the first hundred lie behind the eye, so that whole groups are outside.
Vec3 place(Random& random, size_t object) {
    const Vec3 place(random.between(-20, 20), random.between(-20, 20), random.between(-50, 10));
    return object < 100 ? Vec3(place.x, place.y, 20.0 + std::abs(place.z)) : place;
}

TEST(FrustumBatchOrder, tellsTheTestsOfBoxesAsTheBatchesMakeThem) {
    Random random(3);
    const Vec3 eye(100, 20, 3);
    std::vector<Box3> boxes;
    for (size_t i = 0; i < kObjects; ++i) {
        const Vec3 centre = eye + place(random, i), half(random.unit(), random.unit(), random.unit());
        boxes.push_back({centre - half, centre + half});
    }
    boxes[110] = {};
    expectOwnOrder<BoxBatch>(boxes, frustumAhead(), eye);
}

TEST(FrustumBatchOrder, tellsTheTestsOfSpheresAsTheBatchesMakeThem) {
    Random random(4);
    const Vec3 eye(-7, 0.5, 1000);
    std::vector<Sphere> spheres;
    for (size_t i = 0; i < kObjects; ++i) spheres.push_back({eye + place(random, i), random.unit()});
    spheres[120].radius = std::numeric_limits<double>::quiet_NaN();
    expectOwnOrder<SphereBatch>(spheres, frustumAhead(), eye);
}

}  // namespace
}  // namespace cullscope::frustum_batch_order_test
