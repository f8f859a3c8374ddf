#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/frustum_batch.h"
#include "core/scene/camera.h"

namespace cullscope::benchmark {

/// The view of all measurements: a vertical field of view of 60°, looking down −z from a point beside the origin.
[[nodiscard]] View frustumView();

/// Small boxes in random order of which exactly `share` intersect the frustum: those are distributed over it, the others over the
/// rest of a cube around the eye.
[[nodiscard]] std::vector<Box3> scatteredBoxes(const View& view, size_t count, double share);
/// The same for spheres.
[[nodiscard]] std::vector<Sphere> scatteredSpheres(const View& view, size_t count, double share);
/// Boxes distributed over a cube around the eye that grows with their number: about kConstantVisible of them intersect the
/// frustum.
[[nodiscard]] std::vector<Box3> evenBoxes(const View& view, size_t count);
inline constexpr double kConstantVisible = 500;

/// Objects in the usual layout (an array of structures), with the six planes in world coordinates.
struct NaiveBox {
    Vec3 centre, halfExtent;
};
struct NaiveSphere {
    Vec3 centre;
    double radius;
};
struct NaivePlane {
    Vec3 normal, absNormal;
    double offset;
};
using NaivePlanes = std::array<NaivePlane, 6>;
[[nodiscard]] NaivePlanes naivePlanes(const View& view);
[[nodiscard]] std::vector<NaiveBox> naiveObjects(const std::vector<Box3>& boxes);
[[nodiscard]] std::vector<NaiveSphere> naiveObjects(const std::vector<Sphere>& spheres);

/// The usual loop: object by object and plane by plane until one plane rejects. Without a margin. 1: outside.
void testNaively(const std::vector<NaiveBox>& boxes, const NaivePlanes& planes, std::vector<uint8_t>& outside);
void testNaively(const std::vector<NaiveSphere>& spheres, const NaivePlanes& planes, std::vector<uint8_t>& outside);

/// The sum of a batch's arrays, with the widest vectors that the processor has: the cost of reading alone.
[[nodiscard]] double sumOf(const double* blocks, size_t doubles);

}  // namespace cullscope::benchmark
