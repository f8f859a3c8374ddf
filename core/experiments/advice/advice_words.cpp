#include <fmt/format.h>

#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/advice/adviser.h"
#include "core/experiments/result_file.h"
#include "core/measure/field_figures.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::advice {
namespace {

std::string decimal(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }
std::string percentText(double share) { return decimal(100.0 * share, 0); }

/// Two digits after the point, or as many as tell it from 0.
std::string milliseconds(double value) { return value >= 0.1 ? decimal(value, 1) : decimal(value, 4); }

Message lossSentence(const AdvisedStrategy& best) {
    if (best.judgedViews == 0) return {};
    if (best.lostPixels == 0)
        return {boundSaysSomething(best.judgedViews) ? CULLSCOPE_TR("It lost nothing in %1 views (< 3/%1).")
                                                     : CULLSCOPE_TR("It lost nothing in %1 views."),
                {std::to_string(best.judgedViews)}};
    return {CULLSCOPE_TR("It loses %1 of a million pixels, in %2 of %3 views."),
            {decimal(1e6 * *best.missedRate(), 1), std::to_string(best.viewsWithLoss), std::to_string(best.judgedViews)}};
}

Message structureSentence(const AdvisedStrategy& best) {
    if (best.structure.bytes == 0) return {CULLSCOPE_TR("It builds no structure."), {}};
    const std::string bytes = std::to_string(best.structure.bytes), built = milliseconds(best.structure.buildMilliseconds);
    if (!best.paybackFrames)
        return {CULLSCOPE_TR("Its structure takes %1 bytes and %2 ms to build, which no frame pays back."), {bytes, built}};
    return {CULLSCOPE_TR("Its structure takes %1 bytes and %2 ms to build, paid back after %3 frames."),
            {bytes, built, decimal(std::ceil(*best.paybackFrames), 0)}};
}

Message headroomSentence(const Advice& advice) {
    if (!advice.limitRatio) return {};
    const std::string most = decimal(*advice.limitRatio, 2);
    if (advice.strategies[*advice.best].ratioToAll->ratio > *advice.limitRatio)
        return {CULLSCOPE_TR("That is more than drawing exactly what is visible gains by OpenGL, which is ×%1."), {most}};
    if (!advice.headroomShare)
        return {CULLSCOPE_TR("No culling could gain here for certain: drawing exactly what is visible is ×%1."), {most}};
    return {CULLSCOPE_TR("Any culling could gain ×%1 at most; this is %2 % of the time that could be saved."),
            {most, percentText(advice.headroomShare->ratio)}};
}

Message answer(const AdvisedStrategy& best) {
    const std::string label = strategyLabel(best.strategy);
    if (best.everything && best.strategy.id == baselineOf(BaselineRole::Triangles).id && best.ratioToAll->ratio == 1.0)
        return {CULLSCOPE_TR("Drawing everything is best here: nothing that may be used is faster."), {}};
    if (best.everything)
        return {CULLSCOPE_TR("Drawing everything is best here, by %1: ×%2 the speed of drawing both sides."),
                {label, decimal(best.ratioToAll->ratio, 2)}};
    return {CULLSCOPE_TR("%1 is best here: ×%2 the speed of drawing everything."), {label, decimal(best.ratioToAll->ratio, 2)}};
}

std::string ratioWords(const std::optional<RatioEstimate>& ratio) {
    if (!ratio) return "-";
    if (!ratio->hasInterval) return decimal(ratio->ratio, 2);
    return fmt::format("{:.2f} [{:.2f},{:.2f}]", ratio->ratio, ratio->ci95[0], ratio->ci95[1]);
}

std::string lossWords(const AdvisedStrategy& strategy) {
    if (strategy.judgedViews == 0) return "-";
    if (strategy.lostPixels == 0) return noLossIn(strategy.judgedViews).english();
    return decimal(1e6 * *strategy.missedRate(), 1);
}

const char* standingId(Standing standing) {
    switch (standing) {
        case Standing::Finished:
            return "finished";
        case Standing::Behind:
            return "behind";
        case Standing::FarBehind:
            return "far-behind";
        case Standing::Loses:
            return "loses";
        case Standing::Refused:
            return "refused";
    }
    return "";
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json strategyJson(const AdvisedStrategy& strategy) {
    const bool interval = strategy.ratioToAll && strategy.ratioToAll->hasInterval, judged = strategy.judgedViews > 0;
    return {{"strategy", strategyText(strategy.strategy)},
            {"standing", strategy.limit ? "limit" : standingId(strategy.standing)},
            {"why", strategy.why.empty() ? Json(nullptr) : Json(strategy.why.english())},
            {"promise", strategy.built ? Json(promiseId(strategy.promise)) : Json(nullptr)},
            {"views", strategy.views},
            {"frame_ms", strategy.views > 0 ? Json(strategy.frameMilliseconds) : Json(nullptr)},
            {"ratio_to_all", strategy.ratioToAll ? Json(strategy.ratioToAll->ratio) : Json(nullptr)},
            {"ratio_to_all_ci95", interval ? Json(strategy.ratioToAll->ci95) : Json(nullptr)},
            {"headroom_share", strategy.headroomShare ? Json(strategy.headroomShare->ratio) : Json(nullptr)},
            {"judged_views", strategy.judgedViews},
            {"views_with_loss", judged ? Json(strategy.viewsWithLoss) : Json(nullptr)},
            {"lost_pixels", judged ? Json(strategy.lostPixels) : Json(nullptr)},
            {"lost_pixel_rate", orNull(strategy.missedRate())},
            {"build_ms", strategy.built ? Json(strategy.structure.buildMilliseconds) : Json(nullptr)},
            {"structure_bytes", strategy.built ? Json(strategy.structure.bytes) : Json(nullptr)},
            {"payback_frames", orNull(strategy.paybackFrames)}};
}

}  // namespace

Message standingWords(const AdvisedStrategy& strategy) {
    if (strategy.limit) return {CULLSCOPE_TR("the limit of culling"), {}};
    switch (strategy.standing) {
        case Standing::Finished:
            return {CULLSCOPE_TR("in the race to the end"), {}};
        case Standing::Behind:
            return {CULLSCOPE_TR("slower: its interval excludes the best"), {}};
        case Standing::FarBehind:
            return strategy.views == 0 ? Message{CULLSCOPE_TR("not tried: at its defaults it cannot win"), {}}
                                       : Message{CULLSCOPE_TR("far slower at the first views"), {}};
        case Standing::Loses:
            return strategy.lostPixels == 0 ? Message{CULLSCOPE_TR("promises nothing in these views"), {}}
                                            : Message{CULLSCOPE_TR("loses more than is allowed"), {}};
        case Standing::Refused:
            return strategy.why;
    }
    return {};
}

std::vector<Message> sentences(const Advice& advice) {
    if (!advice.best) return {{CULLSCOPE_TR("Nothing was measured that could be advised."), {}}};
    const AdvisedStrategy& best = advice.strategies[*advice.best];
    std::vector<Message> all;
    for (Message sentence :
         {answer(best), lossSentence(best), best.everything ? Message{} : structureSentence(best), headroomSentence(advice)})
        if (!sentence.empty()) all.push_back(std::move(sentence));
    return all;
}

std::string adviceText(const Advice& advice) {
    std::string text;
    for (const Message& sentence : sentences(advice)) text += terminalLine(sentence.english()) + "\n";
    if (advice.interrupted) text += "Stopped: this is what was known by then.\n";
    text += fmt::format("{}: {} triangles in {} objects, {} poses of {}, {}x{}; {} frames in {:.1f} s\n",
                        terminalLine(advice.request.scene->name()), advice.request.scene->triangleCount(),
                        advice.request.scene->instances().size(), advice.request.path.poses.size(),
                        terminalLine(advice.request.path.name), advice.request.size.width, advice.request.size.height,
                        advice.frames, advice.seconds);
    text += advice.gl.renderer + (advice.gl.software ? " (software OpenGL: times are not a GPU's)\n" : "\n");
    text += fmt::format("{:<44} {:<12} {:>6} {:>9} {:>19} {:>9} {:>14} {:>10} {:>12} {:>9}  {}\n", "strategy", "promise", "views",
                        "ms", "x all [95 %]", "headroom", "missed ppm", "build ms", "bytes", "paid back", "");
    size_t notTried = 0;
    for (const AdvisedStrategy& strategy : advice.strategies) {
        if (strategy.standing == Standing::FarBehind && strategy.views == 0) {
            ++notTried;
            continue;
        }
        text += fmt::format("{:<44} {:<12} {:>6} {:>9} {:>19} {:>9} {:>14} {:>10} {:>12} {:>9}  {}\n",
                            terminalLine(strategyLabel(strategy.strategy)), strategy.built ? promiseId(strategy.promise) : "-",
                            strategy.views, strategy.views > 0 ? decimal(strategy.frameMilliseconds, 2) : "-",
                            ratioWords(strategy.ratioToAll),
                            strategy.headroomShare ? percentText(strategy.headroomShare->ratio) + " %" : "-", lossWords(strategy),
                            strategy.built ? decimal(strategy.structure.buildMilliseconds, 1) : "-",
                            strategy.built ? std::to_string(strategy.structure.bytes) : "-",
                            strategy.paybackFrames ? decimal(std::ceil(*strategy.paybackFrames), 0) : "-",
                            terminalLine(standingWords(strategy).english()));
    }
    if (notTried > 0)
        text += fmt::format("{} other values of parameters were not tried: at their defaults these strategies cannot win\n",
                            notTried);
    return text;
}

std::string adviceJson(const Advice& advice) {
    const ToolVersion tool = toolVersion();
    const Scene& scene = *advice.request.scene;
    Json json{{"tool", {{"name", tool.name}, {"version", tool.version}, {"commit", tool.commit}}},
              {"machine",
               {{"cpu", cpuName()},
                {"gl_renderer", advice.gl.renderer},
                {"gl_version", advice.gl.version},
                {"gl_software", advice.gl.software}}},
              {"scene", {{"name", scene.name()}, {"sha256", scene.sha256()}, {"triangles", scene.triangleCount()}}},
              {"path", advice.request.path.name},
              {"poses", advice.request.path.poses.size()},
              {"size", {advice.request.size.width, advice.request.size.height}},
              {"max_missed", advice.request.maxMissed},
              {"interrupted", advice.interrupted},
              {"seconds", advice.seconds},
              {"frames", advice.frames}};
    json["recommended"] = advice.best ? Json(strategyText(advice.strategies[*advice.best].strategy)) : Json(nullptr);
    json["answer"] = Json::array();
    for (const Message& sentence : sentences(advice)) json["answer"].push_back(sentence.english());
    json["limit_ratio_to_all"] = orNull(advice.limitRatio);
    json["headroom_share"] = advice.headroomShare ? Json(advice.headroomShare->ratio) : Json(nullptr);
    json["strategies"] = Json::array();
    for (const AdvisedStrategy& strategy : advice.strategies) json["strategies"].push_back(strategyJson(strategy));
    return plainJson(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

TradePoint tradePoint(const AdvisedStrategy& strategy) {
    const auto plain = [](double value) { return RatioEstimate{value, {value, value}, false}; };
    TradePoint point;
    point.name = point.label = strategyLabel(strategy.strategy);
    point.promise = strategy.promise;
    point.role = findStrategy(strategy.strategy.id).info.baseline;
    point.judged = strategy.judgedViews > 0;
    point.views = point.judged ? strategy.judgedViews : strategy.views;
    if (strategy.ratioToAll) point.values["ratio_to_all"] = *strategy.ratioToAll;
    point.values["build_ms"] = plain(strategy.structure.buildMilliseconds);
    point.values["structure_bytes"] = plain(double(strategy.structure.bytes));
    // What was not judged stands where its promise says.
    if (strategy.missedRate())
        point.values[kUsualUp] = plain(*strategy.missedRate());
    else if (strategy.promise != Promise::Approximate)
        point.values[kUsualUp] = plain(0.0);
    return point;
}

std::vector<TradePoint> tradePoints(const Advice& advice) {
    std::vector<TradePoint> points;
    for (const AdvisedStrategy& strategy : advice.strategies)
        if (strategy.views > 0 && strategy.ratioToAll) points.push_back(tradePoint(strategy));
    return points;
}

std::vector<const AdvisedStrategy*> pictured(const Advice& advice) {
    std::vector<const AdvisedStrategy*> shown;
    for (const AdvisedStrategy& strategy : advice.strategies) {
        if (strategy.views == 0 || !strategy.ratioToAll || strategy.standing == Standing::FarBehind) continue;
        const auto ofTheSame = [&](const AdvisedStrategy* other) { return other->strategy.id == strategy.strategy.id; };
        if (strategy.everything || std::ranges::none_of(shown, ofTheSame)) shown.push_back(&strategy);
    }
    return shown;
}

}  // namespace cullscope::advice
