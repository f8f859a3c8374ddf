#include "ui/look/plane_swatch.h"

#include <QGuiApplication>

#include "core/visibility/plane_colours.h"
#include "ui/look/painted_icon.h"

namespace cullscope::ui {

namespace {

constexpr int kPlaneSwatchSize = 14;
constexpr double kFrame = 3.5;  // pixels

/// Draws a frame, because pictures show the plane's colour on box edges only.
void drawSwatch(QPainter& painter, const QRectF& place, FrustumPlane plane, const QPalette& palette) {
    const double half = 0.5 * kFrame;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(planeColour(plane, palette), kFrame, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(place.adjusted(half, half, -half, -half));
}

}  // namespace

QColor planeColour(FrustumPlane plane, const QPalette& palette) {
    const QColor base = palette.color(QPalette::Base);
    const Vec3f colour = planePalette(Vec3f(base.redF(), base.greenF(), base.blueF()))[size_t(plane)];
    return QColor::fromRgbF(colour.x, colour.y, colour.z);
}

QIcon planeIcon(FrustumPlane plane) {
    return paintedIcon(
        [plane](QPainter& painter, const QRectF& place) { drawSwatch(painter, place, plane, QGuiApplication::palette()); }, 1);
}

PlaneSwatch::PlaneSwatch(FrustumPlane plane, QWidget* parent) : QWidget(parent), m_plane(plane) {
    setFixedSize(kPlaneSwatchSize, kPlaneSwatchSize);
}

void PlaneSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawSwatch(painter, QRectF(rect()).adjusted(1, 1, -1, -1), m_plane, palette());
}

}  // namespace cullscope::ui
