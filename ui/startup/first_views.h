#pragma once

#include <string>
#include <vector>

#include "ui/session/session.h"

namespace cullscope::ui {

/// Sets up the views at the start: the chosen strategies, one a view, in as many views as they need. Without a choice:
/// `backface`, which leaves something out of any scene, and beside it a view that observes it from outside.
void showFirstViews(Session& session, const std::vector<std::string>& chosen);

}  // namespace cullscope::ui
