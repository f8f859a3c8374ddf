#include <cstdio>
#include <sstream>

#include "core/visibility/eye_bounds.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

// The strategies that test bounds against the frustum, on the same random object-frustum pairs and against the same exact test.

namespace cullscope::test::frustum_family_test {
namespace {

constexpr uint64_t kAllPairs = 1'000'000;
constexpr uint64_t kSample = 50'000;
constexpr uint64_t kViewsPerScene = 20;

enum Variant : size_t { PVertex, Oriented, Length, Sphere, Rows, Corners, Groups, Refined, kVariants };

struct Setting {
    const char *name, *strategy, *parameter, *value;
};

constexpr std::array<Setting, kVariants> kSettings{{{"frustum", "frustum", "box", "p-vertex"},
                                                    {"frustum:box=oriented", "frustum", "box", "oriented"},
                                                    {"frustum:box=length", "frustum", "box", "length"},
                                                    {"frustum:box=sphere", "frustum", "box", "sphere"},
                                                    {"frustum:planes=rows", "frustum", "planes", "rows"},
                                                    {"frustum:planes=corners", "frustum", "planes", "corners"},
                                                    {"frustum-octree:refine=off", "frustum-octree", "refine", "off"},
                                                    {"frustum-octree", "frustum-octree", "refine", "on"}}};

/// The results of one variant over all pairs.
struct VariantTally {
    uint64_t culled = 0, visibleCulled = 0;
    uint64_t falsePositives = 0;  ///< kept, although the object's box lies clearly outside
};

struct Tally {
    uint64_t views = 0, pairs = 0, visible = 0, straddling = 0;
    uint64_t boxOutside = 0, withinMargin = 0;  ///< boxes outside, and those of them that the margin may keep
    std::array<uint64_t, 6> touching{};         ///< visible objects with a vertex within 1e-6 of a plane
    std::array<uint64_t, 6> justOutside{};      ///< culled objects with a vertex within 1e-3 of a plane
    std::array<VariantTally, kVariants> variants;
};

/// By instance: whether a strategy draws it.
std::vector<char> drawnBy(Culler& strategy, const View& view, size_t instances) {
    std::vector<char> drawn(instances, 0);
    for (const DrawRange& range : strategy.cull(view).drawList.ranges) drawn[range.instance] = 1;
    return drawn;
}

/// The exact result for one pair.
struct PairTruth {
    ObjectTruth object;
    bool boxMeets = false;           ///< the object's box intersects the frustum
    bool boxMeetsInMargin = false;   ///< the same box, grown by margin and rounding
    bool boxClearlyOutside = false;  ///< outside by more than the margin of every test; a batch test's is a few times that of the
                                     ///< others
};

class FrustumFamily {
public:
    FrustumFamily() {
        for (const Setting& setting : kSettings) {
            ParameterSet parameters(findStrategy(setting.strategy).info.parameters);
            parameters.setFromText(setting.parameter, setting.value);
            m_strategies.push_back(makeCuller(setting.strategy, std::move(parameters)));
        }
    }

    void run(uint64_t pairs) {
        for (m_seed = 1000; m_tally.pairs < pairs; ++m_seed) {
            const ScenePointer scene = randomScene(m_seed);
            for (const CullerPointer& strategy : m_strategies) strategy->build(*scene);
            Random random(m_seed * 7919);
            for (m_view = 0; m_view < kViewsPerScene && m_tally.pairs < pairs; ++m_view)
                check(*scene, randomView(*scene, random));
        }
    }
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    void check(const Scene& scene, const RandomView& random) {
        const View view(random.camera, random.viewport);
        std::array<std::vector<char>, kVariants> drawn;
        for (size_t v = 0; v < kVariants; ++v) drawn[v] = drawnBy(*m_strategies[v], view, scene.instances().size());
        const ExactVisibility exact(random.camera, random.viewport);
        ++m_tally.views;
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            const PairTruth truth = truthOf(exact, scene, i, view.eye());
            std::array<bool, kVariants> culled;
            for (size_t v = 0; v < kVariants; ++v) culled[v] = drawn[v][i] == 0;
            count(truth, culled);
            const std::string failure = failureOf(truth, culled);
            if (failure.empty()) continue;
            ADD_FAILURE() << failure << ": scene seed " << m_seed << " view " << m_view << " instance " << i << " of mesh "
                          << scene.instances()[i].mesh << "; " << described(random.camera, random.viewport);
        }
    }

    static PairTruth truthOf(const ExactVisibility& exact, const Scene& scene, uint32_t instance, const Vec3& eye) {
        PairTruth truth{exact.judge(scene, instance)};
        const Box3& box = scene.instanceBox(instance);
        const EyeBounds bounds = boundsFromEye(scene, instance, eye);
        const double rounding = 0x1p-44 * (glm::length(box.centre()) + glm::length(eye) + box.diagonal());
        const auto meetsGrown = [&](double by) { return exact.meets({box.min - by, box.max + by}); };
        truth.boxMeets = exact.meets(box);
        truth.boxMeetsInMargin = truth.boxMeets || meetsGrown(1.001 * bounds.margin + rounding);
        truth.boxClearlyOutside = !truth.boxMeetsInMargin && !meetsGrown(4.0 * bounds.margin + rounding);
        return truth;
    }

