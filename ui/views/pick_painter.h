#pragma once

#include <QPainter>

#include "ui/session/session.h"
#include "ui/views/picture_layout.h"

namespace cullscope::ui {

/// Marks the pick over a picture: the outline of the triangle, a ring around a triangle too small to be seen, and the box of the
/// object if the scene has several. Drawn on top of the picture, so that hidden and culled objects are marked too.
/// `before`: the point from which a dashed line measures the distance; none: there is no line.
void paintPick(QPainter& painter, const Scene& opened, const Pick& pick, const std::optional<Vec3>& before, const View& viewing,
               const PictureLayout& layout);

/// Marks the subject in hand of a stepped view: its boxes, triangles and lines, and with dashes what it is compared with; its
/// rectangle of the picture where the picture is the culling view's (`ownPicture`), elsewhere what the culling eye sees through
/// it. `unit`: the scale of the lines' widths.
void paintSubject(QPainter& painter, const SubjectShape& shape, const View& viewing, const PictureLayout& layout, bool ownPicture,
                  double unit = 1.0);

/// Marks a group of what a strategy built: its box with dashes, what divides it and its triangles filled.
void paintGroup(QPainter& painter, const SubjectShape& shape, const View& viewing, const PictureLayout& layout);

/// Marks what was named in an open question: with its place in an order, or the name of its place, else with a cross; triangles
/// that are expected to vanish are filled as well, of many only that, and of very many only a dot each. `parts`: of a question
/// about parts, else null.
void paintPrediction(QPainter& painter, const Scene& scene, const Prediction& prediction, const NamedParts* parts,
                     const View& viewing, const PictureLayout& layout);

/// A rectangle of the window that is being dragged.
void paintRegion(QPainter& painter, const QRectF& region, const PictureLayout& layout);

}  // namespace cullscope::ui
