#pragma once

#include <QColor>

namespace cullscope::ui {

/// What marks the subject in hand of a stepped view, in pictures and panels: seen on light and dark backgrounds, with its dark
/// edge.
inline const QColor kInHandColour(255, 176, 0);
inline const QColor kInHandEdge(0, 0, 0);
inline constexpr double kInHandWidth = 2.0, kInHandEdgeWidth = 4.0;

}  // namespace cullscope::ui
