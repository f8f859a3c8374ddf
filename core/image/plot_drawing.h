#pragma once

#include <functional>
#include <span>
#include <variant>

#include "core/image/line_plot.h"

namespace cullscope {

/// Plots as what is drawn of them: laid out once, in pixels from the upper left corner, for windows and files alike.

struct DrawnPath {
    std::vector<PlotPoint> points;
    PlotPen pen = {};
    PlotColour fill = 0;  ///< of the area that it goes around
};

struct DrawnDisc {
    PlotPoint centre;
    double radius = 0.0;
    PlotPen pen = {};
    PlotColour fill = 0;
};

enum class TextAnchor { Start, Middle, End };

struct DrawnText {
    PlotPoint at;  ///< on the letters' base line
    std::string words;
    PlotColour colour = 0;
    TextAnchor anchor = TextAnchor::Start;
    bool bold = false;
};

/// Where a plot's values stand.
struct PlotPlace {
    PlotBox box;
    PlotRange x, y;

    [[nodiscard]] PlotPoint pixel(const PlotPoint& value) const;
};

struct PlotDrawing {
    std::vector<std::variant<DrawnPath, DrawnDisc, DrawnText>> items;  ///< a later one over the earlier ones
    std::vector<PlotPlace> places;                                     ///< of each plot
};

/// Colours and letters.
struct PlotStyle {
    PlotColour text = 0xFF222222, faint = 0xFF666666, grid = 0xFFDDDDDD;
    std::span<const PlotColour> series;
    double ascent = 0.0, height = 0.0;                      ///< of a line of text, pixels
    std::function<double(const std::string& words)> width;  ///< pixels
    std::function<std::string(double value)> number;        ///< at a tick or behind a reference
};

/// Words in lines of a width, broken at spaces and before Chinese characters, which no spaces divide.
[[nodiscard]] std::vector<std::string> linesOf(const std::string& words, double width, const PlotStyle& style);

/// Colours of lines, told apart in the common deficiencies of colour vision, with a contrast of at least 3 : 1 to the ground.
[[nodiscard]] std::span<const PlotColour> plotSeries(bool dark);

/// Everything that is drawn at another place.
void moveBy(PlotDrawing& drawing, const PlotPoint& by);
/// Everything that is drawn, larger about the upper left corner; letters are those of the style that it was laid out with.
void scaleBy(PlotDrawing& drawing, double scale);

/// The size of a plot in a file, pixels.
inline constexpr double kPlotWidth = 960.0, kPlotHeight = 480.0;
/// Of the letters (em) in such a file, pixels.
inline constexpr double kPlotLetters = 13.0;

/// Draws plots beside each other, below each other where there is little width, with the first one's legend for all of them:
/// beside them where they are wide, else below. No text is cut. One plot at least.
[[nodiscard]] PlotDrawing drawPlots(const std::vector<LinePlot>& plots, double width, double height, const PlotStyle& style);
/// The height that they need in a width.
[[nodiscard]] double neededHeight(const std::vector<LinePlot>& plots, double width, const PlotStyle& style);

/// The lengths of strokes and gaps, pixels; empty: no gaps.
[[nodiscard]] std::vector<double> dashesOf(PlotStroke stroke);

}  // namespace cullscope
