#include "core/visibility/registry.h"

#include <set>

#include "core/base/error.h"
#include "core/visibility/built_strategy.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::registry_test {
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
        std::string known;
        for (const RegisteredStrategy& strategy : strategies()) known += (known.empty() ? "" : ", ") + strategy.info.id;
        EXPECT_THAT(error.what(), testing::HasSubstr("Known: " + known + "."));
    }
}

TEST(Registry, builtStrategyHasTheGivenParameters) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0)});
    StructureStore store;
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    parameters.setFromText("box", "length");
    const BuiltStrategyPointer built = buildStrategy("frustum", parameters, scene, store);
    EXPECT_EQ(built->id(), "frustum");
    EXPECT_EQ(built->parameters(), parameters);
    EXPECT_EQ(built->scenePointer(), scene);
    EXPECT_THROW((void)buildStrategy("frustrum", parameters, scene, store), Error);
}

}  // namespace
}  // namespace cullscope::test::registry_test
