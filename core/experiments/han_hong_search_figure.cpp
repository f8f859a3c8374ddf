#include "core/experiments/han_hong_search_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/gpu/colour.h"
#include "core/scene/scene_rays.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;
using spherical::CornerRay;
using spherical::MapPlace;
using spherical::MapSnapshot;

constexpr PlotColour kHitRed = 0xFFDB1414, kCellBlue = 0xFF9EBCE0, kHitCell = 0xFFE0A030;
constexpr double kWholeHeight = 0.6, kNearWidth = 0.42, kNearHeight = 0.36;  ///< shares of the page's inner width
constexpr double kBesideSearch = 8.0;
constexpr double kNumberAside = 15.0;
constexpr double kShownOfWay = 0.3;  ///< of a ray's way inside the sphere, in the plot

class SearchFigure : private FigurePage {
public:
    using FigurePage::FigurePage;

    [[nodiscard]] Figure make() {
        const View culling = viewOfCase(m_request.onlyCase.value_or(2));
        const FrameLog log = frameOf(culling, 1);
        const MapSnapshot map = shownMap(log);
        if (!map.decision.region)
            throwUsage(CULLSCOPE_TR("Figure %1: no corner ray meets the object in this view. Choose another case or pose."),
                       {std::to_string(m_request.number)});
        addWords(strategy().directionMap("index-map", log)->decisionWords);

        const Camera camera = cameraOfHits(culling, map);
        std::vector<Vec3> places = wholeSphere(camera);
        places.push_back(culling.eye());
        const View whole = fitted(camera, places, {int(inner()), int(kWholeHeight * inner())});
        addSearch(log, map, whole, kMargin);
        // Away from the rays.
        const std::optional<PlotPoint> eye = placeIn(whole, culling.eye());
        const double outward = eye && eye->x > 0.5 * whole.viewport().width ? 1.0 : -1.0;
        addLabel(whole, culling.eye(), {outward * 2.0 * kNumberAside, 0.0}, say(CULLSCOPE_TR("eye")));
        m_bottom += whole.viewport().height + kBesideSearch;

        const View nearby = fitted(camera, aroundHits(map), {int(kNearWidth * inner()), int(kNearHeight * inner())});
        addSearch(log, map, nearby, kMargin);
        addPlate({m_page.pictures.back().corner.x + 4.0, m_page.pictures.back().corner.y + m_look.style.height / 2},
                 say(CULLSCOPE_TR("the same, enlarged")));
        addComparison(map, kMargin + nearby.viewport().width + kBesideSearch, nearby.viewport().height);
        addSigns(map, nearby.viewport().height);
        return finish();
    }

private:
    /// Of the cameras beside the culling view, in the order of how well they show rays in profile, the first that sees most hits.
    [[nodiscard]] Camera cameraOfHits(const View& culling, const MapSnapshot& map) const {
        constexpr std::array kTurns{38.0, -38.0, 28.0, -28.0, 50.0, -50.0, 18.0, -18.0};
        constexpr std::array kRises{20.0, 32.0, 10.0, 44.0};
        // The eye is seen, too: from as far as it lies away.
        const Sphere& sphere = scene().boundingSphere();
        const double away = glm::length(culling.eye() - sphere.centre) / sphere.radius;
        const SceneRays rays(scene(), sphere.centre);
        const MapPlace place(scene(), map);
        std::optional<Camera> best;
        int most = -1;
        for (const double rise : kRises)
            for (const double turn : kTurns) {
                const Camera camera = beside(culling, turn, rise, 2.4 + 0.64 * away, 0.42);
                const int seen = int(std::ranges::count_if(map.decision.rays, [&](const CornerRay& ray) {
                    return ray.hit && isSeen(rays, camera.eye, place.world(ray.point));
                }));
                if (seen > most) most = seen, best = camera;
            }
        return *best;
    }
    [[nodiscard]] static bool isSeen(const SceneRays& rays, const Vec3& eye, const Vec3& place) {
        constexpr double kAtPlace = 0.999;  // share of the way at which the place's own surface begins
        return !rays.first(eye, place - eye, 0.0, kAtPlace);
    }

    /// The hits with some room around them.
    [[nodiscard]] std::vector<Vec3> aroundHits(const MapSnapshot& map) const {
        constexpr double kRoom = 1.5;
        const MapPlace place(scene(), map);
        std::vector<Vec3> places;
        Vec3 middle(0.0);
        for (const CornerRay& ray : map.decision.rays)
            if (ray.followed) places.push_back(place.world(ray.point)), middle += places.back();
        middle /= double(places.size());
        for (Vec3& each : places) each = glm::mix(middle, each, kRoom);
        return places;
    }

    void addSearch(const FrameLog& log, const MapSnapshot& map, const View& viewing, double left) {
        addPicture(viewing.viewport(),
                   drawn(log, viewing, {"ghost"},
                         [&](const OverlayContext& context) {
                             std::vector<OverlayLines> overlays = searchOnSurface(context, map);
                             overlays.insert(overlays.begin(), greatCircles(context, map));
                             return overlays;
                         }),
                   left);
        // The corners by their numbers, beside the patch between them: the corner of the region's box may lie above or below one.
        const MapPlace place(scene(), map);
        Vec3 middle(0.0);
        for (const CornerRay& ray : map.decision.rays) middle += 0.25 * ray.point;
        const std::optional<PlotPoint> centre = placeIn(viewing, place.world(middle));
        for (size_t i = 0; i < map.decision.rays.size(); ++i) {
            const Vec3 corner = place.world(map.decision.rays[i].point);
            const std::optional<PlotPoint> at = placeIn(viewing, corner);
            if (!at || !centre || !map.decision.rays[i].followed) continue;
            addLabel(viewing, corner, {at->x > centre->x ? kNumberAside : -kNumberAside, 0.0}, std::to_string(i + 1));
        }
    }

