#pragma once

#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/slope_horizon.h"
#include "core/visibility/strategy.h"

namespace cullscope::spherical {

/// The structures that both strategies have for one mesh.
struct MappedMesh {
    SphericalMapsPointer maps;
    std::unique_ptr<const BandCells> bandCells;
    std::unique_ptr<const HorizonCells> horizonCells;  ///< of `spherical-horizon`
};

/// The maps of a scene's meshes.
struct MappedScene : Structure {
    using Structure::Structure;

    [[nodiscard]] const MappedMesh& meshOf(uint32_t instance) const { return meshes[scene().instances()[instance].mesh]; }

    std::vector<MappedMesh> meshes;
    TriangleOrderPointer order;
    /// Whether every mesh is star-shaped around its centre, for pictures under each facing rule; of `spherical-horizon`.
    std::array<bool, kFacingRules> starShaped{};
};

/// The maps of a mesh by the parameter "rows" and, where they are declared, "axis", "origin" and "storage".
[[nodiscard]] SphericalMapsPointer makeMaps(const MeshPointer& mesh, const ParameterSet& parameters, const Progress& progress);
/// After the meshes' structures were made: the order and the report.
void finish(MappedScene& structure);

// Parameters of strategies that decide by cells of maps.

[[nodiscard]] ParameterDeclaration rowsParameter();
/// "storage": what the maps keep of R.
[[nodiscard]] ParameterDeclaration storageParameter();
/// "band", the width in degrees, and "sectors".
[[nodiscard]] std::vector<ParameterDeclaration> bandParameters(double width, int64_t sectors);
/// Contour bands by these parameters around the axis to the eye, with all sizes 0.
[[nodiscard]] ContourBands bandsFor(const Vec3& eye, const ParameterSet& parameters);

}  // namespace cullscope::spherical
