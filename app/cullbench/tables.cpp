#include "app/cullbench/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/image/page.h"

namespace cullscope::cullbench {
namespace {

/// The options whose file is standard output.
std::vector<std::string> onStandardOutput(const TableFiles& files) {
    std::vector<std::string> options;
    if (files.json == "-") options.emplace_back("--json");
    if (files.csv == "-") options.emplace_back("--csv");
    if (files.svg == "-") options.emplace_back("--svg");
    if (files.png == "-") options.emplace_back("--png");
    return options;
}

std::vector<LinePlot> plotsOf(const std::vector<ResultTable>& tables) {
    std::vector<LinePlot> plots;
    for (const ResultTable& table : tables) plots.insert(plots.end(), table.plots.begin(), table.plots.end());
    return plots;
}

}  // namespace

void checkTableFiles(const TableFiles& files, const std::vector<std::string>& others, const std::string& store) {
    if (const std::vector<std::string> options = onStandardOutput(files); options.size() > 1)
        throwUsage(CULLSCOPE_TR("%1 and %2 cannot both go to standard output: name a file for one of them."),
                   {options[0], options[1]});
    std::vector<std::string> all{files.json, files.csv, files.svg, files.png};
    all.insert(all.end(), others.begin(), others.end());
    checkOutputPlaces(all, store);
    if (!files.png.empty()) requirePictureFormat(files.png);
}

FILE* tableOutput(const TableFiles& files) { return onStandardOutput(files).empty() ? stdout : stderr; }

void writeTables(const TableFiles& files, const std::vector<ResultTable>& tables) {
    const bool nothing = std::ranges::all_of(tables, [](const ResultTable& table) { return table.rows.empty(); });
    if (nothing && tables.back().interrupted) throwNothingMeasured();
    std::optional<Error> failure;
    const auto writeTo = [&](const std::string& path, const auto& textOf) {
        if (path.empty()) return;
        try {
            writeText(path, textOf());
        } catch (const Error& error) {
            failure = error;
        }
    };
    writeTo(files.json, [&] { return tablesJson(tables); });
    writeTo(files.csv, [&] { return rowsCsv(tables.front()); });
    if (const std::vector<LinePlot> plots = plotsOf(tables); !plots.empty())
        writeTo(files.svg, [&] { return linePlotsSvg(plots); });
    if (const std::vector<LinePlot> plots = plotsOf(tables); !plots.empty() && !files.png.empty()) {
        const Letters letters(kPlotLetters);
        try {
            writePicture(files.png, pagePicture(linePlotsPage(plots, pageStyle(letters)), letters));
        } catch (const Error& error) {
            failure = error;
        }
    }
    if (failure) throw *failure;
}

int tableStatus(const std::vector<ResultTable>& tables) {
    int status = 0;
    for (const ResultTable& table : tables)
        for (const std::string& strategy : table.brokenPromises) {
            say(stderr, "cullbench: {}: {} promises to lose no pixel and lost some\n", table.experiment, strategy);
            status = 1;
        }
    for (const ResultTable& table : tables)
        if (table.checkFailed()) {
            say(stderr, "cullbench: {}: a check does not hold\n", table.experiment);
            status = 1;
        }
    return tables.back().interrupted ? static_cast<int>(ErrorKind::Interrupted) : status;
}

}  // namespace cullscope::cullbench
