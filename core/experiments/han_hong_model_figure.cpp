#include "core/experiments/han_hong_model_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/experiments/han_hong_figure_data.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/experiments/han_hong_figure_page.h"
#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/image/spherical_model.h"
#include "core/scene/scene_rays.h"

namespace cullscope::han_hong {
namespace {

using Shape = PageSign::Shape;

// Of P and R, θ, φ, and the foot of P in the plane of x and y.
constexpr uint32_t kRadiusRed = 0xDB1414, kThetaBlue = 0x1450C8, kPhiGreen = 0x0B7A3B, kFootGrey = 0x606060;
constexpr PlotColour opaque(uint32_t colour) { return 0xFF000000 | colour; }
// Shares of the bounding sphere's radius.
constexpr double kModelAxis = 1.3, kModelArrow = 0.05, kModelArc = 0.3, kFootDash = 0.04;
constexpr double kPointRadius = 4.0;                     // in units
constexpr float kModelLine = 2.0f, kBehindShare = 0.6f;  // of what lies behind the surface, the background's share

class ModelFigure : private FigurePage {
public:
    ModelFigure(const FigureRequest& request, const PageLook& look, const Progress& progress)
        : FigurePage(request, look, progress), m_log(frameOfAll(wholeView())) {
        const uint32_t instance = sphericalModelInstance(drawnTriangles(scene(), m_log)).value_or(0);
        const TriangleMesh& mesh = scene().meshOf(instance);
        m_sphere = mesh.localSphere();
        m_worldFromMesh = scene().instances()[instance].worldFromMesh;
        m_centre = mesh.origin() + m_sphere.centre;
        m_point = farthestSeen(mesh);
    }

    [[nodiscard]] Figure make() {
        addObject();
        addModel();
        std::vector<PageLegendEntry> entries;
        entries.push_back({{Shape::Line, opaque(kThetaBlue), 2.0}, say(CULLSCOPE_TR("θ, zenith angle from the z axis"))});
        entries.push_back(
            {{Shape::Line, opaque(kPhiGreen), 2.0}, say(CULLSCOPE_TR("φ, azimuth from the x axis to the foot of P"))});
        entries.push_back({{Shape::Dashed, opaque(kFootGrey), 1.5}, say(CULLSCOPE_TR("foot of P in the plane of x and y"))});
        entries.push_back({{Shape::Dot, opaque(kRadiusRed)}, m_look.say({CULLSCOPE_TR("the same point P in both"), {}})});
        m_bottom = addText(
            m_page,
            say(CULLSCOPE_TR("Above, lines within the object are pale. The map shows the outermost surface in each direction "
                             "from O, lit as a relief: slopes are darker than the scale.")),
            {kMargin, m_bottom + 4.0}, inner(), m_look.style, m_look.style.text);
        m_bottom = addScale(m_page, {"R = 0", fmt::format("{:.2f}", scene().boundingSphere().radius), {}, reliefColour},
                            {kMargin, m_bottom}, m_look.style);
        addLegendBelow(entries, 0.0);
        const SphericalPoint point = sphericalPoint(m_point);
        const spherical::MapSnapshot map = shownMap(decidedOn(wholeView()));
        m_data.addRow({{"view", 1.0},
                       {"object", double(map.decision.instance)},
                       {"kind", std::string("point")},
                       {"r", point.radius},
                       {"theta", point.theta * 180.0 / kPi},
                       {"phi", point.phi * 180.0 / kPi}});
        addCellRows(m_data, map.decision.instance, *map.maps);
        return finish();
    }

private:
    [[nodiscard]] Vec3 world(const Vec3& place) const { return Vec3(m_worldFromMesh * Vec4(m_centre + place, 1.0)); }

    /// Of the vertices that the camera sees the one farthest from the origin, relative to it.
    [[nodiscard]] Vec3 farthestSeen(const TriangleMesh& mesh) const {
        constexpr size_t kMost = 5000;
        constexpr double kAtPlace = 0.999;  // share of the way at which the vertex' own triangles begin
        const auto place = [&](uint32_t vertex) { return Vec3(mesh.positions()[vertex]) - m_sphere.centre; };
        std::vector<uint32_t> vertices(mesh.positions().size());
        std::iota(vertices.begin(), vertices.end(), 0U);
        const size_t count = std::min(kMost, vertices.size());
        std::ranges::partial_sort(vertices, vertices.begin() + std::ptrdiff_t(count), std::greater(),
                                  [&](uint32_t vertex) { return glm::length(place(vertex)); });
        const SceneRays rays(scene(), scene().boundingSphere().centre);
        const Vec3 eye = wholeView().eye();
        for (size_t i = 0; i < count; ++i)
            if (!rays.first(eye, world(place(vertices[i])) - eye, 0.0, kAtPlace)) return place(vertices[i]);
        return place(vertices.front());
    }

