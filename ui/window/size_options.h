#pragma once

#include <QMenu>
#include <functional>
#include <optional>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// Adds the sizes that pictures can have to a menu, of which one is chosen: the usual ones, another one that a dialog asks for,
/// and that of the window. `size` is the present one (none: the window's), `shown` what it is in pixels. `choose` is called with
/// the chosen one.
void addSizeOptions(QMenu& menu, const std::optional<Viewport>& size, const Viewport& shown,
                    std::function<void(const std::optional<Viewport>&)> choose);

/// A size as settings keep it, "640x480" or "window", and back; none: another text.
[[nodiscard]] QString pictureSizeText(const std::optional<Viewport>& size);
[[nodiscard]] std::optional<std::optional<Viewport>> pictureSizeFromText(const QString& text);

}  // namespace cullscope::ui
