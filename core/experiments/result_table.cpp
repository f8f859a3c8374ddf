#include "core/experiments/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"
#include "core/measure/statistics.h"

namespace cullscope {
namespace {

/// As in files of all versions.
const char* originId(ResultColumn::Origin origin) {
    if (origin == ResultColumn::Origin::Axis) return "setting";
    return origin == ResultColumn::Origin::Stated ? "paper" : "measured";
}

std::string numberText(const ResultColumn& column, double number) {
    return fmt::format("{:.{}f}", number * column.scale, column.decimals);
}

Json rowJson(const ResultTable& table, const std::vector<CellValue>& row) {
    Json json = Json::object();
    for (size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& key = table.columns[i].key;
        json[key] = nullptr;
        if (const auto* number = std::get_if<double>(&row[i])) json[key] = *number;
        if (const auto* words = std::get_if<std::string>(&row[i])) json[key] = *words;
        if (const auto* estimate = std::get_if<RatioEstimate>(&row[i])) {
            json[key] = estimate->ratio;
            json[key + "_ci95"] = estimate->hasInterval ? Json(estimate->ci95) : Json(nullptr);
        }
    }
    return json;
}

Json axisJson(const PlotAxis& axis) {
    return {{"title", axis.title}, {"scale", axis.scale == PlotScale::Linear ? "linear" : "logarithmic"}};
}

Json plotJson(const LinePlot& plot) {
    Json json{{"title", plot.title},
              {"x", axisJson(plot.x)},
              {"y", axisJson(plot.y)},
              {"lines", Json::array()},
              {"references", Json::array()}};
    for (const PlotLine& line : plot.lines) {
        Json points = Json::array();
        for (const PlotPoint& point : line.points) points.push_back({{"x", point.x}, {"y", point.y}});
        json["lines"].push_back({{"name", line.name}, {"points", std::move(points)}});
    }
    for (const PlotReference& reference : plot.references)
        json["references"].push_back({{"name", reference.name}, {"y", reference.y}});
    return json;
}

Json checkJson(const CheckResult& check) {
    const auto limit = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
    return {{"check", check.sentence},
            {"value", check.value ? Json(*check.value) : Json(nullptr)},
            {"least", limit(check.least)},
            {"most", limit(check.most)},
            {"holds", check.holds()}};
}

Json tableJson(const ResultTable& table) {
    Json json{{"experiment", table.experiment},
              {"title", table.title},
              {"source", table.source},
              {"scene", {{"name", table.scene}, {"sha256", table.sceneSha256}, {"triangles", table.triangles}}},
              {"interrupted", table.interrupted},
              {"broken_promises", table.brokenPromises},
              {"notes", Json::array()},
              {"columns", Json::array()},
              {"rows", Json::array()},
              {"plots", Json::array()}};
    for (const Message& note : table.notes) json["notes"].push_back(note.english());
    for (const ResultColumn& column : table.columns)
        json["columns"].push_back({{"key", column.key}, {"title", column.title}, {"from", originId(column.origin)}});
    for (const std::vector<CellValue>& row : table.rows) json["rows"].push_back(rowJson(table, row));
    for (const LinePlot& plot : table.plots) json["plots"].push_back(plotJson(plot));
    for (const CheckResult& check : table.checks) json["checks"].push_back(checkJson(check));
    return json;
}

/// Whether any row of the column has a confidence interval.
bool hasIntervals(const ResultTable& table, size_t column) {
    return table.columns[column].estimated ||
           std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const std::vector<CellValue>& row) { return std::holds_alternative<RatioEstimate>(row[column]); });
}

std::string csvText(const CellValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    if (const auto* estimate = std::get_if<RatioEstimate>(&value)) return fmt::format("{}", estimate->ratio);
    const auto* words = std::get_if<std::string>(&value);
    if (!words) return "";
    if (words->find_first_of(",\"\n") == std::string::npos) return *words;
    std::string quoted = "\"";
    for (const char letter : *words) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

/// CSV with one row for each x and one column for each line.
std::string plotCsv(const LinePlot& plot) {
    std::string csv = csvText(plot.x.title);
    std::set<double> places;
    for (const PlotLine& line : plot.lines) {
        csv += "," + csvText(line.name + ": " + plot.y.title);
        for (const PlotPoint& point : line.points) places.insert(point.x);
    }
    csv += '\n';
    for (const double x : places) {
        csv += fmt::format("{}", x);
        for (const PlotLine& line : plot.lines) {
            const auto at = std::find_if(line.points.begin(), line.points.end(), [x](const PlotPoint& p) { return p.x == x; });
            csv += at == line.points.end() ? std::string(",") : fmt::format(",{}", at->y);
        }
        csv += '\n';
    }
    return csv;
}

/// The width of UTF-8 text in characters of a monospaced font.
size_t width(const std::string& text) {
    return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, size_t wide, bool left) {
    const std::string space(wide > width(text) ? wide - width(text) : 0, ' ');
    return left ? text + space : space + text;
}

}  // namespace

