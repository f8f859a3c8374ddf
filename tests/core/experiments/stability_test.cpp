// The battery of extreme cases: all of it is right here, and it can tell right from wrong.
#include "core/experiments/stability/battery.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/experiments/stability/lossless_check.h"
#include "core/scene/camera_path.h"
#include "core/scene/gallery/gallery.h"
#include "core/scene/scene_source.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/refusal.h"

namespace cullscope::test::stability_test {
namespace {

using stability::CaseResult;
using stability::Finding;
using stability::StabilityCase;

stability::Bench bench() { return {GlEnvironment::renderer(), GlEnvironment::info()}; }

/// Small samples leave out the cases that draw large scenes with every strategy.
bool drawsMuch(const StabilityCase& which) { return !which.scene.empty() && galleryScene(which.scene)->triangleCount() > 2'500; }

TEST(Stability, everyCaseIsRightAndEveryControlFails) {
    size_t controls = 0, promises = 0, losses = 0, run = 0;
    for (const StabilityCase& which : stability::battery()) {
        if (fewSamples() && drawsMuch(which)) continue;
        const CaseResult result = stability::runCase(bench(), which);
        ++run;
        ASSERT_FALSE(result.findings.empty()) << which.id;
        EXPECT_TRUE(result.right()) << stability::batteryText({result}, false);
        for (const Finding& finding : result.findings) {
            controls += finding.control ? 1 : 0;
            promises += finding.expected.text.starts_with("no pixel lost where") ? 1 : 0;
            losses += finding.lostShare > 0 ? 1 : 0;
        }
    }
    EXPECT_GE(run, fewSamples() ? 20u : 41u);
    EXPECT_GE(controls, fewSamples() ? 6u : 11u);
    EXPECT_GE(promises, 600u);
    EXPECT_GE(losses, 6u) << "where no strategy loses anything, the scenes are not extreme";
}

TEST(Stability, everyNumberOfTheListHasACase) {
    std::set<int> numbers;
    std::set<std::string> ids;
    for (const StabilityCase& which : stability::battery()) {
        numbers.insert(which.number);
        EXPECT_TRUE(ids.insert(which.id).second) << which.id;
        EXPECT_TRUE(which.id.starts_with(std::to_string(which.number) + "-")) << which.id;
        EXPECT_EQ(stability::casesNamed(which.id).size(), 1u);
    }
    for (int number = 1; number <= 34; ++number) EXPECT_TRUE(numbers.contains(number)) << number;
    EXPECT_EQ(stability::casesNamed("").size(), stability::battery().size());
    EXPECT_EQ(stability::casesNamed("16").size(), 2u);
    EXPECT_THAT(refusalOf([] { (void)stability::casesNamed("99"); }, ErrorKind::Usage), testing::HasSubstr("16-bowl"));
}

/// Leaves out the object that it is told of, and says that it loses nothing.
class Liar final : public StrategyWith<Structure> {
public:
    explicit Liar(uint32_t without) : m_without(without) {}

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& structure, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        DrawList list{frame.facing(), {}};
        for (const DrawRange& range : everything(structure.scene(), frame.facing()).ranges)
            if (range.instance != m_without) list.ranges.push_back(range);
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }

private:
    uint32_t m_without;
};

StrategyRequest liar(uint32_t without) {
    RegisteredStrategy strategy{findStrategy("backface").info, std::make_shared<Liar>(without)};
    strategy.info.id = "liar";
    return {"liar", ParameterSet(strategy.info.parameters), std::make_shared<RegisteredStrategy>(std::move(strategy))};
}

TEST(Stability, brokenPromiseIsFound) {
    const StabilityCase& bars = *stability::casesNamed("30-mirrored").front();
    const ScenePointer scene = galleryScene(bars.scene);
    // An object that is not there is left out by no one.
    for (const auto& [without, right] : {std::pair(0U, false), std::pair(1U, false), std::pair(99U, true)}) {
        const stability::Findings findings = stability::onTheScene(bench(), bars, scene, {liar(without)});
        ASSERT_EQ(findings.size(), 1u);
        EXPECT_EQ(findings.front().right, right) << without;
        EXPECT_EQ(findings.front().lostShare > 0.01, !right);
    }
}

TEST(Stability, controlThatDoesNotFailIsWrong) {
    StabilityCase bowl = *stability::casesNamed("16-bowl").front();
    bowl.controls = {{"backface", 0.0}};
    const ScenePointer scene = galleryScene(bowl.scene);
    stability::Findings findings = stability::onTheScene(bench(), bowl, scene, {strategyFromText("backface")});
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_FALSE(findings.front().right);
    EXPECT_TRUE(findings.front().control);
    bowl.controls = {{"spherical", 0.0}};
    findings = stability::onTheScene(bench(), bowl, scene, {strategyFromText("backface")});
    ASSERT_EQ(findings.size(), 2u) << "a control that is not tried";
    EXPECT_FALSE(findings.back().right);
}

TEST(Stability, pictureThatShouldNotBeEmptyIsWrong) {
    StabilityCase box = *stability::casesNamed("2-box").front();
    const ScenePointer scene = galleryScene(box.scene);
    EXPECT_TRUE(stability::onTheScene(bench(), box, scene, {strategyFromText("all")}).back().right);
    box.coversPixels = true;
    EXPECT_FALSE(stability::onTheScene(bench(), box, scene, {strategyFromText("all")}).back().right);
}

TEST(Stability, everySceneOfTheGalleryOpensWithItsCameras) {
    std::set<std::string> used;
    for (const StabilityCase& which : stability::battery()) {
        EXPECT_FALSE(which.scene.empty()) << which.id << " can be looked at";
        used.insert(which.scene);
    }
    for (const GeneratorInfo& info : galleryInfos()) {
        const OpenedScene opened = openScene(info.id);
        EXPECT_EQ(opened.specification, info.id);
        const std::vector<Camera>& cameras = opened.scene->remarks().cameras;
        ASSERT_FALSE(cameras.empty()) << info.id;
        EXPECT_EQ(opened.scene->remarks().camera, cameras.front());
        EXPECT_EQ(defaultPathName(*opened.scene), "given");
        const CameraPath path = cameraPath("given", *opened.scene);
        ASSERT_EQ(path.poses.size(), cameras.size());
        for (size_t pose = 0; pose < cameras.size(); ++pose) EXPECT_EQ(path.camera(pose), cameras[pose]) << info.id;
        EXPECT_TRUE(used.contains(info.id) || info.id.starts_with("gallery/case-21")) << info.id << " is in no case";
        EXPECT_THAT(refusalOf([&] { (void)openScene(info.id + ":triangles=3"); }, ErrorKind::Usage),
                    testing::HasSubstr("triangles"));
    }
}

TEST(Stability, resultFileHasEveryFinding) {
    std::vector<CaseResult> results;
    for (const char* id : {"3-flat-box", "34-nothing"})
        results.push_back(stability::runCase(bench(), *stability::casesNamed(id).front()));
    const auto json = nlohmann::json::parse(stability::batteryJson(results, GlEnvironment::info()));
    ASSERT_EQ(json["cases"].size(), 2u);
    EXPECT_EQ(json["cases"][0]["id"], "3-flat-box");
    EXPECT_EQ(json["cases"][0]["findings"].size(), 3u);
    EXPECT_EQ(json["cases"][0]["findings"][0]["control"], true);
    EXPECT_EQ(json["cases"][1]["findings"].size(), results[1].findings.size());
    EXPECT_EQ(json["cases"][1]["scene"], "gallery/case-34-nothing");
    const std::string text = stability::batteryText(results, true);
    EXPECT_THAT(text, testing::HasSubstr("2 of 2 cases right"));
    EXPECT_THAT(text, testing::HasSubstr("p-vertex"));
}

}  // namespace
}  // namespace cullscope::test::stability_test
