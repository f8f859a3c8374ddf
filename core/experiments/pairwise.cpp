#include "core/experiments/pairwise.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

RatioEstimate differenceOver(const RunMeasurement& one, const RunMeasurement& other) {
    std::vector<double> differences;
    for (size_t i = 0; i < std::min(one.frames.size(), other.frames.size()); ++i)
        differences.push_back(other.frames[i].frameMilliseconds - one.frames[i].frameMilliseconds);
    return meanOfRatios(differences);  // a mean with a bootstrap over the views
}

double lostPerMillion(const RunMeasurement& run) {
    double lost = 0.0, covered = 0.0;
    for (const FrameMeasurement& frame : run.frames) {
        lost += double(frame.lostPixels);
        covered += frame.accuracy ? double(frame.accuracy->coveredPixels) : 0.0;
    }
    return covered > 0.0 ? 1e6 * lost / covered : 0.0;
}

std::vector<size_t> measuredRuns(const MeasureResult& result) {
    std::vector<size_t> runs;
    for (size_t i = 0; i < result.runs.size(); ++i)
        if (!result.runs[i].frames.empty()) runs.push_back(i);
    return runs;
}

}  // namespace

std::vector<PairOfRuns> pairsOf(const MeasureResult& result) {
    std::vector<PairOfRuns> pairs;
    for (const size_t one : measuredRuns(result))
        for (const size_t other : measuredRuns(result)) {
            if (one == other) continue;
            const RunMeasurement &a = result.runs[one], &b = result.runs[other];
            pairs.push_back(
                {one, other, ratioOver(b.frames, a.frames), differenceOver(a, b), lostPerMillion(a) - lostPerMillion(b)});
        }
    return pairs;
}

std::string pairText(const PairOfRuns& pair) {
    if (!pair.ratio.hasInterval) return fmt::format("{:.2f}", pair.ratio.ratio);
    return fmt::format("{}{:.2f} [{:.2f}, {:.2f}]", pair.decided() ? "" : "≈ ", pair.ratio.ratio, pair.ratio.ci95[0],
                       pair.ratio.ci95[1]);
}

/// "34 [30, 38]": per cent of what any culling could save.
std::string shareText(const std::optional<RatioEstimate>& share) {
    constexpr double kPercent = 100.0;
    if (!share) return "-";
    if (!share->hasInterval) return fmt::format("{:.0f}", kPercent * share->ratio);
    return fmt::format("{:.0f} [{:.0f}, {:.0f}]", kPercent * share->ratio, kPercent * share->ci95[0], kPercent * share->ci95[1]);
}

std::string pairsText(const MeasureResult& result) {
    const std::vector<size_t> runs = measuredRuns(result);
    const std::vector<PairOfRuns> pairs = pairsOf(result);
    constexpr int kName = 32, kCell = 22;
    const auto cell = [](std::string_view text) {
        // "≈" has one place and three bytes.
        const size_t places = text.size() - (text.starts_with("≈") ? 2 : 0);
        return std::string(kCell > int(places) ? size_t(kCell) - places : 1, ' ') + std::string(text);
    };
    std::string text = "How many times as fast the strategy of the row is as that of the column [95 %]; ≈: not decided\n";
    text += fmt::format("{:<{}}", "", kName);
    for (const size_t run : runs) text += cell(strategyLabel(result.runs[run].strategy));
    for (const size_t one : runs) {
        text += fmt::format("\n{:<{}}", terminalLine(strategyLabel(result.runs[one].strategy)), kName);
        for (const size_t other : runs) {
            const auto found =
                std::ranges::find_if(pairs, [&](const PairOfRuns& pair) { return pair.one == one && pair.other == other; });
            text += cell(found == pairs.end() ? "1" : pairText(*found));
        }
    }
    if (result.limit) {
        text += fmt::format("\n{:<{}}", "of the headroom, % [95 %]", kName);
        for (const size_t run : runs) text += cell(shareText(result.runs[run].summary.headroomShare));
    }
    return text + "\n";
}

std::string pairsJson(const MeasureResult& result) {
    Json json = Json::parse(resultJson(result));
    const auto interval = [](const RatioEstimate& estimate) {
        return estimate.hasInterval ? Json(estimate.ci95) : Json(nullptr);
    };
    json["pairs"] = Json::array();
    for (const PairOfRuns& pair : pairsOf(result))
        json["pairs"].push_back({{"one", strategyText(result.runs[pair.one].strategy)},
                                 {"other", strategyText(result.runs[pair.other].strategy)},
                                 {"ratio", pair.ratio.ratio},
                                 {"ratio_ci95", interval(pair.ratio)},
                                 {"saved_ms", pair.difference.ratio},
                                 {"saved_ms_ci95", interval(pair.difference)},
                                 {"lost_ppm_more", pair.lostDifference},
                                 {"decided", pair.decided()}});
    return plainJson(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string pairsCsv(const MeasureResult& result) {
    std::string csv = "one,other,ratio,ratio_low,ratio_high,saved_ms,saved_ms_low,saved_ms_high,lost_ppm_more,decided\n";
    const auto quoted = [&](size_t run) { return "\"" + strategyText(result.runs[run].strategy) + "\""; };
    const auto limits = [](const RatioEstimate& estimate) {
        return estimate.hasInterval ? fmt::format("{},{}", estimate.ci95[0], estimate.ci95[1]) : std::string(",");
    };
    for (const PairOfRuns& pair : pairsOf(result))
        csv +=
            fmt::format("{},{},{},{},{},{},{},{}\n", quoted(pair.one), quoted(pair.other), pair.ratio.ratio, limits(pair.ratio),
                        pair.difference.ratio, limits(pair.difference), pair.lostDifference, pair.decided());
    return terminalText(csv);
}

}  // namespace cullscope
