#include "core/visibility/strategy_request.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace cullscope::test::strategy_request_test {
namespace {

std::string refusal(const std::string& text) {
    return refusalOf([&] { (void)strategyFromText(text); }, ErrorKind::Usage);
}

TEST(StrategyText, parametersAreReadAndWritten) {
    const StrategyRequest strategy = strategyFromText("frustum:facing=two-sided:box=length");
    EXPECT_EQ(strategy.id, "frustum");
    EXPECT_EQ(strategy.parameters.choice("facing"), "two-sided");
    EXPECT_EQ(strategy.parameters.choice("box"), "length");
    EXPECT_EQ(strategyText(strategy), "frustum:facing=two-sided:box=length");
}

TEST(StrategyText, defaultsAreNotWritten) {
    EXPECT_EQ(strategyText(strategyFromText("all")), "all");
    EXPECT_EQ(strategyText(strategyFromText("frustum:facing=auto")), "frustum");
}

TEST(StrategyText, labelIsTheSameToBeRead) {
    EXPECT_EQ(strategyLabel(strategyFromText("all")), "all");
    EXPECT_EQ(strategyLabel(strategyFromText("frustum:facing=two-sided:box=length")), "frustum facing=two-sided box=length");
}

TEST(StrategyText, listTakenApartAtItsCommasIsRead) {
    using Texts = std::vector<std::string>;
    const auto readAndWritten = [](const Texts& texts) {
        Texts written;
        for (const StrategyRequest& strategy : strategiesFromText(texts)) written.push_back(strategyText(strategy));
        return written;
    };
    EXPECT_EQ(readAndWritten({"all", "frustum:facing=two-sided", "box=length", "backface"}),
              (Texts{"all", "frustum:facing=two-sided:box=length", "backface"}));
    EXPECT_EQ(readAndWritten({"frustum:facing=two-sided,box=length"}), (Texts{"frustum:facing=two-sided:box=length"}));
    EXPECT_EQ(readAndWritten({"all,frustum:facing=two-sided,box=length,backface"}),
              (Texts{"all", "frustum:facing=two-sided:box=length", "backface"}));
    EXPECT_EQ(readAndWritten({}), Texts{});
}

TEST(StrategyText, whatIsUnknownIsRefused) {
    EXPECT_NE(refusal("frustrum").find("Known: all"), std::string::npos);
    EXPECT_NE(refusal("frustum:faces=both").find("Known: "), std::string::npos);
    EXPECT_NE(refusal("frustum:facing=both").find("two-sided"), std::string::npos);
    EXPECT_EQ(refusal("frustum:facing"), "\"facing\" is not of the form key=value.");
    EXPECT_EQ(refusal("backface:facing=front"), "The strategy \"backface\" has no parameters.");
    EXPECT_EQ(refusal("frustum:box=length:box=length"), "frustum:box=length:box=length: box is given twice.");
}

TEST(StrategyText, listWithACommaTooManyIsRefused) {
    for (const std::string text : {"all,,frustum", "all,", ",all", ","})
        EXPECT_NE(refusalOf([&] { (void)strategiesFromText({text}); }, ErrorKind::Usage).find("lacks a strategy"),
                  std::string::npos)
            << text;
}

}  // namespace
}  // namespace cullscope::test::strategy_request_test
