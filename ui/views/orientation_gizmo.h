#pragma once

#include <QPainter>
#include <array>
#include <optional>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// The scene's axes as the camera sees them, in a corner of the picture: red x, green y, blue z. A click on an end looks from
/// there.
class OrientationGizmo {
public:
    /// `picture`: where the view's picture lies, in the units of the painter and of the clicks.
    OrientationGizmo(const View& camera, const QRectF& picture);

    void paint(QPainter& painter) const;
    /// The direction that the end at a point looks from, of length 1; none: no end is there.
    [[nodiscard]] std::optional<Vec3> directionAt(const QPointF& point) const;

private:
    struct End {
        Vec3 direction{0.0};
        int axis = 0;
        QPointF place;
        double towards = 0.0;  ///< how far it points to the eye, -1 to 1
    };

    [[nodiscard]] bool positive(const End& end) const { return end.direction[end.axis] > 0.0; }
    void paintEnd(QPainter& painter, const End& end) const;

    QPointF m_middle;
    double m_ball;              ///< radius of an end
    std::array<End, 6> m_ends;  ///< farthest first
};

}  // namespace cullscope::ui
