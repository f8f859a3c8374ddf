#include "core/experiments/checks.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace cullscope::checks_test {
namespace {

/// y = x², and a column of ratios.
ResultTable squares() {
    ResultTable table;
    table.experiment = "squares";
    table.columns = {{"x", "x"}, {"y", "y"}, {"ratio", "ratio"}};
    for (const double x : {1.0, 2.0, 4.0, 8.0}) table.addRow({{"x", x}, {"y", x * x}, {"ratio", 3.0 - x / 4}});
    return table;
}

CheckResult held(const Check& check, const ResultTable& table = squares()) { return checked({check}, table).front(); }

TEST(Checks, exponentIsHeldAgainstBothLimits) {
    const RowPoints points{{}, "x", "y"};
    EXPECT_NEAR(*held(exponentCheck("power", points)).value, 2.0, 1e-12);
    EXPECT_TRUE(held(exponentCheck("power", points)).holds()) << "without limits it is only told";
    EXPECT_TRUE(held(exponentCheck("power", points, {1.9, 2.1})).holds());
    EXPECT_FALSE(held(exponentCheck("power", points, {.most = 1.9})).holds());
    EXPECT_FALSE(held(exponentCheck("power", points, {.least = 2.1})).holds());
}

TEST(Checks, oneRowThatBreaksTheLimitIsEnough) {
    const CheckResult least = held(everyRowCheck("ratio", {}, "ratio", {.least = 1.5}));
    EXPECT_FALSE(least.holds());
    EXPECT_EQ(least.value, 1.0) << "the row that is farthest from holding";
    EXPECT_EQ(held(everyRowCheck("ratio", {}, "ratio", {.most = 2.0})).value, 2.75);
    EXPECT_TRUE(held(everyRowCheck("ratio", {{"x", {1.0, 2.0}}}, "ratio", {.least = 1.5})).holds()) << "of the chosen rows";
}

TEST(Checks, whatIsNoNumberDoesNotHold) {
    ResultTable table = squares();
    table.addRow({{"x", 16.0}, {"ratio", std::nan("")}});
    EXPECT_FALSE(held(everyRowCheck("ratio", {}, "ratio", {.most = 5.0}), table).holds());
}

TEST(Checks, whatWasNotMeasuredHolds) {
    const Check check = everyRowCheck("ratio", {{"x", {3.0}}}, "ratio", {.least = 1.5});
    EXPECT_FALSE(held(check).value);
    EXPECT_TRUE(held(check).holds());
    EXPECT_EQ(checkText(held(check)), "ratio: not measured (at least 1.5)");
    EXPECT_FALSE(held(exponentCheck("power", {{{"x", {1.0}}}, "x", "y"}, {.most = 1.0})).value) << "of one point";
}

TEST(Checks, tablesSayWhichOnesDoNotHold) {
    ResultTable table = squares();
    EXPECT_FALSE(nlohmann::json::parse(tablesJson({table}))["experiments"][0].contains("checks")) << "it has none";
    table.checks = checked({exponentCheck("y grows with x to the power of", {{}, "x", "y"}, {.most = 1.5})}, table);
    EXPECT_TRUE(table.checkFailed());
    EXPECT_THAT(tableText(table), testing::HasSubstr("y grows with x to the power of: 2 (at most 1.5), DOES NOT HOLD\n"));
    const nlohmann::json json = nlohmann::json::parse(tablesJson({table}))["experiments"][0]["checks"][0];
    EXPECT_EQ(json["check"], "y grows with x to the power of");
    EXPECT_EQ(json["most"], 1.5);
    EXPECT_TRUE(json["least"].is_null());
    EXPECT_EQ(json["holds"], false);
}

}  // namespace
}  // namespace cullscope::checks_test
