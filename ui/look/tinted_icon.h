#pragma once

#include <QIcon>
#include <QString>

namespace cullscope::ui {

/// The program's line icon of that name in the text colour of the palette, at any size and scale; follows changes of the palette.
[[nodiscard]] QIcon tintedIcon(const QString& name);

}  // namespace cullscope::ui
