#pragma once

#include <QColor>
#include <QPainter>
#include <QPalette>
#include <vector>

namespace cullscope::ui {

/// The colours of what lies over a map's cells, for a light or a dark ground. Each differs from the others by its shape too.
struct MapColours {
    explicit MapColours(const QPalette& palette);

    QColor ground;
    QColor text;
    QColor faintText;
    QColor region;  ///< the visible region's red, and the horizon's
    QColor walked;
    QColor contour;
    QColor picked;
    QColor quadtree;
    QColor veil;  ///< over cells that are hidden, half transparent

    /// As it looks over a colour.
    [[nodiscard]] QColor veiled(const QColor& under) const;
};

/// What is drawn over a map, in its legend as on it.
enum class MapSymbol {
    Region,
    Box,
    CornerHit,
    CornerMiss,
    Walked,
    Contour,
    RightAngle,
    Sector,
    Start,
    End,
    JudgedCell,
    Horizon,
    Picked,
    Cells
};

/// A line that is seen on every cell: in its colour on a wider one of the ground's.
void strokeOver(QPainter& painter, const QPainterPath& path, const QPen& pen, const QColor& ground);
/// The pen of a symbol that is a line.
[[nodiscard]] QPen linePen(MapSymbol symbol, const MapColours& colours);
void paintMarker(QPainter& painter, const QPointF& centre, MapSymbol symbol, const MapColours& colours);
/// How far a marker reaches from its middle.
inline constexpr double kMarkerReach = 7.0;
/// Where words around a place stand, moved into the bounds.
[[nodiscard]] QRectF labelPlace(const QPointF& centre, const QString& words, const QRectF& bounds, const QFontMetricsF& metrics);
/// Words that are read on every cell.
void paintLabel(QPainter& painter, const QRectF& place, const QString& words, const MapColours& colours);
/// The same around a place, moved into the bounds.
void paintLabel(QPainter& painter, const QPointF& centre, const QString& words, const QRectF& bounds, const MapColours& colours);
/// A symbol as a legend has it, within a place.
void paintSymbol(QPainter& painter, const QRectF& place, MapSymbol symbol, const MapColours& colours);

/// What words stand beside which symbol, in rows of a width; no words are cut.
class MapLegend {
public:
    struct Entry {
        MapSymbol symbol;
        QString words;
        QColor colour;  ///< of Cells
    };

    MapLegend(std::vector<Entry> entries, const QFontMetricsF& metrics) : m_entries(std::move(entries)), m_metrics(metrics) {}

    [[nodiscard]] double heightFor(double width) const;
    void paint(QPainter& painter, const QRectF& place, const MapColours& colours) const;

private:
    /// Where the entries begin, and where one more row would.
    [[nodiscard]] std::vector<QPointF> places(double width) const;

    std::vector<Entry> m_entries;
    QFontMetricsF m_metrics;
};

}  // namespace cullscope::ui
