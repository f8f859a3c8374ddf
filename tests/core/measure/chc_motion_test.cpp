// `occlusion-chc` with the memory of a view that moves: where it waits for the answers, no sample differs from the picture of all
// objects, in any frame and whatever the memory holds.

#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/core/measure/crowd.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"

namespace cullscope::test::chc_motion_test {
namespace {

using Settings = std::map<std::string, std::string>;

const std::vector<Settings> kSettings{{},
                                      {{"batch", "1"}, {"together", "1"}, {"retest", "1"}, {"depth", "0"}},
                                      {{"batch", "3"}, {"retest", "2"}, {"phase", "same"}, {"leaf", "3"}},
                                      {{"batch", "4096"}, {"together", "4096"}, {"area", "100"}, {"depth", "8"}, {"leaf", "20"}}};

CullerPointer culler(const Settings& settings) {
    ParameterSet parameters(findStrategy("occlusion-chc").info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    return makeCuller("occlusion-chc", parameters);
}

/// At least three: a single crowd may hide little.
uint64_t crowds() { return std::max<uint64_t>(howMany(120, 6), 3); }

struct Tally {
    uint64_t frames = 0, covered = 0, hidden = 0, different = 0;
};

/// Compares every frame of a way of cameras with the picture of all objects.
class Motion {
public:
    explicit Motion(const ScenePointer& scene) : m_buffers(scene, Upload::Vbo) {
        for (const Settings& settings : kSettings) {
            m_cullers.push_back(culler(settings));
            m_cullers.back()->build(*scene);
        }
    }
    void expectNothingLost(const View& view, const std::string& where, Tally& tally) {
        for (size_t i = 0; i < m_cullers.size(); ++i) {
            const Culled frame = m_cullers[i]->cull(view, &GlEnvironment::renderer());
            const std::vector<float> truth = picture(m_buffers, view, everything(m_buffers.scene(), frame.log.facing)).depth;
            const std::vector<float> shown = picture(m_buffers, view, frame.drawList).depth;
            uint64_t different = 0;
            for (size_t pixel = 0; pixel < truth.size(); ++pixel) {
                tally.covered += truth[pixel] > 0.0f ? 1 : 0;
                different += truth[pixel] != shown[pixel] ? 1 : 0;
            }
            EXPECT_EQ(different, 0u) << where << ", setting " << i << "; " << described(view.camera(), view.viewport());
            tally.different += different;
            tally.hidden += frame.culledTriangles[size_t(Cause::Hidden)];
            ++tally.frames;
        }
    }

private:
    SceneBuffers m_buffers;
    std::vector<CullerPointer> m_cullers;
};

void report(const char* name, const Tally& tally) {
    std::printf("long: chc-motion %s frames %llu covered %llu hidden %llu different %llu\n", name,
                static_cast<unsigned long long>(tally.frames), static_cast<unsigned long long>(tally.covered),
                static_cast<unsigned long long>(tally.hidden), static_cast<unsigned long long>(tally.different));
    EXPECT_GT(tally.covered, tally.frames * 100);
    EXPECT_GT(tally.hidden, tally.frames * 50) << "the views hide next to nothing";
}

TEST(ChcMotion, nothingIsLostOnWalksThroughCrowdsThatTurnBy180DegreesASecond) {
    constexpr double kStep = 180.0 / 60.0;  // degrees a frame
    Tally tally;
    for (uint64_t seed = 1; seed <= crowds(); ++seed) {
        const ScenePointer scene = crowd(seed);
        Motion motion(scene);
        Random random(seed * 104729);
        Vec3 eye = random.direction() * random.between(0.0, 9.0);
        const Vec3 velocity = random.direction() * random.between(0.0, 0.3);
        const double start = random.between(0.0, 360.0);
        // Near planes that cut what the eye passes.
        const double near = std::pow(10.0, random.between(-2.0, 0.3));
        for (int frame = 0; frame < 24; ++frame, eye += velocity) {
            const double yaw = Angle::fromDegrees(start + kStep * frame).radians();
            const Vec3 ahead(std::sin(yaw), 0.2 * std::sin(3.0 * yaw), -std::cos(yaw));
            const View view({eye, eye + ahead, {0, 1, 0}, Angle::fromDegrees(70), near, near + 60}, {97, 61});
            motion.expectNothingLost(view, "seed " + std::to_string(seed) + " frame " + std::to_string(frame), tally);
        }
    }
    report("turning", tally);
}

TEST(ChcMotion, nothingIsLostWhereViewsLeapAndPicturesHaveAnySize) {
    constexpr std::array kSizes{Viewport{1, 1},  Viewport{1025, 3}, Viewport{3, 1025}, Viewport{129, 65},
                                Viewport{1, 97}, Viewport{257, 1},  Viewport{63, 127}, Viewport{5, 7}};
    Tally tally;
    for (uint64_t seed = 1; seed <= crowds(); ++seed) {
        const ScenePointer scene = crowd(seed + 1000);
        Motion motion(scene);
        Random random(seed * 15485863);
        for (int frame = 0; frame < 12; ++frame) {
            const Vec3 eye = random.direction() * random.between(0.0, 14.0);
            const double near = std::pow(10.0, random.between(-3.0, 0.5));
            const Camera camera{eye,
                                random.direction() * random.between(0.0, 5.0),
                                random.direction(),
                                Angle::fromDegrees(random.between(5, 130)),
                                near,
                                near + std::pow(10.0, random.between(0.3, 2.5))};
            // Each view stands for some frames.
            for (int stands = 0; stands < 3; ++stands)
                motion.expectNothingLost(View(camera, kSizes[random.bits() % kSizes.size()]),
                                         "seed " + std::to_string(seed) + " frame " + std::to_string(frame), tally);
        }
    }
    report("leaping", tally);
}

}  // namespace
}  // namespace cullscope::test::chc_motion_test
