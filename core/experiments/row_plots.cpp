#include "core/experiments/row_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cullscope {
namespace {

/// What rows have in columns, as words: rows with the same words are together.
using Words = std::vector<std::string>;

Words wordsOf(const ResultTable& table, size_t row, const std::vector<std::string>& columns) {
    Words words;
    for (const std::string& column : columns) {
        const CellValue value = table.value(row, column);
        const std::optional<double> number = numberOf(value);
        const auto* text = std::get_if<std::string>(&value);
        words.push_back(number ? plotNumber(*number) : text ? *text : std::string());
    }
    return words;
}

/// Those of the filtered rows, each once, in the rows' order.
std::vector<Words> differentWords(const ResultTable& table, const RowFilter& filter, const std::vector<std::string>& columns) {
    std::vector<Words> different;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        if (!passes(table, row, filter)) continue;
        Words words = wordsOf(table, row, columns);
        if (std::find(different.begin(), different.end(), words) == different.end()) different.push_back(std::move(words));
    }
    return different;
}

std::string lineName(const Words& group, const std::string& column) {
    std::string name;
    for (const std::string& word : group)
        if (!word.empty()) name += (name.empty() ? "" : ", ") + word;
    if (column.empty()) return name;
    return name.empty() ? column : name + ": " + column;
}

/// The rows of a filter whose words in both lists of columns are these.
ResultTable rowsWith(const RowPlot& described, const ResultTable& table, const Words& separate, const Words& group) {
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
void fillTitle(LinePlot& plot, const Words& values) {
    if (values.empty()) return;
    plot.heading = {plot.title, values};
    plot.title = plot.heading.english();
}

LinePlot plotOf(const RowPlot& described, const ResultTable& table, const Words& separate) {
    LinePlot plot = described.plot;
    fillTitle(plot, separate);
    for (const Words& group : differentWords(table, described.rows, described.lines)) {
        const ResultTable rows = rowsWith(described, table, separate, group);
        for (const RowPlot::Column& column : described.y) {
            PlotLine line{lineName(group, column.name), pointsOf(rows, {{}, described.x, column.key})};
            if (line.points.empty()) continue;
            if (described.byX) std::ranges::stable_sort(line.points, {}, &PlotPoint::x);
            if (described.namesExponents && line.points.size() > 1)
                line.name += fmt::format(": power {:.2f}", exponentOf(line.points));
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

std::vector<LinePlot> plotsOf(const RowPlot& described, const ResultTable& table) {
    std::vector<LinePlot> plots;
    for (const Words& separate : differentWords(table, described.rows, described.separate))
        plots.push_back(plotOf(described, table, separate));
    if (!plots.empty()) return plots;
    // Which values there will be is not known before the first row.
    plots.push_back(described.plot);
    fillTitle(plots.back(), Words(described.separate.size(), "…"));
    return plots;
}

}  // namespace cullscope
