#pragma once

#include <vector>

#include "core/visibility/strategy_request.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Sets up the views at the start: the chosen strategies with their parameters, one a view, in as many views as they need.
/// Without a choice: `backface`, which leaves something out of any scene, and beside it a view that observes it from outside.
void showFirstViews(Session& session, const std::vector<StrategyRequest>& chosen);

}  // namespace cullscope::ui
