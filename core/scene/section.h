#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/plane.h"
#include "core/scene/camera.h"

namespace cullscope {

/// A plane that cuts away a part of what pictures show: a section. What is culled, and every figure, is of the whole scene.
struct Section {
    enum class Axis { X, Y, Z, View };  ///< across which the plane lies; View: across a camera's view direction
    Axis axis = Axis::X;
    double share = 0.5;    ///< where it lies on the scene's extent along the axis, from 0 to 1
    bool flipped = false;  ///< the lower side is kept, and not the upper one; of View: what is nearer

    bool operator==(const Section&) const = default;
};

/// "x:0.5", "view:0.25:flip": on the command line and in pictures' texts. None where a text is no section.
[[nodiscard]] std::string sectionText(const Section& section);
[[nodiscard]] std::optional<Section> sectionFromText(std::string_view text);
/// "x", "y", "z", "view".
[[nodiscard]] const char* sectionAxisId(Section::Axis axis);

/// The plane in world coordinates, with its normal to the side that is kept. `scene`: the scene's box; `camera`: of the axis
/// View.
[[nodiscard]] Plane sectionPlane(const Section& section, const Box3& scene, const Camera& camera);

/// The polygon that a plane cuts out of a box; empty where they do not meet.
[[nodiscard]] std::vector<Vec3> planeInBox(const Plane& plane, const Box3& box);

}  // namespace cullscope
