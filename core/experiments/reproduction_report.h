#pragma once

#include <string>
#include <vector>

#include "core/experiments/result_table.h"

namespace cullscope {

/// A figure of a source, drawn here.
struct ReportedFigure {
    std::string title, source;
    std::string svg;
    std::string command;  ///< that draws it
};

/// A table of a source, measured here.
struct ReportedTable {
    ResultTable table;
    std::string command;  ///< that repeats it
};

struct ReproductionReport {
    std::vector<ReportedTable> tables;
    std::vector<ReportedFigure> figures;
    std::vector<Message> missing;  ///< what could not be measured or drawn, and why
    std::string started;           ///< when, as the reader is to see it
    std::string command;           ///< that made it
    bool complete = true;          ///< false: it is still measured, or was stopped
};

/// The report as one HTML page, which needs nothing beside it: plots and figures stand in it. What a source states and what was
/// measured are told apart by the heads of their columns. For paper, the screen and a projector.
[[nodiscard]] std::string reproductionHtml(const ReproductionReport& report);

}  // namespace cullscope
