#pragma once

#include <cstddef>
#include <cstdint>

// Between frustum_batch.cpp and the kernels, which are compiled for other processors than the rest of the library. No inline
// function may stand here or be included: the linker keeps one copy of it, perhaps the one that not every processor runs.

namespace cullscope {

/// Objects lie in blocks of this many: of a block, first the first coordinates of all its objects, then the second ones, ….
inline constexpr size_t kBatchBlock = 8;
/// Rows of a block of boxes: min x, y, z, max x, y, z; of spheres: centre x, y, z, radius.
inline constexpr size_t kBoxRows = 6;
inline constexpr size_t kSphereRows = 4;

/// A plane { p : normal·p + offset = 0 } in world coordinates with its normal inward, and where in a block of boxes the
/// coordinates of the corner farthest inside (the p-vertex) and farthest outside (the n-vertex) lie.
struct BatchPlane {
    double normal[3];
    double offset;
    size_t inner[3];
    size_t outer[3];
};

/// What the kernels are told of a frustum. An object's margin is marginOfMagnitude · m + marginOfEye; m is the sum of the norm-1
/// distance of its centre from the eye and of its reach.
struct BatchPlanes {
    BatchPlane planes[6];
    double eye[3];
    double marginOfMagnitude;
    double marginOfEye;
};

/// Writes one bit an object, 64 a word, for whole blocks; bits beyond them are 0.
using BatchKernel = void(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside);

BatchKernel testBoxesScalar, testBoxesAvx2, testBoxesAvx512;
BatchKernel testSpheresScalar, testSpheresAvx2, testSpheresAvx512;

/// One object, the first of its block, as the scalar kernels test it.
struct BatchDistances {
    double farthestInside;
    double farthestOutside;
    double margin;
};
BatchDistances boxDistances(const double* block, const BatchPlanes& frustum, size_t plane);
BatchDistances sphereDistances(const double* block, const BatchPlanes& frustum, size_t plane);

}  // namespace cullscope
