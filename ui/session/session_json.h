#pragma once

#include <nlohmann/json.hpp>

#include "ui/session/json_field.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// The parts of a session file, each way. Reading throws Error(Input) naming file and field.

[[nodiscard]] nlohmann::ordered_json jsonOf(const Camera& camera);
[[nodiscard]] Camera readCamera(const JsonField& field);

/// Background and surface.
[[nodiscard]] nlohmann::ordered_json jsonOf(const DrawStyle& style);
[[nodiscard]] DrawStyle readStyle(const JsonField& field);

[[nodiscard]] nlohmann::ordered_json jsonOf(const ViewSetup& setup);
/// Reads out of the same group of fields as the view's strategy; what is missing stays as in a new view.
[[nodiscard]] ViewSetup readSetup(const JsonField& field);

[[nodiscard]] nlohmann::ordered_json jsonOf(const SessionState::View& view);
[[nodiscard]] SessionState::View readView(const JsonField& field);

}  // namespace cullscope::ui
