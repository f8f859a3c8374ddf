// Why a triangle is drawn or not by the spherical strategies: what the chain says is what the frame's log says.

#include <set>

#include "core/frame/entry_words.h"
#include "core/visibility/why.h"
#include "tests/support/long_mode.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::spherical_why_test {
namespace {

using Kind = Subject::Kind;

std::string worded(const Message& message) { return message.english(); }

/// The sentences of a log about bands and cells of an object.
std::set<std::string> sentencesOfCells(const FrameLog& log) {
    std::set<std::string> sentences;
    for (const Decision& decision : log.decisions)
        if ((decision.subject.kind == Kind::Band || decision.subject.kind == Kind::Cell) && decision.sentence != nullptr)
            sentences.insert(worded(whyStep(decision).sentence));
    return sentences;
}

/// Bumps that hide each other, and views of them from all around, in which the near plane does not cut the bounding sphere.
struct Bumps {
    ScenePointer scene = sceneOf({bumpyMesh(3, 4'000, 0.4)}, {Mat4(1.0)});

    [[nodiscard]] static View view(int number) {
        Random random(uint64_t(number) + 11);
        return {{(3.0 + number % 3) * random.direction(), Vec3(0.0), {0, 0.6, 0.8}, Angle::fromDegrees(50), 0.05, 60},
                {160, 120}};
    }
};

TEST(SphericalWhy, whatIsSaidOfBandsAndCellsStandsInTheLogAndAgreesWithWhatBecameOfTheTriangle) {
    const Bumps bumps;
    const uint64_t stride = fewSamples() ? 61 : 7;
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const CullerPointer culler = makeCuller(id);
        culler->build(*bumps.scene);
        size_t hidden = 0, afterACut = 0, drawn = 0;
        for (int number = 0; number < (longMode() ? 24 : 4); ++number) {
            const Culled frame = culler->cull(Bumps::view(number), Recording::On);
            const std::set<std::string> said = sentencesOfCells(frame.log);
            for (uint64_t triangle = 0; triangle < bumps.scene->triangleCount(); triangle += stride) {
                const std::vector<WhyStep> steps = why(*culler->built(), frame.log, triangle);
                size_t tests = 0;
                Containment containment = Containment::Straddles;
                for (const WhyStep& step : steps) {
                    if (!said.contains(worded(step.sentence))) {
                        EXPECT_EQ(worded(step.sentence).find("horizon"), std::string::npos) << worded(step.sentence);
                        continue;
                    }
                    ++tests;
                    containment = step.containment;
                    afterACut += worded(step.sentence).find("ended it") != std::string::npos ? 1 : 0;
                }
                EXPECT_LE(tests, 1u) << id << " view " << number << " triangle " << triangle << ": one test decides a cell";
                // A band across 90 degrees is drawn in part; a cell that rises above its horizon is drawn.
                const bool inPart = containment == Containment::Straddles && std::string(id) == "spherical";
                if (tests == 0 || inPart) continue;
                const bool given = std::ranges::any_of(
                    steps, [](const WhyStep& step) { return worded(step.sentence) == "The triangle is given to OpenGL."; });
                EXPECT_EQ(given, containment != Containment::Outside) << id << " view " << number << " triangle " << triangle;
                ++(given ? drawn : hidden);
            }
        }
        EXPECT_GT(drawn, 50u) << id;
        EXPECT_GT(hidden, 5u) << id;
        if (std::string(id) == "spherical" && !fewSamples()) {
            EXPECT_GT(afterACut, 0u) << "no cell lies behind a band that was hidden";
        }
    }
}

}  // namespace
}  // namespace cullscope::test::spherical_why_test
