// The lecture's window: it shows what the main window shows, its keys work in it, and figures come when they are asked for.
#include <gmock/gmock.h>

#include <QFile>
#include <QHeaderView>
#include <QTemporaryDir>

#include "tests/ui/lecture.h"
#include "ui/panels/plane_table.h"
#include "ui/session/object_pick.h"

namespace cullscope::ui::lecture_test {
namespace {

using ::testing::HasSubstr;

TEST_F(Lecture, aViewAndItsObserverStandBesideMapAndListing) {
    watch("spherical");
    const auto coloured = [](StructurePanel& panel) { return panel.map().map().colouring() == "radius"; };
    window.structurePanel().map().setColouring("radius");
    ASSERT_TRUE(waitUntil([&] { return coloured(window.structurePanel()); }));
    LectureWindow& lecture = begin();
    EXPECT_TRUE(picture(0).isVisible());
    EXPECT_TRUE(picture(1).isVisible());
    EXPECT_EQ(picture(0).window(), &lecture);
    EXPECT_EQ(picture(1).window(), &lecture);
    EXPECT_GT(picture(0).width(), picture(1).width());
    EXPECT_TRUE(lecture.structure().map().isVisible());
    EXPECT_TRUE(waitUntil([&] { return coloured(lecture.structure()); })) << "as in the window";
    lecture.structure().showPage("listing");
    EXPECT_TRUE(lecture.structure().listing().isVisible());
    // The map has no legend of its own there.
    const auto lines = [&] { return lecture.structure().map().map().lines(); };
    ASSERT_TRUE(waitUntil([&] { return !lines().empty(); }));
    for (const MapLegend::Entry& line : lines())
        EXPECT_TRUE(waitUntil([&] { return lecture.legend().words().contains(line.words); })) << line.words.toStdString();
    const QString former = lines().front().words;
    session.slot(0).choose("bsp");
    EXPECT_TRUE(waitUntil([&] { return !lecture.legend().words().contains(former); }));
    EXPECT_FALSE(lecture.structure().map().isVisible()) << "a strategy without a map leaves no empty place";
    EXPECT_TRUE(lecture.legend().words().contains(QStringLiteral("drawn and visible")));
    session.setViewCount(4);
    ASSERT_TRUE(waitUntil([&] { return drawn(); }));
    for (const int view : {0, 1, 2, 3}) EXPECT_EQ(picture(view).window(), &lecture) << view;
    lecture.close();
    ASSERT_TRUE(waitUntil([&] { return !window.lecture(); }));
    for (const int view : {0, 1, 2, 3}) EXPECT_EQ(picture(view).window(), &window) << view;
}

TEST_F(Lecture, signsOverPicturesGrowWithTheScreen) {
    watch("spherical");
    LectureWindow& lecture = begin();
    EXPECT_DOUBLE_EQ(picture(0).extras().unit, 1.0);
    const auto redOf = [&] {
        const QImage shown = picture(0).grab().toImage();
        int red = 0;  // pixels of the x axis' ball
        for (int y = shown.height() / 2; y < shown.height(); ++y)
            for (int x = 0; x < shown.width() / 2; ++x) red += shown.pixelColor(x, y) == QColor(178, 62, 62) ? 1 : 0;
        return red;
    };
    const int small = redOf();
    EXPECT_GT(small, 0);
    lecture.resize(1920, 1080);
    QApplication::processEvents();
    EXPECT_DOUBLE_EQ(picture(0).extras().unit, 1.5);
    EXPECT_GT(redOf(), small * 3 / 2);
    // Letters in the picture, 18 units high, are as high as capitals of 20 pixels times the screen's scale.
    for (const int view : {0, 1})
        EXPECT_GE(18.0 * session.viewRequest(view)->style.unit * picture(view).pictureLayout().scale(), 1.5 * 14.5) << view;
    lecture.close();
    ASSERT_TRUE(waitUntil([&] { return !window.lecture(); }));
    EXPECT_DOUBLE_EQ(picture(0).extras().unit, 1.0);
    for (const int view : {0, 1}) EXPECT_EQ(session.viewRequest(view)->style.unit, 1.0F) << view;
}

TEST_F(Lecture, keysOfTheWindowWorkInIt) {
    watch("spherical");
    begin();
    QWidget* view = &picture(0);
    QTest::keyClick(view, Qt::Key_V);
    EXPECT_TRUE(session.setup(0).look.has(Show::Kind::Verdicts));
    QTest::keyClick(view, Qt::Key_T);
    EXPECT_EQ(session.setup(0).wipe.mode, Wipe::Mode::Truth);
    QTest::keyClick(view, Qt::Key_M);
    EXPECT_EQ(session.setup(0).wipe.mode, Wipe::Mode::Loss);
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_EQ(session.setup(0).role, Role::Frozen);
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_EQ(session.setup(0).role, Role::Linked);
    ASSERT_TRUE(waitUntil([&] { return drawn(); }));
    QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(view->width() / 2 - view->height() / 3, view->height() / 2));
    EXPECT_TRUE(waitUntil([&] { return session.pick().has_value(); })) << "a click picks";
    QTest::keyClick(view, Qt::Key_F8);
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() != nullptr; }));
    QTest::keyClick(view, Qt::Key_PageDown);
    EXPECT_EQ(window.stepper().place()->step(), 1u);
    QTest::keyClick(view, Qt::Key_F8);
    EXPECT_FALSE(window.stepper().active());
    QTest::keyClick(view, Qt::Key_F5);
    EXPECT_TRUE(waitUntil([&] { return !window.lecture(); })) << "F5 leaves, too";
}

