#include "core/experiments/han_hong_figure_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/experiments/han_hong_figure_data.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/experiments/han_hong_rows.h"
#include "core/gpu/colour.h"
#include "core/gpu/gpu_frame.h"
#include "core/image/cell_map_page.h"
#include "core/measure/accuracy.h"
#include "core/scene/camera_path.h"
#include "core/visibility/overlay.h"
#include "core/visibility/spherical/map_details.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope::han_hong {
namespace {

/// A map whose cells have the states of their triangles beside the truth: of several the one that says most.
class TrueStates final : public CellMapSource {
public:
    TrueStates(std::shared_ptr<const CellMapSource> decided, const TriangleStates& truth, uint64_t firstTriangle,
               const SphericalGrid& grid)
        : m_decided(std::move(decided)), m_states(grid.cellCount()) {
        constexpr std::array kByStrength{TriangleState::InVain, TriangleState::Visible, TriangleState::WronglyCulled};
        const auto strength = [&](TriangleState state) {
            const auto place = std::ranges::find(kByStrength, state);
            return place == kByStrength.end() ? 0 : 1 + (place - kByStrength.begin());
        };
        for (uint32_t cell = 0; cell < m_states.size(); ++cell)
            for (const uint32_t triangle : m_decided->owned(cell)) {
                const TriangleState state = truth.states[firstTriangle + triangle];
                if (!m_states[cell] || strength(state) > strength(*m_states[cell])) m_states[cell] = state;
            }
    }

    [[nodiscard]] const void* key() const override { return m_decided->key(); }
    [[nodiscard]] std::span<const uint32_t> owned(uint32_t cell) const override { return m_decided->owned(cell); }
    [[nodiscard]] std::span<const uint32_t> touching(uint32_t cell) const override { return m_decided->touching(cell); }
    [[nodiscard]] SphericalGrid::Cell ownerOf(uint32_t triangle) const override { return m_decided->ownerOf(triangle); }
    [[nodiscard]] std::vector<SphericalGrid::Cell> cellsOf(uint32_t triangle) const override {
        return m_decided->cellsOf(triangle);
    }
    [[nodiscard]] MapValues values(std::string_view colouring) const override { return m_decided->values(colouring); }
    [[nodiscard]] const std::vector<std::optional<TriangleState>>& states() const override { return m_states; }
    [[nodiscard]] std::vector<Words> words(uint32_t cell) const override { return m_decided->words(cell); }

private:
    std::shared_ptr<const CellMapSource> m_decided;
    std::vector<std::optional<TriangleState>> m_states;
};

}  // namespace

