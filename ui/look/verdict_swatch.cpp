#include "ui/look/verdict_swatch.h"

#include <QGuiApplication>

#include "core/image/view_picture.h"
#include "ui/look/painted_icon.h"

namespace cullscope::ui {

namespace {

constexpr int kSwatchSize = 14;

PaletteEntry entryOf(TriangleState state, const QPalette& palette) {
    const QColor base = palette.color(QPalette::Base);
    return verdictPalette(Vec3f(base.redF(), base.greenF(), base.blueF()))[size_t(state)];
}

QColor colourOf(const PaletteEntry& entry) { return QColor::fromRgbF(entry.colour.x, entry.colour.y, entry.colour.z); }

/// Draws the edges of two triangles.
void drawWireframe(QPainter& painter, const QRectF& place, const QColor& colour) {
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place);
    painter.drawLine(place.bottomLeft(), place.topRight());
}

void drawHatched(QPainter& painter, const QRectF& place, const QColor& colour, const QColor& between) {
    painter.setPen(Qt::NoPen);
    painter.fillRect(place, colour);
    painter.setClipRect(place);
    painter.setPen(QPen(between, 1.2));
    for (double x = place.left() - place.height() + 3.0; x < place.right(); x += 6.0)
        painter.drawLine(QPointF(x, place.top()), QPointF(x + place.height(), place.bottom()));
}

}  // namespace

QColor verdictColour(TriangleState state, const QPalette& palette) { return colourOf(entryOf(state, palette)); }

void drawVerdictSwatch(QPainter& painter, const QRectF& place, TriangleState state, const QPalette& palette) {
    const PaletteEntry entry = entryOf(state, palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (entry.look == PaletteEntry::Look::Wireframe)
        drawWireframe(painter, place.adjusted(0.5, 0.5, -0.5, -0.5), colourOf(entry));
    else if (entry.look == PaletteEntry::Look::Marked)
        drawHatched(painter, place, colourOf(entry), Qt::black);
    else
        painter.fillRect(place, colourOf(entry));
    painter.restore();
}

QIcon verdictIcon(TriangleState state) {
    return paintedIcon(
        [state](QPainter& painter, const QRectF& place) { drawVerdictSwatch(painter, place, state, QGuiApplication::palette()); },
        2);
}

QIcon verdictIcon(TriangleState left, TriangleState right) {
    return paintedIcon(
        [left, right](QPainter& painter, const QRectF& place) {
            const QPalette palette = QGuiApplication::palette();
            const QPointF middle(place.width() / 2.0, place.height());
            drawVerdictSwatch(painter, QRectF(place.topLeft(), place.topLeft() + middle), left, palette);
            drawVerdictSwatch(painter, QRectF(place.topRight() - QPointF(middle.x(), 0.0), place.bottomRight()), right, palette);
        },
        2);
}

VerdictSwatch::VerdictSwatch(TriangleState state, QWidget* parent) : QWidget(parent), m_state(state) {
    setFixedSize(kSwatchSize, kSwatchSize);
}

void VerdictSwatch::setState(TriangleState state) {
    m_state = state;
    update();
}

void VerdictSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawVerdictSwatch(painter, QRectF(rect()).adjusted(1, 1, -1, -1), m_state, palette());
}

}  // namespace cullscope::ui
