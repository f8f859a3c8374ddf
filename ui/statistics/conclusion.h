#pragma once

#include <QStringList>

#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

/// What a measurement says, in sentences of the user's language: the fastest strategy that lost no pixel, one that is faster
/// still and loses some, promises that were broken, and what limits the figures. A speed is called faster only where its 95 %
/// interval lies above 1.
[[nodiscard]] QStringList conclusionsOf(const MeasureResult& result);

/// The same of figures, without what limits them.
[[nodiscard]] QStringList conclusionsOf(const std::vector<RunFigures>& runs);

}  // namespace cullscope::ui
