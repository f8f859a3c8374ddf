#pragma once

#include <optional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The pick of an object by the triangle that stands for what became of it in the active view, at its centroid: a wrongly culled
/// one where there is any, else a visible one, else one drawn in vain; where that is not known, the first one. None: it has no
/// triangle.
[[nodiscard]] std::optional<Pick> pickOfObject(const Session& session, uint32_t object);

/// The pick of a triangle, counted within its object, at its centroid.
[[nodiscard]] Pick pickOfTriangle(const Session& session, uint32_t object, uint64_t triangle);

/// Picks an object unless it is what is picked already, whichever of its triangles that is.
void pickObject(Session& session, uint32_t object);
/// The same by a wrongly culled triangle of it, whatever is picked.
void pickLoss(Session& session, uint32_t object);

/// Brings all of an object into the active view.
void frameObject(Session& session, uint32_t object);

}  // namespace cullscope::ui
