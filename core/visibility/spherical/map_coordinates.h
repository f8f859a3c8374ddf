#pragma once

#include "core/spatial/spherical_maps.h"
#include "core/visibility/parameters.h"

namespace cullscope::spherical {

/// The mesh's axis along which θ = 0. The paper's equation (1) has z and does not say how its model lies.
enum class PolarAxis { Z, X, Y };

/// The origin of R, θ and φ. The paper says "the centre of the sphere" and does not say how it was found.
enum class MapOrigin {
    Sphere,   ///< the centre of the bounding sphere
    Box,      ///< the middle of the bounding box
    Centroid  ///< the area-weighted centroid of the surface
};

/// The coordinates of `spherical`'s maps, read when they are built.
struct MapCoordinates {
    PolarAxis axis = PolarAxis::Z;
    MapOrigin origin = MapOrigin::Sphere;
};
[[nodiscard]] std::vector<ParameterDeclaration> coordinateParameters();
[[nodiscard]] MapCoordinates coordinatesOf(const ParameterSet& parameters);

/// The frame of a mesh's maps. With another origin than the bounding sphere's centre, the sphere is the smallest around that
/// origin that holds all vertices that a triangle uses.
[[nodiscard]] MapFrame mapFrame(const TriangleMesh& mesh, const MapCoordinates& coordinates);

}  // namespace cullscope::spherical
