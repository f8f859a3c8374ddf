#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "tests/support/exact_convex.h"

namespace cullscope::test {

/// The relation of an object to a frustum in (nearly) exact arithmetic.
struct ObjectTruth {
    bool visible = false;    ///< a part of a triangle lies within the closed frustum
    bool straddles = false;  ///< visible, and some vertex lies outside
    /// The smallest distance of a vertex from each plane (left, right, bottom, top, near, far), divided by its distance from the
    /// eye; at most 1.
    std::array<double, 6> closest{1, 1, 1, 1, 1, 1};
};

/// Decides which objects a frustum shows, without sharing code with the library: reads eye, target, up, fovy, near, far and the
/// picture's size, builds the six half-spaces itself, transforms every vertex to the world and clips every triangle against the
/// six. Error bound: every sum has terms below 2^38 of the largest coordinate in play (aspects to 2^14, tangents to 2^7, 1e9
/// against 1e-6 ...) and is rounded to 2^-113 of them, so a plane is displaced by less than 2^-100 of the scene's coordinates:
/// 1e-23 at 1e7. Half-spaces are closed: an object that touches a plane counts as visible, which is the stricter requirement on a
/// culling test.
class ExactVisibility {
public:
    ExactVisibility(const Camera& camera, const Viewport& viewport);

    [[nodiscard]] ObjectTruth judge(const Scene& scene, size_t instance) const;
    /// Whether a box in the world intersects the closed frustum.
    [[nodiscard]] bool meets(const Box3& world) const;

private:
    /// inside where n·p + offset >= 0, with p relative to the eye
    struct HalfSpace {
        std::array<Quad, 3> normal;  ///< unit length
        Quad offset;
    };
    [[nodiscard]] Distances distances(const QuadVector& eyeRelative) const;

    std::array<HalfSpace, 6> m_halfSpaces;
    std::array<Quad, 3> m_eye;
};

/// Every number of a camera with 17 digits, to report a counterexample.
[[nodiscard]] std::string described(const Camera& camera, const Viewport& viewport);

}  // namespace cullscope::test
