#pragma once

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// A strategy with parameters as text: {"rows", "90"}, …
inline CullerPointer strategyWith(const char* id, const std::vector<std::pair<const char*, const char*>>& parameters) {
    ParameterSet set(findStrategy(id).info.parameters);
    for (const auto& [key, value] : parameters) set.setFromText(key, value);
    return makeCuller(id, set);
}

/// With maps of few cells, so that many scenes take little time.
inline CullerPointer coarse(const RegisteredStrategy& registered) {
    ParameterSet parameters(registered.info.parameters);
    for (const ParameterDeclaration& declaration : registered.info.parameters)
        if (declaration.key == "rows") parameters.set("rows", int64_t{12});
    return makeCuller(registered.info.id, parameters);
}

/// A sphere mesh with every vertex moved along its direction by a seeded sum of bumps and spikes: star-shaped around the origin.
inline MeshPointer bumpyMesh(uint64_t seed, size_t triangles, double height) {
    const MeshPointer sphere = sphereMesh(triangles);
    Random random(seed);
    std::vector<Vec3> axes;
    std::vector<double> sharpness;
    for (int i = 0; i < 12; ++i) {
        axes.push_back(random.direction());
        sharpness.push_back(random.between(2.0, 40.0));
    }
    std::vector<Vec3f> positions;
    for (const Vec3f& position : sphere->positions()) {
        double radius = 1.0;
        for (size_t i = 0; i < axes.size(); ++i)
            radius += height * std::exp(sharpness[i] * (glm::dot(axes[i], glm::normalize(Vec3(position))) - 1.0));
        positions.push_back(Vec3f(glm::normalize(Vec3(position)) * radius));
    }
    return meshOf(std::move(positions), {sphere->indices().begin(), sphere->indices().end()});
}

/// A rotation about an axis of any length.
inline Mat4 rotation(const Vec3& axis, double radians) {
    const Vec3 n = glm::normalize(axis);
    Mat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) {
        Vec3 e(0.0);
        e[i] = 1.0;
        matrix[i] = Vec4(
            e * std::cos(radians) + glm::cross(n, e) * std::sin(radians) + n * (glm::dot(n, e) * (1.0 - std::cos(radians))), 0.0);
    }
    return matrix;
}

}  // namespace cullscope::test
