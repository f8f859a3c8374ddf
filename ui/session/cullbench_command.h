#pragma once

#include <QString>

#include "core/scene/camera.h"
#include "core/visibility/parameters.h"

namespace cullscope::ui {

/// The `cullbench render` command that repeats a view's picture, quoted for a POSIX shell. Parameters at their defaults are left
/// out.
[[nodiscard]] QString cullbenchCommand(const std::string& scene, const std::string& strategy, const ParameterSet& parameters,
                                       const Camera& camera, const Viewport& size);

}  // namespace cullscope::ui
