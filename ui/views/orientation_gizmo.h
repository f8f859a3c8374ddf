#pragma once

#include <QPainter>
#include <array>
#include <optional>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// The scene's axes as the camera sees them, in a corner of the picture: red x, green y, blue z. A click on the end of an axis
/// turns the camera to look from that direction.
class OrientationGizmo {
public:
    /// `picture`: rectangle of the view's picture, in the units of the painter and of click positions.
    /// `unit`: its scale. `letters`: their least height in those units; 0: as the ends are large.
    OrientationGizmo(const View& camera, const QRectF& picture, double unit = 1.0, int letters = 0);
    /// Whether a picture has room for axes with letters of that least height.
    [[nodiscard]] static bool hasRoom(const QRectF& picture, double unit, int letters);

    void paint(QPainter& painter) const;
    /// The unit vector from the scene towards the viewer for the axis end at a position; none: no end is there.
    [[nodiscard]] std::optional<Vec3> directionAt(const QPointF& point) const;

private:
    struct End {
        Vec3 direction{0.0};
        int axis = 0;
        QPointF place;
        double towards = 0.0;  ///< component towards the eye, -1 to 1
    };

    [[nodiscard]] bool positive(const End& end) const { return end.direction[end.axis] > 0.0; }
    void paintLine(QPainter& painter, const End& end) const;
    void paintEnd(QPainter& painter, const End& end) const;

    QPointF m_middle;
    double m_unit;
    double m_ball;              ///< radius of an axis end
    int m_letters;              ///< height in pixels
    std::array<End, 6> m_ends;  ///< sorted, farthest first
};

}  // namespace cullscope::ui
