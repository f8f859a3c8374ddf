#pragma once

#include <QFontMetricsF>
#include <QPainter>
#include <optional>
#include <vector>

#include "ui/statistics/plot_colours.h"
#include "ui/statistics/plot_marker.h"

namespace cullscope::ui {

/// Which line or marker is which strategy: beside a wide plot, below a narrow one. No label is ever cut.
class PlotLegend {
public:
    struct Entry {
        QString label;
        QColor colour;
        Qt::PenStyle line = Qt::SolidLine;
        std::optional<PlotMarker> marker;  ///< in place of a line
    };

    PlotLegend(std::vector<Entry> entries, const QFontMetricsF& metrics) : m_entries(std::move(entries)), m_metrics(metrics) {}

    /// Takes its part of a place and gives what is left for the plot.
    [[nodiscard]] QRectF takeFrom(const QRectF& place);
    /// The height that a chart and its legend need in a width, where the chart alone needs `chart`, all in pixels.
    [[nodiscard]] double heightWith(double chart, double width) const;
    void paint(QPainter& painter, const PlotColours& colours) const;

private:
    [[nodiscard]] double entryWidth(const Entry& entry) const;
    [[nodiscard]] double widest() const;
    [[nodiscard]] bool fitsBeside(double width) const;
    /// How high its entries are, row by row, in a width.
    [[nodiscard]] double heightIn(double width) const;
    /// Where the entries begin, row by row, in a width.
    [[nodiscard]] std::vector<QPointF> places(double width) const;

    std::vector<Entry> m_entries;
    QFontMetricsF m_metrics;
    QRectF m_place;
    bool m_beside = false;
};

}  // namespace cullscope::ui
