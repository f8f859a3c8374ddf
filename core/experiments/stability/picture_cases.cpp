// Cases of depths, places and pixels.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>

#include "core/base/error.h"
#include "core/experiments/stability/case_findings.h"
#include "core/experiments/stability/lossless_check.h"
#include "core/gpu/depth_formats.h"
#include "core/gpu/gpu_frame.h"
#include "core/measure/accuracy.h"
#include "core/scene/gallery/gallery.h"
#include "core/spatial/bsp_tree.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::stability {
namespace {

constexpr const char* kNearer = CULLSCOPE_TR("the nearer surface is seen");
constexpr const char* kFarther = CULLSCOPE_TR("the farther surface is seen");

Renderer::ItemBuffer itemsOf(const Bench& bench, const ScenePointer& scene, const View& view, Facing facing) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    return bench.renderer.drawItemBuffer(buffers, view, everything(*scene, facing));
}

/// Pixels of a moved scene's picture that differ from the unmoved one's by more than the raster's snapping.
Finding samePicture(const Bench& bench, const ScenePointer& here, const ScenePointer& there, const Viewport& size) {
    uint64_t differing = 0;
    const SceneBuffers buffers(here, Upload::Vbo);
    for (size_t i = 0; i < here->remarks().cameras.size(); ++i) {
        bench.progress.check();
        const View view(here->remarks().cameras[i], size), moved(there->remarks().cameras[i], size);
        const Reference truth = itemBufferReference(bench.renderer, buffers, view, Facing::TwoSided);
        Renderer::ItemBuffer items = itemsOf(bench, there, moved, Facing::TwoSided);
        const ShownPixels shown{std::move(items.depth), std::move(items.triangle)};
        differing += missedBeyondSnapping(truth, shown, *here, view) + extraBeyondSnapping(truth, shown, *here, view);
    }
    return {there->name(),
            {CULLSCOPE_TR("the picture of the scene at the origin"), {}},
            {CULLSCOPE_TR("%1 pixels differ beyond the raster's snapping"), {std::to_string(differing)}},
            differing == 0};
}

std::set<uint32_t> objectsDrawn(const Bench& bench, const BuiltStrategy& strategy, const SceneBuffers& buffers,
                                const View& view) {
    GpuFrame frame(bench.renderer, buffers, view);
    const ViewStatePointer state = strategy.begin();
    strategy.draw(frame, *state);
    std::set<uint32_t> objects;
    for (const DrawRange& range : drawnTriangles(strategy.scene(), frame.take()).ranges) objects.insert(range.instance);
    return objects;
}

/// Views in which a strategy draws other objects of a moved scene than of the unmoved one.
Finding sameObjects(const Bench& bench, const StrategyRequest& request, const ScenePointer& here, const ScenePointer& there,
                    const Viewport& size) {
    StructureStore structures;
    const SceneBuffers nearBuffers(here, Upload::Vbo), farBuffers(there, Upload::Vbo);
    const BuiltStrategyPointer near = buildStrategy(request.id, request.parameters, here, structures);
    const BuiltStrategyPointer far = buildStrategy(request.id, request.parameters, there, structures);
    size_t views = 0;
    for (size_t i = 0; i < here->remarks().cameras.size(); ++i) {
        const View view(here->remarks().cameras[i], size), moved(there->remarks().cameras[i], size);
        views += objectsDrawn(bench, *near, nearBuffers, view) == objectsDrawn(bench, *far, farBuffers, moved) ? 0 : 1;
    }
    return {strategyLabel(request) + ", " + there->name(),
            {CULLSCOPE_TR("the objects of the scene at the origin"), {}},
            {CULLSCOPE_TR("%1 views with other objects"), {std::to_string(views)}},
            views == 0};
}

uint64_t pixelsOf(std::span<const uint32_t> triangles, uint32_t number) {
    return uint64_t(std::ranges::count(triangles, number));
}

}  // namespace

Findings fixedDepth(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(scene->remarks().cameras.front(), which.sizes.front());
    Findings findings;
    for (const DepthFormat format : {DepthFormat::Float32, DepthFormat::Fixed24})
        for (const bool nearFirst : {true, false}) {
            const std::array<uint32_t, 2> order{nearFirst ? 0U : 1U, nearFirst ? 1U : 0U};
            const uint8_t nearer = nearFirst ? 1 : 2;
            const std::vector<uint8_t> seen = drawnWithDepth(bench.renderer, buffers, view, order, format);
            const bool right = std::ranges::all_of(seen, [&](uint8_t one) { return one == nearer; });
            // With 24 bits both have one depth, and the first one drawn stays: right by chance where that is the nearer.
            const bool expected = format == DepthFormat::Float32 || nearFirst;
            Finding finding = holds(std::string(format == DepthFormat::Float32 ? "32-bit float" : "24-bit fixed") +
                                        (nearFirst ? ", near to far" : ", far to near"),
                                    expected ? kNearer : kFarther, right ? kNearer : kFarther, right == expected);
            finding.control = !expected;
            findings.push_back(std::move(finding));
        }
    return findings;
}

