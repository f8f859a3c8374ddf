// `level-of-detail`: what its pictures lose, judged object by object, and when levels change.
#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/mesh/parametric.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::level_of_detail_test {
namespace {

/// Balls of different sizes that do not touch.
ScenePointer balls(uint64_t seed) {
    Random random(seed);
    std::vector<Mat4> places;
    for (int i = 0; i < 64; ++i) {
        const Vec3 place(i % 4, i / 4 % 4, i / 16);
        places.push_back(translation(4.0 * (place - 1.5) + 0.4 * random.direction()) *
                         scaling(Vec3(random.between(0.6, 1.4), random.between(0.6, 1.4), random.between(0.6, 1.4))));
    }
    return copiesOf(sphereMesh(720), places);
}

View aView(const Scene& scene, Random& random, double distance) {
    const Sphere& sphere = scene.boundingSphere();
    const Vec3 eye = sphere.centre + distance * sphere.radius * random.direction();
    return {{eye, sphere.centre + 0.3 * sphere.radius * random.direction(), random.direction(), Angle::fromDegrees(40.0), 0.05,
             100.0 * sphere.radius},
            {120, 90}};
}

CullerPointer built(const Scene& scene, double error, double hysteresis = 0.25) {
    ParameterSet parameters(findStrategy("level-of-detail").info.parameters);
    parameters.set("error", error);
    parameters.set("hysteresis", hysteresis);
    CullerPointer culler = makeCuller("level-of-detail", parameters);
    culler->build(scene);
    return culler;
}

double figure(const FrameLog& log, std::string_view name) {
    for (const NamedFigure& one : log.counters.figures)
        if (one.name == name) return one.value;
    ADD_FAILURE() << "no figure " << name;
    return 0.0;
}

uint32_t objectAt(const Scene& scene, uint32_t item) { return item == 0 ? UINT32_MAX : uint32_t(scene.instanceOf(item - 1)); }

/// The exact picture in more pixels: where an object's outline lies, also between the pixels.
class FineTruth {
public:
    static constexpr int kFiner = 4;

    FineTruth(const SceneBuffers& buffers, const View& view, Facing facing)
        : m_scene(buffers.scene()),
          m_size{kFiner * view.viewport().width, kFiner * view.viewport().height},
          m_truth(itemBufferReference(GlEnvironment::renderer(), buffers, View(view.camera(), m_size), facing)) {}

    /// Whether another object than `object`, or the background, lies within so many pixels of a pixel's centre.
    [[nodiscard]] bool differsNear(int x, int y, double pixels, uint32_t object) const {
        const double reach = kFiner * pixels + 1.0, cx = kFiner * (x + 0.5), cy = kFiner * (y + 0.5);
        for (int row = int(cy - reach); row <= int(cy + reach); ++row)
            for (int column = int(cx - reach); column <= int(cx + reach); ++column) {
                if (row < 0 || column < 0 || row >= m_size.height || column >= m_size.width) return true;
                if (std::hypot(column + 0.5 - cx, row + 0.5 - cy) > reach) continue;
                if (objectAt(m_scene, m_truth.triangle[size_t(row) * size_t(m_size.width) + size_t(column)]) != object)
                    return true;
            }
        return false;
    }

private:
    const Scene& m_scene;
    Viewport m_size;
    Reference m_truth;
};

TEST(LevelOfDetail, pixelsThatShowAnotherObjectLieWithinTheErrorOfAnOutline) {
    uint64_t wrong = 0, covered = 0, coarser = 0;
    for (uint64_t seed = 1; seed <= howMany(60, 1); ++seed) {
        const ScenePointer scene = balls(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        for (const double error : {1.0, 4.0}) {
            const CullerPointer strategy = built(*scene, error);
            EXPECT_EQ(strategy->promise(), Promise::Approximate);
            Random random(seed * 31);
            for (int number = 0; number < 3; ++number) {
                const View view = aView(*scene, random, 0.8 + 1.2 * number);
                const Culled frame = strategy->cull(view);
                EXPECT_LE(figure(frame.log, "surfaces_move_at_most_px"), error);
                coarser += uint64_t(figure(frame.log, "objects_at_coarser_levels"));
                const Reference truth =
                    itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy->referenceFacing());
                Framebuffer target(view.viewport());
                const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, frame.log, truth, target);
                const FineTruth fine(buffers, view, strategy->referenceFacing());
                covered += truth.coveredPixels;
                uint64_t beyond = 0;
                for (size_t pixel = 0; pixel < truth.triangle.size(); ++pixel) {
                    if (pixelDifference(truth, judged.shown, pixel) == PixelDifference::None) continue;
                    ++wrong;
                    const int x = int(pixel % size_t(view.viewport().width)), y = int(pixel / size_t(view.viewport().width));
                    if (!fine.differsNear(x, y, error, objectAt(*scene, truth.triangle[pixel]))) ++beyond;
                }
                EXPECT_EQ(beyond, 0u) << "seed " << seed << " error " << error << " view " << number;
                EXPECT_EQ(judged.accuracy.falselyCulledTriangles, 0u) << "of an object that is drawn none is lost";
            }
        }
    }
    EXPECT_GT(coarser, 50u);
    EXPECT_GT(covered, 5'000u);
    EXPECT_GT(wrong, 20u) << "a bound that nothing comes near to is not tested";
    EXPECT_LT(wrong, covered / 4);
}

TEST(LevelOfDetail, drawsWithError0WhatTheSceneIs) {
    const ScenePointer scene = balls(3);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = built(*scene, 0.0);
    EXPECT_EQ(strategy->promise(), Promise::Conservative);
    Random random(8);
    const View view = aView(*scene, random, 3.0);
    const Culled frame = strategy->cull(view);
    EXPECT_EQ(frame.log.grain(), Grain::Triangle);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy->referenceFacing());
    Framebuffer target(view.viewport());
    const JudgedFrame judged = judge(GlEnvironment::renderer(), buffers, frame.log, truth, target);
    EXPECT_EQ(judged.accuracy.missedPixels + judged.accuracy.extraPixels, 0u);
    EXPECT_FALSE(judged.ownRaster);
}

