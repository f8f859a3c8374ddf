#include "core/experiments/han_hong_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/experiments/han_hong_band_figures.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/experiments/han_hong_model_figure.h"
#include "core/experiments/han_hong_search_figure.h"
#include "core/frame/flow_way.h"
#include "core/image/flow_chart_drawing.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;

/// Draws Figures 1 and 4.
class FigureMaker : private FigurePage {
public:
    using FigurePage::FigurePage;

    [[nodiscard]] Figure flow() {
        const FrameLog whole = frameOf(viewOfCase(m_request.onlyCase.value_or(2)), 1);
        if (m_request.step && *m_request.step > whole.entries())
            throwUsage(CULLSCOPE_TR("--step %1: this frame has the steps 0 to %2."),
                       {std::to_string(*m_request.step), std::to_string(whole.entries())});
        const FrameLog log = whole.upTo(m_request.step.value_or(whole.entries()));
        if (const CellMapPointer map = strategy().directionMap("index-map", whole)) addWords(map->decisionWords);
        // Without a step in hand the chart is the method's alone, with the way of the view.
        const std::optional<ListingState> state = m_request.step ? strategy().listing(log) : std::nullopt;
        const uint8_t line = state ? state->current : 0;
        const FlowChart& flow = strategy().info().first(Show::Kind::Listing)->chart;
        double height = 0.0;
        PlotDrawing chart = drawFlowChart(
            flow, line, inner(), height, m_look.style, {}, [this](const std::string& text) { return m_look.say({text}); },
            flowWay(flow, log, log.entries() == whole.entries()));
        moveBy(chart, {kMargin, m_bottom});
        std::ranges::move(chart.items, std::back_inserter(m_page.drawing.items));
        m_bottom += height;
        std::vector<PageLegendEntry> entries{{{Shape::Area, FlowColours{}.passed, 1.5, FlowColours{}.way},
                                              say(m_request.step ? CULLSCOPE_TR("the way taken until then")
                                                                 : CULLSCOPE_TR("the way of the view in this figure"))}};
        if (m_request.step)
            entries.insert(entries.begin(), {{Shape::Area, FlowColours{}.lit},
                                             m_look.say({CULLSCOPE_TR("the step in hand: %1 of %2"),
                                                         {Term::plain(*m_request.step), Term::plain(whole.entries())}})});
        addLegendBelow(entries, 0.0);
        return finish();
    }

    [[nodiscard]] Figure maps() {
        for (const int number : {1, 2, 3}) {
            if (m_request.onlyCase.value_or(number) != number) continue;
            const FrameLog log = frameOf(viewOfCase(number), size_t(number));
            addMap(log, "entries");
            const uint64_t drawn = drawnTriangles(scene(), log).triangleCount();
            addWords({CULLSCOPE_TR("Drawn: %1 of %2 triangles"), {Term::count(drawn), Term::count(scene().triangleCount())}});
            m_bottom += 8.0;
        }
        return finish();
    }
};

}  // namespace

const char* figureTitle(int number) {
    static constexpr std::array kTitles{CULLSCOPE_TR("Flow chart of the method"),
                                        CULLSCOPE_TR("The object and the same in spherical coordinates"),
                                        CULLSCOPE_TR("How the intersections of rays are computed"),
                                        CULLSCOPE_TR("The visible region on the index map, by case"),
                                        CULLSCOPE_TR("Sampled bands on the object, and their contours on the map"),
                                        CULLSCOPE_TR("S in the sampled bands"),
                                        CULLSCOPE_TR("Sampled bands and what they hide"),
                                        CULLSCOPE_TR("The picture without what is hidden, from both sides")};
    return number >= 1 && number <= kFigures ? kTitles[size_t(number - 1)] : "";
}

std::string figureStrategy(int number) { return number >= 5 ? fmt::format("{}:band=15", kShownStrategy) : kShownStrategy; }

FigureRequest figureRequest(int number, ScenePointer scene) {
    FigureRequest request;
    request.number = number;
    request.scene = std::move(scene);
    request.strategy = strategyFromText(figureStrategy(number));
    return request;
}

Figure figure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    switch (request.number) {
        case 1:
            return FigureMaker(request, look, progress).flow();
        case 2:
            return modelFigure(request, look, progress);
        case 3:
            return searchFigure(request, look, progress);
        case 4:
            return FigureMaker(request, look, progress).maps();
        case 5:
        case 6:
        case 7:
        case 8:
            return bandFigure(request, look, progress);
        default:
            throwUsage(CULLSCOPE_TR("There is no Figure %1: the paper has 1 to %2."),
                       {std::to_string(request.number), std::to_string(kFigures)});
    }
}

}  // namespace cullscope::han_hong
