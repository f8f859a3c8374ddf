// The files of screenshots: the data that each format stores besides the pixels, and the errors if a file cannot be written.
#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "tests/ui/screenshot_fixture.h"

namespace cullscope::ui::screenshot_file_test {
namespace {

TEST_F(ScreenshotTest, exrHoldsDepthAndTriangleOfEveryPixel) {
    ScreenshotOptions options;
    options.overlays = false;
    const Picture saved = readPicture(taken(options, QStringLiteral("{n}.exr")).toStdString());
    ASSERT_GT(saved.size.height, kShown.height);
    ASSERT_EQ(saved.triangle.size(), size_t(saved.size.width) * size_t(saved.size.height));
    const ViewPicturePointer shown = session.picture(0);
    const View view(session.viewingCamera(0), kShown);
    const std::vector<float> depth = forwardDistances(shown->depth, view);
    const int below = saved.size.height - kShown.height;
    size_t covered = 0;
    for (int y = 0; y < saved.size.height; ++y)
        for (int x = 0; x < saved.size.width; ++x) {
            const size_t at = size_t(y) * size_t(saved.size.width) + size_t(x);
            const float expected =
                y < below ? std::numeric_limits<float>::infinity() : depth[size_t(y - below) * size_t(kShown.width) + size_t(x)];
            ASSERT_EQ(saved.depth[at], expected) << x << " " << y;
            ASSERT_EQ(saved.triangle[at] != 0, std::isfinite(expected));
            covered += saved.triangle[at] != 0 ? 1 : 0;
        }
    EXPECT_GT(covered, 1000u);
    // The stored triangle is the one that a click at that pixel picks.
    const int x = kShown.width / 2;
    int y = 0;
    while (saved.triangle[size_t(y + below) * size_t(saved.size.width) + size_t(x)] == 0) ++y;
    session.pickAt(0, x, y);
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    EXPECT_EQ(session.pick()->triangle + 1, saved.triangle[size_t(y + below) * size_t(saved.size.width) + size_t(x)]);
}

TEST_F(ScreenshotTest, aGridInExrHasNoDepth) {
    ScreenshotOptions options = bare();
    options.grid = true;
    const Picture saved = readPicture(taken(options, QStringLiteral("{n}.exr")).toStdString());
    EXPECT_TRUE(saved.depth.empty());
    EXPECT_TRUE(saved.triangle.empty());
}

TEST_F(ScreenshotTest, everyFormatTellsWhatItShows) {
    sessionText = "{\"scene\":\"길/장면.obj\",\"filler\":\"";
    while (sessionText.size() < 20'000) sessionText += "한글 ";
    sessionText += "\"}";
    ParameterSet parameters = session.slot(0).parameters();
    parameters.setFromText("box", "length");
    session.slot(0).setParameters(parameters);
    settle();
    ScreenshotOptions options;
    options.size = Viewport{800, 600};
    options.captionText = QStringLiteral("그림 1");
    options.background = Behind::White;
    for (const char* ending : {"png", "jpg", "tif", "exr"}) {
        const QString file = taken(options, QStringLiteral("{n}.") + QString::fromLatin1(ending));
        ASSERT_FALSE(file.isEmpty()) << ending << ": " << failure.english();
        const std::map<std::string, std::string> metadata = metadataOf(file);
        EXPECT_EQ(metadata.at("cullscope:session"), sessionText) << ending;
        EXPECT_EQ(screenshotOptionsFromText(metadata.at("cullscope:screenshot")), options) << ending;
        ASSERT_TRUE(metadata.contains("cullscope:eye")) << ending;
        EXPECT_EQ(metadata.at("cullscope:scene"), session.opened()->specification);
        EXPECT_EQ(metadata.at("cullscope:strategy"), "frustum");
        EXPECT_EQ(metadata.at("cullscope:parameter:box"), "length");
        EXPECT_EQ(metadata.at("cullscope:missed_pixels"), "0");
        const double ratio = std::stod(metadata.at("cullscope:ratio_to_same_sides"));
        const std::string interval = metadata.at("cullscope:ratio_to_same_sides_ci95");
        EXPECT_GT(ratio, 0.0);
        EXPECT_LE(std::stod(interval), ratio);
        EXPECT_GE(std::stod(interval.substr(interval.find(',') + 1)), ratio);
        EXPECT_FALSE(metadata.contains("cullscope:speedup_vs_backface")) << "it is a ratio of times, not a mean of ratios";
        EXPECT_EQ(metadata.at("cullscope:submitted_triangles"), std::to_string(session.figures(0).consideredTriangles));
        EXPECT_EQ(metadata.at("cullscope:gl_renderer"), session.gpu()->info().renderer);
        EXPECT_EQ(metadata.at("cullscope:version"), CULLSCOPE_VERSION);
        EXPECT_FALSE(metadata.at("cullscope:commit").empty());
        EXPECT_EQ(metadata.at("cullscope:picture_size"), "800x600");
        EXPECT_EQ(metadata.at("cullscope:figures_size"), "480x360");
    }
}

TEST_F(ScreenshotTest, twoInARowHaveTwoNumbers) {
    ScreenshotTaker taker(session);
    QStringList written;
    QObject::connect(&taker, &ScreenshotTaker::done, [&](const QString& path) { written << QFileInfo(path).fileName(); });
    taker.take(settings(bare(), QStringLiteral("{strategy}-{n:02}.png")));
    taker.take(settings(bare(), QStringLiteral("{strategy}-{n:02}.png")));
    ASSERT_TRUE(waitUntil([&] { return !taker.busy(); }));
    EXPECT_EQ(written, QStringList({QStringLiteral("frustum-01.png"), QStringLiteral("frustum-02.png")}));
}

TEST_F(ScreenshotTest, whatCannotBeIsOneSentenceAndNoFile) {
    ScreenshotOptions large = bare();
    large.size = Viewport{20'000, 100};
    ScreenshotOptions small;
    small.size = Viewport{100, 20};
    const QString name = QStringLiteral("{n}.png");
    const std::vector<std::tuple<ScreenshotOptions, QString, const char*>> cases{
        {bare(), QStringLiteral("a.bmp"), ".png"},
        {bare(), QStringLiteral("a"), ".png"},
        {bare(), QStringLiteral("{x}.png"), "{x}"},
        {bare(), QStringLiteral(" "), "no name"},
        {large, name, "20000x100"},
        {small, name, "no room"},
    };
    for (const auto& [options, pattern, part] : cases) {
        EXPECT_TRUE(taken(options, pattern).isEmpty());
        EXPECT_NE(failure.english().find(part), std::string::npos) << failure.english();
    }
    EXPECT_EQ(files(), QStringList());
}

TEST_F(ScreenshotTest, aFullDiskAndAFolderThatIsNoneAreSaid) {
    const auto failureOf = [&](const std::filesystem::path& path) {
        Screenshot screenshot(*session.gpu(), session.frames(), planScreenshot(session, bare(), noExtras, false), path);
        Message message;
        bool done = false;
        QObject::connect(&screenshot, &Screenshot::done, [&] { done = true; });
        QObject::connect(&screenshot, &Screenshot::failed, [&](const Message& sentence) { message = sentence; });
        screenshot.start();
        EXPECT_TRUE(waitUntil([&] { return done || !message.empty(); }));
        EXPECT_FALSE(done);
        return message.english();
    };
    const QString full = folder.filePath(QStringLiteral("full.png"));
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/full"), full));
    EXPECT_NE(failureOf(full.toStdString()).find("full.png cannot be written"), std::string::npos);
    EXPECT_NE(failureOf("/proc/view.png").find("/proc/view.png cannot be written"), std::string::npos);
    EXPECT_EQ(files(), QStringList{QStringLiteral("full.png")});
    ScreenshotSettings nowhere = settings(bare(), QStringLiteral("{n}.png"));
    nowhere.folder = full;
    EXPECT_THROW((void)screenshotPath(session, nowhere), Error);
}

TEST_F(ScreenshotTest, aCancelledOneLeavesNothing) {
    ScreenshotTaker taker(session);
    int signalsSeen = 0;
    QObject::connect(&taker, &ScreenshotTaker::done, [&] { ++signalsSeen; });
    QObject::connect(&taker, &ScreenshotTaker::failed, [&] { ++signalsSeen; });
    ScreenshotOptions options = bare();
    options.size = Viewport{8192, 4096};
    taker.take(settings(options, QStringLiteral("{n}.png")));
    taker.take(settings(options, QStringLiteral("{n}.png")));
    taker.cancel();
    EXPECT_FALSE(taker.busy());
    session.gpu()->run([] {});
    QTest::qWait(100);
    EXPECT_EQ(signalsSeen, 0);
    EXPECT_EQ(files(), QStringList());
}

TEST_F(ScreenshotTest, theWindowGoesOnWhileALargeOneIsDrawn) {
    ScreenshotTaker taker(session);
    ScreenshotOptions options = bare();
    options.size = Viewport{8192, 8192};
    const size_t before = session.pictures()->drawn(0);
    bool ended = false;
    QObject::connect(&taker, &ScreenshotTaker::done, [&] { ended = true; });
    taker.take(settings(options, QStringLiteral("{n}.png")));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->drawn(0) > before || ended; }));
    EXPECT_FALSE(ended);
    ASSERT_TRUE(waitUntil([&] { return !taker.busy(); }));
    EXPECT_EQ(QImageReader(folder.filePath(QStringLiteral("1.png"))).size(), QSize(8192, 8192));
}

TEST_F(ScreenshotTest, theClipboardTakesThePictureWithAndWithoutOverlays) {
    observe();
    ScreenshotTaker taker(session);
    EXPECT_EQ(taker.clipboardImage(1, true).convertToFormat(QImage::Format_RGBA8888), shownImage(1));
    const QImage without = taker.clipboardImage(1, false);
    EXPECT_EQ(without.size(), shownImage(1).size());
    EXPECT_NE(without, shownImage(1));
    ViewSetup setup = session.setup(1);
    setup.look.show("frustum", false);
    session.setSetup(1, setup);
    settle();
    EXPECT_EQ(without, shownImage(1));
}

TEST_F(ScreenshotTest, beforeASceneIsDrawnThereIsNothingToSave) {
    Session empty(sessionOptions(true));
    ScreenshotTaker taker(empty);
    Message message;
    QObject::connect(&taker, &ScreenshotTaker::failed, [&](const Message& sentence) { message = sentence; });
    taker.take(settings(ScreenshotOptions(), QStringLiteral("{n}.png")));
    EXPECT_NE(message.english().find("open a scene"), std::string::npos) << message.english();
    EXPECT_TRUE(taker.clipboardImage(0, true).isNull());
}

}  // namespace
}  // namespace cullscope::ui::screenshot_file_test
