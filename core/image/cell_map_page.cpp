#include "core/image/cell_map_page.h"

#include <fmt/format.h>

#include <set>

#include "core/gpu/colour.h"
#include "core/image/cell_map_picture.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope {
namespace {

constexpr int kFrame = 14;          ///< the margin around the map in its picture, pixels
constexpr double kNumbers = 30.0;   ///< room for θ's numbers on the left of the picture
constexpr double kAxisName = 22.0;  ///< and for the axis' name before them
constexpr PlotColour kRegionRed = 0xFFDB1414;

std::vector<PageLegendEntry> statesOf(const CellMap& map, const Vec3f& background, const PageLook& look) {
    std::set<TriangleState> states;
    for (const std::optional<TriangleState>& state : map.source->states())
        if (state) states.insert(*state);
    const auto palette = verdictPalette(background);
    std::vector<PageLegendEntry> entries;
    for (const TriangleState state : states)
        entries.push_back(
            {{PageSign::Shape::Area, plotColour(palette[size_t(state)].colour)}, look.say({triangleStateName(state)})});
    return entries;
}

/// The map with the circles that its legend speaks of.
CellMap withFewCircles(CellMap map) {
    if (!map.circles) return map;
    map.circles->width *= map.circles->every;
    map.circles->bands = (map.circles->bands + map.circles->every - 1) / map.circles->every;
    return map;
}

}  // namespace

PageSign signOf(MapSymbol symbol, const Vec3f& background) {
    const PlotColour contrast = plotColour(contrastTo(background));
    switch (symbol) {
        case MapSymbol::Region:
            return {PageSign::Shape::Region, kRegionRed, 2.0};
        case MapSymbol::Hit:
            return {PageSign::Shape::Dot, kRegionRed};
        case MapSymbol::Miss:
            return {PageSign::Shape::Cross, contrast, 2.0};
        case MapSymbol::Walked:
            return {PageSign::Shape::Area, 0xBF000000 | (contrast & 0xFFFFFF)};
        case MapSymbol::Box:
        case MapSymbol::Cell:
        case MapSymbol::Part:
        case MapSymbol::Picked:
        case MapSymbol::Cells:
            return {PageSign::Shape::Frame, contrast, symbol == MapSymbol::Box ? 2.0 : 1.0};
        case MapSymbol::RightAngle:
            return {PageSign::Shape::Line, contrast, 2.0};
        case MapSymbol::Circle:
            return {PageSign::Shape::Line, contrast, 1.0};
        case MapSymbol::Start:
            return {PageSign::Shape::Dot, contrast};
        case MapSymbol::End:
            return {PageSign::Shape::Ring, contrast, 2.0};
        case MapSymbol::Horizon:
            return {PageSign::Shape::Line, kRegionRed, 2.0};
    }
    return {};
}

double addCellMap(Page& page, const CellMap& given, std::string_view colouring, const PlotPoint& corner, double width,
                  const DrawStyle& style, const PageLook& look) {
    const CellMap map = withFewCircles(given);
    const PlotStyle& plot = look.style;
    double y = addText(page, look.say(map.objectWords), corner, width, plot, plot.text);
    y = addText(page, look.say(map.decisionWords), {corner.x, y}, width, plot, plot.text, true) + 4.0;

    const int across = int(width - kNumbers - kAxisName) - 2 * kFrame, down = across / 2;
    const Viewport size{across + 2 * kFrame, down + 2 * kFrame};
    const PlotPoint picture{corner.x + kNumbers + kAxisName, y};
    page.pictures.push_back({picture, size, cellMapPicture(map, colouring, page.pixelsOf(size), style)});
    const double left = picture.x + kFrame, top = picture.y + kFrame, bottom = top + down;
    for (int degrees = 0; degrees <= 180; degrees += 30)
        page.text({left - kFrame, top + down * degrees / 180.0 + plot.ascent - plot.height / 2}, fmt::format("{}°", degrees),
                  plot.text, TextAnchor::End);
    for (int degrees = 0; degrees <= 360; degrees += 30)
        page.text({left + across * degrees / 360.0, bottom + kFrame + plot.ascent}, fmt::format("{}°", degrees), plot.text,
                  TextAnchor::Middle);
    page.text({corner.x, top + down / 2.0}, "θ", plot.text, TextAnchor::Start, true);
    page.text({left + across / 2.0, bottom + kFrame + plot.height + plot.ascent}, "φ", plot.text, TextAnchor::Middle, true);
    y = bottom + kFrame + 2.2 * plot.height;

    std::vector<PageLegendEntry> entries;
    for (const MapLegendEntry& entry : map.legend)
        entries.push_back({signOf(entry.symbol, style.background), look.say(entry.words)});
    const MapColouring* shown = map.colouring(colouring);
    if (shown != nullptr && shown->states) {
        const std::vector<PageLegendEntry> states = statesOf(map, style.background, look);
        entries.insert(entries.begin(), states.begin(), states.end());
    }
    y = addLegend(page, entries, {picture.x, y}, width - kNumbers - kAxisName, plot);
    if (shown == nullptr || shown->states) return y;
    const MapValues values = map.source->values(colouring);
    return addScale(page,
                    {look.say({"%1", {values.least}}), look.say({"%1", {values.most}}), look.say(shown->scale),
                     [&](double share) { return rampColour(share, style.background); }},
                    {picture.x, y}, plot);
}

}  // namespace cullscope
