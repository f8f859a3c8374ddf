#include "core/experiments/advice/adviser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/experiments/advice/race.h"

namespace cullscope::advice {
namespace {

constexpr size_t kProbes = 2;
constexpr size_t kLeastViews = 6;       // before an interval may exclude a strategy
constexpr size_t kUsualTurns = 3;       // at each view
constexpr size_t kMostTurns = 15;       // of those that do not differ by then
constexpr double kLastShare = 0.25;     // what the turns after the usual ones may take of the time before them
constexpr double kFar = 2.5;            // as many times as long as the fastest: no interval needed
constexpr double kExcluded = 0.96;      // the interval's end below which a slower one leaves
constexpr double kFarOfVariants = 1.5;  // of a default, so that its other values are not tried
constexpr double kSame = 0.99;          // faster by less does not count against a smaller structure
constexpr double kBuildFrames = 100.0, kLeastBuildSeconds = 0.5;
constexpr double kFrameSeconds = 1.0, kLongFrames = 10.0;
constexpr double kSlowFirst = 5.0;  // of a first frame, which fills caches, too

class Adviser {
public:
    Adviser(const AdviseRequest& request, const Progress& progress)
        : m_request(request), m_progress(progress), m_race(request, progress), m_order(spreadOrder(m_race.poses())) {}

    Advice run() {
        Advice advice;
        try {
            admitAll();
            race();
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) throw;
            advice.interrupted = true;
        }
        choose(advice);
        advice.seconds = passed();
        return advice;
    }

private:
    void admitAll() {
        const std::vector<StrategyRequest> all = candidates();
        for (size_t i = 0; i < all.size(); ++i) {
            m_progress.tell(0.5 * double(i) / double(all.size()), CULLSCOPE_TR("trying strategies"));
            m_progress.check();
            admit(all[i], false);
        }
        const StrategyInfo& limit = limitOfCulling();
        admit({limit.id, ParameterSet(limit.parameters)}, true);
        m_lastBuilt.reset();
        m_defaults.clear();
    }

    void admit(const StrategyRequest& strategy, bool limit) {
        Entrant entrant;
        entrant.figures.strategy = strategy;
        entrant.figures.everything = entrant.info().baseline != BaselineRole::None;
        entrant.figures.limit = limit;
        entrant.probes.resize(m_race.poses());
        entrant.times.resize(m_race.poses());
        entrant.judged.resize(m_race.poses());
        if (variantOfASlowOne(entrant))
            entrant.figures.standing = Standing::FarBehind;
        else if (otherStructureOfALossyOne(entrant))
            entrant.figures.standing = Standing::Loses;
        else if (build(entrant) && !valueThatMayNotBeChosen(entrant))
            probe(entrant);
        // Other values of its parameters may need the same structure: those of a default come after all defaults.
        if (entrant.built && defaultOf(entrant) == nullptr) m_defaults.push_back(entrant.built);
        m_lastBuilt = entrant.built ? entrant.built : m_lastBuilt;
        if (!entrant.racing) entrant.built.reset();
        m_entrants.push_back(std::move(entrant));
    }

    /// The default of an entrant's strategy, if it is another value of one; null: it is the default.
    [[nodiscard]] const Entrant* defaultOf(const Entrant& entrant) const {
        const auto first = std::ranges::find(m_entrants, entrant.figures.strategy.id,
                                             [](const Entrant& other) { return other.figures.strategy.id; });
        return first == m_entrants.end() ? nullptr : &*first;
    }

    [[nodiscard]] bool variantOfASlowOne(const Entrant& entrant) const {
        const Entrant* const first = defaultOf(entrant);
        if (first == nullptr || entrant.figures.everything) return false;
        if (first->figures.standing == Standing::Refused) return true;
        return slower(*first, kFarOfVariants);
    }

    /// A value for which another structure would be built, of a strategy that promises nothing at its default: it may not be
    /// chosen where only what loses nothing will do, and is not worth building.
    [[nodiscard]] bool otherStructureOfALossyOne(const Entrant& entrant) const {
        const Entrant* const first = defaultOf(entrant);
        return first != nullptr && m_request.maxMissed <= 0.0 && first->figures.promise == Promise::Approximate &&
               first->figures.standing == Standing::Loses &&
               first->figures.strategy.parameters.buildText() != entrant.figures.strategy.parameters.buildText();
    }

