// What a first start shows: something lost beside nothing lost, and one next action.
#include <set>

#include "tests/ui/test_scene.h"
#include "ui/text/wording.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::first_start_test {
namespace {

struct FirstStart : ::testing::Test {
    void SetUp() override {
        window.resize(1366, 768);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        window.lessons().player().show(LessonPlayer::firstStep(2));
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            return !session.loader().loading() && session.buffers() && !session.slot(0).building() &&
                   !session.slot(1).building() && session.metricsSettled() && !session.pictures()->busy();
        }));
        QApplication::processEvents();
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(FirstStart, leftSomethingIsLostAndRightNothing) {
    EXPECT_EQ(session.shownViews(), (std::vector{0, 1}));
    EXPECT_EQ(session.figures(0).promise, Promise::Approximate);
    EXPECT_EQ(session.figures(1).promise, Promise::Conservative);
    EXPECT_GT(session.figures(0).lostPixels(), 0u);
    EXPECT_EQ(session.figures(1).lostPixels(), 0u);
    ASSERT_FALSE(session.figures(0).holes.empty());
    EXPECT_GE(session.figures(0).holes.front().pixels, 30u) << "a hole that can be seen";
    EXPECT_FALSE(window.views().pane(0).header().elided());
    EXPECT_FALSE(window.views().pane(1).header().elided());
    EXPECT_FALSE(window.lessonBar().isVisible());
}

TEST_F(FirstStart, oneKeyWatchesFromOutsideWithObjectAndFrustumInThePicture) {
    session.setActiveView(0);
    window.actions().watch->trigger();
    settle();
    EXPECT_EQ(session.culledBy(1), 0);
    const View view(session.viewingCamera(1), session.renderSize(1));
    const auto inPicture = [&](const Vec3& point) {
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(point - view.eye(), 1.0);
        return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
    };
    EXPECT_TRUE(inPicture(session.cullingCamera(1).eye)) << "the tip of the frustum";
    const View culling(session.cullingCamera(0), session.renderSize(0));
    for (const Vec3& corner : culling.frustum().corners()) EXPECT_TRUE(inPicture(culling.eye() + corner)) << "all of the frustum";
    const Sphere sphere = session.scene()->boundingSphere();
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        for (const double side : {-1.0, 1.0}) EXPECT_TRUE(inPicture(sphere.centre + side * sphere.radius * way));
    window.actions().watch->trigger();
    EXPECT_EQ(session.culledBy(1), 1);
    EXPECT_EQ(session.slot(1).built()->promise(), Promise::Conservative) << "the strategy beside is there again";
}

TEST_F(FirstStart, legendAndNextActionAreInSightOnSmallScreensInEveryLanguage) {
    for (const char* spoken : {"en", "ko", "zh_CN"}) {
        language.use(QString::fromLatin1(spoken));
        for (const QSize& size : {QSize(1366, 768), QSize(1280, 720)}) {
            window.resize(size);
            settle();
            QTest::qWait(150);  // layouts within layouts take a turn each
            ASSERT_EQ(window.size(), size) << spoken;
            const QWidget& legend = window.legend();
            EXPECT_EQ(legend.visibleRegion().boundingRect(), legend.rect()) << spoken << ", " << size.width();
            EXPECT_TRUE(window.rect().contains(QRect(legend.mapTo(&window, QPoint()), legend.size()))) << spoken;
            for (const QLabel* label : legend.findChildren<QLabel*>()) {
                if (!label->isVisible()) continue;
                const std::string said =
                    std::string(spoken) + ", " + std::to_string(size.width()) + ": " + label->text().toStdString();
                EXPECT_EQ(label->visibleRegion(), QRegion(label->rect())) << said;
                EXPECT_GE(label->height(), label->heightForWidth(label->width())) << said;
            }
        }
    }
    language.use(QStringLiteral("en"));
}

