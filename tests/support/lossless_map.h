#pragma once

#include "core/scene/camera_path.h"
#include "core/visibility/spherical/map_details.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// The map of `spherical-lossless` for one mesh in one view. World and mesh coordinates are the same.
struct LosslessMap {
    LosslessMap(MeshPointer mesh, MapLayout layout, const Vec3& eye, const Vec3& target = Vec3(0.0), double fovyDegrees = 45.0)
        : scene(sceneOf({std::move(mesh)}, {Mat4(1.0)})),
          view(Camera{eye, target, {0.1, 0.9, 0.2}, Angle::fromDegrees(fovyDegrees), 0.05, 100.0}, {320, 240}) {
        ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
        parameters.set("layout", std::string(mapLayoutId(layout)));
        strategy = makeCuller("spherical-lossless", parameters);
        strategy->build(*scene);
        const Culled frame = strategy->cull(view, Recording::On);
        snapshot = strategy->snapshot(frame.log);
    }

    [[nodiscard]] const spherical::MapSnapshot& map() const { return spherical::mapsOf(snapshot).front(); }

    ScenePointer scene;
    View view;
    CullerPointer strategy;
    StructureSnapshot snapshot;
};

inline constexpr std::array kLayouts{MapLayout::LatitudeLongitude, MapLayout::Octahedral};

}  // namespace cullscope::test
