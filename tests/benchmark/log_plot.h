#pragma once

#include <string>
#include <vector>

/// A value over a size, both above 0.
struct LogPoint {
    double size = 0.0;
    double value = 0.0;
};

struct LogLine {
    std::string name;
    std::vector<LogPoint> points;
};

/// Lines over logarithmic axes.
struct LogPlot {
    std::string title, xTitle, yTitle;
    std::vector<LogLine> lines;
};

/// The plots below each other as one SVG document, text as text.
[[nodiscard]] std::string logPlotsSvg(const std::vector<LogPlot>& plots);

/// The power of the size with which the values grow: the slope of the least-squares line through the logarithms.
[[nodiscard]] double exponentOf(const std::vector<LogPoint>& points);
