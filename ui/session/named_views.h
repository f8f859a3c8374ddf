#pragma once

#include <string>
#include <vector>

#include "ui/session/session.h"

namespace cullscope::ui {

/// A direction from which a scene is looked at by its name.
struct NamedView {
    std::string name;  ///< English, marked for translation
    Vec3 fromYUp;      ///< from the target to the eye where y points up; not normalised
};

/// Front, back, left, right, top, bottom, and from a corner.
[[nodiscard]] const std::vector<NamedView>& namedViews();

/// The direction where an axis points up. With z up the front is seen along +y.
[[nodiscard]] Vec3 directionOf(const NamedView& view, UpAxis up);

/// Looks from there at what the active view looks at, from the same distance.
void lookFrom(Session& session, const NamedView& view);

/// Changes the active view's projection; what lies at the target keeps its size.
void setProjection(Session& session, ProjectionKind projection);

}  // namespace cullscope::ui
