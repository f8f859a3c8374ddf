#pragma once

#include <QMargins>
#include <QRect>
#include <QWidget>

namespace cullscope::ui {

/// The initial size of a window on a screen.
struct Start {
    QSize size;              ///< without the window frame
    bool maximized = false;  ///< the wanted size does not fit; `size` is then that of the window when it is restored
};

/// `available`: the screen without panels; `frame`: margins of the window manager's frame. All in the same pixels.
[[nodiscard]] Start startOn(const QRect& available, const QMargins& frame, const QSize& wanted);

/// Shows a window that was not shown yet: in the wanted size if the screen has room for it and a title bar, else maximised.
void showFitting(QWidget& window, const QSize& wanted);

/// Call it before the window is shown. Throws Error(Usage) where the screen's scale gives a side of the window, at its smallest,
/// more pixels than a picture may have (kMostPixels): no view of it could be drawn.
void requireDrawable(const QWidget& window);

}  // namespace cullscope::ui
