// Every experiment says what it varies, what it measures, and shows what it has.
#include <gmock/gmock.h>

#include "core/experiments/experiment_list.h"
#include "core/experiments/run_rows.h"
#include "core/experiments/sweeps.h"
#include "tests/support/experiment_faults.h"

namespace cullscope::test::declarations_test {
namespace {

using Kind = Axis::Kind;

TEST(Declarations, ofEveryKnownExperimentAreWhole) {
    for (const Experiment& experiment : knownExperiments())
        EXPECT_THAT(experimentFaults(experiment), testing::IsEmpty()) << experiment.id;
    for (const ParameterSweep& sweep : builtInSweeps())
        EXPECT_THAT(experimentFaults(sweepExperiment({sweep})), testing::IsEmpty()) << sweep.strategy << ", " << sweep.key;
}

TEST(Declarations, everyTableOfTimedMethodsHasTheLimitOfCulling) {
    size_t tables = 0;
    for (const Experiment& experiment : knownExperiments())
        for (const Setting& setting : experiment.settings) {
            if (!setting.timed()) continue;
            EXPECT_THAT(setting.strategies, testing::Contains(limitText())) << experiment.id;
            EXPECT_THAT(emptyTable(experiment).notes.back().english(), testing::StartsWith(limitText())) << experiment.id;
            ++tables;
        }
    EXPECT_GT(tables, 10U);
}

/// An experiment of two scenes and two strategies without a fault.
Experiment faultless() {
    Experiment experiment;
    experiment.id = "made-up";
    experiment.axes = {{"scene", "scene", Kind::Scene, {std::string("sphere"), std::string("torus")}},
                       {"strategy", "strategy", Kind::Strategy, {std::string("all"), std::string("frustum")}}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"fps", "fps"});
    experiment.plots = {RowPlot{logPlot("Speed", "fps", "fps"), "fps", {{"fps"}}}};
    return experiment;
}

TEST(Declarations, whatIsMissingIsNamed) {
    using testing::ElementsAre;
    using testing::HasSubstr;
    const auto faultsWith = [](const std::function<void(Experiment&)>& change) {
        Experiment experiment = faultless();
        change(experiment);
        return experimentFaults(experiment);
    };
    EXPECT_THAT(faultsWith([](Experiment&) {}), testing::IsEmpty());
    EXPECT_THAT(faultsWith([](Experiment& e) { e.axes.clear(); }),
                ElementsAre(HasSubstr("no axes"), HasSubstr("timed in turns")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.axes[0].values.emplace_back(std::string("knot")); }),
                ElementsAre(HasSubstr("scene is in no setting")));
    EXPECT_THAT(faultsWith([](Experiment& e) {
                    e.settings[0].strategies.push_back("backface");
                    e.axes[1].values.clear();
                }),
                ElementsAre(HasSubstr("strategy has no values")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.settings[1].labels["scene"] = std::string("knot"); }),
                testing::Contains(HasSubstr("not on axis scene")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.columns.erase(e.columns.begin()); }),
                ElementsAre(HasSubstr("scene has no column")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.columns.push_back(e.columns.back()); }), ElementsAre(HasSubstr("fps twice")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.columns[2].origin = ResultColumn::Origin::Stated; }),
                ElementsAre(HasSubstr("nothing is measured")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.plots[0].lines = {"facing"}; }), ElementsAre(HasSubstr("\"facing\"")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.plots[0].x = "faces"; }), ElementsAre(HasSubstr("\"faces\"")));
    EXPECT_THAT(faultsWith([](Experiment& e) { e.plots[0].y.clear(); }), ElementsAre(HasSubstr("no function fills")));
}

}  // namespace
}  // namespace cullscope::test::declarations_test
