#include "core/image/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/gpu/colour.h"
#include "core/image/drawing_svg.h"
#include "core/image/picture_formats_module.h"

namespace cullscope {
namespace {

constexpr int kSamples = 4;  ///< a pixel's side has, where an area is filled

Vec3f colourOf(PlotColour colour) { return colourFromHexadecimal(colour & 0xFFFFFF); }
double opacityOf(PlotColour colour) { return double(colour >> 24) / 255.0; }

std::string base64(const std::vector<unsigned char>& bytes) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](size_t place) { return place < bytes.size() ? uint32_t(bytes[place]) : 0u; };
        const uint32_t three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        for (int digit = 0; digit < 4; ++digit)
            text += i + size_t(digit) > bytes.size() ? '=' : kDigits[three >> (18 - 6 * digit) & 63];
    }
    return text;
}

std::string element(const PagePicture& picture, const Viewport& pixels) {
    const size_t row = 4 * size_t(pixels.width);
    PictureFileContent content;
    content.width = pixels.width;
    content.height = pixels.height;
    for (size_t y = size_t(pixels.height); y-- > 0;)
        content.bytes.insert(content.bytes.end(), picture.rgba.begin() + std::ptrdiff_t(y * row),
                             picture.rgba.begin() + std::ptrdiff_t((y + 1) * row));
    return fmt::format("<image x=\"{:.6g}\" y=\"{:.6g}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
                       picture.corner.x, picture.corner.y, picture.size.width, picture.size.height,
                       base64(pictureFormats().encoded(PictureFormat::Png, content)));
}

/// Whether a point lies inside an outline, by the even-odd rule.
bool isInside(const std::vector<PlotPoint>& outline, double x, double y) {
    bool inside = false;
    for (size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
        if ((outline[i].y > y) != (outline[j].y > y) &&
            x < outline[i].x + (outline[j].x - outline[i].x) * (y - outline[i].y) / (outline[j].y - outline[i].y))
            inside = !inside;
    return inside;
}

class PagePainter {
public:
    PagePainter(const Page& page, const Letters& letters)
        : m_page(page),
          m_size{int(std::ceil(page.scale * page.width)), int(std::ceil(page.scale * page.height))},
          m_canvas(m_size, colourOf(page.ground), float(opacityOf(page.ground))),
          m_letters(letters) {
        for (const PagePicture& picture : page.pictures) paint(picture);
        PlotDrawing drawing = page.drawing;
        scaleBy(drawing, page.scale);
        for (const auto& item : drawing.items) std::visit([&](const auto& drawn) { paint(drawn); }, item);
    }

    [[nodiscard]] Picture picture() const {
        Picture result;
        result.size = m_size;
        result.rgba = m_canvas.rgba();
        return result;
    }

private:
    void paint(const PagePicture& picture) {
        const int left = int(std::lround(m_page.scale * picture.corner.x));
        const int top = int(std::lround(m_page.scale * picture.corner.y));
        const Viewport pixels = m_page.pixelsOf(picture.size);
        for (int y = 0; y < pixels.height; ++y)
            for (int x = 0; x < pixels.width; ++x) {
                const uint8_t* pixel = &picture.rgba[4 * (size_t(pixels.height - 1 - y) * size_t(pixels.width) + size_t(x))];
                m_canvas.fill({double(left + x), double(top + y), left + x + 1.0, top + y + 1.0},
                              Vec3f(pixel[0], pixel[1], pixel[2]) / 255.0f, pixel[3] / 255.0);
            }
    }

    void paint(const DrawnPath& path) {
        if (path.fill != 0) fill(path.points, path.fill);
        if (path.pen.colour == 0 || path.points.empty()) return;
        std::vector<Vec2> points;
        for (const PlotPoint& point : path.points) points.emplace_back(point.x, point.y);
        const std::vector<double> dashes = dashesOf(path.pen.stroke);
        m_canvas.line(points, {colourOf(path.pen.colour), path.pen.width, dashes.empty() ? 0.0 : m_page.scale * dashes.front()});
    }

    void paint(const DrawnDisc& disc) {
        const Vec2 centre(disc.centre.x, disc.centre.y);
        if (disc.fill != 0) m_canvas.dot(centre, disc.radius, colourOf(disc.fill));
        if (disc.pen.colour != 0) m_canvas.ring(centre, disc.radius, {colourOf(disc.pen.colour), disc.pen.width});
    }

    void paint(const DrawnText& text) {
        const double width = m_letters.width(text.words, text.bold);
        const double share = text.anchor == TextAnchor::Start ? 0.0 : text.anchor == TextAnchor::Middle ? 0.5 : 1.0;
        m_letters.draw(m_canvas, {text.at.x - share * width, text.at.y}, text.words, colourOf(text.colour), text.bold);
    }

    void fill(const std::vector<PlotPoint>& outline, PlotColour colour) {
        const auto [left, right] = std::ranges::minmax(outline, {}, &PlotPoint::x);
        const auto [top, bottom] = std::ranges::minmax(outline, {}, &PlotPoint::y);
        for (int y = int(std::floor(top.y)); y < int(std::ceil(bottom.y)); ++y)
            for (int x = int(std::floor(left.x)); x < int(std::ceil(right.x)); ++x) {
                int inside = 0;
                for (int sample = 0; sample < kSamples * kSamples; ++sample)
                    inside +=
                        isInside(outline, x + (sample % kSamples + 0.5) / kSamples, y + (sample / kSamples + 0.5) / kSamples);
                if (inside > 0)
                    m_canvas.fill({double(x), double(y), x + 1.0, y + 1.0}, colourOf(colour),
                                  opacityOf(colour) * inside / (kSamples * kSamples));
            }
    }

    const Page& m_page;
    Viewport m_size;
    Canvas m_canvas;
    const Letters& m_letters;
};

}  // namespace

PlotStyle pageStyle(const Letters& letters, double scale) {
    PlotStyle style;
    style.series = plotSeries(false);
    style.ascent = letters.ascent() / scale;
    style.height = letters.height() / scale;
    style.width = [&letters, scale](const std::string& words) { return letters.width(words, true) / scale; };
    style.number = plotNumber;
    return style;
}

Page linePlotsPage(const std::vector<LinePlot>& plots, const PlotStyle& style) {
    Page page;
    page.width = kPlotWidth;
    for (const LinePlot& plot : plots) {
        PlotDrawing drawing = drawPlots({plot}, kPlotWidth, kPlotHeight, style);
        moveBy(drawing, {0.0, page.height});
        std::ranges::move(drawing.items, std::back_inserter(page.drawing.items));
        page.height += kPlotHeight;
    }
    return page;
}

std::string pageSvg(const Page& page) {
    std::string svg = svgBeginning(page.width, page.height, page.ground);
    for (const PagePicture& picture : page.pictures) svg += element(picture, page.pixelsOf(picture.size));
    return svg + svgElements(page.drawing) + "</svg>\n";
}

Picture pagePicture(const Page& page, const Letters& letters) { return PagePainter(page, letters).picture(); }

}  // namespace cullscope
