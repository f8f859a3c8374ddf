#include <fmt/format.h>

#include "core/base/terminal_text.h"
#include "core/image/drawing_svg.h"

namespace cullscope {
namespace {

constexpr double kLetter = 0.62;  // of an em, a letter's width in common fonts
constexpr PlotColour kOpaque = 0xFF000000;

/// Letters are not measured here: the viewer of a file chooses its font.
double widthOf(const std::string& words) {
    double width = 0.0;
    for (const char byte : words) {
        const auto value = static_cast<unsigned char>(byte);
        const bool continues = (value & 0xC0) == 0x80, square = value >= 0xE2;
        width += continues ? 0.0 : kPlotLetters * (square ? 1.0 : kLetter);
    }
    return width;
}

/// XML has no control characters.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : terminalLine(text)) {
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

/// An attribute of a colour, with its opacity where it has one.
std::string colourText(const char* attribute, PlotColour colour) {
    if (colour == 0) return fmt::format(" {}=\"none\"", attribute);
    std::string text = fmt::format(" {}=\"#{:06x}\"", attribute, colour & ~kOpaque);
    if (colour < kOpaque) text += fmt::format(" {}-opacity=\"{:.2f}\"", attribute, double(colour >> 24) / 255.0);
    return text;
}

std::string paintText(const PlotPen& pen, PlotColour fill) {
    std::string text = colourText("fill", fill);
    if (pen.colour == 0) return text;
    text += colourText("stroke", pen.colour) + fmt::format(" stroke-width=\"{}\"", pen.width);
    if (pen.stroke != PlotStroke::Solid) text += fmt::format(" stroke-dasharray=\"{}\"", fmt::join(dashesOf(pen.stroke), " "));
    return text;
}

std::string element(const DrawnPath& path) {
    std::string points;
    for (const PlotPoint& point : path.points) points += fmt::format("{:.6g},{:.6g} ", point.x, point.y);
    return fmt::format("<polyline{} points=\"{}\"/>\n", paintText(path.pen, path.fill), points);
}

std::string element(const DrawnDisc& disc) {
    return fmt::format("<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{}\"{}/>\n", disc.centre.x, disc.centre.y, disc.radius,
                       paintText(disc.pen, disc.fill));
}

std::string element(const DrawnText& text) {
    const char* anchor = text.anchor == TextAnchor::Start ? "start" : text.anchor == TextAnchor::Middle ? "middle" : "end";
    return fmt::format("<text x=\"{:.6g}\" y=\"{:.6g}\" text-anchor=\"{}\"{}{}>{}</text>\n", text.at.x, text.at.y, anchor,
                       colourText("fill", text.colour), text.bold ? " font-weight=\"bold\"" : "", escaped(text.words));
}

}  // namespace

PlotStyle svgStyle() {
    PlotStyle style;
    style.series = plotSeries(false);
    style.ascent = kPlotLetters;
    style.height = 1.3 * kPlotLetters;
    style.width = widthOf;
    style.number = plotNumber;
    return style;
}

std::string svgBeginning(double width, double height, PlotColour ground) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.6g} {1:.6g}\" font-family=\"sans-serif\" "
        "font-size=\"{2}\">\n"
        "<rect width=\"{0:.6g}\" height=\"{1:.6g}\"{3}/>\n",
        width, height, kPlotLetters, colourText("fill", ground));
}

std::string svgElements(const PlotDrawing& drawing) {
    std::string text;
    for (const auto& item : drawing.items) text += std::visit([](const auto& drawn) { return element(drawn); }, item);
    return text;
}

}  // namespace cullscope
