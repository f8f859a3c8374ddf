#include "core/experiments/reproduction_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"

namespace cullscope {
namespace {

/// A table of more columns does not fit a sheet of paper at the size of the others.
constexpr size_t kManyColumns = 20;

/// Letters as large as a projector needs, and columns that a sheet of paper holds. A table that is wider than the text takes the
/// window's width; one that is wider than that is scrolled, and on paper it is printed smaller.
constexpr const char* kReportStyle = R"(
:root { color-scheme: light; }
body { font: 18px/1.5 "Noto Sans", "DejaVu Sans", sans-serif; color: #14171c; background: #fff; margin: 0 auto; padding: 24px;
    max-width: 1500px; }
h1 { font-size: 34px; line-height: 1.2; margin: 0 0 8px; }
h2 { font-size: 26px; line-height: 1.25; margin: 48px 0 4px; border-top: 2px solid #14171c; padding-top: 16px; }
p, ul { margin: 8px 0; }
.source { color: #3c4450; margin-top: 0; }
.wide { overflow-x: auto; width: max-content; min-width: 100%; max-width: calc(100vw - 64px); margin-left: 50%;
    transform: translateX(-50%); }
table { border-collapse: collapse; font-size: 16px; line-height: 1.35; margin: 12px 0; font-variant-numeric: tabular-nums; }
th, td { padding: 4px 10px; border-bottom: 1px solid #c8ccd0; text-align: right; vertical-align: top; }
td { white-space: nowrap; }
th { border-bottom: 2px solid #14171c; vertical-align: bottom; }
.machine th { border-bottom: 1px solid #c8ccd0; vertical-align: top; }
.words { text-align: left; }
td.words { white-space: normal; min-width: 6em; max-width: 28em; }
.stated { background: #f3ecd4; }
tr.origins th { border-bottom: 0; font-weight: 400; color: #3c4450; padding-bottom: 0; }
figure { margin: 16px 0; }
figure img { max-width: 100%; height: auto; display: block; }
pre { background: #f1f3f5; padding: 8px 12px; font: 15px/1.4 "DejaVu Sans Mono", monospace; white-space: pre-wrap;
    overflow-wrap: anywhere; margin: 8px 0 16px; }
.failed { font-weight: 700; }
.failed::before { content: "\2717\00a0"; }
.held::before { content: "\2713\00a0"; }
nav ul { columns: 2; }
nav a { color: inherit; }
@media print {
    @page { size: A4 landscape; margin: 12mm; }
    body { font-size: 10.5pt; max-width: none; padding: 0; }
    h1 { font-size: 20pt; } h2 { font-size: 14pt; margin-top: 18pt; break-after: avoid; } h2 + p { break-after: avoid; }
    .wide { overflow: visible; width: auto; min-width: 0; max-width: none; margin-left: 0; transform: none; }
    table { font-size: 7.5pt; } th, td { padding: 1.5pt 4pt; } thead { display: table-header-group; } tr { break-inside: avoid; }
    table.many { font-size: 6pt; } .many th, .many td { padding: 1pt 2pt; }
    td { white-space: normal; } td.words { min-width: 0; }
    pre { font-size: 8pt; break-inside: avoid; break-before: avoid; }
    figure { break-inside: avoid; } figure img { max-height: 120mm; margin: 0 auto; }
    .stated, pre { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : terminalText(text)) switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            case '\n':
                html += "<br>";
                break;
            default:
                html += c;
        }
    return html;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t j = 0; j < 3; ++j) three = (three << 8) | (i + j < bytes.size() ? uint8_t(bytes[i + j]) : 0u);
        for (size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? kDigits[(three >> (18 - 6 * j)) & 63] : '=';
    }
    return text;
}

/// As a picture of its own, so that names within one plot do not meet those of another.
std::string picture(const std::string& svg, const std::string& title) {
    return fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">", escaped(title), base64(svg));
}

/// Whether a column has words; numbers stand under each other at their right end.
bool hasWords(const ResultTable& table, size_t column) {
    return std::ranges::any_of(
        table.rows, [&](const std::vector<CellValue>& row) { return std::holds_alternative<std::string>(row[column]); });
}

/// Whether a row has a value in the column; those of another experiment's form are left out.
bool used(const ResultTable& table, size_t column) {
    return std::ranges::any_of(
        table.rows, [&](const std::vector<CellValue>& row) { return !std::holds_alternative<std::monostate>(row[column]); });
}

const char* originWord(ResultColumn::Origin origin) {
    switch (origin) {
        case ResultColumn::Origin::Stated:
            return "source";
        case ResultColumn::Origin::Measured:
            return "here";
        case ResultColumn::Origin::Axis:
            break;
    }
    return "";
}

std::string classesOf(const ResultTable& table, size_t column) {
    std::string classes = hasWords(table, column) ? "words" : "";
    if (table.columns[column].origin == ResultColumn::Origin::Stated) classes += classes.empty() ? "stated" : " stated";
    return classes.empty() ? "" : " class=\"" + classes + "\"";
}

/// The text of a cell. An interval in brackets stays on one line.
std::string cellHtml(std::string_view text) {
    std::string html;
    bool inBrackets = false;
    for (const char c : escaped(text)) {
        if (c == '[' || c == ']') inBrackets = c == '[';
        if (c == ' ' && inBrackets)
            html += "&nbsp;";
        else
            html += c;
    }
    return html;
}

std::string rowsHtml(const ResultTable& table) {
    if (table.rows.empty()) return "<p>Nothing of it was measured.</p>\n";
    std::vector<size_t> columns;
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (used(table, i)) columns.push_back(i);
    std::string html = fmt::format("<div class=\"wide\"><table{}>\n<thead><tr class=\"origins\">",
                                   columns.size() > kManyColumns ? " class=\"many\"" : "");
    for (const size_t i : columns) html += fmt::format("<th{}>{}</th>", classesOf(table, i), originWord(table.columns[i].origin));
    html += "</tr>\n<tr>";
    for (const size_t i : columns) html += fmt::format("<th{}>{}</th>", classesOf(table, i), cellHtml(table.columns[i].title));
    html += "</tr></thead>\n<tbody>\n";
    for (const std::vector<CellValue>& row : table.rows) {
        html += "<tr>";
        for (const size_t i : columns)
            html += fmt::format("<td{}>{}</td>", classesOf(table, i), cellHtml(valueText(table.columns[i], row[i])));
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string commandHtml(const std::string& command) { return "<pre>" + escaped(command) + "</pre>\n"; }

std::string anchor(const std::string& id) { return "t-" + escaped(id); }

std::string tableHtml(const ReportedTable& reported) {
    const ResultTable& table = reported.table;
    std::string html = fmt::format("<section>\n<h2 id=\"{}\">{}</h2>\n", anchor(table.experiment), escaped(table.title));
    if (!table.source.empty()) html += fmt::format("<p class=\"source\">{}</p>\n", escaped(table.source));
    if (table.interrupted) html += "<p><strong>Stopped early:</strong> what was measured until then.</p>\n";
    html += rowsHtml(table) + commandHtml(reported.command);
    for (const LinePlot& plot : table.plots)
        html += fmt::format("<figure>{}</figure>\n{}", picture(linePlotsSvg({plot}), plot.title),
                            commandHtml(reported.command + " --svg " + table.experiment + ".svg"));
    if (!table.checks.empty()) {
        html += "<ul>\n";
        for (const CheckResult& check : table.checks)
            html += fmt::format("<li class=\"{}\">{}</li>\n", check.holds() ? "held" : "failed", escaped(checkText(check)));
        html += "</ul>\n";
    }
    for (const std::string& strategy : table.brokenPromises)
        html += fmt::format("<p class=\"failed\">{} promises to lose no pixel and lost some.</p>\n", escaped(strategy));
    if (!table.notes.empty()) {
        html += "<ul>\n";
        for (const Message& note : table.notes) html += "<li>" + escaped(note.english()) + "</li>\n";
        html += "</ul>\n";
    }
    if (!table.scene.empty())
        html += fmt::format("<p class=\"source\">Scene: {}, {} triangles{}</p>\n", escaped(table.scene), table.triangles,
                            table.sceneSha256.empty() ? "" : ", SHA-256 " + table.sceneSha256.substr(0, 16) + "…");
    return html + "</section>\n";
}

std::string machineHtml(const ReproductionReport& report) {
    std::string html = "<table class=\"machine\">\n";
    const auto row = [&](const char* name, const std::string& value) {
        if (!value.empty())
            html += fmt::format("<tr><th class=\"words\">{}</th><td class=\"words\">{}</td></tr>\n", name, escaped(value));
    };
    GlInfo gl;
    for (const ReportedTable& each : report.tables)
        if (!each.table.gl.renderer.empty()) gl = each.table.gl;
    row("Measured", report.started);
    row("Program", fmt::format("{} {} ({})", toolVersion().name, toolVersion().version, toolVersion().commit));
    row("Processor", cpuName());
    row("OpenGL", gl.renderer.empty() ? "" : gl.renderer + ", " + gl.version);
    if (gl.software) row("", "A software OpenGL: its times are not those of a graphics card.");
    return html + "</table>\n";
}

}  // namespace

std::string reproductionHtml(const ReproductionReport& report) {
    const char* const title = "Cullscope: tables and figures of the sources, reproduced";
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
        title, kReportStyle, title);
    if (!report.complete) html += "<p><strong>Not complete:</strong> it was stopped, or is still being measured.</p>\n";
    html += machineHtml(report) + commandHtml(report.command);
    html +=
        "<p>Columns under <em>source</em>, shaded, are what the source states; those under <em>here</em> were measured on this "
        "machine. Ratios have their 95 % intervals in brackets. Under each table and figure stands the command that repeats "
        "it.</p>\n<nav><ul>\n";
    for (const ReportedTable& each : report.tables)
        html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor(each.table.experiment), escaped(each.table.title));
    for (size_t i = 0; i < report.figures.size(); ++i)
        html += fmt::format("<li><a href=\"#f-{}\">{}</a></li>\n", i, escaped(report.figures[i].title));
    html += "</ul></nav>\n";
    for (const Message& each : report.missing) html += fmt::format("<p class=\"failed\">{}</p>\n", escaped(each.english()));
    for (const ReportedTable& each : report.tables) html += tableHtml(each);
    for (size_t i = 0; i < report.figures.size(); ++i) {
        const ReportedFigure& figure = report.figures[i];
        html += fmt::format("<section>\n<h2 id=\"f-{}\">{}</h2>\n<p class=\"source\">{}</p>\n<figure>{}</figure>\n{}</section>\n",
                            i, escaped(figure.title), escaped(figure.source), picture(figure.svg, figure.title),
                            commandHtml(figure.command));
    }
    return html + "</body>\n</html>\n";
}

}  // namespace cullscope
