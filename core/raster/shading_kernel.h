#pragma once

#include "core/raster/screen_triangle.h"
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

inline ThreeDoubles cross(const ThreeDoubles& a, const ThreeDoubles& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline Doubles largerOf(const Doubles& a, const Doubles& b) { return a < b ? b : a; }
inline Doubles largestOf(const ThreeDoubles& of) {
    const auto absolute = [](const Doubles& value) -> Doubles { return value < 0.0 ? -value : value; };
    return largerOf(largerOf(absolute(of.x), absolute(of.y)), absolute(of.z));
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

/// The columns of a matrix times a vector, in the order in which glm adds.
inline ThreeDoubles times(const ThreeDoubles (&columns)[3], const ThreeDoubles& by) {
    return {columns[0].x * by.x + columns[1].x * by.y + columns[2].x * by.z,
            columns[0].y * by.x + columns[1].y * by.y + columns[2].y * by.z,
            columns[0].z * by.x + columns[1].z * by.y + columns[2].z * by.z};
}
inline ThreeDoubles fourOf(const double (&values)[3]) {
    return {Doubles{} + values[0], Doubles{} + values[1], Doubles{} + values[2]};
}

/// Numbers of four triangles to those of each.
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
/// Vectors in memory, three floats each, one of each triangle.
inline ThreeDoubles gathered(const float* const (&from)[4]) {
    HalfFloats vectors[4], components[4];
    for (int i = 0; i < 4; ++i) {
        vectors[i] = HalfFloats{from[i][0], from[i][1], from[i][2], 0.0f};
    }
    transpose(vectors, components);
    return {__builtin_convertvector(components[0], Doubles), __builtin_convertvector(components[1], Doubles),
            __builtin_convertvector(components[2], Doubles)};
}

/// The normals of a triangle: interpolated over it they are a matrix times a pixel's direction, of any length.
struct Normals {
    Doubles columns[3];  ///< the fourth numbers are 0
    HalfFloats step;     ///< to the next pixel of a row
};

/// Of the triangles that a block shows, four at a time.
inline void setUpNormals(const Shading& shading, const uint32_t* items, Normals* normalsOf) {
    // In the mesh's axes the weights of the corners' normals at the point in a direction are the products of the direction with
    // b × c, c × a and a × b, up to a common factor.
    const ShadedInstance* instance[4];
    for (int i = 0; i < 4; ++i) instance[i] = &instanceOf(shading, items[i] - 1);
    const bool one = instance[0] == instance[1] && instance[0] == instance[2] && instance[0] == instance[3];
    const auto ofFour = [&](const double* a, const double* b, const double* c, const double* d) -> ThreeDoubles {
        if (one) return {Doubles{} + a[0], Doubles{} + a[1], Doubles{} + a[2]};
        return {Doubles{a[0], b[0], c[0], d[0]}, Doubles{a[1], b[1], c[1], d[1]}, Doubles{a[2], b[2], c[2], d[2]}};
    };
    const ThreeDoubles eye = ofFour(instance[0]->eye, instance[1]->eye, instance[2]->eye, instance[3]->eye);
    ThreeDoubles corner[3], normal[3], normals[3];
    for (size_t c = 0; c < 3; ++c) {
        const float *position[4], *direction[4];
        for (int i = 0; i < 4; ++i) {
            const size_t vertex = instance[i]->indices[3 * size_t(items[i] - 1 - instance[i]->firstTriangle) + c];
            position[i] = instance[i]->positions + 3 * vertex;
            direction[i] = instance[i]->normal + 3 * vertex;
        }
        corner[c] = gathered(position);
        corner[c] = {corner[c].x - eye.x, corner[c].y - eye.y, corner[c].z - eye.z};
        normal[c] = gathered(direction);
        normals[c] = ofFour(instance[0]->normals + 3 * c, instance[1]->normals + 3 * c, instance[2]->normals + 3 * c,
                            instance[3]->normals + 3 * c);
    }
    if (shading.parallel) {
        // Lines of sight that run forward meet what is moved along them at the same pixels: at distance 1 from the eye, the
        // corners are seen from it as they are here, and the weights follow as in perspective.
        const ThreeDoubles forward =
            ofFour(instance[0]->forward, instance[1]->forward, instance[2]->forward, instance[3]->forward);
        const ThreeDoubles ahead = ofFour(instance[0]->ahead, instance[1]->ahead, instance[2]->ahead, instance[3]->ahead);
        for (ThreeDoubles& of : corner) {
            const Doubles by = of.x * ahead.x + of.y * ahead.y + of.z * ahead.z - 1.0;
            of = {of.x - by * forward.x, of.y - by * forward.y, of.z - by * forward.z};
        }
    }
    for (ThreeDoubles& of : normal) of = times(normals, of);
    ThreeDoubles inMesh[3] = {}, matrix[3];
    for (size_t c = 0; c < 3; ++c) {
        const ThreeDoubles weight = cross(corner[(c + 1) % 3], corner[(c + 2) % 3]);
        const Doubles* byColumn[3] = {&weight.x, &weight.y, &weight.z};
        for (int column = 0; column < 3; ++column) {
            inMesh[column].x += normal[c].x * *byColumn[column];
            inMesh[column].y += normal[c].y * *byColumn[column];
            inMesh[column].z += normal[c].z * *byColumn[column];
        }
    }
    Doubles largest{};
    for (size_t c = 0; c < 3; ++c) {
        matrix[c] = times(inMesh, ofFour(instance[0]->fromWorld + 3 * c, instance[1]->fromWorld + 3 * c,
                                         instance[2]->fromWorld + 3 * c, instance[3]->fromWorld + 3 * c));
        largest = largerOf(largest, largestOf(matrix[c]));
    }
    // Its length does not matter; scaled, its square stays within the range of numbers.
    const Doubles scale = 1.0 / (((largest > 0.0) & (largest < __builtin_inf())) ? largest : Doubles{} + 1.0);
    for (ThreeDoubles& of : matrix) of = {of.x * scale, of.y * scale, of.z * scale};
    const ThreeDoubles step =
        times(matrix, {Doubles{} + shading.step[0], Doubles{} + shading.step[1], Doubles{} + shading.step[2]});
    for (int i = 0; i < 4; ++i) {
        for (int column = 0; column < 3; ++column)
            normalsOf[i].columns[column] = Doubles{matrix[column].x[i], matrix[column].y[i], matrix[column].z[i], 0.0};
        normalsOf[i].step = HalfFloats{float(step.x[i]), float(step.y[i]), float(step.z[i]), 0.0f};
    }
}

/// The triangles that a block shows, each once, in the order in which they were found.
class ShownTriangles {
public:
    /// The place of an item that is not the background, from 1.
    uint32_t placeOf(uint32_t item) {
        uint32_t slot = (item * 2654435769u) >> (32 - kBits);
        while (m_table[slot] != 0 && m_items[m_table[slot]] != item) slot = (slot + 1) & (kSlots - 1);
        if (m_table[slot] == 0) {
            m_table[slot] = uint16_t(++m_count);
            m_items[m_count] = item;
        }
        return m_table[slot];
    }
    [[nodiscard]] uint32_t count() const { return m_count; }
    /// By place. Behind the last one there is room for three more.
    [[nodiscard]] uint32_t* items() { return m_items; }

private:
    static constexpr uint32_t kBits = 11, kSlots = 1u << kBits;  ///< twice as many as pixels
    static_assert(kSlots == 2 * kShadedColumns * kShadedRows);
    uint16_t m_table[kSlots] = {};
    uint32_t m_items[1 + kShadedColumns * kShadedRows + 3];
    uint32_t m_count = 0;
};

/// Asks for the vertices of the triangles that a block shows before any of them is needed: they lie apart in memory, and a
/// processor that waits for one after the other spends most of its time so.
inline void fetchAhead(const Shading& shading, ShownTriangles& shown) {
    const uint32_t* indices[1 + kShadedColumns * kShadedRows];
    for (uint32_t i = 1; i <= shown.count(); ++i) {
        const uint32_t triangle = shown.items()[i] - 1;
        const ShadedInstance& instance = instanceOf(shading, triangle);
        indices[i] = instance.indices + 3 * size_t(triangle - instance.firstTriangle);
        __builtin_prefetch(indices[i]);
    }
    for (uint32_t i = 1; i <= shown.count(); ++i) {
        const ShadedInstance& instance = instanceOf(shading, shown.items()[i] - 1);
        for (size_t corner = 0; corner < 3; ++corner) {
            const size_t first = 3 * size_t(indices[i][corner]);
            __builtin_prefetch(instance.positions + first);
            __builtin_prefetch(instance.normal + first);
        }
    }
}

/// The colours of eight pixels by their directions and normals.
template <typename Lanes>
inline void shadeEight(const Shading& shading, const Floats (&direction)[3], const Floats (&normal)[3], Numbers& rgba) {
    const auto& [dx, dy, dz] = direction;
    const auto& [nx, ny, nz] = normal;
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

/// Vectors of eight pixels, one after the other in each half, to their components.
inline void componentsOf(const Floats (&rows)[4], Floats (&components)[3]) {
    const Floats xyOfEven = __builtin_shufflevector(rows[0], rows[2], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats xyOfOdd = __builtin_shufflevector(rows[1], rows[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats zOfEven = __builtin_shufflevector(rows[0], rows[2], 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats zOfOdd = __builtin_shufflevector(rows[1], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
    components[0] = __builtin_shufflevector(xyOfEven, xyOfOdd, 0, 8, 1, 9, 4, 12, 5, 13);
    components[1] = __builtin_shufflevector(xyOfEven, xyOfOdd, 2, 10, 3, 11, 6, 14, 7, 15);
    components[2] = __builtin_shufflevector(zOfEven, zOfOdd, 0, 8, 1, 9, 4, 12, 5, 13);
}

/// Bits of the pixels at which another item begins than before; the first pixel of a row begins one.
template <typename Lanes>
inline uint64_t beginsIn(const uint32_t* items, int32_t count, uint32_t& any) {
    uint64_t begins = 1;
    any |= items[0];
    int32_t found = 1;
    for (; found + kLanes <= count; found += kLanes) {
        Numbers here, left;
        load(here, items + found);
        load(left, items + found - 1);
        begins |= uint64_t(Lanes::bitsOf(here != left)) << found;
    }
    for (; found < count; ++found) begins |= uint64_t(items[found] != items[found - 1] ? 1 : 0) << found;
    for (uint64_t left = begins; left != 0; left &= left - 1) any |= items[__builtin_ctzll(left)];
    return begins;
}

/// The normals at the first pixels of a row's runs, and where these are.
struct ShadedRow {
    HalfFloats start[kShadedColumns + 1], step[kShadedColumns + 1];
    float begin[kShadedColumns + 1];
};

template <typename Lanes>
void shadeBlock(const Shading& shading, const ShadedBlock& block) {
    ShownTriangles shown;
    uint64_t begins[kShadedRows];
    uint16_t placeOfRun[kShadedRows][kShadedColumns];
    uint32_t any = 0;
    for (int32_t row = 0; row < block.rows; ++row) {
        const uint32_t* items = block.items + size_t(row) * block.itemsInRow;
        begins[row] = beginsIn<Lanes>(items, block.columns, any);
        int32_t run = 0;
        for (uint64_t left = begins[row]; left != 0; left &= left - 1) {
            const uint32_t item = items[__builtin_ctzll(left)];
            placeOfRun[row][run++] = uint16_t(item == 0 ? 0 : shown.placeOf(item));
        }
    }
    if (any == 0) {
        for (int32_t row = 0; row < block.rows; ++row)
            for (int32_t i = 0; i < block.columns; ++i)
                block.rgba[size_t(row) * block.rgbaInRow + size_t(i)] = shading.background;
        return;
    }
    // The background has a normal of no length, and is coloured afterwards.
    Normals normals[1 + kShadedColumns * kShadedRows + 3];
    normals[0] = Normals{};
    for (uint32_t i = 0; i < 3; ++i) shown.items()[shown.count() + 1 + i] = shown.items()[1];
    fetchAhead(shading, shown);
    for (uint32_t i = 1; i <= shown.count(); i += 4) setUpNormals(shading, shown.items() + i, normals + i);

    const auto along = [&shading](int axis, double across, double upward) {
        return (shading.forward[axis] + shading.right[axis] * across) + shading.up[axis] * upward;
    };
    for (int32_t row = 0; row < block.rows; ++row) {
        const double upward = (2.0 * (block.row + row + 0.5) / shading.height - 1.0) * shading.halfHeight;
        const auto acrossAt = [&](int32_t column) {
            return (2.0 * (block.column + column + 0.5) / shading.width - 1.0) * shading.halfWidth;
        };
        ShadedRow of;
        int32_t count = 0;
        for (uint64_t left = begins[row]; left != 0; left &= left - 1, ++count) {
            const int32_t begin = __builtin_ctzll(left);
            const Normals& at = normals[placeOfRun[row][count]];
            const double across = acrossAt(begin);
            const Doubles start = (at.columns[0] * along(0, across, upward) + at.columns[1] * along(1, across, upward)) +
                                  at.columns[2] * along(2, across, upward);
            of.start[count + 1] = __builtin_convertvector(start, HalfFloats);
            of.step[count + 1] = at.step;
            of.begin[count + 1] = float(begin);
        }
        float first[3];
        for (int axis = 0; axis < 3; ++axis)
            first[axis] = float(shading.parallel ? shading.forward[axis] : along(axis, acrossAt(0), upward));
        const uint32_t* items = block.items + size_t(row) * block.itemsInRow;
        uint32_t* rgba = block.rgba + size_t(row) * block.rgbaInRow;
        int32_t run = 0;
        for (int32_t from = 0; from < block.columns; from += 8) {
            Numbers item{};
            if (from + 8 <= block.columns) {
                load(item, items + from);
                if (Lanes::bitsOf(item != 0u) == 0) {
                    store<Numbers>(rgba + from, Numbers{} + shading.background);
                    run += __builtin_popcount(uint32_t(begins[row] >> from & 0xff));
                    continue;
                }
            }
            int32_t runs[8];
            for (int32_t i = 0; i < 8; ++i) runs[i] = run += int32_t(begins[row] >> (from + i) & 1);
            Floats rows[4], normal[3], direction[3];
            for (int32_t i = 0; i < 4; ++i) {
                const int32_t a = runs[i], b = runs[i + 4];
                const Floats start = __builtin_shufflevector(of.start[a], of.start[b], 0, 1, 2, 3, 4, 5, 6, 7);
                const Floats step = __builtin_shufflevector(of.step[a], of.step[b], 0, 1, 2, 3, 4, 5, 6, 7);
                const float ofA = float(from + i) - of.begin[a], ofB = float(from + i + 4) - of.begin[b];
                rows[i] = start + Floats{ofA, ofA, ofA, ofA, ofB, ofB, ofB, ofB} * step;
            }
            componentsOf(rows, normal);
            const Floats columns = Floats{0, 1, 2, 3, 4, 5, 6, 7} + float(from);
            for (int axis = 0; axis < 3; ++axis)
                direction[axis] = first[axis] + columns * float(shading.parallel ? 0.0 : shading.step[axis]);
            Numbers colours;
            shadeEight<Lanes>(shading, direction, normal, colours);
            if (from + 8 <= block.columns) {
                store<Numbers>(rgba + from, item == 0u ? Numbers{} + shading.background : colours);
            } else {
                for (int32_t i = 0; from + i < block.columns; ++i)
                    rgba[from + i] = items[from + i] == 0 ? shading.background : colours[i];
            }
        }
    }
}

template <typename Lanes>
void markShownItems(const uint32_t* items, size_t count, uint8_t* fates) {
    constexpr size_t kAtOnce = 64;
    for (size_t from = 0; from < count; from += kAtOnce) {
        uint32_t any = 0;
        const uint32_t* const of = items + from;
        for (uint64_t left = beginsIn<Lanes>(of, int32_t(count - from < kAtOnce ? count - from : kAtOnce), any); left != 0;
             left &= left - 1) {
            const uint32_t item = of[__builtin_ctzll(left)];
            // Another processor may mark the same triangle. No std::atomic_ref, whose functions are inline.
            if (item != 0) __atomic_store_n(fates + (item - 1), uint8_t(kShown), __ATOMIC_RELAXED);
        }
    }
}

}  // namespace
}  // namespace cullscope
