#pragma once

#include <functional>
#include <vector>

#include "core/image/view_picture.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The strategy whose decisions the active view shows: its own, or that of the view that it observes.
[[nodiscard]] const StrategyInfo& shownStrategy(const Session& session);

/// What the lines that strategies draw into the pictures of `views` mean, each once.
[[nodiscard]] std::vector<ShowMeaning> meaningsIn(const Session& session, const std::vector<int>& views);

/// Calls `then` whenever it may have changed, while `context` exists.
void followShownStrategy(Session& session, QObject* context, const std::function<void()>& then);

}  // namespace cullscope::ui
