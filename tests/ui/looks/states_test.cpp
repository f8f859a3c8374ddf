// States that must look right: dark palette, other sizes and scales, statistics, a lecture, and a window before a scene is
// opened.
#include <QHeaderView>
#include <QProcess>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>

#include "tests/ui/looks/desktop.h"
#include "tests/ui/looks/shown_texts.h"

namespace cullscope::ui::states_test {
namespace {

constexpr int kSmallestLectureLetters = 20;  // pixels
constexpr int kColumnWidth = 90;             // of the statistics' table in its stored picture

QStringList cut(Desktop& desktop) { return cutTexts(desktop.window); }

TEST(States, aDarkWindowLooksAsKept) {
    Desktop desktop({.appearance = Appearance::Mode::Dark});
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("first-window-dark")));
}

TEST(States, chineseOnASmallScreenLooksAsKeptAndCutsNoText) {
    Desktop desktop({.size = {1280, 800}, .language = QStringLiteral("zh_CN")});
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("1280x800-zh_CN")));
    EXPECT_EQ(cut(desktop), QStringList());
}

TEST(States, aLargeScreenHasTheStrategyBesideTheViews) {
    Desktop desktop({.size = {1920, 1080}});
    EXPECT_TRUE(desktop.window.side().docked());
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("1920x1080")));
    EXPECT_EQ(cut(desktop), QStringList());
}

TEST(States, beforeASceneIsOpenedTheWindowInvites) {
    Desktop desktop({.open = false});
    const QStringList wanted{QStringLiteral("Open a file…"), QStringLiteral("Generate")};
    for (const QString& text : wanted) {
        int shown = 0;
        for (const auto* button : desktop.window.findChildren<QPushButton*>())
            shown += button->isVisible() && button->text() == text;
        EXPECT_EQ(shown, 1) << text.toStdString();
    }
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("empty")));
    EXPECT_EQ(cut(desktop), QStringList());
}

/// Measures over a short path by the statistics' own button.
void runExperiment(Desktop& desktop) {
    StatisticsPanel& panel = desktop.window.statistics().statistics();
    const auto boxes = panel.bar().findChildren<QSpinBox*>();
    ASSERT_EQ(boxes.size(), 2);
    boxes[0]->setValue(4);
    boxes[1]->setValue(1);
    auto* start = panel.bar().findChild<QPushButton*>();
    const QString begin = start->text();
    QTest::mouseClick(start, Qt::LeftButton);
    EXPECT_NE(start->text(), begin);
    ASSERT_TRUE(waitUntil([&] { return start->text() == begin; }));
    desktop.settle();
    EXPECT_GE(panel.model().rowCount(), 2);
}

TEST(States, aFinishedExperimentLooksAsKept) {
    Desktop desktop;
    desktop.window.statistics().toggleViewAction()->trigger();
    desktop.settle();
    runExperiment(desktop);
    StatisticsPanel& panel = desktop.window.statistics().statistics();
    // Columns fit their numbers, and times have more or fewer digits from run to run: fix the widths.
    for (QTableView* table : panel.findChildren<QTableView*>()) {
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        for (int column = 1; column < table->model()->columnCount(); ++column) table->setColumnWidth(column, kColumnWidth);
    }
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("statistics")));
}

TEST(States, statisticsCutNoTextOnASmallScreen) {
    for (const char* language : {"en", "ko", "zh_CN"}) {
        Desktop desktop({.size = {1280, 800}, .language = QString::fromLatin1(language)});
        desktop.window.statistics().toggleViewAction()->trigger();
        desktop.settle();
        EXPECT_EQ(cut(desktop), QStringList()) << language << ", before an experiment";
        runExperiment(desktop);
        auto* tabs = desktop.window.statistics().statistics().findChild<QTabBar*>();
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            desktop.settle();
            EXPECT_EQ(cut(desktop), QStringList()) << language << ", " << tabs->tabText(tab).toStdString();
            if (qEnvironmentVariableIsSet("CULLSCOPE_SAVE_LOOKS"))
                desktop.window.grab().save(writtenPicturesFolder() +
                                           QStringLiteral("/statistics-%1-%2.png").arg(language).arg(tab));
        }
    }
}

TEST(States, aLectureHasNoSmallLetters) {
    Desktop desktop;
    desktop.window.actions().lecture->trigger();
    LectureWindow* lecture = desktop.window.lecture();
    ASSERT_TRUE(lecture);
    lecture->showNormal();
    lecture->resize(1280, 720);
    desktop.settle();
    ASSERT_EQ(lecture->size(), QSize(1280, 720));
    const Look look = desktop.look(*lecture);
    for (const ShownText& text : shownTexts(*lecture)) {
        if (!text.painted) continue;
        EXPECT_GE(QFontInfo(text.font).pixelSize(), kSmallestLectureLetters)
            << text.where.toStdString() << ": " << text.text.toStdString();
    }
    EXPECT_EQ(cutTexts(*lecture), QStringList());
    EXPECT_TRUE(looksAsKept(look, QStringLiteral("lecture")));
    QTest::keyClick(lecture, Qt::Key_Escape);
    EXPECT_TRUE(waitUntil([&] { return !desktop.window.lecture(); }));
    desktop.settle();
    EXPECT_TRUE(desktop.window.views().pane(0).header().isVisible()) << "the window has its view back as it was";
}

QByteArray ended(QProcess& process, const QString& program, const QStringList& arguments, double scale) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QString::number(scale));
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    EXPECT_TRUE(process.waitForFinished(2 * kPatience));
    return process.readAll();
}

TEST(States, aScaledScreenHasThePictureScaledAndNoTextCut) {
    for (const double scale : {1.5, 2.0}) {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("window.png"));
        QProcess program;
        const QByteArray said =
            ended(program, QStringLiteral(CULLSCOPE_PROGRAM),
                  {QStringLiteral("--size"), QStringLiteral("1366x768"), QStringLiteral("--screenshot"), file}, scale);
        EXPECT_EQ(program.exitCode(), 0) << said.toStdString();
        const QImage picture(file);
        EXPECT_EQ(picture.size(), QSize(1366, 768) * scale) << scale;
        // Runs the test of the first window at this scale: only a process with that scale can measure whether texts fit.
        QProcess inside;
        const QByteArray told = ended(inside, QCoreApplication::applicationFilePath(),
                                      {QStringLiteral("--gtest_filter=FirstWindow.cutsNoTextInAnyLanguage")}, scale);
        EXPECT_EQ(inside.exitCode(), 0) << scale << "\n" << told.toStdString();
    }
}

}  // namespace
}  // namespace cullscope::ui::states_test
