// Strategies that remember what was visible, with the memory of a view that moves: where they promise it, no sample differs from
// the picture of all objects, in any frame and whatever the memory holds.

#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/core/measure/crowd.h"
#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"

namespace cullscope::test::occlusion_motion_test {
namespace {

using Settings = std::map<std::string, std::string>;

struct Method {
    const char* id;
    Settings settings;
};
const std::vector<Method> kMethods{
    {"occlusion-chc", {}},
    {"occlusion-chc", {{"batch", "1"}, {"together", "1"}, {"retest", "1"}, {"depth", "0"}}},
    {"occlusion-chc", {{"batch", "3"}, {"retest", "2"}, {"phase", "same"}, {"leaf", "3"}}},
    {"occlusion-chc", {{"batch", "4096"}, {"together", "4096"}, {"area", "100"}, {"depth", "8"}, {"leaf", "20"}}},
    {"occlusion-hiz", {{"rounds", "1"}}},
    {"occlusion-hiz", {{"large", "0"}}},
    {"occlusion-hiz", {{"rounds", "3"}, {"facing", "two-sided"}}},
    {"clusters", {{"occlusion", "hiz"}, {"size", "16"}}}};

CullerPointer culler(const Method& method) {
    ParameterSet parameters(findStrategy(method.id).info.parameters);
    for (const auto& [key, value] : method.settings) parameters.setFromText(key, value);
    return makeCuller(method.id, parameters);
}

/// At least three: a single crowd may hide little.
uint64_t crowds() { return std::max<uint64_t>(howMany(120, 6), 3); }

struct Tally {
    uint64_t frames = 0, covered = 0, hidden = 0, different = 0;
};
using Tallies = std::map<std::string, Tally>;

/// Compares every frame of a way of cameras with the picture of all objects.
class Motion {
public:
    explicit Motion(const ScenePointer& scene) : m_buffers(scene, Upload::Vbo) {
        for (const Method& method : kMethods) {
            m_cullers.push_back(culler(method));
            m_cullers.back()->build(*scene);
        }
    }
    void expectNothingLost(const View& view, const std::string& where, Tallies& tallies) {
        for (size_t i = 0; i < m_cullers.size(); ++i) {
            const Culled frame = m_cullers[i]->cull(view, &GlEnvironment::renderer());
            const std::vector<float> truth = picture(m_buffers, view, everything(m_buffers.scene(), frame.log.facing)).depth;
            const std::vector<float> shown = picture(m_buffers, view, frame.drawList).depth;
            Tally& tally = tallies[kMethods[i].id];
            uint64_t different = 0;
            for (size_t pixel = 0; pixel < truth.size(); ++pixel) {
                tally.covered += truth[pixel] > 0.0f ? 1 : 0;
                different += truth[pixel] != shown[pixel] ? 1 : 0;
            }
            EXPECT_EQ(different, 0u) << where << ", " << kMethods[i].id << ", setting " << i << "; "
                                     << described(view.camera(), view.viewport());
            tally.different += different;
            tally.hidden += frame.culledTriangles[size_t(Cause::Hidden)];
            ++tally.frames;
        }
    }

private:
    SceneBuffers m_buffers;
    std::vector<CullerPointer> m_cullers;
};

/// `leastOfHiz`: triangles that occlusion-hiz hides in a frame, so that the views are not empty.
void report(const char* name, const Tallies& tallies, uint64_t leastOfHiz = 50) {
    for (const auto& [id, tally] : tallies) {
        std::printf("long: occlusion-motion %s %s frames %llu covered %llu hidden %llu different %llu\n", name, id.c_str(),
                    static_cast<unsigned long long>(tally.frames), static_cast<unsigned long long>(tally.covered),
                    static_cast<unsigned long long>(tally.hidden), static_cast<unsigned long long>(tally.different));
        EXPECT_GT(tally.covered, tally.frames * 100) << id;
        // Of what clusters leave out, less counts as hidden: much of it is turned away or outside the frustum.
        const uint64_t least = id == "clusters" ? 20 : id == "occlusion-hiz" ? leastOfHiz : 50;
        EXPECT_GT(tally.hidden, tally.frames * least) << id << ": the views hide next to nothing";
    }
}

TEST(OcclusionMotion, nothingIsLostOnWalksThroughCrowdsThatTurnBy180DegreesASecond) {
    constexpr double kStep = 180.0 / 60.0;  // degrees a frame
    Tallies tallies;
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
            motion.expectNothingLost(view, "seed " + std::to_string(seed) + " frame " + std::to_string(frame), tallies);
        }
    }
    report("turning", tallies);
}

TEST(OcclusionMotion, nothingIsLostWhereViewsLeapAndPicturesHaveAnySize) {
    constexpr std::array kSizes{Viewport{1, 1},  Viewport{1025, 3}, Viewport{3, 1025}, Viewport{129, 65},
                                Viewport{1, 97}, Viewport{257, 1},  Viewport{63, 127}, Viewport{5, 7}};
    Tallies tallies;
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
                                         "seed " + std::to_string(seed) + " frame " + std::to_string(frame), tallies);
        }
    }
    // After a leap occlusion-hiz knows little: over the long sample it hides 45 triangles a frame.
    report("leaping", tallies, howMany(40, 50));
}

TEST(OcclusionMotion, nothingIsLostInPicturesOfAnySizeInParallelViewsAndFarFromTheOrigin) {
    Tallies tallies;
    const uint64_t frames = howMany(1025, 40);
    for (const double offset : {0.0, 1e6}) {
        const Vec3 place(offset, -offset, 0.5 * offset);
        const ScenePointer scene = crowd(77, place);
        Motion motion(scene);
        for (uint64_t frame = 0; frame < frames; ++frame) {
            Random random(frame + 1);
            const int length = 1 + int(frame * 1024 / std::max<uint64_t>(frames - 1, 1));
            const int other = 1 + int(std::pow(10.0, random.between(0.0, 2.2)));
            // A walk around the crowd that turns by three degrees a frame, every third picture a parallel one.
            const double yaw = Angle::fromDegrees(3.0 * double(frame)).radians();
            const Vec3 eye = place + 8.0 * Vec3(std::sin(yaw), 0.1, std::cos(yaw));
            const Camera camera{eye, place, {0, 1, 0}, Angle::fromDegrees(60), 0.5, 40};
            const View view(frame % 3 == 2 ? inParallel(camera) : camera,
                            frame % 2 == 0 ? Viewport{length, other} : Viewport{other, length});
            motion.expectNothingLost(view, "offset " + std::to_string(offset) + " frame " + std::to_string(frame), tallies);
        }
    }
    report("sizes", tallies);
}

}  // namespace
}  // namespace cullscope::test::occlusion_motion_test