TEST_F(Lecture, aPickAmongSeveralViewsIsAnsweredBesideThem) {
    session.slot(0).choose("spherical");
    session.slot(1).choose("all");
    session.setLinked(1);
    session.setActiveView(0);
    LectureWindow& lecture = begin();
    EXPECT_FALSE(lecture.structure().isVisible());
    const int width = picture(0).width();
    QWidget* view = &picture(0);
    QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(view->width() / 2 - view->height() / 3, view->height() / 2));
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    EXPECT_TRUE(waitUntil([&] { return lecture.structure().why().isVisible(); }));
    EXPECT_LT(picture(0).width(), width) << "the views make room";
    session.setPick(std::nullopt);
    EXPECT_TRUE(waitUntil([&] { return !lecture.structure().isVisible(); })) << "nothing is picked any more";
}

TEST_F(Lecture, rowsOfPlanesAreAsHighAsTheirLetters) {
    watch("frustum");
    LectureWindow& lecture = begin();
    pickObject(session, 0);
    lecture.structure().showWhy();
    const auto* table = lecture.structure().why().findChild<PlaneTable*>();
    ASSERT_TRUE(table);
    ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 6; }));
    for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080)}) {
        lecture.resize(size);
        QApplication::processEvents();
        EXPECT_GE(table->rowHeight(0), table->fontMetrics().height()) << size.height();
        EXPECT_GE(table->height(), table->horizontalHeader()->height() + 6 * table->rowHeight(0)) << size.height();
    }
}

TEST_F(Lecture, steppingBringsTheListingToTheFront) {
    watch("frustum");
    LectureWindow& lecture = begin();
    lecture.structure().showPage("losses");
    EXPECT_FALSE(lecture.structure().listing().isVisible());
    window.actions().stepThrough->trigger();
    EXPECT_TRUE(waitUntil([&] { return lecture.structure().listing().isVisible(); }));
    window.actions().stepThrough->trigger();
}

TEST_F(Lecture, aStrategyWithoutATreeOpensOnItsListing) {
    watch("backface");
    window.structurePanel().showPage("tree");
    EXPECT_EQ(begin().structure().page(), "listing");
}

TEST_F(Lecture, pagesShowEachViewAloneInOrderAndThenAllAgain) {
    session.setViewCount(4);
    session.setActiveView(2);
    LectureWindow& lecture = begin();
    const auto shown = [&] {
        std::vector<int> views;
        for (const int view : {0, 1, 2, 3})
            if (picture(view).window() == &lecture) views.push_back(view);
        return views;
    };
    EXPECT_EQ(shown().size(), 4u);
    for (const int view : {0, 1, 2, 3}) {
        QTest::keyClick(&lecture, Qt::Key_PageDown);
        EXPECT_EQ(shown(), std::vector<int>{view});
    }
    QTest::keyClick(&lecture, Qt::Key_PageDown);
    EXPECT_EQ(shown().size(), 4u);
    QTest::keyClick(&lecture, Qt::Key_PageUp);
    EXPECT_EQ(shown(), std::vector<int>{3});
}

TEST_F(Lecture, figuresComeWhenTheyAreAskedForAndGoWithTheNextStep) {
    const auto numbers = [](const QWidget& widget) {
        QStringList words;
        for (const QLabel* label : widget.findChildren<QLabel*>())
            if (label->isVisible() && label->text().startsWith(QStringLiteral("Missed:"))) words << label->text();
        return words;
    };
    player().begin(QStringLiteral("frustum"));
    go(0);
    LectureWindow& lecture = begin();
    EXPECT_TRUE(numbers(lecture).isEmpty());
    EXPECT_FALSE(lecture.revealed());
    QTest::keyClick(&lecture, Qt::Key_R);
    EXPECT_TRUE(lecture.revealed());
    EXPECT_EQ(numbers(lecture).size(), 1);
    QTest::keyClick(&lecture, Qt::Key_PageDown);
    EXPECT_EQ(player().step(), 1);
    EXPECT_FALSE(lecture.revealed());
    EXPECT_TRUE(numbers(lecture).isEmpty());
    EXPECT_EQ(lecture.sentence().toStdString(), textIn(player().current().sentence, "en"));
}

