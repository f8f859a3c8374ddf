// Small-feature culling in the window: stepped as every other method, with the outline told apart and the losses beside the
// parameters.

#include <QLabel>
#include <QRegularExpression>
#include <QSlider>

#include "tests/ui/stepped_window.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/strategy_panel.h"

namespace cullscope::ui::small_feature_steps_test {
namespace {

struct SmallFeatureSteps : SteppedWindow {
    void SetUp() override {
        Window::SetUp();
        session.setViewCount(1);
        session.setActiveView(0);
        ViewSetup setup = session.setup(0);
        setup.size = Viewport{240, 180};
        session.setSetup(0, setup);
        openAndWait(session, QStringLiteral("plant:pipelines=1"));
    }

    void choose(const char* id) {
        session.slot(0).choose(id);
        settleAll();
    }

    /// The next decision that leaves something out because it is too small, or shows no sample.
    const Decision* nextLeftOut() {
        stepper().setBreakpoints(
            {{EntryKind::Trait::Cause, uint8_t(Cause::TooSmall)}, {EntryKind::Trait::Cause, uint8_t(Cause::NoSample)}});
        stepper().toBreakpoint(true);
        if (!waitUntil([&] { return session.pictures()->isCurrent(0); })) return nullptr;
        const std::optional<FrameEntry> entry = stepper().place()->current();
        return entry && entry->decision ? entry->decision : nullptr;
    }
};

TEST_F(SmallFeatureSteps, stepsLightTheNodeAndSayTheNumbersOfEachTest) {
    choose("small-feature");
    begin();
    StructurePanel& panel = window.structurePanel();
    const Decision* left = nextLeftOut();
    ASSERT_NE(left, nullptr);
    ASSERT_EQ(left->outcome, Decision::Outcome::Culled);
    const uint32_t node = left->subject.number;
    EXPECT_EQ(left->line, 6) << "if t < threshold: leave it out";
    // The step before it is the test, with its numbers.
    showStep(stepper().place()->step() - 1);
    const Decision& test = *stepper().place()->current()->decision;
    EXPECT_EQ(test.line, 5);
    EXPECT_EQ(test.subject.number, node);
    EXPECT_LT(test.operands[0] / test.operands[1], test.operands[3]);
    EXPECT_TRUE(stepper().sentence().contains(QStringLiteral("0.002"))) << stepper().sentence().toStdString();
    EXPECT_FALSE(session.step()->shape.boxes.empty()) << "lit in the view";
    panel.tabs().setCurrentWidget(&panel.listing());
    EXPECT_TRUE(
        waitUntil([&] { return panel.listing().model().index(4, ListingModel::Mark).data().toString() == QStringLiteral("▶"); }));
    EXPECT_TRUE(waitUntil([&] {
        const QModelIndexList rows = panel.tree().view().selectionModel()->selectedRows();
        return !rows.isEmpty() && panel.tree().model().groupAt(rows.front()) == node;
    })) << "lit in the tree";
}

TEST_F(SmallFeatureSteps, theOtherTwoMethodsStopAtWhatTheyLeaveOutToo) {
    for (const char* id : {"small-feature-triangle", "small-feature-bounded"}) {
        SCOPED_TRACE(id);
        choose(id);
        begin();
        const Decision* left = nextLeftOut();
        ASSERT_NE(left, nullptr);
        EXPECT_GT(left->line, 0);
        EXPECT_TRUE(stepper().sentence().contains(QRegularExpression(QStringLiteral("\\d"))))
            << stepper().sentence().toStdString();
        window.actions().stepThrough->trigger();
        settleAll();
    }
}

TEST_F(SmallFeatureSteps, namesOfBothOctreesStandWhole) {
    window.resize(1280, 800);
    choose("small-feature");
    StructureTree& tree = window.structurePanel().tree();
    window.structurePanel().tabs().setCurrentWidget(&tree);
    for (const char* id : {"en", "ko", "zh_CN"}) {
        language.use(QString::fromLatin1(id));
        settleAll();
        ASSERT_TRUE(waitUntil([&] { return tree.model().rowCount() == 2; }));
        for (int row = 0; row < 2; ++row) {
            const QModelIndex octree = tree.model().index(row, StructureModel::Name);
            EXPECT_GE(tree.view().visualRect(octree).width(), tree.view().sizeHintForIndex(octree).width())
                << octree.data().toString().toStdString();
        }
    }
    language.use(QStringLiteral("en"));
}

TEST_F(SmallFeatureSteps, outlineIsToldApartInTheObserverWithALegend) {
    choose("small-feature");
    session.setViewCount(2);
    session.observe(1, 0);
    session.setActiveView(1);
    settleAll();
    EXPECT_TRUE(window.legend().meanings().isHidden());
    const QImage before = pixelsAlone(session.picture(1)->colour);
    ViewSetup setup = session.setup(1);
    setup.look.show("outline", true);
    session.setSetup(1, setup);
    settleAll();
    EXPECT_NE(pixelsAlone(session.picture(1)->colour), before);
    EXPECT_FALSE(window.legend().meanings().isHidden());
    EXPECT_EQ(window.legend().meanings().findChild<QLabel*>()->text(), QStringLiteral("outline: always kept"));
    session.setActiveView(0);
    settleAll();
    EXPECT_FALSE(window.legend().meanings().isHidden()) << "the observer's picture stays in sight";
    session.slot(0).choose("frustum");
    settleAll();
    EXPECT_TRUE(window.legend().meanings().isHidden()) << "it keeps no outline";
}

TEST_F(SmallFeatureSteps, missedPixelsStandBesideTheSliderAndFollowIt) {
    choose("small-feature");
    auto* panel = window.findChild<StrategyPanel*>();
    ASSERT_NE(panel, nullptr);
    const auto missed = [&] { return session.figures(0).accuracy.missedPixels; };
    auto* slider = panel->form().findChild<QWidget*>(QStringLiteral("threshold"))->findChild<QSlider*>();
    ASSERT_NE(slider, nullptr);
    slider->setSliderDown(true);
    slider->setSliderPosition(0);
    settleAll();
    EXPECT_EQ(missed(), 0u) << "nothing is below 0";
    EXPECT_TRUE(panel->missed().text().contains(QStringLiteral("0")));
    const QString none = panel->missed().text();
    slider->setSliderPosition(slider->maximum() * 9 / 10);
    EXPECT_FALSE(panel->missed().isEnabled()) << "counted anew";
    EXPECT_EQ(panel->missed().text(), none) << "the last one stays meanwhile";
    settleAll();
    EXPECT_GT(missed(), 100u);
    EXPECT_TRUE(panel->missed().isEnabled());
    EXPECT_NE(panel->missed().text(), none);
    slider->setSliderDown(false);
}

}  // namespace
}  // namespace cullscope::ui::small_feature_steps_test
