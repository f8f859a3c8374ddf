#include "core/experiments/stability/lossless_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/gpu/gpu_frame.h"
#include "core/measure/accuracy.h"
#include "core/scene/gallery/gallery.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::stability {
namespace {

/// The truths of the scene's views; each is drawn once for all strategies with its facing rule.
class Truths {
public:
    Truths(const Bench& bench, const ScenePointer& scene) : m_bench(bench), m_buffers(scene, Upload::Vbo) {}

    [[nodiscard]] const SceneBuffers& buffers() const { return m_buffers; }
    [[nodiscard]] std::shared_ptr<const Reference> of(const View& view, Facing facing) {
        return m_references.of(m_bench.renderer, m_buffers, view, facing);
    }

private:
    const Bench& m_bench;
    SceneBuffers m_buffers;
    References m_references;
};

struct Losses {
    uint64_t covered = 0, lost = 0, mayNotBeLost = 0;
    bool promised = false;  ///< at one of the views at least
};

/// One strategy from all cameras, at all sizes. Each size is a walk of its own: what a view remembers goes on from camera to
/// camera, as in use.
Losses lossesOf(const Bench& bench, const BuiltStrategy& strategy, const StabilityCase& which, Truths& truths) {
    Losses losses;
    for (const Viewport& size : which.sizes) {
        const ViewStatePointer state = strategy.begin();
        Framebuffer target(size);
        for (const Camera& camera : strategy.scene().remarks().cameras) {
            bench.progress.check();
            const View view(camera, size);
            GpuFrame frame(bench.renderer, truths.buffers(), view);
            strategy.draw(frame, *state);
            const std::shared_ptr<const Reference> truth = truths.of(view, strategy.referenceFacing());
            const JudgedFrame judged = judge(bench.renderer, truths.buffers(), frame.take(), *truth, target);
            losses.covered += truth->coveredPixels;
            losses.lost += judged.lostPixels();
            if (strategy.promiseAt(view) != Promise::Approximate) {
                losses.promised = true;
                losses.mayNotBeLost += judged.lostPixels();
            }
        }
    }
    return losses;
}

Finding findingOf(const StrategyRequest& request, const Losses& losses) {
    Finding finding;
    finding.subject = strategyLabel(request);
    finding.expected.text =
        losses.promised ? CULLSCOPE_TR("no pixel lost where it promises so") : CULLSCOPE_TR("its loss is measured");
    finding.lostShare = losses.covered == 0 ? 0.0 : double(losses.lost) / double(losses.covered);
    finding.found = {CULLSCOPE_TR("%1 of %2 pixels lost"), {std::to_string(losses.lost), std::to_string(losses.covered)}};
    finding.right = losses.mayNotBeLost == 0;
    return finding;
}

Finding refusalOf(const StrategyRequest& request, const Error& error) {
    Finding finding;
    finding.subject = strategyLabel(request);
    finding.expected.text = CULLSCOPE_TR("no pixel lost, or a sentence that says why it does not serve the scene");
    finding.found = error.message();
    finding.refused = true;
    return finding;
}

/// What a strategy declares, with one parameter at another value; none where that value is refused.
std::optional<StrategyRequest> with(const StrategyRequest& request, const std::string& key, const ParameterValue& value) {
    StrategyRequest other = request;
    other.parameters.set(key, value);
    if (other == request) return std::nullopt;
    return other;
}

/// Null where it is refused: that is found where it is drawn.
BuiltStrategyPointer builtUnlessRefused(const StrategyRequest& request, const ScenePointer& scene, StructureStore& structures) {
    try {
        return buildStrategy(strategyOf(request), request.parameters, scene, structures);
    } catch (const Error&) {
        return nullptr;
    }
}

void addVariants(std::vector<StrategyRequest>& requests, const StrategyRequest& usual, const ScenePointer& scene) {
    StructureStore structures;
    BuiltStrategyPointer built;  // kept for the variants, which cull with the same structure
    for (const ParameterDeclaration& parameter : usual.parameters.declarations()) {
        const auto add = [&](const ParameterValue& value) {
            if (auto other = with(usual, parameter.key, value)) requests.push_back(std::move(*other));
        };
        for (const ParameterDeclaration::Choice& choice : parameter.choices) add(choice.id);
        if (parameter.type == ParameterType::Boolean) add(!usual.parameters.boolean(parameter.key));
        const bool number = parameter.type == ParameterType::Integer || parameter.type == ParameterType::Real;
        if (!number || parameter.use != ParameterUse::Culling) continue;
        const auto least = parameter.type == ParameterType::Integer ? ParameterValue(int64_t(parameter.minimum))
                                                                    : ParameterValue(parameter.minimum);
        auto other = with(usual, parameter.key, least);
        if (!other) continue;
        if (!built) built = builtUnlessRefused(usual, scene, structures);
        if (!built || built->promise() != Promise::Approximate) continue;
        const BuiltStrategyPointer variant = builtUnlessRefused(*other, scene, structures);
        if (!variant || variant->promise() != Promise::Approximate) requests.push_back(std::move(*other));
    }
}

/// Whether the controls that the case names fail as they must.
void applyControls(const StabilityCase& which, Findings& findings) {
    for (const Control& control : which.controls) {
        const std::string label = strategyLabel(strategyFromText(control.strategy));
        const auto found = std::ranges::find(findings, label, &Finding::subject);
        if (found == findings.end()) {
            findings.push_back({label, {CULLSCOPE_TR("a loss that is seen"), {}}, {CULLSCOPE_TR("not tried"), {}}, false, true});
            continue;
        }
        found->control = true;
        found->expected = {CULLSCOPE_TR("more than %1 % of the pixels lost, and that is seen"),
                           {fmt::format("{:g}", 100 * control.leastLost)}};
        found->right = found->right && !found->refused && found->lostShare > control.leastLost;
    }
}

}  // namespace