    void addObject() {
        const Viewport size = pictureSize();
        const double radius = m_sphere.radius;
        std::vector<Vec3> places = wholeSphere(wholeView().camera());
        for (int axis = 0; axis < 3; ++axis) places.push_back(world(axisEnd(axis)));
        // In a parallel picture what is parallel to an axis looks so.
        const View view = fitted(inParallel(wholeView().camera()), places, size);
        addPicture(size, drawn(m_log, view, {}, [&](const OverlayContext& context) { return coordinateLines(context); }));
        static constexpr std::array kNames{"x, φ = 0°", "y, φ = 90°", "z, θ = 0°"};
        for (int axis = 0; axis < 3; ++axis) addAxisName(view, world(axisEnd(axis)), kNames[size_t(axis)]);
        const double theta = std::acos(m_point.z / glm::length(m_point)), phi = std::atan2(m_point.y, m_point.x);
        addLabel(view, world(Vec3(0.0)), {-12.0, 12.0}, "O");
        addLabel(view, world(0.62 * m_point), {14.0, 8.0}, "R", opaque(kRadiusRed));
        addLabel(view, world(kModelArc * radius * onThetaArc(theta / 2, phi)), {-14.0, 4.0}, "θ", opaque(kThetaBlue));
        addLabel(view, world(kModelArc * radius * onThetaArc(kRightAngle, phi / 2)), {10.0, -14.0}, "φ", opaque(kPhiGreen));
        addLabel(view, world(m_point), {0.0, -16.0}, "P", opaque(kRadiusRed));
        m_bottom += size.height + 4.0;
    }
    /// Beyond the axis' arrow.
    void addAxisName(const View& view, const Vec3& end, const std::string& name) {
        constexpr double kBeyond = 17.0;
        const std::optional<PlotPoint> from = placeIn(view, world(Vec3(0.0))), to = placeIn(view, end);
        if (!from || !to) return;
        const Vec2 way = glm::normalize(Vec2(to->x - from->x, to->y - from->y));
        addLabel(view, end, kBeyond * way + Vec2(way.x * m_look.style.width(name) / 2, 0.0), name);
    }
    [[nodiscard]] Vec3 axisEnd(int axis) const {
        Vec3 end(0.0);
        end[axis] = kModelAxis * m_sphere.radius;
        return end;
    }
    [[nodiscard]] static Vec3 onThetaArc(double theta, double phi) {
        return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    }

    /// The axes from the origin, R to the point, θ from the z axis, φ from the x axis to the point's foot in the plane of x and
    /// y: pale where the surface hides them.
    [[nodiscard]] std::vector<OverlayLines> coordinateLines(const OverlayContext& context) const {
        constexpr int kPieces = 24;
        const double radius = m_sphere.radius;
        std::vector<LineSegment> lines;
        const auto add = [&](const Vec3& from, const Vec3& to, const Vec3f& colour) {
            lines.push_back({world(from), world(to), colour});
        };
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 end = axisEnd(axis);
            Vec3 aside(0.0);
            aside[(axis + 1) % 3] = 0.4 * kModelArrow * radius;
            add(Vec3(0.0), end, context.contrast);
            for (const double side : {-1.0, 1.0}) add(end, (1.0 - kModelArrow) * end + side * aside, context.contrast);
        }
        const Vec3f red = colourFromHexadecimal(kRadiusRed), blue = colourFromHexadecimal(kThetaBlue);
        const Vec3f green = colourFromHexadecimal(kPhiGreen), grey = colourFromHexadecimal(kFootGrey);
        const double theta = std::acos(m_point.z / glm::length(m_point)), phi = std::atan2(m_point.y, m_point.x);
        for (int i = 0; i < kPieces; ++i) {
            const double from = double(i) / kPieces, to = double(i + 1) / kPieces;
            add(kModelArc * radius * onThetaArc(theta * from, phi), kModelArc * radius * onThetaArc(theta * to, phi), blue);
            add(kModelArc * radius * onThetaArc(kRightAngle, phi * from), kModelArc * radius * onThetaArc(kRightAngle, phi * to),
                green);
        }
        add(Vec3(0.0), m_point, red);
        const Vec3 foot(m_point.x, m_point.y, 0.0);
        for (const auto& [start, end] : {std::pair(Vec3(0.0), foot), std::pair(foot, m_point)}) {
            const int dashes = std::max(1, int(glm::length(end - start) / (2.0 * kFootDash * radius)));
            for (int i = 0; i < dashes; ++i)
                add(glm::mix(start, end, double(i) / dashes), glm::mix(start, end, (i + 0.6) / dashes), grey);
        }
        OverlayLines behind{lines, {kModelLine, false}}, before{std::move(lines), {kModelLine, true}, true},
            point{{}, {kModelLine, false}, true};
        for (LineSegment& line : behind.lines) line.colour = glm::mix(line.colour, context.style.background, kBehindShare);
        addMark(point.lines, context, world(m_point), kPointRadius, MarkShape::Dot, red);
        addMark(point.lines, context, world(Vec3(0.0)), 0.7 * kPointRadius, MarkShape::Dot, context.contrast);
        return {std::move(behind), std::move(before), std::move(point)};
    }

