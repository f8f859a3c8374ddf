#pragma once

#include <algorithm>

#include "core/geometry/random.h"
#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/measure/render_frame.h"
#include "core/mesh/parametric.h"
#include "tests/core/measure/small_strategies.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

// What tests of the small strategies share: a scene, random views, and one strategy on it.

inline constexpr Viewport kSize{160, 120};

/// Disjoint spheres of equal size in a box, so that many hide others.
inline ScenePointer spheres() {
    std::vector<Mat4> places;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 2; ++y)
            for (int z = 0; z < 3; ++z) places.push_back(translation({2.4 * x - 2.4, 2.4 * y - 1.2, 2.4 * z - 2.4}));
    return copiesOf(sphereMesh(320), places);
}
/// The same of 216 spheres of 20 triangles, so that a frame has more than 200 decisions.
inline ScenePointer manySpheres() {
    std::vector<Mat4> places;
    for (int i = 0; i < 216; ++i)
        places.push_back(translation({i % 6 - 2.5, i / 6 % 6 - 2.5, i / 36 - 2.5}) * scaling(Vec3(0.4)));
    return copiesOf(sphereMesh(20), places);
}

/// A view from outside all spheres that has some of them in the picture.
inline View somewhere(Random& random, const Viewport& size = kSize) {
    const Vec3 away = random.direction(), aside = random.direction(), up = random.direction();
    const double distance = random.between(6.0, 14.0);
    return {{distance * away, 2.0 * aside, up, Angle::fromDegrees(random.between(15.0, 70.0)), 0.1, 100.0}, size};
}

/// One strategy on the spheres.
class Bench {
public:
    explicit Bench(const RegisteredStrategy& strategy, ScenePointer on = spheres())
        : scene(std::move(on)),
          buffers(scene, Upload::Vbo),
          built(buildStrategy(strategy, ParameterSet(strategy.info.parameters), scene, m_store)),
          state(built->begin()) {}

    [[nodiscard]] FrameLog decide(const View& view, bool recording = true) {
        GpuFrame frame(GlEnvironment::renderer(), buffers, view, recording);
        built->draw(frame, *state);
        return frame.take();
    }
    [[nodiscard]] Reference truth(const View& view) const {
        return itemBufferReference(GlEnvironment::renderer(), buffers, view, built->referenceFacing());
    }
    /// The frame's own picture, drawn as its commands came.
    [[nodiscard]] std::pair<Picture, FrameLog> drawn(const View& view) {
        Framebuffer target(view.viewport());
        FrameResult result = renderFrame(GlEnvironment::renderer(), buffers, *built, *state, view, target);
        return {Picture{target.readColour(), target.readDepth()}, std::move(result.log)};
    }
    [[nodiscard]] Picture replayed(const View& view, const FrameLog& log, const PictureTile& tile) const {
        Framebuffer target(tile);
        GlEnvironment::renderer().draw(buffers, view, log, target);
        return {target.readColour(), target.readDepth()};
    }

    ScenePointer scene;
    SceneBuffers buffers;

private:
    StructureStore m_store;

public:
    BuiltStrategyPointer built;
    ViewStatePointer state;
};

/// Whether what the frame shows was rasterised by itself, by a rule that may differ by the raster's snapping.
inline bool hasOwnRaster(const FrameLog& log) {
    return std::ranges::any_of(log.commands, [](const Command& c) { return std::holds_alternative<FinishedPicturePointer>(c); });
}

/// The wrong pixels of a frame: missed and extra ones; of a frame that rasters by itself those that the raster's snapping does
/// not explain.
inline uint64_t wrongPixels(const Bench& bench, const FrameLog& log, const Reference& truth) {
    const View view(log.camera, log.size);
    Framebuffer target(log.size);
    const ShownPixels shown = shownPixels(GlEnvironment::renderer(), bench.buffers, log, target);
    if (hasOwnRaster(log))
        return missedBeyondSnapping(truth, shown, *bench.scene, view) + extraBeyondSnapping(truth, shown, *bench.scene, view);
    const Accuracy accuracy = compare(truth, shown, drawnTriangles(*bench.scene, log), *bench.scene);
    return accuracy.missedPixels + accuracy.extraPixels;
}

}  // namespace cullscope::test
