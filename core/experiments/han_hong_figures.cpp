#include "core/experiments/han_hong_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/frame/flow_way.h"
#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/image/cell_map_page.h"
#include "core/image/flow_chart_drawing.h"
#include "core/image/spherical_model.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;

constexpr double kBetween = 8.0;  ///< pictures beside each other, pixels
constexpr PlotColour kRed = 0xFFDB1414;

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
        const FlowChart& flow = strategy().info().first(Show::Kind::Listing)->chart;
        double height = 0.0;
        PlotDrawing chart = drawFlowChart(
            flow, line, inner(), height, m_look.style, {}, [this](const std::string& text) { return m_look.say({text}); },
            flowWay(flow, log, log.entries() == whole.entries()));
        moveBy(chart, {kMargin, m_bottom});
        std::ranges::move(chart.items, std::back_inserter(m_page.drawing.items));
        m_bottom += height;
        m_bottom = addLegend(
            m_page,
            {{{Shape::Area, FlowColours{}.lit},
              m_look.say({CULLSCOPE_TR("the step in hand: %1 of %2"),
                          {Term::plain(m_request.step.value_or(whole.entries())), Term::plain(whole.entries())}})},
             {{Shape::Area, FlowColours{}.passed, 1.5, FlowColours{}.way}, say(CULLSCOPE_TR("the way taken until then"))},
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
        const spherical::MapSnapshot map = shownMap(log);
        if (!map.decision.region)
            throwUsage(CULLSCOPE_TR("Figure %1: no corner ray meets the object in this view. Choose another case or pose."),
                       {std::to_string(m_request.number)});
        addWords(strategy().directionMap("index-map", log)->decisionWords);
        // The eye is seen, too: from as far as it lies away.
        const Sphere& sphere = scene().boundingSphere();
        const double away = glm::length(culling.eye() - sphere.centre) / sphere.radius;
        const View viewing(beside(culling, 40.0, 24.0, 2.4 + 0.64 * away, 0.42), size);
        addPicture(size, drawn(log, viewing, {"ghost"}, [&](const OverlayContext& context) {
                       std::vector<OverlayLines> overlays = searchOnSurface(context, map);
                       overlays.insert(overlays.begin(), greatCircles(context, map));
                       return overlays;
                   }));
        labelSearch(viewing, map);
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        addLegendBelow({{{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("submitted"))},
                        {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("rest of the object"))},
                        {{Shape::Line, stateColour(TriangleState::Visible), 1.0}, say(CULLSCOPE_TR("bounding sphere"))},
                        {{Shape::Line, dark}, say(CULLSCOPE_TR("corner ray, pale behind a surface"))},
                        {{Shape::Ring, dark}, say(CULLSCOPE_TR("where it enters the sphere"))},
                        {{Shape::Dot, kRed}, say(CULLSCOPE_TR("corner: hit"))},
                        {{Shape::Cross, dark, 2.0}, say(CULLSCOPE_TR("corner: miss, nearest point"))},
                        {{Shape::Dashed, kRed}, say(CULLSCOPE_TR("visible region, on the surface"))},
                        {{Shape::Line, dark, 2.0}, say(CULLSCOPE_TR("its box, on the surface"))}},
                       size.height);
    }

    /// Names the eye, and the corners by their numbers, away from the patch between them.
    void labelSearch(const View& viewing, const spherical::MapSnapshot& map) {
        constexpr double kAside = 14.0;
        const spherical::MapPlace place(scene(), map);
        Vec3 middle(0.0);
        for (const spherical::CornerRay& ray : map.decision.rays) middle += 0.25 * ray.point;
        const std::optional<PlotPoint> centre = placeIn(viewing, place.world(middle));
        for (size_t i = 0; i < map.decision.rays.size(); ++i) {
            const std::optional<PlotPoint> at = placeIn(viewing, place.world(map.decision.rays[i].point));
            if (!at || !centre || !map.decision.rays[i].followed) continue;
            const Vec2 away(at->x - centre->x, at->y - centre->y);
            const Vec2 aside = kAside / std::max(glm::length(away), 1e-9) * away;
            addLabel({at->x + aside.x, at->y + aside.y}, std::to_string(i + 1));
        }
        if (const std::optional<PlotPoint> eye = placeIn(viewing, place.world(map.decision.eye)))
            addLabel({eye->x, eye->y + kAside}, say(CULLSCOPE_TR("eye")));
    }

    /// Words around a place in the newest picture, as far as they stay in it.
    void addLabel(const PlotPoint& at, const std::string& words) {
        const PagePicture& picture = m_page.pictures.back();
        const PlotStyle& style = m_look.style;
        const double left = std::clamp(at.x - style.width(words) / 2, 0.0, picture.size.width - style.width(words));
        const double baseline = std::clamp(at.y - style.height / 2 + style.ascent, style.ascent, double(picture.size.height));
        m_page.text({picture.corner.x + left, picture.corner.y + baseline}, words, style.text, TextAnchor::Start, true);
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
             {{Shape::Dot, dark}, say(CULLSCOPE_TR("nearest to the eye"))},
             {{Shape::Ring, dark}, say(CULLSCOPE_TR("opposite"))}},
            pictureHeight);
    }

    void sizes() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        requireBands(log);
        const Viewport size = pictureSize();
        const spherical::MapSnapshot map = shownMap(log);
        const spherical::MapPlace place(scene(), map);
        const Vec3 upright = scene().upAxis() == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
        const spherical::ContourBands& bands = *map.decision.bands;
        const uint32_t sector = tellingSector(bands, glm::normalize(glm::transpose(place.linear()) * upright));
        addWords({CULLSCOPE_TR("S of the bands of %1 in one sector"), {Term::angle(bands.width)}});
        addPicture(size, drawn(log, View(acrossSector(map, sector), size), {"ghost"},
                               [&](const OverlayContext& context) { return spherical::sizeOverlay(context, {map}, sector); }));
        const std::vector<spherical::SizePlace> sizes = spherical::sizePlaces(map, sector);
        const PlotColour green = plotColour(spherical::sizeColour(m_style.background));
        std::vector<PageLegendEntry> entries{
            {{Shape::Letter, green}, say(CULLSCOPE_TR("the largest S: from the axis to the surface"))},
            {{Shape::Line, green, 2.0}, say(CULLSCOPE_TR("S of a band that is drawn"))},
            {{Shape::Dashed, green, 2.0}, say(CULLSCOPE_TR("S of a band that is hidden"))},
            {{Shape::Dashed, green, 1.0}, say(CULLSCOPE_TR("level of the largest S: what stays below it is hidden"))},
            {{Shape::Line, green, 1.0}, say(CULLSCOPE_TR("edges of the sector and its bands"))},
            {{Shape::Dot, plotColour(contrastTo(m_style.background))}, say(CULLSCOPE_TR("nearest to the eye"))},
            {{Shape::Ring, plotColour(contrastTo(m_style.background))}, say(CULLSCOPE_TR("opposite"))},
            {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("what is not drawn"))}};
        if (std::ranges::any_of(sizes, &spherical::SizePlace::larger))
            entries.insert(entries.begin() + 3, {{Shape::Dashed, stateColour(TriangleState::WronglyCulled), 2.0},
                                                 say(CULLSCOPE_TR("hidden for good by a nearer band, though its S is larger"))});
        addLegendBelow(entries, size.height);
    }

    /// A camera that sees a sector in profile: the axis to the side, S upward.
    [[nodiscard]] Camera acrossSector(const spherical::MapSnapshot& map, uint32_t sector) const {
        constexpr double kAway = 3.6, kRise = 0.2;  // radii; share of the distance
        const spherical::ContourBands& bands = *map.decision.bands;
        const Mat3 world = spherical::MapPlace(scene(), map).linear();
        const Vec3 axis = glm::normalize(world * bands.axis);
        const Vec3 outward = glm::normalize(world * bands.direction(kRightAngle, (sector + 0.5) * kTurn / bands.sectors));
        const Sphere sphere = scene().instanceSphere(map.decision.instance);
        Camera camera = wholeView().camera();
        camera.target = sphere.centre;
        camera.eye = sphere.centre + kAway * sphere.radius * glm::normalize(glm::cross(axis, outward) + kRise * outward);
        camera.up = outward;
        camera.fovy = Angle::fromDegrees(35.0);
        fitDepthRange(camera, scene());
        return camera;
    }

    void hidden() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        requireBands(log);
        const Viewport size = pictureSize();
        const spherical::MapSnapshot map = shownMap(log);
        addPicture(size, drawn(log, View(beside(culling, 128.0, 18.0, 4.2), size), {"verdicts"},
                               [&](const OverlayContext& context) { return contoursOnSurface(context, map); }));
        m_bottom += size.height;
        const TriangleStates states = statesAgainstTruth(log);
        addMap(log, "state", &states);
    }

    void frontAndBack() {
        const View culling = wholeView();
        const FrameLog log = frameOf(culling, 1);
        const int third = int(inner() - 2 * kBetween) / 3;
        const Viewport size{third, third};
        const Vec3& centre = scene().boundingSphere().centre;
        Camera front = culling.camera();
        front.fovy = Angle::fromDegrees(45.0);
        Camera behind = front;
        behind.eye = 2.0 * centre - front.eye;
        behind.target = 2.0 * centre - front.target;
        Camera side = beside(culling, 90.0, 0.0, glm::length(front.eye - centre) / scene().boundingSphere().radius);
        side.fovy = front.fovy;
        for (Camera* camera : {&behind, &side}) fitDepthRange(*camera, scene());

        const View eye(front, size);
        std::vector<uint8_t> seen = drawn(log, eye, {"back-sides"});
        const double lost = markLost(log, eye, seen);
        const auto rim = [&](const OverlayContext& context) { return std::vector{rimOf(context, log)}; };
        const std::array names{CULLSCOPE_TR("from the eye"), CULLSCOPE_TR("from the side, with what was left out"),
                               CULLSCOPE_TR("from the opposite side")};
        std::array pictures{std::move(seen), drawn(log, View(side, size), {"back-sides", "ghost"}, rim),
                            drawn(log, View(behind, size), {"back-sides"}, rim)};
        double below = 0.0;
        for (size_t i = 0; i < pictures.size(); ++i) {
            const double left = kMargin + double(i) * (size.width + kBetween);
            addPicture(size, std::move(pictures[i]), left);
            below = std::max(below, addText(m_page, say(names[i]), {left, m_bottom + size.height + 4.0}, size.width, m_look.style,
                                            m_look.style.text));
        }
        addLegendBelow({{{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("front sides of what is drawn"))},
                        {{Shape::Area, plotColour(backColour(m_style.background))},
                         say(CULLSCOPE_TR("its back sides: the hollow behind them was left out"))},
                        {{Shape::Line, plotColour(contrastTo(m_style.background)), 1.5},
                         say(CULLSCOPE_TR("rim of what is drawn: there the shell ends"))},
                        {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("what is not drawn"))},
                        {{Shape::Area, stateColour(TriangleState::WronglyCulled)},
                         m_look.say({CULLSCOPE_TR("lost pixels: %1"), {Term::share(lost)}})}},
                       below - m_bottom);
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

std::string figureStrategy(int number) {
    return number >= 5 && number <= 7 ? fmt::format("{}:band=15", kShownStrategy) : kShownStrategy;
}

Figure figure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    return FigureMaker(request, look, progress).make();
}

}  // namespace cullscope::han_hong
