#pragma once

#include <QWidget>

namespace cullscope::ui {

/// The wheel changes this field only while it has the keyboard's focus; otherwise it scrolls what the field stands in.
void leaveWheelUnlessFocused(QWidget& field);

}  // namespace cullscope::ui
