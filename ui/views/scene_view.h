#pragma once

#include <QOpenGLWidget>
#include <memory>
#include <optional>

#include "core/gpu/framebuffer.h"
#include "core/gpu/renderer.h"
#include "ui/session/cullbench_command.h"
#include "ui/session/session.h"

namespace cullscope::ui {

class ViewInput;

/// The picture of one view: what its strategy decides, drawn into a framebuffer of its own and shown. Drawn anew only
/// when something in it changed. Everything that belongs to the OpenGL context is rebuilt when the context is another.
class SceneView : public QOpenGLWidget {
    Q_OBJECT

public:
    SceneView(Session& session, int view, QWidget* parent = nullptr);
    ~SceneView() override;

    [[nodiscard]] int view() const { return m_view; }
    /// In device pixels.
    [[nodiscard]] Viewport renderSize() const;
    /// The world point under a position in the widget.
    [[nodiscard]] Vec3 pointAt(const QPointF& position);
    /// The same, but nothing where no surface is drawn there.
    [[nodiscard]] std::optional<Vec3> surfaceAt(const QPointF& position);
    /// Whether the picture shows the present camera and strategy.
    [[nodiscard]] bool pictureIsCurrent() const { return !m_dirty && m_framebuffer; }
    /// Pixels of the picture (y upward) from a position in the widget.
    [[nodiscard]] Vec2 pixelAt(const QPointF& position) const;
    /// What is seen at the present camera.
    [[nodiscard]] View camera() const;
    /// The picture as it is drawn, without the window.
    [[nodiscard]] QImage picture();
    /// The colours in which it is drawn: those of the window's palette, in 8 bits a channel.
    [[nodiscard]] DrawStyle style() const;
    /// Everything that the picture depends on; only with a scene.
    [[nodiscard]] PictureRequest request() const;
    /// How many pictures were drawn so far: a view that is not dirty is not drawn.
    [[nodiscard]] size_t drawnPictures() const { return m_drawnPictures; }

signals:
    /// The user asks for this view's menu.
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void release();
    void makeDirty();
    void draw();
    void present();
    void complain(const Message& message);
    [[nodiscard]] double depthAt(const QPointF& position);

    Session& m_session;
    int m_view;
    std::unique_ptr<ViewInput> m_input;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Framebuffer> m_framebuffer;
    std::vector<float> m_depth;  ///< of the picture, read when first asked for
    bool m_dirty = true;
    bool m_complained = false;
    size_t m_drawnPictures = 0;
};

}  // namespace cullscope::ui
