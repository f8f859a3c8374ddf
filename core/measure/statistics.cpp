#include "core/measure/statistics.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/random.h"

namespace cullscope {
namespace {

/// The fewest resamples of one view's repetitions. Among many views a resample of all of them rarely meets the same one twice.
constexpr size_t kLeastResamplesOfAView = 20;

/// The time of a view, or the total over views.
struct Times {
    double baseline = 0.0, subject = 0.0;
};

size_t pairsOf(const ViewTimes& view) { return std::min(view.baseline.size(), view.subject.size()); }

Times mediansOf(const ViewTimes& view) { return {quantile(view.baseline, 0.5), quantile(view.subject, 0.5)}; }

double ratioOf(const Times& times) { return times.subject > 0.0 ? times.baseline / times.subject : 0.0; }

/// The view's medians over pairs of its repetitions that are drawn with replacement.
Times resampled(const ViewTimes& view, Random& random, ViewTimes& drawn) {
    const size_t pairs = pairsOf(view);
    drawn.baseline.resize(pairs);
    drawn.subject.resize(pairs);
    for (size_t i = 0; i < pairs; ++i) {
        const size_t from = random.bits() % pairs;
        drawn.baseline[i] = view.baseline[from];
        drawn.subject[i] = view.subject[from];
    }
    return mediansOf(drawn);
}

/// The times of a view, or the totals over views.
struct HeadroomTimes {
    double baseline = 0.0, subject = 0.0, baselineOfLimit = 0.0, limit = 0.0;

    void add(const HeadroomTimes& other) {
        baseline += other.baseline;
        subject += other.subject;
        baselineOfLimit += other.baselineOfLimit;
        limit += other.limit;
    }
    /// None: the limit saves nothing.
    [[nodiscard]] std::optional<double> share() const {
        if (!(limit < baselineOfLimit) || !(baseline > 0.0)) return std::nullopt;
        return (1.0 - subject / baseline) / (1.0 - limit / baselineOfLimit);
    }
};

/// The turns in which all four were timed.
size_t turnsOf(const TimesBesideLimit& view) {
    return std::min({view.baseline.size(), view.subject.size(), view.baselineOfLimit.size(), view.limit.size()});
}

HeadroomTimes mediansOf(const TimesBesideLimit& view) {
    return {quantile(view.baseline, 0.5), quantile(view.subject, 0.5), quantile(view.baselineOfLimit, 0.5),
            quantile(view.limit, 0.5)};
}

/// The view's medians over turns that are drawn with replacement.
HeadroomTimes resampled(const TimesBesideLimit& view, Random& random, TimesBesideLimit& drawn) {
    const size_t turns = turnsOf(view);
    for (std::vector<double>* times : {&drawn.baseline, &drawn.subject, &drawn.baselineOfLimit, &drawn.limit})
        times->resize(turns);
    for (size_t i = 0; i < turns; ++i) {
        const size_t from = random.bits() % turns;
        drawn.baseline[i] = view.baseline[from];
        drawn.subject[i] = view.subject[from];
        drawn.baselineOfLimit[i] = view.baselineOfLimit[from];
        drawn.limit[i] = view.limit[from];
    }
    return mediansOf(drawn);
}

}  // namespace

RatioEstimate ratioOfTotals(std::span<const ViewTimes> views) {
    const auto counted =
        static_cast<size_t>(std::ranges::count_if(views, [](const ViewTimes& view) { return pairsOf(view) > 0; }));
    if (counted == 0) return {};
    // Every view is resampled beforehand: a resample of the views takes one of each drawn view's resamples.
    const size_t each = std::max(kLeastResamplesOfAView, kResamples / counted);
    Random random(1);
    Times total;
    std::vector<Times> ofViews;
    ofViews.reserve(counted * each);
    ViewTimes drawn;
    for (const ViewTimes& view : views) {
        if (pairsOf(view) == 0) continue;
        const Times median = mediansOf(view);
        total.baseline += median.baseline;
        total.subject += median.subject;
        for (size_t i = 0; i < each; ++i) ofViews.push_back(resampled(view, random, drawn));
    }
    std::vector<double> ratios(kResamples);
    for (double& ratio : ratios) {
        Times sum;
        for (size_t i = 0; i < counted; ++i) {
            const Times& one = ofViews[random.bits() % ofViews.size()];
            sum.baseline += one.baseline;
            sum.subject += one.subject;
        }
        ratio = ratioOf(sum);
    }
    const bool once = std::ranges::all_of(views, [](const ViewTimes& view) { return pairsOf(view) <= 1; });
    // Medians of a few times are not those of their resamples: the interval then reaches to the estimate.
    const double estimate = ratioOf(total);
    const auto [low, high] = middle95(ratios);
    return {estimate, {std::min(low, estimate), std::max(high, estimate)}, counted > 1 || !once};
}

RatioEstimate meanOfRatios(const std::vector<double>& ratios) {
    if (ratios.empty()) return {};
    const auto n = ratios.size();
    Random random(1);
    std::vector<double> means(kResamples);
    for (double& mean : means) {
        double sum = 0.0;
        for (size_t i = 0; i < n; ++i) sum += ratios[random.bits() % n];
        mean = sum / double(n);
    }
    return {std::accumulate(ratios.begin(), ratios.end(), 0.0) / double(n), middle95(means), n > 1};
}

std::optional<RatioEstimate> shareOfHeadroom(std::span<const TimesBesideLimit> views) {
    if (views.empty()) return std::nullopt;
    const size_t each = std::max(kLeastResamplesOfAView, kResamples / views.size());
    Random random(1);
    HeadroomTimes total;
    std::vector<HeadroomTimes> ofViews;
    ofViews.reserve(views.size() * each);
    TimesBesideLimit drawn;
    for (const TimesBesideLimit& view : views) {
        total.add(mediansOf(view));
        for (size_t i = 0; i < each; ++i) ofViews.push_back(resampled(view, random, drawn));
    }
    const std::optional<double> share = total.share();
    if (!share) return std::nullopt;
    std::vector<double> shares;
    for (size_t i = 0; i < kResamples; ++i) {
        HeadroomTimes sum;
        for (size_t k = 0; k < views.size(); ++k) sum.add(ofViews[random.bits() % ofViews.size()]);
        if (const std::optional<double> one = sum.share()) shares.push_back(*one);
    }
    constexpr double kAgreeing = 0.975;
    if (double(shares.size()) < kAgreeing * double(kResamples)) return std::nullopt;
    const bool once = std::ranges::all_of(views, [](const TimesBesideLimit& view) { return turnsOf(view) <= 1; });
    const auto [low, high] = middle95(shares);
    return RatioEstimate{*share, {std::min(low, *share), std::max(high, *share)}, views.size() > 1 || !once};
}

std::array<double, 2> middle95(const std::vector<double>& values) { return {quantile(values, 0.025), quantile(values, 0.975)}; }

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const double rank = share * double(values.size() - 1);
    const auto below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (values[above] - values[below]) * (rank - double(below));
}

}  // namespace cullscope
