#pragma once

#include <cmath>

#include "core/image/letters.h"
#include "core/image/picture_file.h"
#include "core/image/plot_drawing.h"

namespace cullscope {

/// A picture on a page.
struct PagePicture {
    PlotPoint corner;           ///< its upper left one, units of the page
    Viewport size;              ///< units of the page
    std::vector<uint8_t> rgba;  ///< rows from the bottom; as many pixels as `pixelsOf` has
};

/// Pictures with what is drawn and written over them, as plain data: a figure of a paper. It is laid out in units from the upper
/// left corner, which do not depend on how many pixels a file of it has.
struct Page {
    double width = 0.0, height = 0.0;
    double scale = 1.0;  ///< pixels a unit has in a file without vectors, and in the pictures
    PlotColour ground = 0xFFFFFFFF;
    std::vector<PagePicture> pictures;
    PlotDrawing drawing;

    /// The pixels of a picture of that many units.
    [[nodiscard]] Viewport pixelsOf(const Viewport& size) const {
        return {int(std::lround(scale * size.width)), int(std::lround(scale * size.height))};
    }

    void text(const PlotPoint& at, const std::string& words, PlotColour colour, TextAnchor anchor = TextAnchor::Start,
              bool bold = false) {
        drawing.items.emplace_back(DrawnText{at, words, colour, anchor, bold});
    }
};

/// The colours of a page and its letters, those of the installed fonts. `scale`: of the page; `letters`: that much larger than
/// its units say.
[[nodiscard]] PlotStyle pageStyle(const Letters& letters, double scale = 1.0);

/// The plots below each other, as linePlotsSvg has them.
[[nodiscard]] Page linePlotsPage(const std::vector<LinePlot>& plots, const PlotStyle& style);

/// A page as an SVG document with the pictures in it; text stays text, in a font that its viewer chooses.
[[nodiscard]] std::string pageSvg(const Page& page);
/// A page as a picture of its scale. `letters`: those that the page was laid out with.
[[nodiscard]] Picture pagePicture(const Page& page, const Letters& letters);

}  // namespace cullscope