void ResultTable::addRow(const Row& values) {
    std::vector<CellValue> row;
    for (const ResultColumn& column : columns) {
        const auto value = values.find(column.key);
        row.push_back(value == values.end() ? CellValue() : value->second);
    }
    rows.push_back(std::move(row));
}

CellValue ResultTable::value(size_t row, const std::string& key) const {
    for (size_t i = 0; i < columns.size(); ++i)
        if (columns[i].key == key) return rows[row][i];
    return {};
}

bool ResultTable::checkFailed() const {
    return std::any_of(checks.begin(), checks.end(), [](const CheckResult& check) { return !check.holds(); });
}

std::optional<double> numberOf(const CellValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* estimate = std::get_if<RatioEstimate>(&value)) return estimate->ratio;
    return std::nullopt;
}

std::string valueText(const ResultColumn& column, const CellValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return numberText(column, *number);
    if (const auto* words = std::get_if<std::string>(&value)) return terminalLine(*words);
    if (const auto* estimate = std::get_if<RatioEstimate>(&value)) {
        if (!estimate->hasInterval) return numberText(column, estimate->ratio);
        return numberText(column, estimate->ratio) + " [" + numberText(column, estimate->ci95[0]) + ", " +
               numberText(column, estimate->ci95[1]) + "]";
    }
    return "";
}

std::string tablesJson(const std::vector<ResultTable>& tables) {
    const ToolVersion tool = toolVersion();
    Json json{{"tool", {{"name", tool.name}, {"version", tool.version}, {"commit", tool.commit}}},
              {"machine", {{"cpu", cpuName()}}},
              {"experiments", Json::array()}};
    for (const ResultTable& table : tables) {
        if (!table.gl.renderer.empty()) {
            json["machine"]["gl_renderer"] = table.gl.renderer;
            json["machine"]["gl_version"] = table.gl.version;
            json["machine"]["gl_software"] = table.gl.software;
        }
        json["experiments"].push_back(tableJson(table));
    }
    return plainJson(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string rowsCsv(const ResultTable& table) {
    std::string csv;
    std::vector<bool> withIntervals(table.columns.size());
    for (size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& key = table.columns[i].key;
        csv += (i > 0 ? "," : "") + key;
        withIntervals[i] = hasIntervals(table, i);
        if (withIntervals[i]) csv += "," + key + "_low," + key + "_high";
    }
    csv += '\n';
    for (const std::vector<CellValue>& row : table.rows) {
        for (size_t i = 0; i < row.size(); ++i) {
            csv += (i > 0 ? "," : "") + csvText(row[i]);
            if (!withIntervals[i]) continue;
            const auto* estimate = std::get_if<RatioEstimate>(&row[i]);
            const bool known = estimate != nullptr && estimate->hasInterval;
            csv += known ? fmt::format(",{},{}", estimate->ci95[0], estimate->ci95[1]) : std::string(",,");
        }
        csv += '\n';
    }
    return terminalText(csv);
}

std::string tableCsv(const ResultTable& table) {
    std::string csv = rowsCsv(table);
    for (const LinePlot& plot : table.plots) csv += "\n" + terminalText(plotCsv(plot));
    return csv;
}

std::string checkText(const CheckResult& check) {
    std::string limits;
    if (std::isfinite(check.least)) limits += fmt::format("at least {:g}", check.least);
    if (std::isfinite(check.most)) limits += fmt::format("{}at most {:g}", limits.empty() ? "" : ", ", check.most);
    const std::string value = check.value ? fmt::format("{:.3g}", *check.value) : std::string("not measured");
    const std::string text = check.sentence + ": " + value + (limits.empty() ? "" : " (" + limits + ")");
    return check.holds() ? text : text + ", DOES NOT HOLD";
}

std::string tableText(const ResultTable& table) {
    std::vector<size_t> widths;
    for (size_t i = 0; i < table.columns.size(); ++i) {
        widths.push_back(width(table.columns[i].title));
        for (const auto& row : table.rows) widths[i] = std::max(widths[i], width(valueText(table.columns[i], row[i])));
    }
    const auto line = [&](const auto& textOf) {
        std::string text;
        for (size_t i = 0; i < table.columns.size(); ++i)
            if (!table.columns[i].filesOnly)
                text += (i > 0 ? "  " : "") + padded(textOf(i), widths[i], table.columns[i].origin == ResultColumn::Origin::Axis);
        return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
    };
    std::string text = table.experiment + ": " + table.title + "\n";
    if (!table.source.empty()) text += table.source + "\n";
    if (table.triangles > 0) text += fmt::format("{}: {} triangles\n", terminalLine(table.scene), table.triangles);
    if (!table.gl.renderer.empty())
        text += table.gl.renderer + (table.gl.software ? " (software OpenGL: times are not a GPU's)\n" : "\n");
    text += line([&](size_t i) { return table.columns[i].title; });
    for (const auto& row : table.rows) text += line([&](size_t i) { return valueText(table.columns[i], row[i]); });
    for (const Message& note : table.notes) text += "- " + terminalLine(note.english()) + "\n";
    for (const CheckResult& check : table.checks) text += checkText(check) + "\n";
    return text;
}

}  // namespace cullscope
