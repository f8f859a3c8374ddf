// The strategy of one view is built in the background: what is chosen is never kept waiting by what was chosen before.
#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/scene/scene_source.h"
#include "core/visibility/registry.h"
#include "core/visibility/structure_store.h"
#include "tests/ui/test_scene.h"
#include "ui/jobs/strategy_slot.h"

namespace cullscope::ui::strategy_slot_test {
namespace {

struct Slot : ::testing::Test {
    Slot() {
        slot.setScene(openScene("sphere:triangles=60000").scene);
        QObject::connect(&slot, &StrategySlot::chosen, [this] { ++changes; });
    }
    [[nodiscard]] bool built() {
        return waitUntil([this] { return slot.built() && !slot.building(); });
    }
    static ParameterSet parametersOf(const std::string& id) { return ParameterSet(findStrategy(id).info.parameters); }

    std::shared_ptr<StructureStore> structures = std::make_shared<StructureStore>();
    StrategySlot slot{"all", parametersOf("all"), [](const StrategyInfo&) { return std::optional<Message>(); }, structures};
    int changes = 0;
};

TEST_F(Slot, anotherStrategyDoesNotWaitForTheOneThatIsBeingBuilt) {
    ASSERT_TRUE(built());
    const size_t before = structures->built();
    // Its tree of so many triangles takes seconds.
    slot.choose("bsp");
    ASSERT_TRUE(waitUntil([this] { return slot.building(); }));
    slot.choose("frustum");
    ASSERT_TRUE(built());
    EXPECT_EQ(slot.built()->id(), "frustum");
    EXPECT_EQ(structures->built(), before + 1) << "the tree was built to its end";
}

TEST_F(Slot, otherParametersDoNotWaitForALongBuilding) {
    ASSERT_TRUE(built());
    std::vector<std::string> failures;
    QObject::connect(&slot, &StrategySlot::failed, [&](const Message& why) { failures.push_back(why.english()); });
    slot.choose("bsp");
    QTest::qWait(1100);
    ASSERT_TRUE(slot.building());
    ParameterSet parameters = slot.parameters();
    parameters.setFromText("limit", "1000");
    slot.setParameters(parameters);
    ASSERT_TRUE(waitUntil([&] { return !failures.empty(); })) << "the tree without a limit was waited for";
    EXPECT_THAT(failures.front(), ::testing::HasSubstr("1000"));
}

TEST_F(Slot, aStrategyIsChosenWithItsParametersInOneChangeAndBuiltOnce) {
    ASSERT_TRUE(built());
    const size_t before = structures->built();
    ParameterSet parameters = parametersOf("spherical");
    parameters.setFromText("rows", "500");
    slot.choose("spherical", parameters);
    EXPECT_EQ(changes, 1);
    ASSERT_TRUE(built());
    EXPECT_EQ(slot.built()->parameters(), parameters);
    EXPECT_EQ(structures->built(), before + 1);
    parameters.setFromText("rows", "600");
    slot.choose("spherical", parameters);
    EXPECT_EQ(changes, 2) << "other parameters of the same strategy";
    ASSERT_TRUE(built());
    EXPECT_EQ(slot.built()->parameters(), parameters);
}

TEST_F(Slot, anUnknownStrategyChangesNothing) {
    EXPECT_THROW(slot.choose("none", parametersOf("all")), Error);
    EXPECT_EQ(slot.id(), "all");
    EXPECT_FALSE(slot.everChosen());
    EXPECT_EQ(changes, 0);
}

TEST_F(Slot, whileAParameterIsDraggedWhatIsBuiltOnTheWayIsShown) {
    ASSERT_TRUE(built());
    std::vector<int64_t> shown;
    QObject::connect(&slot, &StrategySlot::builtChanged, [&] {
        if (slot.built() && slot.built()->id() == "spherical") shown.push_back(slot.built()->parameters().integer("rows"));
    });
    ParameterSet parameters = parametersOf("spherical");
    for (const char* rows : {"100", "200", "300"}) {
        parameters.setFromText("rows", rows);
        slot.choose("spherical", parameters);
    }
    ASSERT_TRUE(waitUntil([&] { return !shown.empty() && shown.back() == 300; }));
    EXPECT_EQ(shown.size(), 2u) << "the first one, which was being built, and the last one";
}

}  // namespace
}  // namespace cullscope::ui::strategy_slot_test
