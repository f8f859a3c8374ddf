#include "core/experiments/han_hong_figure_page.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/experiments/han_hong_figure_data.h"
#include "core/experiments/han_hong_rows.h"
#include "core/gpu/colour.h"
#include "core/gpu/gpu_frame.h"
#include "core/image/cell_map_page.h"
#include "core/measure/accuracy.h"
#include "core/scene/camera_path.h"

namespace cullscope::han_hong {

FigurePage::FigurePage(const FigureRequest& request, const PageLook& look, const Progress& progress)
    : m_request(request),
      m_look(look),
      m_buffers(request.scene, Upload::Vbo),
      m_strategy(buildStrategy(request.strategy.id, request.strategy.parameters, request.scene, m_structures, progress)) {
    m_style.background = Vec3f(1.0f);
    m_style.surface = Vec3f(0.62f, 0.70f, 0.84f);
    m_data = figureTable(request.number, *m_strategy);
    m_page.width = request.width;
    const std::string number = m_look.say({CULLSCOPE_TR("Figure %1"), {Term::plain(uint64_t(request.number))}});
    m_bottom = addText(m_page, fmt::format("{}. {}", number, say(figureTitle(request.number))), {kMargin, kMargin}, inner(),
                       m_look.style, m_look.style.text, true) +
               6.0;
}

PlotColour FigurePage::stateColour(TriangleState state) const {
    return plotColour(verdictPalette(m_style.background)[size_t(state)].colour);
}

PageLegendEntry FigurePage::stateEntry(TriangleState state) const {
    return {{PageSign::Shape::Area, stateColour(state)}, say(triangleStateName(state))};
}

FrameLog FigurePage::frameOf(const View& culling, size_t view) {
    GpuFrame frame(m_renderer, m_buffers, culling, true);
    m_strategy->draw(frame, *m_strategy->begin());
    FrameLog log = frame.take();
    addFigureRows(m_data, view, *m_strategy, log);
    return log;
}

FrameLog FigurePage::frameOfAll(const View& culling) {
    GpuFrame frame(m_renderer, m_buffers, culling, true);
    frame.draw(everything(scene(), Facing::TwoSided));
    return frame.take();
}

View FigurePage::viewOfCase(int number) const {
    const CameraPath path = cameraPath(fmt::format("case-{}", number), scene());
    if (m_request.pose >= path.poses.size())
        throwUsage(CULLSCOPE_TR("--pose %1: the path %2 has %3 poses, counted from 0."),
                   {std::to_string(m_request.pose), path.name, std::to_string(path.poses.size())});
    return {path.camera(m_request.pose), kSmall};
}

View FigurePage::wholeView() const { return {overviewCamera(scene(), double(kLarge.width) / kLarge.height), kLarge}; }

Camera FigurePage::beside(const View& culling, double turn, double rise, double distance, double towardsEye) const {
    const Sphere& sphere = scene().boundingSphere();
    const Vec3 toEye = glm::normalize(culling.eye() - sphere.centre);
    const Vec3 upright = scene().upAxis() == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const bool along = std::abs(glm::dot(upright, toEye)) > 0.95;
    const Vec3 side = glm::normalize(glm::cross(along ? culling.camera().up : upright, toEye)), up = glm::cross(toEye, side);
    const double a = Angle::fromDegrees(turn).radians(), b = Angle::fromDegrees(rise).radians();
    Camera camera = culling.camera();
    camera.target = sphere.centre + towardsEye * (culling.eye() - sphere.centre);
    camera.eye =
        camera.target + distance * sphere.radius * (std::cos(b) * (std::cos(a) * toEye + std::sin(a) * side) + std::sin(b) * up);
    camera.up = up;
    camera.fovy = Angle::fromDegrees(35.0);
    fitDepthRange(camera, scene());
    return camera;
}

void FigurePage::requireBands(const FrameLog& log) const {
    if (const std::optional<Message> why = m_strategy->whyNotShown("bands", {}, log)) throwUsage(why->text, why->arguments);
}

std::vector<uint8_t> FigurePage::drawn(const FrameLog& log, const View& viewing, const ViewLook& look, const Overlays& more) {
    Framebuffer target(viewing.viewport());
    std::optional<TriangleStates> states;
    if (look.has(Show::Kind::Verdicts)) states = judgedStates(m_renderer, m_buffers, log, m_strategy->referenceFacing());
    drawViewPicture(m_renderer, m_buffers, *m_strategy, log, viewing, states ? &*states : nullptr, look, m_style, target);
    if (more) {
        const OverlayContext context{scene(), viewing, m_style, verdictPalette(m_style.background),
                                     contrastTo(m_style.background)};
        for (const OverlayLines& overlay : more(context))
            m_renderer.drawLines(viewing, overlay.lines, {overlay.style.width, overlay.style.depthTest}, target);
    }
    return target.readColour();
}

void FigurePage::addPicture(const Viewport& size, std::vector<uint8_t> rgba, double left) {
    m_page.pictures.push_back({{left, m_bottom}, size, std::move(rgba)});
}

void FigurePage::addLegendBelow(const std::vector<PageLegendEntry>& entries, double pictureHeight) {
    m_bottom = addLegend(m_page, entries, {kMargin, m_bottom + pictureHeight + 4.0}, inner(), m_look.style);
}

void FigurePage::addMap(const FrameLog& log, const char* colouring) {
    const CellMapPointer map = m_strategy->directionMap("index-map", log);
    if (!map)
        throwUsage(CULLSCOPE_TR("Figure %1: this frame decided nothing that could be shown."),
                   {std::to_string(m_request.number)});
    m_bottom = addCellMap(m_page, *map, colouring, {kMargin, m_bottom + 8.0}, inner(), m_style, m_look);
}

}  // namespace cullscope::han_hong
