#include "ui/plots/map_symbols.h"

#include <QPainterPath>
#include <algorithm>

#include "ui/look/verdict_swatch.h"
#include "ui/plots/plot_colours.h"

namespace cullscope::ui {

namespace {

constexpr double kMarkerRadius = 5.0;
constexpr double kSymbol = 22.0;
constexpr double kMapSwatch = 12.0;
constexpr double kSymbolGap = 4.0;
constexpr double kApart = 12.0;
constexpr double kLineLeading = 2.0;

QPainterPath diamond(const QPointF& centre, double radius) {
    QPainterPath path;
    path.addPolygon(QPolygonF(
        {centre - QPointF(0, radius), centre + QPointF(radius, 0), centre + QPointF(0, radius), centre - QPointF(radius, 0)}));
    path.closeSubpath();
    return path;
}

QPainterPath disc(const QPointF& centre, double radius) {
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    return path;
}

}  // namespace

MapColours::MapColours(const QPalette& palette) {
    const PlotColours plot(palette);
    ground = plot.ground;
    text = plot.text;
    faintText = plot.faintText;
    region = plot.dark ? QColor(0xFF4A4A) : QColor(0xD00000);
    walked = plot.dark ? QColor(0x2BD4A4) : QColor(0x00805A);
    circle = plot.dark ? QColor(0xFF9A4D) : QColor(0xC44E00);
    picked = plot.dark ? QColor(0xFF6AD5) : QColor(0xC0008A);
    cell = plot.text;
    cell.setAlphaF(0.35F);
    veil = verdictColour(TriangleState::Hidden, palette);
    veil.setAlphaF(0.4F);
}

QColor MapColours::veiled(const QColor& under) const {
    const auto mixed = [share = veil.alphaF()](float over, float below) { return share * over + (1.0F - share) * below; };
    return QColor::fromRgbF(mixed(veil.redF(), under.redF()), mixed(veil.greenF(), under.greenF()),
                            mixed(veil.blueF(), under.blueF()));
}

double unitOfLetters(const QFontMetricsF& metrics) {
    constexpr double kLineOfLecture = 24.0;  // pixels: letters of 20
    return std::max(1.0, metrics.height() / kLineOfLecture);
}

void strokeOver(QPainter& painter, const QPainterPath& path, const QPen& pen, const MapColours& colours) {
    QColor under = colours.ground;
    under.setAlphaF(0.75);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(under, pen.widthF() + 2.0 * colours.unit, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(pen);
    painter.drawPath(path);
}

QPen linePen(MapSymbol symbol, const MapColours& colours) {
    const auto wide = [&](double width) { return width * colours.unit; };
    if (symbol == MapSymbol::Region) {
        QPen pen(colours.region, wide(2.0), Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
        pen.setDashPattern({3.0, 2.0});
        return pen;
    }
    if (symbol == MapSymbol::Box) return {colours.text, wide(1.2)};
    if (symbol == MapSymbol::Part) return {colours.text, wide(1.6), Qt::DashLine, Qt::FlatCap, Qt::RoundJoin};
    if (symbol == MapSymbol::Cell) return {colours.cell, wide(0.8)};
    if (symbol == MapSymbol::Horizon) return {colours.region, wide(2.0)};
    if (symbol == MapSymbol::RightAngle) return {colours.circle, wide(2.2)};
    return {symbol == MapSymbol::Picked ? colours.picked : colours.circle, wide(symbol == MapSymbol::Picked ? 2.0 : 1.2)};
}

void paintMarker(QPainter& painter, const QPointF& centre, MapSymbol symbol, const MapColours& colours) {
    const double radius = kMarkerRadius * colours.unit;
    if (symbol == MapSymbol::Miss) {
        painter.setPen(QPen(colours.region, 2.0 * colours.unit));
        painter.setBrush(colours.ground);
        return painter.drawPath(diamond(centre, radius + colours.unit));
    }
    const QColor colour = symbol == MapSymbol::Hit ? colours.region : colours.circle;
    painter.setPen(QPen(colours.ground, 1.5 * colours.unit));
    painter.setBrush(colour);
    painter.drawPath(disc(centre, radius));
    if (symbol != MapSymbol::End) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.ground);
    painter.drawPath(disc(centre, radius - 2.5 * colours.unit));
}

bool hasSymbol(const CellMap& map, MapSymbol symbol) {
    switch (symbol) {
        case MapSymbol::Region:
        case MapSymbol::Horizon:
            return std::ranges::any_of(map.curves,
                                       [=](const MapCurve& curve) { return curve.symbol == symbol && !curve.points.empty(); });
        case MapSymbol::Hit:
        case MapSymbol::Miss:
            return std::ranges::any_of(map.marks, [=](const MapMark& mark) { return mark.symbol == symbol; });
        case MapSymbol::Box:
            return !map.boxes.empty();
        case MapSymbol::Walked:
            return !map.walked.empty();
        case MapSymbol::Circle:
        case MapSymbol::RightAngle:
        case MapSymbol::Start:
        case MapSymbol::End:
            return map.circles.has_value();
        default:
            return true;
    }
}

QRectF labelPlace(const QPointF& centre, const QString& words, const QRectF& bounds, const QFontMetricsF& metrics) {
    QRectF place(0, 0, metrics.horizontalAdvance(words) + 4.0, metrics.ascent());
    place.moveCenter(centre);
    place.moveTop(std::clamp(place.top(), bounds.top(), bounds.bottom() - place.height()));
    place.moveLeft(std::clamp(place.left(), bounds.left(), bounds.right() - place.width()));
    return place;
}

void paintLabel(QPainter& painter, const QPointF& centre, const QString& words, const QRectF& bounds, const MapColours& colours) {
    paintLabel(painter, labelPlace(centre, words, bounds, QFontMetricsF(painter.font())), words, colours);
}

void paintLabel(QPainter& painter, const QRectF& place, const QString& words, const MapColours& colours) {
    QColor ground = colours.ground;
    ground.setAlphaF(0.85F);
    painter.fillRect(place, ground);
    painter.setPen(colours.text);
    painter.drawText(place, Qt::AlignCenter, words);
}

void paintSymbol(QPainter& painter, const QRectF& place, MapSymbol symbol, const MapColours& colours) {
    const QPointF centre = place.center();
    switch (symbol) {
        case MapSymbol::Hit:
        case MapSymbol::Miss:
        case MapSymbol::Start:
        case MapSymbol::End:
            return paintMarker(painter, centre, symbol, colours);
        case MapSymbol::Walked:
            return painter.fillRect(QRectF(centre - QPointF(6.0, 3.0) * colours.unit, QSizeF(12.0, 6.0) * colours.unit),
                                    colours.walked);
        default:
            break;
    }
    QPainterPath path;
    if (symbol == MapSymbol::Box || symbol == MapSymbol::Cell || symbol == MapSymbol::Picked) {
        path.addRect(QRectF(centre - QPointF(7.0, 4.0) * colours.unit, QSizeF(14.0, 8.0) * colours.unit));
    } else {
        path.moveTo(place.left(), centre.y());
        path.lineTo(place.right(), centre.y());
    }
    painter.setBrush(Qt::NoBrush);
    // In the legend, a line as thin and pale as on the map would hardly be visible.
    painter.setPen(symbol == MapSymbol::Cell ? QPen(colours.faintText, 1.2 * colours.unit) : linePen(symbol, colours));
    painter.drawPath(path);
}

std::vector<QPointF> MapLegend::places(double width) const {
    std::vector<QPointF> places;
    QPointF at(0.0, 0.0);
    for (const Entry& entry : m_entries) {
        const double needed = kSymbol + kSymbolGap + m_metrics.horizontalAdvance(entry.words);
        if (at.x() > 0.0 && at.x() + needed > width) at = {0.0, at.y() + m_metrics.height() + kLineLeading};
        places.push_back(at);
        at.rx() += needed + kApart;
    }
    places.push_back({0.0, at.y() + m_metrics.height() + kLineLeading});
    return places;
}

double MapLegend::heightFor(double width) const { return m_entries.empty() ? 0.0 : places(width).back().y(); }

void MapLegend::paint(QPainter& painter, const QRectF& place, const MapColours& colours) const {
    const std::vector<QPointF> offsets = places(place.width());
    for (size_t i = 0; i < m_entries.size(); ++i) {
        const QPointF at = place.topLeft() + offsets[i];
        const QRectF symbol(at, QSizeF(kSymbol, m_metrics.height()));
        if (m_entries[i].symbol == MapSymbol::Cells)
            painter.fillRect(QRectF(symbol.center() - QPointF(kMapSwatch, kMapSwatch) / 2, QSizeF(kMapSwatch, kMapSwatch)),
                             m_entries[i].colour);
        else
            paintSymbol(painter, symbol, m_entries[i].symbol, colours);
        painter.setPen(colours.text);
        painter.drawText(at + QPointF(kSymbol + kSymbolGap, m_metrics.ascent()), m_entries[i].words);
    }
}

}  // namespace cullscope::ui
