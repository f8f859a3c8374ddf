// Screenshots: what is in the file, at any size, and what is said where there can be none.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <numeric>
#include <span>

#include "core/base/error.h"
#include "core/measure/picture_file.h"
#include "tests/ui/test_scene.h"
#include "ui/dialogs/screenshot_taker.h"
#include "ui/session/picture_tiles.h"
#include "ui/views/screenshot_painter.h"

namespace cullscope::ui {
namespace {

using Behind = ScreenshotOptions::Background;

const Viewport kShown{480, 360};

/// Nothing but the pictures.
ScreenshotOptions bare() {
    ScreenshotOptions options;
    options.overlays = options.legend = options.caption = false;
    return options;
}

PictureExtras noExtras(int) { return {}; }

struct ScreenshotTest : ::testing::Test {
    void SetUp() override {
        QSettings().remove(QStringLiteral("screenshot"));
        for (int view = 0; view < Session::kMostViews; ++view) session.setViewport(view, kShown);
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=5,spacing=3"));
        session.slot(0).choose("frustum");
        session.slot(1).choose("frustum");
        session.setActiveView(0);
        session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 1.0));
        settle();
    }

    /// View 1 watches view 0 from outside, coloured by verdict.
    void observe() {
        session.observe(1, 0);
        ViewSetup setup = session.setup(1);
        setup.look = {Colouring::Verdicts, true, true, false};
        session.setSetup(1, setup);
        session.setActiveView(1);
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : session.shownViews())
                if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
            return session.figuresSettled();
        }));
    }

    ScreenshotSettings settings(const ScreenshotOptions& options, const QString& pattern) {
        return {options, folder.path(), pattern};
    }

    /// Takes it and gives the file; empty: it failed, with `failure`.
    QString taken(const ScreenshotOptions& options, const QString& pattern = QStringLiteral("{n}.png")) {
        ScreenshotTaker taker(session);
        taker.setSessionText([this] { return sessionText; });
        QString file;
        failure = {};
        QObject::connect(&taker, &ScreenshotTaker::done, [&](const QString& path) { file = path; });
        QObject::connect(&taker, &ScreenshotTaker::failed, [&](const Message& message) { failure = message; });
        taker.take(settings(options, pattern));
        EXPECT_TRUE(waitUntil([&] { return !taker.busy(); }));
        return file;
    }

    [[nodiscard]] QStringList files() const { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System); }

    QImage image(const QString& file) { return pixelsAlone(QImage(file)); }
    QImage shownImage(int view) { return session.picture(view)->colour.convertToFormat(QImage::Format_RGBA8888); }

    QTemporaryDir folder;
    std::string sessionText = "{}";
    Message failure;
    Session session{sessionOptions(true)};
};

/// The height of what is not background in a part of an image.
int inkHeight(const QImage& picture, const QRect& place) {
    const QRgb background = picture.pixel(place.right(), place.bottom());
    int first = -1, last = -1;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x)
            if (picture.pixel(x, y) != background) {
                if (first < 0) first = y;
                last = y;
            }
    return last - first + 1;
}

int pixelsOf(const QImage& picture, QRgb colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) count += (picture.pixel(x, y) & 0xffffff) == (colour & 0xffffff) ? 1 : 0;
    return count;
}

TEST_F(ScreenshotTest, asShownItIsTheViewsPicturePixelForPixel) {
    EXPECT_EQ(image(taken(bare())), shownImage(0));
    observe();
    ScreenshotOptions options = bare();
    options.overlays = true;
    EXPECT_EQ(image(taken(options)), shownImage(1));
}

TEST_F(ScreenshotTest, belowItLegendAndCaptionCostThePictureNothing) {
    observe();
    const QImage saved = image(taken(ScreenshotOptions()));
    EXPECT_EQ(saved.width(), kShown.width);
    ASSERT_GT(saved.height(), kShown.height);
    EXPECT_EQ(saved.copy(0, 0, kShown.width, kShown.height), shownImage(1));
}

