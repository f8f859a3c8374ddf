#pragma once

#include <QString>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The strategy that a view shows, with its id and the parameters that are not at their defaults.
[[nodiscard]] QString shownStrategy(const Session& session, int view);

/// The line below a screenshot of the active view, or of all: scene, strategy and figures, and at which size those were measured.
[[nodiscard]] QString madeCaption(Session& session, bool grid);

/// What stands before the legend's counts: of which size's picture they are.
[[nodiscard]] QString legendHeading(const Viewport& size);

}  // namespace cullscope::ui
