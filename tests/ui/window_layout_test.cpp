// The layout of the window is restored at the next start, and any panel can replace a view's picture.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QTemporaryDir>

#include "tests/ui/test_scene.h"
#include "ui/dialogs/help_window.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::window_layout_test {
namespace {

/// Session and window as at a start of the program.
struct Program {
    explicit Program(const QSize& size) {
        window.setKeepsLayout(true);
        restored = window.restoreLayout(true);
        if (!restored) window.resize(size);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    }

    [[nodiscard]] QDockWidget& dock(const char* name) { return *window.findChild<QDockWidget*>(QString::fromLatin1(name)); }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
    bool restored = false;
};

struct WindowLayout : ::testing::Test {
    void SetUp() override { QSettings().clear(); }
    void TearDown() override { QSettings().clear(); }
};

TEST_F(WindowLayout, comesBackAsItWasLeft) {
    {
        Program first({1200, 740});
        EXPECT_FALSE(first.restored);
        first.session.setViewCount(4);
        first.dock("inside").show();
        first.dock("statistics").show();
        first.window.resize(1180, 720);
        QApplication::processEvents();
        first.window.close();
    }
    Program second({900, 600});
    EXPECT_TRUE(second.restored);
    EXPECT_EQ(second.session.viewCount(), 4);
    EXPECT_EQ(second.window.size(), QSize(1180, 720));
    EXPECT_TRUE(second.dock("inside").isVisible()) << "opened by hand beside four views";
    EXPECT_TRUE(second.dock("statistics").isVisible());
    for (const char* name : {"inside", "statistics"}) EXPECT_TRUE(second.dock(name).isFloating()) << name;
    second.window.actions().resetLayout->trigger();
    EXPECT_FALSE(second.dock("inside").isVisible()) << "four views are compared without it";
    EXPECT_FALSE(second.dock("statistics").isVisible());
    second.session.setViewCount(2);
    EXPECT_TRUE(second.dock("inside").isVisible());
    EXPECT_FALSE(second.dock("inside").isFloating());
}

TEST_F(WindowLayout, openingADockBesideEightViewsKeepsTheirSize) {
    Program program({1366, 768});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    program.dock("statistics").show();
    program.session.setViewCount(8);
    QApplication::processEvents();
    for (const char* name : {"inside", "statistics"}) EXPECT_FALSE(program.dock(name).isVisible()) << name;
    const auto settle = [&] { return waitUntil([&] { return program.session.metricsSettled(); }); };
    ASSERT_TRUE(settle());
    const auto expectViewsUnchanged = [&] {
        QApplication::processEvents();
        for (int view = 0; view < 8; ++view) {
            EXPECT_EQ(program.session.viewport(view), (Viewport{320, 240})) << "view " << view;
            EXPECT_EQ(program.session.figures(view).state, ViewMetrics::State::Ready) << "view " << view;
        }
    };
    expectViewsUnchanged();
    const QWidget& middle = *program.window.views().parentWidget();
    const QRect views(middle.mapToGlobal(QPoint()), middle.size());
    for (const char* name : {"inside", "statistics"}) {
        QDockWidget& dock = program.dock(name);
        dock.toggleViewAction()->trigger();
        EXPECT_TRUE(dock.isVisible()) << name;
        EXPECT_TRUE(dock.isFloating()) << name;
        expectViewsUnchanged();
        dock.toggleViewAction()->trigger();
        EXPECT_FALSE(dock.isVisible()) << name;
        expectViewsUnchanged();
        for (QWidget* receiver : {static_cast<QWidget*>(&dock), static_cast<QWidget*>(&program.window)}) {
            dock.toggleViewAction()->trigger();
            QTest::keyClick(receiver, Qt::Key_Escape);
            EXPECT_FALSE(dock.isVisible()) << name;
        }
    }
    program.dock("inside").toggleViewAction()->trigger();
    QApplication::processEvents();
    EXPECT_EQ(program.dock("inside").frameGeometry(), QRect(views.right() - 399, views.top(), 400, views.height()));
    program.session.setViewCount(2);
    QApplication::processEvents();
    for (const char* name : {"inside", "statistics"}) {
        EXPECT_TRUE(program.dock(name).isVisible()) << name << " was open before";
        EXPECT_FALSE(program.dock(name).isFloating()) << name;
    }
    QTest::keyClick(&program.window, Qt::Key_Escape);
    EXPECT_TRUE(program.dock("inside").isVisible()) << "Esc closes only what floats";
}

TEST_F(WindowLayout, coloursAreExplainedWhereverThePanelInsideIsFolded) {
    for (const QSize& size : {QSize(1280, 800), QSize(1600, 900)}) {
        Program program(size);
        openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
        const auto inSight = [&] {
            QApplication::processEvents();
            const LegendStrip& strip = program.window.legendStrip();
            if (!strip.isVisible()) return false;
            EXPECT_EQ(strip.words().size(), qsizetype(kTriangleStateCount) - 1) << "all that the bars below the pictures have";
            const QRect place(strip.mapTo(&program.window, QPoint()), strip.size());
            EXPECT_TRUE(program.window.rect().contains(place));
            EXPECT_FALSE(
                place.intersects(QRect(program.window.views().mapTo(&program.window, QPoint()), program.window.views().size())));
            return true;
        };
        EXPECT_FALSE(inSight()) << "the panel explains them";
        EXPECT_TRUE(program.window.legend().isVisible());
        for (const int count : {4, 6, 8}) {
            program.session.setViewCount(count);
            EXPECT_TRUE(inSight()) << count << " views";
        }
        program.session.setViewCount(2);
        EXPECT_FALSE(inSight());
        program.dock("inside").close();
        EXPECT_TRUE(inSight()) << "the panel is closed";
    }
}

TEST_F(WindowLayout, theRailsPageLiesBesideTheViews) {
    for (const int views : {2, 8}) {
        Program program({1366, 768});
        openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
        program.session.setViewCount(views);
        program.window.side().setOpenPage(0);
        QApplication::processEvents();
        const auto placed = [&](const QWidget& widget) { return QRect(widget.mapTo(&program.window, QPoint()), widget.size()); };
        EXPECT_FALSE(placed(program.window.strategyPanel()).intersects(placed(program.window.views()))) << views;
        EXPECT_TRUE(program.window.strategyPanel().isVisible());
    }
}

TEST_F(WindowLayout, theStatisticsFloatOverTheLowerHalfOfTheViews) {
    Program program({1366, 768});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    program.session.setViewCount(4);
    program.dock("statistics").toggleViewAction()->trigger();
    QApplication::processEvents();
    const QWidget& middle = *program.window.views().parentWidget();
    const QRect views(middle.mapToGlobal(QPoint()), middle.size());
    const QRect place = program.dock("statistics").frameGeometry();
    EXPECT_EQ(place.width(), views.width());
    EXPECT_EQ(place.topLeft(), QPoint(views.left(), views.top() + views.height() / 2));
    EXPECT_TRUE(views.contains(place)) << "it wants more height than half of the views have";
}

TEST_F(WindowLayout, docksLeftFloatingAreDockedBesideTwoViews) {
    {
        Program first({1200, 740});
        first.session.setViewCount(4);
        first.dock("inside").show();
        QApplication::processEvents();
        first.window.close();
    }
    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window(session, language, appearance);
    EXPECT_TRUE(window.restoreLayout(false));
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    EXPECT_EQ(session.viewCount(), 2);
    auto* inside = window.findChild<QDockWidget*>(QStringLiteral("inside"));
    EXPECT_FALSE(inside->isFloating());
    EXPECT_TRUE(inside->isVisible());
}

TEST_F(WindowLayout, anyPanelStandsInAViewsPlaceAndComesBackWithTheSession) {
    Program program({1366, 768});
    openAndWait(program.session, QStringLiteral("split:mesh=torus:triangles=2000,by=clusters,triangles=200"));
    program.session.setViewCount(8);
    const std::vector<PlaceablePanel> panels = PlacedPanels::known();
    ASSERT_LE(panels.size(), 7u);
    for (size_t i = 0; i < panels.size(); ++i) {
        ViewSetup setup = program.session.setup(int(i) + 1);
        setup.panel = panels[i].id;
        program.session.setSetup(int(i) + 1, setup);
    }
    const auto expectPlaced = [&] {
        for (size_t i = 0; i < panels.size(); ++i) {
            const ViewPane& pane = program.window.views().pane(int(i) + 1);
            ASSERT_TRUE(pane.panel()) << panels[i].id;
            EXPECT_TRUE(pane.panel()->isVisible()) << panels[i].id;
            EXPECT_EQ(pane.panel()->objectName().toStdString(), panels[i].id);
            EXPECT_FALSE(program.session.viewRequest(int(i) + 1)) << "a picture that is not on show is not drawn";
        }
    };
    expectPlaced();
    ASSERT_TRUE(waitUntil([&] { return program.session.metricsSettled() && !program.session.pictures()->busy(); }));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("panels.cullscope"));
    ASSERT_TRUE(program.window.document().opener().save(file, QStringLiteral("compare")));
    for (int view = 1; view < 8; ++view) program.session.setSetup(view, ViewSetup{});
    EXPECT_FALSE(program.window.views().pane(1).panel());
    EXPECT_TRUE(program.session.viewRequest(1));
    program.window.document().opener().open(file);
    ASSERT_TRUE(waitUntil([&] { return !program.session.setup(1).panel.empty(); }));
    expectPlaced();
}

