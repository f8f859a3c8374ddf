#pragma once

#include <cstddef>
#include <cstdint>

// The interface between frustum_batch.cpp and the kernels, which are compiled for other instruction sets than the rest of the
// library. No inline function may be defined or included here: the linker keeps one copy, possibly one that not every processor
// can run.

namespace cullscope {

/// Objects are stored in blocks of this many. A block holds the first coordinate of all its objects, then the second of all, and
/// so on.
inline constexpr size_t kBatchBlock = 8;
/// Rows of a block of boxes: min x, y, z, max x, y, z; of spheres: centre x, y, z, radius.
inline constexpr size_t kBoxRows = 6;
inline constexpr size_t kSphereRows = 4;

/// A plane { p : normal·p + offset = 0 } in world coordinates with its normal inward, and the places in a block of boxes of the
/// coordinates of the corner farthest inside (p-vertex) and farthest outside (n-vertex).
struct BatchPlane {
    double normal[3];
    double offset;
    size_t inner[3];
    size_t outer[3];
};

/// A frustum as the kernels need it. An object's margin is marginOfMagnitude · m + marginOfEye; m is the 1-norm distance of its
/// centre from the eye plus its reach.
struct BatchPlanes {
    BatchPlane planes[6];
    double eye[3];
    double marginOfMagnitude;
    double marginOfEye;
};

/// Tests of objects that follow each other against one plane, which a kernel made together.
struct BatchTests {
    size_t object;  ///< the first one, counted from the first of the blocks
    size_t plane;
    size_t count;
    const double *inside, *margin;  ///< `count` each: farthestInside and margin of BatchDistances
};

/// Is told of the tests in the order in which a kernel makes them.
struct BatchListener {
    void (*tell)(void* to, const BatchTests& tests);
    void* to;
};

/// Writes one bit an object, 64 a word, for whole blocks; bits beyond them are 0. `listener`: null where nothing is to be told;
/// then code without it runs. The results are the same.
using BatchKernel = void(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                         const BatchListener* listener);

BatchKernel testBoxesScalar, testBoxesAvx2, testBoxesAvx512;
BatchKernel testSpheresScalar, testSpheresAvx2, testSpheresAvx512;

/// The result of the scalar kernels for one object, the first of its block.
struct BatchDistances {
    double farthestInside;
    double farthestOutside;
    double margin;
};
BatchDistances boxDistances(const double* block, const BatchPlanes& frustum, size_t plane);
BatchDistances sphereDistances(const double* block, const BatchPlanes& frustum, size_t plane);

}  // namespace cullscope
