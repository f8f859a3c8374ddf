#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// A session as JSON text (see stateToText), for a file or for a picture's metadata under this name.
inline constexpr const char* kSessionMetadata = "cullscope:session";
/// Without the dot.
inline constexpr const char* kSessionExtension = "cullscope";

/// The state as JSON. The scene's files are named relative to the folder of `file`, which the text is meant for; with an empty
/// `file` they are absolute. All numbers read back as they were. Throws Error(Usage) where no scene is open, or where a file's
/// name is no UTF-8.
[[nodiscard]] std::string stateToText(const SessionState& state, const std::filesystem::path& file);

/// The other way round; `file` is where the text was found. None where it is JSON, but nobody's session. Throws Error(Input)
/// naming file and field where it is no JSON or a session with something wrong in it. Fields that nobody knows are passed over.
[[nodiscard]] std::optional<SessionState> stateFromText(std::string_view text, const std::filesystem::path& file);

/// Writes a session whole or not at all. Throws as stateToText, and Error(Usage) where the place cannot be written.
void saveSession(const std::filesystem::path& file, const SessionState& state);

/// Throws Error(Input) naming the file, and the field where there is one, where it is no session or cannot be read.
[[nodiscard]] SessionState loadSession(const std::filesystem::path& file);

}  // namespace cullscope::ui