    /// Another value of a parameter, with which the strategy promises nothing, where only what loses nothing will do: the default
    /// was drawn, to say what such a strategy loses.
    [[nodiscard]] bool valueThatMayNotBeChosen(const Entrant& entrant) const {
        return !entrant.eligible && !entrant.figures.limit && defaultOf(entrant) != nullptr;
    }

    bool build(Entrant& entrant) {
        const StrategyRequest& strategy = entrant.figures.strategy;
        if (const std::optional<Message> why = unavailable(entrant.info(), m_race.gl())) return refuse(entrant, *why);
        if (const auto why = unserved(entrant.info(), strategy.parameters, m_request.path.camera(0)))
            return refuse(entrant, *why);
        double seconds = m_request.buildSeconds;
        if (seconds <= 0.0) {
            double best = 0.0;
            for (size_t i = 0; i < probes(); ++i) best += bestProbe(m_order[i]) / 1000.0 / double(probes());
            seconds = std::max(kLeastBuildSeconds, kBuildFrames * (std::isfinite(best) ? best : 0.0));
        }
        const Deadline deadline(seconds, m_progress.stop);
        try {
            entrant.built = buildStrategy(strategyOf(strategy), strategy.parameters, m_request.scene, m_structures,
                                          {nullptr, deadline.token()});
        } catch (const Error& error) {
            m_progress.check();
            if (!deadline.passed()) return refuse(entrant, error.message());
            return refuse(entrant,
                          {CULLSCOPE_TR("building its structure takes longer than %1 s"), {fmt::format("{:.2g}", seconds)}});
        }
        entrant.figures.structure = entrant.built->report();
        entrant.figures.built = true;
        entrant.figures.promise = entrant.built->promise();
        for (size_t pose = 0; pose < m_race.poses(); ++pose)
            if (entrant.built->promiseAt(m_race.viewOf(pose)) == Promise::Approximate)
                entrant.figures.promise = Promise::Approximate;
        entrant.eligible =
            !entrant.figures.limit && (m_request.maxMissed > 0.0 || entrant.figures.promise != Promise::Approximate);
        if (!entrant.eligible) entrant.figures.standing = Standing::Loses;
        return true;
    }

    static bool refuse(Entrant& entrant, const Message& why) {
        entrant.figures.standing = Standing::Refused;
        entrant.figures.why = why;
        return false;
    }

    [[nodiscard]] size_t probes() const { return std::min(kProbes, m_order.size()); }

    /// The least time of those that may be chosen at one of the first views, in milliseconds; infinite where there is none yet.
    [[nodiscard]] double bestProbe(size_t pose) const {
        double best = std::numeric_limits<double>::infinity();
        for (const Entrant& entrant : m_entrants)
            if (entrant.eligible && entrant.racing && !entrant.probes[pose].empty())
                best = std::min(best, entrant.probes[pose].front());
        return best;
    }

    /// Whether a strategy took more than so many times as long as the fastest, at those of the first views that it drew.
    [[nodiscard]] bool slower(const Entrant& entrant, double times) const {
        double best = 0.0;
        for (size_t pose = 0; pose < entrant.probes.size(); ++pose)
            if (!entrant.probes[pose].empty()) best += bestProbe(pose);
        return sumOf(entrant.probes) > times * best;
    }

    /// A frame that takes so long is not waited for.
    [[nodiscard]] double longFrame(size_t pose) const {
        const double best = bestProbe(pose) / 1000.0;
        return std::isfinite(best) ? std::max(kFrameSeconds, kLongFrames * best) : 1e6;
    }

