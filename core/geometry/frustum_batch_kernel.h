#pragma once

#include "core/geometry/frustum_batch_planes.h"

// The arithmetic of all batch tests, compiled once for every instruction set. `Lanes` computes with Lanes::kWidth doubles at a
// time. Every instruction set does the same operations in the same order, so that the results are bit-identical. Each instruction
// set has one source file that includes this, hence the anonymous namespace; frustum_batch_planes.h says what must not be
// included here.

namespace cullscope {
namespace {

/// The rows of a block of boxes. `at` points to the place of the lanes in the first row.
template <typename Lanes>
struct Boxes {
    using Vector = typename Lanes::Vector;
    static constexpr size_t kRows = kBoxRows;

    /// |centre − eye| + half extent along an axis is the larger distance of the box's two sides from the eye.
    static Vector magnitude(const double* at, const BatchPlanes& frustum) {
        return axis(at, frustum, 0) + axis(at, frustum, 1) + axis(at, frustum, 2);
    }
    static Vector distance(const double* at, const BatchPlane& plane) { return corner(at, plane, plane.inner); }
    static Vector withReach(Vector distance, const double* /*at*/) { return distance; }
    static Vector outer(const double* at, const BatchPlane& plane) { return corner(at, plane, plane.outer); }

private:
    static Vector axis(const double* at, const BatchPlanes& frustum, size_t axis) {
        const Vector eye = Lanes::spread(frustum.eye[axis]);
        return Lanes::max(eye - Lanes::load(at + axis * kBatchBlock), Lanes::load(at + (3 + axis) * kBatchBlock) - eye);
    }
    static Vector corner(const double* at, const BatchPlane& plane, const size_t (&rows)[3]) {
        return Lanes::spread(plane.normal[0]) * Lanes::load(at + rows[0]) +
               Lanes::spread(plane.normal[1]) * Lanes::load(at + rows[1]) +
               Lanes::spread(plane.normal[2]) * Lanes::load(at + rows[2]) + Lanes::spread(plane.offset);
    }
};

template <typename Lanes>
struct Spheres {
    using Vector = typename Lanes::Vector;
    static constexpr size_t kRows = kSphereRows;

    static Vector magnitude(const double* at, const BatchPlanes& frustum) {
        return axis(at, frustum, 0) + axis(at, frustum, 1) + axis(at, frustum, 2) + radius(at);
    }
    static Vector distance(const double* at, const BatchPlane& plane) {
        return Lanes::spread(plane.normal[0]) * Lanes::load(at) + Lanes::spread(plane.normal[1]) * Lanes::load(at + kBatchBlock) +
               Lanes::spread(plane.normal[2]) * Lanes::load(at + 2 * kBatchBlock) + Lanes::spread(plane.offset);
    }
    static Vector withReach(Vector distance, const double* at) { return distance + radius(at); }
    static Vector outer(const double* at, const BatchPlane& plane) { return distance(at, plane) - radius(at); }

private:
    static Vector radius(const double* at) { return Lanes::load(at + 3 * kBatchBlock); }
    static Vector axis(const double* at, const BatchPlanes& frustum, size_t axis) {
        return Lanes::abs(Lanes::load(at + axis * kBatchBlock) - Lanes::spread(frustum.eye[axis]));
    }
};

template <typename Lanes, typename Shape>
typename Lanes::Vector marginOf(const double* at, const BatchPlanes& frustum) {
    return Shape::magnitude(at, frustum) * Lanes::spread(frustum.marginOfMagnitude) + Lanes::spread(frustum.marginOfEye);
}

/// Calls body(0) … body(kCount − 1), written out at every level of optimisation, so that arrays indexed by it stay in registers.
template <size_t kCount, typename Body>
[[gnu::always_inline]] inline void repeat(const Body& body) {
    if constexpr (kCount > 0) {
        repeat<kCount - 1>(body);
        body(kCount - 1);
    }
}

/// Tells of no test.
template <typename Lanes>
struct Untold {
    [[gnu::always_inline]] void test(size_t /*object*/, size_t /*plane*/, const double* /*at*/,
                                     typename Lanes::Vector /*distance*/, typename Lanes::Vector /*margin*/) const {}
};

/// Tells a listener of every test where it falls.
template <typename Lanes, typename Shape>
struct Told {
    const BatchListener& listener;

