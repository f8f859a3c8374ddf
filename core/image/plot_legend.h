#pragma once

#include "core/image/plot_drawing.h"

namespace cullscope {

/// How a plot's `number`-th line is drawn, in the plot and in its legend.
[[nodiscard]] PlotPen penOf(const PlotLine& line, size_t number, const PlotStyle& style);
[[nodiscard]] PlotPen referencePen(const PlotStyle& style);
/// A mark's shape around a point.
void drawShape(PlotDrawing& drawing, const PlotMark& mark, const PlotPoint& centre);

/// Which line, area or mark is what: beside a wide plot, below a narrow one. No name is ever cut.
class PlotLegend {
public:
    PlotLegend(const LinePlot& plot, const PlotStyle& style);

    /// Takes its part of a place and gives what is left for the plot.
    [[nodiscard]] PlotBox takeFrom(const PlotBox& place);
    /// The height that plots and their legend need in a width, where the plots alone need `plots`, all in pixels.
    [[nodiscard]] double heightWith(double plots, double width) const;
    /// What is left of a width for the plots.
    [[nodiscard]] double widthBeside(double width) const { return fitsBeside(width) ? width - m_widest : width; }
    /// Beside plots not farther right than where they end.
    void draw(PlotDrawing& drawing, double end) const;

private:
    struct Entry {
        std::string name;
        PlotPen line;
        PlotColour area = 0;
        PlotMark mark;
    };
    void add(Entry entry);
    [[nodiscard]] double widthOf(const Entry& entry) const;
    [[nodiscard]] bool fitsBeside(double width) const;
    /// How high its entries are, row by row, in a width.
    [[nodiscard]] double heightIn(double width) const;
    /// Where the entries begin, row by row, in a width.
    [[nodiscard]] std::vector<PlotPoint> offsets(double width) const;

    const PlotStyle& m_style;
    std::vector<Entry> m_entries;
    double m_widest = 0.0;
    PlotBox m_place;
    bool m_beside = false;
};

}  // namespace cullscope
