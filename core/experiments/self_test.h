#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/experiments/certify/certify.h"
#include "core/experiments/experiment.h"
#include "core/experiments/stability/battery.h"

namespace cullscope {

/// What is asked of a machine and its OpenGL.
struct SelfTestRequest {
    bool graphicsCard = false;        ///< with the sizes for one, up to 10^9 triangles
    uint64_t certifiedViews = 2'000;  ///< of each strategy that promises to lose nothing
    std::string court{};              ///< the scene of the courts; empty: the experiment's own
    ExperimentOptions experiments{};
    certify::TrierMaker trier{};  ///< CertifyRequest::trier
};

/// What one machine says of all that Cullscope promises, and how fast it is there.
struct SelfTest {
    GlInfo gl;
    bool graphicsCard = false;
    std::vector<stability::CaseResult> battery{};
    std::vector<certify::Certificate> certificates{};  ///< of strategies that promised something in some view
    std::vector<ResultTable> tables{};                 ///< of the experiments on growth
    std::vector<Message> missing{};                    ///< why a table is not there
    bool interrupted = false;

    /// Every case is right, no promise was broken, and every check holds.
    [[nodiscard]] bool right() const;
};

/// Throws Error(OpenGl) where the processor draws.
void requireGraphicsCard(const GlInfo& gl);

/// The battery, a certificate of every strategy that promises to lose nothing, and the experiments on growth, in this order, each
/// with an OpenGL context of its own. `finished` is given each part's text as soon as it is there. A stop request ends it with
/// what is complete. Throws, before it begins, as requireGraphicsCard for a graphics card, and where the scene of the courts
/// cannot be opened.
[[nodiscard]] SelfTest selfTest(const SelfTestRequest& request, const Progress& progress = {},
                                const std::function<void(const std::string& text)>& finished = {});

/// docs/files.md, "Self-test".
[[nodiscard]] std::string selfTestJson(const SelfTest& test);

}  // namespace cullscope
