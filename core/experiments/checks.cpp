#include "core/experiments/checks.h"

#include <algorithm>
#include <cmath>

namespace cullscope {

Check exponentCheck(std::string sentence, RowPoints points, CheckLimits limits) {
    const auto value = [points = std::move(points)](const ResultTable& table) -> std::optional<double> {
        const std::vector<PlotPoint> found = pointsOf(table, points);
        if (found.size() < 2) return std::nullopt;
        return exponentOf(found);
    };
    return {std::move(sentence), value, limits.least, limits.most};
}

Check everyRowCheck(std::string sentence, RowFilter rows, std::string column, CheckLimits limits) {
    const auto value = [rows = std::move(rows), column = std::move(column), limits](const ResultTable& table) {
        /// How far a value is beyond the nearer limit; below 0 within the limits.
        const auto beyond = [&](double number) { return std::max(limits.least - number, number - limits.most); };
        std::optional<double> worst;
        for (size_t row = 0; row < table.rows.size(); ++row) {
            if (!passes(table, row, rows)) continue;
            const std::optional<double> number = numberOf(table.value(row, column));
            if (number && std::isnan(*number)) return number;
            if (number && (!worst || beyond(*number) > beyond(*worst))) worst = number;
        }
        return worst;
    };
    return {std::move(sentence), value, limits.least, limits.most};
}

std::vector<CheckResult> checked(const std::vector<Check>& checks, const ResultTable& table) {
    std::vector<CheckResult> results;
    for (const Check& check : checks) results.push_back({check.sentence, check.value(table), check.least, check.most});
    return results;
}

}  // namespace cullscope
