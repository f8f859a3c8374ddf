#pragma once

#include <optional>
#include <string_view>

#include "core/scene/camera.h"

namespace cullscope {

/// The size that "640x480" names, of 1 to kMostPixels pixels each way; none for any other text.
[[nodiscard]] std::optional<Viewport> viewportFromText(std::string_view text);

}  // namespace cullscope