Findings movedScene(const Bench& bench, const StabilityCase& which) {
    const ScenePointer here = galleryScene("gallery/case-21-origin");
    const Viewport size = which.sizes.front();
    Findings findings;
    for (const char* id : {"gallery/case-21-transforms", "gallery/case-21-coordinates"}) {
        const ScenePointer there = galleryScene(id);
        findings.push_back(samePicture(bench, here, there, size));
        // Those of which a draw list is whole objects, decided by the processor alone.
        for (const char* strategy : {"all", "frustum", "frustum-octree"})
            findings.push_back(sameObjects(bench, strategyFromText(strategy), here, there, size));
        for (Finding& finding : onTheScene(bench, which, there, everyStrategy(there, bench.gl))) {
            finding.subject += ", " + there->name();
            findings.push_back(std::move(finding));
        }
    }
    return findings;
}

Findings answersThatComeLate(const Bench& bench, const StabilityCase& which) {
    constexpr double kFewValues = 8;
    const ScenePointer scene = galleryScene(which.scene);
    std::vector<StrategyRequest> requests;
    for (const RegisteredStrategy& strategy : strategies()) {
        if (unavailable(strategy.info, bench.gl)) continue;
        const StrategyRequest usual{strategy.info.id, ParameterSet(strategy.info.parameters)};
        requests.push_back(usual);
        if (!strategy.info.remembers) continue;
        // Of what depends on the frames before: every value of numbers that have few.
        for (const ParameterDeclaration& parameter : strategy.info.parameters) {
            if (parameter.type != ParameterType::Integer || parameter.maximum - parameter.minimum > kFewValues) continue;
            for (auto value = int64_t(parameter.minimum); value <= int64_t(parameter.maximum); ++value) {
                StrategyRequest other = usual;
                other.parameters.set(parameter.key, value);
                if (!(other == usual)) requests.push_back(std::move(other));
            }
        }
    }
    return onTheScene(bench, which, scene, requests);
}

Findings smallParts(const Bench& bench, const StabilityCase& which) {
    std::vector<StrategyRequest> requests;
    for (const char* text : {"small-feature", "small-feature-triangle", "small-feature-bounded", "small-feature-bounded:pixels=0",
                             "level-of-detail", "frustum-octree", "spherical-lossless", "oracle"})
        requests.push_back(strategyFromText(text));
    return onTheScene(bench, which, galleryScene(which.scene), requests);
}

Findings selectionBuffer(const Bench& bench, const StabilityCase& /*which*/) {
    std::vector<EyeBox> boxes;
    for (int i = 0; i < 400; ++i) boxes.push_back({{0.2 * (i % 20) - 1.9, 0.2 * (i / 20) - 1.9, -5}, Vec3(0.05)});
    const Camera camera{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 10};
    const View view(camera, {100, 100});
    if (!bench.gl.compatibilityProfile) {
        Finding none{"GL_SELECT", {CULLSCOPE_TR("400 hits"), {}}, {CULLSCOPE_TR("this OpenGL has no selection mode"), {}}};
        none.refused = true;
        return {none};
    }
    Findings findings;
    for (const auto& [words, overflows] : {std::pair(1596, 1), std::pair(1600, 0)}) {
        const Renderer::SelectedBoxes selected = bench.renderer.selectBoxes(view, boxes, size_t(words));
        findings.push_back(number(fmt::format("{} words, hits", words), 400, double(selected.hits.size()), 0));
        Finding tries = number(fmt::format("{} words, overflows", words), overflows, selected.overflows, 0);
        tries.control = overflows > 0;
        findings.push_back(std::move(tries));
    }
    return findings;
}

Findings barsInACycle(const Bench& bench, const StabilityCase& which) {
    Findings findings = everyStrategyOnTheScene(bench, which);
    const ScenePointer scene = galleryScene(which.scene);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(scene->remarks().cameras.front(), which.sizes.front());
    for (const char* id : {"painter", "bsp"}) {
        StructureStore structures;
        const StrategyRequest request = strategyFromText(id);
        const BuiltStrategyPointer strategy = buildStrategy(request.id, request.parameters, scene, structures);
        GpuFrame frame(bench.renderer, buffers, view);
        const ViewStatePointer state = strategy->begin();
        strategy->draw(frame, *state);
        const uint64_t parts = frame.take().consideredTriangles(), all = scene->triangleCount();
        findings.push_back({std::string(id) + ", polygons drawn",
                            {CULLSCOPE_TR("more than %1"), {std::to_string(all)}},
                            {"%1", {std::to_string(parts)}},
                            parts > all});
    }
    return findings;
}