TEST_F(FirstStart, framesOfViewsThatDrawOtherSidesAreComparedBesideEachOther) {
    ASSERT_NE(session.slot(0).built()->facing(), session.slot(1).built()->facing());
    ASSERT_TRUE(waitUntil([&] { return session.figures(0).timed && session.figures(1).timed; }));
    const QString words = window.legend().figuresWords();
    EXPECT_TRUE(words.contains(QStringLiteral("other sides"))) << words.toStdString();
    EXPECT_TRUE(words.contains(
        QRegularExpression(QStringLiteral("(A is .* times as fast as B|B is .* times as fast as A)( \\(.* – .*\\))?\\."))))
        << words.toStdString();
    session.slot(1).choose(session.slot(0).id());
    settle();
    EXPECT_FALSE(window.legend().figuresWords().contains(QStringLiteral("other sides"))) << "one baseline";
}

TEST_F(FirstStart, framesOfOtherCamerasAreNotCompared) {
    session.setFrozen(1, true);
    Camera moved = session.viewingCamera(0);
    moved.eye += 0.2 * (moved.eye - moved.target);
    session.setViewingCamera(0, moved);
    ASSERT_NE(session.cullingCamera(0), session.cullingCamera(1));
    ASSERT_TRUE(waitUntil([&] { return session.figures(0).timed && session.figures(1).timed; }));
    const QString words = window.legend().figuresWords();
    EXPECT_FALSE(words.contains(QStringLiteral("times as fast"))) << words.toStdString();
    for (const int view : {0, 1}) {
        const QString time = viewLetter(view) + QLatin1Char(' ') + millisecondsText(session.figures(view).frameMilliseconds);
        EXPECT_TRUE(words.contains(time)) << words.toStdString();
    }
}

TEST_F(FirstStart, eightViewsHaveEightStrategies) {
    for (const int count : {4, 6, 8}) {
        session.setViewCount(count);
        std::set<std::string> ids;
        for (const int view : session.shownViews()) ids.insert(session.slot(view).id());
        EXPECT_EQ(ids.size(), size_t(count)) << count;
    }
    // What was chosen stays, though another view has it.
    session.slot(7).choose(session.slot(0).id());
    session.setViewCount(2);
    session.setViewCount(8);
    EXPECT_EQ(session.slot(7).id(), session.slot(0).id());
    settle();
}

TEST_F(FirstStart, aPickAmongManyViewsOpensThePanelThatAnswers) {
    session.setViewCount(4);
    settle();
    ASSERT_FALSE(window.structurePanel().isVisible());
    session.setActiveView(0);
    session.pickLostAt(0, session.figures(0).holes.front().x, session.figures(0).holes.front().y);
    EXPECT_TRUE(waitUntil([&] { return window.structurePanel().why().isVisible(); }));
}

TEST_F(FirstStart, wordsThatCountMarkedPixelsCoverNone) {
    window.actions().loss->trigger();
    ViewPane& pane = window.views().pane(0);
    for (const QSize& size : {QSize(1366, 768), QSize(1366, 560)}) {
        window.resize(size);
        settle();
        const auto* chip = pane.picture().findChild<QLabel*>();
        ASSERT_TRUE(chip);
        EXPECT_TRUE(chip->isVisible());
        EXPECT_GE(chip->y(), int(pane.picture().pictureLayout().rect().bottom()) - 1) << size.height();
        EXPECT_LE(chip->geometry().bottom(), pane.picture().height()) << size.height();
    }
}

TEST_F(FirstStart, nextActionLeadsToTheFirstLesson) {
    QLabel* next = nullptr;
    for (QLabel* label : window.legend().findChildren<QLabel*>())
        if (label->text() == window.legend().nextAction()) next = label;
    ASSERT_TRUE(next);
    EXPECT_TRUE(next->isVisible());
    EXPECT_TRUE(next->text().contains(QStringLiteral("lesson 1"))) << next->text().toStdString();
    EXPECT_EQ(next->textFormat(), Qt::RichText) << "a link, and not its mark-up";
    emit next->linkActivated(QStringLiteral("lesson"));
    ASSERT_TRUE(window.lessons().player().active());
    EXPECT_EQ(window.lessons().player().lesson().title, LessonPlayer::titleOf(LessonPlayer::known().front()));
    EXPECT_FALSE(window.legend().nextAction().contains(QStringLiteral("lesson 1")));
    settle();
}

}  // namespace
}  // namespace cullscope::ui::first_start_test
