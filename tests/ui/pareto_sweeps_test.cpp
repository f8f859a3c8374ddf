// Sweeps over parameters: the lines of the Pareto plot, and how sweeps are started, shown and stopped.
#include <gtest/gtest.h>

#include <QTest>
#include <QXmlStreamReader>

#include "tests/ui/made_up_result.h"
#include "ui/jobs/experiment_runner.h"
#include "ui/plots/plot_file.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui::pareto_sweeps_test {
namespace {

constexpr int kPatience = 60'000;  // ms

/// The measurement of a strategy with one parameter changed.
RunMeasurement swept(const std::string& id, const std::string& key, const std::string& value, double milliseconds,
                     uint64_t missed) {
    RunMeasurement made = run(id, milliseconds, {missed, missed});
    made.strategy.parameters.setFromText(key, value);
    return made;
}

/// A result with two sweeps of `spherical` that cross at its default parameters, one sweep of `spherical-lossless` that begins
/// with level 0 (the strategy's own choice), and `frustum`.
MeasureResult sweptResult() {
    MeasureResult result = madeUpResult();
    result.runs = {run("all", 10.0, {0, 0}),
                   run("backface", 8.0, {0, 0}),
                   run("frustum", 6.0, {0, 0}),
                   swept("spherical", "rows", "360", 5.0, 3),
                   swept("spherical", "rows", "45", 4.0, 90),
                   swept("spherical", "rows", "180", 4.5, 20),
                   swept("spherical", "band", "2.5", 5.5, 9),
                   swept("spherical", "band", "20", 3.5, 400),
                   swept("spherical-lossless", "level", "0", 3.0, 0),
                   swept("spherical-lossless", "level", "8", 3.4, 0),
                   swept("spherical-lossless", "level", "6", 3.6, 0)};
    return result;
}

/// All texts of a plot's SVG export.
QStringList wordsOf(const PlotWidget& plot) {
    QXmlStreamReader reader(plotSvg(plot, {960, 420}));
    QStringList words;
    while (!reader.atEnd())
        if (reader.readNext() == QXmlStreamReader::Characters && !reader.text().trimmed().isEmpty())
            words << reader.text().trimmed().toString();
    return words;
}

TEST(RunSweeps, runsThatDifferInOneParameterAreOneSweep) {
    const std::vector<RunSweep> sweeps = runSweeps(runFigures(sweptResult()));
    ASSERT_EQ(sweeps.size(), 3U);
    EXPECT_EQ(sweeps[0].key, "rows");
    EXPECT_EQ(sweeps[0].runs, (std::vector<size_t>{4, 5, 3})) << "not by value";
    EXPECT_EQ(sweeps[0].values, QStringList({"45", "180", "360"}));
    EXPECT_EQ(sweeps[1].key, "band");
    EXPECT_EQ(sweeps[1].runs, (std::vector<size_t>{6, 5, 7})) << "without the run at which it crosses the other";
    EXPECT_EQ(sweeps[1].values, QStringList({"2.5°", "5°", "20°"}));
    EXPECT_EQ(sweeps[2].id, QStringLiteral("spherical-lossless"));
    EXPECT_EQ(sweeps[2].values, QStringList({"6", "8", "auto"})) << "the strategy's own choice is not the least value";
}

TEST(RunSweeps, runsThatDifferInTwoParametersAreNone) {
    MeasureResult result = madeUpResult();
    result.runs = {swept("spherical", "rows", "45", 5.0, 3), swept("spherical", "band", "20", 4.0, 90)};
    EXPECT_TRUE(runSweeps(runFigures(result)).empty());
}

TEST(ParetoFronts, pointsHaveTheirValuesAndTheLegendTheSweeps) {
    ParetoPlot plot;
    plot.setRuns(runFigures(sweptResult()));
    const QStringList words = wordsOf(plot);
    for (const char* expected : {"45", "360", "180 · 5°", "2.5°", "20°", "6", "8", "auto", "spherical by rows",
                                 "spherical by band", "spherical-lossless by level", "0 of 2"})
        EXPECT_EQ(words.count(QString::fromUtf8(expected)), 1) << expected << " in " << words.join('|').toStdString();
    EXPECT_EQ(words.count(QStringLiteral("frustum")), 2) << "at its point and in the legend, as it lies on no sweep";
}

TEST(ParetoFronts, everySweepIsALineOfItsColour) {
    ParetoPlot plot;
    plot.resize(900, 300);
    plot.setRuns(runFigures(sweptResult()));
    const QByteArray svg = plotSvg(plot, {900, 300});
    const PlotColours colours(plot.palette());
    for (size_t sweep = 0; sweep < 3; ++sweep) EXPECT_TRUE(svg.contains(colours.series(sweep).name().toLatin1())) << sweep;
}

TEST(ExperimentBar, sweepsAreOfferedWithTheirValuesAndStarted) {
    StatisticsPanel panel;
    std::vector<ExperimentSettings> asked;
    QObject::connect(&panel, &StatisticsPanel::startRequested,
                     [&](const ExperimentSettings& settings) { asked.push_back(settings); });
    const QList<QAction*> offers = panel.bar().sweeps().actions();
    ASSERT_EQ(offers.size(), qsizetype(builtInSweeps().size()) + 2) << "all of them, a separator, and each";
    const auto offer = [&](const QString& text) {
        const auto found = std::ranges::find(offers, text, &QAction::text);
        return found == offers.end() ? nullptr : *found;
    };
    EXPECT_NE(offer(QStringLiteral("spherical-lossless by level: 4, 5, 6, 7, 8, auto")), nullptr);
    QAction* const rows = offer(QStringLiteral("spherical by rows: 45, 90, 180, 360"));
    ASSERT_NE(rows, nullptr);
    rows->trigger();
    EXPECT_TRUE(asked.empty()) << "there is no scene";
    panel.setScene(madeUpResult().request.scene);
    rows->trigger();
    ASSERT_EQ(asked.size(), 1U);
    ASSERT_EQ(asked[0].sweeps.size(), 1U);
    EXPECT_EQ(asked[0].sweeps[0].key, "rows");
    offers[0]->trigger();
    EXPECT_EQ(asked.back().sweeps.size(), builtInSweeps().size());
    panel.bar().start();
    EXPECT_TRUE(asked.back().sweeps.empty()) << "Start measures the shown views";
}

TEST(ExperimentBar, sweepShowsItsPlot) {
    StatisticsPanel panel;
    panel.resize(926, 260);
    panel.setScene(madeUpResult().request.scene);
    panel.show();
    auto* plot = panel.findChild<ParetoPlot*>();
    ASSERT_NE(plot, nullptr);
    EXPECT_FALSE(plot->isVisible());
    panel.bar().sweeps().actions()[0]->trigger();
    panel.setRunning(true);
    EXPECT_TRUE(plot->isVisible());
    EXPECT_EQ(plot->accessibleDescription(), QStringLiteral("Being measured…"));
    panel.setRunning(false);
    EXPECT_TRUE(plot->accessibleDescription().startsWith(QStringLiteral("Nothing is measured yet")));
}

/// An experiment that sweeps parameters on a scene of nine small objects.
MeasureRequest sweepRequest(const std::string& path) {
    MeasureRequest request = test::smallExperiment({});
    request.strategies = requestsOf(sweepExperiment(builtInSweeps()).settings.front());
    request.path = cameraPath(path, *request.scene);
    request.timing.fixedRepetitions = 1;
    request.baselinesToo = true;
    return request;
}

TEST(Sweep, everyValueIsARunBesideTheBaselines) {
    GpuThread gpu;
    ExperimentRunner runner(&gpu, std::make_shared<StructureStore>());
    std::optional<MeasureResult> result;
    QObject::connect(&runner, &ExperimentRunner::finished, [&](const MeasureResult& finished) { result = finished; });
    const MeasureRequest request = sweepRequest("walk:2");
    runner.start(request);
    ASSERT_TRUE(QTest::qWaitFor([&] { return result.has_value(); }, kPatience));
    ASSERT_EQ(result->runs.size(), request.strategies.size() + 2);
    EXPECT_EQ(result->runs.back().strategy.id, "backface");
    const std::vector<RunSweep> measured = runSweeps(runFigures(*result));
    ASSERT_EQ(measured.size(), builtInSweeps().size());
    for (size_t i = 0; i < measured.size(); ++i) EXPECT_EQ(measured[i].runs.size(), builtInSweeps()[i].values.size()) << i;
}

TEST(Sweep, pointsAppearWhileItRunsAndCancellingKeepsThem) {
    GpuThread gpu;
    ExperimentRunner runner(&gpu, std::make_shared<StructureStore>());
    std::optional<MeasureResult> partial, result;
    QObject::connect(&runner, &ExperimentRunner::partial, [&](const MeasureResult& some) { partial = some; });
    QObject::connect(&runner, &ExperimentRunner::finished, [&](const MeasureResult& finished) { result = finished; });
    runner.start(sweepRequest("walk:3000"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return partial.has_value(); }, kPatience));
    EXPECT_FALSE(result);
    ParetoPlot plot;
    plot.setRuns(runFigures(*partial));
    EXPECT_TRUE(wordsOf(plot).contains(QStringLiteral("spherical-lossless by level")));
    runner.cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return result.has_value(); }, kPatience));
    EXPECT_TRUE(result->interrupted);
    EXPECT_EQ(runSweeps(runFigures(*result)).size(), builtInSweeps().size());
}

}  // namespace
}  // namespace cullscope::ui::pareto_sweeps_test