    void test(size_t object, size_t plane, const double* at, typename Lanes::Vector distance,
              typename Lanes::Vector margin) const {
        double inside[Lanes::kWidth], margins[Lanes::kWidth];
        Lanes::store(inside, Shape::withReach(distance, at));
        Lanes::store(margins, margin);
        listener.tell(listener.to, {object, plane, Lanes::kWidth, inside, margins});
    }
};

/// Tests kVectors · kWidth objects that follow each other from the first of a block on; `first`: the number of the first.
template <typename Lanes, typename Shape, size_t kVectors, typename Telling>
[[gnu::always_inline]] inline uint64_t testGroup(const double* block, const BatchPlanes& frustum, size_t first,
                                                 const Telling& telling) {
    using Vector = typename Lanes::Vector;
    constexpr uint64_t kAll = ~uint64_t{0} >> (64 - kVectors * Lanes::kWidth);
    const auto at = [&](size_t vector) __attribute__((always_inline)) {
        const size_t object = vector * Lanes::kWidth;
        return block + object / kBatchBlock * (Shape::kRows * kBatchBlock) + object % kBatchBlock;
    };
    Vector margin[kVectors], least[kVectors];
    repeat<kVectors>([&](size_t v) __attribute__((always_inline)) {
        margin[v] = marginOf<Lanes, Shape>(at(v), frustum);
        least[v] = Lanes::spread(__builtin_huge_val());
    });
    uint64_t bits = 0;
    for (size_t p = 0; p < 6 && bits != kAll; p += Lanes::kPlanesBetweenLooks) {
        repeat<Lanes::kPlanesBetweenLooks>([&](size_t next) __attribute__((always_inline)) {
            const BatchPlane& plane = frustum.planes[p + next];
            repeat<kVectors>([&](size_t v) __attribute__((always_inline)) {
                const Vector distance = Shape::distance(at(v), plane);
                telling.test(first + v * Lanes::kWidth, p + next, at(v), distance, margin[v]);
                // Lanes::min returns its second operand where the first is NaN, so that a NaN distance does not count.
                least[v] = Lanes::min(distance, least[v]);
            });
        });
        bits = 0;
        repeat<kVectors>([&](size_t v) __attribute__((always_inline)) {
            // The least of the sums is the sum of the least, as rounding keeps the order.
            bits |= Lanes::bits(Lanes::less(Shape::withReach(least[v], at(v)), -margin[v])) << (v * Lanes::kWidth);
        });
    }
    return bits;
}

/// A function of its own for each way of telling: what tells must not take registers from what does not.
template <typename Lanes, typename Shape, typename Telling>
[[gnu::noinline]] void testBlocks(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                                  const Telling& telling) {
    constexpr size_t kGroup = Lanes::kVectors * Lanes::kWidth;
    for (size_t first = 0; blockCount > 0; ++outside, first += 64) {
        const size_t wordBlocks = blockCount < 64 / kBatchBlock ? blockCount : 64 / kBatchBlock;
        uint64_t word = 0;
        for (size_t object = 0; object < wordBlocks * kBatchBlock;) {
            const double* at = blocks + object / kBatchBlock * (Shape::kRows * kBatchBlock) + object % kBatchBlock;
            const bool whole = kGroup <= kBatchBlock || wordBlocks * kBatchBlock - object >= kGroup;
            word |= (whole ? testGroup<Lanes, Shape, Lanes::kVectors>(at, frustum, first + object, telling)
                           : testGroup<Lanes, Shape, kBatchBlock / Lanes::kWidth>(at, frustum, first + object, telling))
                    << object;
            object += whole ? kGroup : kBatchBlock;
        }
        *outside = word;
        blocks += wordBlocks * Shape::kRows * kBatchBlock;
        blockCount -= wordBlocks;
    }
}

template <typename Lanes, typename Shape>
void test(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside, const BatchListener* listener) {
    if (listener == nullptr)
        testBlocks<Lanes, Shape>(blocks, blockCount, frustum, outside, Untold<Lanes>{});
    else
        testBlocks<Lanes, Shape>(blocks, blockCount, frustum, outside, Told<Lanes, Shape>{*listener});
}

}  // namespace
}  // namespace cullscope
