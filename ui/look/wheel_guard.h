#pragma once

#include <QWidget>

namespace cullscope::ui {

/// Lets the wheel change a field only while the field has the keyboard focus; otherwise the wheel scrolls the area around it.
void leaveWheelUnlessFocused(QWidget& field);

}  // namespace cullscope::ui
