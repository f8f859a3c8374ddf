#include "core/image/page_legend.h"

#include <cmath>

namespace cullscope {
namespace {

constexpr double kSign = 22.0;  ///< width, pixels
constexpr double kBehindSign = 6.0, kBetween = 18.0;
constexpr PlotColour kTint = 0x38000000;  ///< opacity of what a region's outline encloses
constexpr double kScaleWidth = 120.0, kScaleHeight = 10.0;
constexpr int kScaleSteps = 24;
constexpr double kDotRadius = 4.5, kArm = 4.5;

void addSign(Page& page, const PageSign& sign, const PlotPoint& middle) {
    const PlotPen pen{sign.colour, sign.width};
    const auto path = [&](std::vector<PlotPoint> points, const PlotPen& with, PlotColour fill = 0) {
        page.drawing.items.emplace_back(DrawnPath{std::move(points), with, fill});
    };
    const double left = middle.x - kSign / 2, right = middle.x + kSign / 2;
    const std::vector<PlotPoint> frame{
        {left, middle.y - 6.0}, {right, middle.y - 6.0}, {right, middle.y + 6.0}, {left, middle.y + 6.0}, {left, middle.y - 6.0}};
    switch (sign.shape) {
        case PageSign::Shape::Area:
            return path(frame, {sign.edge, sign.edge != 0 ? sign.width : 0.0}, sign.colour);
        case PageSign::Shape::Frame:
            return path(frame, pen);
        case PageSign::Shape::Region:
            return path(frame, {sign.colour, sign.width, PlotStroke::Dashed}, kTint | (sign.colour & 0xFFFFFF));
        case PageSign::Shape::Line:
            return path({{left, middle.y}, {right, middle.y}}, pen);
        case PageSign::Shape::Dashed:
            return path({{left, middle.y}, {right, middle.y}}, {sign.colour, sign.width, PlotStroke::Dashed});
        case PageSign::Shape::Dot:
            page.drawing.items.emplace_back(DrawnDisc{middle, kDotRadius, {}, sign.colour});
            return;
        case PageSign::Shape::Ring:
            page.drawing.items.emplace_back(DrawnDisc{middle, kDotRadius, pen});
            return;
        case PageSign::Shape::Cross:
            for (const double side : {1.0, -1.0})
                path({{middle.x - kArm, middle.y - side * kArm}, {middle.x + kArm, middle.y + side * kArm}}, pen);
            return;
        case PageSign::Shape::Letter:
            page.text({middle.x, middle.y + 5.0}, "S", sign.colour, TextAnchor::Middle, true);
            return;
    }
}

}  // namespace

PlotColour plotColour(const Vec3f& colour) {
    const auto byte = [](float share) { return PlotColour(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f)); };
    return 0xFF000000 | byte(colour.x) << 16 | byte(colour.y) << 8 | byte(colour.z);
}

double addLegend(Page& page, const std::vector<PageLegendEntry>& entries, const PlotPoint& corner, double width,
                 const PlotStyle& style) {
    const double row = 1.25 * style.height;
    double x = corner.x, y = corner.y;
    for (const PageLegendEntry& entry : entries) {
        const double needed = kSign + kBehindSign + style.width(entry.words);
        if (x > corner.x && x + needed > corner.x + width) x = corner.x, y += row;
        addSign(page, entry.sign, {x + kSign / 2, y + row / 2});
        page.text({x + kSign + kBehindSign, y + row / 2 - style.height / 2 + style.ascent}, entry.words, style.text);
        x += needed + kBetween;
    }
    return entries.empty() ? corner.y : y + row;
}

double addScale(Page& page, const PageScale& scale, const PlotPoint& corner, const PlotStyle& style) {
    const double baseline = corner.y + style.ascent, left = corner.x + style.width(scale.least) + kBehindSign;
    page.text({corner.x, baseline}, scale.least, style.text);
    for (int step = 0; step < kScaleSteps; ++step) {
        const double from = left + kScaleWidth * step / kScaleSteps, to = left + kScaleWidth * (step + 1) / kScaleSteps;
        const double top = corner.y + (style.height - kScaleHeight) / 2;
        page.drawing.items.emplace_back(DrawnPath{{{from, top}, {to, top}, {to, top + kScaleHeight}, {from, top + kScaleHeight}},
                                                  {},
                                                  plotColour(scale.colour(double(step) / (kScaleSteps - 1)))});
    }
    page.text({left + kScaleWidth + kBehindSign, baseline}, scale.most + (scale.words.empty() ? "" : "   " + scale.words),
              style.text);
    return corner.y + 1.25 * style.height;
}

double addText(Page& page, const std::string& words, const PlotPoint& corner, double width, const PlotStyle& style,
               PlotColour colour, bool bold) {
    double y = corner.y;
    for (const std::string& line : linesOf(words, width, style)) {
        page.text({corner.x, y + style.ascent}, line, colour, TextAnchor::Start, bold);
        y += style.height;
    }
    return y;
}

}  // namespace cullscope
