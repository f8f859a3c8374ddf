#pragma once

#include <functional>

#include "core/experiments/row_plots.h"

namespace cullscope {

/// What must hold of an experiment's table: a value of it lies within limits. Where both limits are infinite, the value is only
/// told.
struct Check {
    std::string sentence;                                                  ///< names the value
    std::function<std::optional<double>(const ResultTable& table)> value;  ///< none: the table has no rows that it speaks of
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

struct CheckLimits {
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

/// The exponent of the power law y ~ x^k over the points. It needs two points or more; their values must be above 0.
[[nodiscard]] Check exponentCheck(std::string sentence, RowPoints points, CheckLimits limits = {});
/// A column's number in every one of the rows; the value is the one that is farthest from holding.
[[nodiscard]] Check everyRowCheck(std::string sentence, RowFilter rows, std::string column, CheckLimits limits);

/// The checks held against a table.
[[nodiscard]] std::vector<CheckResult> checked(const std::vector<Check>& checks, const ResultTable& table);

}  // namespace cullscope
