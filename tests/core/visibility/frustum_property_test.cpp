#include <cstdio>
#include <sstream>

#include "core/visibility/registry.h"
#include "tests/core/scene/test_scenes.h"
#include "tests/core/visibility/exact_visibility.h"
#include "tests/core/visibility/random_views.h"

namespace cullscope::test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 500;
constexpr uint64_t kViewsPerScene = 20;

struct Tally {
    uint64_t views = 0, objects = 0, visible = 0, straddling = 0, culledByPVertex = 0, culledByLength = 0, failures = 0;
    std::array<uint64_t, 6> touching{};     ///< visible objects with a vertex within 1e-6 of a plane
    std::array<uint64_t, 6> justOutside{};  ///< culled ones within 1e-3
};

/// Which instances a strategy draws.
std::vector<char> drawnBy(Strategy& strategy, const View& view, size_t instances) {
    std::vector<char> drawn(instances, 0);
    for (const DrawRange& range : strategy.cull(view).drawList.ranges) drawn[range.instance] = 1;
    return drawn;
}

class FrustumProperty {
public:
    FrustumProperty() {
        ParameterSet length(findStrategy("frustum").info.parameters);
        length.setFromText("box", "length");
        m_byLength = makeStrategy("frustum", length);
    }

    void run(uint64_t views) {
        for (uint64_t first = 0; first < views; first += kViewsPerScene) {
            const uint64_t seed = 1000 + first / kViewsPerScene;
            const ScenePointer scene = randomScene(seed);
            m_byPVertex->build(*scene);
            m_byLength->build(*scene);
            Random random(seed * 7919);
            for (uint64_t view = first; view < std::min(views, first + kViewsPerScene); ++view)
                check(*scene, randomView(*scene, random), seed, view);
        }
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    void check(const Scene& scene, const RandomView& random, uint64_t seed, uint64_t number) {
        const View view(random.camera, random.viewport);
        const std::vector<char> byPVertex = drawnBy(*m_byPVertex, view, scene.instances().size());
        const std::vector<char> byLength = drawnBy(*m_byLength, view, scene.instances().size());
        const ExactVisibility exact(random.camera, random.viewport);
        ++m_tally.views;
        for (size_t i = 0; i < scene.instances().size(); ++i) {
            const ObjectTruth truth = exact.judge(scene, i);
            count(truth, byPVertex[i] != 0, byLength[i] != 0);
            if (!truth.visible || (byPVertex[i] != 0 && byLength[i] != 0)) continue;
            ++m_tally.failures;
            ADD_FAILURE() << "visible object culled by box=" << (byPVertex[i] == 0 ? "p-vertex" : "length") << ": scene seed "
                          << seed << " view " << number << " instance " << i << " of mesh " << scene.instances()[i].mesh << "; "
                          << described(random.camera, random.viewport);
        }
    }

    void count(const ObjectTruth& truth, bool drawnByPVertex, bool drawnByLength) {
        ++m_tally.objects;
        if (truth.visible) ++m_tally.visible;
        if (truth.straddles) ++m_tally.straddling;
        if (!drawnByPVertex) ++m_tally.culledByPVertex;
        if (!drawnByLength) ++m_tally.culledByLength;
        for (size_t plane = 0; plane < 6; ++plane) {
            if (truth.visible && truth.closest[plane] < 1e-6) ++m_tally.touching[plane];
            if (!drawnByPVertex && truth.closest[plane] < 1e-3) ++m_tally.justOutside[plane];
        }
    }

    StrategyPointer m_byPVertex = makeStrategy("frustum");
    StrategyPointer m_byLength;
    Tally m_tally;
};

std::string list(const std::array<uint64_t, 6>& counts) {
    std::ostringstream text;
    for (const uint64_t count : counts) text << (text.tellp() > 0 ? "/" : "") << count;
    return text.str();
}

TEST(FrustumProperty, visibleObjectCulled) {
    FrustumProperty property;
    property.run(longMode() ? kAllViews : kSample);
    const Tally& t = property.tally();
    std::printf(
        "long: frustum-property views %llu objects %llu culled %llu (length %llu) visible %llu straddling %llu "
        "touching-planes %s culled-just-outside %s failures %llu\n",
        static_cast<unsigned long long>(t.views), static_cast<unsigned long long>(t.objects),
        static_cast<unsigned long long>(t.culledByPVertex), static_cast<unsigned long long>(t.culledByLength),
        static_cast<unsigned long long>(t.visible), static_cast<unsigned long long>(t.straddling), list(t.touching).c_str(),
        list(t.justOutside).c_str(), static_cast<unsigned long long>(t.failures));

    // It must not pass for want of anything to lose: shares of the objects, counts of the views.
    EXPECT_EQ(t.failures, 0u);
    EXPECT_GT(t.culledByPVertex, t.objects / 5);
    EXPECT_GT(t.culledByLength, t.objects / 5);
    EXPECT_GT(t.visible, t.views / 2);
    EXPECT_GT(t.straddling, t.views / 4);
    for (size_t plane = 0; plane < 6; ++plane) {
        EXPECT_GT(t.touching[plane], t.views / 200) << "plane " << plane;
        EXPECT_GT(t.justOutside[plane], t.views / 200) << "plane " << plane;
    }
    EXPECT_GT(t.touching[4], t.views / 40) << "the near plane";
}

}  // namespace
}  // namespace cullscope::test
