#include <cstdio>

#include "core/measure/reference.h"
#include "core/visibility/registry.h"
#include "tests/core/gpu/gl_environment.h"
#include "tests/core/scene/test_scenes.h"
#include "tests/core/visibility/exact_visibility.h"
#include "tests/core/visibility/random_views.h"

// The other half of the bound in geometry/frustum.h: what the GPU's float arithmetic puts on the raster, `frustum` must have
// drawn, also where an object touches a plane to within rounding. The judge is the picture of everything.

namespace cullscope::test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 400;
constexpr uint64_t kViewsPerScene = 20;

/// The random sizes go to 16384 × 1; a picture of that size for each view would cost more than it shows.
Viewport small(const Viewport& size) { return {std::min(size.width, size.height == 1 ? 1024 : 96), std::min(size.height, 64)}; }

struct Tally {
    uint64_t views = 0, viewsWithCulled = 0, coveredPixels = 0, differentPixels = 0;
};

class FrustumPicture {
public:
    void run(uint64_t views) {
        for (uint64_t first = 0; first < views; first += kViewsPerScene) {
            const uint64_t seed = 1000 + first / kViewsPerScene;
            const ScenePointer scene = randomScene(seed);
            const SceneBuffers buffers(scene, Upload::Vbo);
            m_frustum->build(*scene);
            Random random(seed * 7919);
            for (uint64_t view = first; view < std::min(views, first + kViewsPerScene); ++view)
                check(buffers, randomView(*scene, random), seed, view);
        }
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    void check(const SceneBuffers& buffers, const RandomView& random, uint64_t seed, uint64_t number) {
        const Viewport size = small(random.viewport);
        const View view(random.camera, size);
        const DrawList list = m_frustum->cull(view).drawList;
        const std::vector<float> all = picture(buffers, view, everything(buffers.scene(), list.facing)).depth;
        const std::vector<float> culled = picture(buffers, view, list).depth;
        ++m_tally.views;
        if (list.ranges.size() < buffers.scene().instances().size()) ++m_tally.viewsWithCulled;
        uint64_t different = 0;
        for (size_t pixel = 0; pixel < all.size(); ++pixel) {
            if (all[pixel] > 0.0f) ++m_tally.coveredPixels;
            if (all[pixel] != culled[pixel]) ++different;
        }
        m_tally.differentPixels += different;
        EXPECT_EQ(different, 0u) << "pixels lost: scene seed " << seed << " view " << number << "; "
                                 << described(random.camera, size);
    }

    StrategyPointer m_frustum = makeStrategy("frustum");
    Tally m_tally;
};

TEST(FrustumPicture, pixelOfACulledObjectMissing) {
    FrustumPicture property;
    property.run(longMode() ? kAllViews : kSample);
    const Tally& t = property.tally();
    std::printf("long: frustum-picture views %llu with-culled %llu covered %llu different %llu\n",
                static_cast<unsigned long long>(t.views), static_cast<unsigned long long>(t.viewsWithCulled),
                static_cast<unsigned long long>(t.coveredPixels), static_cast<unsigned long long>(t.differentPixels));
    // It must not pass for want of anything to lose.
    EXPECT_GT(t.viewsWithCulled, t.views / 2);
    EXPECT_GT(t.coveredPixels, t.views * 20);
}

}  // namespace
}  // namespace cullscope::test