std::vector<StrategyRequest> everyStrategy(const ScenePointer& scene, const GlInfo& gl) {
    std::vector<StrategyRequest> requests;
    for (const RegisteredStrategy& strategy : strategies()) {
        if (unavailable(strategy.info, gl)) continue;
        const StrategyRequest usual{strategy.info.id, ParameterSet(strategy.info.parameters)};
        requests.push_back(usual);
        addVariants(requests, usual, scene);
    }
    return requests;
}

Findings onTheScene(const Bench& bench, const StabilityCase& which, const ScenePointer& scene,
                    const std::vector<StrategyRequest>& requests) {
    Findings findings;
    Truths truths(bench, scene);
    StructureStore structures;
    std::vector<BuiltStrategyPointer> ofOneStrategy;  // variants that cull with the same structure follow each other
    uint64_t covered = 0;
    for (size_t i = 0; i < requests.size(); ++i) {
        if (i > 0 && requests[i].id != requests[i - 1].id) ofOneStrategy.clear();
        bench.progress.tell(double(i) / double(requests.size()), which.title);
        try {
            const BuiltStrategyPointer strategy =
                buildStrategy(strategyOf(requests[i]), requests[i].parameters, scene, structures, {nullptr, bench.progress.stop});
            ofOneStrategy.push_back(strategy);
            const Losses losses = lossesOf(bench, *strategy, which, truths);
            covered = std::max(covered, losses.covered);
            findings.push_back(findingOf(requests[i], losses));
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Interrupted) throw;
            findings.push_back(refusalOf(requests[i], error));
        }
    }
    applyControls(which, findings);
    if (which.coversPixels == (covered == 0))
        findings.push_back(
            {"item buffer",
             {which.coversPixels ? CULLSCOPE_TR("a surface in the picture") : CULLSCOPE_TR("an empty picture"), {}},
             {CULLSCOPE_TR("%1 pixels covered"), {std::to_string(covered)}},
             false});
    return findings;
}

Findings everyStrategyOnTheScene(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    return onTheScene(bench, which, scene, everyStrategy(scene, bench.gl));
}

}  // namespace cullscope::stability
