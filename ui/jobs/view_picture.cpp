#include "ui/jobs/view_picture.h"

#include <QRgb>
#include <algorithm>
#include <chrono>
#include <limits>
#include <set>

#include "core/image/spherical_model.h"
#include "core/image/view_picture.h"
#include "core/scene/camera_moves.h"
#include "ui/jobs/picture_tiles.h"

namespace cullscope::ui {

namespace {

constexpr int kMarkReach = 2;  // marks of 5 × 5 pixels, so that one pixel in 300,000 can be seen
constexpr QRgb kAddedColour = 0xff1b6b2a, kSnappedColour = 0xffb07a00;

QRgb missedColour(const DrawStyle& style) {
    const Vec3f colour = verdictPalette(style.background)[size_t(TriangleState::WronglyCulled)].colour;
    return qRgb(int(std::lround(colour.x * 255.0f)), int(std::lround(colour.y * 255.0f)), int(std::lround(colour.z * 255.0f)));
}

void grow(QImage& marks, int x, int y, int reach, QRgb colour) {
    const int left = std::max(0, x - reach), right = std::min(marks.width() - 1, x + reach);
    for (int row = std::max(0, y - reach); row <= std::min(marks.height() - 1, y + reach); ++row) {
        auto* pixels = reinterpret_cast<QRgb*>(marks.scanLine(row));
        std::fill(pixels + left, pixels + right + 1, colour);
    }
}

/// Marks what `colour` shows farther away or nearer than `other`; the lost ones lie on top.
void markDifferences(ViewPicture& picture, const std::vector<PixelDifference>& differences, int reach) {
    const Viewport& size = picture.request.size;
    picture.marks = newImage(size, QImage::Format_ARGB32_Premultiplied);
    picture.marks.fill(Qt::transparent);
    const QRgb missed = missedColour(picture.request.style);
    const auto& lost = picture.request.lost;
    const auto isLost = [&](size_t pixel) { return !lost || std::ranges::binary_search(*lost, uint32_t(pixel)); };
    const auto mark = [&](uint64_t& count, QRgb colour, const auto& marked) {
        for (size_t i = 0; i < differences.size(); ++i) {
            if (!marked(i)) continue;
            ++count;
            grow(picture.marks, int(i % size_t(size.width)), size.height - 1 - int(i / size_t(size.width)), reach, colour);
        }
    };
    const auto misses = [&](size_t i) { return differences[i] == PixelDifference::Missed; };
    uint64_t lostOnes = 0;
    mark(picture.added, kAddedColour, [&](size_t i) { return differences[i] == PixelDifference::Extra; });
    mark(picture.withinSnapping, kSnappedColour, [&](size_t i) { return misses(i) && !isLost(i); });
    mark(lostOnes, missed, [&](size_t i) { return misses(i) && isLost(i); });
    picture.missed = lostOnes + picture.withinSnapping;
}

}  // namespace

namespace {

/// What a request shows of its frame.
ViewFramePointer shownFrame(const ViewRequest& request, const ViewFramePointer& frame) {
    if (!request.unanswered) return frameUpTo(frame, request.upTo);
    auto all = std::make_shared<ViewFrame>(ViewFrame{frame->request, frame->log.upTo(0)});
    all->log.facing = request.strategy->referenceFacing();
    all->log.commands = {everything(request.buffers->scene(), all->log.facing)};
    return all;
}

}  // namespace

namespace {

/// How long OpenGL takes with it.
template <typename Draw>
double millisecondsOf(const Draw& draw) {
    const auto start = std::chrono::steady_clock::now();
    draw();
    waitForGpu();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

View ViewRequest::shownView() const {
    View view(viewing, size);
    if (section) view.cutBy(sectionPlane(*section, buffers->scene().bounds(), culling));
    return view;
}

QColor addedPixelColour() { return QColor::fromRgb(kAddedColour); }
QColor snappedPixelColour() { return QColor::fromRgb(kSnappedColour); }

Framebuffer& ViewPictureDrawer::target(const Viewport& size) {
    if (!m_framebuffer || !(m_framebuffer->size() == size)) m_framebuffer = std::make_unique<Framebuffer>(size);
    return *m_framebuffer;
}

void ViewPictureDrawer::letGo() {
    m_framebuffer.reset();
    m_frames->forget();
}

PictureDrawing::PictureDrawing(const ViewRequest& request, const ViewFramePointer& frame, ViewFramePointer other)
    : m_picture(std::make_shared<ViewPicture>()), m_viewing(request.shownView()), m_states(request.states) {
    m_picture->request = request;
    m_picture->frame = shownFrame(request, frame);
    if (request.upTo && !request.unanswered && !request.look.has(Show::Kind::Verdicts) && !request.look.inPlace())
        m_ahead = request.strategy->decidedAhead(frame->log, entriesUpTo(*frame, *request.upTo));
    if (!m_ahead.ranges.empty()) m_picture->ahead = newImage(request.size, QImage::Format_RGBA8888);
    const Scene& scene = request.buffers->scene();
    m_picture->consideredTriangles = log().consideredTriangles();
    if (request.look.has(Show::Kind::Planes)) m_picture->planes = countByPlane(request.strategy->snapshot(log()));
    m_picture->partOfModel = request.look.has(Show::Kind::Model) && !hasWholeModel(scene, drawnTriangles(scene, log()));
    if (request.look.has(Show::Kind::Verdicts) && !m_states)
        m_states = std::make_shared<const TriangleStates>(triangleStates(scene, log(), std::nullopt));
    const size_t pixels = size_t(request.size.width) * size_t(request.size.height);
    m_picture->colour = newImage(request.size, QImage::Format_RGBA8888);
    m_picture->depth.resize(pixels);
    if (request.wipe == Wipe::Mode::Truth || request.wipe == Wipe::Mode::Loss)
        m_truth = everything(scene, request.strategy->referenceFacing());
    else if (request.wipe != Wipe::Mode::None)
        m_picture->otherFrame = m_other = std::move(other);
    if (!m_truth && !m_other) return;
    m_picture->other = newImage(request.size, QImage::Format_RGBA8888);
    m_differences.resize(pixels);
}

void PictureDrawing::draw(Renderer& renderer, Framebuffer& target) {
    const ViewRequest& request = m_picture->request;
    m_milliseconds += millisecondsOf([&] {
        drawViewPicture(renderer, *request.buffers, *request.strategy, log(), m_viewing, m_states.get(), request.look,
                        request.style, target);
    });
    copyTile(target.readColour(), target.tile(), m_picture->colour);
    copyTile(target.readDepth(), target.tile(), m_picture->depth, request.size.width);
    if (m_truth || m_other) drawBeside(renderer, target);
    if (!m_ahead.ranges.empty()) drawAhead(renderer, target);
}

void PictureDrawing::drawAhead(Renderer& renderer, Framebuffer& target) {
    DrawStyle style = m_picture->request.style;
    style.backgroundAlpha = 0.0f;
    renderer.draw(*m_picture->request.buffers, m_viewing, m_ahead, target, style);
    copyTile(target.readColour(), target.tile(), m_picture->ahead);
}

void PictureDrawing::drawBeside(Renderer& renderer, Framebuffer& target) {
    const ViewRequest& request = m_picture->request;
    // Overlay lines and the culled triangles of a verdict view have depths of their own: compare a plain replay of the frame.
    if (!(request.look == ViewLook{})) renderer.draw(*request.buffers, m_viewing, log(), target, request.style);
    const std::vector<float> mine = target.readDepth();
    if (m_truth)
        renderer.draw(*request.buffers, m_viewing, *m_truth, target, request.style);
    else
        renderer.draw(*request.buffers, m_viewing, m_other->log, target, request.style);
    copyTile(target.readColour(), target.tile(), m_picture->other);
    const std::vector<float> other = target.readDepth();
    std::vector<PixelDifference> differences(mine.size());
    for (size_t i = 0; i < mine.size(); ++i) differences[i] = pixelDifference(other[i], mine[i]);
    if (!log().drawsScene() || (m_other && !m_other->log.drawsScene()))
        compareTriangles(differences, mine, other, renderer, target.tile());
    copyTile(differences, target.tile(), m_differences, request.size.width);
}

/// Surfaces that a strategy made itself have depths that are rounded otherwise: the triangles tell, too, as in
/// measure/accuracy.h.
void PictureDrawing::compareTriangles(std::vector<PixelDifference>& differences, const std::vector<float>& mine,
                                      const std::vector<float>& other, Renderer& renderer, const PictureTile& tile) const {
    const SceneBuffers& buffers = *m_picture->request.buffers;
    const std::vector<uint32_t> is = renderer.drawItemBuffer(buffers, m_viewing, log(), tile).triangle;
    const std::vector<uint32_t> should = m_truth ? renderer.drawItemBuffer(buffers, m_viewing, *m_truth, tile).triangle
                                                 : renderer.drawItemBuffer(buffers, m_viewing, m_other->log, tile).triangle;
    const Scene& scene = buffers.scene();
    const bool byObject = log().grain() == Grain::Object || (m_other && m_other->log.grain() == Grain::Object);
    const Grain grain = byObject ? Grain::Object : Grain::Triangle;
    for (size_t i = 0; i < differences.size(); ++i)
        differences[i] =
            pixelDifference(other[i], comparedItem(scene, grain, should[i]), mine[i], comparedItem(scene, grain, is[i]));
}

std::shared_ptr<ViewPicture> PictureDrawing::finish(int reach) {
    if (m_truth || m_other) markDifferences(*m_picture, m_differences, reach);
    return m_picture;
}

ViewPicturePointer ViewPictureDrawer::draw(const ViewRequest& request, const std::stop_token& stop) {
    const Renderer::Stoppable stoppable(renderer(), stop);
    const auto start = std::chrono::steady_clock::now();
    const std::shared_ptr<ViewPicture> picture = request.coarse ? drawCoarse(request) : drawWhole(request);
    picture->milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return picture;
}

std::shared_ptr<ViewPicture> ViewPictureDrawer::drawCoarse(const ViewRequest& request) {
    auto picture = std::make_shared<ViewPicture>();
    picture->request = request;
    picture->frame = m_frames->of(request.frame(), renderer());
    Framebuffer& into = target(request.size);
    drawCoarsePicture(renderer(), *request.buffers, *request.coarse, *request.strategy, picture->frame->log,
                      request.look.has(Show::Kind::Verdicts)
                          ? std::span<const TriangleState>(picture->frame->statesOf(request.coarse))
                          : std::span<const TriangleState>(),
                      request.shownView(), request.look, request.style, into);
    picture->colour = newImage(request.size, QImage::Format_RGBA8888);
    copyTile(into.readColour(), into.tile(), picture->colour);
    picture->depth = into.readDepth();
    picture->consideredTriangles = picture->frame->log.consideredTriangles();
    return picture;
}

std::shared_ptr<ViewPicture> ViewPictureDrawer::drawWhole(const ViewRequest& request) {
    const ViewFramePointer frame = m_frames->of(request.frame(), renderer());
    const ViewFramePointer other = request.other ? m_frames->ofOther(request.otherFrame(), renderer()) : nullptr;
    PictureDrawing drawing(request, frame, other);
    Framebuffer& into = target(request.size);
    drawing.draw(renderer(), into);
    const std::optional<double> drawn = drawingTime(request, *frame, drawing);
    if (drawn) m_frames->took(request.frame(), frame->log.cullMilliseconds + *drawn);
    const std::shared_ptr<ViewPicture> picture = drawing.finish(kMarkReach);
    picture->timed = drawn.has_value();
    return picture;
}

std::optional<double> ViewPictureDrawer::drawingTime(const ViewRequest& request, const ViewFrame& frame,
                                                     const PictureDrawing& drawing) {
    if (request.upTo || request.unanswered) return std::nullopt;
    // The frame's own picture and nothing else: not from another place, or in colours.
    if (request.viewing == request.culling && request.look == ViewLook{} && !request.section) return drawing.milliseconds();
    if (!frame.unsteady || !(request.size == request.cullingSize)) return std::nullopt;
    return millisecondsOf([&] {
        renderer().draw(*request.buffers, View(request.culling, request.cullingSize), frame.log, target(request.size),
                        request.style);
    });
}

std::optional<ViewPictureDrawer::Picked> ViewPictureDrawer::pick(const ViewRequest& request, int x, int y) {
    const Scene& scene = request.buffers->scene();
    const ViewFramePointer frame = shownFrame(request, m_frames->of(request.frame(), renderer()));
    if (request.look.has(Show::Kind::Model)) {
        const std::optional<DirectionPick> found =
            pickSphericalModel(scene, drawnTriangles(scene, frame->log), request.size, request.style, x, y);
        return found ? std::optional(Picked{found->triangle, found->point}) : std::nullopt;
    }
    const View viewing = request.shownView();
    const bool whole = !request.unanswered && !request.upTo;
    // Where something is compared, what this view lost of the truth comes before what it shows behind.
    const bool marked = request.wipe == Wipe::Mode::Loss || request.wipe == Wipe::Mode::Difference;
    if (whole && request.wipe != Wipe::Mode::None)
        if (const auto lost = missing(request, *frame, x, y, marked ? kMarkReach : 0)) return lost;
    const bool all = request.look.has(Show::Kind::Left);
    const std::optional<PickedTriangle> picked =
        all ? renderer().pick(*request.buffers, viewing, everything(scene, Facing::TwoSided), x, y)
            : renderer().pick(*request.buffers, viewing, frame->log, x, y);
    if (!picked) return whole ? missing(request, *frame, x, y, 0) : std::nullopt;
    return Picked{picked->triangle, pointUnder(viewing, Vec2(x + 0.5, y + 0.5), picked->depth)};
}

std::optional<ViewPictureDrawer::Picked> ViewPictureDrawer::missing(const ViewRequest& request, const ViewFrame& frame, int x,
                                                                    int y, int reach) {
    const Viewport& size = request.size;
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) return std::nullopt;
    const PictureTile around{std::max(0, x - reach),
                             std::max(0, y - reach),
                             {std::min(size.width - 1, x + reach) - std::max(0, x - reach) + 1,
                              std::min(size.height - 1, y + reach) - std::max(0, y - reach) + 1}};
    const View viewing = request.shownView();
    const Scene& scene = request.buffers->scene();
    const Renderer::ItemBuffer truth =
        renderer().drawItemBuffer(*request.buffers, viewing, everything(scene, request.strategy->referenceFacing()), around);
    const Renderer::ItemBuffer shown = renderer().drawItemBuffer(*request.buffers, viewing, frame.log, around);
    const Grain grain = frame.log.grain();
    std::optional<Picked> nearest;
    int least = std::numeric_limits<int>::max();
    for (size_t i = 0; i < truth.depth.size(); ++i) {
        const PixelDifference difference = frame.log.drawsScene()
                                               ? pixelDifference(truth.depth[i], shown.depth[i])
                                               : pixelDifference(truth.depth[i], comparedItem(scene, grain, truth.triangle[i]),
                                                                 shown.depth[i], comparedItem(scene, grain, shown.triangle[i]));
        const int column = around.x + int(i % size_t(around.size.width)), row = around.y + int(i / size_t(around.size.width));
        const int away = (column - x) * (column - x) + (row - y) * (row - y);
        if (difference != PixelDifference::Missed || away >= least) continue;
        least = away;
        nearest = Picked{truth.triangle[i] - 1, pointUnder(viewing, Vec2(column + 0.5, row + 0.5), double(truth.depth[i]))};
    }
    return nearest;
}

std::vector<uint64_t> ViewPictureDrawer::trianglesIn(const ViewRequest& request, const PictureTile& within) {
    const ViewFramePointer frame = shownFrame(request, m_frames->of(request.frame(), renderer()));
    const View viewing = request.shownView();
    std::set<uint64_t> shown;
    for (const uint32_t item : renderer().drawItemBuffer(*request.buffers, viewing, frame->log, within).triangle)
        if (item != 0) shown.insert(item - 1);
    return {shown.begin(), shown.end()};
}

}  // namespace cullscope::ui
