#pragma once

#include <QMargins>
#include <QRect>
#include <QWidget>

namespace cullscope::ui {

/// How a window begins on a screen.
struct Start {
    QSize size;              ///< without the frame
    bool maximized = false;  ///< the wanted size has no place; `size` is then what the window has when it is no longer maximised
};

/// `available`: the screen less panels; `frame`: what a window manager puts around a window. All in the same pixels.
[[nodiscard]] Start startOn(const QRect& available, const QMargins& frame, const QSize& wanted);

/// Shows a window that is not shown yet: in the wanted size where the screen has place for it and a title bar, else maximised.
void showFitting(QWidget& window, const QSize& wanted);

}  // namespace cullscope::ui
