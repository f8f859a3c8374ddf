#include "ui/views/pick_painter.h"

#include "core/scene/eye_triangle.h"
#include "ui/look/in_hand.h"

namespace cullscope::ui {

namespace {

constexpr double kSmall = 8.0;  // extent of a triangle in the window below which a ring marks it
constexpr double kRing = 8.0;
constexpr double kNearestShare = 1e-6;  // of w; points with less, at or behind the eye plane, are clipped
const QColor kLine(255, 255, 255);
const QColor kEdge(0, 0, 0);
constexpr double kNamedSize = 1.6;  // of a mark in a question, in lines of text

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

}  // namespace

void paintPick(QPainter& painter, const Scene& opened, const Pick& pick, const View& viewing, const PictureLayout& layout) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (opened.instances().size() > 1) {
        const QVector<QLineF> lines = boxLines(projection, opened.instanceBox(pick.object), viewing.eye());
        twice(painter, 1.0, Qt::DashLine, [&] { painter.drawLines(lines); });
    }
    const uint64_t own = pick.triangle - opened.firstTriangle(pick.object);
    const QVector<QLineF> lines = triangleLines(projection, InstanceFromEye(opened, pick.object, viewing.eye()).corners(own));
    QPolygonF extent;
    for (const QLineF& line : lines) extent << line.p1() << line.p2();
    const QRectF bounds = extent.boundingRect();
    if (!lines.isEmpty()) {
        twice(painter, 1.5, Qt::SolidLine, [&] { painter.drawLines(lines); });
        if (std::max(bounds.width(), bounds.height()) < kSmall)
            twice(painter, 1.5, Qt::SolidLine, [&] { painter.drawEllipse(bounds.center(), kRing, kRing); });
    }
    painter.restore();
}

void paintSubject(QPainter& painter, const SubjectShape& shape, const View& viewing, const PictureLayout& layout,
                  bool ownPicture) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    QVector<QLineF> lines;
    for (const Box3& box : shape.boxes) lines << boxLines(projection, box, viewing.eye());
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
    const auto draw = [&](const QColor& colour, double width) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines);
        if (!shape.pixels || !ownPicture) return;
        painter.drawRect(QRectF(layout.positionOf((*shape.pixels)[0]), layout.positionOf((*shape.pixels)[1])).normalized());
    };
    draw(kInHandEdge, kInHandEdgeWidth);
    draw(kInHandColour, kInHandWidth);
    painter.restore();
}

void paintPrediction(QPainter& painter, const Scene& scene, const Prediction& prediction, const View& viewing,
                     const PictureLayout& layout) {
    const Projection projection(viewing, layout);
    painter.save();
    painter.setClipRect(layout.rect(), Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    const double height = QFontMetricsF(painter.font(), painter.device()).height() * kNamedSize;
    for (size_t i = 0; i < prediction.items.size(); ++i) {
        const uint64_t item = prediction.items[i];
        const size_t instance = prediction.ofTriangles ? scene.instanceOf(item) : item;
        Vec3 middle = scene.instanceBox(instance).centre() - viewing.eye();
        if (prediction.ofTriangles) {
            const std::array<Vec3, 3> corners =
                InstanceFromEye(scene, instance, viewing.eye()).corners(item - scene.firstTriangle(instance));
            middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        }
        const std::optional<QLineF> place = projection.line(middle, middle);
        if (!place) continue;
        const QRectF disc(place->x1() - height / 2.0, place->y1() - height / 2.0, height, height);
        painter.setPen(QPen(kEdge, 2.0));
        painter.setBrush(kInHandColour);
        painter.drawEllipse(disc);
        const bool ordered = prediction.question == Prediction::Question::Order;
        painter.drawText(disc, Qt::AlignCenter, ordered ? QString::number(i + 1) : QStringLiteral("✗"));
    }
    painter.restore();
}

}  // namespace cullscope::ui
