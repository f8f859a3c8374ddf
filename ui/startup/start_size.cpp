#include "ui/startup/start_size.h"

#include <QScreen>

namespace cullscope::ui {

namespace {

// The frame is not known before the window is on the screen: assume that of the usual window managers.
constexpr QMargins kUsualFrame{4, 40, 4, 4};

}  // namespace

Start startOn(const QRect& available, const QMargins& frame, const QSize& wanted) {
    const QSize room = available.marginsRemoved(frame).size();
    const bool fits = wanted.width() <= room.width() && wanted.height() <= room.height();
    return {wanted.boundedTo(room), !fits};
}

void showFitting(QWidget& window, const QSize& wanted) {
    const Start start = startOn(window.screen()->availableGeometry(), kUsualFrame, wanted);
    window.resize(start.size);
    if (start.maximized)
        window.showMaximized();
    else
        window.show();
}

}  // namespace cullscope::ui
