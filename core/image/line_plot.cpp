#include "core/image/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cullscope {
namespace {

constexpr double kStepTolerance = 1e-9;    // share of a step: tolerance for the rounding of its multiples
constexpr double kLinearSteps = 5.0;       // at least, along a linear axis
constexpr double kManyDecades = 3.0;       // above this an axis shows whole decades
constexpr double kLeastPlainPower = 1e-3;  // powers of ten below and above these are written 1eN
constexpr double kMostPlainPower = 1e4;

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `value`, or the largest that is at most
/// `value`.
double roundUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= value * (1.0 - kStepTolerance)) return factor * power;
    return 10.0 * power;
}
double roundDown(double value) { return 1.0 / roundUp(1.0 / value); }

/// Round numbers from `first` to `last`, both above 0.
std::vector<double> logarithmicTicks(double first, double last) {
    const bool decadesOnly = std::log10(last / first) > kManyDecades + kStepTolerance;
    std::vector<double> ticks;
    for (double power = std::floor(std::log10(first) + kStepTolerance); power <= std::log10(last) + kStepTolerance; ++power)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * std::pow(10.0, power);
            const bool inside = tick >= first * (1.0 - kStepTolerance) && tick <= last * (1.0 + kStepTolerance);
            if (inside && (factor == 1.0 || !decadesOnly)) ticks.push_back(tick);
        }
    return ticks;
}

void finishLogarithmic(PlotRange& range, bool given) {
    if (!given) {
        range.first = roundDown(range.first);
        range.last = roundUp(range.last);
        if (std::log10(range.last / range.first) > kManyDecades + kStepTolerance) {
            range.first = std::pow(10.0, std::floor(std::log10(range.first) + kStepTolerance));
            range.last = std::pow(10.0, std::ceil(std::log10(range.last) - kStepTolerance));
        }
    }
    if (range.last <= range.first) range.last = roundUp(range.first * 1.5);
    range.ticks = logarithmicTicks(range.first, range.last);
}

/// Multiples of a step from `first` to `last`.
std::vector<double> linearTicks(double first, double last, double step) {
    std::vector<double> ticks;
    for (double number = std::ceil(first / step - kStepTolerance); number * step <= last + kStepTolerance * step; ++number)
        ticks.push_back(number * step);
    return ticks;
}

void finishLinear(PlotRange& range, bool given) {
    if (range.last <= range.first) range.last = range.first + std::max(1.0, std::abs(range.first));
    const double step = roundDown((range.last - range.first) / kLinearSteps);
    if (!given) {
        range.first = std::floor(range.first / step + kStepTolerance) * step;
        range.last = std::ceil(range.last / step - kStepTolerance) * step;
    }
    range.ticks = linearTicks(range.first, range.last, step);
}

PlotRange rangeOf(const PlotAxis& axis, std::vector<double> values) {
    PlotRange range;
    range.scale = axis.scale;
    const bool given = axis.least < axis.most;
    if (given) values.insert(values.end(), {axis.least, axis.most});
    if (axis.zero) values.push_back(0.0);
    std::erase_if(values, [&](double value) { return !range.places(value); });
    if (values.empty()) values = {1.0, 10.0};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    range.first = *least;
    range.last = *most;
    axis.scale == PlotScale::Logarithmic ? finishLogarithmic(range, given) : finishLinear(range, given);
    if (axis.whole) std::erase_if(range.ticks, [](double tick) { return std::abs(tick - std::round(tick)) > kStepTolerance; });
    return range;
}

/// What lines, bars and marks have along an axis.
std::vector<double> valuesOf(const LinePlot& plot, double PlotPoint::*along, double PlotBox::*from, double PlotBox::*to) {
    std::vector<double> values;
    for (const PlotLine& line : plot.lines)
        for (const PlotPoint& point : line.points) values.push_back(point.*along);
    for (const PlotBars& bars : plot.bars)
        for (const PlotBox& box : bars.boxes) values.insert(values.end(), {box.*from, box.*to});
    for (const PlotMark& mark : plot.marks) values.push_back(mark.at.*along);
    return values;
}

}  // namespace

LinePlot logPlot(std::string title, std::string xTitle, std::string yTitle) {
    LinePlot plot;
    plot.title = std::move(title);
    plot.x = {std::move(xTitle), PlotScale::Logarithmic};
    plot.y = {std::move(yTitle), PlotScale::Logarithmic};
    return plot;
}

PlotLine plainLine(std::string name, std::vector<PlotPoint> points, const PlotPen& pen) {
    PlotLine line{std::move(name), std::move(points)};
    line.pen = pen;
    line.dots = false;
    return line;
}

bool PlotRange::places(double value) const { return std::isfinite(value) && (scale == PlotScale::Linear || value > 0.0); }

double PlotRange::share(double value) const {
    if (scale == PlotScale::Linear) return (value - first) / (last - first);
    return std::log(value / first) / std::log(last / first);
}

std::vector<double> PlotRange::fewTicks(size_t most) const {
    std::vector<double> few = ticks;
    if (few.size() <= most) return few;
    if (scale == PlotScale::Linear) {
        few = linearTicks(first, last, roundUp((last - first) / double(most - 1)));
        // A single number would be no scale.
        if (few.size() < 2 && most >= 2) few = everyNth(linearTicks(first, last, roundDown(last - first)), most);
        return few;
    }
    std::erase_if(few, [](double tick) { return std::abs(std::log10(tick) - std::round(std::log10(tick))) > kStepTolerance; });
    return everyNth(few, most);
}

PlotRange rangeAlongX(const LinePlot& plot) {
    return rangeOf(plot.x, valuesOf(plot, &PlotPoint::x, &PlotBox::left, &PlotBox::right));
}

PlotRange rangeAlongY(const LinePlot& plot) {
    std::vector<double> values = valuesOf(plot, &PlotPoint::y, &PlotBox::top, &PlotBox::bottom);
    for (const PlotReference& reference : plot.references) values.push_back(reference.y);
    return rangeOf(plot.y, std::move(values));
}

std::vector<std::vector<PlotPoint>> unbrokenPieces(const PlotLine& line, const PlotRange& x, const PlotRange& y) {
    std::vector<std::vector<PlotPoint>> pieces(1);
    for (const PlotPoint& point : line.points) {
        if (x.places(point.x) && y.places(point.y))
            pieces.back().push_back(point);
        else if (!pieces.back().empty())
            pieces.emplace_back();
    }
    if (pieces.back().empty()) pieces.pop_back();
    return pieces;
}

std::string plotNumber(double value) {
    const double power = value > 0.0 ? std::round(std::log10(value)) : 0.0;
    const bool powerOfTen = value > 0.0 && std::abs(value / std::pow(10.0, power) - 1.0) < kStepTolerance;
    if (powerOfTen && (value < kLeastPlainPower * (1.0 - kStepTolerance) || value > kMostPlainPower * (1.0 + kStepTolerance)))
        return fmt::format("1e{:.0f}", power);
    // Six digits hide the rounding of a step's multiples.
    std::string text = fmt::format("{:.6g}", value == 0.0 ? 0.0 : value);
    const size_t exponent = text.find('e');
    if (exponent == std::string::npos) return text;
    // As powers of ten are written: 2e6 and 2e-7.
    return fmt::format("{}e{}", text.substr(0, exponent), std::stoi(text.substr(exponent + 1)));
}

double exponentOf(const std::vector<PlotPoint>& points) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const PlotPoint& point : points) {
        const double size = std::log(point.x), value = std::log(point.y);
        x += size;
        y += value;
        xx += size * size;
        xy += size * value;
    }
    const double n = double(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace cullscope
