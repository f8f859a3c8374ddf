#pragma once

#include <QIcon>
#include <QString>

namespace cullscope::ui {

/// One of the program's line icons in the colour of the palette's text, at any size and scale; follows a palette that changes.
[[nodiscard]] QIcon tintedIcon(const QString& name);

}  // namespace cullscope::ui
