#include "ui/views/scene_view.h"

#include <QMouseEvent>
#include <cmath>
#include <utility>

#include "core/measure/accuracy.h"
#include "core/visibility/registry.h"
#include "ui/session/session_state.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"
#include "ui/views/object_names.h"
#include "ui/views/pick_painter.h"
#include "ui/views/view_input.h"

namespace cullscope::ui {

SceneView::SceneView(Session& session, int view, QWidget* parent)
    : QWidget(parent), m_session(session), m_view(view), m_input(std::make_unique<ViewInput>(session, *this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setMouseTracking(true);
    // All of it is painted: what lies under it need not be.
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_session.setDrawStyle(pictureStyle(palette()));
    connect(&session, &Session::pictureChanged, this, [this](int changed) {
        if (changed == m_view) update();
    });
    for (const auto signal : {&Session::pickChanged, &Session::groupChanged})
        connect(&session, signal, this, qOverload<>(&SceneView::update));
    // A step is painted with its picture, which pictureChanged tells of: painting the former one again would delay it.
    connect(&session, &Session::questionChanged, this, qOverload<>(&SceneView::update));
    connect(&session, &Session::setupChanged, this, [this](int changed) {
        if (changed != m_view) return;
        m_lossesShown = m_lossesShown && m_session.setup(m_view).wipe.mode == Wipe::Mode::Loss;
        update();
    });
    connect(&session, &Session::metricsChanged, this, [this](int changed) {
        if (changed != m_session.culledBy(m_view) || m_session.figures(m_view).state == ViewMetrics::State::Ready) return;
        if (m_loss) emit lossMarked();
        m_loss.reset();
    });
}

SceneView::~SceneView() = default;

PictureLayout SceneView::pictureLayout() const {
    const ViewPicturePointer shown = m_session.picture(m_view);
    Viewport size = shown ? shown->request.size : renderSize();
    // While the user resizes the window, the last picture is shown at its own size.
    if (size.width < 1 || size.height < 1) size = {std::max(1, width()), std::max(1, height())};
    return {QSizeF(width(), std::max(1, height() - m_foot)), devicePixelRatioF(), size};
}

View SceneView::camera() const { return View(m_session.viewingCamera(m_view), renderSize()); }

bool SceneView::showsPresentCamera() const { return m_session.pictures() && m_session.pictures()->isCurrent(m_view); }

bool SceneView::pictureIsCurrent() const { return showsPresentCamera() && !m_session.picture(m_view)->request.coarse; }

double SceneView::depthAt(const ViewPicture& picture, const QPointF& position) const {
    if (picture.depth.empty()) return 0.0;
    const Viewport& size = picture.request.size;
    const Vec2 pixel = pixelAt(position);
    const int x = std::clamp(int(pixel.x), 0, size.width - 1);
    const int y = std::clamp(int(pixel.y), 0, size.height - 1);
    return picture.depth[size_t(y) * size_t(size.width) + size_t(x)];
}

std::optional<Vec3> SceneView::surfaceIn(const ViewPicture& picture, const QPointF& position) const {
    const double depth = depthAt(picture, position);
    return depth > 0.0 ? std::optional(pointUnder(camera(), pixelAt(position), depth)) : std::nullopt;
}

Vec3 SceneView::pointAt(const QPointF& position) const {
    return shownSurfaceAt(position).value_or(pointUnder(camera(), pixelAt(position), 0.0));
}

std::optional<Vec3> SceneView::shownSurfaceAt(const QPointF& position) const {
    return showsPresentCamera() ? surfaceIn(*m_session.picture(m_view), position) : std::nullopt;
}

std::optional<double> SceneView::distanceAhead() const {
    constexpr int kPlaces = 7;
    const ViewPicturePointer shown = m_session.picture(m_view);
    if (!shown || shown->depth.empty()) return std::nullopt;
    const View seen(shown->request.viewing, shown->request.size);
    const int width = seen.viewport().width, height = seen.viewport().height;
    const auto within = [](int place, int length) { return length / 4 + place * (length / 2) / (kPlaces + 1); };
    float nearest = 0.0f;  // reversed: the largest
    for (int y = 1; y <= kPlaces; ++y)
        for (int x = 1; x <= kPlaces; ++x)
            nearest = std::max(nearest, shown->depth[size_t(within(y, height)) * size_t(width) + size_t(within(x, width))]);
    if (!(nearest > 0.0f)) return std::nullopt;
    return seen.distanceFromDepth(double(nearest));
}

bool SceneView::showsNothing() const {
    const ViewPicturePointer shown = m_session.picture(m_view);
    if (!shown || !pictureIsCurrent() || shown->request.look.inPlace()) return false;
    return std::ranges::none_of(shown->depth, [](float depth) { return depth > 0.0f; });
}

double SceneView::pace() const { return m_input->pace(); }

std::optional<Vec3> SceneView::surfaceAt(const QPointF& position) const {
    if (pictureIsCurrent()) return shownSurfaceAt(position);
    const std::optional<ViewRequest> wanted = m_session.viewRequest(m_view);
    return wanted ? surfaceIn(*m_session.pictures()->drawNow(*wanted), position) : std::nullopt;
}

QImage SceneView::picture() const {
    const std::optional<ViewRequest> wanted = m_session.viewRequest(m_view);
    if (!wanted) return {};
    return (pictureIsCurrent() ? m_session.picture(m_view) : m_session.pictures()->drawNow(*wanted))->colour;
}

PictureSubject SceneView::subject() const {
    const std::optional<ViewRequest> wanted = m_session.viewRequest(m_view);
    PictureSubject subject = pictureSubject(m_session, m_view, wanted);
    if (wanted && pictureIsCurrent()) subject.look = shownLook(*m_session.picture(m_view)->frame, wanted->look);
    return subject;
}

PictureExtras SceneView::extras() const {
    PictureExtras extras;
    extras.unit = m_unit;
    if (m_session.setup(m_view).look.inPlace()) {
        // The pixels of this picture are directions: overlays with camera positions cannot be placed on it.
        extras.modelScales = true;
        if (m_loupe) extras.loupe = m_loupePlace;
        return extras;
    }
    const ViewPicturePointer shown = m_session.picture(m_view);
    if (shown) extras.names = objectNames(m_session, *shown);
    if (!m_session.question()) extras.wipe = m_session.setup(m_view).wipe;
    const auto nameOf = [this](int view) {
        return translated(findStrategy(m_session.slot(m_session.culledBy(view)).id()).info.name);
    };
    const bool truth = extras.wipe.mode == Wipe::Mode::Truth;
    extras.left = truth
                      ? tr("Truth")
                      : tr("%1: %2", "letter of a view, strategy").arg(viewLetter(extras.wipe.other), nameOf(extras.wipe.other));
    extras.right = truth ? nameOf(m_view) : tr("%1: %2", "letter of a view, strategy").arg(viewLetter(m_view), nameOf(m_view));
    if (!shown) return extras;
    const int height = shown->request.size.height;
    const std::vector<Hole>& holes = m_session.figures(m_view).holes;
    if (m_loss && *m_loss < holes.size()) {
        const Hole& hole = holes[*m_loss];
        const double width = std::sqrt(double(hole.pixels));
        const QPointF middle(hole.x + 0.5, height - hole.y - 0.5);
        extras.markedLoss = QRectF(middle - QPointF(width, width) / 2.0, QSizeF(width, width));
        extras.loupe = middle;
    } else if (m_loupe) {
        extras.loupe = m_loupePlace;
    }
    return extras;
}

void SceneView::setLoupe(bool on) {
    m_loupe = on;
    if (!on)
        setLoupePlace(std::nullopt);
    else if (underMouse())
        moveLoupe(mapFromGlobal(QCursor::pos()));
}

void SceneView::setLoupePlace(const std::optional<QPointF>& place) {
    m_loupePlace = place;
    update();
}

void SceneView::moveLoupe(const QPointF& position) {
    const Viewport size = renderSize();
    const Vec2 pixel = pixelAt(position);
    const QPointF place(pixel.x, size.height - pixel.y);
    if (!QRectF(0.0, 0.0, size.width, size.height).contains(place)) return endLoupe();
    setLoupePlace(place);
    emit loupeMoved(m_view, m_loupePlace);
}

void SceneView::endLoupe() {
    setLoupePlace(std::nullopt);
    emit loupeMoved(m_view, std::nullopt);
}

void SceneView::setUnit(double unit, int letters) {
    m_unit = unit;
    m_letters = letters;
    update();
}

void SceneView::setAxes(bool on) {
    m_axes = on;
    update();
}

std::optional<OrientationGizmo> SceneView::axes() const {
    const ViewPicturePointer shown = m_session.picture(m_view);
    if (!m_axes || !shown || shown->request.look.inPlace()) return std::nullopt;
    const QRectF picture = pictureLayout().rect();
    if (!OrientationGizmo::hasRoom(picture, m_unit, m_letters)) return std::nullopt;
    return OrientationGizmo(View(shown->request.viewing, shown->request.size), picture, m_unit, m_letters);
}

void SceneView::goToNextLoss() {
    // Losses are known at the culling camera; another camera's picture has no place for them.
    const std::vector<Hole>& holes = m_session.figures(m_view).holes;
    const bool placed = m_session.setup(m_view).role == Role::Linked && !holes.empty();
    m_loss = !placed ? std::nullopt : std::optional(m_loss ? (*m_loss + 1) % holes.size() : 0);
    if (ViewSetup setup = m_session.setup(m_view); placed && setup.wipe.mode == Wipe::Mode::None) {
        m_lossesShown = true;
        setup.wipe.mode = Wipe::Mode::Loss;
        m_session.setSetup(m_view, setup);
    }
    if (m_loss) m_session.pickLostAt(m_view, holes[*m_loss].x, holes[*m_loss].y);
    emit lossMarked();
    update();
}

bool SceneView::leaveLosses() {
    if (!m_loss && !m_lossesShown) return false;
    m_loss.reset();
    if (std::exchange(m_lossesShown, false)) {
        ViewSetup setup = m_session.setup(m_view);
        setup.wipe.mode = Wipe::Mode::None;
        m_session.setSetup(m_view, setup);
    }
    emit lossMarked();
    update();
    return true;
}

void SceneView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const PictureLayout layout = pictureLayout();
    const ViewPicturePointer shown = m_session.picture(m_view);
    PictureExtras over = extras();
    // Over the outlines of a step: they would cross the letters.
    const std::vector<PlacedName> names = std::exchange(over.names, {});
    if (shown)
        paintPicture(painter, layout.rect(), *shown, over);
    else
        painter.fillRect(layout.rect(), QColor::fromRgbF(m_session.drawStyle().background.x, m_session.drawStyle().background.y,
                                                         m_session.drawStyle().background.z));
    paintStep(painter, layout);
    over.names = names;
    if (shown) paintNames(painter, layout.rect(), *shown, over);
    if (const OpenedScenePointer& opened = m_session.opened();
        shown && opened && m_session.pick() && !m_session.question() && !shown->request.look.inPlace())
        paintPick(painter, *opened->scene, *m_session.pick(), m_session.pointBefore(),
                  View(shown->request.viewing, shown->request.size), layout);
    if (const std::optional<OrientationGizmo> gizmo = axes()) gizmo->paint(painter);
    if (m_region) paintRegion(painter, *m_region, layout);
}

void SceneView::setRegion(const std::optional<QRectF>& region) {
    if (region == m_region) return;
    m_region = region;
    update();
}

void SceneView::paintStep(QPainter& painter, const PictureLayout& layout) const {
    const ViewPicturePointer shown = m_session.picture(m_view);
    const ShownStep* step = m_session.stepOf(m_view);
    if (shown && m_session.question() && m_session.scene() == shown->request.buffers->scenePointer())
        paintPrediction(painter, *m_session.scene(), *m_session.question(), m_session.questionParts().get(),
                        View(shown->request.viewing, shown->request.size), layout);
    const ChosenGroup* group = m_session.groupOf(m_view);
    if (shown && group && shown->frame->request.strategy == group->strategy && !shown->request.look.inPlace())
        paintGroup(painter, group->shape, View(shown->request.viewing, shown->request.size), layout);
    if (!shown || !step || m_session.question() || shown->request.look.inPlace()) return;
    if (!shown->ahead.isNull()) {
        painter.setOpacity(kAheadOpacity);
        paintScaled(painter, layout.rect(), shown->ahead);
        painter.setOpacity(1.0);
    }
    // Of a newer frame's subject nothing is known before the picture of that frame is there.
    if (!shown->frame->request.sameFrame(step->frame->request)) return;
    paintSubject(painter, step->shape, View(shown->request.viewing, shown->request.size), layout,
                 shown->request.viewing == shown->request.culling, m_unit);
}

void SceneView::tellSize() {
    const double scale = devicePixelRatioF();
    m_session.setViewport(m_view,
                          {std::max(1, int(std::lround(width() * scale))), std::max(1, int(std::lround(height() * scale)))});
}

void SceneView::resizeEvent(QResizeEvent* event) {
    tellSize();
    QWidget::resizeEvent(event);
}

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) m_session.setDrawStyle(pictureStyle(palette()));
    QWidget::changeEvent(event);
}

