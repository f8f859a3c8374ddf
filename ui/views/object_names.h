#pragma once

#include "ui/session/session.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

/// The names of the objects where the picture shows them: in an open question, which asks for them, and of a scene that names
/// planes, as the lecture's quiz does, whose polygons the sentences name. Empty in other scenes, and where there are too many
/// objects to read their names.
[[nodiscard]] std::vector<PlacedName> objectNames(const Session& session, const ViewPicture& shown);

}  // namespace cullscope::ui
