#include "ui/plots/line_plot_widget.h"

#include <QLocale>

#include "ui/text/translated.h"

namespace cullscope::ui {

LinePlotWidget::LinePlotWidget(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void LinePlotWidget::setPlot(const LinePlot& plot) {
    m_plot = plot;
    contentsChanged();
}

QString LinePlotWidget::title() const { return m_plot.heading.empty() ? translated(m_plot.title) : translated(m_plot.heading); }

QString LinePlotWidget::description() const {
    QStringList lines;
    for (const PlotLine& line : m_plot.lines) {
        QStringList numbers;
        for (const PlotPoint& point : line.points) numbers << QLocale().toString(point.y, 'g', 3);
        lines << QStringLiteral("%1: %2").arg(translated(line.name), numbers.join(QLatin1Char(' ')));
    }
    for (const PlotReference& reference : m_plot.references)
        lines << QStringLiteral("%1 %2").arg(translated(reference.name), QLocale().toString(reference.y));
    return lines.join(QLatin1Char('\n'));
}

std::vector<LinePlot> LinePlotWidget::plots(const QPalette& /*palette*/) const {
    LinePlot plot = m_plot;
    const auto translate = [](std::string& text) { text = translated(text).toStdString(); };
    plot.title = title().toStdString();
    for (std::string* text : {&plot.x.title, &plot.y.title}) translate(*text);
    for (PlotLine& line : plot.lines) translate(line.name);
    for (PlotReference& reference : plot.references) translate(reference.name);
    for (PlotMark& mark : plot.marks) translate(mark.name);
    return {std::move(plot)};
}

}  // namespace cullscope::ui
