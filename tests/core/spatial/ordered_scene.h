#pragma once

#include "core/spatial/painters_order.h"
#include "tests/support/cut_scenes.h"

// Small scenes in the painter's order.
namespace cullscope::test::painters_order_test {

inline View front(Viewport size = {100, 100}) {
    return {{{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, size};
}

struct Ordered {
    std::vector<uint32_t> triangles;  ///< far to near
    PaintersOrder order;
    std::vector<NewellStep> steps;
    std::vector<double> shares;              ///< of each scene triangle's area, summed over its polygons
    std::vector<std::vector<Vec3>> corners;  ///< of the polygons in their order, relative to the eye

    [[nodiscard]] uint64_t count(NewellTest test) const { return order.tests[size_t(test)]; }
    /// Of all comparisons.
    [[nodiscard]] uint64_t comparisons() const {
        uint64_t sum = 0;
        for (const uint64_t tests : order.tests) sum += tests;
        return sum;
    }
};

inline Ordered ordered(const ScenePointer& scene, PaintersOptions options = {}, const View& view = front()) {
    CutTriangles triangles(*scene);
    Ordered result;
    options.watch = [&](const NewellStep& step) { result.steps.push_back(step); };
    result.order = paintersOrder(triangles, *scene, view, options);
    triangles.finish();
    result.shares.assign(scene->triangleCount(), 0.0);
    for (const uint32_t polygon : result.order.polygons) {
        const uint32_t triangle = triangles.polygons()[polygon].triangle;
        result.triangles.push_back(triangle);
        result.shares[triangle] += triangles.share(polygon);
        for (std::vector<Vec3>& corners = result.corners.emplace_back(); const auto& corner : triangles.cornersOf(polygon))
            corners.push_back(triangles.position(corner.vertex) - view.eye());
    }
    return result;
}

/// Triangles 0, 1, … of three corners each.
inline ScenePointer sceneWith(std::vector<Vec3f> corners) { return sceneOf({soupMesh(std::move(corners))}); }

inline ScenePointer layers(std::vector<float> heights) {
    std::vector<Vec3f> corners;
    for (const float z : heights) corners.insert(corners.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
    return sceneWith(std::move(corners));
}

}  // namespace cullscope::test::painters_order_test
