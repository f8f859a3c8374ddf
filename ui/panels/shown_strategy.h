#pragma once

#include <functional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The strategy whose decisions the active view shows: its own, or that of the view that it observes.
[[nodiscard]] const StrategyInfo& shownStrategy(const Session& session);

/// Calls `then` whenever it may have changed, while `context` exists.
void followShownStrategy(Session& session, QObject* context, const std::function<void()>& then);

}  // namespace cullscope::ui
