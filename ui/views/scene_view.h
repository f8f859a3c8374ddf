#pragma once

#include <QOpenGLWidget>
#include <memory>
#include <optional>

#include "core/image/picture_metadata.h"
#include "ui/session/session.h"
#include "ui/views/orientation_gizmo.h"
#include "ui/views/picture_layout.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

class ViewInput;

/// Shows the newest picture of one view and takes the mouse and the keys. The picture is drawn on the session's GPU
/// thread; this widget only paints it, so that neither a slow strategy nor a lost context of the window touches what is shown.
class SceneView : public QOpenGLWidget {
    Q_OBJECT

public:
    SceneView(Session& session, int view, QWidget* parent = nullptr);
    ~SceneView() override;

    [[nodiscard]] int view() const { return m_view; }
    /// Of the picture, in pixels.
    [[nodiscard]] Viewport renderSize() const { return m_session.renderSize(m_view); }
    /// Where the picture lies in the widget.
    [[nodiscard]] PictureLayout pictureLayout() const;
    /// The world point under a position in the widget.
    [[nodiscard]] Vec3 pointAt(const QPointF& position) const;
    /// The same, but nothing where no surface is drawn there.
    [[nodiscard]] std::optional<Vec3> surfaceAt(const QPointF& position) const;
    /// Whether the picture shows the present camera and strategy.
    [[nodiscard]] bool pictureIsCurrent() const;
    /// Pixels of the picture (y upward) from a position in the widget.
    [[nodiscard]] Vec2 pixelAt(const QPointF& position) const { return pictureLayout().pixelAt(position); }
    /// What is seen at the present viewing camera.
    [[nodiscard]] View camera() const;
    /// The picture of the present camera and strategy as it is drawn, without what is painted over it.
    [[nodiscard]] QImage picture() const;
    /// Everything that the picture depends on; only with a scene.
    [[nodiscard]] PictureSubject subject() const;
    /// How many pictures were drawn so far: a view that is not dirty is not drawn.
    [[nodiscard]] size_t drawnPictures() const { return m_session.pictures() ? m_session.pictures()->drawn(m_view) : 0; }
    /// What is painted over the picture.
    [[nodiscard]] PictureExtras extras() const;

    /// Whether the loupe follows the pointer.
    [[nodiscard]] bool loupe() const { return m_loupe; }
    void setLoupe(bool on);
    /// What the loupe enlarges, in pixels of the picture from the top left; none: it is not shown.
    void setLoupePlace(const std::optional<QPointF>& place);
    /// Marks the next lost pixels, largest hole first, under the loupe, and shows the losses where nothing else is shown beside
    /// the picture; nothing lost: unmarks.
    void goToNextLoss();
    /// Unmarks the loss, and shows no losses where going to one had begun that. False: there was nothing to put away.
    bool leaveLosses();
    /// Shows the scene's axes in a corner, with ends to click on.
    void setAxes(bool on);
    /// The axes' ends; none: they are not shown.
    [[nodiscard]] std::optional<OrientationGizmo> axes() const;
    /// Which loss is marked, from 0.
    [[nodiscard]] std::optional<size_t> markedLoss() const { return m_loss; }

signals:
    /// The user asks for this view's menu.
    void menuRequested(int view, const QPoint& globalPosition);
    void lossMarked();
    /// The pointer is at this place of the picture now (none: no longer in it), and the loupe is on.
    void loupeMoved(int view, const std::optional<QPointF>& place);

protected:
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void tellSize();
    void moveLoupe(const QPointF& position);
    void endLoupe();
    [[nodiscard]] double depthAt(const ViewPicture& picture, const QPointF& position) const;

    Session& m_session;
    int m_view;
    std::unique_ptr<ViewInput> m_input;
    bool m_loupe = false;
    bool m_axes = true;
    std::optional<QPointF> m_loupePlace;
    std::optional<size_t> m_loss;
    bool m_lossesShown = false;  ///< by going to the next one
};

/// The colours of pictures in a window of this palette, in 8 bits a channel so that `cullbench render` repeats them.
[[nodiscard]] DrawStyle pictureStyle(const QPalette& palette);

}  // namespace cullscope::ui
