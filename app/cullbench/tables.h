#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "core/experiments/result_table.h"

namespace cullscope::cullbench {

/// The files that tables of experiments are written to; empty: none. - is standard output.
struct TableFiles {
    std::string json, csv, svg, png;
};

/// Throws Error(Usage) where two of them are standard output, or as checkOutputPlaces of them and `others` does.
void checkTableFiles(const TableFiles& files, const std::vector<std::string>& others = {}, const std::string& store = {});

/// Where the tables are printed: standard error where standard output carries a file.
[[nodiscard]] FILE* tableOutput(const TableFiles& files);

/// Writes JSON and plots of all tables, and the rows of the first as CSV. Every file is tried, so that one that cannot be written
/// does not cost the others. Throws Error(Interrupted), and writes none, where a stop came before the first row.
void writeTables(const TableFiles& files, const std::vector<ResultTable>& tables);

/// The command's exit status; what was broken is printed on standard error.
[[nodiscard]] int tableStatus(const std::vector<ResultTable>& tables);

}  // namespace cullscope::cullbench
