#include "ui/views/scene_view.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <cmath>
#include <new>

#include "core/base/error.h"
#include "ui/views/view_input.h"

namespace cullscope::ui {

namespace {

// In 8 bits a channel, so that `cullbench render --background --surface` repeats the picture.
constexpr QRgb kDarkBackground = 0x14171c;
constexpr QRgb kDarkSurface = 0xccccc7;
constexpr QRgb kLightBackground = 0xffffff;
constexpr QRgb kLightSurface = 0xb8b8b3;

Vec3f colour(QRgb rgb) { return Vec3f(float(qRed(rgb)), float(qGreen(rgb)), float(qBlue(rgb))) / 255.0f; }

}  // namespace

SceneView::SceneView(Session& session, int view, QWidget* parent)
    : QOpenGLWidget(parent), m_session(session), m_view(view), m_input(std::make_unique<ViewInput>(session, *this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    connect(&session, &Session::cameraChanged, this, &SceneView::makeDirty);
    connect(&session, &Session::buffersChanged, this, &SceneView::makeDirty);
    connect(&session, &Session::strategyBuilt, this, [this](int changed) {
        if (changed == m_view) makeDirty();
    });
}

SceneView::~SceneView() {
    makeCurrent();
    release();
    doneCurrent();
}

void SceneView::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        release();
        doneCurrent();
    });
    m_dirty = true;
}

void SceneView::release() {
    m_renderer = nullptr;
    m_framebuffer = nullptr;
    m_dirty = true;
}

void SceneView::makeDirty() {
    m_dirty = true;
    update();
}

Viewport SceneView::renderSize() const {
    const double scale = devicePixelRatioF();
    return {std::max(1, int(std::lround(width() * scale))), std::max(1, int(std::lround(height() * scale)))};
}

View SceneView::camera() const { return View(m_session.camera(), renderSize()); }

Vec2 SceneView::pixelAt(const QPointF& position) const {
    const double scale = devicePixelRatioF();
    return {position.x() * scale, renderSize().height - position.y() * scale};
}

double SceneView::depthAt(const QPointF& position) {
    const Viewport size = renderSize();
    if (!m_framebuffer || m_dirty || !(m_framebuffer->size() == size)) return 0.0;
    if (m_depth.empty()) {
        makeCurrent();
        m_depth = m_framebuffer->readDepth();
        doneCurrent();
    }
    const Vec2 pixel = pixelAt(position);
    const int x = std::clamp(int(pixel.x), 0, size.width - 1);
    const int y = std::clamp(int(pixel.y), 0, size.height - 1);
    return m_depth[size_t(y) * size_t(size.width) + size_t(x)];
}

Vec3 SceneView::pointAt(const QPointF& position) { return pointUnder(camera(), pixelAt(position), depthAt(position)); }

std::optional<Vec3> SceneView::surfaceAt(const QPointF& position) {
    if (m_dirty) {
        makeCurrent();
        draw();
        doneCurrent();
    }
    const double depth = depthAt(position);
    if (depth <= 0.0) return std::nullopt;
    return pointUnder(camera(), pixelAt(position), depth);
}

QImage SceneView::picture() {
    makeCurrent();
    if (m_dirty) draw();
    QImage image;
    if (m_framebuffer) {
        const Viewport& size = m_framebuffer->size();
        const std::vector<uint8_t> pixels = m_framebuffer->readColour();
        image = QImage(pixels.data(), size.width, size.height, 4 * size.width, QImage::Format_RGBA8888).mirrored();
    }
    doneCurrent();
    return image;
}

PictureRequest SceneView::request() const {
    const StrategySlot& slot = m_session.slot(m_view);
    return {m_session.opened()->specification,
            m_session.sceneSource().modelFolders,
            slot.id(),
            slot.parameters(),
            m_session.camera(),
            renderSize(),
            style()};
}

DrawStyle SceneView::style() const {
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    DrawStyle style;
    style.background = colour(dark ? kDarkBackground : kLightBackground);
    style.surface = colour(dark ? kDarkSurface : kLightSurface);
    return style;
}

void SceneView::draw() {
    m_dirty = false;
    m_depth.clear();
    const SceneBuffersPointer& buffers = m_session.buffers();
    const BuiltStrategyPointer& built = m_session.slot(m_view).built();
    const bool ready = buffers && built && built->scene == buffers->scenePointer();
    try {
        if (!m_renderer) m_renderer = std::make_unique<Renderer>();
        const Viewport size = renderSize();
        if (!m_framebuffer || !(m_framebuffer->size() == size)) m_framebuffer = std::make_unique<Framebuffer>(size);
        if (!ready) {
            m_framebuffer = nullptr;
            return;
        }
        renderShared(*m_renderer, *buffers, *built, camera(), *m_framebuffer, style());
        ++m_drawnPictures;
    } catch (const Error& error) {
        complain(error.message());
    } catch (const std::bad_alloc&) {
        complain(
            {QT_TRANSLATE_NOOP("core", "There is not enough memory to draw this view. Make the window or the scene smaller."),
             {}});
    } catch (const std::exception& error) {
        complain({QT_TRANSLATE_NOOP("core", "This view cannot be drawn: %1"), {error.what()}});
    }
}

void SceneView::complain(const Message& message) {
    m_framebuffer = nullptr;
    if (!std::exchange(m_complained, true)) m_session.raise(Severity::Error, message);
}

void SceneView::paintGL() {
    if (m_dirty || (m_framebuffer && !(m_framebuffer->size() == renderSize()))) draw();
    present();
}

void SceneView::present() {
    if (m_framebuffer)
        m_framebuffer->showIn(defaultFramebufferObject());
    else
        fillFramebuffer(defaultFramebufferObject(), style().background);
}

void SceneView::resizeEvent(QResizeEvent* event) {
    m_dirty = true;
    m_session.setViewport(m_view, renderSize());
    QOpenGLWidget::resizeEvent(event);
}

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) makeDirty();
    QOpenGLWidget::changeEvent(event);
}

bool SceneView::event(QEvent* event) {
    if (event->type() == QEvent::ScreenChangeInternal) m_session.setViewport(m_view, renderSize());
    // Keys that fly must not be taken for shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride && ViewInput::wantsKey(*static_cast<QKeyEvent*>(event))) event->accept();
    return QOpenGLWidget::event(event);
}

void SceneView::mousePressEvent(QMouseEvent* event) { m_input->press(*event); }
void SceneView::mouseMoveEvent(QMouseEvent* event) { m_input->move(*event); }
void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_input->release(*event)) emit menuRequested(m_view, event->globalPosition().toPoint());
}
void SceneView::mouseDoubleClickEvent(QMouseEvent* event) { m_input->doubleClick(*event); }
void SceneView::wheelEvent(QWheelEvent* event) { m_input->wheel(*event); }

void SceneView::keyPressEvent(QKeyEvent* event) {
    const bool menu = event->key() == Qt::Key_Menu || (event->key() == Qt::Key_F10 && event->modifiers() == Qt::ShiftModifier);
    if (menu)
        emit menuRequested(m_view, mapToGlobal(rect().center()));
    else if (!m_input->keyPress(*event))
        QOpenGLWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
    if (!m_input->keyRelease(*event)) QOpenGLWidget::keyReleaseEvent(event);
}

void SceneView::focusInEvent(QFocusEvent* event) {
    m_session.setActiveView(m_view);
    QOpenGLWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
    m_input->stop();
    QOpenGLWidget::focusOutEvent(event);
}

}  // namespace cullscope::ui