    /// The first frame fills caches and is not counted. Of those that may be chosen the lesser of two frames counts: another
    /// program that takes the processor for a moment must not decide. One that is far slower leaves here.
    void probe(Entrant& entrant) {
        const std::optional<double> first = m_race.draw(entrant, m_order.front(), longFrame(m_order.front()));
        if (!first) return;
        const bool slow = *first > kSlowFirst * bestProbe(m_order.front());
        for (size_t i = 0; i < probes() && !slow; ++i) {
            std::optional<double> least;
            for (int frame = 0; frame < (entrant.eligible ? 2 : 1); ++frame) {
                const std::optional<double> time = m_race.draw(entrant, m_order[i], longFrame(m_order[i]));
                if (!time) return;
                least = std::min(*time, least.value_or(*time));
            }
            entrant.probes[m_order[i]].push_back(*least);
            if (entrant.figures.promise == Promise::Approximate && !entrant.figures.limit) m_race.judge(entrant, m_order[i]);
        }
        if (slow) entrant.probes[m_order.front()].push_back(*first);
        if (entrant.figures.limit) {
            entrant.racing = true;
        } else if (slow || (!entrant.figures.everything && slower(entrant, kFar))) {
            if (entrant.eligible) entrant.figures.standing = Standing::FarBehind;
            entrant.eligible = false;
        } else if (losesTooMuch(entrant, 2.0)) {
            leave(entrant, Standing::Loses);
        } else if (entrant.eligible) {
            entrant.racing = true;
            entrant.figures.standing = Standing::Finished;
        }
    }

    [[nodiscard]] bool losesTooMuch(const Entrant& entrant, double factor) const {
        const std::optional<double> rate = entrant.figures.missedRate();
        return entrant.figures.promise == Promise::Approximate && rate && *rate > factor * m_request.maxMissed;
    }
    static void leave(Entrant& entrant, Standing standing) {
        entrant.figures.standing = standing;
        entrant.eligible = entrant.racing = false;
    }

    void race() {
        leaveSlow();
        double seconds = 0.0;  // of all that comes before the last turns
        for (size_t turn = 0; turn < kMostTurns && (turn == 0 || !decided()); ++turn) {
            if (turn == kUsualTurns) seconds = passed();
            if (turn >= kUsualTurns && passed() > (1.0 + kLastShare) * seconds) break;
            for (size_t i = 0; i < m_order.size() && (turn == 0 || !decided()); ++i) {
                m_progress.tell(0.5 + 0.5 * (double(turn) + double(i) / double(m_order.size())) / double(kMostTurns),
                                CULLSCOPE_TR("racing"));
                drawAll(m_order[i], turn, (turn + i) % 2 != 0);
                dropSlower(turn * m_order.size() + i + 1);
            }
        }
    }
    [[nodiscard]] double passed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }

    /// Those that were tried before the fastest.
    void leaveSlow() {
        for (Entrant& entrant : m_entrants)
            if (entrant.eligible && !entrant.figures.everything && slower(entrant, kFar)) leave(entrant, Standing::FarBehind);
    }

    void drawAll(size_t pose, size_t turn, bool backwards) {
        for (size_t k = 0; k < m_entrants.size(); ++k) {
            Entrant& entrant = m_entrants[backwards ? m_entrants.size() - 1 - k : k];
            // Drawing everything and the limit stay for the ratios; finding the limit takes time that is not its own.
            const bool kept = &entrant == &m_entrants.front() || (entrant.figures.limit && entrant.racing && turn == 0);
            if (!kept && (!entrant.racing || entrant.figures.limit)) continue;
            const std::optional<double> time = m_race.draw(entrant, pose, 1e6);
            if (!time) continue;
            entrant.times[pose].push_back(*time);
            if (entrant.figures.promise != Promise::Approximate || entrant.figures.limit || !entrant.racing) continue;
            m_race.judge(entrant, pose);
            if (losesTooMuch(entrant, entrant.figures.judgedViews == m_order.size() ? 1.0 : 2.0)) leave(entrant, Standing::Loses);
        }
    }

    void dropSlower(size_t drawn) {
        const Entrant* const best = fastest(m_entrants);
        if (best == nullptr || drawn < std::min(kLeastViews, kUsualTurns * m_order.size())) return;
        for (Entrant& entrant : m_entrants) {
            if (&entrant == best || !entrant.racing || !entrant.eligible) continue;
            const RatioEstimate ratio = ratioBetween(best->times, entrant.times);
            if (!ratio.hasInterval || ratio.ci95[1] >= kExcluded) continue;
            entrant.racing = false;
            entrant.figures.standing = Standing::Behind;
        }
    }

