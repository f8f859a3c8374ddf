#include "ui/views/picture_painter.h"

#include <QPainterPath>
#include <cmath>

#include "ui/views/model_painter.h"

namespace cullscope::ui {

namespace {

constexpr double kLoupeZoom = 8.0;
constexpr double kLoupeRadius = 72.0;
constexpr double kPale = 0.65;        // opacity of the background colour over the picture under marks
constexpr double kAboutWhole = 1e-3;  // of a scale: so near to a whole number it is one
constexpr int kMostEnlargement = 8;   // beyond it, differences of a pixel's sides are small
constexpr QColor kWipeLine(255, 255, 255);
constexpr QColor kLineEdge(0, 0, 0);

QColor colour(const Vec3f& rgb) { return QColor::fromRgbF(rgb.x, rgb.y, rgb.z); }

bool isPale(Wipe::Mode mode) { return mode == Wipe::Mode::Loss || mode == Wipe::Mode::Difference; }

/// Paints the picture and the one that it is compared with, without text.
void paintLayers(QPainter& painter, const QRectF& target, const ViewPicture& picture, const Wipe& wipe) {
    paintScaled(painter, target, picture.colour);
    if (picture.other.isNull()) return;
    if (isPale(wipe.mode)) {
        QColor veil = colour(picture.request.style.background);
        veil.setAlphaF(kPale);
        painter.save();
        // A transparent background stays transparent.
        if (picture.request.style.backgroundAlpha < 1.0f) painter.setCompositionMode(QPainter::CompositionMode_SourceAtop);
        painter.fillRect(target, veil);
        painter.restore();
        paintScaled(painter, target, picture.marks);
        return;
    }
    painter.save();
    QRectF left = target;
    left.setWidth(target.width() * wipe.position);
    painter.setClipRect(left, Qt::IntersectClip);
    paintScaled(painter, target, picture.other);
    painter.restore();
}

/// Strokes a light line over a wider dark one, which is visible on any picture.
void strokeTwice(QPainter& painter, const QPainterPath& path, double unit) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kLineEdge, 4.0 * unit));
    painter.drawPath(path);
    painter.setPen(QPen(kWipeLine, 2.0 * unit));
    painter.drawPath(path);
}

void label(QPainter& painter, const QRectF& place, Qt::Alignment side, const QString& text, double unit) {
    if (text.isEmpty()) return;
    const QFontMetricsF metrics(painter.font(), painter.device());
    const double inset = 4.0 * unit;
    const QString shown = metrics.elidedText(text, Qt::ElideRight, place.width() - 4.0 * inset);
    if (shown.size() < 2) return;
    QRectF box(0.0, place.bottom() - metrics.height() - 3.0 * inset, metrics.horizontalAdvance(shown) + 2.0 * inset,
               metrics.height() + inset);
    box.moveLeft(side == Qt::AlignLeft ? place.left() + inset : place.right() - box.width() - inset);
    painter.fillRect(box, QColor(0, 0, 0, 190));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, shown);
}

void paintWipeLine(QPainter& painter, const QRectF& target, const PictureExtras& extras) {
    const double x = target.left() + target.width() * extras.wipe.position;
    QPainterPath line;
    line.moveTo(x, target.top());
    line.lineTo(x, target.bottom());
    strokeTwice(painter, line, extras.unit);
    label(painter, QRectF(target.left(), target.top(), x - target.left(), target.height()), Qt::AlignRight, extras.left,
          extras.unit);
    label(painter, QRectF(x, target.top(), target.right() - x, target.height()), Qt::AlignLeft, extras.right, extras.unit);
}

}  // namespace

