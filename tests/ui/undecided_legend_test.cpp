// While a frame is stepped through, the legend has the state of triangles about which nothing was decided yet.

#include <QLabel>

#include "tests/ui/shown_window.h"
#include "ui/panels/legend_panel.h"

namespace cullscope::ui::undecided_legend_test {
namespace {

struct UndecidedLegend : Window {
    [[nodiscard]] bool shown() {
        auto* legend = window.findChild<LegendPanel*>();
        if (legend == nullptr) return false;
        for (const QLabel* label : legend->findChildren<QLabel*>())
            if (label->text() == QStringLiteral("not yet decided")) return !label->isHidden();
        return false;
    }
};

TEST_F(UndecidedLegend, isShownWhileStepping) {
    session.setActiveView(0);
    session.slot(0).choose("frustum");
    ViewSetup setup = session.setup(0);
    setup.look.show("verdicts", true);
    session.setSetup(0, setup);
    settle();
    EXPECT_FALSE(shown());
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(
        waitUntil([&] { return session.step() && session.pictures()->isCurrent(0) && session.picture(0)->request.upTo; }));
    EXPECT_TRUE(shown());
    settle();
    // The counts are those of the whole frame: a 0 would say that all is decided at this step.
    int counts = 0;
    for (const QLabel* label : window.legend().findChildren<QLabel*>())
        if (label->accessibleName() == QStringLiteral("not yet decided")) {
            EXPECT_EQ(label->text(), QString());
            ++counts;
        }
    EXPECT_EQ(counts, 1);
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.picture(0)->request.upTo; }));
    EXPECT_FALSE(shown());
}

}  // namespace
}  // namespace cullscope::ui::undecided_legend_test
