#pragma once

#include <functional>

#include "core/frame/words.h"
#include "core/image/page.h"

namespace cullscope {

/// How a page is laid out and what language it speaks.
struct PageLook {
    PlotStyle style;
    std::function<std::string(const Words& words)> say = [](const Words& words) { return words.english(); };
};

/// What a sign in a legend looks like.
struct PageSign {
    enum class Shape { Area, Frame, Region, Line, Dashed, Dot, Ring, Cross, Letter };
    Shape shape = Shape::Area;
    PlotColour colour = 0;
    double width = 1.5;   ///< of lines, pixels
    PlotColour edge = 0;  ///< of an area; 0: none
};
struct PageLegendEntry {
    PageSign sign;
    std::string words;
};

/// 0xFFRRGGBB.
[[nodiscard]] PlotColour plotColour(const Vec3f& colour);

/// Writes a legend, its entries beside each other in as many rows as a width needs; returns where it ends, pixels from the top.
double addLegend(Page& page, const std::vector<PageLegendEntry>& entries, const PlotPoint& corner, double width,
                 const PlotStyle& style);

/// A scale of colours with the values at both of its ends.
struct PageScale {
    std::string least, most;
    std::string words;                          ///< behind it; may be empty
    std::function<Vec3f(double share)> colour;  ///< share: 0 at the least to 1 at the most
};

/// Writes a scale; returns where it ends, pixels from the top.
double addScale(Page& page, const PageScale& scale, const PlotPoint& corner, const PlotStyle& style);

/// Writes a text in as many lines as a width needs; returns where it ends, pixels from the top.
double addText(Page& page, const std::string& words, const PlotPoint& corner, double width, const PlotStyle& style,
               PlotColour colour, bool bold = false);

}  // namespace cullscope
