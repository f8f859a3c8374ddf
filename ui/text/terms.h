#pragma once

#include <QStringList>

#include "core/frame/words.h"

namespace cullscope::ui {

/// What core says with numbers, in the user's language and with the numbers written in the user's way.
[[nodiscard]] QString translated(const Term& term);
[[nodiscard]] QString translated(const Words& words);
[[nodiscard]] QStringList translatedLines(const std::vector<Words>& lines);

/// A length in the mesh's units with three significant digits.
[[nodiscard]] QString lengthText(double length);
/// An angle in degrees, with enough digits to tell a map's cells apart.
[[nodiscard]] QString degreesText(double radians);
/// A ratio with two digits after the point.
[[nodiscard]] QString ratioWithTwoDigits(double ratio);

}  // namespace cullscope::ui