    /// Whether one is left, or those that are do not differ by more than matters.
    [[nodiscard]] bool decided() {
        const Entrant* const best = fastest(m_entrants);
        if (best == nullptr) return true;
        return std::ranges::all_of(m_entrants, [&](const Entrant& entrant) {
            if (&entrant == best || !entrant.racing || !entrant.eligible) return true;
            const RatioEstimate ratio = ratioBetween(best->times, entrant.times);
            return ratio.hasInterval && ratio.ci95[0] >= kSame - 0.01;
        });
    }

    /// Judges the chosen one at every view: one that breaks its promise is not chosen.
    bool keepsItsPromise(Entrant& entrant, Advice& advice) {
        try {
            for (size_t pose = 0; pose < m_race.poses() && !advice.interrupted; ++pose)
                if (!entrant.judged[pose] && m_race.draw(entrant, pose, 1e6)) m_race.judge(entrant, pose);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) throw;
            advice.interrupted = true;
        }
        const std::optional<double> rate = entrant.figures.missedRate();
        return !rate || *rate <= m_request.maxMissed;
    }

    /// Of those that are left the fastest, but for one whose structure is smaller and that is hardly slower.
    [[nodiscard]] Entrant* chosen() {
        Entrant* const best = fastest(m_entrants);
        Entrant* choice = best;
        for (Entrant& entrant : m_entrants) {
            if (best == nullptr || !entrant.racing || !entrant.eligible) continue;
            if (ratioBetween(best->times, entrant.times).ratio < kSame) continue;
            const auto cost = [](const Entrant& one) { return one.figures.structure.bytes; };
            if (cost(entrant) < cost(*choice)) choice = &entrant;
        }
        if (choice != nullptr) return everythingWhereAsFast(m_entrants, choice);
        // Those in the race were all found to lose: the fastest of those that left it.
        for (Entrant& entrant : m_entrants)
            if (entrant.eligible && entrant.figures.standing == Standing::Behind &&
                (choice == nullptr || ratioBetween(m_entrants.front().times, entrant.times).ratio >
                                          ratioBetween(m_entrants.front().times, choice->times).ratio))
                choice = &entrant;
        return choice;
    }

    void choose(Advice& advice) {
        Entrant* choice = chosen();
        while (choice != nullptr && sumOf(choice->times) <= 0.0) choice = nullptr;
        while (choice != nullptr && !keepsItsPromise(*choice, advice)) {
            leave(*choice, Standing::Loses);
            choice = chosen();
        }
        setTimes(m_entrants, choice);
        for (const Entrant& entrant : m_entrants)
            if (entrant.figures.limit && entrant.figures.ratioToAll) advice.limitRatio = entrant.figures.ratioToAll->ratio;
        if (choice != nullptr) advice.headroomShare = choice->figures.headroomShare;
        fill(advice, choice);
    }

    void fill(Advice& advice, const Entrant* choice) const {
        for (const Entrant* entrant : ranked(m_entrants, choice)) advice.strategies.push_back(entrant->figures);
        if (choice != nullptr) advice.best = 0;
        advice.request = m_request;
        advice.gl = m_race.gl();
        advice.frames = m_race.frames();
    }

    const AdviseRequest& m_request;
    const Progress& m_progress;
    Race m_race;
    StructureStore m_structures;
    BuiltStrategyPointer m_lastBuilt;
    std::vector<BuiltStrategyPointer> m_defaults;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::vector<size_t> m_order;
    std::vector<Entrant> m_entrants;  ///< the first one draws everything
};

}  // namespace

Advice advise(const AdviseRequest& request, const Progress& progress) {
    if (request.path.poses.empty()) throwUsage(CULLSCOPE_TR("The camera path has no poses."));
    if (request.scene->triangleCount() == 0) throwUsage(CULLSCOPE_TR("The scene has no triangles: there is nothing to measure."));
    return Adviser(request, progress).run();
}

}  // namespace cullscope::advice
