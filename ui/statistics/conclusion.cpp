#include "ui/statistics/conclusion.h"
#include "ui/text/terms.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace cullscope::ui {

namespace {

struct Conclusion {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::Conclusion)
};

/// "×1.43 (95 %: 1.40 to 1.46)"; without the interval where there is none.
QString speedOf(const RatioEstimate& speed) {
    if (!speed.hasInterval) return QStringLiteral("×%1").arg(ratioWithTwoDigits(speed.ratio));
    return Conclusion::tr("×%1 (95 %: %2 to %3)", "a ratio of times and its interval")
        .arg(ratioWithTwoDigits(speed.ratio), ratioWithTwoDigits(speed.ci95[0]), ratioWithTwoDigits(speed.ci95[1]));
}

bool surelyFaster(const RatioEstimate& speed) { return (speed.hasInterval ? speed.ci95[0] : speed.ratio) > 1.0; }

/// The run with the largest ratio among those that a condition holds for; null: there is none.
template <typename Condition>
const RunFigures* fastest(const std::vector<RunFigures>& runs, const Condition& condition) {
    const RunFigures* best = nullptr;
    for (const RunFigures& run : runs)
        if (!run.baseline && !run.limit && condition(run) && (!best || run.speedup.ratio > best->speedup.ratio)) best = &run;
    return best;
}

QString worstOf(const RunFigures& run) {
    const auto worst = std::ranges::max_element(run.poses, {}, &PoseFigures::missedPixels);
    return worst == run.poses.end() ? QString() : QString::number(worst->pose);
}

/// What any culling could gain, and which share of it the fastest strategy without loss has; empty: it was not measured.
QString headroomOf(const std::vector<RunFigures>& runs, const RunFigures* safe) {
    const auto limit = std::ranges::find(runs, true, &RunFigures::limit);
    if (limit == runs.end()) return {};
    if (!surelyFaster(limit->speedup))
        return Conclusion::tr(
            "Drawing everything is best here: not even exactly the visible triangles, known beforehand, are "
            "surely faster.");
    const QString most =
        Conclusion::tr("Any culling could gain at most %1 here: so much faster are exactly the visible triangles.")
            .arg(speedOf(limit->speedup));
    if (!safe || !safe->headroomShare) return most;
    return most + QLatin1Char(' ') +
           Conclusion::tr("%1 saves %2 % of the time that can be saved.", "a strategy")
               .arg(safe->label, QLocale().toString(100.0 * safe->headroomShare->ratio, 'f', 0));
}

}  // namespace

QStringList conclusionsOf(const std::vector<RunFigures>& runs) {
    QStringList sentences;
    const auto lossless = [](const RunFigures& run) { return run.missedPpm == 0.0; };
    const RunFigures* safe = fastest(runs, lossless);
    if (safe && surelyFaster(safe->speedup))
        sentences << Conclusion::tr("Fastest without a lost pixel: %1, %2 against drawing everything with the same sides.")
                         .arg(safe->label, speedOf(safe->speedup));
    else if (safe)
        sentences << Conclusion::tr(
                         "No strategy that loses no pixel is surely faster than drawing everything with the same sides; the best "
                         "one is %1 with %2.")
                         .arg(safe->label, speedOf(safe->speedup));
    const RunFigures* lossy = fastest(runs, [](const RunFigures& run) { return run.missedPpm.value_or(0.0) > 0.0; });
    if (lossy && surelyFaster(lossy->speedup) && (!safe || lossy->speedup.ratio > safe->speedup.ratio))
        sentences << Conclusion::tr("Faster, with losses: %1, %2; it loses %3 of a million pixels, most of them at pose %4.")
                         .arg(lossy->label, speedOf(lossy->speedup), significantText(*lossy->missedPpm), worstOf(*lossy));
    if (const QString headroom = headroomOf(runs, safe); !headroom.isEmpty()) sentences << headroom;
    for (const RunFigures& run : runs)
        if (run.promise != Promise::Approximate && run.missedPpm.value_or(0.0) > 0.0)
            sentences << Conclusion::tr("%1 promises to lose nothing and lost %2 of a million pixels: the promise is broken.")
                             .arg(run.label, significantText(*run.missedPpm));
    const bool unmeasured = std::ranges::any_of(runs, [](const RunFigures& run) { return !run.missedPpm; });
    if (unmeasured) sentences << Conclusion::tr("Losses were not measured of every strategy.");
    if (sentences.isEmpty()) sentences << Conclusion::tr("Only baselines were measured: there is nothing to compare.");
    return sentences;
}

QStringList conclusionsOf(const MeasureResult& result) {
    QStringList sentences = conclusionsOf(runFigures(result));
    if (result.gl.software)
        sentences << Conclusion::tr("A software OpenGL drew: on a graphics card drawing takes less, and culling the same.");
    if (result.interrupted) sentences << Conclusion::tr("The measurement was stopped early: poses are missing.");
    return sentences;
}

}  // namespace cullscope::ui
