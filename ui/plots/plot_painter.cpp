#include "ui/plots/plot_painter.h"

#include <QLocale>
#include <QPolygonF>

namespace cullscope::ui {

namespace {

QString numberText(double value) {
    const QString plain = QString::fromStdString(plotNumber(value));
    // Powers of ten far from 1 stay as core writes them.
    if (plain.contains(QLatin1Char('e'))) return plain;
    const qsizetype point = plain.indexOf(QLatin1Char('.'));
    return QLocale().toString(value, 'f', point < 0 ? 0 : int(plain.size() - point - 1));
}

void setUp(QPainter& painter, const PlotPen& pen, PlotColour fill) {
    QPen outline(QColor::fromRgba(pen.colour), pen.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    // Qt measures dashes in widths of the pen.
    QList<qreal> dashes;
    for (const double pixels : dashesOf(pen.stroke)) dashes << pixels / pen.width;
    if (!dashes.isEmpty()) outline.setDashPattern(dashes);
    painter.setPen(pen.colour == 0 ? QPen(Qt::NoPen) : outline);
    painter.setBrush(fill == 0 ? QBrush(Qt::NoBrush) : QBrush(QColor::fromRgba(fill)));
}

void paint(QPainter& painter, const DrawnPath& path) {
    setUp(painter, path.pen, path.fill);
    QPolygonF points;
    for (const PlotPoint& point : path.points) points << QPointF(point.x, point.y);
    if (path.fill == 0)
        painter.drawPolyline(points);
    else
        painter.drawPolygon(points);
}

void paint(QPainter& painter, const DrawnDisc& disc) {
    setUp(painter, disc.pen, disc.fill);
    painter.drawEllipse(QPointF(disc.centre.x, disc.centre.y), disc.radius, disc.radius);
}

void paint(QPainter& painter, const DrawnText& text) {
    const QFont plain = painter.font();
    QFont font = plain;
    font.setBold(text.bold);
    const QString words = QString::fromStdString(text.words);
    const double width = QFontMetricsF(font).horizontalAdvance(words);
    const double share = text.anchor == TextAnchor::Start ? 0.0 : text.anchor == TextAnchor::Middle ? 0.5 : 1.0;
    painter.setFont(font);
    painter.setPen(QColor::fromRgba(text.colour));
    painter.drawText(QPointF(text.at.x - share * width, text.at.y), words);
    painter.setFont(plain);
}

}  // namespace

PlotStyle plotStyle(const QFont& font, const PlotColours& colours) {
    const QFontMetricsF metrics(font);
    PlotStyle style;
    style.text = colours.text.rgba();
    style.faint = colours.faintText.rgba();
    style.grid = colours.grid.rgba();
    style.series = plotSeries(colours.dark);
    style.ascent = metrics.ascent();
    style.height = metrics.height();
    style.width = [metrics](const std::string& words) { return metrics.horizontalAdvance(QString::fromStdString(words)); };
    style.number = [](double value) { return numberText(value).toStdString(); };
    return style;
}

void paintDrawing(QPainter& painter, const PlotDrawing& drawing) {
    for (const auto& item : drawing.items) std::visit([&](const auto& drawn) { paint(painter, drawn); }, item);
}

}  // namespace cullscope::ui
