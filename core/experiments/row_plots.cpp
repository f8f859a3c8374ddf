#include "core/experiments/row_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/image/cell_map_picture.h"

namespace cullscope {
namespace {

constexpr size_t kSteps = 8;  ///< colours of cells

/// What rows have in columns, as words: rows with the same words are together.
using RowWords = std::vector<std::string>;

RowWords wordsOf(const ResultTable& table, size_t row, const std::vector<std::string>& columns) {
    RowWords words;
    for (const std::string& column : columns) {
        const CellValue value = table.value(row, column);
        const std::optional<double> number = numberOf(value);
        const auto* text = std::get_if<std::string>(&value);
        words.push_back(number ? plotNumber(*number) : text ? *text : std::string());
    }
    return words;
}

/// Those of the filtered rows, each once, in the rows' order.
std::vector<RowWords> differentWords(const ResultTable& table, const RowFilter& filter, const std::vector<std::string>& columns) {
    std::vector<RowWords> different;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        if (!passes(table, row, filter)) continue;
        RowWords words = wordsOf(table, row, columns);
        if (std::find(different.begin(), different.end(), words) == different.end()) different.push_back(std::move(words));
    }
    return different;
}

std::string lineName(const RowWords& group, const std::string& column) {
    std::string name;
    for (const std::string& word : group)
        if (!word.empty()) name += (name.empty() ? "" : ", ") + word;
    if (column.empty()) return name;
    return name.empty() ? column : name + ": " + column;
}

/// The rows of a filter whose words in both lists of columns are these.
ResultTable rowsWith(const RowPlot& described, const ResultTable& table, const RowWords& separate, const RowWords& group) {
    ResultTable chosen;
    chosen.columns = table.columns;
    for (size_t row = 0; row < table.rows.size(); ++row)
        if (passes(table, row, described.rows) && wordsOf(table, row, described.separate) == separate &&
            wordsOf(table, row, described.lines) == group)
            chosen.rows.push_back(table.rows[row]);
    return chosen;
}

void addPowers(LinePlot& plot, const std::vector<RowPlot::Power>& powers) {
    if (plot.lines.empty() || plot.lines.front().points.empty()) return;
    const std::vector<PlotPoint> from = plot.lines.front().points;
    for (const RowPlot::Power& power : powers) {
        PlotLine line{power.name, {}};
        for (const PlotPoint& point : from)
            line.points.push_back({point.x, from.front().y * std::pow(point.x / from.front().x, power.exponent)});
        plot.lines.push_back(std::move(line));
    }
}

/// Places zeros a decade below the least value, where the axis says 0.
void placeZeros(LinePlot& plot) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    bool zeros = false;
    for (const PlotLine& line : plot.lines)
        for (const PlotPoint& point : line.points) {
            zeros = zeros || point.y == 0.0;
            if (point.y > 0.0) least = std::min(least, point.y);
            most = std::max(most, point.y);
        }
    if (!zeros) return;
    if (most == 0.0) least = most = 1.0;
    const int first = int(std::floor(std::log10(least))), last = int(std::ceil(std::log10(most)));
    plot.y.least = std::pow(10.0, first - 1);
    plot.y.most = std::pow(10.0, std::max(last, first));
    plot.y.ticks = {{plot.y.least, "0"}};
    for (int power = first; power <= std::max(last, first); ++power)
        plot.y.ticks.push_back({std::pow(10.0, power), plotNumber(std::pow(10.0, power))});
    for (PlotLine& line : plot.lines)
        for (PlotPoint& point : line.points)
            if (point.y == 0.0) point.y = plot.y.least;
}

/// Puts values into the places %1, %2, … of the title.
void fillTitle(LinePlot& plot, const RowWords& values) {
    if (values.empty()) return;
    plot.heading = {plot.title, values};
    plot.title = plot.heading.english();
}

/// The different numbers of a column in ascending order.
std::vector<double> numbersOf(const ResultTable& table, const RowFilter& filter, const std::string& column) {
    std::set<double> numbers;
    for (size_t row = 0; row < table.rows.size(); ++row)
        if (const std::optional<double> number = numberOf(table.value(row, column)); number && passes(table, row, filter))
            numbers.insert(*number);
    return {numbers.begin(), numbers.end()};
}

/// An axis with a place of equal width for each number.
void setPlaces(PlotAxis& axis, const std::vector<double>& numbers) {
    axis.least = 0.0;
    axis.most = double(numbers.size());
    axis.ticks.clear();
    for (size_t i = 0; i < numbers.size(); ++i) axis.ticks.push_back({double(i) + 0.5, plotNumber(numbers[i])});
}

