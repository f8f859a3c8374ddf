#include "core/experiments/store/comparison.h"

#include <fmt/format.h>

#include <charconv>

#include "core/base/error.h"
#include "core/experiments/result_fields.h"

namespace cullscope::store {
namespace {

/// "3" or "3:frustum".
std::pair<int64_t, std::string> sideFrom(const std::string& text) {
    int64_t number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string rest(end, text.data() + text.size());
    if (failure != std::errc() || (!rest.empty() && (rest.front() != ':' || rest.size() == 1)))
        throwUsage(CULLSCOPE_TR("%1 names no measurement: say its number as in 3, or number and strategy as in 3:frustum."),
                   {text});
    return {number, rest.empty() ? rest : rest.substr(1)};
}

void requireSameViews(const Listed& a, const Listed& b) {
    const auto differ = [&](const char* what) {
        throwUsage(CULLSCOPE_TR("Measurements %1 and %2 cannot be compared: their %3 differ."),
                   {std::to_string(a.number), std::to_string(b.number), what});
    };
    if (a.scene != b.scene || a.sceneSha256 != b.sceneSha256) differ(CULLSCOPE_TR("scenes"));
    if (a.path != b.path || a.poses != b.poses) differ(CULLSCOPE_TR("camera paths"));
    if (a.size.width != b.size.width || a.size.height != b.size.height) differ(CULLSCOPE_TR("picture sizes"));
}

/// Frames in several windows, or with vertices that are sent anew each time, are other frames.
void requireSameDrawing(const Stored& a, const StoredRun& ofA, const Stored& b, const StoredRun& ofB) {
    const ResultFields one = ResultFields::parse(ofA.head), other = ResultFields::parse(ofB.head);
    for (const auto& [field, what] : {std::pair("windows", CULLSCOPE_TR("numbers of windows")),
                                      std::pair("window_views", CULLSCOPE_TR("views of the windows")),
                                      std::pair("upload", CULLSCOPE_TR("ways of uploading vertices"))})
        if (one.value(field, ResultFields()) != other.value(field, ResultFields()))
            throwUsage(CULLSCOPE_TR("Measurements %1 and %2 cannot be compared: their %3 differ."),
                       {std::to_string(a.listed.number), std::to_string(b.listed.number), what});
}

const StoredRun& runOf(const Stored& stored, const std::string& strategy) {
    const StoredRun* const run = stored.find(strategy);
    if (run == nullptr) {
        std::string known;
        for (const StoredRun& each : stored.runs) known += (known.empty() ? "" : ", ") + each.strategy;
        throwUsage(CULLSCOPE_TR("Measurement %1 has no run of %2. It has: %3."),
                   {std::to_string(stored.listed.number), strategy, known});
    }
    return *run;
}

Compared compare(const Stored& a, const StoredRun& ofA, const Stored& b, const StoredRun& ofB) {
    requireSameDrawing(a, ofA, b, ofB);
    Compared result;
    result.a = ofA.strategy;
    result.b = ofB.strategy;
    result.inTurns = a.listed.number == b.listed.number;
    RunMeasurement both[2] = {ofA.run, ofB.run};
    both[0].frames.clear();
    both[1].frames.clear();
    for (const FrameMeasurement& frame : ofA.run.frames)
        for (const FrameMeasurement& other : ofB.run.frames)
            if (frame.pose == other.pose) {
                both[0].frames.push_back(frame);
                both[1].frames.push_back(other);
                result.msOfA += frame.frameMilliseconds;
                result.msOfB += other.frameMilliseconds;
            }
    result.poses = both[0].frames.size();
    if (result.poses == 0) return result;
    result.msOfA /= double(result.poses);
    result.msOfB /= double(result.poses);
    result.ratio = ratioOver(both[0].frames, both[1].frames);
    result.lostByA = both[0].losses();
    result.lostByB = both[1].losses();
    return result;
}

void requirePoses(const std::vector<Compared>& all, const Listed& a, const Listed& b) {
    for (const Compared& each : all)
        if (each.poses > 0) return;
    throwUsage(CULLSCOPE_TR("Measurements %1 and %2 cannot be compared: they have no run or pose in common."),
               {std::to_string(a.number), std::to_string(b.number)});
}

}  // namespace

std::vector<Compared> compared(const Stored& a, const Stored& b) {
    requireSameViews(a.listed, b.listed);
    std::vector<Compared> all;
    for (const StoredRun& run : a.runs) {
        if (!run.askedFor && !run.isLimit) continue;
        if (const StoredRun* const other = b.find(run.strategy)) all.push_back(compare(a, run, b, *other));
    }
    std::erase_if(all, [](const Compared& each) { return each.poses == 0; });
    requirePoses(all, a.listed, b.listed);
    return all;
}

std::vector<Compared> compared(const ResultStore& store, const std::string& a, const std::string& b) {
    const auto [numberA, strategyA] = sideFrom(a);
    const auto [numberB, strategyB] = sideFrom(b);
    const Stored first = store.read(numberA);
    const Stored second = store.read(numberB);
    if (strategyA.empty() && strategyB.empty()) return compared(first, second);
    requireSameViews(first.listed, second.listed);
    const std::string& one = strategyA.empty() ? strategyB : strategyA;
    const std::string& other = strategyB.empty() ? strategyA : strategyB;
    std::vector<Compared> all{compare(first, runOf(first, one), second, runOf(second, other))};
    requirePoses(all, first.listed, second.listed);
    return all;
}

Message verdict(const Compared& compared) {
    const RatioEstimate& ratio = compared.ratio;
    const std::string words = ratio.hasInterval
                                  ? fmt::format("{:.2f} [{:.2f}, {:.2f}]", ratio.ratio, ratio.ci95[0], ratio.ci95[1])
                                  : fmt::format("{:.2f}", ratio.ratio);
    if (!ratio.hasInterval)
        return {CULLSCOPE_TR("B has %1 times the speed of A; of single frames there is no interval"), {words}};
    if (ratio.ci95[0] > 1.0) return {CULLSCOPE_TR("B is faster: %1 times the speed of A"), {words}};
    if (ratio.ci95[1] < 1.0) return {CULLSCOPE_TR("B is slower: %1 times the speed of A"), {words}};
    return {CULLSCOPE_TR("no difference that this measurement tells: B has %1 times the speed of A"), {words}};
}

}  // namespace cullscope::store
