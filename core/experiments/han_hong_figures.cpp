#include "core/experiments/han_hong_figures.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/gpu/colour.h"
#include "core/image/cell_map_page.h"
#include "core/image/flow_chart_drawing.h"
#include "core/image/spherical_model.h"
#include "core/visibility/spherical/map_overlays.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;

constexpr double kBetween = 8.0;  ///< pictures beside each other, pixels
constexpr PlotColour kRed = 0xFFDB1414;

/// What is left of the lines that lie on the far side of a place, as seen by a camera: they do not cross what stands there. None
/// is longer than `longest`, as an axis through it is.
void keepBeyond(std::vector<OverlayLines>& overlays, const View& viewing, const Vec3& place, double longest) {
    const Vec3 forward = glm::normalize(place - viewing.eye());
    for (OverlayLines& overlay : overlays)
        std::erase_if(overlay.lines, [&](const LineSegment& line) {
            return glm::length(line.to - line.from) > longest || glm::dot(0.5 * (line.from + line.to) - place, forward) < 0.0;
        });
}

/// Draws one figure's page.
class FigureMaker : private FigurePage {
public:
    using FigurePage::FigurePage;

    [[nodiscard]] Figure make() {
        switch (m_request.number) {
            case 1:
                flow();
                break;
            case 2:
                model();
                break;
            case 3:
                search();
                break;
            case 4:
                maps();
                break;
            case 5:
                sampling();
                break;
            case 6:
                sizes();
                break;
            case 7:
                hidden();
                break;
            case 8:
                frontAndBack();
                break;
            default:
                throwUsage(CULLSCOPE_TR("There is no Figure %1: the paper has 1 to %2."),
                           {std::to_string(m_request.number), std::to_string(kFigures)});
        }
        m_page.height = m_bottom + kMargin;
        return {std::move(m_page), std::move(m_data)};
    }

private:
    void flow() {
        const FrameLog whole = frameOf(viewOfCase(m_request.onlyCase.value_or(2)), 1);
        if (m_request.step && *m_request.step > whole.entries())
            throwUsage(CULLSCOPE_TR("--step %1: this frame has the steps 0 to %2."),
                       {std::to_string(*m_request.step), std::to_string(whole.entries())});
        const FrameLog log = whole.upTo(m_request.step.value_or(whole.entries()));
        const std::optional<ListingState> state = strategy().listing(log);
        const uint8_t line = state ? state->current : 0;
        double height = 0.0;
        PlotDrawing chart = drawFlowChart(strategy().info().first(Show::Kind::Listing)->chart, line, inner(), height,
                                          m_look.style, {}, [this](const std::string& text) { return m_look.say({text}); });
        moveBy(chart, {kMargin, m_bottom});
        std::ranges::move(chart.items, std::back_inserter(m_page.drawing.items));
        m_bottom += height;
        m_bottom =
            addLegend(m_page,
                      {{{Shape::Area, FlowColours{}.lit},
                        m_look.say({CULLSCOPE_TR("the step in hand: %1 of %2"),
                                    {Term::plain(m_request.step.value_or(whole.entries())), Term::plain(whole.entries())}})},
                       {{Shape::Area, FlowColours{}.structure}, say(CULLSCOPE_TR("structure"))}},
                      {kMargin, m_bottom + 4.0}, inner(), m_look.style);
    }
    void model() {
        const View view(wholeView().camera(), pictureSize());
        const FrameLog log = frameOfAll(view);
        addPicture(view.viewport(), drawn(log, view, {}));
        m_bottom += view.viewport().height + 4.0;
        const Viewport size{int(inner()), int(inner()) / 2 + 40};
        Framebuffer target(size);
        drawSphericalModel(m_renderer, m_buffers, View(view.camera(), size), drawnTriangles(scene(), log), m_style, target);
        addPicture(size, target.readColour());
        const MapArea area = sphericalModelArea(size, m_style);
        const PlotStyle& style = m_look.style;
        const double left = kMargin + area.left, bottom = m_bottom + size.height - area.bottom, top = bottom - area.height;
        for (int degrees = 0; degrees <= 360; degrees += 30)
            m_page.text({left + area.width * degrees / 360.0, bottom + 6.0 + style.ascent}, fmt::format("{}°", degrees),
                        style.text, TextAnchor::Middle);
        for (int degrees = 0; degrees <= 180; degrees += 30)
            m_page.text({left - 8.0, top + area.height * degrees / 180.0 + style.ascent - style.height / 2},
                        fmt::format("{}°", degrees), style.text, TextAnchor::End);
        m_page.text({left + area.width / 2, bottom + 6.0 + style.height + style.ascent}, "φ", style.text, TextAnchor::Middle,
                    true);
        m_page.text({kMargin, top + area.height / 2}, "θ", style.text, TextAnchor::Start, true);
        std::vector<PageLegendEntry> entries;
        const std::array<Vec3f, 5> ramp = reliefColours();
        for (size_t i = 0; i < ramp.size(); ++i)
            entries.push_back({{Shape::Area, plotColour(ramp[i])},
                               fmt::format("R = {:.2f}", double(i) / (ramp.size() - 1) * scene().boundingSphere().radius)});
        addLegendBelow(entries, size.height);
    }