TEST_F(ScreenshotTest, whatIsChangedAfterwardsIsNotInIt) {
    const QImage before = shownImage(0);
    ScreenshotTaker taker(session);
    QString file;
    QObject::connect(&taker, &ScreenshotTaker::done, [&](const QString& path) { file = path; });
    taker.take(settings(bare(), QStringLiteral("{n}.png")));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(40.0), {}));
    session.slot(0).choose("backface");
    ASSERT_TRUE(waitUntil([&] { return !taker.busy(); }));
    EXPECT_EQ(image(file), before);
}

TEST_F(ScreenshotTest, fourThousandPixelsHaveTypeAndLinesThreeTimesAsLarge) {
    observe();
    ScreenshotOptions options;
    options.captionText = QStringLiteral("Haxgp");
    const auto take = [&](const Viewport& size) {
        options.size = size;
        const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
        const QImage saved = image(taken(options));
        EXPECT_EQ(saved.size(), QSize(size.width, size.height));
        return std::pair(plan, saved);
    };
    const auto [plan, small] = take({1280, 720});
    const auto [largePlan, large] = take({3840, 2160});
    const int height = inkHeight(small, plan.captionPlace);
    EXPECT_GT(height, 10);
    EXPECT_NEAR(inkHeight(large, largePlan.captionPlace), 3 * height, 4);
    // Every state's colour lies in its swatch, and words beside it.
    ASSERT_EQ(largePlan.legend.size(), 1 + kTriangleStateCount);
    EXPECT_FALSE(largePlan.legend.front().state) << "the heading";
    const auto palette = verdictPalette(largePlan.style.background);
    for (const LegendEntry& entry : std::span(largePlan.legend).subspan(1)) {
        const Vec3f colour = palette[size_t(*entry.state)].colour;
        const QImage part = large.copy(entry.place);
        EXPECT_GT(pixelsOf(part, QColor::fromRgbF(colour.x, colour.y, colour.z).rgb()), 50) << entry.words.toStdString();
        EXPECT_GT(inkHeight(part, part.rect().adjusted(int(20 * largePlan.unit), 0, 0, 0)), 20) << entry.words.toStdString();
    }
    // The frustum's lines, white on dark, grow in both directions.
    const QRgb line = qRgb(255, 255, 255);
    const int smallLines = pixelsOf(small.copy(plan.parts.front().picture), line);
    const int largeLines = pixelsOf(large.copy(largePlan.parts.front().picture), line);
    EXPECT_GT(smallLines, 300);
    EXPECT_GT(largeLines, 6 * smallLines);
    EXPECT_LT(largeLines, 12 * smallLines);
}

std::string headingOf(const Viewport& size) {
    return "Triangles at " + std::to_string(size.width) + " × " + std::to_string(size.height) + " pixels:";
}

TEST_F(ScreenshotTest, theLegendNamesTheSizeOfItsCounts) {
    observe();
    ScreenshotOptions options;
    // As on the screen, where the figures of that size are the counts.
    ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    EXPECT_EQ(plan.legend.front().words.toStdString(), headingOf(session.figures(1).size));
    EXPECT_GT(inkHeight(image(taken(options)), plan.legend.front().place), 5) << "it is written";
    // Not coloured by verdict: nothing is counted, and there is no heading.
    session.setActiveView(0);
    settle();
    for (const LegendEntry& entry : planScreenshot(session, options, noExtras, false).legend)
        EXPECT_FALSE(entry.words.startsWith(QStringLiteral("Triangles at"))) << entry.words.toStdString();
}

TEST_F(ScreenshotTest, theLegendCountsTheTrianglesOfTheSavedSize) {
    observe();
    ScreenshotOptions options;
    options.size = Viewport{1280, 720};
    ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    ASSERT_TRUE(plan.parts.front().wanted.truth);
    TiledPicture::Result result;
    session.gpu()->run([&] {
        Renderer renderer;
        TiledPicture picture(plan.parts.front().request, plan.parts.front().wanted);
        while (picture.drawNext(renderer)) {
        }
        result = picture.take();
    });
    ASSERT_TRUE(result.states);
    EXPECT_TRUE(result.states->againstTruth);
    EXPECT_EQ(std::accumulate(result.states->counts.begin(), result.states->counts.end(), uint64_t{0}),
              session.scene()->triangleCount());
    // The caption's figures are of another size: the legend's heading states its own.
    EXPECT_EQ(plan.legend.front().words.toStdString(), headingOf(plan.parts.front().request.cullingSize));
    EXPECT_NE(plan.parts.front().request.cullingSize, session.figures(1).size);
    EXPECT_TRUE(plan.caption.contains(QStringLiteral("figures at 480 × 360 pixels"))) << plan.caption.toStdString();
    // More pixels show more triangles than the window's picture does.
    EXPECT_GT(result.states->counts[size_t(TriangleState::Visible)],
              session.figures(1).states->counts[size_t(TriangleState::Visible)]);
}

