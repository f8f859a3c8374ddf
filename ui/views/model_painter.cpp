#include "ui/views/model_painter.h"

#include <QCoreApplication>

#include "core/gpu/colour.h"
#include "core/image/spherical_model.h"

namespace cullscope::ui {

namespace {

constexpr int kDegreeStep = 90;
constexpr double kTick = 6.0;  // units; the ticks are part of the picture
constexpr double kTickGap = 4.0;
constexpr double kRampWidth = 64.0;
constexpr double kLeastLetters = 7.0;  // units; smaller text cannot be read
constexpr double kLettersWide = 2.2;   // width of "180°" in multiples of the letter height
constexpr double kLinesHigh = 1.4;     // height of a line in multiples of the letter height

QString words(const char* text) { return QCoreApplication::translate("SphericalModel", text); }

QColor colourOf(const Vec3f& rgb, double alpha = 1.0) { return QColor::fromRgbF(rgb.x, rgb.y, rgb.z, float(alpha)); }

class ScalePainter {
public:
    ScalePainter(QPainter& painter, const QRectF& target, const ViewPicture& picture, double unit)
        : m_painter(painter), m_target(target), m_picture(picture), m_unit(unit) {
        const ViewRequest& request = picture.request;
        const MapArea area = sphericalModelArea(request.size, request.style);
        const double scale = target.width() / request.size.width;
        m_map = QRectF(target.left() + scale * area.left, target.bottom() - scale * (area.bottom + area.height),
                       scale * area.width, scale * area.height);
        m_below = m_map.bottom() + kTick * unit;
    }

    /// Paints the numbers at the ticks, as large as the margins allow; none if they could not be read.
    void paintDegrees() {
        const double tick = kTick * m_unit, gap = 0.5 * kTickGap * m_unit;
        if (setLetters((m_target.bottom() - m_map.bottom() - tick) / kLinesHigh)) {
            for (int phi = 0; phi <= 360; phi += kDegreeStep) writeBelow(phi, QStringLiteral("%1°").arg(phi));
            writeBelow(0.5 * kDegreeStep, QStringLiteral("φ"));
            m_below += metrics().height();
        }
        if (setLetters((m_map.left() - m_target.left() - tick - gap) / kLettersWide)) {
            for (int theta = 0; theta <= 180; theta += kDegreeStep) writeBeside(theta, QStringLiteral("%1°").arg(theta));
            writeBeside(0.5 * kDegreeStep, QStringLiteral("θ"));
        }
    }

    /// Paints the colour scale above the map at its right end, or over the map if there is no room above.
    void paintRamp() {
        const QString nearest = words(QT_TRANSLATE_NOOP("SphericalModel", "R: near"));
        const QString farthest = words(QT_TRANSLATE_NOOP("SphericalModel", "far"));
        setLetters(letterHeight());
        const double gap = kTickGap * m_unit, ramp = kRampWidth * m_unit, line = metrics().height();
        const double before = metrics().horizontalAdvance(nearest), after = metrics().horizontalAdvance(farthest);
        const double width = before + after + ramp + 2.0 * gap;
        const QRectF place(m_map.right() - width, std::max(m_target.top(), m_map.top() - line - gap), width, line);
        paintBackdrop(place);
        const QRectF bar(place.left() + before + gap, place.top() + 0.2 * line, ramp, 0.6 * line);
        QLinearGradient gradient(bar.topLeft(), bar.topRight());
        const std::array<Vec3f, 5> colours = reliefColours();
        for (size_t i = 0; i < colours.size(); ++i)
            gradient.setColorAt(double(i) / double(colours.size() - 1), colourOf(colours[i]));
        write(place, Qt::AlignLeft, nearest);
        m_painter.fillRect(bar, gradient);
        write(place, Qt::AlignRight, farthest);
    }

    /// Paints the note below the numbers, in smaller letters if needed; over the map if it does not fit at all.
    void paintHint() {
        if (!m_picture.partOfModel) return;
        const QString hint = words(QT_TRANSLATE_NOOP(
            "SphericalModel", "Only what the strategy submits is drawn: choose All triangles for the whole model."));
        const double gap = kTickGap * m_unit;
        const QRectF room(m_target.left() + gap, m_below, m_target.width() - 2.0 * gap, m_target.bottom() - m_below);
        double height = 0.0;
        for (double letters = letterHeight(); setLetters(letters); letters -= m_unit) {
            height = metrics().boundingRect(QRectF(0.0, 0.0, room.width(), 1e4), kHintFlags, hint).height();
            if (height <= room.height()) break;
        }
        const QRectF place(room.left(), std::min(m_below, m_target.bottom() - height), room.width(), height);
        if (height > room.height()) paintBackdrop(place);
        write(place, kHintFlags, hint);
    }

private:
    static constexpr int kHintFlags = int(Qt::AlignHCenter) | int(Qt::AlignTop) | int(Qt::TextWordWrap);

    [[nodiscard]] QFontMetricsF metrics() const { return QFontMetricsF(m_painter.font(), m_painter.device()); }
    /// The letter height of the window's or the screenshot's font, in the painter's units.
    [[nodiscard]] double letterHeight() const { return QFontInfo(m_font).pixelSize(); }

    /// Sets the letter height, but at most that of the font. Returns false and sets nothing if the text could not be read.
    bool setLetters(double height) {
        if (height < kLeastLetters * m_unit) return false;
        QFont font = m_font;
        font.setPixelSize(int(std::min(height, letterHeight())));
        m_painter.setFont(font);
        return true;
    }

    void write(const QRectF& place, int flags, const QString& text) {
        m_painter.setPen(colourOf(contrastTo(m_picture.request.style.background)));
        m_painter.drawText(place, flags, text);
    }

    void writeBelow(double phi, const QString& text) {
        const double x = m_map.left() + phi / 360.0 * m_map.width(), aside = 40.0 * m_unit;
        write(QRectF(x - aside, m_map.bottom() + kTick * m_unit, 2.0 * aside, metrics().height()), Qt::AlignHCenter, text);
    }

    void writeBeside(double theta, const QString& text) {
        const double y = m_map.top() + theta / 180.0 * m_map.height(), line = metrics().height();
        const double right = m_map.left() - (kTick + 0.5 * kTickGap) * m_unit, width = 80.0 * m_unit;
        write(QRectF(right - width, y - 0.5 * line, width, line), Qt::AlignRight, text);
    }

    void paintBackdrop(const QRectF& place) { m_painter.fillRect(place, colourOf(m_picture.request.style.background, 0.8)); }

    QPainter& m_painter;
    QRectF m_target, m_map;
    const ViewPicture& m_picture;
    double m_unit;
    QFont m_font = m_painter.font();
    double m_below = 0.0;  ///< upper end of the free area below the map
};

}  // namespace

void paintModelScales(QPainter& painter, const QRectF& target, const ViewPicture& picture, double unit) {
    painter.save();
    ScalePainter scales(painter, target, picture, unit);
    scales.paintDegrees();
    scales.paintRamp();
    scales.paintHint();
    painter.restore();
}

}  // namespace cullscope::ui
