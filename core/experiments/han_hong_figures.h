#pragma once

#include <optional>

#include "core/experiments/result_table.h"
#include "core/image/page_legend.h"
#include "core/visibility/strategy_request.h"

/// The figures of Han & Hong 2008, drawn of a scene's first object.
namespace cullscope::han_hong {

inline constexpr int kFigures = 8;
/// The width that the figures are laid out for, in units of a page whose letters are kPlotLetters large, and the pixels that a
/// picture of them has across: there the letters have 20.
inline constexpr double kFigureWidth = 820.0;
inline constexpr int kFigurePixels = 1280;
/// The strategy that they show.
inline constexpr const char* kShownStrategy = "spherical";

/// What each figure shows, in the paper's words; marked for translation.
[[nodiscard]] const char* figureTitle(int number);

/// The strategy that a figure shows, as strategyFromText reads it: in Figures 5 to 8 with bands of 15°, so that each can be told
/// from its neighbours. The paper does not say how wide its bands are.
[[nodiscard]] std::string figureStrategy(int number);

struct FigureRequest {
    int number = 1;  ///< 1 to kFigures
    ScenePointer scene;
    StrategyRequest strategy;                     ///< `spherical` with its parameters
    size_t pose = 0;                              ///< of the paths of the cases
    std::optional<int> onlyCase{};                ///< of Figures 1, 3 and 4; none: 2 of Figures 1 and 3, all three of Figure 4
    std::optional<size_t> step{};                 ///< of Figure 1: how many of the frame's decisions have fallen; none: all
    double width = kFigureWidth;                  ///< of the page, in its units
    double scale = kFigurePixels / kFigureWidth;  ///< of the page, pixels a unit
};

/// What command line, dialog and report draw where nothing else is asked for.
[[nodiscard]] FigureRequest figureRequest(int number, ScenePointer scene);

struct Figure {
    Page page;
    ResultTable data;  ///< rays with their hits, the region's outline, its boxes, S of all bands and sectors; Figure 2: P, cells
};

/// Draws a figure. A current OpenGL context is needed. Throws Error(Usage) where the frame has nothing that the figure shows,
/// such as contour bands of an object that is not inside the frustum, Error(Interrupted) on a stop request.
[[nodiscard]] Figure figure(const FigureRequest& request, const PageLook& look, const Progress& progress = {});

}  // namespace cullscope::han_hong
