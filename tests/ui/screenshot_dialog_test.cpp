// The dialog for the options of a screenshot.
#include <gtest/gtest.h>

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>

#include "tests/ui/test_scene.h"
#include "ui/dialogs/screenshot_dialog.h"

namespace cullscope::ui::screenshot_dialog_test {
namespace {

struct ScreenshotDialogTest : ::testing::Test {
    void SetUp() override {
        QSettings().remove(QStringLiteral("screenshot"));
        for (int view = 0; view < Session::kMostViews; ++view) session.setViewport(view, {480, 360});
        openAndWait(session, QStringLiteral("torus:triangles=500"));
        session.slot(1).choose("backface");
        ASSERT_TRUE(waitUntil([&] { return session.viewRequest(0) && session.viewRequest(1); }));
        first.folder = folder.path();
        first.pattern = QStringLiteral("{scene}-{strategy}-{n:02}.png");
    }

    QTemporaryDir folder;
    ScreenshotSettings first;
    Session session{sessionOptions(true)};
    ExtrasOf extras = [](int) { return PictureExtras(); };
};

TEST_F(ScreenshotDialogTest, itGivesBackWhatItWasShown) {
    first.options.grid = true;
    first.options.size = Viewport{1234, 567};
    first.options.overlays = false;
    first.options.captionText = QStringLiteral("그림");
    first.options.background = ScreenshotOptions::Background::Black;
    ScreenshotDialog dialog(session, extras, first);
    EXPECT_EQ(dialog.settings().options, first.options);
    EXPECT_EQ(dialog.settings().folder, first.folder);
    EXPECT_EQ(dialog.settings().pattern, first.pattern);
    for (const Viewport& preset : {Viewport{1280, 720}, Viewport{3840, 2160}}) {
        first.options.size = preset;
        EXPECT_EQ(ScreenshotDialog(session, extras, first).settings().options.size, preset);
    }
    first.options.size.reset();
    EXPECT_EQ(ScreenshotDialog(session, extras, first).settings().options.size, std::nullopt);
}

TEST_F(ScreenshotDialogTest, settingsAreRemembered) {
    first.options.size = Viewport{1920, 1080};
    first.options.legend = false;
    first.save();
    const ScreenshotSettings again = ScreenshotSettings::load();
    EXPECT_EQ(again.options, first.options);
    EXPECT_EQ(again.folder, first.folder);
    EXPECT_EQ(again.pattern, first.pattern);
}

TEST_F(ScreenshotDialogTest, itSaysWhatTheFileWillBeCalledOrWhyThereIsNone) {
    ScreenshotDialog dialog(session, extras, first);
    EXPECT_TRUE(dialog.saveButton().isEnabled());
    EXPECT_TRUE(dialog.verdict().contains(QStringLiteral("-backface-01.png"))) << dialog.verdict().toStdString();
    auto* pattern = dialog.findChild<QLineEdit*>(QStringLiteral("pattern"));
    ASSERT_TRUE(pattern);
    for (const char* wrong : {"view.bmp", "{what}.png", ""}) {
        pattern->setText(QString::fromLatin1(wrong));
        EXPECT_FALSE(dialog.saveButton().isEnabled()) << wrong;
        EXPECT_FALSE(dialog.verdict().isEmpty());
        EXPECT_EQ(dialog.saveButton().accessibleDescription(), dialog.verdict());
    }
    pattern->setText(QStringLiteral("view.jpg"));
    EXPECT_TRUE(dialog.saveButton().isEnabled());
    EXPECT_TRUE(dialog.verdict().contains(QStringLiteral("view.jpg")));
}

TEST_F(ScreenshotDialogTest, aNameWithFoldersNamesItsOwn) {
    QTemporaryDir other;
    ASSERT_TRUE(QDir(first.folder).mkpath(QStringLiteral("figures")));
    ScreenshotDialog dialog(session, extras, first);
    auto* pattern = dialog.findChild<QLineEdit*>(QStringLiteral("pattern"));
    ASSERT_TRUE(pattern);
    const auto pathOf = [&](const QString& text) {
        pattern->setText(text);
        return QString::fromStdString(screenshotPath(session, dialog.settings()).string());
    };
    EXPECT_EQ(pathOf(other.filePath(QStringLiteral("a.png"))), other.filePath(QStringLiteral("a.png")));
    EXPECT_TRUE(dialog.verdict().contains(other.filePath(QStringLiteral("a.png")))) << dialog.verdict().toStdString();
    EXPECT_EQ(pathOf(QStringLiteral("figures/b.png")), QDir(first.folder).filePath(QStringLiteral("figures/b.png")));
    pattern->setText(other.filePath(QStringLiteral("none/a.png")));
    EXPECT_FALSE(dialog.saveButton().isEnabled());
    EXPECT_TRUE(dialog.verdict().contains(QStringLiteral("no folder"))) << dialog.verdict().toStdString();
    pattern->setText(other.path() + QLatin1Char('/'));
    EXPECT_TRUE(dialog.verdict().contains(QStringLiteral("no name"))) << dialog.verdict().toStdString();
}

TEST_F(ScreenshotDialogTest, everythingIsReachedByTabAndHasAName) {
    ScreenshotDialog dialog(session, extras, first);
    dialog.show();
    int stops = 0;
    for (QWidget* widget = dialog.nextInFocusChain(); widget != &dialog; widget = widget->nextInFocusChain()) {
        if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() || !widget->isVisible()) continue;
        ++stops;
        const auto* button = qobject_cast<QAbstractButton*>(widget);
        EXPECT_FALSE(widget->accessibleName().isEmpty() && (!button || button->text().isEmpty()))
            << widget->metaObject()->className();
    }
    EXPECT_GE(stops, 11);
}

}  // namespace
}  // namespace cullscope::ui::screenshot_dialog_test
