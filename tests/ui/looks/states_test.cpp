// States that must look right: dark palette, other sizes and scales, statistics, a lecture, and a window before a scene is
// opened.
#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QMenu>
#include <QProcess>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>

#include "core/scene/camera_moves.h"
#include "tests/ui/looks/desktop.h"
#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/looks/shown_texts.h"
#include "ui/dialogs/generate_dialog.h"
#include "ui/dialogs/help_window.h"
#include "ui/dialogs/section_dialog.h"
#include "ui/dialogs/stability_dialog.h"
#include "ui/panels/path_bar.h"

namespace cullscope::ui::states_test {
namespace {

constexpr int kSmallestLectureLetters = 20;  // pixels
constexpr int kColumnWidth = 140;            // of the statistics' table in its stored picture

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
    EXPECT_EQ(desktop.window.side().openPage(), 0);
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("1920x1080")));
    EXPECT_EQ(cut(desktop), QStringList());
    // More parameters than have room, so that a scroll bar makes their sentences narrower.
    desktop.session.setViewCount(1);
    desktop.session.slot(0).choose("spherical");
    desktop.settle();
    EXPECT_EQ(desktop.window.side().openPage(), 0);
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

TEST(States, thePathBarCutsNoTextWhileItRecordsAndStepsInAnyLanguage) {
    for (const char* language : {"en", "ko", "zh_CN"}) {
        Desktop desktop({.size = {1280, 720}, .language = QString::fromLatin1(language)});
        auto* bar = desktop.window.findChild<PathBar*>();
        ASSERT_TRUE(bar);
        WindowActions& actions = desktop.window.actions();
        actions.record->trigger();
        for (int pose = 0; pose < 12; ++pose)
            desktop.session.setCamera(turned(desktop.session.camera(), UpAxis::Y, Angle::fromDegrees(7.0), {})),
                actions.addPose->trigger();
        desktop.settle();
        ASSERT_TRUE(bar->isVisible());
        const auto expectWhole = [&](const char* state) {
            EXPECT_EQ(cutTexts(*bar), QStringList()) << language << ", " << state;
            const QRect place(bar->mapTo(&desktop.window, QPoint()), bar->size());
            EXPECT_TRUE(desktop.window.rect().contains(place)) << language << ", " << state;
            EXPECT_GE(bar->width(), bar->minimumSizeHint().width()) << language << ", " << state;
            EXPECT_EQ(desktop.window.size(), QSize(1280, 720)) << language << ", " << state;
            bar->grab().save(QStringLiteral("%1/path-bar-%2-%3.png")
                                 .arg(writtenPicturesFolder(), QLatin1String(language), QLatin1String(state)));
        };
        expectWhole("recording");
        actions.record->trigger();
        actions.poseBack->trigger();
        desktop.settle();
        ASSERT_TRUE(bar->isVisible());
        expectWhole("stepping");
    }
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

TEST(States, helpMenusAndDialogsCutNoTextInAnyLanguage) {
    for (const QString& language : {QStringLiteral("en"), QStringLiteral("ko"), QStringLiteral("zh_CN")}) {
        SCOPED_TRACE(language.toStdString());
        Desktop desktop({.size = {1280, 800}, .language = language, .strategies = {"spherical", "frustum"}});
        HelpWindow help(desktop.language);
        help.show();
        help.search().setText(QStringLiteral("frustum"));
        QApplication::processEvents();
        EXPECT_EQ(cutTexts(help), QStringList());
        keepToLookAt(help, QStringLiteral("help-") + language);
        help.hide();
        for (const char* id : {"field", "plant"}) {
            GenerateDialog dialog(*std::ranges::find(sceneGenerators(), id, &GeneratorInfo::id));
            dialog.show();
            QApplication::processEvents();
            EXPECT_EQ(cutTexts(dialog), QStringList()) << id;
            keepToLookAt(dialog, QStringLiteral("generate-%1-%2").arg(QLatin1String(id), language));
        }
        desktop.window.side().setOpenPage(0);
        desktop.settle();
        EXPECT_EQ(cut(desktop), QStringList());
        QComboBox& choice = desktop.window.strategyPanel().choice();
        choice.showPopup();
        QApplication::processEvents();
        // The list is as wide as its three columns.
        const QAbstractItemView& list = *choice.view();
        EXPECT_GE(list.viewport()->width(), list.sizeHintForColumn(0));
        keepToLookAt(*choice.view()->window(), QStringLiteral("strategies-") + language);
        choice.hidePopup();
        keepToLookAt(desktop.window, QStringLiteral("rail-") + language);
        QMenu menu;
        ViewPane& pane = desktop.window.views().pane(0);
        ViewMenu filler(desktop.session, pane, desktop.window.actions(), menu);
        filler.addStrategies();
        filler.addLook();
        filler.addComparisons();
        for (QMenu* part : menu.findChildren<QMenu*>()) {
            part->ensurePolished();
            part->resize(part->sizeHint());
            keepToLookAt(*part, QStringLiteral("menu-%1-%2").arg(menu.findChildren<QMenu*>().indexOf(part)).arg(language));
        }
        keepToLookAt(*desktop.window.actions().builtInPaths, QStringLiteral("paths-") + language);
        desktop.window.actions().clippingPlane->trigger();
        desktop.window.actions().stability->trigger();
        desktop.settle();
        auto* plane = desktop.window.findChild<SectionDialog*>();
        auto* cases = desktop.window.findChild<StabilityDialog*>();
        ASSERT_TRUE(plane && cases);
        for (QWidget* dialog : std::initializer_list<QWidget*>{plane, cases}) {
            EXPECT_EQ(cutTexts(*dialog), QStringList()) << dialog->metaObject()->className();
            keepToLookAt(*dialog, QLatin1String(dialog->metaObject()->className()).mid(15) + QLatin1Char('-') + language);
        }
        keepToLookAt(desktop.window, QStringLiteral("clipped-") + language);
        plane->close();
        cases->close();
        // A closed view in wireframe, with its chip.
        desktop.window.actions().show("wireframe")->trigger();
        desktop.settle();
        keepToLookAt(desktop.window, QStringLiteral("wireframe-") + language);
    }
}

/// A program that runs on a screen scaled by a factor, beside others.
class ScaledProgram {
public:
    ScaledProgram(const QString& program, const QStringList& arguments, double scale) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QString::number(scale));
        // A share of the tests would leave out what is asked for here, and write its report over that of this program.
        for (const char* name : {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX", "GTEST_OUTPUT"})
            environment.remove(QString::fromLatin1(name));
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        m_process.start(program, arguments);
    }
    /// What it wrote; it ended without an error.
    [[nodiscard]] QByteArray output() {
        EXPECT_TRUE(m_process.waitForFinished(2 * kPatience));
        const QByteArray output = m_process.readAll();
        EXPECT_EQ(m_process.exitCode(), 0) << output.toStdString();
        return output;
    }

private:
    QProcess m_process;
};

TEST(States, aScaledScreenHasThePictureScaledAndNoTextCut) {
    struct AtScale {
        double scale;
        QString file;
        std::unique_ptr<ScaledProgram> picture, inside;
    };
    const QTemporaryDir folder;
    std::vector<AtScale> runs;
    for (const double scale : {1.5, 2.0}) {
        AtScale& run =
            runs.emplace_back(AtScale{scale, folder.filePath(QString::number(scale) + QStringLiteral(".png")), {}, {}});
        const QStringList arguments{QStringLiteral("--size"), QStringLiteral("1366x768"), QStringLiteral("--screenshot"),
                                    run.file};
        run.picture = std::make_unique<ScaledProgram>(QStringLiteral(CULLSCOPE_PROGRAM), arguments, scale);
        // Runs the test of the first window at this scale: only a process with that scale can measure whether texts fit.
        const QStringList filter{QStringLiteral("--gtest_filter=FirstWindow.cutsNoTextInAnyLanguage")};
        run.inside = std::make_unique<ScaledProgram>(QCoreApplication::applicationFilePath(), filter, scale);
    }
    for (AtScale& run : runs) {
        SCOPED_TRACE(run.scale);
        (void)run.picture->output();
        EXPECT_EQ(QImage(run.file).size(), QSize(1366, 768) * run.scale);
        EXPECT_TRUE(run.inside->output().contains("[  PASSED  ] 1 test."));
    }
}

}  // namespace
}  // namespace cullscope::ui::states_test
