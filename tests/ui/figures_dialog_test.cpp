#include "ui/dialogs/figures_dialog.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::figures_dialog_test {
namespace {

struct FiguresPage : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("star:seed=3,triangles=4000"));
        window.actions().figures->trigger();
        dialog = window.findChild<FiguresDialog*>();
        ASSERT_NE(dialog, nullptr);
        EXPECT_EQ(dialog->scenes().currentIndex(), 1) << "the scene that is open";
    }
    /// Waits for the page that a change draws.
    template <typename Change>
    void choose(const Change& change) {
        QSignalSpy drawn(dialog, &FiguresDialog::drawn);
        change();
        ASSERT_TRUE(dialog->drawing());
        ASSERT_TRUE(drawn.wait(kPatience));
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
    FiguresDialog* dialog = nullptr;
};

TEST_F(FiguresPage, drawsWhatIsChosenAndSavesItAsPictureAndNumbers) {
    EXPECT_TRUE(dialog->cases().isEnabled());
    EXPECT_FALSE(dialog->saveButton().isEnabled()) << "not drawn yet";
    choose([&] { dialog->figures().setCurrentIndex(5); });
    EXPECT_FALSE(dialog->cases().isEnabled()) << "Figure 6 shows all of the object";
    EXPECT_FALSE(dialog->picture().isNull());
    ASSERT_TRUE(dialog->saveButton().isEnabled());
    const QTemporaryDir folder;
    for (const auto& [kind, name, begin] : {std::tuple(FiguresDialog::File::Png, "f.png", "\x89PNG"),
                                            {FiguresDialog::File::Svg, "f.svg", "<"},
                                            {FiguresDialog::File::Csv, "f.csv", "view,case,object,kind"},
                                            {FiguresDialog::File::Json, "f.json", "{"}}) {
        QSignalSpy saved(&session, &Session::fileSaved);
        dialog->saveTo(kind, folder.filePath(QString::fromLatin1(name)).toStdString());
        ASSERT_TRUE(saved.wait(kPatience)) << name;
        QFile file(folder.filePath(QString::fromLatin1(name)));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        EXPECT_TRUE(file.readAll().startsWith(begin)) << name;
    }
    EXPECT_EQ(QImage(folder.filePath(QStringLiteral("f.png"))).size(), dialog->picture().size());
}

TEST(FiguresPageAlone, saysThatNoSceneIsOpen) {
    Session session{sessionOptions(true)};
    FiguresDialog dialog(session);
    QSignalSpy drawn(&dialog, &FiguresDialog::drawn);
    EXPECT_EQ(dialog.scenes().currentIndex(), 0) << "no scene is open";
    dialog.scenes().setCurrentIndex(1);
    EXPECT_EQ(drawn.size(), 1);
    EXPECT_FALSE(dialog.drawing()) << "the paper's bunny is not waited for";
    EXPECT_TRUE(dialog.picture().isNull());
    EXPECT_FALSE(dialog.saveButton().isEnabled());
}

}  // namespace
}  // namespace cullscope::ui::figures_dialog_test