    /// The search along the ray that passes most cells of those that hit: its R in each cell beside that of the triangles there.
    void addComparison(const MapSnapshot& map, double left, double height) {
        constexpr int kSteps = 64;
        const auto passed = [](const CornerRay& ray) { return ray.hit ? ray.walkedCells.size() : 0; };
        const auto& rays = map.decision.rays;
        const size_t number = size_t(std::ranges::max_element(rays, {}, passed) - rays.begin());
        const CornerRay& ray = rays[number];
        if (!ray.hit || !ray.span) return;
        const double unit = glm::length(ray.ray.direction);
        const auto along = [&](double t) { return unit * (t - ray.span->from); };
        // Only the end of the way is shown, where both meet.
        const double start = glm::mix(ray.hit->t, ray.span->from, kShownOfWay);
        std::vector<WalkedCell> shown;
        std::ranges::copy_if(ray.walkedCells, std::back_inserter(shown),
                             [&](const WalkedCell& walked) { return walked.span.to > start; });
        LinePlot plot;
        plot.title = m_look.say(
            {CULLSCOPE_TR("Ray %1: its R beside that of the triangles of each cell"), {Term::plain(uint64_t(number + 1))}});
        plot.x.title = wayWords(map.maps->grid(), shown);
        plot.y.title = "R";
        PlotBars cells{say(CULLSCOPE_TR("R of the triangles of a cell")), kCellBlue, {}};
        PlotBars hit{say(CULLSCOPE_TR("of the first cell with the triangle that is hit")), kHitCell, {}};
        for (const WalkedCell& walked : shown) {
            const SphericalMaps::Extent extent = map.maps->extent(map.maps->grid().number(walked.cell));
            if (extent.empty()) continue;
            (walked.hit ? hit : cells)
                .boxes.push_back(
                    {along(std::max(walked.span.from, start)), extent.farthest, along(walked.span.to), extent.nearest});
        }
        plot.bars = {std::move(cells), std::move(hit)};
        std::vector<PlotPoint> points;
        for (int i = 0; i <= kSteps; ++i) {
            const double t = glm::mix(start, ray.hit->t, double(i) / kSteps);
            points.push_back({along(t), glm::length(ray.ray.at(t))});
        }
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        plot.lines = {plainLine(say(CULLSCOPE_TR("R of the ray")), points, {dark, 2.0})};
        plot.marks = {{say(CULLSCOPE_TR("hit")), points.back(), PlotShape::Disc, {kHitRed, 2.5}, 0}};
        PlotDrawing drawing = drawPlots({plot}, kMargin + inner() - left, height, m_look.style);
        moveBy(drawing, {left, m_bottom});
        std::ranges::move(drawing.items, std::back_inserter(m_page.drawing.items));
    }

    /// Which way a ray goes over the map.
    [[nodiscard]] std::string wayWords(const SphericalGrid& grid, std::span<const WalkedCell> cells) const {
        const auto degrees = [](double angle) { return Term::name(fmt::format("{:.0f}°", angle * 180.0 / kPi)); };
        const auto theta = [&](const WalkedCell& walked) { return degrees(grid.thetaOf(walked.cell.row)); };
        const auto phi = [&](const WalkedCell& walked) { return degrees(grid.phiOf(walked.cell.column)); };
        return m_look.say({CULLSCOPE_TR("way from the sphere, its end: cells (θ, φ) = (%1, %2) to (%3, %4)"),
                           {theta(cells.front()), phi(cells.front()), theta(cells.back()), phi(cells.back())}});
    }

    void addSigns(const MapSnapshot& map, double height) {
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        std::vector<PageLegendEntry> signs{
            {{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("submitted"))},
            {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("rest of the object"))},
            {{Shape::Line, stateColour(TriangleState::Visible), 1.0}, say(CULLSCOPE_TR("bounding sphere"))},
            {{Shape::Line, dark}, say(CULLSCOPE_TR("corner ray; pale is what lies behind a surface"))},
            {{Shape::Ring, dark}, say(CULLSCOPE_TR("where it enters the sphere"))},
            {{Shape::Dot, kHitRed}, say(CULLSCOPE_TR("corner: hit"))},
            {{Shape::Dashed, kHitRed}, say(CULLSCOPE_TR("visible region, on the surface"))},
            {{Shape::Line, dark, 2.0}, say(CULLSCOPE_TR("its box, on the surface"))}};
        if (std::ranges::any_of(map.decision.rays, [](const CornerRay& ray) { return ray.followed && !ray.hit; }))
            signs.insert(signs.begin() + 6, {{Shape::Cross, dark, 2.0}, say(CULLSCOPE_TR("corner: miss, nearest point"))});
        addLegendBelow(signs, height);
    }
};

}  // namespace

Figure searchFigure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    return SearchFigure(request, look, progress).make();
}

}  // namespace cullscope::han_hong
