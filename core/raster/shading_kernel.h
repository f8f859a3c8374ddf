#pragma once

#include "core/raster/shaded_rows.h"
#include "core/raster/vectors.h"

// Shades the pixels of a picture, as lambert.frag does: a headlight at the eye,
// normals interpolated over the triangle. Compiled once for every instruction
// set, as the depth buffer's kernels; all do the same operations in the same
// order.

namespace cullscope {
namespace {

struct ThreeDoubles {
    Doubles x, y, z;
};

/// Where a piece of a row that shows one triangle begins.
struct Run {
    uint32_t item;
    int32_t begin;
};

inline ThreeDoubles cross(const ThreeDoubles& a, const ThreeDoubles& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline Doubles largerOf(const Doubles& a, const Doubles& b) { return a < b ? b : a; }
inline Doubles largestOf(const ThreeDoubles& of) {
    const auto absolute = [](const Doubles& value) -> Doubles { return value < 0.0 ? -value : value; };
    return largerOf(largerOf(absolute(of.x), absolute(of.y)), absolute(of.z));
}
inline Doubles dot(const ThreeDoubles& a, const ThreeDoubles& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// A direction by its shares of a basis.
inline ThreeDoubles toward(const ThreeDoubles& forward, const ThreeDoubles& right, const ThreeDoubles& up, const Doubles& across,
                           const Doubles& upward) {
    return {(forward.x + right.x * across) + up.x * upward, (forward.y + right.y * across) + up.y * upward,
            (forward.z + right.z * across) + up.z * upward};
}

inline const ShadedInstance& instanceOf(const Shading& shading, uint32_t triangle) {
    size_t low = 0, high = shading.instanceCount;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        if (shading.instances[middle].firstTriangle <= triangle)
            low = middle;
        else
            high = middle;
    }
    return shading.instances[low];
}

/// Of four runs in turn: the direction to their first pixel, the normal there,
/// and its change to the next pixel; a normal has any length. Eight numbers
/// each, of which the fourth and the eighth are 0.
struct FourRuns {
    Floats start[4], step[4];
};

/// The columns of a matrix times a vector, in the order in which glm adds.
inline ThreeDoubles times(const ThreeDoubles (&columns)[3], const ThreeDoubles& by) {
    return {columns[0].x * by.x + columns[1].x * by.y + columns[2].x * by.z,
            columns[0].y * by.x + columns[1].y * by.y + columns[2].y * by.z,
            columns[0].z * by.x + columns[1].z * by.y + columns[2].z * by.z};
}
inline ThreeDoubles fourOf(const double (&values)[3]) {
    return {Doubles{} + values[0], Doubles{} + values[1], Doubles{} + values[2]};
}

/// Numbers of four runs to those of each.
inline void transpose(const HalfFloats (&rows)[4], HalfFloats (&columns)[4]) {
    const HalfFloats a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
                     b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
    const HalfFloats c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
                     d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    columns[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
    columns[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    columns[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
    columns[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}
inline void transpose(const ThreeDoubles& of, HalfFloats (&columns)[4]) {
    const HalfFloats rows[4] = {__builtin_convertvector(of.x, HalfFloats), __builtin_convertvector(of.y, HalfFloats),
                                __builtin_convertvector(of.z, HalfFloats), HalfFloats{}};
    transpose(rows, columns);
}

/// Vectors in memory, three floats each, one of each run.
inline ThreeDoubles gathered(const float* const (&from)[4]) {
    HalfFloats vectors[4], components[4];
    for (int i = 0; i < 4; ++i) {
        vectors[i] = HalfFloats{from[i][0], from[i][1], from[i][2], 0.0f};
    }
    transpose(vectors, components);
    return {__builtin_convertvector(components[0], Doubles), __builtin_convertvector(components[1], Doubles),
            __builtin_convertvector(components[2], Doubles)};
}

inline void setUpRuns(const Shading& shading, const Run* runs, int32_t first, const Doubles& upward, FourRuns& four) {
    // In the mesh's axes the weights of the corners' normals at the point in a direction are the products of the direction with
    // b × c, c × a and a × b, up to a common factor, so that the normal is a matrix times the direction.
    const ShadedInstance* instance[4];
    for (int i = 0; i < 4; ++i) instance[i] = &instanceOf(shading, runs[i].item - 1);
    const bool one = instance[0] == instance[1] && instance[0] == instance[2] && instance[0] == instance[3];
    using Axes = double[3];
    const auto fromInstances = [&](const Axes& (*axesOf)(const ShadedInstance&)) -> ThreeDoubles {
        if (one) return fourOf(axesOf(*instance[0]));
        const Axes &a = axesOf(*instance[0]), &b = axesOf(*instance[1]), &c = axesOf(*instance[2]), &d = axesOf(*instance[3]);
        return {Doubles{a[0], b[0], c[0], d[0]}, Doubles{a[1], b[1], c[1], d[1]}, Doubles{a[2], b[2], c[2], d[2]}};
    };
    const ThreeDoubles eye = fromInstances([](const ShadedInstance& of) -> const Axes& { return of.eye; });
    ThreeDoubles corner[3], normal[3];
    for (size_t c = 0; c < 3; ++c) {
        const float *position[4], *direction[4];
        for (int i = 0; i < 4; ++i) {
            const size_t vertex = instance[i]->indices[3 * size_t(runs[i].item - 1 - instance[i]->firstTriangle) + c];
            position[i] = instance[i]->positions + 3 * vertex;
            direction[i] = instance[i]->normal + 3 * vertex;
        }
        corner[c] = gathered(position);
        corner[c] = {corner[c].x - eye.x, corner[c].y - eye.y, corner[c].z - eye.z};
        normal[c] = gathered(direction);
    }
    Doubles across{double(first + runs[0].begin), double(first + runs[1].begin), double(first + runs[2].begin),
                   double(first + runs[3].begin)};
    across = (2.0 * (across + 0.5) / shading.width - 1.0) * shading.tanHalfWidth;
    const ThreeDoubles forward = fromInstances([](const ShadedInstance& of) -> const Axes& { return of.forward; });
    const ThreeDoubles right = fromInstances([](const ShadedInstance& of) -> const Axes& { return of.right; });
    const ThreeDoubles up = fromInstances([](const ShadedInstance& of) -> const Axes& { return of.up; });
    const ThreeDoubles inMesh = toward(forward, right, up, across, upward);
    const ThreeDoubles stepInMesh = fromInstances([](const ShadedInstance& of) -> const Axes& { return of.step; });
    ThreeDoubles start{}, step{};
    for (size_t c = 0; c < 3; ++c) {
        const ThreeDoubles weight = cross(corner[(c + 1) % 3], corner[(c + 2) % 3]);
        const Doubles atStart = dot(weight, inMesh), change = dot(weight, stepInMesh);
        start = {start.x + normal[c].x * atStart, start.y + normal[c].y * atStart, start.z + normal[c].z * atStart};
        step = {step.x + normal[c].x * change, step.y + normal[c].y * change, step.z + normal[c].z * change};
    }
    ThreeDoubles normals[3];
    for (int column = 0; column < 3; ++column) {
        const auto valueOf = [&](int row) -> Doubles {
            const int at = 3 * column + row;
            if (one) return Doubles{} + instance[0]->normals[at];
            return Doubles{instance[0]->normals[at], instance[1]->normals[at], instance[2]->normals[at],
                           instance[3]->normals[at]};
        };
        normals[column] = {valueOf(0), valueOf(1), valueOf(2)};
    }
    start = times(normals, start);
    step = times(normals, step);
    // Its length does not matter; scaled, its square stays within the range of numbers.
    const Doubles largest = largerOf(largestOf(start), largestOf(step));
    const Doubles scale = 1.0 / (((largest > 0.0) & (largest < __builtin_inf())) ? largest : Doubles{} + 1.0);
    start = {start.x * scale, start.y * scale, start.z * scale};
    step = {step.x * scale, step.y * scale, step.z * scale};

    const ThreeDoubles direction = toward(fourOf(shading.forward), fourOf(shading.right), fourOf(shading.up), across, upward);
    HalfFloats directions[4], starts[4], steps[4];
    transpose(direction, directions);
    transpose(start, starts);
    transpose(step, steps);
    const HalfFloats along{float(shading.step[0]), float(shading.step[1]), float(shading.step[2]), 0.0f};
    for (int i = 0; i < 4; ++i) {
        four.start[i] = __builtin_shufflevector(directions[i], starts[i], 0, 1, 2, 3, 4, 5, 6, 7);
        four.step[i] = __builtin_shufflevector(along, steps[i], 0, 1, 2, 3, 4, 5, 6, 7);
    }
}

/// a0 a1 … of eight pixels to their first numbers, their second ones, and so
/// on.
inline void transpose(const Floats (&rows)[8], Floats (&columns)[8]) {
    Floats pairs[8], fours[8];
    for (int i = 0; i < 8; i += 2) {
        pairs[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        pairs[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (int i = 0; i < 8; i += 4)
        for (int j = 0; j < 2; ++j) {
            fours[i + 2 * j] = __builtin_shufflevector(pairs[i + j], pairs[i + j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            fours[i + 2 * j + 1] = __builtin_shufflevector(pairs[i + j], pairs[i + j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (int i = 0; i < 4; ++i) {
        columns[i] = __builtin_shufflevector(fours[i], fours[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        columns[i + 4] = __builtin_shufflevector(fours[i], fours[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

/// The colours of eight pixels, of which `values` has direction and normal.
template <typename Lanes>
inline void shadeEight(const Shading& shading, const Floats (&values)[8], Numbers& rgba) {
    Floats of[8];
    transpose(values, of);
    const auto& [dx, dy, dz, nothing, nx, ny, nz, nothingEither] = of;
    const Floats squares = (dx * dx + dy * dy + dz * dz) * (nx * nx + ny * ny + nz * nz);
    const Floats product = dx * nx + dy * ny + dz * nz;
    const Floats cosine = squares > 0.0f ? (product < 0.0f ? -product : product) / Lanes::root(squares) : Floats{} + 1.0f;
    const Floats unlimited = 0.12f + 0.88f * cosine;
    const Floats shade = 1.0f < unlimited ? Floats{} + 1.0f : unlimited;
    rgba = Numbers{} + 0xff000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const Floats bright = shading.surface[channel] * shade;
        const Floats value = (255.0f < bright ? Floats{} + 255.0f : bright) + 0.5f;
        rgba |= Numbers(__builtin_convertvector(value, Ints)) << (8 * channel);
    }
}

/// Runs are short and their lengths are chance: where they begin is kept as
/// bits, and nothing branches on them.
template <typename Lanes>
void shadeRow(const Shading& shading, const uint32_t* items, int32_t count, int32_t first, int32_t row, uint32_t* rgba) {
    const Doubles upward = Doubles{} + (2.0 * (row + 0.5) / shading.height - 1.0) * shading.tanHalfHeight;
    constexpr int32_t kTogether = 64;
    // The run that the pixels before belong to is the first one of these.
    Floats start[1 + kTogether + 3], step[1 + kTogether + 3];
    int32_t beginOf[1 + kTogether + 3] = {};
    start[0] = step[0] = Floats{};
    uint32_t before = ~items[0];
    for (int32_t chunk = 0; chunk < count; chunk += kTogether) {
        const int32_t pixels = count - chunk < kTogether ? count - chunk : kTogether;
        uint64_t begins = 0;
        uint32_t any = 0;
        int32_t found = 0;
        if (chunk > 0) {
            Numbers shown{};
            for (; found + kLanes <= pixels; found += kLanes) {
                Numbers here, left;
                load(here, items + chunk + found);
                load(left, items + chunk + found - 1);
                begins |= uint64_t(Lanes::bitsOf(here != left)) << found;
                shown |= here;
            }
            for (int lane = 0; lane < kLanes; ++lane) any |= shown[lane];
            if (found > 0) before = items[chunk + found - 1];
        }
        for (int32_t i = found; i < pixels; ++i) {
            const uint32_t item = items[chunk + i];
            begins |= uint64_t(item != before ? 1 : 0) << i;
            any |= item;
            before = item;
        }
        if (any == 0) {
            for (int32_t i = 0; i < pixels; ++i) rgba[chunk + i] = shading.background;
            continue;
        }
        Run runs[kTogether + 3];
        int32_t runCount = 0;
        for (uint64_t left = begins; left != 0; left &= left - 1) {
            const int32_t begin = chunk + __builtin_ctzll(left);
            // The background is shaded as some triangle, and coloured afterwards.
            runs[runCount] = {items[begin] + (items[begin] == 0 ? 1 : 0), begin};
            beginOf[++runCount] = begin;
        }
        for (int32_t i = runCount; i % 4 != 0; ++i) runs[i] = runs[i - 1];
        for (int32_t i = 0; i < runCount; i += 4) {
            FourRuns four;
            setUpRuns(shading, runs + i, first, upward, four);
            for (int32_t j = 0; j < 4; ++j) {
                start[1 + i + j] = four.start[j];
                step[1 + i + j] = four.step[j];
            }
        }
        int32_t run = 0;
        for (int32_t block = 0; block < pixels; block += 8) {
            Floats values[8];
            for (int32_t i = 0; i < 8; ++i) {
                run += int32_t(begins >> (block + i) & 1);
                values[i] = start[run] + float(chunk + block + i - beginOf[run]) * step[run];
            }
            Numbers colours;
            shadeEight<Lanes>(shading, values, colours);
            uint32_t* to = rgba + chunk + block;
            if (block + 8 <= pixels) {
                Numbers shown;
                load(shown, items + chunk + block);
                store<Numbers>(to, shown == 0u ? Numbers{} + shading.background : colours);
            } else {
                for (int32_t i = 0; i < pixels - block; ++i)
                    to[i] = items[chunk + block + i] == 0 ? shading.background : colours[i];
            }
        }
        start[0] = start[run];
        step[0] = step[run];
        beginOf[0] = beginOf[run];
    }
}

}  // namespace
}  // namespace cullscope
