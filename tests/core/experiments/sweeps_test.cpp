#include "core/experiments/sweeps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cullscope::sweeps_test {
namespace {

TEST(Fronts, everyValueIsOneThatItsStrategyTakes) {
    ASSERT_FALSE(builtInSweeps().empty());
    for (const ParameterSweep& sweep : builtInSweeps()) {
        SCOPED_TRACE(sweep.strategy + "." + sweep.key);
        ParameterSet parameters(findStrategy(sweep.strategy).info.parameters);
        std::set<std::string> different;
        for (const std::string& value : sweep.values) {
            EXPECT_NO_THROW(parameters.setFromText(sweep.key, value)) << value;
            different.insert(toText(parameters.value(sweep.key)));
        }
        EXPECT_EQ(different.size(), sweep.values.size()) << "one value is written in two ways";
        EXPECT_GE(sweep.values.size(), 2u) << "one point is no sweep";
        if (!sweep.automatic.empty()) {
            EXPECT_EQ(std::count(sweep.values.begin(), sweep.values.end(), sweep.automatic), 1);
        }
    }
}

TEST(Fronts, everySweepHasItsStrategysDefaultOnIt) {
    for (const ParameterSweep& sweep : builtInSweeps()) {
        const ParameterSet defaults(findStrategy(sweep.strategy).info.parameters);
        EXPECT_EQ(std::count(sweep.values.begin(), sweep.values.end(), toText(defaults.value(sweep.key))), 1)
            << sweep.strategy << "." << sweep.key;
    }
}

TEST(Fronts, whereTwoCrossIsMeasuredOnce) {
    const std::vector<ParameterSweep> crossing{{"spherical", "rows", {"45", "180"}}, {"spherical", "band", {"5", "10"}}};
    const std::vector<StrategyRequest> requests = requestsOf(sweepExperiment(crossing).settings.front());
    ASSERT_EQ(requests.size(), 3u) << "180 rows and bands of 5° are both the default";
    EXPECT_EQ(requests[0].parameters.integer("rows"), 45);
    EXPECT_EQ(requests[0].parameters.real("band"), 5.0);
    EXPECT_EQ(requests[1].parameters.integer("rows"), 180);
    EXPECT_EQ(requests[2].parameters.integer("rows"), 180);
    EXPECT_EQ(requests[2].parameters.real("band"), 10.0);
}

}  // namespace
}  // namespace cullscope::sweeps_test