TEST_F(Lecture, pointerIsABrightSpotThatFollowsTheMouse) {
    LectureWindow& lecture = begin();
    EXPECT_FALSE(lecture.spot().isVisible());
    QTest::keyClick(&lecture, Qt::Key_P);
    ASSERT_TRUE(lecture.spot().isVisible());
    const QPoint place(picture(0).width() / 2, picture(0).height() / 2);
    QTest::mouseMove(&picture(0), place);
    EXPECT_TRUE(waitUntil([&] { return lecture.spot().place() == picture(0).mapTo(&lecture, place); }));
    EXPECT_TRUE(lecture.spot().testAttribute(Qt::WA_TransparentForMouseEvents));
    QTest::keyClick(&lecture, Qt::Key_B);
    EXPECT_FALSE(lecture.spot().isVisible()) << "a blank screen has no spot";
    QTest::keyClick(&lecture, Qt::Key_B);
    EXPECT_FALSE(lecture.spot().isVisible());
}

TEST_F(Lecture, presenterHasTheNotesAndTheNextSentenceInTheFirstWindow) {
    player().begin(
        lessonFromText("title en A\nstep\nsay en One.\nnote en Ask first.\nscene torus:triangles=2000\n"
                       "step\nsay en Two.\n",
                       "/nowhere/a.lesson"));
    go(0);
    begin();
    PresenterPage& page = window.presenter();
    EXPECT_TRUE(page.isVisible());
    EXPECT_EQ(page.now(), QStringLiteral("One."));
    EXPECT_EQ(page.notes(), QStringLiteral("Ask first."));
    EXPECT_EQ(page.next(), QStringLiteral("Two."));
    player().forward();
    EXPECT_EQ(page.now(), QStringLiteral("Two."));
    window.lecture()->close();
    ASSERT_TRUE(waitUntil([&] { return !window.lecture(); }));
    EXPECT_FALSE(page.isVisible());
}

/// Figures are measured, in one round.
struct Handout : ::testing::Test {
    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(Handout, hasEveryStepWithPictureSentenceAndFigures) {
    window.resize(1280, 720);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    const QTemporaryDir folder;
    LessonPlayer& player = window.lessons().player();
    player.begin(lessonFromText(
                     "title en A lesson\nstep\nsay en One & only.\nnote en Ask first.\nscene torus:triangles=2000\n"
                     "A.strategy frustum\nB.role observer\nB.observed A\nstep\nsay en Two.\nview_count 4\nstep\nsay en Three.\n",
                     "/nowhere/a.lesson"),
                 1);
    LessonHandout& handout = window.lessons().handout();
    QSignalSpy done(&handout, &LessonHandout::done), failed(&handout, &LessonHandout::failed);
    const QString html = folder.filePath(QStringLiteral("a.html")), pdf = folder.filePath(QStringLiteral("a.pdf"));
    for (const QString& file : {html, pdf}) {
        done.clear();
        handout.make(file);
        ASSERT_TRUE(waitUntil([&] { return !done.isEmpty() || !failed.isEmpty(); }));
        ASSERT_TRUE(failed.isEmpty());
        EXPECT_EQ(player.step(), 1) << "the step that was in hand is shown again";
    }
    QFile page(html);
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    const std::string text = page.readAll().toStdString();
    for (const char* words : {"1. One &amp; only.", "2. Two.", "3. Three.", "Ask first.", "A: View-frustum culling", "missed"})
        EXPECT_THAT(text, HasSubstr(words));
    size_t pictures = 0;
    for (size_t at = text.find("data:image/png"); at != std::string::npos; at = text.find("data:image/png", at + 1)) ++pictures;
    EXPECT_EQ(pictures, 3u);
    // Beside two views stands the panel with map and listing, whose width is the dock's; beside four stands none.
    const auto widthOf = [&](size_t number) {
        size_t at = 0;
        for (size_t i = 0; i <= number; ++i) at = text.find("base64,", at) + 7;
        const std::string data = text.substr(at, text.find('"', at) - at);
        return QImage::fromData(QByteArray::fromBase64(QByteArray::fromStdString(data))).width();
    };
    EXPECT_GT(widthOf(0), window.width() - window.structurePanel().width() + 100) << "the views alone leave the dock's width";
    EXPECT_LE(widthOf(1), window.width());
    // What watches another view has no figures of its own to tell.
    EXPECT_EQ(text.find("watches"), std::string::npos);
    QFile printed(pdf);
    ASSERT_TRUE(printed.open(QIODevice::ReadOnly));
    EXPECT_TRUE(printed.readAll().startsWith("%PDF"));
    handout.make(folder.filePath(QStringLiteral("a.doc")));
    EXPECT_EQ(failed.size(), 1);
}

}  // namespace
}  // namespace cullscope::ui::lecture_test
