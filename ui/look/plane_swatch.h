#pragma once

#include <QIcon>
#include <QPalette>
#include <QWidget>

#include "core/geometry/frustum.h"

namespace cullscope::ui {

/// The colour of a frustum's plane on the palette's base, as in pictures of boxes. Never for text.
[[nodiscard]] QColor planeColour(FrustumPlane plane, const QPalette& palette);

/// An icon for the boxes that a plane rejected: a small frame in the plane's colour; follows the application's palette.
[[nodiscard]] QIcon planeIcon(FrustumPlane plane);

/// The same frame as a widget of 14 × 14 pixels.
class PlaneSwatch : public QWidget {
    Q_OBJECT

public:
    explicit PlaneSwatch(FrustumPlane plane, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    FrustumPlane m_plane;
};

}  // namespace cullscope::ui
