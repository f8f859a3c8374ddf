#pragma once

#include <fmt/format.h>

#include "core/experiments/stability/battery.h"

namespace cullscope::stability {

/// A finding of a test that answers yes or no.
[[nodiscard]] inline Finding holds(std::string subject, const char* expected, const char* found, bool right) {
    return {std::move(subject), {expected, {}}, {found, {}}, right};
}
/// A finding of a number that must have a value.
[[nodiscard]] inline Finding number(std::string subject, double expected, double found, double tolerance) {
    return {std::move(subject),
            {"%1", {fmt::format("{:.10g}", expected)}},
            {"%1", {fmt::format("{:.10g}", found)}},
            found >= expected - tolerance && found <= expected + tolerance};
}
/// The same finding as a control, which must be seen to fail.
[[nodiscard]] inline Finding asControl(Finding finding) {
    finding.control = true;
    return finding;
}

// The functions of the cases that do more than draw a scene with every strategy.
Findings sphereBesideTheFrustum(const Bench& bench, const StabilityCase& which);
Findings boxBesideTheFrustum(const Bench& bench, const StabilityCase& which);
Findings flatBox(const Bench& bench, const StabilityCase& which);
Findings planeFarFromTheOrigin(const Bench& bench, const StabilityCase& which);
Findings brokenFiles(const Bench& bench, const StabilityCase& which);
Findings triangleOverTheSeam(const Bench& bench, const StabilityCase& which);
Findings triangleOverThePole(const Bench& bench, const StabilityCase& which);
Findings azimuths(const Bench& bench, const StabilityCase& which);
Findings azimuthThatRoundsToATurn(const Bench& bench, const StabilityCase& which);
Findings smallZenith(const Bench& bench, const StabilityCase& which);
Findings cornersAtTheCentre(const Bench& bench, const StabilityCase& which);
Findings rayOfImpact(const Bench& bench, const StabilityCase& which);
Findings fixedDepth(const Bench& bench, const StabilityCase& which);
Findings movedScene(const Bench& bench, const StabilityCase& which);
Findings boxesAroundTheEye(const Bench& bench, const StabilityCase& which);
Findings answersThatComeLate(const Bench& bench, const StabilityCase& which);
Findings smallParts(const Bench& bench, const StabilityCase& which);
Findings selectionBuffer(const Bench& bench, const StabilityCase& which);
Findings barsInACycle(const Bench& bench, const StabilityCase& which);
Findings pixelRule(const Bench& bench, const StabilityCase& which);
Findings areasKept(const Bench& bench, const StabilityCase& which);
Findings oneRoundingApart(const Bench& bench, const StabilityCase& which);

}  // namespace cullscope::stability
