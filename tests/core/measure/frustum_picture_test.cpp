#include <cstdio>

#include "core/measure/reference.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

// The picture's half of the bound in geometry/frustum.h: `frustum` must draw every object that the GPU's float arithmetic
// rasterises, also where it touches a plane to within rounding. The reference is the picture of all objects; for
// `frustum-select`, which promises more than samples, also exact visibility.

namespace cullscope::test::frustum_picture_test {
namespace {

constexpr uint64_t kAllViews = 10'000;
constexpr uint64_t kSample = 400;
constexpr uint64_t kViewsPerScene = 20;

/// The strategies, one with a parameter.
struct Contestant {
    const char* id;
    const char* key = nullptr;
    const char* value = nullptr;
};
constexpr std::array kContestants{Contestant{"frustum"}, Contestant{"frustum", "box", "oriented"}, Contestant{"frustum-octree"},
                                  Contestant{"frustum-select"}, Contestant{"frustum-query"}};

CullerPointer made(const Contestant& contestant) {
    ParameterSet parameters(findStrategy(contestant.id).info.parameters);
    if (contestant.key != nullptr) parameters.setFromText(contestant.key, contestant.value);
    return makeCuller(contestant.id, parameters);
}

/// The random sizes go up to 16384 × 1; a picture of that size for each view would cost too much time.
Viewport small(const Viewport& size) { return {std::min(size.width, size.height == 1 ? 1024 : 96), std::min(size.height, 64)}; }

struct Tally {
    uint64_t views = 0, pairs = 0, culled = 0, coveredPixels = 0, differentPixels = 0, pixelsOfCulled = 0, falselyCulled = 0;
    uint64_t viewsWithCulled = 0;
};

class FrustumPicture {
public:
    FrustumPicture() {
        for (const Contestant& contestant : kContestants) m_strategies.push_back(made(contestant));
    }

    /// `from`: a multiple of kViewsPerScene.
    void run(uint64_t from, uint64_t views) {
        for (uint64_t first = from; first < views; first += kViewsPerScene) {
            const uint64_t seed = 1000 + first / kViewsPerScene;
            const ScenePointer scene = randomScene(seed);
            const SceneBuffers buffers(scene, Upload::Vbo);
            for (const CullerPointer& strategy : m_strategies) strategy->build(*scene);
            Random random(seed * 7919);
            for (uint64_t view = first; view < std::min(views, first + kViewsPerScene); ++view)
                check(buffers, randomView(*scene, random),
                      "scene seed " + std::to_string(seed) + " view " + std::to_string(view));
        }
    }
    /// By index into kContestants.
    [[nodiscard]] const std::array<Tally, kContestants.size()>& tallies() const { return m_tallies; }

private:
    void check(const SceneBuffers& buffers, const RandomView& random, const std::string& where) {
        const Viewport size = small(random.viewport);
        const View view(random.camera, size);
        std::array<std::vector<float>, 2> all;
        for (size_t i = 0; i < m_strategies.size(); ++i) {
            SCOPED_TRACE(std::string(kContestants[i].id) + ": " + where + "; " + described(random.camera, size));
            const DrawList list = m_strategies[i]->cull(view, &GlEnvironment::renderer()).drawList;
            std::vector<float>& truth = all[list.facing == Facing::Front ? 1 : 0];
            if (truth.empty()) truth = picture(buffers, view, everything(buffers.scene(), list.facing)).depth;
            comparePictures(truth, picture(buffers, view, list).depth, m_tallies[i]);
            lookAtCulled(buffers, view, list, m_tallies[i]);
            judgeObjects(buffers.scene(), ExactVisibility(random.camera, size), list, kContestants[i], m_tallies[i]);
        }
    }

    static void comparePictures(const std::vector<float>& truth, const std::vector<float>& drawn, Tally& tally) {
        uint64_t different = 0;
        for (size_t pixel = 0; pixel < truth.size(); ++pixel) {
            if (truth[pixel] > 0.0f) ++tally.coveredPixels;
            if (truth[pixel] != drawn[pixel]) ++different;
        }
        ++tally.views;
        tally.differentPixels += different;
        EXPECT_EQ(different, 0u) << "pixels lost";
    }

    /// In the picture of all objects a culled object may be hidden behind another one, so the culled objects are also drawn
    /// alone.
    static void lookAtCulled(const SceneBuffers& buffers, const View& view, const DrawList& list, Tally& tally) {
        DrawList culled = everything(buffers.scene(), Facing::TwoSided);
        for (const DrawRange& range : list.ranges)
            std::erase_if(culled.ranges, [&](const DrawRange& other) { return other.instance == range.instance; });
        if (culled.ranges.empty()) return;
        const std::vector<float> alone = picture(buffers, view, culled).depth;
        const auto pixels = uint64_t(std::count_if(alone.begin(), alone.end(), [](float depth) { return depth > 0.0f; }));
        tally.pixelsOfCulled += pixels;
        EXPECT_EQ(pixels, 0u) << "pixels that culled objects cover, alone";
    }