/// A frame that is compared by object is not excused from objects.
TEST(LevelOfDetail, anObjectThatIsNotDrawnIsMissedWhateverStandsForTheOthers) {
    const ScenePointer scene = balls(5);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = built(*scene, 2.0);
    Random random(11);
    const View view = aView(*scene, random, 2.5);
    const Culled frame = strategy->cull(view, Recording::On);
    ASSERT_EQ(frame.log.grain(), Grain::Object);
    EXPECT_FALSE(frame.log.drawsScene());
    EXPECT_LT(frame.consideredTriangles, scene->triangleCount() / 2);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, strategy->referenceFacing());
    Framebuffer target(view.viewport());
    const auto judgedOf = [&](const FrameLog& log) { return judge(GlEnvironment::renderer(), buffers, log, truth, target); };
    const Accuracy whole = judgedOf(frame.log).accuracy;
    EXPECT_EQ(whole.submittedTriangles, frame.consideredTriangles);
    // The nearest object of the list is seen.
    FrameLog without = frame.log;
    auto& ranges = std::get<DrawList>(without.commands.front()).ranges;
    const uint32_t object = ranges.front().instance;
    ranges.erase(ranges.begin());
    const auto seen =
        uint64_t(std::ranges::count_if(truth.triangle, [&](uint32_t item) { return objectAt(*scene, item) == object; }));
    ASSERT_GT(seen, 50u);
    const Accuracy lost = judgedOf(without).accuracy;
    EXPECT_GT(lost.missedPixels, whole.missedPixels + seen / 2);
    EXPECT_GT(lost.falselyCulledTriangles, 0u);
    // Colours by verdict and "why" speak of the object.
    const TriangleStates states = triangleStates(*scene, frame.log, truth.visible());
    EXPECT_EQ(states.counts[size_t(TriangleState::WronglyCulled)], 0u);
    EXPECT_EQ(states.counts[size_t(TriangleState::Visible)], truth.visibleTriangles.size());
    EXPECT_GT(triangleStates(*scene, without, truth.visible()).counts[size_t(TriangleState::WronglyCulled)], 0u);
    const auto sentences = [&](uint32_t instance) {
        std::string text;
        for (const WhyStep& step : why(*strategy->built(), frame.log, scene->firstTriangle(instance) + 700))
            text += step.sentence.english() + "\n";
        return text;
    };
    const uint32_t far = ranges.back().instance;
    EXPECT_NE(sentences(far).find("moves its surface by at most"), std::string::npos);
    EXPECT_NE(sentences(far).find("A coarser surface of the object is given to OpenGL"), std::string::npos) << sentences(far);
}

/// A camera that trembles about the distance at which a level changes.
TEST(LevelOfDetail, hysteresisKeepsALevelWhereTheCameraTrembles) {
    const ScenePointer scene = copiesOf(sphereMesh(720), {Mat4(1.0)});
    const auto switches = [&](double hysteresis) {
        const auto at = [](double distance) {
            return View({{0, 0, distance}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(40.0), 0.05, 1e4}, {120, 90});
        };
        const CullerPointer strategy = built(*scene, 1.0, hysteresis);
        // Away from the ball until its level changes.
        double distance = 3.0;
        double triangles = double(strategy->cull(at(distance)).consideredTriangles);
        const double before = triangles;
        while (triangles == before && distance < 1e3) {
            distance *= 1.01;
            triangles = double(strategy->cull(at(distance)).consideredTriangles);
        }
        EXPECT_LT(triangles, before);
        uint64_t found = 0;
        for (int i = 0; i < 40; ++i)
            found += uint64_t(figure(strategy->cull(at(distance * (i % 2 == 0 ? 0.99 : 1.01))).log, "levels_switched"));
        return found;
    };
    EXPECT_GE(switches(0.0), 30u);
    EXPECT_LE(switches(0.25), 1u);
}

}  // namespace
}  // namespace cullscope::test::level_of_detail_test
