#include "ui/views/pick_painter.h"

#include <utility>

#include "core/scene/eye_triangle.h"
#include "ui/look/in_hand.h"
#include "ui/models/prediction_model.h"

namespace cullscope::ui {

namespace {

constexpr double kSmall = 8.0;  // extent of a triangle in the window below which a ring marks it
constexpr double kMarkRadius = 8.0;
constexpr double kNearestShare = 1e-6;  // of w; points with less, at or behind the eye plane, are clipped
const QColor kLine(255, 255, 255);
const QColor kEdge(0, 0, 0);
constexpr double kNamedSize = 1.6;                         // of a mark in a question, in lines of text
constexpr size_t kMostMarks = 40;                          // of triangles; more are only filled
constexpr size_t kMostOutlined = 200, kMostFilled = 2000;  // triangles; more are marked by a dot each
constexpr double kDot = 3.0;
constexpr int kPlaneOpacity = 56;  // of 255
constexpr int kOwnOpacity = 112;

/// Draws a line that is visible on any background: light with a dark edge.
template <typename Draw>
void twice(QPainter& painter, double width, Qt::PenStyle style, const Draw& draw) {
    painter.setPen(QPen(kEdge, width + 2.0));
    draw();
    painter.setPen(QPen(kLine, width, style));
    draw();
}

class Projection {
public:
    Projection(const View& view, const PictureLayout& layout) : m_view(view), m_layout(layout) {}

    /// The line in the window, clipped at the eye plane; none: it lies completely behind the eye.
    [[nodiscard]] std::optional<QLineF> line(const Vec3& a, const Vec3& b) const {
        Vec4 from = m_view.clipFromEyeRelative() * Vec4(a, 1.0), to = m_view.clipFromEyeRelative() * Vec4(b, 1.0);
        const double least = kNearestShare * std::max(std::abs(from.w), std::abs(to.w));
        if (from.w < least && to.w < least) return std::nullopt;
        if (from.w < least) from += (least - from.w) / (to.w - from.w) * (to - from);
        if (to.w < least) to += (least - to.w) / (from.w - to.w) * (from - to);
        return QLineF(place(from), place(to));
    }

    /// A convex polygon in the window, clipped at the eye plane.
    [[nodiscard]] QPolygonF polygon(const std::vector<Vec3>& corners) const {
        std::vector<Vec4> clip;
        double farthest = 0.0;
        for (const Vec3& corner : corners) {
            clip.push_back(m_view.clipFromEyeRelative() * Vec4(corner, 1.0));
            farthest = std::max(farthest, std::abs(clip.back().w));
        }
        const double least = kNearestShare * farthest;
        QPolygonF result;
        for (size_t i = 0; i < clip.size(); ++i) {
            const Vec4 &from = clip[i], &to = clip[(i + 1) % clip.size()];
            if (from.w >= least) result << place(from);
            if ((from.w >= least) != (to.w >= least)) result << place(from + (least - from.w) / (to.w - from.w) * (to - from));
        }
        return result;
    }

private:
    [[nodiscard]] QPointF place(const Vec4& clip) const {
        const Viewport& size = m_view.viewport();
        return m_layout.positionOf({(clip.x / clip.w * 0.5 + 0.5) * size.width, (clip.y / clip.w * 0.5 + 0.5) * size.height});
    }

    const View& m_view;
    const PictureLayout& m_layout;
};

QVector<QLineF> boxLines(const Projection& projection, const Box3& box, const Vec3& eye) {
    QVector<QLineF> lines;
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1) != 0) continue;
            const auto at = [&](int which) {
                return Vec3((which & 1) != 0 ? box.max.x : box.min.x, (which & 2) != 0 ? box.max.y : box.min.y,
                            (which & 4) != 0 ? box.max.z : box.min.z) -
                       eye;
            };
            if (const auto line = projection.line(at(corner), at(corner | 1 << axis))) lines << *line;
        }
    return lines;
}

QVector<QLineF> triangleLines(const Projection& projection, const std::array<Vec3, 3>& corners) {
    QVector<QLineF> lines;
    for (size_t i = 0; i < 3; ++i)
        if (const auto line = projection.line(corners[i], corners[(i + 1) % 3])) lines << *line;
    return lines;
}

