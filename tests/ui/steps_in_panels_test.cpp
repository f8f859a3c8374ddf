// The panels beside a stepped frame: which one is in front, and what "Why" says at a step.

#include "tests/ui/stepped_window.h"

namespace cullscope::ui::steps_in_panels_test {
namespace {

/// The lecture's quiz with the tree of its planes in the first view.
struct StepsInPanels : SteppedWindow {
    void SetUp() override {
        Window::SetUp();
        openAndWait(session, QStringLiteral("quiz"));
        session.setActiveView(0);
        ParameterSet parameters(findStrategy("bsp").info.parameters);
        parameters.setFromText("plane", "given");
        session.slot(0).choose("bsp");
        session.slot(0).setParameters(parameters);
        settleAll();
    }
};

TEST_F(StepsInPanels, listingComesToTheFrontUntilAnotherTabIsChosenWhileStepping) {
    QTabWidget& tabs = window.tabs();
    tabs.setCurrentIndex(0);
    begin();
    EXPECT_EQ(tabs.currentWidget(), &window.structurePanel().listing());
    window.actions().stepThrough->trigger();
    tabs.setCurrentIndex(0);
    begin();
    EXPECT_EQ(tabs.currentWidget(), &window.structurePanel().listing()) << "nothing was chosen while stepping";
    const int tree = tabs.indexOf(&window.structurePanel().tree());
    QTest::mouseClick(tabs.tabBar(), Qt::LeftButton, {}, tabs.tabBar()->tabRect(tree).center());
    EXPECT_EQ(tabs.currentIndex(), tree);
    window.actions().stepThrough->trigger();
    begin();
    EXPECT_EQ(tabs.currentIndex(), tree) << "the user's choice stays";
}

TEST_F(StepsInPanels, whyAtAStepSaysWhatIsDecidedSoFar) {
    const Scene& scene = *session.scene();
    const uint64_t last = scene.firstTriangle(2);  // of C, which is drawn at last
    session.setPick(Pick{2, last, Vec3(0.0)});
    begin();
    showStep(3);
    WhyPanel& why = window.structurePanel().why();
    ASSERT_TRUE(waitUntil([&] {
        return !why.sentences().isEmpty() &&
               why.sentences().back() == QStringLiteral("Up to this step nothing of it is decided, and nothing of it is drawn.");
    })) << why.sentences().join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(why.outcome().isEmpty()) << "the truth is compared with the whole frame";
    showStep(stepper().place()->count());
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] {
        return !why.sentences().isEmpty() && why.sentences().back() == QStringLiteral("It shows in the picture.");
    })) << why.sentences().join(QLatin1Char('\n')).toStdString();
}

}  // namespace
}  // namespace cullscope::ui::steps_in_panels_test
