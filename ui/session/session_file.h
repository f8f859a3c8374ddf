#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// The metadata name under which a picture stores a session as JSON text (see stateToText).
inline constexpr const char* kSessionMetadata = "cullscope:session";
/// The file name extension without the dot.
inline constexpr const char* kSessionExtension = "cullscope";

/// The state as JSON. File names in the scene specification are relative to the folder of `file`, where the text is to be saved;
/// absolute if `file` is empty. All numbers are read back exactly. Throws Error(Usage) if no scene is open, or if a file name is
/// not valid UTF-8.
[[nodiscard]] std::string stateToText(const SessionState& state, const std::filesystem::path& file);

/// Reads such a text; `file` is where it was found. None: it is JSON, but not a session. Throws Error(Input) naming file and
/// field if it is not JSON, or a session with an invalid value. Unknown fields are ignored.
[[nodiscard]] std::optional<SessionState> stateFromText(std::string_view text, const std::filesystem::path& file);

/// The same of a text that was parsed already, which must be a session.
[[nodiscard]] SessionState stateFromJson(const nlohmann::json& json, const std::filesystem::path& file);

/// Writes a session completely or not at all. Throws as stateToText does, and Error(Usage) if the file cannot be written.
void saveSession(const std::filesystem::path& file, const SessionState& state);

/// Reads a session. Throws Error(Input) naming the file, and the field if there is one, if it cannot be read or is not a session.
[[nodiscard]] SessionState loadSession(const std::filesystem::path& file);

}  // namespace cullscope::ui
