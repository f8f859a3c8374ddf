#include "tests/benchmark/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace {

constexpr double kWidth = 900, kHeight = 480;
constexpr double kLeft = 80, kRight = 220, kTop = 40, kBottom = 50;
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#555555", "#a0761e"};

/// Whole decades that hold some values, as powers of ten.
struct Decades {
    double first = 1e300, last = -1e300;

    void add(double value) {
        first = std::min(first, std::floor(std::log10(value)));
        last = std::max(last, std::ceil(std::log10(value)));
    }
    [[nodiscard]] double share(double value) const { return (std::log10(value) - first) / (last - first); }
};

struct Axes {
    Decades x, y;
    double top = 0.0;

    [[nodiscard]] double px(double value) const { return kLeft + x.share(value) * (kWidth - kLeft - kRight); }
    [[nodiscard]] double py(double value) const { return top + kHeight - kBottom - y.share(value) * (kHeight - kTop - kBottom); }
};

void drawText(std::ostream& out, double x, double y, const std::string& words, const char* anchor) {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << words << "</text>\n";
}

void drawLine(std::ostream& out, double x1, double y1, double x2, double y2, const char* colour) {
    out << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2 << "\" stroke=\"" << colour
        << "\"/>\n";
}

void drawGrid(std::ostream& out, const Axes& axes, const LogPlot& plot) {
    const double right = kWidth - kRight, bottom = axes.top + kHeight - kBottom;
    for (double power = axes.x.first; power <= axes.x.last; ++power) {
        const double x = axes.px(std::pow(10.0, power));
        drawLine(out, x, axes.top + kTop, x, bottom, "#dddddd");
        drawText(out, x, bottom + 18, "1e" + std::to_string(int(power)), "middle");
    }
    for (double power = axes.y.first; power <= axes.y.last; ++power) {
        const double y = axes.py(std::pow(10.0, power));
        drawLine(out, kLeft, y, right, y, "#dddddd");
        drawText(out, kLeft - 6, y + 4, "1e" + std::to_string(int(power)), "end");
    }
    drawText(out, (kLeft + right) / 2, bottom + 38, plot.xTitle, "middle");
    drawText(out, kLeft - 6, axes.top + kTop - 12, plot.yTitle, "end");
    drawText(out, kLeft, axes.top + 20, plot.title, "start");
}

void drawCurve(std::ostream& out, const Axes& axes, const LogLine& line, size_t number) {
    const char* colour = kColours[number % kColours.size()];
    out << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << colour << "\" points=\"";
    for (const LogPoint& point : line.points) out << axes.px(point.size) << ',' << axes.py(point.value) << ' ';
    out << "\"/>\n";
    for (const LogPoint& point : line.points)
        out << "<circle cx=\"" << axes.px(point.size) << "\" cy=\"" << axes.py(point.value) << "\" r=\"3\" fill=\"" << colour
            << "\"/>\n";
    const double x = kWidth - kRight + 14, y = axes.top + kTop + 20 * double(number);
    drawLine(out, x, y, x + 18, y, colour);
    drawText(out, x + 24, y + 4, line.name, "start");
}

void drawPlot(std::ostream& out, const LogPlot& plot, double top) {
    Axes axes;
    axes.top = top;
    for (const LogLine& line : plot.lines)
        for (const LogPoint& point : line.points) {
            axes.x.add(point.size);
            axes.y.add(point.value);
        }
    drawGrid(out, axes, plot);
    for (size_t i = 0; i < plot.lines.size(); ++i) drawCurve(out, axes, plot.lines[i], i);
}

}  // namespace

std::string logPlotsSvg(const std::vector<LogPlot>& plots) {
    std::ostringstream out;
    const double height = kHeight * double(plots.size());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << kWidth << ' ' << height
        << "\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"" << kWidth << "\" height=\"" << height
        << "\" fill=\"#ffffff\"/>\n";
    for (size_t i = 0; i < plots.size(); ++i) drawPlot(out, plots[i], kHeight * double(i));
    out << "</svg>\n";
    return out.str();
}

double exponentOf(const std::vector<LogPoint>& points) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const LogPoint& point : points) {
        const double size = std::log(point.size), value = std::log(point.value);
        x += size;
        y += value;
        xx += size * size;
        xy += size * value;
    }
    const double n = double(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}