    void search() {
        const View culling = viewOfCase(m_request.onlyCase.value_or(2));
        const FrameLog log = frameOf(culling, 1);
        const Viewport size = pictureSize();
        const View viewing(beside(culling, 34.0, 26.0, 4.2, 0.3), size);
        addPicture(size, drawn(log, viewing, {"ghost", "boxes"}));
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        addLegendBelow({{{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("submitted"))},
                        {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("rest of the object"))},
                        {{Shape::Line, stateColour(TriangleState::Visible), 1.0}, say(CULLSCOPE_TR("bounding sphere"))},
                        {{Shape::Line, dark}, say(CULLSCOPE_TR("corner ray"))},
                        {{Shape::Ring, dark}, say(CULLSCOPE_TR("where it enters the sphere"))},
                        {{Shape::Dot, kRed}, say(CULLSCOPE_TR("corner: hit"))},
                        {{Shape::Cross, dark, 2.0}, say(CULLSCOPE_TR("corner: miss, nearest point"))},
                        {{Shape::Dashed, kRed}, say(CULLSCOPE_TR("visible region"))},
                        {{Shape::Frame, dark}, say(CULLSCOPE_TR("its box"))}},
                       size.height);
    }

    void maps() {
        for (const int number : {1, 2, 3}) {
            if (m_request.onlyCase.value_or(number) != number) continue;
            addMap(frameOf(viewOfCase(number), size_t(number)), "entries");
            m_bottom += 8.0;
        }
    }

    void sampling() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        requireBands(log);
        const Viewport size = pictureSize();
        addPicture(size, drawn(log, View(beside(culling, 50.0, 20.0, 4.4), size), {"bands"}));
        addBandLegend(size.height);
        addMap(log, "entries");
    }
    void addBandLegend(double pictureHeight) {
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        addLegendBelow(
            {{{Shape::Line, stateColour(TriangleState::Visible), 1.0}, say(CULLSCOPE_TR("contour of a band that is drawn"))},
             {{Shape::Line, stateColour(TriangleState::Hidden), 1.0}, say(CULLSCOPE_TR("contour of a band that is hidden"))},
             {{Shape::Line, dark, 2.5}, "α = 90°"},
             {{Shape::Ring, dark}, say(CULLSCOPE_TR("nearest to the eye"))},
             {{Shape::Dot, dark}, say(CULLSCOPE_TR("opposite"))}},
            pictureHeight);
    }

    void sizes() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        requireBands(log);
        const Viewport size = pictureSize();
        addPicture(size, drawn(log, View(beside(culling, 84.0, 12.0, 4.0), size), {"ghost", "sizes"}));
        const PlotColour green = plotColour(spherical::sizeColour(m_style.background));
        addLegendBelow({{{Shape::Letter, green}, say(CULLSCOPE_TR("S, from the axis to the surface, of the labelled sector"))},
                        {{Shape::Line, green, 2.0}, say(CULLSCOPE_TR("S of a band that is drawn"))},
                        {{Shape::Dashed, green, 2.0}, say(CULLSCOPE_TR("S of a band that is hidden"))},
                        {{Shape::Line, green, 1.0}, say(CULLSCOPE_TR("edges of the sector"))},
                        {{Shape::Ring, plotColour(contrastTo(m_style.background))}, say(CULLSCOPE_TR("nearest to the eye"))},
                        {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("what is not drawn"))}},
                       size.height);
    }

    void hidden() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        requireBands(log);
        const Viewport size = pictureSize();
        const View viewing(beside(culling, 128.0, 18.0, 4.2), size);
        addPicture(size, drawn(log, viewing, {"verdicts"}, [&](const OverlayContext& context) {
                       std::vector<OverlayLines> overlays = strategy().overlay("bands", context, log);
                       const Sphere& sphere = scene().boundingSphere();
                       keepBeyond(overlays, viewing, sphere.centre, sphere.radius);
                       return overlays;
                   }));
        addLegendBelow(
            {stateEntry(TriangleState::Visible),
             stateEntry(TriangleState::InVain),
             stateEntry(TriangleState::Hidden),
             stateEntry(TriangleState::WronglyCulled),
             {{Shape::Line, stateColour(TriangleState::Visible), 1.0}, say(CULLSCOPE_TR("contour, behind the object"))}},
            size.height);
        addMap(log, "state");
    }

    void frontAndBack() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        const int half = int(inner() - kBetween) / 2;
        const Viewport size{half, half};
        Camera front = culling.camera();
        front.fovy = Angle::fromDegrees(45.0);
        Camera behind = front;
        behind.eye = 2.0 * scene().boundingSphere().centre - front.eye;
        behind.target = 2.0 * scene().boundingSphere().centre - front.target;
        fitDepthRange(behind, scene());
        const double right = kMargin + size.width + kBetween;
        addPicture(size, drawn(log, View(front, size), {"back-sides"}));
        addPicture(size, drawn(log, View(behind, size), {"back-sides"}), right);
        m_page.text({kMargin, m_bottom + size.height + m_look.style.height}, say(CULLSCOPE_TR("from the eye")),
                    m_look.style.text);
        m_page.text({right, m_bottom + size.height + m_look.style.height}, say(CULLSCOPE_TR("from the opposite side")),
                    m_look.style.text);
        addLegendBelow({{{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("front sides of what is drawn"))},
                        {{Shape::Area, plotColour(backColour(m_style.background))},
                         say(CULLSCOPE_TR("its back sides: the hollow behind them was left out"))}},
                       size.height + 1.4 * m_look.style.height);
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

Figure figure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    return FigureMaker(request, look, progress).make();
}

}  // namespace cullscope::han_hong