    void addModel() {
        constexpr double kAxisName = 75.0;  // degrees; between the numbers of two ticks
        const Viewport size{int(inner()), int(inner()) / 2 + 40};
        const View view = sharp({wholeView().camera(), size});
        Framebuffer target(view.viewport());
        drawSphericalModel(m_renderer, m_buffers, view, drawnTriangles(scene(), m_log), m_style, target);
        addPicture(size, target.readColour());
        MapArea area = sphericalModelArea(view.viewport(), m_style);
        for (double* length : {&area.left, &area.bottom, &area.width, &area.height}) *length /= m_page.scale;
        const PlotStyle& style = m_look.style;
        const double left = kMargin + area.left, bottom = m_bottom + size.height - area.bottom, top = bottom - area.height;
        for (int degrees = 0; degrees <= 360; degrees += 30)
            m_page.text({left + area.width * degrees / 360.0, bottom + 6.0 + style.ascent}, fmt::format("{}°", degrees),
                        style.text, TextAnchor::Middle);
        for (int degrees = 0; degrees <= 180; degrees += 30)
            m_page.text({left - 8.0, top + area.height * degrees / 180.0 + style.ascent - style.height / 2},
                        fmt::format("{}°", degrees), style.text, TextAnchor::End);
        m_page.text({left + area.width / 2, bottom + 6.0 + style.height + style.ascent}, "φ", opaque(kPhiGreen),
                    TextAnchor::Middle, true);
        m_page.text({kMargin, top + area.height * kAxisName / 180.0}, "θ", opaque(kThetaBlue), TextAnchor::Start, true);
        addPoint(left, top, area);
        m_bottom += size.height;
    }
    void addPoint(double left, double top, const MapArea& area) {
        constexpr double kAside = 10.0, kCasing = 1.5;
        const double radius = glm::length(m_point), theta = std::acos(m_point.z / radius);
        double phi = std::atan2(m_point.y, m_point.x);
        if (phi < 0.0) phi += kTurn;
        const PlotPoint at{left + area.width * phi / kTurn, top + area.height * theta / kPi};
        m_page.drawing.items.emplace_back(DrawnDisc{at, kPointRadius + kCasing, {}, 0xFFFFFFFF});
        m_page.drawing.items.emplace_back(DrawnDisc{at, kPointRadius, {}, opaque(kRadiusRed)});
        const std::string words =
            fmt::format("P: R = {:.2f}, θ = {:.0f}°, φ = {:.0f}°", radius, theta * 180.0 / kPi, phi * 180.0 / kPi);
        addPlate({at.x + kAside, at.y}, words);
    }

    FrameLog m_log;
    Sphere m_sphere;
    Mat4 m_worldFromMesh{1.0};
    Vec3 m_centre{0.0}, m_point{0.0};
};

}  // namespace

Figure modelFigure(const FigureRequest& request, const PageLook& look, const Progress& progress) {
    return ModelFigure(request, look, progress).make();
}

}  // namespace cullscope::han_hong
