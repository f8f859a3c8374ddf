#pragma once

#include <optional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The pick that stands for an object, at the centroid of one of its triangles: a wrongly culled triangle in the active view if
/// there is one, else a visible one, else one drawn in vain; the first triangle if there is none of these or the states are not
/// known. None: the object has no triangles.
[[nodiscard]] std::optional<Pick> pickOfObject(const Session& session, uint32_t object);

/// The pick of a triangle at its centroid; `triangle` is numbered within the object.
[[nodiscard]] Pick pickOfTriangle(const Session& session, uint32_t object, uint64_t triangle);

/// Picks an object, unless one of its triangles is picked already.
void pickObject(Session& session, uint32_t object);
/// Picks an object by a wrongly culled triangle, if it has one, even if another of its triangles is picked.
void pickLoss(Session& session, uint32_t object);

/// Hides or shows objects; the others stay as they are.
void setObjectsHidden(Session& session, const std::vector<uint32_t>& objects, bool hidden);
/// Hides all others; does nothing where there are none to isolate.
void isolateObjects(Session& session, const std::vector<uint32_t>& objects);
void showAllObjects(Session& session);

/// Fits an object into the active view.
void frameObject(Session& session, uint32_t object);

}  // namespace cullscope::ui
