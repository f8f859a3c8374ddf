#include "core/image/plot_legend.h"

#include <algorithm>

namespace cullscope {
namespace {

constexpr double kSymbol = 22.0;
constexpr double kArea = 10.0;  // height
constexpr double kWordGap = 5.0;
constexpr double kLegendGap = 14.0;
constexpr double kLeading = 4.0;
constexpr double kLegendBesideFrom = 560.0;  // width of the whole plot
constexpr double kMostBeside = 0.35;         // of that width

}  // namespace

PlotPen penOf(const PlotLine& line, size_t number, const PlotStyle& style) {
    if (line.pen) return *line.pen;
    const PlotColour colour = style.series[line.colour.value_or(number) % style.series.size()];
    return {line.baseline ? style.faint : colour, 2.0, line.dashed ? PlotStroke::Dashed : PlotStroke::Solid};
}

PlotPen referencePen(const PlotStyle& style) { return {style.faint, 1.4, PlotStroke::Dotted}; }

void drawShape(PlotDrawing& drawing, const PlotMark& mark, const PlotPoint& centre) {
    const double r = mark.size / 2;
    const auto polygon = [&](std::vector<PlotPoint> corners) {
        for (PlotPoint& corner : corners) corner = {centre.x + corner.x, centre.y + corner.y};
        corners.push_back(corners.front());
        drawing.items.push_back(DrawnPath{std::move(corners), mark.outline, mark.fill});
    };
    if (mark.shape == PlotShape::Disc) drawing.items.push_back(DrawnDisc{centre, r, mark.outline, mark.fill});
    if (mark.shape == PlotShape::Square)
        polygon({{0.5 - r, 0.5 - r}, {r - 0.5, 0.5 - r}, {r - 0.5, r - 0.5}, {0.5 - r, r - 0.5}});
    if (mark.shape == PlotShape::Triangle) polygon({{0.0, -r}, {r, r}, {-r, r}});
}

PlotLegend::PlotLegend(const LinePlot& plot, const PlotStyle& style) : m_style(style) {
    for (const PlotBars& bars : plot.bars) add({bars.name, {}, bars.colour, {}});
    for (size_t i = 0; i < plot.lines.size(); ++i) add({plot.lines[i].name, penOf(plot.lines[i], i, style), 0, {}});
    const PlotRange y = rangeAlongY(plot);
    for (const PlotReference& reference : plot.references)
        if (y.places(reference.y)) add({reference.name + ' ' + style.number(reference.y), referencePen(style), 0, {}});
    for (const PlotMark& mark : plot.marks) add({mark.name, {}, 0, mark});
}

void PlotLegend::add(Entry entry) {
    if (entry.name.empty()) return;
    m_widest = std::max(m_widest, widthOf(entry));
    m_entries.push_back(std::move(entry));
}

double PlotLegend::widthOf(const Entry& entry) const { return kSymbol + kWordGap + m_style.width(entry.name) + kLegendGap; }

std::vector<PlotPoint> PlotLegend::offsets(double width) const {
    std::vector<PlotPoint> offsets;
    PlotPoint at;
    for (const Entry& entry : m_entries) {
        const double needed = widthOf(entry);
        if (at.x > 0.0 && at.x + needed > width) at = {0.0, at.y + m_style.height + kLeading};
        offsets.push_back(at);
        at.x += needed;
    }
    return offsets;
}

bool PlotLegend::fitsBeside(double width) const { return width >= kLegendBesideFrom && m_widest <= kMostBeside * width; }

double PlotLegend::heightIn(double width) const {
    return m_entries.empty() ? 0.0 : kLeading + offsets(width).back().y + m_style.height + kLeading;
}

double PlotLegend::heightWith(double plots, double width) const {
    return fitsBeside(width) ? std::max(plots, kLegendGap / 2 + heightIn(0.0)) : plots + heightIn(width);
}

PlotBox PlotLegend::takeFrom(const PlotBox& place) {
    const double width = place.right - place.left;
    PlotBox rest = place;
    m_place = place;
    m_beside = fitsBeside(width);
    if (m_beside) {
        rest.right = place.right - m_widest;
        m_place.left = rest.right + kLegendGap;
        m_place.top += kLegendGap / 2;
    } else {
        rest.bottom = place.bottom - heightIn(width);
        m_place.top = rest.bottom + kLeading;
    }
    return rest;
}

void PlotLegend::draw(PlotDrawing& drawing, double end) const {
    const std::vector<PlotPoint> offsets = this->offsets(m_beside ? 0.0 : m_place.right - m_place.left);
    const double left = m_beside ? std::min(m_place.left, end + kLegendGap) : m_place.left;
    for (size_t i = 0; i < m_entries.size(); ++i) {
        const Entry& entry = m_entries[i];
        const PlotPoint at{left + offsets[i].x, m_place.top + offsets[i].y};
        const double middle = at.y + m_style.height / 2, right = at.x + kSymbol, half = kArea / 2;
        drawShape(drawing, entry.mark, {at.x + kSymbol / 2, middle});
        if (entry.line.colour != 0) drawing.items.push_back(DrawnPath{{{at.x, middle}, {right, middle}}, entry.line});
        if (entry.area != 0)
            drawing.items.push_back(DrawnPath{
                {{at.x, middle - half}, {right, middle - half}, {right, middle + half}, {at.x, middle + half}}, {}, entry.area});
        drawing.items.push_back(DrawnText{{right + kWordGap, at.y + m_style.ascent}, entry.name, m_style.text});
    }
}

}  // namespace cullscope
