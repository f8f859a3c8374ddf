#include "ui/window/pointer_spot.h"

#include <QApplication>
#include <QCursor>
#include <QMouseEvent>
#include <QPainter>

namespace cullscope::ui {

namespace {

constexpr double kRadiusOfHeight = 1.0 / 24.0;  // of the window's height
constexpr QColor kSpotDisc(255, 214, 0, 110);
constexpr QColor kSpotRing(20, 20, 20, 200);

}  // namespace

PointerSpot::PointerSpot(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void PointerSpot::setOn(bool on) {
    if (on == m_on) return;
    m_on = on;
    // All widgets of the window: the pointer's moves go to the one that lies under it.
    if (on)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
    setVisible(on);
    if (!on) return;
    moveTo(parentWidget()->mapFromGlobal(QCursor::pos()));
    raise();
}

void PointerSpot::moveTo(const QPoint& place) {
    m_place = place;
    const int radius = int(parentWidget()->height() * kRadiusOfHeight) + 2;
    setGeometry(QRect(place - QPoint(radius, radius), QSize(2 * radius, 2 * radius)));
}

bool PointerSpot::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseMove && watched->isWidgetType() &&
        static_cast<QWidget*>(watched)->window() == parentWidget()->window())
        moveTo(parentWidget()->mapFromGlobal(static_cast<QMouseEvent*>(event)->globalPosition().toPoint()));
    return QWidget::eventFilter(watched, event);
}

void PointerSpot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(kSpotDisc);
    painter.setPen(QPen(kSpotRing, 2.0));
    painter.drawEllipse(QRectF(rect()).adjusted(2, 2, -2, -2));
}

}  // namespace cullscope::ui
