#include "ui/views/scene_view.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <cmath>

#include "core/base/error.h"
#include "core/measure/frame.h"
#include "ui/views/view_input.h"

namespace cullscope::ui {

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

Vec3 SceneView::pointAt(const QPointF& position) {
    const Vec2 pixel = pixelAt(position);
    const View seen = camera();
    double depth = 0.0;
    if (m_framebuffer && !m_dirty && m_framebuffer->size() == seen.viewport()) {
        if (m_depth.empty()) {
            makeCurrent();
            m_depth = m_framebuffer->readDepth();
            doneCurrent();
        }
        const int x = std::clamp(int(pixel.x), 0, seen.viewport().width - 1);
        const int y = std::clamp(int(pixel.y), 0, seen.viewport().height - 1);
        depth = m_depth[size_t(y) * size_t(seen.viewport().width) + size_t(x)];
    }
    return pointUnder(seen, pixel, depth);
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

DrawStyle SceneView::style() const {
    DrawStyle style;
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    if (dark) return style;
    style.background = Vec3f(1.0f);
    style.surface = Vec3f(0.72f, 0.72f, 0.70f);
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
        const std::lock_guard lock(built->mutex);
        renderFrame(*m_renderer, *buffers, *built->strategy, camera(), *m_framebuffer, style());
        ++m_drawnPictures;
    } catch (const Error& error) {
        m_framebuffer = nullptr;
        if (!std::exchange(m_complained, true)) m_session.raise(Severity::Error, error.message());
    }
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
