#include "ui/look/wheel_guard.h"

#include <QEvent>

namespace cullscope::ui {

namespace {

class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

}  // namespace

void leaveWheelUnlessFocused(QWidget& field) {
    // StrongFocus excludes focus by the wheel.
    field.setFocusPolicy(Qt::StrongFocus);
    field.installEventFilter(new WheelGuard(&field));
}

}  // namespace cullscope::ui