TEST_F(ScreenshotTest, tilesMakeTheSamePictureAsOneFramebuffer) {
    observe();
    ViewSetup setup = session.setup(1);
    setup.wipe.mode = Wipe::Mode::Loss;
    session.setSetup(1, setup);
    settle();
    ViewRequest request = *session.viewRequest(1);
    request.size = {kMostTilePixels + 700, kMostTilePixels / 4};
    request.cullingSize = {kMostTilePixels + 500, 400};
    request.states = nullptr;
    session.gpu()->run([&] {
        Renderer renderer;
        TiledPicture tiled(request, {true, true, 2});
        EXPECT_EQ(tiled.steps(), 6u);
        while (tiled.drawNext(renderer)) {
        }
        const TiledPicture::Result result = tiled.take();

        const View culling(request.culling, request.cullingSize);
        Trace trace;
        const Verdict verdict = cullShared(*request.strategy, culling, &trace, &renderer);
        const Reference truth =
            itemBufferReference(renderer, *request.buffers, culling, request.strategy->strategy->referenceFacing());
        request.states = std::make_shared<const TriangleStates>(
            triangleStates(request.buffers->scene(), culling, verdict.drawList, trace, &truth));
        EXPECT_EQ(result.states->counts, request.states->counts);
        PictureDrawing whole(request, renderer);
        Framebuffer target(request.size);
        whole.draw(renderer, target);
        const auto picture = whole.finish(2);
        int different = 0;
        for (int y = 0; y < request.size.height; ++y)
            for (int x = 0; x < request.size.width; ++x)
                different += picture->colour.pixel(x, y) != result.picture->colour.pixel(x, y) ? 1 : 0;
        // Rounding at a triangle's edge may differ where a tile begins far to the right.
        EXPECT_LT(different, request.size.width * request.size.height / 10'000);
        EXPECT_EQ(picture->marks.size(), result.picture->marks.size());
        const Renderer::ItemBuffer items =
            renderer.drawItemBuffer(*request.buffers, View(request.viewing, request.size), whole.drawList());
        size_t otherItems = 0;
        for (size_t i = 0; i < items.triangle.size(); ++i) otherItems += items.triangle[i] != result.triangle[i] ? 1 : 0;
        EXPECT_LT(otherItems, items.triangle.size() / 10'000);
    });
}

TEST_F(ScreenshotTest, transparentMeansNothingOrEverything) {
    ScreenshotOptions options = bare();
    options.background = Behind::Transparent;
    const QImage saved = image(taken(options));
    const QImage shown = shownImage(0);
    EXPECT_EQ(qAlpha(saved.pixel(0, 0)), 0);
    int covered = 0, wrong = 0;
    for (int y = 0; y < saved.height(); ++y)
        for (int x = 0; x < saved.width(); ++x) {
            const bool background = shown.pixel(x, y) == shown.pixel(0, 0);
            covered += background ? 0 : 1;
            wrong += background ? qAlpha(saved.pixel(x, y)) != 0 : saved.pixel(x, y) != shown.pixel(x, y);
        }
    EXPECT_GT(covered, 1000);
    EXPECT_EQ(wrong, 0);
    // The veil under marks must not fill it.
    ViewSetup setup = session.setup(0);
    setup.wipe.mode = Wipe::Mode::Loss;
    session.setSetup(0, setup);
    settle();
    options.overlays = true;
    EXPECT_EQ(qAlpha(image(taken(options)).pixel(0, 0)), 0);
}

TEST_F(ScreenshotTest, backgroundsAreWhiteOrBlackAsAsked) {
    ScreenshotOptions options = bare();
    options.background = Behind::White;
    EXPECT_EQ(image(taken(options)).pixel(0, 0), qRgb(255, 255, 255));
    options.background = Behind::Black;
    EXPECT_EQ(image(taken(options)).pixel(0, 0), qRgb(0, 0, 0));
}

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
    // The triangle is the one that a click there picks.
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
        const ScreenshotContent content = readScreenshot(file.toStdString());
        EXPECT_EQ(content.session, sessionText) << ending;
        EXPECT_EQ(content.options, options) << ending;
        const auto& metadata = content.metadata;
        ASSERT_TRUE(metadata.contains("cullscope:eye")) << ending;
        EXPECT_EQ(metadata.at("cullscope:scene"), session.opened()->specification);
        EXPECT_EQ(metadata.at("cullscope:strategy"), "frustum");
        EXPECT_EQ(metadata.at("cullscope:parameter:box"), "length");
        EXPECT_EQ(metadata.at("cullscope:missed_pixels"), "0");
        EXPECT_EQ(metadata.at("cullscope:submitted_triangles"), std::to_string(session.figures(0).consideredTriangles));
        EXPECT_EQ(metadata.at("cullscope:gl_renderer"), session.gpu()->info().renderer);
        EXPECT_EQ(metadata.at("cullscope:version"), CULLSCOPE_VERSION);
        EXPECT_FALSE(metadata.at("cullscope:commit").empty());
        EXPECT_EQ(metadata.at("cullscope:picture_size"), "800x600");
        EXPECT_EQ(metadata.at("cullscope:figures_size"), "480x360");
    }
}

