#pragma once

#include "core/image/letters.h"
#include "core/image/picture_file.h"
#include "core/image/plot_drawing.h"

namespace cullscope {

/// A picture on a page.
struct PagePicture {
    PlotPoint corner;  ///< its upper left one, pixels
    Viewport size;
    std::vector<uint8_t> rgba;  ///< rows from the bottom
};

/// Pictures with what is drawn and written over them, as plain data: a figure of a paper. In pixels from the upper left corner.
struct Page {
    double width = 0.0, height = 0.0;
    PlotColour ground = 0xFFFFFFFF;
    std::vector<PagePicture> pictures;
    PlotDrawing drawing;

    void text(const PlotPoint& at, const std::string& words, PlotColour colour, TextAnchor anchor = TextAnchor::Start,
              bool bold = false) {
        drawing.items.emplace_back(DrawnText{at, words, colour, anchor, bold});
    }
};

/// The colours of a page and its letters: those of the installed fonts.
[[nodiscard]] PlotStyle pageStyle(const Letters& letters);

/// The plots below each other, as linePlotsSvg has them.
[[nodiscard]] Page linePlotsPage(const std::vector<LinePlot>& plots, const PlotStyle& style);

/// A page as an SVG document with the pictures in it; text stays text, in a font that its viewer chooses.
[[nodiscard]] std::string pageSvg(const Page& page);
/// A page as a picture. `letters`: those that the page was laid out with.
[[nodiscard]] Picture pagePicture(const Page& page, const Letters& letters);

}  // namespace cullscope
