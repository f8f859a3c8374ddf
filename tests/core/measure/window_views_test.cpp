// Several windows a frame: of one view, or of different views of the path.
#include "core/measure/meter.h"
#include "core/measure/render_frame.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::window_views_test {
namespace {

std::vector<uint8_t> alone(const SceneBuffers& buffers, const BuiltStrategy& strategy, const View& view) {
    Framebuffer target(view.viewport());
    (void)renderFrame(GlEnvironment::renderer(), buffers, strategy, *strategy.begin(), view, target);
    return target.readColour();
}

TEST(WindowViews, eachWindowShowsItsOwn) {
    const MeasureRequest request = smallExperiment({"frustum"});
    const SceneBuffers buffers(request.scene, Upload::Vbo);
    const CullerPointer culler = makeCuller("frustum");
    culler->build(*request.scene);
    const BuiltStrategy& strategy = *culler->built();
    const View first(request.path.camera(0), request.size), second(request.path.camera(1), request.size);
    Framebuffer a(request.size), b(request.size), c(request.size);
    const ViewStatePointer state = strategy.begin();
    const std::array<FrameTarget, 3> pictures{FrameTarget{&a, state.get()}, {&b, state.get(), &second}, {&c, state.get()}};
    const FrameResult frame = renderFrame(GlEnvironment::renderer(), buffers, strategy, first, pictures);
    const std::vector<uint8_t> ofFirst = alone(buffers, strategy, first), ofSecond = alone(buffers, strategy, second);
    ASSERT_NE(ofFirst, ofSecond);
    EXPECT_EQ(a.readColour(), ofFirst);
    EXPECT_EQ(b.readColour(), ofSecond);
    EXPECT_EQ(c.readColour(), ofFirst);
    EXPECT_EQ(frame.log.camera, first.camera()) << "the first one is judged";
}

TEST(WindowViews, countsAreThoseOfThePoseWhateverTheOthersShow) {
    MeasureRequest request = smallExperiment({"all", "frustum"});
    request.windows = 4;
    const MeasureResult one = measure(request);
    request.differentViews = true;
    const MeasureResult different = measure(request);
    ASSERT_EQ(one.runs.size(), different.runs.size());
    for (size_t run = 0; run < one.runs.size(); ++run) {
        ASSERT_EQ(one.runs[run].frames.size(), different.runs[run].frames.size());
        for (size_t pose = 0; pose < one.runs[run].frames.size(); ++pose)
            EXPECT_EQ(one.runs[run].frames[pose].submitted, different.runs[run].frames[pose].submitted);
    }
}

}  // namespace
}  // namespace cullscope::test::window_views_test
