#include "core/visibility/registry.h"

#include <set>

#include "core/base/error.h"

namespace cullscope::registry_test {
namespace {

TEST(Registry, baselinesAreThereAndEveryIdIsThereOnce) {
    std::set<std::string> ids;
    for (const RegisteredStrategy& strategy : strategies())
        EXPECT_TRUE(ids.insert(strategy.info.id).second) << strategy.info.id << " twice";
    EXPECT_THAT(ids, testing::IsSupersetOf({"all", "backface", "frustum"}));
}

TEST(Registry, declarationsAreComplete) {
    for (const RegisteredStrategy& strategy : strategies()) {
        SCOPED_TRACE(strategy.info.id);
        EXPECT_FALSE(strategy.info.name.empty());
        EXPECT_TRUE(strategy.info.description.ends_with('.'));
        for (const ParameterDeclaration& parameter : strategy.info.parameters) {
            SCOPED_TRACE(parameter.key);
            EXPECT_FALSE(parameter.description.empty());
            EXPECT_EQ(parameter.type == ParameterType::Choice, !parameter.choices.empty());
            // The default must be a value that may be set.
            ParameterSet set(strategy.info.parameters);
            EXPECT_NO_THROW(set.set(parameter.key, parameter.defaultValue));
            for (const ParameterDeclaration::Choice& choice : parameter.choices) {
                EXPECT_NO_THROW(set.setFromText(parameter.key, choice.id));
                EXPECT_FALSE(choice.description.empty());
            }
        }
    }
}

TEST(Registry, unknownStrategyIsRefused) {
    try {
        (void)findStrategy("frustrum");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.what(), testing::HasSubstr("\"frustrum\""));
        EXPECT_THAT(error.what(), testing::HasSubstr("all, backface, frustum"));
    }
}

TEST(Registry, madeStrategyHasTheGivenParameters) {
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    parameters.setFromText("box", "length");
    EXPECT_EQ(makeStrategy("frustum", parameters)->parameters(), parameters);
    EXPECT_EQ(makeStrategy("frustum")->parameters().choice("box"), "p-vertex");
}

}  // namespace
}  // namespace cullscope::registry_test
