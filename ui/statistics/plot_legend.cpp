#include "ui/statistics/plot_legend.h"

#include <algorithm>

namespace cullscope::ui {

namespace {

constexpr double kSymbol = 22.0;
constexpr double kMarker = 10.0;
constexpr double kGap = 14.0;
constexpr double kLeading = 3.0;
constexpr double kBesideFrom = 560.0;  // width of the whole plot
constexpr double kMostBeside = 0.35;   // of that width

}  // namespace

double PlotLegend::entryWidth(const Entry& entry) const {
    return kSymbol + 5.0 + m_metrics.horizontalAdvance(entry.label) + kGap;
}

double PlotLegend::widest() const {
    double widest = 0.0;
    for (const Entry& entry : m_entries) widest = std::max(widest, entryWidth(entry));
    return widest;
}

std::vector<QPointF> PlotLegend::places(double width) const {
    std::vector<QPointF> places;
    QPointF at(0.0, 0.0);
    for (const Entry& entry : m_entries) {
        const double needed = entryWidth(entry);
        if (at.x() > 0.0 && at.x() + needed > width) at = {0.0, at.y() + m_metrics.height() + kLeading};
        places.push_back(at);
        at.rx() += needed;
    }
    return places;
}

bool PlotLegend::fitsBeside(double width) const { return width >= kBesideFrom && widest() <= kMostBeside * width; }

double PlotLegend::heightIn(double width) const {
    return m_entries.empty() ? 0.0 : places(width).back().y() + m_metrics.height() + kLeading;
}

double PlotLegend::heightWith(double chart, double width) const {
    return fitsBeside(width) ? std::max(chart, kGap / 2 + heightIn(0.0)) : chart + heightIn(width);
}

QRectF PlotLegend::takeFrom(const QRectF& place) {
    m_beside = fitsBeside(place.width());
    const double below = m_beside ? 0.0 : heightIn(place.width());
    m_place = m_beside ? QRectF(place.right() - widest(), place.top() + kGap / 2, widest(), place.height())
                       : QRectF(place.left(), place.bottom() - below, place.width(), below);
    return m_beside ? place.adjusted(0.0, 0.0, -widest(), 0.0) : place.adjusted(0.0, 0.0, 0.0, -below);
}

void PlotLegend::paint(QPainter& painter, const PlotColours& colours) const {
    const std::vector<QPointF> offsets = places(m_beside ? 0.0 : m_place.width());
    const double height = m_metrics.height();
    for (size_t i = 0; i < m_entries.size(); ++i) {
        const Entry& entry = m_entries[i];
        const QPointF at = m_place.topLeft() + offsets[i];
        const double middle = at.y() + height / 2;
        if (entry.marker) {
            const QRectF marker(at.x() + (kSymbol - kMarker) / 2, middle - kMarker / 2, kMarker, kMarker);
            drawPlotMarker(painter, marker, *entry.marker);
        } else {
            painter.setPen(QPen(entry.colour, 2.0, entry.line));
            painter.drawLine(QPointF(at.x(), middle), QPointF(at.x() + kSymbol, middle));
        }
        painter.setPen(colours.text);
        painter.drawText(QPointF(at.x() + kSymbol + 5.0, at.y() + m_metrics.ascent()), entry.label);
    }
}

}  // namespace cullscope::ui