TEST_F(ScreenshotTest, aGridIsArrangedAsInTheWindow) {
    session.slot(1).choose("backface");
    settle();
    ScreenshotOptions options = bare();
    options.grid = true;
    options.size = Viewport{1202, 500};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    ASSERT_EQ(plan.parts.size(), 2u);
    const QImage saved = image(taken(options));
    ASSERT_EQ(saved.size(), QSize(1202, 500));
    for (const ScreenshotPlan::Part& part : plan.parts) {
        EXPECT_EQ(part.picture, QRect(part.view == 0 ? 0 : part.picture.x(), 0, 600, 500));
        EXPECT_EQ(saved.copy(part.picture), session.pictures()->drawNow(part.request)->colour) << part.view;
    }
    EXPECT_LT(plan.parts[0].picture.right(), plan.parts[1].picture.left());
    EXPECT_EQ(plan.parts[1].request.strategy->id, "backface");
}

TEST_F(ScreenshotTest, eightViewsAreTwoRowsOfFourUnderHeadlines) {
    session.setViewCount(8);
    settle();
    ScreenshotOptions options;
    options.grid = true;
    options.size = Viewport{1920, 1080};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    ASSERT_EQ(plan.parts.size(), 8u);
    for (size_t i = 0; i < 8; ++i) {
        const ScreenshotPlan::Part& part = plan.parts[i];
        EXPECT_EQ(part.view, int(i));
        EXPECT_EQ(part.picture.size(), plan.parts[0].picture.size());
        EXPECT_EQ(part.picture.left(), plan.parts[i % 4].picture.left());
        EXPECT_EQ(part.picture.top(), plan.parts[i / 4 * 4].picture.top());
        EXPECT_GT(part.headline.height(), 10);
        EXPECT_FALSE(part.words.isEmpty());
        for (size_t other = 0; other < i; ++other) EXPECT_FALSE(part.picture.intersects(plan.parts[other].picture));
        EXPECT_TRUE(QRect(0, 0, 1920, plan.captionPlace.top()).contains(part.picture));
    }
    const QString file = taken(options);
    EXPECT_EQ(image(file).size(), QSize(1920, 1080));
    EXPECT_EQ(readScreenshot(file.toStdString()).metadata.at("cullscope:view_H:strategy"), session.slot(7).id());
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
        Screenshot screenshot(*session.gpu(), planScreenshot(session, bare(), noExtras, false), path);
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
    setup.look.frustum = false;
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
}  // namespace cullscope::ui
