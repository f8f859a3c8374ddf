#include "ui/plots/plot_widget.h"

#include <QEvent>
#include <cmath>

#include "ui/plots/plot_painter.h"

namespace cullscope::ui {

namespace {

constexpr int kMargin = 12;

}  // namespace

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
}

void PlotWidget::setMeasuring(bool measuring) {
    m_measuring = measuring;
    contentsChanged();
}

void PlotWidget::setEmptySentence(const QString& sentence) {
    m_emptySentence = sentence;
    contentsChanged();
}

QString PlotWidget::emptySentence() const {
    if (m_measuring) return tr("Being measured…");
    if (!m_emptySentence.isNull()) return m_emptySentence;
    return tr("Nothing is measured yet. Choose a camera path above and press Start.");
}

void PlotWidget::contentsChanged() {
    setAccessibleName(title());
    setAccessibleDescription(empty() ? emptySentence() : description());
    setMinimumHeight(empty() ? 0 : neededHeight(width()));
    update();
}

PlotDrawing PlotWidget::drawing() const {
    return drawPlots(plots(palette()), width(), height(), plotStyle(font(), PlotColours(palette())));
}

void PlotWidget::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotStyle style = plotStyle(painter.font(), PlotColours(palette));
    painter.save();
    painter.translate(place.topLeft());
    paintDrawing(painter, drawPlots(plots(palette), place.width(), place.height(), style));
    painter.restore();
}

int PlotWidget::neededHeight(int width) const {
    return int(std::ceil(cullscope::neededHeight(plots(palette()), width, plotStyle(font(), PlotColours(palette())))));
}

void PlotWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (!empty()) return paintPlot(painter, rect(), palette());
    painter.setPen(PlotColours(palette()).text);
    painter.drawText(rect().adjusted(kMargin, 0, -kMargin, 0), Qt::AlignCenter | Qt::TextWordWrap, emptySentence());
}

void PlotWidget::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // The constructor changes the palette too, before there is anything to ask for a title.
    if (!testAttribute(Qt::WA_WState_Polished)) return;
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        contentsChanged();
}

void PlotWidget::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setMinimumHeight(empty() ? 0 : neededHeight(width()));
}

void PlotWidget::showEvent(QShowEvent* event) {
    contentsChanged();
    QWidget::showEvent(event);
}

}  // namespace cullscope::ui
