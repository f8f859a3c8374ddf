// The frames that a screenshot replays, and how many are decided for it.
#include "tests/ui/screenshot_fixture.h"
#include "ui/jobs/picture_tiles.h"

namespace cullscope::ui::screenshot_frames_test {
namespace {

using ScreenshotFrames = ScreenshotTest;

TEST_F(ScreenshotFrames, ofTheViewsSizeItReplaysTheViewsFrame) {
    observe();
    const size_t before = session.frames()->decided(0);
    ScreenshotOptions options;
    ASSERT_FALSE(taken(options).isEmpty());
    session.setActiveView(0);
    settle();
    ASSERT_FALSE(taken(bare()).isEmpty());
    EXPECT_EQ(session.frames()->decided(0), before);
}

TEST_F(ScreenshotFrames, ofAnotherSizeItDecidesOnceHoweverManyTilesItHas) {
    observe();
    ScreenshotOptions options = bare();
    options.size = Viewport{kMostTilePixels + 200, 60};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    const ScreenshotPlan::Part& part = plan.parts.front();
    ASSERT_EQ(tilesOf(part.request.size).size(), 2u);
    EXPECT_TRUE(part.wanted.truth) << "which has tiles of its own";
    size_t before = session.frames()->decided(0);
    EXPECT_EQ(image(taken(options)).width(), kMostTilePixels + 200);
    EXPECT_EQ(session.frames()->decided(0), before + 1) << "the observed view's frame, for another size";
    // A second screenshot is of another moment.
    ASSERT_FALSE(taken(options).isEmpty());
    EXPECT_EQ(session.frames()->decided(0), before + 2);
}

TEST_F(ScreenshotFrames, ofSeveralViewsItDecidesOnceForThoseThatShowTheSameFrame) {
    observe();
    ScreenshotOptions options = bare();
    options.grid = true;
    options.size = Viewport{1200, 300};
    const ScreenshotPlan plan = planScreenshot(session, options, noExtras, false);
    ASSERT_EQ(plan.parts.size(), 2u);
    ASSERT_TRUE(plan.parts[0].request.frame().sameFrame(plan.parts[1].request.frame()));
    const size_t before = session.frames()->decided(0);
    ASSERT_FALSE(taken(options).isEmpty());
    EXPECT_EQ(session.frames()->decided(0), before + 1) << "the view's picture and its observer's";
}

}  // namespace
}  // namespace cullscope::ui::screenshot_frames_test