/// The middle of a named item, relative to the eye; none: it is a part that is not known any more.
std::optional<Vec3> middleOf(const Scene& scene, const Prediction& prediction, const NamedParts* parts, size_t place,
                             const Vec3& eye) {
    const uint64_t item = prediction.items[place];
    if (prediction.of == Prediction::Items::Parts)
        return parts && item < parts->parts.size() ? std::optional(parts->middleOf(scene, item) - eye) : std::nullopt;
    if (prediction.of == Prediction::Items::Objects) return scene.instanceBox(item).centre() - eye;
    const size_t instance = scene.instanceOf(item);
    const std::array<Vec3, 3> corners = InstanceFromEye(scene, instance, eye).corners(item - scene.firstTriangle(instance));
    return (corners[0] + corners[1] + corners[2]) / 3.0;
}

/// Fills triangles of the scene, by their numbers.
void fillTriangles(QPainter& painter, const Projection& projection, const Scene& scene, const std::vector<uint64_t>& triangles,
                   const Vec3& eye) {
    QPolygonF dots;
    painter.setPen(triangles.size() > kMostOutlined ? QPen(Qt::NoPen) : QPen(kInHandEdge, 0.5));
    painter.setBrush(QColor(kInHandColour.red(), kInHandColour.green(), kInHandColour.blue(), kOwnOpacity));
    for (const uint64_t triangle : triangles) {
        const size_t instance = scene.instanceOf(triangle);
        const auto [a, b, c] = InstanceFromEye(scene, instance, eye).corners(triangle - scene.firstTriangle(instance));
        const Vec3 middle = (a + b + c) / 3.0;
        if (triangles.size() <= kMostFilled)
            painter.drawPolygon(projection.polygon({a, b, c}));
        else if (const std::optional<QLineF> place = projection.line(middle, middle))
            dots << place->p1();
    }
    painter.setPen(QPen(kInHandColour, kDot));
    painter.drawPoints(dots);
}

/// What the mark of a named item says.
QString markText(const Prediction& prediction, const NamedParts* parts, size_t place) {
    if (prediction.question == Prediction::Question::Order) return QString::number(place + 1);
    if (prediction.question == Prediction::Question::Vanish || !parts) return QStringLiteral("✗");
    const std::optional<size_t> expected = place < prediction.places.size() ? prediction.places[place] : std::nullopt;
    const bool known = expected && *expected < parts->places.size();
    const std::string where = known ? PredictionModel::placeName(*parts, *expected).toStdString() : "?";
    return QString::fromStdString(parts->parts[prediction.items[place]].name + ": " + where);
}

}  // namespace

void paintPick(QPainter& painter, const Scene& opened, const Pick& pick, const std::optional<Vec3>& before, const View& viewing,
               const PictureLayout& layout) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (opened.instances().size() > 1) {
        const QVector<QLineF> lines = boxLines(projection, opened.instanceBox(pick.object), viewing.eye());
        twice(painter, 1.0, Qt::DashLine, [&] { painter.drawLines(lines); });
    }
    if (before)
        if (const std::optional<QLineF> way = projection.line(*before - viewing.eye(), pick.point - viewing.eye()))
            twice(painter, 1.0, Qt::DotLine, [&] { painter.drawLine(*way); });
    const uint64_t own = pick.triangle - opened.firstTriangle(pick.object);
    const QVector<QLineF> lines = triangleLines(projection, InstanceFromEye(opened, pick.object, viewing.eye()).corners(own));
    QPolygonF extent;
    for (const QLineF& line : lines) extent << line.p1() << line.p2();
    const QRectF bounds = extent.boundingRect();
    if (!lines.isEmpty()) {
        twice(painter, 1.5, Qt::SolidLine, [&] { painter.drawLines(lines); });
        if (std::max(bounds.width(), bounds.height()) < kSmall)
            twice(painter, 1.5, Qt::SolidLine, [&] { painter.drawEllipse(bounds.center(), kMarkRadius, kMarkRadius); });
    }
    painter.restore();
}

