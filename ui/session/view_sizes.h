#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/message.h"
#include "ui/jobs/view_setup.h"

namespace cullscope::ui {

/// A view's pictures take bytes in proportion to their pixels, in OpenGL and outside it. So the pixels that are asked for are
/// limited for all views together, before anything is allocated.

/// The most that the user can ask for: one picture of 8192 × 8192, or eight of 3840 × 2160.
inline constexpr uint64_t kMostPixelsAskedFor = uint64_t{1} << 26;
/// The most that a session file can ask for. The difference is for frozen views, which keep the size that the window gave them.
inline constexpr uint64_t kMostPixelsOfSession = uint64_t{1} << 27;

/// The pixels that all these views ask for: of each one's picture, or of the one that its frozen camera culls for where that is
/// larger. What fits the window is not asked for.
[[nodiscard]] uint64_t pixelsAskedFor(const std::vector<ViewSetup>& views);

/// Why these views cannot be shown at their sizes; none: they can.
[[nodiscard]] std::optional<Message> tooManyPixels(const std::vector<ViewSetup>& views, uint64_t most);

}  // namespace cullscope::ui
