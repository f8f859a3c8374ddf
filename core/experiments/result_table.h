#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/message.h"
#include "core/gpu/context.h"
#include "core/image/line_plot.h"
#include "core/measure/meter.h"
#include "core/measure/statistics.h"

namespace cullscope {

/// The value of a cell: none, a number, words (an id, or English marked for translation), or a ratio with its 95 % interval.
using CellValue = std::variant<std::monostate, double, std::string, RatioEstimate>;

/// Values of a row, by column.
using Row = std::map<std::string, CellValue>;
using Rows = std::vector<Row>;

struct ResultColumn {
    enum class Origin {
        Axis,     ///< what was set
        Stated,   ///< by the experiment's source, such as a paper
        Measured  ///< here
    };

    std::string key;    ///< field in JSON and CSV
    std::string title;  ///< English, marked for translation where it is shown in the desktop
    Origin origin = Origin::Measured;
    int decimals = 0;        ///< digits after the point on screen
    double scale = 1.0;      ///< factor of numbers on screen: 100 for a share in per cent
    bool filesOnly = false;  ///< not in tables as text, which have no room for it
    bool estimated = false;  ///< its values may have intervals: CSV has columns for them, whatever the rows are
};

/// A check of an experiment, held against its table.
struct CheckResult {
    std::string sentence;
    std::optional<double> value;  ///< none: the table has no rows that it speaks of
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();

    /// What has no value holds.
    [[nodiscard]] bool holds() const { return !value || (*value >= least && *value <= most); }
};

/// What an experiment measured, as plain data: beside what its source states, where it has one.
struct ResultTable {
    std::string experiment;  ///< id
    std::string title;       ///< English, marked for translation where it is shown in the desktop
    std::string source;
    std::vector<Message> notes;
    std::vector<ResultColumn> columns;
    std::vector<std::vector<CellValue>> rows;  ///< one value for each column
    std::vector<LinePlot> plots;
    std::vector<CheckResult> checks;          ///< of the rows so far
    std::string scene, sceneSha256;           ///< the newest scene measured; empty: none yet
    uint64_t triangles = 0;                   ///< of that scene
    GlInfo gl;                                ///< of what was drawn; empty where nothing was drawn
    std::vector<std::string> brokenPromises;  ///< strategies that promise to lose no pixel but lost some, each once
    bool interrupted = false;                 ///< stopped early: the table holds what was measured until then

    /// Appends a row; a value whose key no column has is dropped.
    void addRow(const Row& values);
    /// The value in a row and column; none where there is no such column.
    [[nodiscard]] CellValue value(size_t row, const std::string& key) const;
    /// Whether a check does not hold.
    [[nodiscard]] bool checkFailed() const;
};

/// A number, or a ratio without its interval; none of words and of no value.
[[nodiscard]] std::optional<double> numberOf(const CellValue& value);

/// A cell as text with the column's decimals and unit, without thousands separators; empty for no value. Words stay as they are.
[[nodiscard]] std::string valueText(const ResultColumn& column, const CellValue& value);

/// A check in one line: what it says, its value, its limits, and whether it holds.
[[nodiscard]] std::string checkText(const CheckResult& check);

/// Tables as JSON and as text with aligned columns, without plots; the rows of one as CSV (a header line; intervals in columns of
/// their own); and the same with each plot behind it, after an empty line, with one column for each of its lines.
[[nodiscard]] std::string tablesJson(const std::vector<ResultTable>& tables);
[[nodiscard]] std::string tableText(const ResultTable& table);
[[nodiscard]] std::string rowsCsv(const ResultTable& table);
[[nodiscard]] std::string tableCsv(const ResultTable& table);

}  // namespace cullscope
