#include "ui/views/orientation_gizmo.h"

#include <algorithm>

namespace cullscope::ui {

namespace {

constexpr double kAxisReach = 34.0;   // from the middle to an end, in a picture of more than kRoomy
constexpr double kSmallReach = 20.0;  // in a smaller one
constexpr double kBallShare = 0.26;   // of the reach
constexpr double kGizmoMargin = 6.0;
constexpr double kRoomy = 360.0;        // width of a picture
constexpr double kLettersOfBall = 1.5;  // height of the letters, in radii of the ball around them

// The usual colours of the axes, dark enough for white letters, and distinct from the colours of the verdicts.
constexpr std::array kColours{QColor(178, 62, 62), QColor(62, 128, 62), QColor(66, 92, 170)};
constexpr std::array kNames{"X", "Y", "Z"};

}  // namespace

bool OrientationGizmo::hasRoom(const QRectF& picture, double unit, int letters) {
    return letters == 0 || picture.width() > unit * kRoomy;
}

OrientationGizmo::OrientationGizmo(const View& camera, const QRectF& picture, double unit, int letters) : m_unit(unit) {
    double reach = unit * (picture.width() > unit * kRoomy ? kAxisReach : kSmallReach);
    m_ball = kBallShare * reach;
    m_letters = std::max(9, int(kLettersOfBall * m_ball));
    if (m_letters < letters) {
        m_letters = letters;
        m_ball = letters / kLettersOfBall;
        reach = m_ball / kBallShare;
    }
    const double away = kGizmoMargin * unit + reach + m_ball;
    m_middle = picture.bottomLeft() + QPointF(away, -away);
    const Frustum& frustum = camera.frustum();
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            End& end = m_ends[size_t(2 * axis + (sign > 0.0 ? 0 : 1))];
            end.axis = axis;
            end.direction[axis] = sign;
            end.place = m_middle + reach * QPointF(glm::dot(end.direction, frustum.right), -glm::dot(end.direction, frustum.up));
            end.towards = -glm::dot(end.direction, frustum.forward);
        }
    std::stable_sort(m_ends.begin(), m_ends.end(), [](const End& a, const End& b) { return a.towards < b.towards; });
}

void OrientationGizmo::paint(QPainter& painter) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(m_letters);
    font.setBold(true);
    painter.setFont(font);
    // The lines first: none crosses a letter.
    for (const End& end : m_ends)
        if (positive(end)) paintLine(painter, end);
    for (const End& end : m_ends) paintEnd(painter, end);
    painter.restore();
}

void OrientationGizmo::paintLine(QPainter& painter, const End& end) const {
    painter.setPen(QPen(kColours[size_t(end.axis)], 2.0 * m_unit));
    painter.drawLine(m_middle, end.place);
}

void OrientationGizmo::paintEnd(QPainter& painter, const End& end) const {
    const QColor& colour = kColours[size_t(end.axis)];
    const QRectF ball(end.place - QPointF(m_ball, m_ball), 2.0 * QSizeF(m_ball, m_ball));
    if (positive(end)) {
        painter.setPen(QPen(colour, 2.0 * m_unit));
        painter.setBrush(colour);
        painter.drawEllipse(ball);
        painter.setPen(Qt::white);
        painter.drawText(ball, Qt::AlignCenter, QString::fromLatin1(kNames[size_t(end.axis)]));
        return;
    }
    QColor pale = colour;
    pale.setAlphaF(0.25f);
    painter.setPen(QPen(colour, 1.5 * m_unit));
    painter.setBrush(pale);
    const double inset = 0.2 * m_ball;
    painter.drawEllipse(ball.adjusted(inset, inset, -inset, -inset));
}

std::optional<Vec3> OrientationGizmo::directionAt(const QPointF& point) const {
    // The ends are sorted from far to near: test the front ones first.
    for (auto end = m_ends.rbegin(); end != m_ends.rend(); ++end) {
        const QPointF offset = point - end->place;
        if (QPointF::dotProduct(offset, offset) <= m_ball * m_ball) return end->direction;
    }
    return std::nullopt;
}

}  // namespace cullscope::ui
