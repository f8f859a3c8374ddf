#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/image/picture_metadata.h"
#include "ui/session/session.h"
#include "ui/views/orientation_gizmo.h"
#include "ui/views/picture_layout.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

class ViewInput;

/// Shows the newest picture of one view and handles its mouse and key events. The session's GPU thread draws the picture and
/// reads it back; this widget only paints it, so that neither a slow strategy nor a lost OpenGL context affects the shown
/// picture. It has no OpenGL of its own: a window with a QOpenGLWidget is composed and swapped as a whole for each change of any
/// part of it.
class SceneView : public QWidget {
    Q_OBJECT

public:
    SceneView(Session& session, int view, QWidget* parent = nullptr);
    ~SceneView() override;

    [[nodiscard]] int view() const { return m_view; }
    /// The size of the picture in pixels.
    [[nodiscard]] Viewport renderSize() const { return m_session.renderSize(m_view); }
    /// The layout of the picture in the widget.
    [[nodiscard]] PictureLayout pictureLayout() const;
    /// The world point under a position in the widget.
    [[nodiscard]] Vec3 pointAt(const QPointF& position) const;
    /// The world point of the surface at a position in the widget; none: no surface is drawn there.
    [[nodiscard]] std::optional<Vec3> surfaceAt(const QPointF& position) const;
    /// The same in the picture that is shown, if it is of the present camera; none as well where it is not.
    [[nodiscard]] std::optional<Vec3> shownSurfaceAt(const QPointF& position) const;
    /// The least distance along the view direction to what the middle half of the shown picture has, which may be of the camera
    /// a moment ago; none: nothing is there.
    [[nodiscard]] std::optional<double> distanceAhead() const;
    /// Whether the picture of the present camera has no surface.
    [[nodiscard]] bool showsNothing() const;
    /// The factor of the flying speed that the user has set.
    [[nodiscard]] double pace() const;
    /// Whether the picture shows the present camera and strategy, and is whole.
    [[nodiscard]] bool pictureIsCurrent() const;
    /// The same of a picture that may be coarse, because the camera is being moved.
    [[nodiscard]] bool showsPresentCamera() const;
    /// The picture pixel (y upward) at a position in the widget.
    [[nodiscard]] Vec2 pixelAt(const QPointF& position) const { return pictureLayout().pixelAt(position); }
    /// The view through the present viewing camera.
    [[nodiscard]] View camera() const;
    /// The picture of the present camera and strategy, without overlays.
    [[nodiscard]] QImage picture() const;
    /// Everything that the picture depends on; only with a scene.
    [[nodiscard]] PictureSubject subject() const;
    /// How many pictures were drawn so far: a view that is not dirty is not drawn.
    [[nodiscard]] size_t drawnPictures() const { return m_session.pictures() ? m_session.pictures()->drawn(m_view) : 0; }
    /// The overlays of the picture.
    [[nodiscard]] PictureExtras extras() const;

    /// Whether the loupe follows the pointer.
    [[nodiscard]] bool loupe() const { return m_loupe; }
    void setLoupe(bool on);
    /// Sets the point that the loupe enlarges, in picture pixels from the top left; none hides the loupe.
    void setLoupePlace(const std::optional<QPointF>& place);
    /// Marks the next hole of lost pixels, largest first, under the loupe. Switches the wipe to losses if it is off. Without
    /// losses it removes the mark.
    void goToNextLoss();
    /// Removes the mark, and switches the wipe off if goToNextLoss() had switched it on. Returns false if there was no mark and
    /// no such wipe.
    bool leaveLosses();
    /// Shows a rectangle that is being dragged, in the widget; none: there is none.
    void setRegion(const std::optional<QRectF>& region);
    /// The scale of line widths and signs over the picture, 1 in the window and more on the large screen of a lecture; and the
    /// least height of letters there.
    void setUnit(double unit, int letters = 0);
    /// Leaves so much of the height free below the picture.
    void setFoot(int height) {
        if (height == std::exchange(m_foot, height)) return;
        update();
    }
    /// Shows or hides the scene's axes in a corner, whose ends can be clicked.
    void setAxes(bool on);
    /// The scene's axes; none: they are not shown.
    [[nodiscard]] std::optional<OrientationGizmo> axes() const;
    /// The number of the marked loss, from 0; none: no loss is marked.
    [[nodiscard]] std::optional<size_t> markedLoss() const { return m_loss; }

signals:
    /// The user asks for this view's context menu.
    void menuRequested(int view, const QPoint& globalPosition);
    void lossMarked();
    void paceChanged();
    /// Emitted while the loupe is on: the pointer is at this place in the picture (none: it has left the picture).
    void loupeMoved(int view, const std::optional<QPointF>& place);

protected:
    void paintEvent(QPaintEvent* event) override;
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
    double m_unit = 1.0;
    int m_letters = 0;
    int m_foot = 0;
    void tellSize();
    /// What a stepped view has over its picture: what is decided and not drawn yet, and the subject in hand.
    void paintStep(QPainter& painter, const PictureLayout& layout) const;
    void moveLoupe(const QPointF& position);
    void endLoupe();
    [[nodiscard]] std::optional<Vec3> surfaceIn(const ViewPicture& picture, const QPointF& position) const;
    [[nodiscard]] double depthAt(const ViewPicture& picture, const QPointF& position) const;

    Session& m_session;
    int m_view;
    std::unique_ptr<ViewInput> m_input;
    bool m_loupe = false;
    bool m_axes = true;
    std::optional<QPointF> m_loupePlace;
    std::optional<QRectF> m_region;
    std::optional<size_t> m_loss;
    bool m_lossesShown = false;  ///< goToNextLoss() has switched the wipe on
};

/// The colours of pictures in a window with this palette, in 8 bits a channel, so that `cullbench render` can repeat them.
[[nodiscard]] DrawStyle pictureStyle(const QPalette& palette);

}  // namespace cullscope::ui