    void count(const PairTruth& truth, const std::array<bool, kVariants>& culled) {
        ++m_tally.pairs;
        m_tally.visible += truth.object.visible ? 1 : 0;
        m_tally.straddling += truth.object.straddles ? 1 : 0;
        m_tally.boxOutside += truth.boxMeets ? 0 : 1;
        m_tally.withinMargin += !truth.boxMeets && truth.boxMeetsInMargin ? 1 : 0;
        for (size_t plane = 0; plane < 6; ++plane) {
            m_tally.touching[plane] += truth.object.visible && truth.object.closest[plane] < 1e-6 ? 1 : 0;
            m_tally.justOutside[plane] += culled[PVertex] && truth.object.closest[plane] < 1e-3 ? 1 : 0;
        }
        for (size_t v = 0; v < kVariants; ++v) {
            m_tally.variants[v].culled += culled[v] ? 1 : 0;
            m_tally.variants[v].visibleCulled += culled[v] && truth.object.visible ? 1 : 0;
            m_tally.variants[v].falsePositives += !culled[v] && truth.boxClearlyOutside ? 1 : 0;
        }
    }

    /// Describes a violated condition for a pair; empty where all hold.
    static std::string failureOf(const PairTruth& truth, const std::array<bool, kVariants>& culled) {
        for (size_t v = 0; v < kVariants; ++v)
            if (truth.object.visible && culled[v]) return std::string("visible object culled by ") + kSettings[v].name;
        if (truth.object.visible && !truth.boxMeets) return "the box does not hold its object";
        if (!truth.boxMeetsInMargin && !culled[Refined]) return "box outside kept by the refinement";
        // An object that a looser test culls is also culled by the tighter one.
        constexpr std::array<std::pair<Variant, Variant>, 5> kLooserThan{
            {{Length, PVertex}, {Sphere, PVertex}, {PVertex, Oriented}, {PVertex, Groups}, {Groups, Refined}}};
        for (const auto& [looser, tighter] : kLooserThan)
            if (culled[looser] && !culled[tighter] && truth.boxClearlyOutside)
                return std::string("culled by ") + kSettings[looser].name + " and kept by " + kSettings[tighter].name;
        return {};
    }

    uint64_t m_seed = 0, m_view = 0;
    std::vector<CullerPointer> m_strategies;
    Tally m_tally;
};

std::string list(const std::array<uint64_t, 6>& counts) {
    std::ostringstream text;
    for (const uint64_t count : counts) text << (text.tellp() > 0 ? "/" : "") << count;
    return text.str();
}

void print(const Tally& t) {
    const auto number = [](uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf(
        "long: frustum-family views %llu pairs %llu visible %llu straddling %llu touching-planes %s culled-just-outside %s "
        "boxes-outside %llu within-margin %llu\n",
        number(t.views), number(t.pairs), number(t.visible), number(t.straddling), list(t.touching).c_str(),
        list(t.justOutside).c_str(), number(t.boxOutside), number(t.withinMargin));
    for (size_t v = 0; v < kVariants; ++v)
        std::printf("long: frustum-family %s pairs %llu culled %llu visible-culled %llu false-positives %llu\n",
                    kSettings[v].name, number(t.pairs), number(t.variants[v].culled), number(t.variants[v].visibleCulled),
                    number(t.variants[v].falsePositives));
}

TEST(FrustumFamily, noVisibleObjectIsCulledAndTighterTestsKeepTheirPromises) {
    FrustumFamily family;
    family.run(howMany(kAllPairs, kSample));
    const Tally& t = family.tally();
    print(t);

    // Guards against a vacuous pass, by shares of the pairs and counts of the views.
    EXPECT_GT(t.visible, t.views / 2);
    EXPECT_GT(t.straddling, t.views / 4);
    for (size_t plane = 0; plane < 6; ++plane) {
        EXPECT_GT(t.touching[plane], t.views / 200) << "plane " << plane;
        EXPECT_GT(t.justOutside[plane], t.views / 200) << "plane " << plane;
    }
    EXPECT_GT(t.touching[4], t.views / 40) << "the near plane";
    for (const VariantTally& variant : t.variants) EXPECT_GT(variant.culled, t.pairs / 5);

    // The known false positives of plane tests, and their order.
    EXPECT_EQ(t.variants[Refined].falsePositives, 0u);
    EXPECT_GT(t.variants[Groups].falsePositives, t.pairs / 2000);
    // Groups alone do not make a test tighter; the difference is the batch test's wider margin.
    EXPECT_LE(t.variants[Groups].falsePositives, t.variants[PVertex].falsePositives);
    EXPECT_GE(t.variants[Groups].falsePositives, t.variants[PVertex].falsePositives * 9 / 10);
    EXPECT_LT(t.variants[Oriented].falsePositives, t.variants[PVertex].falsePositives);
    EXPECT_GT(t.variants[Length].falsePositives, t.variants[PVertex].falsePositives);
}

}  // namespace
}  // namespace cullscope::test::frustum_family_test
