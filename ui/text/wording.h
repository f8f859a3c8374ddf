#pragma once

#include <QFontMetrics>
#include <QString>

#include "core/measure/statistics.h"
#include "core/scene/camera.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::ui {

/// Words and number formats that several panels share.

/// The promise in words: "exact set", "lossless" or "lossy".
[[nodiscard]] QString promiseWord(Promise promise);
/// The meaning of that word, in one sentence.
[[nodiscard]] QString promiseSentence(Promise promise);
[[nodiscard]] QString facingWord(Facing facing);
/// "Frustum", or "Frustum box=length" where a parameter is not at its default.
[[nodiscard]] QString strategyWords(const StrategyRequest& strategy);
/// What sentences call the baseline with a role, which is not BaselineRole::None.
[[nodiscard]] QString baselineWord(BaselineRole role);
/// "A", "B".
[[nodiscard]] QString viewLetter(int view);

/// A ratio with two significant digits: "0.97", "3.1", "15".
[[nodiscard]] QString ratioText(double ratio);
/// "×3.1", and with its 95 % interval "×3.1 (2.93 – 3.31)".
[[nodiscard]] QString speedText(const RatioEstimate& speed);
[[nodiscard]] QString speedWithInterval(const RatioEstimate& speed);
/// "2.93 – 3.31".
[[nodiscard]] QString intervalText(const RatioEstimate& speed);
/// A fraction in per cent: "15", below 10 with one digit: "1.5". Never "0" for a fraction above 0, never "100" for one below 1.
[[nodiscard]] QString percentText(double share);
/// The share of the headroom, which may be below 0 and above 1: "43 %", with its 95 % interval "43 % [38, 49]".
[[nodiscard]] QString headroomText(const RatioEstimate& share);
[[nodiscard]] QString countText(uint64_t count);
[[nodiscard]] QString millisecondsText(double milliseconds);
/// A size in pixels: "640 × 480".
[[nodiscard]] QString pixelText(const Viewport& size);
[[nodiscard]] QString bytesText(uint64_t bytes);

/// The height of a line in whichever of the window's languages, pixels: Korean and Chinese letters may come from a font that is
/// higher than the given one.
[[nodiscard]] int lineHeight(const QFontMetrics& metrics);

}  // namespace cullscope::ui
