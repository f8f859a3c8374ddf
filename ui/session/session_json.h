#pragma once

#include <nlohmann/json.hpp>

#include "ui/session/json_field.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Conversions of the parts of a session file to and from JSON. Reading throws Error(Input) naming file and field.

[[nodiscard]] nlohmann::ordered_json jsonOf(const Camera& camera);
[[nodiscard]] Camera readCamera(const JsonField& field);

/// Background and surface colours.
[[nodiscard]] nlohmann::ordered_json jsonOf(const DrawStyle& style);
[[nodiscard]] DrawStyle readStyle(const JsonField& field);

[[nodiscard]] nlohmann::ordered_json jsonOf(const ViewSetup& setup);
/// Reads the setup from the JSON object that also holds the view's strategy; missing fields keep the values of a new view.
[[nodiscard]] ViewSetup readSetup(const JsonField& field);

/// The view's parameters as a ParameterSet of its strategy. Throws Error(Usage) naming an unknown strategy or parameter.
[[nodiscard]] ParameterSet parametersOf(const SessionState::View& view);

[[nodiscard]] nlohmann::ordered_json jsonOf(const SessionState::View& view);
[[nodiscard]] SessionState::View readView(const JsonField& field);

}  // namespace cullscope::ui
