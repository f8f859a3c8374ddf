#pragma once

#include <array>
#include <cmath>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// Objects of many sizes and directions, some large and thin, close to each other so that many hide others; around a place.
inline ScenePointer crowd(uint64_t seed, const Vec3& place = Vec3(0.0)) {
    Random random(seed);
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    const int count = 20 + int(random.between(0, 60));
    for (int i = 0; i < count; ++i) {
        switch (int(random.between(0, 4))) {
            case 0:
                meshes.push_back(squareMesh(1, 0));
                break;
            case 1:
                meshes.push_back(sphereMesh(80));
                break;
            case 2:
                meshes.push_back(starMesh(uint64_t(i), 200));
                break;
            default:
                meshes.push_back(boxMesh(Vec3f(-1), Vec3f(1)));
        }
        const Vec3 axis = random.direction(), other = glm::normalize(glm::cross(axis, random.direction()));
        Mat4 turn(1.0);
        turn[0] = Vec4(axis, 0);
        turn[1] = Vec4(other, 0);
        turn[2] = Vec4(glm::cross(axis, other), 0);
        const Vec3 size(std::pow(10.0, random.between(-1.5, 0.7)), std::pow(10.0, random.between(-1.5, 0.7)),
                        std::pow(10.0, random.between(-2.0, 0.5)));
        const Vec3 at(random.between(-5, 5), random.between(-5, 5), random.between(-5, 5));
        places.push_back(translation(place + at) * turn * scaling(size));
    }
    return sceneOf(std::move(meshes), places);
}

}  // namespace cullscope::test
