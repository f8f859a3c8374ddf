// A strategy's own picture beside the truth: what differs is marked by the triangles that both show.
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/reference.h"
#include "tests/ui/test_scene.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui::own_picture_test {
namespace {

constexpr size_t kLost = 7;

/// The visible triangles at depths that are rounded otherwise, at some pixels another triangle at such a depth, and nothing at
/// the first kLost pixels that show something.
FinishedPicturePointer roundedOtherwise(const Reference& truth, const Viewport& size) {
    auto picture = std::make_shared<FinishedPicture>();
    picture->size = size;
    picture->triangle.assign(truth.triangle.begin(), truth.triangle.end());
    picture->depth.assign(truth.depth.begin(), truth.depth.end());
    size_t lost = 0;
    for (size_t i = 0; i < picture->depth.size(); ++i) {
        if (picture->triangle[i] == 0) continue;
        picture->depth[i] = std::nextafter(picture->depth[i], i % 2 == 0 ? 0.0F : 1.0F);
        if (i % 5 == 0) picture->triangle[i] = picture->triangle[i] % 320 + 1;
        if (lost == kLost) continue;
        picture->triangle[i] = 0;
        picture->depth[i] = 0.0F;
        ++lost;
    }
    return picture;
}

class ShowsAPicture final : public StrategyWith<Structure> {
public:
    explicit ShowsAPicture(FinishedPicturePointer picture) : m_picture(std::move(picture)) {}

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        frame.show(m_picture);
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }

private:
    FinishedPicturePointer m_picture;
};

BuiltStrategyPointer showing(const FinishedPicturePointer& picture, const ScenePointer& scene) {
    RegisteredStrategy strategy;
    strategy.info.id = "own-picture";
    strategy.strategy = std::make_shared<ShowsAPicture>(picture);
    const ParameterSet parameters(strategy.info.parameters);
    return std::make_shared<const BuiltStrategy>(strategy, parameters, strategy.strategy->build(scene, parameters, {}));
}

TEST(Wipe, marksWhereAnOwnPictureLosesWhatTheTruthShowsButNoUnresolvedDepths) {
    GpuThread gpu;
    gpu.run([&] {
        ViewRequest request;
        request.buffers = gpu.upload(openScene("sphere:triangles=320").scene);
        request.culling = request.viewing = {{0.5, 1, 3}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100};
        request.size = request.cullingSize = {160, 120};
        Renderer renderer;
        const View view(request.culling, request.size);
        const Reference truth = itemBufferReference(renderer, *request.buffers, view, Facing::TwoSided);
        request.strategy = showing(roundedOtherwise(truth, request.size), request.buffers->scenePointer());
        for (const Wipe::Mode mode : {Wipe::Mode::Truth, Wipe::Mode::Difference}) {
            request.wipe = mode;
            request.other = mode == Wipe::Mode::Difference
                                ? showing(roundedOtherwise(truth, request.size), request.buffers->scenePointer())
                                : nullptr;
            request.otherView = 1;
            ViewFrames frames;
            const ViewFramePointer other = request.other ? frames.of(request.otherFrame(), renderer) : nullptr;
            PictureDrawing drawing(request, frames.of(request.frame(), renderer), other);
            Framebuffer target(request.size);
            drawing.draw(renderer, target);
            const auto picture = drawing.finish(0);
            EXPECT_EQ(picture->missed, mode == Wipe::Mode::Truth ? kLost : 0);
            EXPECT_EQ(picture->added, 0u);
        }
    });
}

}  // namespace
}  // namespace cullscope::ui::own_picture_test
