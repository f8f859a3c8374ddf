#pragma once

#include <filesystem>
#include <optional>

#include "core/scene/camera.h"

namespace cullscope {

/// The size of a JPEG file whose colours come in several scans, as a progressive one's do: its decoder keeps the coefficients of
/// the whole picture at once, six bytes a pixel, before the first row is known. None where rows are decoded one after the other,
/// and where the file has no header that says it. (ITU T.81, B.2)
[[nodiscard]] std::optional<Viewport> sizeKeptWhole(const std::filesystem::path& file);

}  // namespace cullscope
