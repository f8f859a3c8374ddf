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
    bool dashed = false;                          ///< tells lines of one colour apart
    std::optional<size_t> colour = std::nullopt;  ///< which of the palette's, from 0; none: by its place in the plot
};

/// A level that lines are compared with.
struct PlotReference {
    std::string name;  ///< its number is written behind it
    double y = 0.0;
};

struct PlotAxis {
    std::string title;
    PlotScale scale = PlotScale::Linear;
    double least = 0.0, most = 0.0;  ///< shown at least, where one is below the other; else only round numbers around the values
};

/// Lines over two axes, as plain data. Texts are shown as they are, or are English marked for translation.
struct LinePlot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotLine> lines;
    std::vector<PlotReference> references;
};

/// Without lines, both axes logarithmic.
[[nodiscard]] LinePlot logPlot(std::string title, std::string xTitle, std::string yTitle);

/// What an axis shows: a range, never empty, and round numbers in it.
struct PlotRange {
    PlotScale scale = PlotScale::Linear;
    double first = 0.0, last = 1.0;
    std::vector<double> ticks;

    /// Whether a value has a place on the scale: it is a number, on a logarithmic one above 0.
    [[nodiscard]] bool places(double value) const;
    /// How far along the axis a value stands: 0 at the first, 1 at the last.
    [[nodiscard]] double share(double value) const;
};

/// The range along x or y that holds all lines (and along y the references). What has no place on the scale counts for nothing.
[[nodiscard]] PlotRange rangeAlongX(const LinePlot& plot);
[[nodiscard]] PlotRange rangeAlongY(const LinePlot& plot);

/// A line in pieces: it is broken where a point has no place on the scales.
[[nodiscard]] std::vector<std::vector<PlotPoint>> unbrokenPieces(const PlotLine& line, const PlotRange& x, const PlotRange& y);

/// A number at a tick or behind a reference's name: few digits, powers of ten far from 1 as in 1e6.
[[nodiscard]] std::string plotNumber(double value);

/// The plots below each other as one SVG document, text as text.
[[nodiscard]] std::string linePlotsSvg(const std::vector<LinePlot>& plots);

/// The power of x with which y grows: the slope of the least-squares line through the logarithms. All values above 0.
[[nodiscard]] double exponentOf(const std::vector<PlotPoint>& points);

}  // namespace cullscope
