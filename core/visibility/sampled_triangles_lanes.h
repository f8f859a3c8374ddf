#pragma once

#include <cstring>

#include "core/visibility/sampled_triangles_kernel.h"

namespace cullscope {

/// The test of several triangles at a time, compiled for each instruction set by the file that includes it. `Lanes`: how many
/// (kWide), and as many floats and whole numbers (Floats, Ints), vectors of the compiler.
template <typename Lanes>
struct SampleLanes {
    using Floats = typename Lanes::Floats;
    using Ints = typename Lanes::Ints;

    struct Corner {
        Floats x, y, w;
    };

    [[gnu::always_inline]] static Floats least(Floats a, Floats b) { return a < b ? a : b; }
    [[gnu::always_inline]] static Floats most(Floats a, Floats b) { return a > b ? a : b; }
    [[gnu::always_inline]] static Floats all(float value) { return Floats{} + value; }
    [[gnu::always_inline]] static Floats load(const float* from) {
        Floats values;
        std::memcpy(&values, from, sizeof values);
        return values;
    }
    [[gnu::always_inline]] static Floats along(const std::array<float, 4>& row, Floats x, Floats y, Floats z) {
        return row[0] * x + row[1] * y + row[2] * z + row[3];
    }
    [[gnu::always_inline]] static Corner project(const SampleTest& test, const CornerBlock& block, size_t corner, size_t first) {
        const Floats x = load(&block.rows[3 * corner][first]), y = load(&block.rows[3 * corner + 1][first]),
                     z = load(&block.rows[3 * corner + 2][first]);
        const Floats w = along(test.w, x, y, z), byW = 1.0f / w;
        return {along(test.x, x, y, z) * byW, along(test.y, x, y, z) * byW, w};
    }
    /// The whole number below a number that is at least 0.
    [[gnu::always_inline]] static Floats whole(Floats value) {
        return __builtin_convertvector(__builtin_convertvector(value, Ints), Floats);
    }

    /// Appends the verdict on the triangles of a block from the one numbered `first` on. A comparison with NaN is false, and a
    /// triangle with NaN is not known.
    [[gnu::always_inline]] static void test(const CornerBlock& block, const SampleTest& test, size_t first,
                                            BlockVerdict& verdict) {
        const Corner a = project(test, block, 0, first), b = project(test, block, 1, first), c = project(test, block, 2, first);
        const Floats nearest = least(least(a.w, b.w), c.w), farthest = most(most(a.w, b.w), c.w);
        const Floats room = test.room + test.roomTimesW / nearest;
        const Floats left = least(least(a.x, b.x), c.x) - room, right = most(most(a.x, b.x), c.x) + room;
        const Floats bottom = least(least(a.y, b.y), c.y) - room, top = most(most(a.y, b.y), c.y) + room;
        const float width = test.width, height = test.height;
        // Within the picture's size on each side of it, a triangle lies where its rounded corners say.
        const Ints known = (nearest >= test.leastW) & (farthest <= test.mostW) & (left >= -width) & (right <= 2.0f * width) &
                           (bottom >= -height) & (top <= 2.0f * height);
        const Ints inPicture = (left >= 0.0f) & (right <= width) & (bottom >= 0.0f) & (top <= height);
        // Pixel centres lie at k + ½ for k from 0 to size − 1: from the first number to the whole one below the last.
        const Floats fromX = most(left, all(0.5f)) - 0.5f, upToX = least(right, all(width - 0.5f)) - 0.5f;
        const Floats fromY = most(bottom, all(0.5f)) - 0.5f, upToY = least(top, all(height - 0.5f)) - 0.5f;
        const Floats lastX = whole(upToX), lastY = whole(upToY);
        const Ints holds = (upToX >= 0.0f) & (lastX >= fromX) & (upToY >= 0.0f) & (lastY >= fromY);
        // Twice the signed area, positive where the corners turn counter-clockwise, and twice those of the triangles that the
        // last centre forms with each edge. A corner that is off by `room` along each axis changes such a number by `room` times
        // the lengths along the axes of the edge across; those of all edges are twice the rectangle's sides.
        const Floats ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
        const Floats area = ux * vy - uy * vx;
        const Floats doubt = 2.0f * room * ((right - left) + (top - bottom) + room);
        const Ints away = inPicture & (test.front * area < -doubt);
        const Floats px = lastX + 0.5f - a.x, py = lastY + 0.5f - a.y;
        const Ints turned = area < 0.0f;
        const Floats size = turned ? -area : area;
        const Floats first1 = ux * py - uy * px, third1 = px * vy - py * vx;
        const Floats ofFirst = turned ? -first1 : first1, ofThird = turned ? -third1 : third1;
        const Floats ofSecond = size - ofFirst - ofThird;
        // Where its rectangle holds one centre alone, the triangle may lie beside it.
        const Ints beside = inPicture & (lastX - 1.0f < fromX) & (lastY - 1.0f < fromY) & (size > doubt) &
                            (least(least(ofFirst, ofSecond), ofThird) < -doubt);
        const Ints facesAway = known & away, holdsNoCentre = known & ~away & (~holds | beside);
        for (size_t i = 0; i < Lanes::kWide; ++i) {
            verdict.facesAway = uint16_t(verdict.facesAway | uint32_t(facesAway[i] & 1) << (first + i));
            verdict.holdsNoCentre = uint16_t(verdict.holdsNoCentre | uint32_t(holdsNoCentre[i] & 1) << (first + i));
        }
    }
};

template <typename Lanes>
void testSamples(std::span<const CornerBlock> blocks, const SampleTest& test, BlockVerdict* verdicts) {
    for (const CornerBlock& block : blocks) {
        BlockVerdict verdict;
        for (size_t first = 0; first < kCornerBlock; first += Lanes::kWide) SampleLanes<Lanes>::test(block, test, first, verdict);
        *verdicts++ = verdict;
    }
}

}  // namespace cullscope
