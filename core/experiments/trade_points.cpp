#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/experiments/trade_plot.h"
#include "core/measure/field_figures.h"
#include "core/visibility/strategy_request.h"

// The figures that may be axes, and the points that have them.
namespace cullscope {
namespace {

std::vector<TradeFigure> allFigures() {
    std::vector<TradeFigure> figures{
        {kUsualAcross, CULLSCOPE_TR("Speed against a baseline that draws the same sides"), 1.0, 2, false, false, false, true},
        {"ratio_to_all", CULLSCOPE_TR("Speed against drawing everything"), 1.0, 2, false, false, false, true},
        {"ratio_to_backface", CULLSCOPE_TR("Speed against drawing all front faces"), 1.0, 2, false, false, false, true},
        {"fps_overall", CULLSCOPE_TR("fps, all views"), 1.0, 1},
        {"fps_min", CULLSCOPE_TR("fps in the slowest view"), 1.0, 1},
        {"headroom_share", CULLSCOPE_TR("Share of the headroom, %"), 100.0, 0},
        {"culled_fraction", CULLSCOPE_TR("Culled triangles, %"), 100.0, 1},
        {"cull_share", CULLSCOPE_TR("Culling, % of the frame"), 100.0, 2, true},
        {"build_ms", CULLSCOPE_TR("Build time, ms"), 1.0, 1, true, true},
        {"structure_bytes", CULLSCOPE_TR("Structure, bytes"), 1.0, 0, true, true},
        {kUsualUp, CULLSCOPE_TR("Missed per million"), 1e6, 2, true, true, true},
        {"largest_hole_px", CULLSCOPE_TR("Largest hole, pixels"), 1.0, 0, true, true, true}};
    figures[0].brief = CULLSCOPE_TR("Speed, same sides");
    figures[1].brief = CULLSCOPE_TR("Speed, everything");
    figures[2].brief = CULLSCOPE_TR("Speed, front faces");
    for (const FieldFigure& field : fieldFigures()) {
        if (std::ranges::find(figures, field.key, &TradeFigure::key) != figures.end()) continue;
        const std::string_view key = field.key;
        const bool waste = key.find("false_positive") != std::string_view::npos;
        // A quantile of 0 leaves room for errors above it.
        const bool ofLoss = !waste && key.find("_p99") == std::string_view::npos;
        figures.push_back({field.key, field.title, field.scale, field.decimals + 1, true, !waste, ofLoss, false, field.meaning});
    }
    return figures;
}

Promise promiseFromId(const std::string& id) {
    for (const Promise promise : {Promise::Exact, Promise::Conservative})
        if (id == promiseId(promise)) return promise;
    return Promise::Approximate;
}

std::string wordsIn(const ResultTable& table, size_t row, const std::string& key) {
    const CellValue value = table.value(row, key);
    return std::holds_alternative<std::string>(value) ? std::get<std::string>(value) : std::string();
}

}  // namespace

const std::vector<TradeFigure>& tradeFigures() {
    static const std::vector<TradeFigure> kFigures = allFigures();
    return kFigures;
}

const TradeFigure& tradeFigure(std::string_view key) {
    const auto found = std::ranges::find(tradeFigures(), key, &TradeFigure::key);
    if (found != tradeFigures().end()) return *found;
    std::string known;
    for (const TradeFigure& figure : tradeFigures()) known += (known.empty() ? "" : ", ") + figure.key;
    throwUsage(CULLSCOPE_TR("There is no figure \"%1\"; there are %2."), {std::string(key), known});
}

const RatioEstimate* TradePoint::value(const TradeFigure& figure) const {
    const auto found = values.find(figure.key);
    return found == values.end() ? nullptr : &found->second;
}

bool TradePoint::lossless() const {
    const RatioEstimate* const lost = value(tradeFigure(kUsualUp));
    return lost != nullptr && lost->ratio == 0.0;
}

std::map<std::string, RatioEstimate> tradeValues(const Row& cells) {
    std::map<std::string, RatioEstimate> values;
    for (const TradeFigure& figure : tradeFigures()) {
        const auto cell = cells.find(figure.key);
        if (cell == cells.end()) continue;
        if (const auto* estimate = std::get_if<RatioEstimate>(&cell->second))
            values[figure.key] = *estimate;
        else if (const std::optional<double> number = numberOf(cell->second))
            values[figure.key] = {*number, {*number, *number}, false};
    }
    return values;
}

std::vector<TradePoint> tradePoints(const ResultTable& table) {
    std::vector<TradePoint> points;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        Row cells;
        for (size_t i = 0; i < table.columns.size(); ++i) cells[table.columns[i].key] = table.rows[row][i];
        TradePoint point;
        const std::string strategy = wordsIn(table, row, "strategy"), key = wordsIn(table, row, "parameter");
        StrategyRequest request = strategyFromText(strategy);
        point.role = findStrategy(request.id).info.baseline;
        if (key.empty()) {
            point.name = point.label = strategyLabel(request);
        } else {
            point.sweep = strategy + ", " + key;
            point.label = wordsIn(table, row, "value");
            request.parameters.setFromText(key, point.label);
            point.name = strategyLabel(request);
        }
        point.promise = promiseFromId(wordsIn(table, row, "promise"));
        point.views = size_t(numberOf(table.value(row, "poses")).value_or(0.0));
        point.values = tradeValues(cells);
        // Where the limit was not judged, as in older files: it draws what is visible.
        if (findStrategy(request.id).info.limit) point.values.try_emplace(kUsualUp, RatioEstimate{0.0, {0.0, 0.0}, false});
        points.push_back(std::move(point));
    }
    return points;
}

std::string tradeCsv(const std::vector<TradePoint>& points) {
    ResultTable table;
    table.columns = {{"strategy", "strategy"}, {"promise", "promise"}, {"views", "views"}};
    for (const TradeFigure& figure : tradeFigures())
        if (std::ranges::any_of(points, [&](const TradePoint& point) { return point.value(figure) != nullptr; }))
            table.columns.push_back({figure.key, figure.title});
    for (const TradePoint& point : points) {
        Row row{{"strategy", point.name}, {"promise", std::string(promiseId(point.promise))}, {"views", double(point.views)}};
        for (const auto& [key, value] : point.values) row[key] = value;
        table.addRow(row);
    }
    return rowsCsv(table);
}

}  // namespace cullscope
