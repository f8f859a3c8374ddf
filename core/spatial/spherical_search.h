#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/spatial/spherical_maps.h"

namespace cullscope {

/// The ray origin + t · direction, in the coordinates of the maps, relative to their centre. `direction` has any length but 0.
struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, 1.0};

    [[nodiscard]] Vec3 at(double t) const { return origin + t * direction; }
};

/// The ray parameters at which a ray enters and leaves a sphere around the origin; none where it misses. The entry is at least 0.
struct Span {
    double from = 0.0;
    double to = 0.0;
};
[[nodiscard]] std::optional<Span> throughSphere(const Ray& ray, double radius);

/// The part of a ray inside one cell, and what a search for a triangle found there.
struct WalkedCell {
    SphericalGrid::Cell cell;
    Span span;
    double nearest = 0.0, farthest = 0.0;  ///< of searchTriangle: the ray's least and largest R in the cell
    uint32_t tested = 0;                   ///< triangles that were intersected with the ray
    bool hit = false;                      ///< one of them is hit, before those of the cells before
};

/// The cells that a part of a ray passes through, in order. (Along a line the azimuth is monotonic and the zenith angle has at
/// most one extreme, so only the boundaries in between can be crossed.)
[[nodiscard]] std::vector<WalkedCell> walkedCells(const SphericalGrid& grid, const Ray& ray, const Span& span);

struct TriangleHit {
    uint32_t triangle = 0;  ///< of the mesh
    double t = 0.0;
};

/// The ray parameter at which a ray hits a triangle, edges included, from either side. None for a ray in the triangle's plane.
[[nodiscard]] std::optional<double> hit(const Ray& ray, const std::array<Vec3, 3>& corners);

/// The nearest triangle that a ray hits in a part of it that holds all of the object: Triangle_Search of Han & Hong's Appendix 1.
/// Walks the index map from the start cell by cell, compares the ray's own R there with the range of R of the cell's triangles,
/// and confirms by intersecting them. `told`, if there is one, is told of every cell as soon as it was searched.
[[nodiscard]] std::optional<TriangleHit> searchTriangle(const SphericalMaps& maps, const Ray& ray, const Span& span,
                                                        const std::function<void(const WalkedCell&)>& told = {});
/// The same of the part inside the bounding sphere.
[[nodiscard]] std::optional<TriangleHit> searchTriangle(const SphericalMaps& maps, const Ray& ray,
                                                        const std::function<void(const WalkedCell&)>& told = {});

}  // namespace cullscope