FigurePage::FigurePage(const FigureRequest& request, const PageLook& look, const Progress& progress)
    : m_request(request),
      m_look(look),
      m_buffers(request.scene, Upload::Vbo),
      m_strategy(buildStrategy(request.strategy.id, request.strategy.parameters, request.scene, m_structures, progress)) {
    m_style.background = Vec3f(1.0f);
    m_style.surface = Vec3f(0.62f, 0.70f, 0.84f);
    m_data = figureTable(request.number, *m_strategy);
    m_page.width = request.width;
    m_page.scale = request.scale;
    m_style.unit = float(request.scale);
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

View FigurePage::sharp(const View& viewing) const { return {viewing.camera(), m_page.pixelsOf(viewing.viewport())}; }

FrameLog FigurePage::frameOf(const View& culling, size_t view) {
    FrameLog log = decidedOn(culling);
    addFigureRows(m_data, view, *m_strategy, log);
    return log;
}

FrameLog FigurePage::decidedOn(const View& culling) {
    GpuFrame frame(m_renderer, m_buffers, culling, true);
    m_strategy->draw(frame, *m_strategy->begin());
    return frame.take();
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

View FigurePage::fitted(Camera camera, const std::vector<Vec3>& places, const Viewport& size) const {
    constexpr double kRoom = 1.05;
    constexpr int kTurns = 4;  // turned towards the middle, a camera sees it a little elsewhere
    const bool parallel = camera.projection == ProjectionKind::Parallel;
    camera.fovy = Angle::fromDegrees(60.0);
    for (int turn = 0; turn < kTurns; ++turn) {
        const Frustum frustum = View(camera, size).frustum();
        Vec2 low(1e9), high(-1e9);
        for (const Vec3& place : places) {
            const Vec3 to = place - camera.eye;
            const double ahead = parallel ? 1.0 : glm::dot(to, frustum.forward);
            const Vec2 at = Vec2(glm::dot(to, frustum.right), glm::dot(to, frustum.up)) / ahead;
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const Vec2 middle = 0.5 * (low + high), half = 0.5 * kRoom * (high - low);
        if (parallel) {
            const Vec3 by = middle.x * frustum.right + middle.y * frustum.up;
            camera.eye += by;
            camera.target += by;
            camera.height = 2.0 * std::max(half.y, half.x * size.height / size.width);
            continue;
        }
        camera.target = camera.eye + glm::length(camera.target - camera.eye) *
                                         glm::normalize(frustum.forward + middle.x * frustum.right + middle.y * frustum.up);
        camera.fovy = Angle::fromRadians(2.0 * std::atan(std::max(half.y, half.x * size.height / size.width)));
    }
    fitDepthRange(camera, scene());
    return {camera, size};
}

std::vector<Vec3> FigurePage::wholeSphere(const Camera& camera) const {
    const Sphere& sphere = scene().boundingSphere();
    const Frustum frustum = View(camera, {1, 1}).frustum();
    std::vector<Vec3> places;
    for (const double side : {-1.0, 1.0}) {
        places.push_back(sphere.centre + side * sphere.radius * frustum.right);
        places.push_back(sphere.centre + side * sphere.radius * frustum.up);
    }
    return places;
}

void FigurePage::requireBands(const FrameLog& log) const {
    if (const std::optional<Message> why = m_strategy->whyNotShown("bands", {}, log)) throwUsage(why->text, why->arguments);
}

std::vector<uint8_t> FigurePage::drawn(const FrameLog& log, const View& given, const ViewLook& look, const Overlays& more) {
    const View viewing = sharp(given);
    Framebuffer target(viewing.viewport());
    std::optional<TriangleStates> states;
    if (look.has(Show::Kind::Verdicts)) states = statesAgainstTruth(log);
    drawViewPicture(m_renderer, m_buffers, *m_strategy, log, viewing, states ? &*states : nullptr, look, m_style, target);
    if (more) {
        const OverlayContext context{scene(), viewing, m_style, verdictPalette(m_style.background),
                                     contrastTo(m_style.background)};
        for (const OverlayLines& overlay : more(context)) drawOverlay(m_renderer, viewing, overlay, m_style, target);
    }
    return target.readColour();
}

TriangleStates FigurePage::statesAgainstTruth(const FrameLog& log) {
    return judgedStates(m_renderer, m_buffers, log, m_strategy->referenceFacing());
}

double FigurePage::markLost(const FrameLog& log, const View& given, std::vector<uint8_t>& rgba) {
    constexpr double kTint = 0.75;
    const View viewing = sharp(given);
    const Reference truth = itemBufferReference(m_renderer, m_buffers, viewing, m_strategy->referenceFacing());
    const Renderer::ItemBuffer shown = m_renderer.drawItemBuffer(m_buffers, viewing, log, {0, 0, viewing.viewport()});
    const Vec3f lost = verdictPalette(m_style.background)[size_t(TriangleState::WronglyCulled)].colour;
    uint64_t count = 0;
    for (size_t pixel = 0; pixel < truth.depth.size(); ++pixel) {
        if (pixelDifference(truth.depth[pixel], shown.depth[pixel]) != PixelDifference::Missed) continue;
        ++count;
        for (int c = 0; c < 3; ++c) {
            uint8_t& value = rgba[4 * pixel + size_t(c)];
            value = uint8_t(std::lround((1.0 - kTint) * value + kTint * 255.0 * lost[c]));
        }
    }
    return truth.coveredPixels == 0 ? 0.0 : double(count) / double(truth.coveredPixels);
}

spherical::MapSnapshot FigurePage::shownMap(const FrameLog& log) const {
    const StructureSnapshot snapshot = m_strategy->snapshot(log);
    const std::vector<spherical::MapSnapshot>& maps = spherical::mapsOf(snapshot);
    if (maps.empty()) refuse();
    return maps[spherical::placeOfMap(maps, std::nullopt)];
}

void FigurePage::refuse() const {
    throwUsage(CULLSCOPE_TR("Figure %1: this frame decided nothing that could be shown."), {std::to_string(m_request.number)});
}

void FigurePage::addWords(const Words& words) {
    m_bottom = addText(m_page, m_look.say(words), {kMargin, m_bottom}, inner(), m_look.style, m_look.style.text, true) + 4.0;
}

void FigurePage::addPicture(const Viewport& size, std::vector<uint8_t> rgba, double left) {
    m_page.pictures.push_back({{left, m_bottom}, size, std::move(rgba)});
}

void FigurePage::addLabel(const View& viewing, const Vec3& place, const Vec2& aside, const std::string& words,
                          std::optional<PlotColour> colour) {
    const std::optional<PlotPoint> at = placeIn(viewing, place);
    if (!at) return;
    const PagePicture& picture = m_page.pictures.back();
    const double left = at->x + aside.x - m_look.style.width(words) / 2;
    addPlate({picture.corner.x + left, picture.corner.y + at->y + aside.y}, words, colour);
}

void FigurePage::addPlate(const PlotPoint& from, const std::string& words, std::optional<PlotColour> colour) {
    constexpr double kAround = 2.0;
    constexpr PlotColour kGround = 0xFFFFFFFF;
    const PagePicture& picture = m_page.pictures.back();
    const PlotStyle& style = m_look.style;
    const double wide = style.width(words);
    const auto within = [](double at, double least, double room) { return std::clamp(at, least, least + std::max(room, 0.0)); };
    const double left = within(from.x, picture.corner.x, picture.size.width - wide);
    const double top = within(from.y - style.height / 2, picture.corner.y, picture.size.height - style.height);
    const double right = left + wide + kAround, bottom = top + style.height;
    m_page.drawing.items.emplace_back(
        DrawnPath{{{left - kAround, top}, {right, top}, {right, bottom}, {left - kAround, bottom}}, {}, kGround});
    m_page.text({left, top + style.ascent}, words, colour.value_or(style.text), TextAnchor::Start, true);
}

Figure FigurePage::finish() {
    m_page.height = m_bottom + kMargin;
    return {std::move(m_page), std::move(m_data)};
}

void FigurePage::addLegendBelow(const std::vector<PageLegendEntry>& entries, double pictureHeight) {
    m_bottom = addLegend(m_page, entries, {kMargin, m_bottom + pictureHeight + 4.0}, inner(), m_look.style);
}

void FigurePage::addMap(const FrameLog& log, const char* colouring, const TriangleStates* truth) {
    const CellMapPointer map = m_strategy->directionMap("index-map", log);
    if (!map) refuse();
    CellMap shown = *map;
    if (std::ranges::none_of(shown.marks, [](const MapMark& mark) { return mark.symbol == MapSymbol::Miss; }))
        std::erase_if(shown.legend, [](const MapLegendEntry& entry) { return entry.symbol == MapSymbol::Miss; });
    if (truth != nullptr)
        shown.source = std::make_shared<TrueStates>(map->source, *truth, scene().firstTriangle(map->object), map->grid);
    // A page has room for every circle.
    if (shown.circles) {
        shown.circles->every = 1;
        for (MapLegendEntry& entry : shown.legend)
            if (entry.symbol == MapSymbol::Circle) entry.words.terms = {Term::angle(shown.circles->width)};
    }
    m_bottom = addCellMap(m_page, shown, colouring, {kMargin, m_bottom + 8.0}, inner(), m_style, m_look);
}

}  // namespace cullscope::han_hong
