#pragma once

#include <QString>

#include "core/visibility/strategy_request.h"

namespace cullscope::ui {

/// Words that several panels share.

/// "exact set", "lossless", "lossy".
[[nodiscard]] QString promiseWord(Promise promise);
/// What the word means, one sentence.
[[nodiscard]] QString promiseSentence(Promise promise);
[[nodiscard]] QString facingWord(Facing facing);
/// "Frustum", or "Frustum box=length" where a parameter is not at its default.
[[nodiscard]] QString strategyWords(const StrategyRequest& strategy);
/// "A", "B".
[[nodiscard]] QString viewLetter(int view);

/// A ratio with two significant digits: "0.97", "3.1", "15".
[[nodiscard]] QString ratioText(double ratio);
/// A share in per cent: "15", below 10 with one digit: "1.5"; never "0" for something, never "100" for less than all.
[[nodiscard]] QString percentText(double share);
[[nodiscard]] QString countText(uint64_t count);
[[nodiscard]] QString millisecondsText(double milliseconds);
[[nodiscard]] QString bytesText(uint64_t bytes);

}  // namespace cullscope::ui
