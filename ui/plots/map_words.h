#pragma once

#include <QString>

#include "ui/plots/map_cells.h"

namespace cullscope::ui {

/// The texts of a map's picture that are the same for all maps.

/// Everything about a cell, in several lines, its state last.
[[nodiscard]] QString cellWords(const ShownMap& shown, const TriangleStates* truth, uint32_t cell);
/// The meaning of a cell's colour in a map coloured by state. Without truth a drawn cell is called "drawn", not "visible".
[[nodiscard]] QString stateWords(TriangleState state, bool truthKnown);
/// The meaning of the picked triangle's mark.
[[nodiscard]] QString pickedWords();

}  // namespace cullscope::ui
