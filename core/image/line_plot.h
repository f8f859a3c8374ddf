#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace cullscope {

enum class PlotScale { Linear, Logarithmic };

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// Opacity, red, green and blue: 0xAARRGGBB. 0: nothing is painted.
using PlotColour = uint32_t;

enum class PlotStroke { Solid, Dashed, Dotted };

struct PlotPen {
    PlotColour colour = 0;
    double width = 1.0;  ///< pixels
    PlotStroke stroke = PlotStroke::Solid;
};

/// Names stand in the legend; what has none is not in it.
struct PlotLine {
    std::string name;
    std::vector<PlotPoint> points;
    bool baseline = false;                        ///< grey
    bool dashed = false;                          ///< tells lines of one colour apart
    std::optional<size_t> colour = std::nullopt;  ///< which of the palette's, from 0; none: by its place in the plot
    std::optional<PlotPen> pen = std::nullopt;    ///< in place of what the three above say
    bool dots = true;                             ///< at its points, where they are few
};

/// A horizontal line at a level that the plot's lines are compared with.
struct PlotReference {
    std::string name;  ///< its value is written behind it
    double y = 0.0;
};

/// Top and bottom: of a box among values the upper and the lower value, of one in pixels the upper and the lower edge.
struct PlotBox {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    /// Of one in pixels.
    [[nodiscard]] bool contains(const PlotPoint& point) const {
        return point.x >= left && point.x <= right && point.y >= top && point.y <= bottom;
    }
};

/// Filled areas of one meaning.
struct PlotBars {
    std::string name;
    PlotColour colour = 0;
    std::vector<PlotBox> boxes;
    std::vector<std::string> labels = {};  ///< by box: words behind its right end; empty: there are none
    bool within = false;                   ///< the words stand in the boxes' middles
};

enum class PlotShape { None, Disc, Square, Triangle };

/// Of marks that stand in the legend alone.
inline constexpr PlotPoint kNoPlace{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

/// A point by itself.
struct PlotMark {
    std::string name;
    PlotPoint at;
    PlotShape shape = PlotShape::None;
    PlotPen outline = {};
    PlotColour fill = 0;
    std::string label = {};  ///< beside it
    double size = 11.0;      ///< pixels
};

struct PlotTick {
    double value = 0.0;
    std::string label;
};

struct PlotAxis {
    std::string title;
    PlotScale scale = PlotScale::Linear;
    double least = 0.0, most = 0.0;  ///< shown at least, where one is below the other; else only round numbers around the values
    bool zero = false;               ///< 0 is shown too
    bool whole = false;              ///< ticks at whole numbers alone
    std::vector<PlotTick> ticks = {};  ///< in place of round numbers
};

/// Values over two axes, as plain data. Texts are shown as they are, or are English marked for translation.
struct LinePlot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotLine> lines;
    std::vector<PlotReference> references;
    std::vector<PlotBars> bars;
    std::vector<PlotMark> marks;
    double widest = 0.0;   ///< how many times its height it may be wide; 0: any
    Message heading = {};  ///< the title with its values apart, for who translates it; empty: the title has no values
};

/// A plot without lines, with two logarithmic axes.
[[nodiscard]] LinePlot logPlot(std::string title, std::string xTitle, std::string yTitle);

/// A line drawn by a pen of its own, without dots.
[[nodiscard]] PlotLine plainLine(std::string name, std::vector<PlotPoint> points, const PlotPen& pen);

/// What an axis shows: a range, never empty, and round numbers in it.
struct PlotRange {
    PlotScale scale = PlotScale::Linear;
    double first = 0.0, last = 1.0;
    std::vector<double> ticks;

    /// Whether the scale can show a value: a number, and above 0 on a logarithmic scale.
    [[nodiscard]] bool places(double value) const;
    /// As many of the round numbers as there is room for, two or more: rather a larger step, or powers of ten alone.
    [[nodiscard]] std::vector<double> fewTicks(size_t most) const;
    /// How far along the axis a value stands: 0 at the first, 1 at the last.
    [[nodiscard]] double share(double value) const;
};

/// The range along x or y that holds all lines, bars and marks (and along y the references). What has no place on the scale
/// counts for nothing.
[[nodiscard]] PlotRange rangeAlongX(const LinePlot& plot);
[[nodiscard]] PlotRange rangeAlongY(const LinePlot& plot);

/// The first of items and every n-th after it, with the least n that leaves at most that many.
template <typename Item>
[[nodiscard]] std::vector<Item> everyNth(const std::vector<Item>& items, size_t most) {
    std::vector<Item> kept;
    for (size_t i = 0; i < items.size(); i += (items.size() + most - 1) / most) kept.push_back(items[i]);
    return kept;
}

/// A line in pieces: it is broken where a point has no place on the scales.
[[nodiscard]] std::vector<std::vector<PlotPoint>> unbrokenPieces(const PlotLine& line, const PlotRange& x, const PlotRange& y);

/// A number at a tick or behind a reference's name: few digits, powers of ten far from 1 in the form 1e6.
[[nodiscard]] std::string plotNumber(double value);

/// The plots below each other as one SVG document on white, text as text.
[[nodiscard]] std::string linePlotsSvg(const std::vector<LinePlot>& plots);

/// The exponent of the power law y ~ x^k: the slope of the least-squares line through the logarithms. All values must be above 0.
[[nodiscard]] double exponentOf(const std::vector<PlotPoint>& points);

}  // namespace cullscope
