#include "core/experiments/sweeps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cullscope::sweeps_test {
namespace {

TEST(Fronts, everyValueIsOneThatItsStrategyTakes) {
    ASSERT_FALSE(fronts().empty());
    for (const ParameterSweep& front : fronts()) {
        SCOPED_TRACE(front.strategy + "." + front.key);
        ParameterSet parameters(findStrategy(front.strategy).info.parameters);
        std::set<std::string> different;
        for (const std::string& value : front.values) {
            EXPECT_NO_THROW(parameters.setFromText(front.key, value)) << value;
            different.insert(toText(parameters.value(front.key)));
        }
        EXPECT_EQ(different.size(), front.values.size()) << "one value is written in two ways";
        EXPECT_GE(front.values.size(), 2u) << "one point is no front";
        if (!front.automatic.empty()) {
            EXPECT_EQ(std::count(front.values.begin(), front.values.end(), front.automatic), 1);
        }
    }
}

TEST(Fronts, everyFrontHasItsStrategysDefaultOnIt) {
    for (const ParameterSweep& front : fronts()) {
        const ParameterSet defaults(findStrategy(front.strategy).info.parameters);
        EXPECT_EQ(std::count(front.values.begin(), front.values.end(), toText(defaults.value(front.key))), 1)
            << front.strategy << "." << front.key;
    }
}

TEST(Fronts, whereTwoCrossIsMeasuredOnce) {
    const std::vector<ParameterSweep> crossing{{"spherical", "rows", {"45", "180"}}, {"spherical", "band", {"5", "10"}}};
    const std::vector<StrategyRequest> requests = contestants(crossing);
    ASSERT_EQ(requests.size(), 3u) << "180 rows and bands of 5° are both the default";
    EXPECT_EQ(requests[0].parameters.integer("rows"), 45);
    EXPECT_EQ(requests[0].parameters.real("band"), 5.0);
    EXPECT_EQ(requests[1].parameters.integer("rows"), 180);
    EXPECT_EQ(requests[2].parameters.integer("rows"), 180);
    EXPECT_EQ(requests[2].parameters.real("band"), 10.0);
}

}  // namespace
}  // namespace cullscope::sweeps_test
