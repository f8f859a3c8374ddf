#include "ui/views/view_input.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/views/scene_view.h"

namespace cullscope::ui {

namespace {

constexpr double kClickReach = 4.0;  // pixels; a shorter motion is a click, a longer one a drag
constexpr double kWipeReach = 6.0;   // pixels on either side of the line
constexpr double kDegreesPerPixel = 0.4;
constexpr double kDegreesPerKey = 5.0;
constexpr double kPixelsPerKey = 40.0;
constexpr double kZoomPerNotch = 0.85;
constexpr double kNearPerNotch = 1.25;
constexpr double kFovyPerNotch = 1.06;
constexpr double kNarrowestFovy = 1.0;  // degrees
constexpr double kWidestFovy = 150.0;
constexpr int kFlightInterval = 16;                           // ms
constexpr double kFlightSpeed = 0.8;                          // of the distance ahead, a second
constexpr double kNearestAhead = 0.01, kFarthestAhead = 1.0;  // scene radii
constexpr double kSettling = 6.0;                             // a second: how fast the speed follows the distance
constexpr double kHurry = 4.0;
constexpr double kPaceStep = 2.0, kSlowestPace = 1.0 / 64.0, kFastestPace = 64.0;
constexpr double kLongestFlightStep = 0.1;  // seconds; keeps the camera near the scene after a slow picture

bool flies(int key) {
    switch (key) {
        case Qt::Key_W:
        case Qt::Key_A:
        case Qt::Key_S:
        case Qt::Key_D:
        case Qt::Key_Q:
        case Qt::Key_E:
            return true;
        default:
            return false;
    }
}

Camera withFovy(const Camera& camera, double factor) {
    Camera result = camera;
    if (camera.projection == ProjectionKind::Parallel) {
        result.height *= factor;
        return result;
    }
    result.fovy = Angle::fromDegrees(std::clamp(camera.fovy.degrees() * factor, kNarrowestFovy, kWidestFovy));
    return result;
}

}  // namespace

ViewInput::ViewInput(Session& session, SceneView& view) : m_session(session), m_view(view) {
    m_flight.setInterval(kFlightInterval);
    connect(&m_flight, &QTimer::timeout, this, &ViewInput::fly);
}

bool ViewInput::wantsKey(const QKeyEvent& event) {
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    return modifiers == Qt::NoModifier && flies(event.key());
}

void ViewInput::press(const QMouseEvent& event) {
    m_session.setActiveView(m_view.view());
    m_pressed = m_last = event.position();
    m_moved = m_flown = false;
    if (event.button() == Qt::LeftButton && overWipeLine(event.position())) {
        m_drag = Drag::Wipe;
        return;
    }
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    switch (event.button()) {
        case Qt::LeftButton:
            m_drag = shift ? Drag::Pan : Drag::Turn;
            if (m_session.question() && event.modifiers().testFlag(Qt::ControlModifier)) m_drag = Drag::Region;
            break;
        case Qt::MiddleButton:
            m_drag = Drag::Pan;
            break;
        case Qt::RightButton:
            m_drag = Drag::Look;
            break;
        default:
            m_drag = Drag::None;
    }
}

void ViewInput::beginDrag() {
    m_moved = true;
    m_last = m_pressed;
    m_pivot.reset();
    if (m_drag == Drag::Turn) m_pivot = m_view.shownSurfaceAt(m_pressed);
    if (m_drag != Drag::Pan) return;
    const View seen = m_view.camera();
    m_grabbedDistance = glm::dot(m_view.pointAt(m_pressed) - seen.eye(), seen.frustum().forward);
}

bool ViewInput::overWipeLine(const QPointF& position) const {
    const Wipe wipe = m_view.extras().wipe;
    if (wipe.mode != Wipe::Mode::Truth && wipe.mode != Wipe::Mode::OtherView) return false;
    const QRectF picture = m_view.pictureLayout().rect();
    return std::abs(position.x() - picture.left() - wipe.position * picture.width()) < kWipeReach;
}

void ViewInput::moveWipe(const QPointF& position) {
    const QRectF picture = m_view.pictureLayout().rect();
    ViewSetup setup = m_session.setup(m_view.view());
    setup.wipe.position = std::clamp((position.x() - picture.left()) / picture.width(), 0.0, 1.0);
    m_session.setSetup(m_view.view(), setup);
}

void ViewInput::move(const QMouseEvent& event) {
    if (m_drag == Drag::None) m_view.setCursor(overWipeLine(event.position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
    if (m_drag == Drag::None || !m_session.opened()) return;
    if (m_drag == Drag::Wipe) {
        m_moved = true;
        moveWipe(event.position());
        return;
    }
    const QPointF way = event.position() - m_pressed;
    if (!m_moved && std::hypot(way.x(), way.y()) < kClickReach) return;
    if (!m_moved) beginDrag();
    const QPointF step = event.position() - m_last;
    const Angle azimuth = Angle::fromDegrees(-kDegreesPerPixel * step.x());
    const Angle elevation = Angle::fromDegrees(kDegreesPerPixel * step.y());
    const Camera& camera = m_session.viewingCamera(m_view.view());
    switch (m_drag) {
        case Drag::Turn:
            m_session.moveViewingCamera(
                m_view.view(), turnedAbout(camera, m_session.upAxis(), m_pivot.value_or(camera.target), azimuth, elevation));
            break;
        case Drag::Look:
            m_session.moveViewingCamera(m_view.view(), looked(camera, m_session.upAxis(), azimuth * 0.5, elevation * -0.5));
            break;
        case Drag::Pan:
            m_session.moveViewingCamera(m_view.view(), panned(m_view.camera(), m_grabbedDistance, m_view.pixelAt(m_last),
                                                              m_view.pixelAt(event.position())));
            break;
        case Drag::Region:
            m_view.setRegion(QRectF(m_pressed, event.position()).normalized());
            break;
        case Drag::None:
        case Drag::Wipe:
            break;
    }
    m_last = event.position();
}

bool ViewInput::release(const QMouseEvent& event) {
    const bool menu = event.button() == Qt::RightButton && m_drag == Drag::Look && !m_moved && !m_flown;
    const bool clicks = m_drag == Drag::Turn || m_drag == Drag::Region;
    if (event.button() == Qt::LeftButton && clicks && !m_moved) click(event.position());
    if (m_drag == Drag::Region && m_moved) nameRegion(event.position());
    m_view.setRegion(std::nullopt);
    m_drag = Drag::None;
    return menu;
}

void ViewInput::nameRegion(const QPointF& position) {
    const Vec2 from = m_view.pixelAt(m_pressed), to = m_view.pixelAt(position);
    const Viewport size = m_view.renderSize();
    const auto pixel = [](double at, int end) { return int(std::clamp(std::floor(at), 0.0, double(end - 1))); };
    const int left = pixel(std::min(from.x, to.x), size.width), right = pixel(std::max(from.x, to.x), size.width);
    const int low = pixel(std::min(from.y, to.y), size.height), high = pixel(std::max(from.y, to.y), size.height);
    m_session.nameIn(m_view.view(), {left, low, {right - left + 1, high - low + 1}});
}

std::optional<Vec3> ViewInput::axisAt(const QPointF& position) const {
    const std::optional<OrientationGizmo> axes = m_view.axes();
    return axes ? axes->directionAt(position) : std::nullopt;
}

void ViewInput::click(const QPointF& position) {
    if (const std::optional<Vec3> direction = axisAt(position)) {
        const Camera& camera = m_session.viewingCamera(m_view.view());
        m_session.moveViewingCamera(m_view.view(), seenFrom(camera, m_session.upAxis(), *direction));
        return;
    }
    const Vec2 pixel = m_view.pixelAt(position);
    m_session.pickAt(m_view.view(), int(std::floor(pixel.x)), int(std::floor(pixel.y)));
}

void ViewInput::doubleClick(const QMouseEvent& event) {
    m_drag = Drag::None;
    if (event.button() != Qt::LeftButton || !m_session.opened() || axisAt(event.position())) return;
    // There is no centre of rotation where no surface is drawn.
    if (const std::optional<Vec3> point = m_view.surfaceAt(event.position()))
        m_session.moveViewingCamera(m_view.view(), centredOn(m_view.camera(), *point));
}

void ViewInput::wheel(QWheelEvent& event) {
    event.accept();
    if (!m_session.opened()) return;
    // Some systems turn the wheel with a modifier key into horizontal scrolling.
    const QPoint angle = event.angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    const Camera& camera = m_session.viewingCamera(m_view.view());
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        if (m_session.moving()) m_session.moving()->move();
        m_session.setChosenNear(camera.nearDistance * std::pow(kNearPerNotch, notches));
    } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        m_session.moveViewingCamera(m_view.view(), withFovy(camera, std::pow(kFovyPerNotch, -notches)));
    } else {
        // Zooming keeps the point under the pointer: reuse it until the next picture is drawn.
        if (m_view.showsPresentCamera() || m_zoomPosition != event.position()) m_zoomPoint = m_view.pointAt(event.position());
        m_zoomPosition = event.position();
        const double radius = m_session.opened()->scene->boundingSphere().radius;
        m_session.moveViewingCamera(m_view.view(), zoomed(camera, m_zoomPoint, std::pow(kZoomPerNotch, notches), radius));
    }
}

bool ViewInput::keyPress(const QKeyEvent& event) {
    if (!m_session.opened()) return false;
    if (wantsKey(event)) {
        if (!event.isAutoRepeat()) m_keys.insert(event.key());
        if (!m_flight.isActive()) {
            m_ahead.reset();
            m_clock.start();
            m_flight.start();
        }
        return true;
    }
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    QPointF way;
    switch (event.key()) {
        case Qt::Key_Left:
            way = {-1.0, 0.0};
            break;
        case Qt::Key_Right:
            way = {1.0, 0.0};
            break;
        case Qt::Key_Up:
            way = {0.0, -1.0};
            break;
        case Qt::Key_Down:
            way = {0.0, 1.0};
            break;
        case Qt::Key_BracketLeft:
            setPace(m_pace / kPaceStep);
            return true;
        case Qt::Key_BracketRight:
            setPace(m_pace * kPaceStep);
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
        case Qt::Key_Minus: {
            const double factor = event.key() == Qt::Key_Minus ? 1.0 / kZoomPerNotch : kZoomPerNotch;
            const double radius = m_session.opened()->scene->boundingSphere().radius;
            m_session.moveViewingCamera(m_view.view(), zoomed(m_session.viewingCamera(m_view.view()),
                                                              m_session.viewingCamera(m_view.view()).target, factor, radius));
            return true;
        }
        default:
            return false;
    }
    const Camera& camera = m_session.viewingCamera(m_view.view());
    if (shift) {
        const double distance = glm::length(camera.target - camera.eye);
        const Vec2 step = kPixelsPerKey * Vec2(way.x(), -way.y());
        m_session.moveViewingCamera(m_view.view(), panned(m_view.camera(), distance, Vec2(0.0), step));
    } else {
        m_session.moveViewingCamera(m_view.view(),
                                    turned(camera, m_session.upAxis(), Angle::fromDegrees(kDegreesPerKey * way.x()),
                                           Angle::fromDegrees(-kDegreesPerKey * way.y())));
    }
    return true;
}

bool ViewInput::keyRelease(const QKeyEvent& event) {
    if (!flies(event.key())) return false;
    if (!event.isAutoRepeat()) m_keys.remove(event.key());
    if (m_keys.isEmpty()) m_flight.stop();
    return true;
}

void ViewInput::stop() {
    m_keys.clear();
    m_flight.stop();
    m_view.setRegion(std::nullopt);
    m_drag = Drag::None;
}

void ViewInput::setPace(double pace) {
    m_pace = std::clamp(pace, kSlowestPace, kFastestPace);
    emit m_view.paceChanged();
}

double ViewInput::flightSpeed(double seconds) {
    const double radius = m_session.opened()->scene->boundingSphere().radius;
    const double ahead =
        std::clamp(m_view.distanceAhead().value_or(kFarthestAhead * radius), kNearestAhead * radius, kFarthestAhead * radius);
    // In the logarithm, so that the speed changes as evenly near a wall as in the open.
    m_ahead = m_ahead ? *m_ahead * std::pow(ahead / *m_ahead, std::min(1.0, kSettling * seconds)) : ahead;
    return m_pace * kFlightSpeed * *m_ahead;
}

void ViewInput::fly() {
    if (!m_session.opened()) return;
    const double seconds = std::min(m_clock.restart() / 1000.0, kLongestFlightStep);
    const double hurry = QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier) ? kHurry : 1.0;
    const double length = hurry * seconds * flightSpeed(seconds);
    const auto held = [this](int key) { return m_keys.contains(key) ? 1.0 : 0.0; };
    const Vec3 step(held(Qt::Key_D) - held(Qt::Key_A), held(Qt::Key_E) - held(Qt::Key_Q), held(Qt::Key_W) - held(Qt::Key_S));
    m_flown = m_flown || step != Vec3(0.0);
    if (step != Vec3(0.0)) m_session.moveViewingCamera(m_view.view(), flown(m_view.camera(), length * step));
}

}  // namespace cullscope::ui
