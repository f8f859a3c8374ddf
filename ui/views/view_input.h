#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QSet>
#include <QTimer>

#include "ui/session/session.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace cullscope::ui {

class SceneView;

/// Turns mouse and key events on a view into moves of its viewing camera, with the usual assignments: left drag turns, middle
/// drag or Shift+left pans, right drag looks around while W A S D Q E fly, the wheel zooms to the pointer, Ctrl+wheel moves the
/// near plane, Shift+wheel the field of view, a double click sets the centre of rotation, a click picks, a drag moves the
/// wipe's line, and in an open question Ctrl+left drag names all within a rectangle.
class ViewInput : public QObject {
    Q_OBJECT

public:
    ViewInput(Session& session, SceneView& view);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    /// Handles a release. Returns true if it ended a right click without a drag: the caller opens the menu.
    [[nodiscard]] bool release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void wheel(QWheelEvent& event);
    /// Handles a key. Returns false if it is not a camera key.
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    /// Forgets pressed keys and buttons, as after a loss of the focus.
    void stop();

    [[nodiscard]] static bool wantsKey(const QKeyEvent& event);
    /// The factor of the flying speed that the user has set.
    [[nodiscard]] double pace() const { return m_pace; }

private:
    enum class Drag { None, Turn, Pan, Look, Wipe, Region };

    void beginDrag();
    void fly();
    /// How far one flies in a second, scene units: by the distance to what is ahead, so that one neither crawls outside nor
    /// passes through walls inside.
    [[nodiscard]] double flightSpeed(double seconds);
    void setPace(double pace);
    /// Picks, or looks along the axis whose end was clicked.
    void click(const QPointF& position);
    [[nodiscard]] std::optional<Vec3> axisAt(const QPointF& position) const;
    [[nodiscard]] bool overWipeLine(const QPointF& position) const;
    void moveWipe(const QPointF& position);
    /// Names what lies between where the button was pressed and here.
    void nameRegion(const QPointF& position);

    Session& m_session;
    SceneView& m_view;
    Drag m_drag = Drag::None;
    bool m_moved = false;
    bool m_flown = false;  ///< flown since the button was pressed
    QPointF m_pressed;
    QPointF m_last;
    double m_grabbedDistance = 1.0;
    std::optional<Vec3> m_pivot;  ///< what the turn is about; none: the target
    QPointF m_zoomPosition{-1.0, -1.0};
    Vec3 m_zoomPoint{0.0};
    QSet<int> m_keys;
    QTimer m_flight;
    QElapsedTimer m_clock;
    double m_pace = 1.0;            ///< of flying, as the user has set it
    std::optional<double> m_ahead;  ///< the distance that the flight's speed is of, scene units
};

}  // namespace cullscope::ui
