#pragma once

#include <string>
#include <vector>

#include "ui/session/session.h"

namespace cullscope::ui {

/// What the views show at the start: the chosen strategies, one a view and as many views as they need. Without a choice a
/// strategy that leaves something out of any scene, and beside it a view that watches it from outside.
void showFirstViews(Session& session, const std::vector<std::string>& chosen);

}  // namespace cullscope::ui
