#pragma once

#include <QColor>
#include <QPalette>

namespace cullscope::ui {

/// The colours of the plots, for a light or a dark ground; told apart in the common deficiencies of colour vision, and never the
/// only sign of what they say.
struct PlotColours {
    explicit PlotColours(const QPalette& palette);

    QColor ground;
    QColor text;
    QColor faintText;
    QColor grid;
    QColor cull;
    QColor draw;
    QColor baselineCull;
    QColor baselineDraw;
    QColor noLoss;
    QColor loss;
    QColor chosen;
    bool dark = false;

    /// Of a strategy that is no baseline, by its number among those.
    [[nodiscard]] QColor series(size_t number) const;
};

}  // namespace cullscope::ui