/// Cells in the colours of equal steps between the least and the largest value.
void addCells(LinePlot& plot, const RowPlot& described, const ResultTable& table) {
    const std::vector<double> across = numbersOf(table, described.rows, described.x);
    const std::vector<double> up = numbersOf(table, described.rows, described.cellsOver);
    const std::string& column = described.y.front().key;
    const std::vector<double> values = numbersOf(table, described.rows, column);
    setPlaces(plot.x, across);
    setPlaces(plot.y, up);
    if (values.empty()) return;
    const double least = values.front(), step = (values.back() - least) / double(kSteps);
    const auto written = [&](double value) { return fmt::format("{:.{}f}", value * described.scale, described.decimals); };
    for (size_t i = 0; i < kSteps && (i == 0 || step > 0.0); ++i) {
        PlotBars bars;
        const Vec3f colour = 255.0f * rampColour(double(i) / double(kSteps - 1), Vec3f(1.0f));
        bars.colour = 0xFF000000 | PlotColour(colour.x) << 16 | PlotColour(colour.y) << 8 | PlotColour(colour.z);
        bars.name = written(least + double(i) * step);
        if (step > 0.0) bars.name += " – " + written(least + double(i + 1) * step);
        bars.within = true;
        plot.bars.push_back(std::move(bars));
    }
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const std::optional<double> x = numberOf(table.value(row, described.x)),
                                    y = numberOf(table.value(row, described.cellsOver));
        const std::optional<double> value = numberOf(table.value(row, column));
        if (!x || !y || !value || !passes(table, row, described.rows)) continue;
        const double left = double(std::ranges::lower_bound(across, *x) - across.begin());
        const double bottom = double(std::ranges::lower_bound(up, *y) - up.begin());
        const size_t bucket = step > 0.0 ? std::min(size_t((*value - least) / step), kSteps - 1) : 0;
        plot.bars[bucket].boxes.push_back({left, bottom + 1.0, left + 1.0, bottom});
        plot.bars[bucket].labels.push_back(written(*value));
    }
}

LinePlot plotOf(const RowPlot& described, const ResultTable& table, const RowWords& separate) {
    LinePlot plot = described.plot;
    fillTitle(plot, separate);
    if (!described.cellsOver.empty()) {
        addCells(plot, described, table);
        return plot;
    }
    for (const RowWords& group : differentWords(table, described.rows, described.lines)) {
        const ResultTable rows = rowsWith(described, table, separate, group);
        for (const RowPlot::Column& column : described.y) {
            PlotLine line{lineName(group, column.name), pointsOf(rows, {{}, described.x, column.key})};
            if (line.points.empty()) continue;
            if (described.byX) std::ranges::stable_sort(line.points, {}, &PlotPoint::x);
            if (described.namesExponents && line.points.size() > 1)
                // Zero has no sign: a line that does not grow is named "0.00".
                line.name += fmt::format(": power {:.2f}", std::round(100.0 * exponentOf(line.points)) / 100.0 + 0.0);
            plot.lines.push_back(std::move(line));
        }
    }
    addPowers(plot, described.powers);
    if (described.zeros) placeZeros(plot);
    return plot;
}

}  // namespace

bool passes(const ResultTable& table, size_t row, const RowFilter& filter) {
    return std::all_of(filter.begin(), filter.end(), [&](const auto& wanted) {
        return std::find(wanted.second.begin(), wanted.second.end(), table.value(row, wanted.first)) != wanted.second.end();
    });
}

std::vector<PlotPoint> pointsOf(const ResultTable& table, const RowPoints& which) {
    std::vector<PlotPoint> points;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        if (!passes(table, row, which.rows)) continue;
        const std::optional<double> x = numberOf(table.value(row, which.x)), y = numberOf(table.value(row, which.y));
        if (x && y && *x >= which.leastX && *x <= which.mostX) points.push_back({*x, *y});
    }
    return points;
}

RowPlot linesOf(LinePlot plot, const char* x, const char* y, const char* lines) {
    RowPlot described{std::move(plot)};
    described.x = x;
    described.y = {{y}};
    described.lines = {lines};
    described.byX = true;
    return described;
}

std::vector<LinePlot> plotsOf(const RowPlot& described, const ResultTable& table) {
    std::vector<LinePlot> plots;
    for (const RowWords& separate : differentWords(table, described.rows, described.separate))
        plots.push_back(plotOf(described, table, separate));
    if (!plots.empty()) return plots;
    // Which values there will be is not known before the first row.
    plots.push_back(described.plot);
    fillTitle(plots.back(), RowWords(described.separate.size(), "…"));
    return plots;
}

}  // namespace cullscope
