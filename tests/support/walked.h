#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "core/visibility/octree_walk.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// By instance, the planes of an object that one walk kept; none: culled.
using Kept = std::vector<std::optional<uint8_t>>;

inline Kept byInstance(const std::vector<KeptObject>& kept, size_t instances) {
    Kept result(instances);
    for (const KeptObject& object : kept) {
        EXPECT_FALSE(result[object.instance]) << "kept twice";
        result[object.instance] = object.planes;
    }
    return result;
}

/// An object's own bounds against one plane: the tighter of box and sphere, and their common margin.
struct OwnTest {
    double inner, outer, margin;
};

inline OwnTest ownTest(const Plane& plane, const Scene& scene, size_t instance, const Vec3& eye) {
    const EyeBox box = relativeToEye(scene.instanceBox(instance), eye);
    const Sphere& sphere = scene.instanceSphere(instance);
    const double centre = plane.distance(box.centre), reach = glm::dot(glm::abs(plane.normal), box.halfExtent);
    const double middle = plane.distance(sphere.centre - eye);
    return {std::min(centre + reach, middle + sphere.radius), std::max(centre - reach, middle - sphere.radius),
            conservativeMargin(glm::length(sphere.centre - eye) + sphere.radius) +
                (glm::length(sphere.centre) + glm::length(eye) + sphere.radius) * 0x1p-49};
}

/// One walk over the groups of a scene.
struct Walked {
    std::vector<KeptObject> objects;
    OctreeWalkCounters figures;
    FrameLog log;

    [[nodiscard]] size_t kept() const { return objects.size(); }
    [[nodiscard]] uint64_t tests() const { return figures.nodesVisited + figures.objectsTested; }
};

inline Walked walked(const InstanceOctree& octree, const Scene& scene, const View& view, Recording recording = Recording::Off,
                     bool refine = false) {
    FrameContext frame(scene, view, recording == Recording::On);
    Walked result;
    result.objects = keptObjects(octree, frame, &result.figures, {refine});
    result.log = frame.take();
    return result;
}

inline Walked walked(const Scene& scene, const Camera& camera) {
    return walked(InstanceOctree(scene), scene, View(camera, {640, 480}));
}

/// A square field of n × n boxes with this spacing, about the origin.
inline ScenePointer boxField(int n, double spacing) {
    std::vector<Mat4> places;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) places.push_back(translation(spacing * Vec3(i - 0.5 * (n - 1), 0, j - 0.5 * (n - 1))));
    return copiesOf(boxMesh(Vec3f(-0.3f), Vec3f(0.3f)), places);
}

}  // namespace cullscope::test
