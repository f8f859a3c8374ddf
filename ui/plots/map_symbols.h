#pragma once

#include <QColor>
#include <QPainter>
#include <QPalette>
#include <vector>

#include "core/frame/cell_map.h"

namespace cullscope::ui {

/// The colours of the overlays on a map, for a light or a dark background. The overlays differ in shape too.
struct MapColours {
    explicit MapColours(const QPalette& palette);

    QColor ground;
    QColor text;
    QColor faintText;
    QColor region;  ///< red, also for a horizon
    QColor walked;
    QColor circle;
    QColor picked;
    QColor cell;
    QColor veil;        ///< half transparent, over hidden cells
    double unit = 1.0;  ///< of widths and marks, in the painter's units: more where letters are large

    /// The colour `under` with the veil over it.
    [[nodiscard]] QColor veiled(const QColor& under) const;
};

/// The unit of signs among letters of a font: signs grow with letters that are larger than those of a lecture at 1280 × 720.
[[nodiscard]] double unitOfLetters(const QFontMetricsF& metrics);

/// Strokes a line that is visible on any cell: over a wider line in the background colour.
void strokeOver(QPainter& painter, const QPainterPath& path, const QPen& pen, const MapColours& colours);
/// The pen of a symbol that is a line.
[[nodiscard]] QPen linePen(MapSymbol symbol, const MapColours& colours);
void paintMarker(QPainter& painter, const QPointF& centre, MapSymbol symbol, const MapColours& colours);
/// Radius of a marker, in the painter's units.
inline constexpr double kMarkerReach = 7.0;
/// The rectangle of a label centred at a point, moved into the bounds.
[[nodiscard]] QRectF labelPlace(const QPointF& centre, const QString& words, const QRectF& bounds, const QFontMetricsF& metrics);
/// Paints text that is legible on any cell.
void paintLabel(QPainter& painter, const QRectF& place, const QString& words, const MapColours& colours);
/// Paints such text centred at a point, moved into the bounds.
void paintLabel(QPainter& painter, const QPointF& centre, const QString& words, const QRectF& bounds, const MapColours& colours);
/// Whether a map has something with this symbol.
[[nodiscard]] bool hasSymbol(const CellMap& map, MapSymbol symbol);
/// Paints the legend's sample of a symbol into a rectangle.
void paintSymbol(QPainter& painter, const QRectF& place, MapSymbol symbol, const MapColours& colours);

/// A legend of symbols with their texts, in rows of a given width; texts are never cut.
class MapLegend {
public:
    struct Entry {
        MapSymbol symbol;
        QString words;
        QColor colour;  ///< for MapSymbol::Cells
    };

    MapLegend(std::vector<Entry> entries, const QFontMetricsF& metrics) : m_entries(std::move(entries)), m_metrics(metrics) {}

    [[nodiscard]] double heightFor(double width) const;
    void paint(QPainter& painter, const QRectF& place, const MapColours& colours) const;

private:
    /// The positions of all entries, and that of a row after the last one.
    [[nodiscard]] std::vector<QPointF> places(double width) const;

    std::vector<Entry> m_entries;
    QFontMetricsF m_metrics;
};

}  // namespace cullscope::ui
