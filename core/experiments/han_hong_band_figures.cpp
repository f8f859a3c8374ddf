#include "core/experiments/han_hong_band_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/experiments/han_hong_band_lines.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;
using spherical::ContourBands;
using spherical::MapPlace;
using spherical::MapSnapshot;

constexpr double kBesideBands = 8.0;  ///< between pictures beside each other
constexpr double kAboveAxis = 1.2;    ///< radii; how far up a picture with the perpendicular axis reaches

class BandFigures : private FigurePage {
public:
    BandFigures(const FigureRequest& request, const PageLook& look, const Progress& progress)
        : FigurePage(request, look, progress), m_culling(wholeView()), m_log(frameOf(m_culling, 1)) {
        requireBands(m_log);
        m_map = shownMap(m_log);
        const Vec3 upright = scene().upAxis() == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
        const MapPlace place(scene(), *m_map);
        m_sector = tellingSector(bands(), glm::normalize(glm::transpose(place.linear()) * upright));
    }

    [[nodiscard]] Figure make() {
        const std::array draw{&BandFigures::sampling, &BandFigures::sizes, &BandFigures::hidden, &BandFigures::frontAndBack};
        (this->*draw[size_t(m_request.number - 5)])();
        return finish();
    }

private:
    [[nodiscard]] const ContourBands& bands() const { return *m_map->decision.bands; }

    /// The one camera of Figures 5 to 8, a parallel one: the axis across the picture with the eye to the right, S upward; far
    /// beyond 90°, where S decides, the surface is turned towards it.
    [[nodiscard]] View observer(const Viewport& size, double above = kAboveAxis) const {
        constexpr double kAway = 4.4, kRise = 0.2;  // radii; share of the distance
        const Angle behind = Angle::fromDegrees(22.0);
        const Mat3 world = MapPlace(scene(), *m_map).linear();
        const Vec3 axis = glm::normalize(world * bands().axis);
        const Vec3 outward = glm::normalize(world * directionInSector(kRightAngle));
        const Vec3 across = std::cos(behind.radians()) * glm::cross(axis, outward) - std::sin(behind.radians()) * axis;
        Camera camera = m_culling.camera();
        const Sphere sphere = scene().instanceSphere(m_map->decision.instance);
        camera.target = sphere.centre;
        camera.eye = sphere.centre + kAway * sphere.radius * glm::normalize(across + kRise * outward);
        camera.up = outward;
        camera.projection = ProjectionKind::Parallel;
        std::vector<Vec3> places = wholeSphere(camera);
        places.push_back(sphere.centre + above * sphere.radius * outward);
        return fitted(camera, places, size);
    }
    /// In the middle of the sector that Figures 5 to 8 look at, in the mesh's coordinates.
    [[nodiscard]] Vec3 directionInSector(double alpha) const {
        return bands().direction(alpha, (m_sector + 0.5) * kTurn / bands().sectors);
    }

    /// Adds a sentence, and goes on below it.
    void addSentence(const char* text) {
        constexpr double kBelow = 4.0;
        m_bottom = addText(m_page, say(text), {kMargin, m_bottom}, inner(), m_look.style, m_look.style.text) + kBelow;
    }
    void addCameraWords() {
        addSentence(
            CULLSCOPE_TR("Seen by one camera in Figures 5 to 7: beside the sight ray, which comes from the right, "
                         "and a little from behind."));
    }
    void addAngleWords() {
        addSentence(
            CULLSCOPE_TR("α is the angle from the sight ray, seen from the middle of the sphere: the paper's near half, up to "
                         "180° across, has α up to 90°."));
    }

    [[nodiscard]] PageLegendEntry backSign() const {
        return {{Shape::Area, plotColour(backColour(m_style.background))}, say(CULLSCOPE_TR("back sides of what is drawn"))};
    }

