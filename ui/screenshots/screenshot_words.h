#pragma once

#include <QStringList>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The strategy that a view shows, with its id and the parameters that are not at their defaults.
[[nodiscard]] QString shownStrategy(const Session& session, int view);

/// The picture sizes, each once, that the known figures of views were measured at.
[[nodiscard]] QStringList figuresSizes(const Session& session, const std::vector<int>& views);

/// The default caption of the active view or of all shown views: scene, strategy and metrics, with the picture size that these
/// were measured at.
[[nodiscard]] QString madeCaption(Session& session, bool grid);

/// The heading of the legend's counts, which states the picture size that they belong to.
[[nodiscard]] QString legendHeading(const Viewport& size);

}  // namespace cullscope::ui
