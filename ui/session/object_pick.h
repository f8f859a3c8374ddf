#pragma once

#include <optional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The pick of an object by its first triangle, at that triangle's centroid; none: it has no triangle.
[[nodiscard]] std::optional<Pick> pickOfObject(const Scene& opened, uint32_t object);

/// Picks an object unless it is what is picked already, whichever of its triangles that is.
void pickObject(Session& session, uint32_t object);

/// Brings all of an object into the active view.
void frameObject(Session& session, uint32_t object);

}  // namespace cullscope::ui