    /// An object that intersects the frustum must be drawn, even if it covers no sample; `frustum-query` promises samples only.
    static void judgeObjects(const Scene& scene, const ExactVisibility& exact, const DrawList& list, const Contestant& contestant,
                             Tally& tally) {
        std::vector<bool> drawn(scene.instances().size(), false);
        for (const DrawRange& range : list.ranges) drawn[range.instance] = true;
        const auto culled = uint64_t(std::count(drawn.begin(), drawn.end(), false));
        tally.pairs += drawn.size();
        tally.culled += culled;
        tally.viewsWithCulled += culled > 0 ? 1 : 0;
        if (std::string_view(contestant.id) == "frustum-query") return;
        for (size_t i = 0; i < drawn.size(); ++i) {
            if (drawn[i] || !exact.judge(scene, i).visible) continue;
            ++tally.falselyCulled;
            ADD_FAILURE() << "visible object culled: instance " << i;
        }
    }

    std::vector<CullerPointer> m_strategies;
    std::array<Tally, kContestants.size()> m_tallies;
};

TEST(FrustumPicture, meshAwayFromTheZeroOfItsCoordinatesIsDrawnWhereItsFloatsShow) {
    // An object of size 1e-3 at 3.8 from its mesh's origin, seen from a distance of 1e-3: float rounding moves it in front of the
    // far plane.
    FrustumPicture property;
    property.run(5180, 5184);
    for (const Tally& t : property.tallies()) EXPECT_EQ(t.views, 4u);
}

Mat3 randomTurn(Random& random) {
    const Vec3 first = random.direction(), second = glm::normalize(glm::cross(first, random.direction()));
    return {first, second, glm::cross(first, second)};
}

/// A box around `centre`, rotated, flattened along `centre` and rotated again, with its own centre at the world's origin.
ScenePointer flattenedFarFromItsZero(double distance, double thickness, Random& random) {
    const Mat3 before = randomTurn(random), after = randomTurn(random);
    const Vec3 centre = glm::transpose(before) * Vec3(0, 0, distance);
    const Mat3 linear = after * Mat3(scaling({1, 1, thickness})) * before;
    Mat4 place(linear);
    place[3] = Vec4(-(linear * centre), 1.0);
    return sceneOf({boxMesh(Vec3f(centre - 0.5), Vec3f(centre + 0.5))}, {place});
}

/// Looks along -z at the nearest corner from a distance of 3, with the far plane just in front of it.
View farPlaneJustBefore(const Scene& scene, Random& random) {
    Vec3 nearest(0, 0, -1e9);
    for (size_t v = 0; v < scene.meshOf(0).vertexCount(); ++v) {
        const Vec3 world(scene.instances()[0].worldFromMesh * Vec4(scene.meshOf(0).position(v), 1.0));
        if (world.z > nearest.z) nearest = world;
    }
    const double distance = 3.0 - std::pow(10.0, random.between(-5.3, -3.7));
    return {{nearest + Vec3(0, 0, 3), nearest, Vec3(0, 1, 0), Angle::fromDegrees(0.01), 0.1, distance}, {64, 64}};
}

TEST(FrustumPicture, meshTurnedFlattenedAndTurnedFarFromItsZeroIsDrawnWhereItsFloatsShow) {
    // Products are rounded in proportion to their size, also where they cancel in the vertices' sums.
    uint64_t shown = 0;
    for (const double thickness : {1e-2, 1e-3}) {
        Random random(7);
        for (int i = 0; i < 300; ++i) {
            const ScenePointer scene = flattenedFarFromItsZero(1000, thickness, random);
            const View view = farPlaneJustBefore(*scene, random);
            const std::vector<float> depth = picture(scene, view, Facing::TwoSided).depth;
            const bool shows = std::any_of(depth.begin(), depth.end(), [](float value) { return value > 0.0f; });
            shown += shows ? 1 : 0;
            for (const Contestant& contestant : kContestants) {
                const CullerPointer strategy = made(contestant);
                strategy->build(*scene);
                const bool drawn = !strategy->cull(view, &GlEnvironment::renderer()).drawList.ranges.empty();
                EXPECT_TRUE(drawn || !shows) << contestant.id << " at " << thickness << ", " << i;
            }
        }
    }
    EXPECT_GT(shown, 20u);
}

TEST(FrustumPicture, noPixelOfACulledObjectIsMissing) {
    FrustumPicture property;
    property.run(0, howMany(kAllViews, kSample));
    for (size_t i = 0; i < kContestants.size(); ++i) {
        const Tally& t = property.tallies()[i];
        std::printf(
            "long: frustum-picture %s%s%s views %llu pairs %llu culled %llu covered %llu different %llu of-culled-alone %llu "
            "falsely-culled %llu\n",
            kContestants[i].id, kContestants[i].key != nullptr ? " box=" : "",
            kContestants[i].key != nullptr ? kContestants[i].value : "", static_cast<unsigned long long>(t.views),
            static_cast<unsigned long long>(t.pairs), static_cast<unsigned long long>(t.culled),
            static_cast<unsigned long long>(t.coveredPixels), static_cast<unsigned long long>(t.differentPixels),
            static_cast<unsigned long long>(t.pixelsOfCulled), static_cast<unsigned long long>(t.falselyCulled));
        // Guards against a vacuous pass: enough views must cull something.
        EXPECT_GT(t.viewsWithCulled, t.views / 2) << kContestants[i].id;
        EXPECT_GT(t.coveredPixels, t.views * 20) << kContestants[i].id;
    }
}

}  // namespace
}  // namespace cullscope::test::frustum_picture_test
