#pragma once

#include <optional>
#include <vector>

#include "core/spatial/spherical_maps.h"

namespace cullscope {

/// origin + t · direction, which is of any length but 0. Both in whatever coordinates the maps are in, from their centre.
struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, 1.0};

    [[nodiscard]] Vec3 at(double t) const { return origin + t * direction; }
};

/// Where a ray enters and leaves a sphere around the origin; none: it misses. The entry is not before the ray's own beginning.
struct Span {
    double from = 0.0;
    double to = 0.0;
};
[[nodiscard]] std::optional<Span> throughSphere(const Ray& ray, double radius);

/// The piece of a ray inside one cell.
struct WalkedCell {
    SphericalGrid::Cell cell;
    Span span;
};

/// The cells that a piece of a ray passes one after the other. (Azimuth grows or falls all along a line, the zenith angle turns
/// at most once: only boundaries that lie between can be crossed.)
[[nodiscard]] std::vector<WalkedCell> walkedCells(const SphericalGrid& grid, const Ray& ray, const Span& span);

struct TriangleHit {
    uint32_t triangle = 0;  ///< of the mesh
    double t = 0.0;
};

/// Where a ray meets a triangle, edges included; either side. None for a ray in the triangle's plane.
[[nodiscard]] std::optional<double> hit(const Ray& ray, const std::array<Vec3, 3>& corners);

/// The nearest triangle that a ray meets inside the bounding sphere: Triangle_Search of Han & Hong's Appendix 1. Walks the index
/// map from the entry cell by cell, compares the ray's own R there with how far the cell's triangles reach, and confirms by
/// intersecting them. `walked`, where given, gets every cell that was looked at.
[[nodiscard]] std::optional<TriangleHit> searchTriangle(const SphericalMaps& maps, const Ray& ray,
                                                        std::vector<WalkedCell>* walked = nullptr);

}  // namespace cullscope
