// The contents of a screenshot of any size: pictures, legend, caption and grid.
#include <gtest/gtest.h>

#include <span>

#include "tests/ui/screenshot_fixture.h"
#include "ui/jobs/picture_tiles.h"

namespace cullscope::ui::screenshot_test {
namespace {

/// The height of all pixels in a part of an image that differ from its background.
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
    // Each swatch has the colour of its state, and text is beside it.
    ASSERT_EQ(largePlan.legend.size(), kTriangleStateCount);
    EXPECT_FALSE(largePlan.legend.front().state) << "the heading";
    const auto palette = verdictPalette(largePlan.style.background);
    for (const LegendEntry& entry : std::span(largePlan.legend).subspan(1)) {
        const Vec3f colour = palette[size_t(*entry.state)].colour;
        const QImage part = large.copy(entry.place);
        EXPECT_GT(pixelsOf(part, QColor::fromRgbF(colour.x, colour.y, colour.z).rgb()), 50) << entry.words.toStdString();
        EXPECT_GT(inkHeight(part, part.rect().adjusted(int(20 * largePlan.unit), 0, 0, 0)), 20) << entry.words.toStdString();
    }
    // The frustum's lines, white on dark, become wider and longer.
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
    // At the size of the window the counts are the metrics of that size.
    ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    EXPECT_EQ(plan.legend.front().words.toStdString(), headingOf(session.figures(1).size));
    EXPECT_GT(inkHeight(image(taken(options)), plan.legend.front().place), 5) << "it is written";
    // A picture that is not coloured by verdict has no counts and no heading.
    session.setActiveView(0);
    settle();
    for (const LegendEntry& entry : planScreenshot(session, options, noExtras, false).legend)
        EXPECT_FALSE(entry.words.startsWith(QStringLiteral("Triangles at"))) << entry.words.toStdString();
}

TEST_F(ScreenshotTest, allFiguresOfAPictureOfAnotherSizeAreTheViewsFigures) {
    observe();
    ScreenshotOptions options;
    options.size = Viewport{3840, 2160};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    ASSERT_TRUE(plan.parts.front().wanted.truth) << "its colours are of its own size";
    EXPECT_NE(plan.parts.front().request.cullingSize, session.figures(1).size);
    EXPECT_EQ(plan.legend.front().words.toStdString(), headingOf(session.figures(1).size));
    ASSERT_TRUE(plan.counts);
    EXPECT_EQ(*plan.counts, session.figures(1).states->counts);
    EXPECT_TRUE(plan.caption.contains(QStringLiteral("figures at 480 × 360 pixels"))) << plan.caption.toStdString();
    // What is not known yet is not written.
    session.setMeasuring(false);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(3.0), {}));
    const ScreenshotPlan stale = planScreenshot(session, options, noExtras, false);
    EXPECT_FALSE(stale.counts);
    EXPECT_FALSE(stale.legend.front().words.startsWith(QStringLiteral("Triangles at")));
    EXPECT_FALSE(stale.caption.contains(QStringLiteral("figures at"))) << stale.caption.toStdString();
}

TEST_F(ScreenshotTest, viewsOfSeveralSizesStateThemInTheirHeadlines) {
    session.setPictureSize({1}, Viewport{320, 240});
    settle();
    ScreenshotOptions options;
    options.grid = true;
    options.size = Viewport{1920, 1080};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    EXPECT_FALSE(plan.caption.contains(QStringLiteral("figures at"))) << plan.caption.toStdString();
    EXPECT_TRUE(plan.parts[0].words.endsWith(QStringLiteral("480 × 360"))) << plan.parts[0].words.toStdString();
    EXPECT_TRUE(plan.parts[1].words.endsWith(QStringLiteral("320 × 240"))) << plan.parts[1].words.toStdString();
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
        FramesBeside frames(session.frames());
        while (tiled.drawNext(frames, renderer)) {
        }
        const TiledPicture::Result result = tiled.take();

        const View culling(request.culling, request.cullingSize);
        const ViewFramePointer frame = frames.of(request.frame(), renderer);
        const Reference truth = itemBufferReference(renderer, *request.buffers, culling, request.strategy->referenceFacing());
        request.states =
            std::make_shared<const TriangleStates>(triangleStates(request.buffers->scene(), frame->log, truth.visible()));
        EXPECT_EQ(result.states->counts, request.states->counts);
        PictureDrawing whole(request, frame, nullptr);
        Framebuffer target(request.size);
        whole.draw(renderer, target);
        const auto picture = whole.finish(2);
        int different = 0;
        for (int y = 0; y < request.size.height; ++y)
            for (int x = 0; x < request.size.width; ++x)
                different += picture->colour.pixel(x, y) != result.picture->colour.pixel(x, y) ? 1 : 0;
        // Rounding at triangle edges may differ if a tile begins far to the right.
        EXPECT_LT(different, request.size.width * request.size.height / 10'000);
        EXPECT_EQ(picture->marks.size(), result.picture->marks.size());
        const Renderer::ItemBuffer items =
            renderer.drawItemBuffer(*request.buffers, View(request.viewing, request.size), whole.log(), {0, 0, request.size});
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
    // The veil under the marks must leave the transparent background transparent.
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
    EXPECT_EQ(plan.parts[1].request.strategy->id(), "backface");
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
    EXPECT_EQ(metadataOf(file).at("cullscope:view_H:strategy"), session.slot(7).id());
}

}  // namespace
}  // namespace cullscope::ui::screenshot_test
