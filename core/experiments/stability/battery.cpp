#include "core/experiments/stability/battery.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/experiments/result_file.h"
#include "core/experiments/stability/case_findings.h"
#include "core/experiments/stability/lossless_check.h"

namespace cullscope::stability {

const std::vector<StabilityCase>& battery() {
    constexpr const char* kNothingLost = CULLSCOPE_TR("strategies that promise to lose nothing lose nothing");
    constexpr const char* kAreas = CULLSCOPE_TR("ends, or stops with a sentence; areas are kept and nothing is lost");
    // A line or a few for each.
    // clang-format off
    static const std::vector<StabilityCase> kCases{
        {1, "1-sphere", CULLSCOPE_TR("A sphere beside a corner of the view that passes every plane test"), CULLSCOPE_TR("planes do not tell it apart, the exact test does"),
         "gallery/case-1-sphere", {{64, 64}}, {}, sphereBesideTheFrustum, false},
        {2, "2-box", CULLSCOPE_TR("A box beside the view that passes every p-vertex test"), CULLSCOPE_TR("planes do not tell it apart, the exact test does"),
         "gallery/case-2-box", {{64, 64}}, {}, boxBesideTheFrustum, false},
        {3, "3-flat-box", CULLSCOPE_TR("A flat box above a plane"), CULLSCOPE_TR("its extent's length keeps it, its p-vertex does not"),
         "gallery/case-3-flat-box", {{160, 120}}, {}, flatBox},
        {4, "4-far-plane", CULLSCOPE_TR("A sphere at a plane ten million from the origin"), CULLSCOPE_TR("visible; floats say that it is not"),
         "gallery/case-4-far-plane", {{160, 120}}, {}, planeFarFromTheOrigin},
        {5, "5-broken-file", CULLSCOPE_TR("A file with NaN, infinite numbers, faces without area and corners that are not there"), CULLSCOPE_TR("counted and left out; the other faces stay"),
         "gallery/case-5-broken-file", {{160, 120}}, {}, brokenFiles},
        {6, "6-seam", CULLSCOPE_TR("A triangle over the seam of a map of directions"), CULLSCOPE_TR("columns 359 and 0 only"),
         "gallery/case-6-seam", {{160, 120}}, {}, triangleOverTheSeam},
        {7, "7-pole", CULLSCOPE_TR("A triangle around the pole of a map of directions"), CULLSCOPE_TR("every column of the polar row"),
         "gallery/case-7-pole", {{160, 120}}, {}, triangleOverThePole},
        {8, "8-azimuths", CULLSCOPE_TR("Azimuths in other quadrants than the first"), CULLSCOPE_TR("225 and 90 degrees"),
         "gallery/case-8-azimuths", {{160, 120}}, {}, azimuths},
        {9, "9-rounded-azimuth", CULLSCOPE_TR("An azimuth that rounds to a whole turn"), CULLSCOPE_TR("column 359 or 0, never 360"),
         "gallery/case-9-rounded-azimuth", {{160, 120}}, {}, azimuthThatRoundsToATurn},
        {10, "10-small-zenith", CULLSCOPE_TR("A zenith angle of a hundred-millionth of a degree"), CULLSCOPE_TR("kept; an arc cosine gives 0"),
         "gallery/case-10-small-zenith", {{160, 120}}, {}, smallZenith},
        {11, "11-centre", CULLSCOPE_TR("A corner or a centroid exactly at the centre"), CULLSCOPE_TR("finite, and a candidate in every direction"),
         "gallery/case-11-centre", {{160, 120}}, {}, cornersAtTheCentre},
        {12, "12-latitudes", CULLSCOPE_TR("A camera at three radii at every latitude"), kNothingLost,
         "gallery/case-12-latitudes", {{160, 160}}, {}, everyStrategyOnTheScene},
        {13, "13-pole", CULLSCOPE_TR("A camera on the polar axis"), kNothingLost,
         "gallery/case-13-pole", {{160, 160}}, {}, everyStrategyOnTheScene},
        {14, "14-corner-rays", CULLSCOPE_TR("A sphere in view that all four corner rays miss"), kNothingLost,
         "gallery/case-14-corner-rays", {{160, 160}}, {}, everyStrategyOnTheScene},
        {15, "15-impact", CULLSCOPE_TR("A ray that enters the bounding sphere far from where it hits"), CULLSCOPE_TR("the walk reaches the surface, 37 degrees away"),
         "gallery/case-15-ball", {{160, 120}}, {}, rayOfImpact},
        {16, "16-torus", CULLSCOPE_TR("A tilted torus from afar"), kNothingLost,
         "gallery/case-16-torus", {{240, 240}}, {{"spherical", 0.05}}, everyStrategyOnTheScene},
        {16, "16-bowl", CULLSCOPE_TR("A thick bowl seen into its opening"), kNothingLost,
         "gallery/case-16-bowl", {{240, 240}}, {{"spherical", 0.5}}, everyStrategyOnTheScene},
        {17, "17-inside", CULLSCOPE_TR("A camera inside the bounding sphere, and exactly at its centre"), kNothingLost,
         "gallery/case-17-inside", {{160, 120}}, {}, everyStrategyOnTheScene},
        {18, "18-depths", CULLSCOPE_TR("Two surfaces a hundredth apart, near 0.01 and far a million"), kNothingLost,
         "gallery/case-18-depths", {{64, 64}}, {}, everyStrategyOnTheScene},
        {19, "19-fixed-depth", CULLSCOPE_TR("The same on a depth buffer of 24 bits, in both drawing orders"), CULLSCOPE_TR("wrong in one of them: floats are right in both"),
         "gallery/case-18-depths", {{32, 32}}, {}, fixedDepth},
        {20, "20-tiny", CULLSCOPE_TR("A body of size 1e-18"), kNothingLost,
         "gallery/case-20-tiny", {{120, 90}}, {}, everyStrategyOnTheScene},
        {20, "20-huge", CULLSCOPE_TR("A body of size 1e18"), kNothingLost,
         "gallery/case-20-huge", {{120, 90}}, {}, everyStrategyOnTheScene},
        {20, "20-mixed", CULLSCOPE_TR("Bodies of both sizes in one scene"), kNothingLost,
         "gallery/case-20-mixed", {{120, 90}}, {}, everyStrategyOnTheScene},
        {21, "21-moved", CULLSCOPE_TR("A scene moved by ten million, through its transforms and through its coordinates"), CULLSCOPE_TR("the same objects, the same picture away from edges, and nothing lost"),
         "gallery/case-21-transforms", {{160, 120}}, {}, movedScene},
        {22, "22-around", CULLSCOPE_TR("A box around the eye, and one that reaches beyond the far plane"), CULLSCOPE_TR("not outside, and nothing lost"),
         "gallery/case-22-boxes", {{64, 64}}, {}, boxesAroundTheEye},
        {23, "23-narrow", CULLSCOPE_TR("A field of view of a hundredth of a degree"), kNothingLost,
         "gallery/case-23-narrow", {{160, 120}, {1, 1}, {16384, 1}}, {}, everyStrategyOnTheScene},
        {23, "23-wide", CULLSCOPE_TR("A field of view of 179 degrees"), kNothingLost,
         "gallery/case-23-wide", {{160, 120}, {1, 1}, {16384, 1}}, {}, everyStrategyOnTheScene},
        {24, "24-turning", CULLSCOPE_TR("An eye that turns by 180 degrees a second, and answers that come late"), CULLSCOPE_TR("without latency nothing is lost; with it the loss is seen"),
         "gallery/case-24-turning", {{160, 120}}, {{"octree-query:latency=2", 0.0}}, answersThatComeLate},
        {25, "25-select-buffer", CULLSCOPE_TR("Selection mode with 400 names in a buffer that is four words too small"), CULLSCOPE_TR("the overflow is seen, and tried again: 400 hits"),
         "gallery/case-25-names", {{160, 120}}, {}, selectionBuffer},
        {26, "26-proxy", CULLSCOPE_TR("An object's box around the eye and the far plane, and an eye just outside of it"), kNothingLost,
         "gallery/case-26-proxy", {{160, 160}}, {}, everyStrategyOnTheScene},
        {27, "27-cycle", CULLSCOPE_TR("Three bars that overlap each other in a cycle"), CULLSCOPE_TR("cut at least once and right at every overlap; centroids alone are not"),
         "gallery/case-27-cycle", {{160, 120}}, {{"painter:sort=centroid", 0.0}}, barsInACycle},
        {28, "28-pixels", CULLSCOPE_TR("Edges through pixel centres: a triangle and its complement"), CULLSCOPE_TR("10 and 6 pixels, 16 together, none twice"),
         "gallery/case-28-pixels", {{8, 8}}, {}, pixelRule},
        {29, "29-parts", CULLSCOPE_TR("40,000 abutting parts just below the threshold of small features"), CULLSCOPE_TR("as published a hole opens; with a bound it does not"),
         "gallery/case-29-parts", {{1920, 1080}}, {{"small-feature", 0.5}}, smallParts},
        {30, "30-mirrored", CULLSCOPE_TR("Mirrored and flattened bodies"), kNothingLost,
         "gallery/case-30-mirrored", {{200, 150}}, {}, everyStrategyOnTheScene},
        {31, "31-coplanar", CULLSCOPE_TR("Ten thousand polygons in one plane in a BSP tree"), kAreas,
         "gallery/case-31-coplanar", {{120, 90}}, {}, areasKept},
        {31, "31-edges", CULLSCOPE_TR("Polygons that share every edge in a BSP tree"), kAreas,
         "gallery/case-31-edges", {{120, 90}}, {}, areasKept},
        {31, "31-slivers", CULLSCOPE_TR("Slivers a billion times as long as wide in a BSP tree"), kAreas,
         "gallery/case-31-slivers", {{120, 90}}, {}, areasKept},
        {31, "31-random", CULLSCOPE_TR("Ten thousand random triangles in a BSP tree"), kAreas,
         "gallery/case-31-random", {{120, 90}}, {}, areasKept},
        {32, "32-rounding", CULLSCOPE_TR("Two surfaces one rounding of a float apart"), CULLSCOPE_TR("unresolved, and not counted as missed"),
         "gallery/case-32-rounding", {{64, 64}}, {}, oneRoundingApart},
        {33, "33-near", CULLSCOPE_TR("Triangles through the near plane with every corner outside the view"), kNothingLost,
         "gallery/case-33-near", {{160, 120}}, {}, everyStrategyOnTheScene},
        {34, "34-nothing", CULLSCOPE_TR("An empty object and triangles without area beside a square"), kNothingLost,
         "gallery/case-34-nothing", {{64, 64}}, {}, everyStrategyOnTheScene},
        {35, "35-inside-out", CULLSCOPE_TR("A closed mesh of two boxes that cross, one of which is inside out"), CULLSCOPE_TR("back faces are seen from outside: back-face culling loses them, and does not promise otherwise"),
         "gallery/case-35-inside-out", {{160, 120}}, {{"backface", 0.01}}, everyStrategyOnTheScene},
    };
    // clang-format on
    return kCases;
}

std::vector<const StabilityCase*> casesNamed(std::string_view numberOrId) {
    std::vector<const StabilityCase*> cases;
    for (const StabilityCase& each : battery())
        if (numberOrId.empty() || each.id == numberOrId || std::to_string(each.number) == numberOrId) cases.push_back(&each);
    if (!cases.empty()) return cases;
    std::string known;
    for (const StabilityCase& each : battery()) known += (known.empty() ? "" : ", ") + each.id;
    throwUsage(CULLSCOPE_TR("There is no case \"%1\". Known: their numbers, or %2."), {std::string(numberOrId), known});
}

size_t CaseResult::wrong() const {
    return size_t(std::ranges::count_if(findings, [](const Finding& finding) { return !finding.right; }));
}

Message CaseResult::found() const {
    const std::string count = std::to_string(findings.size());
    if (const Finding* telling = tellingFinding()) {
        if (!telling->right)
            return {CULLSCOPE_TR("%1 of %2 findings are wrong, the first one: %3"),
                    {std::to_string(wrong()), count, telling->subject}};
        return {CULLSCOPE_TR("all %1 findings are right; the control fails as it must: %2"), {count, telling->subject}};
    }
    return {CULLSCOPE_TR("all %1 findings are right"), {count}};
}

const Finding* CaseResult::tellingFinding() const {
    for (const auto& tells :
         {+[](const Finding& finding) { return !finding.right; }, +[](const Finding& finding) { return finding.control; }})
        if (const auto found = std::ranges::find_if(findings, tells); found != findings.end()) return &*found;
    return nullptr;
}

CaseResult runCase(const Bench& bench, const StabilityCase& which) {
    const auto start = std::chrono::steady_clock::now();
    CaseResult result{&which, which.run(bench, which)};
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::string batteryText(const std::vector<CaseResult>& results, bool everything) {
    std::string text;
    size_t right = 0;
    double seconds = 0.0;
    for (const CaseResult& result : results) {
        right += result.right() ? 1 : 0;
        seconds += result.seconds;
        const Finding* telling = result.tellingFinding();
        text +=
            fmt::format("{:<20} {:<5}  {}: {}{}\n", result.which->id, result.right() ? "right" : "WRONG", result.which->expected,
                        result.found().english(), telling == nullptr ? "" : ": " + telling->found.english());
        for (const Finding& finding : result.findings)
            if (everything || !finding.right)
                text += fmt::format("    {:<44} {:<7} {} | {}\n", finding.subject,
                                    !finding.right    ? "WRONG"
                                    : finding.control ? "control"
                                    : finding.refused ? "refuses"
                                                      : "right",
                                    finding.expected.english(), finding.found.english());
    }
    return text + fmt::format("{} of {} cases right, {:.0f} s\n", right, results.size(), seconds);
}

std::string batteryJson(const std::vector<CaseResult>& results, const GlInfo& gl) {
    Json cases = Json::array();
    for (const CaseResult& result : results) {
        Json findings = Json::array();
        for (const Finding& finding : result.findings)
            findings.push_back({{"subject", finding.subject},
                                {"expected", finding.expected.english()},
                                {"found", finding.found.english()},
                                {"right", finding.right},
                                {"control", finding.control},
                                {"refused", finding.refused},
                                {"lost_share", finding.lostShare}});
        cases.push_back({{"number", result.which->number},
                         {"id", result.which->id},
                         {"title", result.which->title},
                         {"expected", result.which->expected},
                         {"scene", result.which->scene},
                         {"right", result.right()},
                         {"seconds", result.seconds},
                         {"findings", std::move(findings)}});
    }
    const Json root{{"tool", {{"name", "cullscope"}, {"version", toolVersion().version}, {"commit", toolVersion().commit}}},
                    {"machine", {{"gl_renderer", gl.renderer}, {"gl_version", gl.version}}},
                    {"cases", std::move(cases)}};
    return root.dump(2) + "\n";
}

}  // namespace cullscope::stability