    void sampling() {
        addCameraWords();
        addAngleWords();
        const Viewport size = pictureSize();
        // All of the object: here it is sampled, and what is hidden is left out later.
        addPicture(size, drawn(frameOfAll(m_culling), observer(size), {},
                               [&](const OverlayContext& context) { return spherical::bandOverlay(context, {*m_map}); }));
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        addLegendBelow(
            {{{Shape::Line, stateColour(TriangleState::Visible), 1.0},
              say(CULLSCOPE_TR("where a band begins that is drawn, by sector"))},
             {{Shape::Line, stateColour(TriangleState::Hidden), 1.0},
              say(CULLSCOPE_TR("where a band begins that is hidden, by sector"))},
             {{Shape::Line, dark, 2.5}, "α = 90°"},
             {{Shape::Line, dark, 1.5}, say(CULLSCOPE_TR("sight ray through the middle of the sphere, seen through the object"))},
             {{Shape::Dot, dark}, say(CULLSCOPE_TR("nearest to the eye"))},
             {{Shape::Ring, dark}, say(CULLSCOPE_TR("opposite"))}},
            size.height);
        addMap(m_log, "entries");
    }

    void sizes() {
        addWords({CULLSCOPE_TR("S of the bands of %1 in one sector"), {Term::angle(bands().width)}});
        addCameraWords();
        const Viewport size = pictureSize();
        const View viewing = observer(size);
        const std::vector<spherical::SizePlace> sizes = spherical::sizePlaces(*m_map, m_sector);
        const std::optional<Projection> projection = projectionOf(scene(), *m_map, sizes);
        addPicture(size, drawn(m_log, viewing, {"ghost", "back-sides"}, [&](const OverlayContext& context) {
                       std::vector<OverlayLines> overlays = spherical::sizeOverlay(context, {*m_map}, m_sector);
                       if (projection) std::ranges::move(projectionLines(context, *projection), std::back_inserter(overlays));
                       return overlays;
                   }));
        if (projection) addProjectionLabels(viewing, *projection);
        addBandNumbers(viewing, sizes);
        addSizeSigns(sizes, size.height);
    }

    void addProjectionLabels(const View& viewing, const Projection& projection) {
        addLabel(viewing, projection.origin, {-12.0, 12.0}, "O");
        addLabel(viewing, 0.5 * (projection.origin + projection.place), {14.0, 4.0}, "R");
        addLabel(viewing, projection.arc[projection.arc.size() / 3], {0.0, -12.0}, "α");
        addLabel(viewing, projection.top, {0.0, -10.0}, say(CULLSCOPE_TR("perpendicular axis")));
        // Beside the upper end of its length, where no bar of a band stands.
        addLabel(viewing, glm::mix(projection.origin, projection.onPerpendicular, 0.94), {54.0, 4.0}, "S = R · sin α",
                 plotColour(spherical::sizeColour(m_style.background)));
        addLabel(viewing, projection.start, {0.0, 16.0}, say(CULLSCOPE_TR("to the eye")));
    }

    /// Beyond the sphere, where each band lies; that of the largest S beyond its letter.
    void addBandNumbers(const View& viewing, const std::vector<spherical::SizePlace>& sizes) {
        constexpr double kBeyond = 1.05, kBeyondLetter = 1.22;  // radii
        const auto largest =
            std::ranges::max_element(sizes, {}, [](const spherical::SizePlace& size) { return size.larger ? 0.0 : size.size; });
        const MapPlace place(scene(), *m_map);
        for (const spherical::SizePlace& size : sizes) {
            const double beyond = size.band == largest->band ? kBeyondLetter : kBeyond;
            addLabel(viewing,
                     place.world(beyond * m_map->maps.sphere().radius * directionInSector((size.band + 0.5) * bands().width)),
                     Vec2(0.0), std::to_string(size.band + 1));
        }
    }

