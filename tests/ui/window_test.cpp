// The window around its views: language, messages, docks, size and picture.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>

#include "core/scene/scene_files.h"
#include "tests/ui/shown_window.h"
#include "ui/panels/empty_state.h"
#include "ui/startup/start_size.h"
#include "ui/startup/window_picture.h"

namespace cullscope::ui::window_test {
namespace {

TEST_F(Window, anotherLanguageKeepsTheState) {
    session.slot(0).choose("all");
    // A camera that the user has moved is kept, even if longer texts change the size of the views.
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(10.0), {}));
    settle();
    const Camera camera = session.camera();
    const OpenedScenePointer scene = session.opened();
    for (const char* id : {"ko", "zh_CN", "en"}) {
        language.use(QString::fromLatin1(id));
        QApplication::processEvents();
        EXPECT_EQ(session.slot(0).id(), "all");
        EXPECT_EQ(session.camera(), camera);
        EXPECT_EQ(session.opened(), scene);
        const QString line = window.views().pane(0).header().firstLine();
        if (QLatin1String(id) == QLatin1String("ko")) {
            EXPECT_EQ(line, QStringLiteral("모든 삼각형: 무손실"));
            EXPECT_EQ(window.actions().open->text(), QStringLiteral("열기(&O)…"));
        }
        if (QLatin1String(id) == QLatin1String("zh_CN")) {
            EXPECT_EQ(line, QStringLiteral("所有三角形：无损"));
        }
        if (QLatin1String(id) == QLatin1String("en")) {
            EXPECT_EQ(line, QStringLiteral("All triangles: lossless"));
        }
    }
}

TEST_F(Window, messagesAreShownInTheLanguageOfTheWindow) {
    language.use(QStringLiteral("ko"));
    openAndWait(session, QStringLiteral("/nonexistent/file.obj"));
    QApplication::processEvents();
    EXPECT_TRUE(window.message().isVisible());
    EXPECT_TRUE(window.message().text().contains(QStringLiteral("파일을 열 수 없습니다")))
        << window.message().text().toStdString();
    EXPECT_TRUE(window.message().text().contains(QStringLiteral("/nonexistent/file.obj")));
    language.use(QStringLiteral("en"));
}

TEST_F(Window, choosingAStrategyChangesTheActiveViewOnly) {
    session.setActiveView(0);
    QComboBox& choice = window.strategyPanel().choice();
    choice.setCurrentIndex(choice.findData(QStringLiteral("frustum"), StrategyModel::IdRole));
    emit choice.activated(choice.currentIndex());
    EXPECT_EQ(session.slot(0).id(), "frustum");
    EXPECT_EQ(session.slot(1).id(), "backface");
}

TEST_F(Window, aMessageKeepsTheSizeOfTheViewsAndTheFigures) {
    const Viewport size = picture(0).renderSize();
    const Camera camera = session.camera();
    openAndWait(session, QStringLiteral("/nonexistent/file.obj"));
    QApplication::processEvents();
    ASSERT_TRUE(window.message().isVisible());
    EXPECT_EQ(picture(0).renderSize(), size);
    EXPECT_EQ(session.camera(), camera);
    EXPECT_EQ(session.figures(0).state, ViewMetrics::State::Ready);
    EXPECT_EQ(session.figures(1).state, ViewMetrics::State::Ready);
    // The bar stays inside the central widget when the window is resized.
    window.resize(900, 650);
    QApplication::processEvents();
    EXPECT_TRUE(window.message().parentWidget()->rect().contains(window.message().geometry()));
}

TEST_F(Window, activatingAViewWithManyParametersKeepsTheSizeOfTheWindow) {
    session.slot(0).choose("frustum");
    window.resize(900, 420);
    settle();
    EXPECT_EQ(window.size(), QSize(900, 420));
    const Viewport size = picture(0).renderSize();
    for (const int view : {0, 1, 0}) {
        session.setActiveView(view);
        QApplication::processEvents();
        QTest::qWait(50);
        EXPECT_EQ(window.size(), QSize(900, 420));
        EXPECT_EQ(picture(0).renderSize(), size);
        EXPECT_EQ(session.figures(0).state, ViewMetrics::State::Ready);
    }
}

