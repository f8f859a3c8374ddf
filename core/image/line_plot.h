#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cullscope {

enum class PlotScale { Linear, Logarithmic };

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

struct PlotLine {
    std::string name;
    std::vector<PlotPoint> points;
    bool baseline = false;                        ///< grey
    bool dashed = false;                          ///< distinguishes lines of the same colour
    std::optional<size_t> colour = std::nullopt;  ///< index into the palette; none: by the line's place in the plot
};

/// A horizontal line at a level that the plot's lines are compared with.
struct PlotReference {
    std::string name;  ///< its value is written behind it
    double y = 0.0;
};

struct PlotAxis {
    std::string title;
    PlotScale scale = PlotScale::Linear;
    double least = 0.0, most = 0.0;  ///< the range shown, where least < most; else the range of the values, rounded outward
};

/// Lines over two axes, as plain data. Texts are shown unchanged, or are English marked for translation.
struct LinePlot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotLine> lines;
    std::vector<PlotReference> references;
};

/// A plot without lines, with two logarithmic axes.
[[nodiscard]] LinePlot logPlot(std::string title, std::string xTitle, std::string yTitle);

/// The range of an axis, never empty, and the round numbers in it.
struct PlotRange {
    PlotScale scale = PlotScale::Linear;
    double first = 0.0, last = 1.0;
    std::vector<double> ticks;

    /// Whether the scale can show a value: a number, and above 0 on a logarithmic scale.
    [[nodiscard]] bool places(double value) const;
    /// The position of a value along the axis: 0 at the first end, 1 at the last.
    [[nodiscard]] double share(double value) const;
};

/// The range along x or y that contains all lines (and along y the references). Values that the scale cannot show are ignored.
[[nodiscard]] PlotRange rangeAlongX(const LinePlot& plot);
[[nodiscard]] PlotRange rangeAlongY(const LinePlot& plot);

/// A line in pieces: it is interrupted at every point that the scales cannot show.
[[nodiscard]] std::vector<std::vector<PlotPoint>> unbrokenPieces(const PlotLine& line, const PlotRange& x, const PlotRange& y);

/// A number at a tick or behind a reference's name: few digits, powers of ten far from 1 in the form 1e6.
[[nodiscard]] std::string plotNumber(double value);

/// The plots below each other as one SVG document; text is kept as text.
[[nodiscard]] std::string linePlotsSvg(const std::vector<LinePlot>& plots);

/// The exponent of the power law y ~ x^k: the slope of the least-squares line through the logarithms. All values must be above 0.
[[nodiscard]] double exponentOf(const std::vector<PlotPoint>& points);

}  // namespace cullscope