void paintScaled(QPainter& painter, const QRectF& target, const QImage& image) {
    const QTransform toDevice = painter.deviceTransform();
    const double scale = target.width() * toDevice.m11() / image.width();
    const int whole = int(std::ceil(scale - kAboutWhole));
    const bool fraction = scale > 1.0 + kAboutWhole && std::abs(scale - std::round(scale)) * image.width() > 0.5;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, fraction || scale < 1.0 - kAboutWhole);
    // With the nearest pixel it would have uneven sides, with a mean of four it would be blurred: it is enlarged by the next
    // whole number first, and then reduced.
    if (!fraction || whole > kMostEnlargement) return painter.drawImage(target, image);
    // Only the part that is painted: a loupe shows little of the picture.
    const QRectF seen = painter.hasClipping() ? target & painter.clipBoundingRect() : target;
    const QTransform toImage = QTransform::fromTranslate(-target.left(), -target.top()) *
                               QTransform::fromScale(image.width() / target.width(), image.height() / target.height());
    const QRect part = toImage.mapRect(seen).toAlignedRect() & image.rect();
    if (part.isEmpty()) return;
    const QImage enlarged = image.copy(part).scaled(part.size() * whole);
    painter.drawImage(toImage.inverted().mapRect(QRectF(part)), enlarged);
}

/// Light letters with a dark edge on what they name, or above it where it is smaller than they are.
void paintNames(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras) {
    const double perPixel = target.width() / picture.request.size.width;
    QFont font = painter.font();
    font.setBold(true);
    const QFontMetricsF metrics(font, painter.device());
    painter.save();
    painter.setClipRect(target, Qt::IntersectClip);
    for (const PlacedName& name : extras.names) {
        const double wide = metrics.horizontalAdvance(name.text);
        const QSizeF seen = name.extent.size() * perPixel;
        const bool above = seen.width() < wide || seen.height() < metrics.capHeight();
        QPointF base = target.topLeft() + name.place * perPixel + QPointF(0.0, metrics.capHeight() / 2.0);
        if (above)
            base = target.topLeft() + QPointF(name.place.x(), name.extent.top()) * perPixel - QPointF(0.0, 4.0 * extras.unit);
        QPainterPath letters;
        letters.addText(base - QPointF(wide / 2.0, 0.0), font, name.text);
        painter.strokePath(letters, QPen(kLineEdge, 3.0 * extras.unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.fillPath(letters, kWipeLine);
    }
    painter.restore();
}

void paintLoupe(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras) {
    const double perPixel = target.width() / picture.request.size.width;
    const QPointF middle = target.topLeft() + *extras.loupe * perPixel;
    const double radius = std::min(kLoupeRadius * extras.unit, 0.3 * std::min(target.width(), target.height()));
    // The loupe lies beside the pixels that it enlarges, within the picture.
    QPointF centre = middle + QPointF(radius, -radius) * 1.2;
    if (centre.x() + radius > target.right()) centre.setX(middle.x() - 1.2 * radius);
    if (centre.y() - radius < target.top()) centre.setY(middle.y() + 1.2 * radius);
    QPainterPath lens;
    lens.addEllipse(centre, radius, radius);
    painter.save();
    painter.setClipPath(lens);
    const double zoomed = kLoupeZoom * extras.unit;
    const QRectF enlarged(centre - *extras.loupe * zoomed,
                          QSizeF(picture.request.size.width * zoomed, picture.request.size.height * zoomed));
    painter.fillRect(lens.boundingRect(), colour(picture.request.style.background));
    paintLayers(painter, enlarged, picture, extras.wipe);
    painter.restore();
    strokeTwice(painter, lens, extras.unit);
}

void paintPicture(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras) {
    painter.save();
    paintLayers(painter, target, picture, extras.wipe);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!picture.other.isNull() && !isPale(extras.wipe.mode)) paintWipeLine(painter, target, extras);
    paintNames(painter, target, picture, extras);
    if (extras.markedLoss) {
        const double perPixel = target.width() / picture.request.size.width;
        const QPointF middle = target.topLeft() + extras.markedLoss->center() * perPixel;
        const double radius = std::max(14.0 * extras.unit, 0.7 * extras.markedLoss->width() * perPixel);
        QPainterPath ring;
        ring.addEllipse(middle, radius, radius);
        strokeTwice(painter, ring, extras.unit);
    }
    if (extras.modelScales && picture.request.look.inPlace()) paintModelScales(painter, target, picture, extras.unit);
    if (extras.loupe) paintLoupe(painter, target, picture, extras);
    painter.restore();
}

}  // namespace cullscope::ui
