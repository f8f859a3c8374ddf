// A view's memory is that of its picture and of its figures: both are drawn by one renderer, which alone knows the answers to the
// questions that the memory holds.

#include "core/measure/accuracy.h"
#include "tests/ui/shown_window.h"
#include "ui/models/metrics_words.h"

namespace cullscope::ui::memory_of_a_view_test {
namespace {

using MemoryOfAView = Window;

TEST_F(MemoryOfAView, figuresUseTheAnswersThatThePictureUses) {
    openAndWait(session, QStringLiteral("layers:count=8,triangles=200"));
    ParameterSet parameters(findStrategy("octree-query").info.parameters);
    parameters.setFromText("latency", "1");
    session.slot(0).choose("octree-query");
    session.slot(0).setParameters(parameters);
    settle();
    Camera front = session.camera();
    front.up = {0, 1, 0};
    front.eye = front.target + Vec3(0, 0, 0.6 * session.scene()->bounds().diagonal());
    uint64_t considered = session.scene()->triangleCount();
    for (int move = 1; move <= 3; ++move) {
        session.setCamera(zoomed(front, front.target, 1.0 - 0.001 * move, 1.0));
        settle();
        considered = session.picture(0)->consideredTriangles;
        EXPECT_EQ(session.figures(0).consideredTriangles, considered) << "after " << move;
        EXPECT_EQ(session.figures(0).frame, session.picture(0)->frame) << "after " << move;
    }
    EXPECT_LT(considered, session.scene()->triangleCount()) << "the answers to the frame before hide something";
}

TEST_F(MemoryOfAView, tellsAFrameHowLongTheOneBeforeTook) {
    openAndWait(session, QStringLiteral("layers:count=4,triangles=200"));
    ParameterSet parameters(findStrategy("small-feature").info.parameters);
    parameters.setFromText("hold-fps", "60");
    session.slot(0).choose("small-feature");
    session.slot(0).setParameters(parameters);
    settle();
    const Camera first = session.camera();
    for (int move = 1; move <= 2; ++move) {
        session.setCamera(zoomed(first, first.target, 1.0 - 0.001 * move, 1.0));
        settle();
        const std::optional<double> took = session.picture(0)->frame->log.frameBeforeMilliseconds;
        ASSERT_TRUE(took) << "after " << move;
        EXPECT_GT(*took, 0.0);
    }
}

TEST_F(MemoryOfAView, ofHeldFramesIsSettledAtRestAndLeftAloneByStepping) {
    openAndWait(session, QStringLiteral("plant:pipelines=4"));
    ParameterSet parameters(findStrategy("small-feature").info.parameters);
    parameters.setFromText("hold-fps", "60");
    session.slot(0).choose("small-feature");
    session.slot(0).setParameters(parameters);
    settle();
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.9, 1.0));
    const size_t before = session.frames()->decided(0);
    settle();
    EXPECT_GE(session.frames()->decided(0), before + 3) << "a frame alone says nothing";
    const ViewFramePointer shown = session.picture(0)->frame;
    EXPECT_FALSE(shown->unsteady);
    EXPECT_EQ(session.figures(0).frame, shown) << "the missed pixels are those of the frame that is shown";
    EXPECT_FALSE(heldWords(shown->log).isEmpty());
    EXPECT_TRUE(metricsLine(session.figures(0)).endsWith(heldWords(shown->log)));
    EXPECT_TRUE(metricsDetails(session.figures(0), {}).contains(QStringLiteral("to hold the frame time")));
    // A replay of a part decides nothing and is not timed.
    const size_t decided = session.frames()->decided(0);
    const size_t whole = shown->log.entries();
    for (size_t entries = 1; entries < whole; entries += 1 + whole / 4) {
        session.setStep(ShownStep{0, {entries, whole}, 1, 2, shown, {}});
        settle();
        EXPECT_TRUE(session.pictures()->isCurrent(0));
    }
    session.setStep(std::nullopt);
    settle();
    EXPECT_EQ(session.frames()->decided(0), decided);
    EXPECT_EQ(session.picture(0)->frame, shown);
}

}  // namespace
}  // namespace cullscope::ui::memory_of_a_view_test
