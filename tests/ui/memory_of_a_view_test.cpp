// A view's memory is that of its picture and of its figures: both are drawn by one renderer, which alone knows the answers to the
// questions that the memory holds.

#include "core/measure/accuracy.h"
#include "tests/ui/shown_window.h"

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
    EXPECT_FALSE(session.picture(0)->frame->log.frameBeforeMilliseconds) << "a view without a past";
    const Camera first = session.camera();
    for (int move = 1; move <= 2; ++move) {
        session.setCamera(zoomed(first, first.target, 1.0 - 0.001 * move, 1.0));
        settle();
        const std::optional<double> took = session.picture(0)->frame->log.frameBeforeMilliseconds;
        ASSERT_TRUE(took) << "after " << move;
        EXPECT_GT(*took, 0.0);
    }
}

}  // namespace
}  // namespace cullscope::ui::memory_of_a_view_test