TEST_F(WindowLayout, aLectureThatWasSavedIsHeldAgain) {
    Program program({1366, 768});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("lecture.cullscope"));
    ASSERT_TRUE(program.window.document().opener().save(file, QStringLiteral("lecture")));
    program.window.document().opener().open(file);
    EXPECT_TRUE(waitUntil([&] { return program.window.lecture() != nullptr; }));
    QTest::keyClick(program.window.lecture(), Qt::Key_Escape);
    EXPECT_TRUE(waitUntil([&] { return program.window.lecture() == nullptr; }));
}

TEST_F(WindowLayout, theProgramMayEndDuringALecture) {
    Program program({1000, 700});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    program.window.actions().lecture->trigger();
    ASSERT_TRUE(program.window.lecture());
}

TEST_F(WindowLayout, lettersOfAnotherLanguageKeepTheSizeOfTheViews) {
    Program program({1366, 768});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    ASSERT_TRUE(waitUntil([&] { return program.session.viewport(0).width > 1; }));
    QApplication::processEvents();
    const Viewport size = program.session.viewport(0);
    for (const char* language : {"ko", "zh_CN", "en"}) {
        program.language.use(QString::fromLatin1(language));
        QApplication::processEvents();
        EXPECT_EQ(program.session.viewport(0), size) << language;
    }
}