bool SceneView::event(QEvent* event) {
    if (event->type() == QEvent::ScreenChangeInternal) tellSize();
    // Accepting ShortcutOverride keeps the flight keys from triggering shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride && ViewInput::wantsKey(*static_cast<QKeyEvent*>(event))) event->accept();
    return QWidget::event(event);
}

void SceneView::mousePressEvent(QMouseEvent* event) { m_input->press(*event); }

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (m_loupe) moveLoupe(event->position());
    m_input->move(*event);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_input->release(*event)) emit menuRequested(m_view, event->globalPosition().toPoint());
}
void SceneView::mouseDoubleClickEvent(QMouseEvent* event) { m_input->doubleClick(*event); }
void SceneView::wheelEvent(QWheelEvent* event) { m_input->wheel(*event); }

void SceneView::leaveEvent(QEvent* event) {
    if (m_loupe) endLoupe();
    QWidget::leaveEvent(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const bool menu = event->key() == Qt::Key_Menu || (event->key() == Qt::Key_F10 && event->modifiers() == Qt::ShiftModifier);
    if (menu)
        emit menuRequested(m_view, mapToGlobal(rect().center()));
    else if (event->key() == Qt::Key_Escape && leaveLosses())
        event->accept();
    else if (!m_input->keyPress(*event))
        QWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
    if (!m_input->keyRelease(*event)) QWidget::keyReleaseEvent(event);
}

void SceneView::focusInEvent(QFocusEvent* event) {
    m_session.setActiveView(m_view);
    QWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
    m_input->stop();
    QWidget::focusOutEvent(event);
}

}  // namespace cullscope::ui
