#include "core/experiments/advice/race.h"

#include <algorithm>
#include <bit>

#include "core/base/error.h"

namespace cullscope::advice {

Deadline::Deadline(double seconds, const std::stop_token& whole)
    : m_whole(whole, [this] { m_stop.request_stop(); }), m_clock([this, seconds](const std::stop_token& ended) {
          std::unique_lock lock(m_mutex);
          const auto over = std::chrono::duration<double>(std::min(seconds, 1e6));
          // False where the time is over and the work has not ended.
          if (!m_wake.wait_for(lock, ended, over, [&] { return ended.stop_requested(); }) && !ended.stop_requested()) {
              m_passed = true;
              m_stop.request_stop();
          }
      }) {}

Race::Race(const AdviseRequest& request, const Progress& progress)
    : m_request(request), m_progress(progress), m_gl(requireOpenGl45()), m_frames(request.scene, request.upload, request.size) {}

std::optional<double> Race::draw(Entrant& entrant, size_t pose, double seconds) {
    const Deadline deadline(seconds, m_progress.stop);
    try {
        const std::optional<View> before = pose > 0 ? std::optional(viewOf(pose - 1)) : std::nullopt;
        SingleFrames::Frame frame = m_frames.draw(*entrant.built, viewOf(pose), before ? &*before : nullptr, deadline.token());
        m_log = std::move(frame.log);
        return frame.milliseconds;
    } catch (const Error& error) {
        m_progress.check();
        entrant.racing = entrant.eligible = false;
        if (deadline.passed()) {
            entrant.figures.standing = Standing::FarBehind;
        } else {
            entrant.figures.standing = Standing::Refused;
            entrant.figures.why = error.message();
        }
        return std::nullopt;
    }
}

void Race::judge(Entrant& entrant, size_t pose) {
    if (entrant.judged[pose]) return;
    const JudgedFrame judged = m_frames.judge(*entrant.built, m_log);
    entrant.judged[pose] = true;
    AdvisedStrategy& figures = entrant.figures;
    ++figures.judgedViews;
    figures.coveredPixels += judged.accuracy.coveredPixels;
    figures.lostPixels += judged.lostPixels();
    if (judged.lostPixels() > 0) ++figures.viewsWithLoss;
}

std::vector<size_t> spreadOrder(size_t n) {
    std::vector<size_t> order;
    const size_t places = std::bit_ceil(n);
    const int digits = std::countr_zero(places);
    for (size_t i = 0; i < places; ++i) {
        size_t mirrored = 0;
        for (int digit = 0; digit < digits; ++digit)
            if ((i >> digit & 1u) != 0) mirrored |= size_t(1) << (digits - 1 - digit);
        if (mirrored < n) order.push_back(mirrored);
    }
    return order;
}

RatioEstimate ratioBetween(const std::vector<std::vector<double>>& baseline, const std::vector<std::vector<double>>& subject) {
    std::vector<ViewTimes> views;
    for (size_t pose = 0; pose < std::min(baseline.size(), subject.size()); ++pose)
        if (!baseline[pose].empty() && !subject[pose].empty()) views.push_back({baseline[pose], subject[pose]});
    return ratioOfTotals(views);
}

double sumOf(const std::vector<std::vector<double>>& times) {
    double sum = 0.0;
    for (const std::vector<double>& view : times)
        if (!view.empty()) sum += quantile(view, 0.5);
    return sum;
}

std::optional<RatioEstimate> headroomOf(const Entrant& choice, const std::vector<Entrant>& entrants) {
    const Entrant& all = entrants.front();
    std::vector<TimesBesideLimit> views;
    for (const Entrant& limit : entrants)
        for (size_t pose = 0; limit.figures.limit && pose < all.times.size(); ++pose)
            if (!all.times[pose].empty() && !choice.times[pose].empty() && !limit.times[pose].empty()) {
                // The limit is drawn in one turn.
                const double everything = quantile(all.times[pose], 0.5);
                views.push_back({{everything}, {quantile(choice.times[pose], 0.5)}, {everything}, {limit.times[pose].front()}});
            }
    return shareOfHeadroom(views);
}

std::vector<const Entrant*> ranked(const std::vector<Entrant>& entrants, const Entrant* choice) {
    std::vector<const Entrant*> order;
    for (const Entrant& entrant : entrants) order.push_back(&entrant);
    const auto group = [&](const Entrant* entrant) {
        if (entrant == choice) return 0;
        if (entrant->figures.limit) return 4;
        if (entrant->figures.views == 0) return 3;
        return entrant->figures.standing == Standing::Loses ? 2 : 1;
    };
    std::ranges::stable_sort(order, [&](const Entrant* one, const Entrant* other) {
        if (group(one) != group(other)) return group(one) < group(other);
        return one->figures.ratioToAll.value_or(RatioEstimate{}).ratio >
               other->figures.ratioToAll.value_or(RatioEstimate{}).ratio;
    });
    return order;
}

namespace {

size_t viewsOf(const std::vector<std::vector<double>>& times) {
    return size_t(std::ranges::count_if(times, [](const auto& view) { return !view.empty(); }));
}

void setTimes(Entrant& entrant, const Entrant& everything) {
    const bool raced = sumOf(entrant.times) > 0.0;
    const std::vector<std::vector<double>>& times = raced ? entrant.times : entrant.probes;
    AdvisedStrategy& figures = entrant.figures;
    figures.views = viewsOf(times);
    if (figures.views == 0) return;
    figures.frameMilliseconds = sumOf(times) / double(figures.views);
    figures.ratioToAll = ratioBetween(raced ? everything.times : everything.probes, times);
}

/// Of an entrant that left the race: its figures at all views, by those of the choice.
void setByChoice(Entrant& entrant, const Entrant& choice, double limitRatio) {
    AdvisedStrategy& figures = entrant.figures;
    const bool raced = sumOf(entrant.times) > 0.0;
    const std::vector<std::vector<double>>& times = raced ? entrant.times : entrant.probes;
    // Of the choice those of the same turns: what another program took of the processor, it took of both.
    std::vector<std::vector<double>> sameTurns = raced ? choice.times : choice.probes;
    for (size_t view = 0; view < times.size(); ++view)
        sameTurns[view].resize(std::min(sameTurns[view].size(), times[view].size()));
    const RatioEstimate beside = ratioBetween(sameTurns, times);
    if (!(beside.ratio > 0.0)) return;
    const double best = choice.figures.ratioToAll->ratio;
    figures.ratioToAll = {best * beside.ratio, {best * beside.ci95[0], best * beside.ci95[1]}, beside.hasInterval};
    figures.frameMilliseconds = choice.figures.frameMilliseconds / beside.ratio;
    figures.headroomShare.reset();
    if (!choice.figures.headroomShare || limitRatio <= 1.0) return;
    const double share = (1.0 - 1.0 / figures.ratioToAll->ratio) / (1.0 - 1.0 / limitRatio);
    figures.headroomShare = RatioEstimate{share, {share, share}, false};
}

}  // namespace

Entrant* fastest(std::vector<Entrant>& entrants) {
    Entrant* best = nullptr;
    for (Entrant& entrant : entrants)
        if (entrant.eligible && entrant.racing && (best == nullptr || sumOf(entrant.times) < sumOf(best->times))) best = &entrant;
    return best;
}

void setTimes(std::vector<Entrant>& entrants, const Entrant* choice) {
    double limitRatio = 0.0;
    for (Entrant& entrant : entrants) {
        setTimes(entrant, entrants.front());
        if (entrant.figures.limit && entrant.figures.ratioToAll) limitRatio = entrant.figures.ratioToAll->ratio;
    }
    for (Entrant& entrant : entrants)
        if (!entrant.figures.limit) entrant.figures.headroomShare = headroomOf(entrant, entrants);
    for (Entrant& entrant : entrants) {
        AdvisedStrategy& figures = entrant.figures;
        // Drawing everything and the limit are drawn to the end, whatever became of them.
        const bool left = !entrant.racing && !figures.limit && &entrant != &entrants.front();
        if (choice != nullptr && &entrant != choice && left && figures.views > 0) setByChoice(entrant, *choice, limitRatio);
        if (!figures.ratioToAll) continue;
        const double saved = figures.frameMilliseconds * (figures.ratioToAll->ratio - 1.0);
        if (saved > 0.0 && figures.structure.bytes > 0) figures.paybackFrames = figures.structure.buildMilliseconds / saved;
    }
}

Entrant* everythingWhereAsFast(std::vector<Entrant>& entrants, Entrant* choice) {
    Entrant* everything = nullptr;
    for (Entrant& entrant : entrants) {
        if (!entrant.figures.everything || !entrant.racing || !entrant.eligible || sumOf(entrant.times) <= 0.0) continue;
        const RatioEstimate ratio = ratioBetween(entrant.times, choice->times);
        if (ratio.hasInterval && ratio.ci95[0] > 1.0) continue;
        if (everything == nullptr || sumOf(entrant.times) < sumOf(everything->times)) everything = &entrant;
    }
    return everything != nullptr ? everything : choice;
}

std::vector<StrategyRequest> candidates() {
    std::vector<StrategyRequest> requests;
    const auto add = [&](StrategyRequest request) {
        if (std::ranges::find(requests, request) == requests.end()) requests.push_back(std::move(request));
    };
    for (const StrategyInfo* baseline : baselines()) add({baseline->id, ParameterSet(baseline->parameters)});
    add(baselineUnder(Facing::ByObject));
    std::vector<const StrategyInfo*> tried;
    for (const RegisteredStrategy& strategy : strategies())
        if (!strategy.info.limit && strategy.info.decidesByFile.empty()) tried.push_back(&strategy.info);
    for (const StrategyInfo* info : tried) add({info->id, ParameterSet(info->parameters)});
    for (const StrategyInfo* info : tried)
        for (const DeclaredSweep& sweep : info->sweeps)
            for (const std::string& value : sweep.values) {
                StrategyRequest request{info->id, ParameterSet(info->parameters)};
                request.parameters.setFromText(sweep.key, value);
                add(std::move(request));
            }
    return requests;
}

}  // namespace cullscope::advice
