#include <algorithm>
#include <array>
#include <sstream>

#include "core/image/line_plot.h"

namespace cullscope {
namespace {

constexpr double kWidth = 960, kHeight = 480;
constexpr double kLeft = 80, kRight = 280, kTop = 60, kBottom = 56;
constexpr double kLegendRow = 20;
constexpr double kLegend = 44;  // distance from the plot: the references' numbers stand between
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#6a3d9a", "#a0761e"};
constexpr const char* kBaseline = "#555555";
constexpr const char* kGrid = "#dddddd";
constexpr const char* kText = "#222222";
constexpr const char* kReference = "#777777";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

/// Maps values of one plot to positions in the document.
struct Place {
    PlotRange x, y;
    double top = 0.0;

    static constexpr double kRightEnd = kWidth - kRight;
    [[nodiscard]] double bottom() const { return top + kHeight - kBottom; }
    [[nodiscard]] double px(double value) const { return kLeft + x.share(value) * (kRightEnd - kLeft); }
    [[nodiscard]] double py(double value) const { return bottom() - y.share(value) * (kHeight - kTop - kBottom); }
};

void drawText(std::ostream& out, double x, double y, const std::string& words, const char* more) {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" " << more << '>' << escaped(words) << "</text>\n";
}

void drawLine(std::ostream& out, double x1, double y1, double x2, double y2, const std::string& stroke) {
    out << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2 << "\" " << stroke << "/>\n";
}

std::string strokeOf(const char* colour, double width, bool dashed) {
    std::ostringstream out;
    out << "stroke=\"" << colour << "\" stroke-width=\"" << width << '"' << (dashed ? " stroke-dasharray=\"7 4\"" : "");
    return out.str();
}

void drawGrid(std::ostream& out, const Place& place, const LinePlot& plot) {
    const std::string grid = strokeOf(kGrid, 1.0, false);
    for (const double tick : place.x.ticks) {
        drawLine(out, place.px(tick), place.top + kTop, place.px(tick), place.bottom(), grid);
        drawText(out, place.px(tick), place.bottom() + 18, plotNumber(tick), "text-anchor=\"middle\"");
    }
    for (const double tick : place.y.ticks) {
        drawLine(out, kLeft, place.py(tick), Place::kRightEnd, place.py(tick), grid);
        drawText(out, kLeft - 6, place.py(tick) + 4, plotNumber(tick), "text-anchor=\"end\"");
    }
    drawText(out, (kLeft + Place::kRightEnd) / 2, place.bottom() + 40, plot.x.title, "text-anchor=\"middle\"");
    drawText(out, kLeft - 50, place.top + kTop - 14, plot.y.title, "text-anchor=\"start\"");
    drawText(out, kLeft - 50, place.top + 22, plot.title, "text-anchor=\"start\" font-size=\"16\" font-weight=\"bold\"");
}

/// A row of the legend: a piece of the line, and its name.
void drawLegendRow(std::ostream& out, const Place& place, size_t row, const std::string& stroke, const std::string& words) {
    const double x = Place::kRightEnd + kLegend, y = place.top + kTop + 6 + kLegendRow * double(row);
    drawLine(out, x, y, x + 26, y, stroke);
    drawText(out, x + 32, y + 4, words, "text-anchor=\"start\"");
}

/// Thin horizontal lines, with their values behind them and their names in the legend below those of the curves.
void drawReferences(std::ostream& out, const Place& place, const LinePlot& plot) {
    const std::string stroke = strokeOf(kReference, 1.4, false) + " stroke-dasharray=\"2 3\"";
    size_t row = plot.lines.size();
    for (const PlotReference& reference : plot.references) {
        if (!place.y.places(reference.y)) continue;
        const double y = place.py(reference.y);
        drawLine(out, kLeft, y, Place::kRightEnd, y, stroke);
        drawText(out, Place::kRightEnd + 6, y + 4, plotNumber(reference.y), "font-style=\"italic\"");
        drawLegendRow(out, place, row++, stroke, reference.name + " " + plotNumber(reference.y));
    }
}

void drawCurve(std::ostream& out, const Place& place, const PlotLine& line, size_t number) {
    const char* colour = line.baseline ? kBaseline : kColours[line.colour.value_or(number) % kColours.size()];
    for (const std::vector<PlotPoint>& piece : unbrokenPieces(line, place.x, place.y)) {
        out << "<polyline fill=\"none\" " << strokeOf(colour, 2.0, line.dashed) << " points=\"";
        for (const PlotPoint& point : piece) out << place.px(point.x) << ',' << place.py(point.y) << ' ';
        out << "\"/>\n";
        for (const PlotPoint& point : piece)
            out << "<circle cx=\"" << place.px(point.x) << "\" cy=\"" << place.py(point.y) << "\" r=\"2.5\" fill=\"" << colour
                << "\"/>\n";
    }
    drawLegendRow(out, place, number, strokeOf(colour, 2.5, line.dashed), line.name);
}

}  // namespace

std::string linePlotsSvg(const std::vector<LinePlot>& plots) {
    std::ostringstream out;
    const double height = kHeight * double(plots.size());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << kWidth << ' ' << height
        << "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"" << kText << "\">\n<rect width=\"" << kWidth << "\" height=\""
        << height << "\" fill=\"#ffffff\"/>\n";
    for (size_t i = 0; i < plots.size(); ++i) {
        const Place place{rangeAlongX(plots[i]), rangeAlongY(plots[i]), kHeight * double(i)};
        drawGrid(out, place, plots[i]);
        drawReferences(out, place, plots[i]);
        for (size_t line = 0; line < plots[i].lines.size(); ++line) drawCurve(out, place, plots[i].lines[line], line);
    }
    out << "</svg>\n";
    return out.str();
}

}  // namespace cullscope