TEST_F(WindowLayout, aPathOfAFewPosesIsPlayedSlowly) {
    Program program({1000, 700});
    openAndWait(program.session, QStringLiteral("torus:triangles=2000"));
    for (int pose = 0; pose < 3; ++pose) {
        program.window.actions().addPose->trigger();
        program.session.setCamera(turned(program.session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    }
    program.window.actions().play->trigger();
    ASSERT_TRUE(program.window.paths().player().playing());
    EXPECT_LT(program.window.paths().player().speed(), 0.1);
    ASSERT_TRUE(waitUntil([&] { return !program.window.paths().player().playing(); }));
    // A path of many poses plays at the usual speed.
    for (int pose = 0; pose < 40; ++pose) {
        program.session.setCamera(turned(program.session.camera(), UpAxis::Y, Angle::fromDegrees(1.0), {}));
        program.window.actions().addPose->trigger();
    }
    program.window.actions().play->trigger();
    EXPECT_EQ(program.window.paths().player().speed(), 1.0);
    program.window.actions().stop->trigger();
}

TEST_F(WindowLayout, helpIsInTheLanguageOfTheWindow) {
    Program program({1000, 700});
    program.window.actions().help->trigger();
    auto* help = program.window.findChild<HelpWindow*>();
    ASSERT_TRUE(help);
    QStringList pages;
    for (const Language::Known& language : Language::known()) {
        program.language.use(language.id);
        const QString text = help->page().toPlainText();
        EXPECT_GT(text.size(), 1500) << language.id.toStdString();
        EXPECT_FALSE(pages.contains(text)) << language.id.toStdString();
        EXPECT_TRUE(text.contains(QStringLiteral("cullbench")));
        pages << text;
    }
    program.window.actions().help->trigger();
    EXPECT_EQ(program.window.findChildren<HelpWindow*>().size(), 1);
    program.language.use(QStringLiteral("en"));
}

}  // namespace
}  // namespace cullscope::ui::window_layout_test
