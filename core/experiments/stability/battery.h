#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/gpu/context.h"
#include "core/gpu/renderer.h"
#include "core/scene/scene.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::stability {

/// What one strategy, or one function of the library, does in an extreme case.
struct Finding {
    std::string subject;  ///< a strategy as `strategyLabel` has it, or what else was tried
    Message expected{};
    Message found{};
    bool right = true;
    bool control = false;    ///< of what must be seen to fail, so that the case can tell right from wrong
    bool refused = false;    ///< it does not serve the case, and says so in a sentence
    double lostShare = 0.0;  ///< of the covered pixels, where pixels were compared
};
using Findings = std::vector<Finding>;

/// Where cases run: the current OpenGL.
struct Bench {
    Renderer& renderer;
    const GlInfo& gl;
    Progress progress{};
};

/// A strategy that must be seen to lose some of the picture where others must not.
struct Control {
    std::string strategy;    ///< as `strategyFromText` reads it
    double leastLost = 0.0;  ///< share of the covered pixels, exclusive
};

/// A case of the battery: data, and the function that finds what is right and wrong of it. The usual one is in lossless_check.h:
/// every strategy draws the scene from its cameras; those that promise to lose nothing there must lose nothing, the others are
/// measured.
struct StabilityCase {
    int number = 0;
    std::string id;        ///< "16-bowl"
    std::string title;     ///< English, marked for translation
    std::string expected;  ///< English, marked for translation: the right answer
    std::string scene{};   ///< of the gallery; empty: the case has none
    std::vector<Viewport> sizes{{240, 240}};
    std::vector<Control> controls{};
    Findings (*run)(const Bench& bench, const StabilityCase& which) = nullptr;
    bool coversPixels = true;  ///< false: the right picture is empty
};

/// All cases, by number.
[[nodiscard]] const std::vector<StabilityCase>& battery();
/// The cases with a number, or the one with an id; all of them for an empty text. Throws Error(Usage) naming what there is.
[[nodiscard]] std::vector<const StabilityCase*> casesNamed(std::string_view numberOrId);

struct CaseResult {
    const StabilityCase* which = nullptr;
    Findings findings;
    double seconds = 0.0;

    [[nodiscard]] size_t wrong() const;
    [[nodiscard]] bool right() const { return wrong() == 0; }
    /// The first finding that is wrong, else the first control; null where there is neither.
    [[nodiscard]] const Finding* tellingFinding() const;
    /// What was found, as one sentence.
    [[nodiscard]] Message found() const;
};
/// Needs a current context. Throws Error(Interrupted) on a stop request.
[[nodiscard]] CaseResult runCase(const Bench& bench, const StabilityCase& which);

/// The results as text, one line a case; `everything`: with a line for each finding.
[[nodiscard]] std::string batteryText(const std::vector<CaseResult>& results, bool everything);
[[nodiscard]] std::string batteryJson(const std::vector<CaseResult>& results, const GlInfo& gl);

}  // namespace cullscope::stability
