#pragma once

#include <QIcon>
#include <QPainter>
#include <QPalette>
#include <QWidget>

#include "core/visibility/triangle_states.h"

namespace cullscope::ui {

/// The colour of a triangle state on the palette's base colour, as in the pictures. Never for text.
[[nodiscard]] QColor verdictColour(TriangleState state, const QPalette& palette);

/// Draws a small rectangle that shows a state as the pictures do: outside the frustum as a wireframe, wrongly culled hatched, the
/// others filled.
void drawVerdictSwatch(QPainter& painter, const QRectF& place, TriangleState state, const QPalette& palette);

/// The same rectangle as an icon that follows the application's palette.
[[nodiscard]] QIcon verdictIcon(TriangleState state);
/// One for what has parts of both states.
[[nodiscard]] QIcon verdictIcon(TriangleState left, TriangleState right);

/// The same rectangle as a widget of 14 × 14 pixels.
class VerdictSwatch : public QWidget {
    Q_OBJECT

public:
    explicit VerdictSwatch(TriangleState state, QWidget* parent = nullptr);

    void setState(TriangleState state);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    TriangleState m_state;
};

}  // namespace cullscope::ui