void paintSubject(QPainter& painter, const SubjectShape& shape, const View& viewing, const PictureLayout& layout, bool ownPicture,
                  double unit) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    QVector<QLineF> lines;
    for (const Box3& box : shape.boxes) lines << boxLines(projection, box, viewing.eye());
    for (const std::vector<Vec3>& outline : shape.polygons)
        for (size_t i = 0; i < outline.size(); ++i)
            if (const auto line = projection.line(outline[i] - viewing.eye(), outline[(i + 1) % outline.size()] - viewing.eye()))
                lines << *line;
    for (std::array<Vec3, 3> corners : shape.triangles) {
        for (Vec3& corner : corners) corner -= viewing.eye();
        lines << triangleLines(projection, corners);
    }
    const auto addLines = [&](const std::vector<std::vector<Vec3>>& through) {
        for (const std::vector<Vec3>& points : through)
            for (size_t i = 1; i < points.size(); ++i)
                if (const auto line = projection.line(points[i - 1] - viewing.eye(), points[i] - viewing.eye())) lines << *line;
    };
    addLines(shape.lines);
    if (!ownPicture) addLines(shape.sight);
    const QVector<QLineF> own = std::exchange(lines, {});
    addLines(shape.compared);
    const auto draw = [&](const QColor& colour, double width) {
        if (!lines.isEmpty()) {
            painter.setPen(QPen(colour, width, colour == kInHandColour ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
            painter.drawLines(lines);
        }
        // With round ends Qt strokes 1,500 lines nine times as long.
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap));
        painter.drawLines(own);
        if (!shape.pixels || !ownPicture) return;
        painter.drawRect(QRectF(layout.positionOf((*shape.pixels)[0]), layout.positionOf((*shape.pixels)[1])).normalized());
    };
    draw(kInHandEdge, kInHandEdgeWidth * unit);
    draw(kInHandColour, kInHandWidth * unit);
    painter.restore();
}

void paintGroup(QPainter& painter, const SubjectShape& shape, const View& viewing, const PictureLayout& layout) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const Box3& box : shape.boxes) {
        const QVector<QLineF> lines = boxLines(projection, box, viewing.eye());
        twice(painter, 1.0, Qt::DashLine, [&] { painter.drawLines(lines); });
    }
    const auto fill = [&](std::vector<Vec3> corners, int opacity, double edge) {
        for (Vec3& corner : corners) corner -= viewing.eye();
        const QPolygonF polygon = projection.polygon(corners);
        painter.setBrush(QColor(kInHandColour.red(), kInHandColour.green(), kInHandColour.blue(), opacity));
        painter.setPen(QPen(kEdge, edge + 2.0));
        painter.drawPolygon(polygon);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(kInHandColour, edge));
        painter.drawPolygon(polygon);
    };
    for (const std::vector<Vec3>& outline : shape.polygons) fill(outline, kPlaneOpacity, 1.5);
    for (const std::array<Vec3, 3>& corners : shape.triangles) fill({corners.begin(), corners.end()}, kOwnOpacity, 1.0);
    painter.restore();
}

void paintPrediction(QPainter& painter, const Scene& scene, const Prediction& prediction, const NamedParts* parts,
                     const View& viewing, const PictureLayout& layout) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    const double height = QFontMetricsF(painter.font(), painter.device()).height() * kNamedSize;
    size_t marks = prediction.items.size();
    if (prediction.of == Prediction::Items::Triangles && prediction.question == Prediction::Question::Vanish) {
        fillTriangles(painter, projection, scene, prediction.items, viewing.eye());
        if (marks > kMostMarks) marks = 0;
    }
    for (size_t i = 0; i < marks; ++i) {
        const std::optional<Vec3> middle = middleOf(scene, prediction, parts, i, viewing.eye());
        const std::optional<QLineF> place = middle ? projection.line(*middle, *middle) : std::nullopt;
        if (!place) continue;
        const QString text = markText(prediction, parts, i);
        const double width =
            std::max(height, QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(text) + 0.6 * height);
        const QRectF disc(place->x1() - width / 2.0, place->y1() - height / 2.0, width, height);
        painter.setPen(QPen(kEdge, 2.0));
        painter.setBrush(kInHandColour);
        painter.drawRoundedRect(disc, height / 2.0, height / 2.0);
        painter.drawText(disc, Qt::AlignCenter, text);
    }
    painter.restore();
}

void paintRegion(QPainter& painter, const QRectF& region, const PictureLayout& layout) {
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setBrush(QColor(kInHandColour.red(), kInHandColour.green(), kInHandColour.blue(), kPlaneOpacity));
    painter.setPen(QPen(kInHandEdge, kInHandEdgeWidth));
    painter.drawRect(region);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kInHandColour, kInHandWidth, Qt::DashLine));
    painter.drawRect(region);
    painter.restore();
}

}  // namespace cullscope::ui
