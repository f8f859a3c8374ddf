#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/frustum_batch.h"
#include "core/scene/camera.h"

namespace cullscope::benchmark {

/// The view of all measurements: 60° upright, looking down −z from beside the origin.
[[nodiscard]] View frustumView();

/// Small boxes in random order of which exactly `share` reach into the view: those anywhere in its frustum, the others anywhere
/// else in a cube around the eye.
[[nodiscard]] std::vector<Box3> scatteredBoxes(const View& view, size_t count, double share);
/// The same for spheres.
[[nodiscard]] std::vector<Sphere> scatteredSpheres(const View& view, size_t count, double share);
/// Boxes anywhere in a cube around the eye that grows with their number: about kConstantVisible of them reach into the view.
[[nodiscard]] std::vector<Box3> evenBoxes(const View& view, size_t count);
inline constexpr double kConstantVisible = 500;

/// Objects as everyone stores them, with the six planes in world coordinates.
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

/// The loop that everyone writes: object by object and plane by plane until one rejects. No margin. 1: outside.
void testNaively(const std::vector<NaiveBox>& boxes, const NaivePlanes& planes, std::vector<uint8_t>& outside);
void testNaively(const std::vector<NaiveSphere>& spheres, const NaivePlanes& planes, std::vector<uint8_t>& outside);

/// What merely reading a batch's arrays costs: their sum, with the widest vectors that the processor has.
[[nodiscard]] double sumOf(const double* blocks, size_t doubles);

}  // namespace cullscope::benchmark