    void addSizeSigns(const std::vector<spherical::SizePlace>& sizes, double height) {
        const PlotColour green = plotColour(spherical::sizeColour(m_style.background));
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        std::vector<PageLegendEntry> entries{
            {{Shape::Letter, green}, say(CULLSCOPE_TR("the largest S: from the sight ray through O to a triangle's centroid"))},
            {{Shape::Line, green, 2.0}, say(CULLSCOPE_TR("S of a band that is drawn, at its own triangle"))},
            {{Shape::Dashed, green, 2.0}, say(CULLSCOPE_TR("S of a band that is hidden"))},
            {{Shape::Dashed, green, 1.0},
             say(CULLSCOPE_TR(
                 "level of the largest S: beyond α = 90°, bands farther from the eye that stay below it are hidden"))},
            {{Shape::Line, green, 1.0},
             say(CULLSCOPE_TR("edges of the sector and its bands, numbered from the eye; without triangles a band has no S"))},
            {{Shape::Line, plotColour(projectionColour()), 2.0}, say(CULLSCOPE_TR("R of the largest S, from the origin O"))},
            {{Shape::Dashed, plotColour(projectionColour()), 1.5},
             say(CULLSCOPE_TR("its projection on the perpendicular axis, where S is as long"))},
            {{Shape::Dot, dark}, say(CULLSCOPE_TR("nearest to the eye"))},
            {{Shape::Ring, dark}, say(CULLSCOPE_TR("opposite"))},
            {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("what is not drawn"))},
            backSign()};
        if (std::ranges::any_of(sizes, &spherical::SizePlace::larger))
            entries.insert(entries.begin() + 3, {{Shape::Dashed, stateColour(TriangleState::WronglyCulled), 2.0},
                                                 say(CULLSCOPE_TR("hidden for good by a nearer band, though its S is larger"))});
        addLegendBelow(entries, height);
    }

    void hidden() {
        addCameraWords();
        addAngleWords();
        const Viewport size = pictureSize();
        std::vector<uint8_t> picture = drawn(m_log, observer(size), {"verdicts"});
        shadeBands(observer(size), picture);
        addPicture(size, std::move(picture));
        m_bottom += size.height;
        addSentence(CULLSCOPE_TR(
            "On the object the second, fourth, … band from the eye is darker; what is wrongly culled has an outline."));
        const TriangleStates states = statesAgainstTruth(m_log);
        addMap(m_log, "state", &states);
        addSentence(
            CULLSCOPE_TR("Drawn in vain: drawn, but in no pixel of the picture from the eye. White cells: no triangle has its "
                         "centroid there."));
    }

    /// Three pictures: the paper's two, from the eye and from the opposite side, and from the side, which shows that the surface
    /// is an open shell.
    void frontAndBack() {
        if (const CellMapPointer map = strategy().directionMap("index-map", m_log)) addWords(map->decisionWords);
        const int third = int(inner() - 2 * kBesideBands) / 3;
        const Viewport size{third, third};
        const Vec3& centre = scene().boundingSphere().centre;
        const Camera front = m_culling.camera();
        Camera behind = front;
        behind.eye = 2.0 * centre - front.eye;
        behind.target = 2.0 * centre - front.target;
        const View eye = fitted(front, wholeSphere(front), size), opposite = fitted(behind, wholeSphere(behind), size);
        const View side = observer(size, 1.0);

        std::vector<uint8_t> seen = drawn(m_log, eye, {"back-sides"});
        const double lost = markLost(m_log, eye, seen);
        const auto rim = [&](const OverlayContext& context) { return std::vector{rimOf(context, m_log)}; };
        std::vector<uint8_t> back = drawn(m_log, opposite, {"back-sides"}, rim);
        darkenHollow(m_log, opposite, back);
        std::vector<uint8_t> beside = drawn(m_log, side, {"back-sides", "ghost"}, rim);
        darkenHollow(m_log, side, beside);
        addPictures(size, {{std::move(seen), CULLSCOPE_TR("front: from the eye")},
                           {std::move(back), CULLSCOPE_TR("back: from the opposite side, into the hollow shell")},
                           {std::move(beside), CULLSCOPE_TR("from the side, as in Figures 5 to 7, with what is left out")}});
        const PlotColour dark = plotColour(contrastTo(m_style.background));
        addLegendBelow(
            {{{Shape::Area, plotColour(m_style.surface)}, say(CULLSCOPE_TR("front sides of what is drawn"))},
             {{Shape::Area, plotColour(backColour(m_style.background))},
              say(CULLSCOPE_TR("its back sides, seen from within: the darker, the deeper in the hollow"))},
             {{Shape::Line, dark, 1.5}, say(CULLSCOPE_TR("rim of what is drawn: there the shell ends"))},
             {{Shape::Area, plotColour(ghostColour(m_style))}, say(CULLSCOPE_TR("what is not drawn"))},
             {{Shape::Area, stateColour(TriangleState::WronglyCulled)},
              m_look.say({CULLSCOPE_TR("wrongly culled: visible, but hidden by S: %1 of the pixels that the object covers"),
                          {Term::share(lost)}})}},
            0.0);
    }

    struct NamedPicture {
        std::vector<uint8_t> rgba;
        const char* name = "";
    };
    /// Pictures beside each other with their names below.
    void addPictures(const Viewport& size, std::vector<NamedPicture> pictures) {
        double left = kMargin, below = m_bottom;
        for (NamedPicture& picture : pictures) {
            addPicture(size, std::move(picture.rgba), left);
            below = std::max(below, addText(m_page, say(picture.name), {left, m_bottom + size.height + 2.0}, size.width,
                                            m_look.style, m_look.style.text));
            left += size.width + kBesideBands;
        }
        m_bottom = below + 6.0;
    }

    /// Tells each pixel that a frame's triangles cover: its number, its place in the world and its triangle's corners there.
    template <typename Told>
    void tellPixels(const FrameLog& log, const View& given, const Told& told) {
        const View viewing = sharp(given);
        const Renderer::ItemBuffer shown = m_renderer.drawItemBuffer(m_buffers, viewing, log, {0, 0, viewing.viewport()});
        const auto width = size_t(viewing.viewport().width);
        for (size_t pixel = 0; pixel < shown.triangle.size(); ++pixel) {
            if (shown.triangle[pixel] == 0) continue;
            const double x = double(pixel % width) + 0.5, y = double(pixel / width) + 0.5;
            const Vec3 place = viewing.pointAt(x, y, viewing.distanceFromDepth(shown.depth[pixel]));
            told(pixel, place, viewing.direction(x, y), cornersInWorld(scene(), shown.triangle[pixel] - 1));
        }
    }
    static void darken(std::vector<uint8_t>& rgba, size_t pixel, double share) {
        for (size_t c = 0; c < 3; ++c) rgba[4 * pixel + c] = uint8_t(std::lround(share * rgba[4 * pixel + c]));
    }

    /// The contours on the object without lines across it.
    void shadeBands(const View& given, std::vector<uint8_t>& rgba) {
        const MapPlace map(scene(), *m_map);
        tellPixels(frameOfAll(m_culling), given, [&](size_t pixel, const Vec3& place, const Vec3&, const std::array<Vec3, 3>&) {
            darken(rgba, pixel, lightnessOfBand(bands(), map.local(place)));
        });
    }

    /// Makes back sides the darker, the deeper they lie in the hollow, seen from where it opens: evenly lit, a hollow looks like
    /// a body.
    void darkenHollow(const FrameLog& log, const View& given, std::vector<uint8_t>& rgba) {
        constexpr double kDarkest = 0.4;
        const Vec3 origin = MapPlace(scene(), *m_map).world(Vec3(0.0));
        const Vec3 axis = glm::normalize(MapPlace(scene(), *m_map).linear() * bands().axis);
        std::vector<double> depths(rgba.size() / 4, 0.0);
        tellPixels(log, given, [&](size_t pixel, const Vec3& place, const Vec3& sight, const std::array<Vec3, 3>& corners) {
            const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            if (glm::dot(normal, sight) > 0.0) depths[pixel] = std::max(glm::dot(place - origin, axis), 0.0);
        });
        const double deepest = std::ranges::max(depths);
        for (size_t pixel = 0; pixel < depths.size() && deepest > 0.0; ++pixel)
            if (depths[pixel] > 0.0) darken(rgba, pixel, glm::mix(1.0, kDarkest, depths[pixel] / deepest));
    }

    View m_culling;
    FrameLog m_log;
    std::optional<MapSnapshot> m_map;
    uint32_t m_sector = 0;
};

}  // namespace

Figure bandFigure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    return BandFigures(request, look, progress).make();
}

}  // namespace cullscope::han_hong