TEST_F(Window, theTabBarHasANameAndItsPlaceInTheOrderOfTab) {
    window.side().setOpenPage(0);
    session.setActiveView(0);
    session.slot(0).choose("frustum");
    const auto* parameter = window.strategyPanel().form().findChild<QWidget*>(QStringLiteral("box"));
    ASSERT_TRUE(parameter);
    ASSERT_TRUE(waitUntil([&] { return parameter->isVisible(); }));
    QWidget* choice = &window.strategyPanel().choice();
    std::vector<QWidget*> stops;
    QWidget* widget = choice;
    do {
        if ((widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy() && widget->isVisible()) stops.push_back(widget);
        widget = widget->nextInFocusChain();
    } while (widget != choice);
    const auto place = [&](const QWidget* wanted) { return std::find(stops.begin(), stops.end(), wanted) - stops.begin(); };
    EXPECT_LT(place(choice), place(parameter));
    EXPECT_LT(place(parameter), place(window.tabs().tabBar()));
    EXPECT_LT(place(window.tabs().tabBar()), place(&window.figures().table()));
    EXPECT_LT(place(&window.figures().table()), std::ptrdiff_t(stops.size()));
    EXPECT_FALSE(window.tabs().tabBar()->accessibleName().isEmpty());
}

TEST_F(Window, theWheelOverTheDockKeepsTheStrategy) {
    QComboBox& choice = window.strategyPanel().choice();
    picture(0).setFocus();
    const int before = choice.currentIndex();
    QWheelEvent event({5.0, 5.0}, choice.mapToGlobal(QPointF(5.0, 5.0)), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&choice, &event);
    EXPECT_EQ(choice.currentIndex(), before);
}

TEST(FileDialog, typesHaveNamesBesideTheirPatterns) {
    const QString all = DocumentCommands::fileTypes().section(QStringLiteral(";;"), 0, 0);
    for (const char* pattern : {"*.obj", "*.PLY", "*.polygons", "*.rvm", "*.bsp", "*.gltf", "*.GLB", "*.ifc", "*.obj.gz",
                                "*.PLY.XZ", "*.cullscope", "*.png", "*.exr"})
        EXPECT_TRUE(all.contains(QLatin1String(pattern))) << pattern << " is opened by the one dialog: " << all.toStdString();
    const QString meshes = DocumentCommands::fileTypes().section(QStringLiteral(";;"), 1, 1);
    EXPECT_TRUE(meshes.startsWith(QStringLiteral("Meshes (obj, "))) << meshes.toStdString();
    EXPECT_TRUE(meshes.contains(QStringLiteral(" (*.obj *.OBJ "))) << meshes.toStdString();
}

TEST(FileDialog, everyPlaceThatSaysWhatCanBeOpenedNamesAllOfIt) {
    std::vector<std::pair<QString, QString>> places{{QStringLiteral("the dialog"), DocumentCommands::fileTypes().toUpper()}};
    Session session(sessionOptions(true));
    QMenu generate;
    const EmptyState empty(session, &generate);
    QStringList words;
    for (const QLabel* label : empty.findChildren<QLabel*>()) words << label->text();
    places.emplace_back(QStringLiteral("the empty window"), words.join(QLatin1Char(' ')));
    for (const Language::Known& language : Language::known()) {
        QFile page(QStringLiteral(":/resources/help/help.%1.md").arg(language.id));
        ASSERT_TRUE(page.open(QIODevice::ReadOnly));
        places.emplace_back(language.id, QString::fromUtf8(page.readAll()).section(QStringLiteral("\n2. "), 0, 0).toUpper());
    }
    EXPECT_GE(readableSceneExtensions().size(), 10u);
    for (const auto& [place, text] : places)
        for (const std::string& extension : readableSceneExtensions())
            EXPECT_TRUE(text.contains(QString::fromStdString(extension).toUpper()))
                << place.toStdString() << " does not name " << extension;
}

TEST(StartSize, theWindowFitsTheScreenWithItsFrame) {
    const QMargins frame(4, 40, 4, 4);
    const QSize wanted(1366, 768);
    const Start small = startOn({0, 0, 1366, 768}, frame, wanted);
    EXPECT_TRUE(small.maximized);
    EXPECT_EQ(small.size, QSize(1358, 724));
    // The screen that Qt reports for 1366 × 768 at a scale of 1.5.
    EXPECT_EQ(startOn({0, 0, 911, 512}, frame, wanted).size, QSize(903, 468));
    const Start large = startOn({0, 27, 1920, 1053}, frame, wanted);
    EXPECT_FALSE(large.maximized);
    EXPECT_EQ(large.size, wanted);
}

TEST_F(Window, theLeastSizeFitsASmallScaledScreen) {
    // At 1366 × 768 and a scale of 1.5 the window has room for 911 × 472.
    EXPECT_LE(window.minimumSizeHint().width(), 900);
    EXPECT_LE(window.minimumSizeHint().height(), 400);
}

TEST_F(Window, thePictureOfALargeSceneIsTakenOnceItIsDrawn) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    int status = -1;
    // A scene of this size is measured only when the user asks for it.
    session.open(QStringLiteral("sphere:triangles=5.1e6"));
    WindowPicture shot(window, session, file.toStdString());
    QObject::connect(&shot, &WindowPicture::done, [&](int result) { status = result; });
    ASSERT_TRUE(waitUntil([&] { return status >= 0; }));
    ASSERT_EQ(status, 0);
    ASSERT_EQ(session.figures(0).state, ViewMetrics::State::OnRequest);
    const QPoint middle = picture(0).mapTo(&window, picture(0).rect().center());
    const QPoint corner = picture(0).mapTo(&window, picture(0).rect().topRight() + QPoint(-4, 4));
    const QImage saved(file);
    EXPECT_NE(saved.pixelColor(middle * window.devicePixelRatioF()), saved.pixelColor(corner * window.devicePixelRatioF()));
}

TEST_F(Window, pictureOfTheWindowIsSaved) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    int status = -1;
    WindowPicture shot(window, session, file.toStdString());
    QObject::connect(&shot, &WindowPicture::done, [&](int result) { status = result; });
    ASSERT_TRUE(waitUntil([&] { return status >= 0; }));
    EXPECT_EQ(status, 0);
    EXPECT_EQ(QImage(file).size(), window.size() * window.devicePixelRatioF());
}

}  // namespace
}  // namespace cullscope::ui::window_test
