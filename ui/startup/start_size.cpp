#include "ui/startup/start_size.h"

#include <QScreen>
#include <algorithm>

#include "core/base/error.h"
#include "core/scene/camera.h"

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

void requireDrawable(const QWidget& window) {
    const double scale = window.devicePixelRatioF();
    const QSize least = window.minimumSizeHint().expandedTo(window.minimumSize());
    const double longest = scale * std::max(least.width(), least.height());
    if (longest <= kMostPixels) return;
    throwUsage("The window has %1 pixels on a side, more than %2: the screen's scale is %3. Set a smaller one (QT_SCALE_FACTOR).",
               {std::to_string(int64_t(longest)), std::to_string(kMostPixels), QString::number(scale).toStdString()});
}

}  // namespace cullscope::ui
