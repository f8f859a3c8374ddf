#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// A wall at distance 3 that fills a view from the origin along −z, spheres behind it, one before it, and one behind the eye.
inline ScenePointer wallBeforeSpheres() {
    std::vector<MeshPointer> meshes{squareMesh(8, -3), sphereMesh(320), sphereMesh(320)};
    std::vector<Mat4> places{Mat4(1.0), translation({0, 0, -1.5}) * scaling(Vec3(0.2)), translation({0, 0, 6})};
    for (int i = 0; i < 12; ++i) {
        meshes.push_back(sphereMesh(320));
        places.push_back(translation({2.5 * (i % 4) - 3.5, 2.5 * (i / 4) - 2.5, -8.0 - (i % 3)}));
    }
    return sceneOf(std::move(meshes), places);
}

/// A wall at distance 3 that fills the left half of the view, and boxes behind and beside it.
inline ScenePointer boxesBehindHalfAWall() {
    std::vector<MeshPointer> meshes{meshOf({{-9, -9, -3}, {0, -9, -3}, {0, 9, -3}, {-9, 9, -3}}, {0, 1, 2, 0, 2, 3})};
    std::vector<Mat4> places{Mat4(1.0)};
    const MeshPointer box = boxMesh(Vec3f(-0.1f), Vec3f(0.1f));
    for (int i = 0; i < 400; ++i) {
        meshes.push_back(box);
        places.push_back(translation({i % 20 - 9.5, i / 20 - 9.5, -11.0 - 0.01 * i}));
    }
    return sceneOf(std::move(meshes), places);
}

/// The instances that a frame draws.
inline std::set<uint32_t> drawn(const Culled& frame) {
    std::set<uint32_t> instances;
    for (const DrawRange& range : frame.drawList.ranges) instances.insert(range.instance);
    return instances;
}

/// A figure that a frame counted; fails where it has none of that name.
inline double figure(const Culled& frame, const std::string& name) {
    for (const NamedFigure& one : frame.log.counters.figures)
        if (one.name == name) return one.value;
    ADD_FAILURE() << "no figure " << name;
    return 0.0;
}

}  // namespace cullscope::test