Findings pixelRule(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    const View view(scene->remarks().cameras.front(), which.sizes.front());
    const SceneBuffers buffers(scene, Upload::Vbo);
    Findings findings = everyStrategyOnTheScene(bench, which);
    for (const char* id : {"depth-buffer", "scan-line"}) {
        StructureStore structures;
        const StrategyRequest request = strategyFromText(std::string(id) + ":facing=two-sided");
        const BuiltStrategyPointer strategy = buildStrategy(request.id, request.parameters, scene, structures);
        const ViewStatePointer state = strategy->begin();
        GpuFrame frame(bench.renderer, buffers, view);
        strategy->draw(frame, *state);
        const FrameLog log = frame.take();
        const std::span<const uint32_t> triangles = std::get<FinishedPicturePointer>(log.commands.back())->triangle;
        findings.push_back(number(std::string(id) + ", pixels of the triangle", 10, double(pixelsOf(triangles, 1)), 0));
        findings.push_back(number(std::string(id) + ", pixels of its complement", 6, double(pixelsOf(triangles, 2)), 0));
    }
    // OpenGL does not say to which of two triangles a centre on their edge belongs, only that it belongs to one.
    uint64_t each = 0;
    for (const uint32_t instance : {0U, 1U}) {
        const Renderer::ItemBuffer items = bench.renderer.drawItemBuffer(
            buffers, view, DrawList{Facing::TwoSided, {{instance, 0, uint32_t(scene->meshOf(instance).indices().size())}}});
        each += items.triangle.size() - pixelsOf(items.triangle, 0);
    }
    const Renderer::ItemBuffer both = bench.renderer.drawItemBuffer(buffers, view, everything(*scene, Facing::TwoSided));
    findings.push_back(number("OpenGL, pixels of both", 16, double(both.triangle.size() - pixelsOf(both.triangle, 0)), 0));
    findings.push_back(number("OpenGL, pixels of each, summed", 16, double(each), 0));
    return findings;
}

Findings areasKept(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    // All but the strategies that draw by order have nothing to fear of these scenes.
    Findings findings = onTheScene(bench, which, scene,
                                   {strategyFromText("bsp"), strategyFromText("bsp:plane=fewest"), strategyFromText("painter")});
    for (const auto& [subject, plane] :
         {std::pair("BSP tree, plane=fewest", BspPlane::Fewest), std::pair("BSP tree, plane=balance", BspPlane::Balance)}) {
        Finding finding{subject, {CULLSCOPE_TR("areas kept to 1e-9"), {}}, {}};
        try {
            const BspTree tree(*scene, {.plane = plane}, {nullptr, bench.progress.stop});
            std::vector<double> shares(scene->triangleCount(), 0.0);
            for (const BspTree::Part& part : tree.parts()) shares[part.triangle] += part.share;
            double worst = 0.0;
            for (const double share : shares) worst = std::max(worst, std::abs(share - 1.0));
            finding.found = {CULLSCOPE_TR("%1 polygons, areas kept to %2"),
                             {std::to_string(tree.parts().size()), fmt::format("{:.1e}", worst)}};
            finding.right = worst <= 1e-9;
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Interrupted) throw;
            finding.found = error.message();
            finding.refused = true;
        }
        findings.push_back(std::move(finding));
    }
    return findings;
}

Findings oneRoundingApart(const Bench& bench, const StabilityCase& which) {
    const float depth = 0.02f, behind = std::nextafterf(depth, 0.0f), farBehind = 0.0199f;
    const auto word = [](PixelDifference difference) {
        return difference == PixelDifference::Unresolved ? CULLSCOPE_TR("unresolved")
               : difference == PixelDifference::Missed   ? CULLSCOPE_TR("missed")
                                                         : CULLSCOPE_TR("another difference");
    };
    const PixelDifference close = pixelDifference(depth, 1, behind, 2), far = pixelDifference(depth, 1, farBehind, 2);
    Findings findings{
        holds("one unit in the last place behind", word(PixelDifference::Unresolved), word(close),
              close == PixelDifference::Unresolved),
        asControl(holds("a hundredth behind", word(PixelDifference::Missed), word(far), far == PixelDifference::Missed))};
    for (Finding& finding : everyStrategyOnTheScene(bench, which)) findings.push_back(std::move(finding));
    return findings;
}

}  // namespace cullscope::stability
