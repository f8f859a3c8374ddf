#pragma once

#include <map>
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
using PaperValue = std::variant<std::monostate, double, std::string, RatioEstimate>;

struct PaperColumn {
    enum class Origin { Setting, Paper, Measured };

    std::string key;    ///< field in JSON and CSV
    std::string title;  ///< English, marked for translation
    Origin origin = Origin::Measured;
    int decimals = 0;    ///< digits after the point on screen
    double scale = 1.0;  ///< factor of numbers on screen: 100 for a share in per cent
};

/// A table of a paper and the same quantities measured here, as plain data.
struct PaperTable {
    std::string experiment;  ///< id
    std::string title;       ///< English, marked for translation
    std::string source;
    std::vector<Message> notes;
    std::vector<PaperColumn> columns;
    std::vector<std::vector<PaperValue>> rows;  ///< one value for each column
    std::vector<LinePlot> plots;                ///< the paper's figures
    std::string scene, sceneSha256;             ///< the newest scene measured; empty: none yet
    uint64_t triangles = 0;
    GlInfo gl;                                ///< of the timed runs; empty where nothing was timed
    std::vector<std::string> brokenPromises;  ///< strategies that promise to lose no pixel but lost some, each once
    bool interrupted = false;                 ///< stopped early: the table holds what was measured until then

    /// Appends a row; a value whose key no column has is dropped.
    void addRow(const std::map<std::string, PaperValue>& values);
};

/// A cell as text with the column's decimals and unit, without thousands separators; empty for no value. Words stay as they are.
[[nodiscard]] std::string paperText(const PaperColumn& column, const PaperValue& value);

/// Tables as JSON, as CSV (a header line; intervals in columns of their own; each plot after an empty line, with one column for
/// each of its lines) and as text with aligned columns, without plots.
[[nodiscard]] std::string paperTablesJson(const std::vector<PaperTable>& tables);
[[nodiscard]] std::string paperTableCsv(const PaperTable& table);
[[nodiscard]] std::string paperTableText(const PaperTable& table);

}  // namespace cullscope
