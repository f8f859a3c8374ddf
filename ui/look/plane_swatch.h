#pragma once

#include <QIcon>
#include <QPalette>
#include <QWidget>

#include "core/geometry/frustum.h"

namespace cullscope::ui {

/// The colour of a frustum's plane on the palette's base, as in pictures of boxes. Never for text.
[[nodiscard]] QColor planeColour(FrustumPlane plane, const QPalette& palette);

/// A small frame that stands for the boxes which a plane rejected; as an icon that follows the application's palette.
[[nodiscard]] QIcon planeIcon(FrustumPlane plane);

/// The same as a widget of 14 × 14.
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
