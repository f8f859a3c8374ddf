#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/experiments/result_table.h"

namespace cullscope {

/// Rows of a table by their values: a row is among them where each of these columns has one of the values.
using RowFilter = std::map<std::string, std::vector<CellValue>>;
[[nodiscard]] bool passes(const ResultTable& table, size_t row, const RowFilter& filter);

/// The numbers of two columns as points, in the rows' order; rows without both numbers, or beyond the range of x, have none.
struct RowPoints {
    RowFilter rows;
    std::string x, y;  ///< columns
    double leastX = -std::numeric_limits<double>::infinity(), mostX = std::numeric_limits<double>::infinity();
};
[[nodiscard]] std::vector<PlotPoint> pointsOf(const ResultTable& table, const RowPoints& which);

/// A plot of an experiment, as data: which columns of its table it shows.
struct RowPlot {
    struct Column {
        std::string key;
        std::string name{};  ///< of its lines, behind what they are grouped by
    };
    /// A line that grows with a power of x from the first point of the plot's first line on.
    struct Power {
        std::string name;
        double exponent = 1.0;
    };

    LinePlot plot;                        ///< title, axes, reference levels; without lines
    std::string x{};                      ///< column
    std::vector<Column> y{};              ///< a line of each; none: the experiment draws the plot from single frames
    std::vector<std::string> lines{};     ///< columns: rows with the same values there are one line
    RowFilter rows{};                     ///< the rows shown
    std::vector<std::string> separate{};  ///< columns: a plot for each of their values, which take the title's places %1, %2, …
    std::vector<Power> powers{};
    /// Coloured cells over two columns in place of lines: x, and this one upward; each has the value of `y`'s one column, written
    /// in it. Empty: lines.
    std::string cellsOver{};
    double scale = 1.0;           ///< of what is written in cells
    int decimals = 2;             ///< likewise
    bool namesExponents = false;  ///< a line's name ends with the exponent of its power law
    bool byX = false;             ///< a line's points are in the order of x, not of the rows
    bool zeros = false;           ///< zeros have a place on the logarithmic y axis: a decade below the rest, with the label 0

    [[nodiscard]] bool ofFrames() const { return y.empty(); }
};

/// A plot of a column over another one, with a line for each value of `lines`, in the order of x.
[[nodiscard]] RowPlot linesOf(LinePlot plot, const char* x, const char* y, const char* lines);

/// The plots of the table's rows; one without lines where there are no rows yet.
[[nodiscard]] std::vector<LinePlot> plotsOf(const RowPlot& described, const ResultTable& table);

}  // namespace cullscope
