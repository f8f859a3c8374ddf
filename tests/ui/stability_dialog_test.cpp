#include "ui/dialogs/stability_dialog.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::stability_dialog_test {
namespace {

struct StabilityPage : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
    }

    StabilityDialog& dialog() {
        if (!window.findChild<StabilityDialog*>()) window.actions().stability->trigger();
        return *window.findChild<StabilityDialog*>();
    }
    /// The row of a case.
    QTreeWidgetItem& row(const std::string& id) {
        for (int i = 0; i < dialog().cases().topLevelItemCount(); ++i) {
            QTreeWidgetItem* item = dialog().cases().topLevelItem(i);
            if (item->data(0, Qt::UserRole).toString().toStdString() == id) return *item;
        }
        throw std::runtime_error("no case " + id);
    }
    void runChosen(const std::vector<std::string>& ids) {
        dialog().cases().clearSelection();
        for (const std::string& id : ids) row(id).setSelected(true);
        QSignalSpy ended(&dialog(), &StabilityDialog::ended);
        dialog().runChosenButton().click();
        EXPECT_TRUE(dialog().running());
        EXPECT_TRUE(ended.wait(kPatience));
        EXPECT_FALSE(dialog().running());
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(StabilityPage, listsEveryCaseWithItsRightAnswer) {
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_EQ(dialog().cases().topLevelItemCount(), int(stability::battery().size()));
    for (int i = 0; i < dialog().cases().topLevelItemCount(); ++i) {
        EXPECT_FALSE(dialog().cases().topLevelItem(i)->text(0).isEmpty());
        EXPECT_FALSE(dialog().cases().topLevelItem(i)->text(2).isEmpty());
        EXPECT_TRUE(dialog().cases().topLevelItem(i)->text(3).isEmpty()) << "nothing is found before it runs";
    }
    EXPECT_FALSE(dialog().runChosenButton().isEnabled()) << "nothing is chosen";
    EXPECT_FALSE(dialog().cancelButton().isEnabled());
    window.actions().stability->trigger();
    EXPECT_EQ(window.findChildren<StabilityDialog*>().size(), 1);
}

TEST_F(StabilityPage, chosenCasesAreRunBesideTheViews) {
    runChosen({"3-flat-box", "27-cycle"});
    EXPECT_EQ(row("3-flat-box").text(1), "right");
    EXPECT_EQ(row("3-flat-box").childCount(), 3);
    EXPECT_EQ(row("3-flat-box").child(0)->text(1), "control");
    EXPECT_TRUE(row("27-cycle").text(3).contains(QStringLiteral("painter sort=centroid")))
        << row("27-cycle").text(3).toStdString();
    EXPECT_GT(row("27-cycle").childCount(), 60);
    EXPECT_TRUE(row("4-far-plane").text(1).isEmpty()) << "it was not chosen";
    EXPECT_TRUE(dialog().conclusion().text().contains(QStringLiteral("All 2 cases")))
        << dialog().conclusion().text().toStdString();
}

TEST_F(StabilityPage, doubleClickOpensTheSceneFromItsCamera) {
    const auto opened = [&] { return session.opened() ? session.opened()->specification : std::string(); };
    emit dialog().cases().itemDoubleClicked(&row("3-flat-box"), 0);  // has no scene
    emit dialog().cases().itemDoubleClicked(&row("16-bowl"), 0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened() == "gallery/case-16-bowl"; }, kPatience)) << opened();
    EXPECT_NEAR(session.camera().fovy.degrees(), 25.0, 1e-9);
}

TEST_F(StabilityPage, cancelledRunKeepsWhatWasFound) {
    QSignalSpy ended(&dialog(), &StabilityDialog::ended);
    dialog().runButton().click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !row("3-flat-box").text(3).isEmpty(); }, kPatience));
    dialog().cancelButton().click();
    ASSERT_TRUE(ended.count() > 0 || ended.wait(kPatience));
    EXPECT_FALSE(dialog().running());
    EXPECT_FALSE(row("3-flat-box").text(3).isEmpty());
    EXPECT_TRUE(row("34-nothing").text(1).isEmpty());
    EXPECT_TRUE(dialog().runButton().isEnabled());
}

}  // namespace
}  // namespace cullscope::ui::stability_dialog_test
