#include "ui/plots/plot_file.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "ui/look/appearance.h"

namespace cullscope::ui {

namespace {

constexpr int kTextPixels = 13;
constexpr int kResolution = 96;  // pixels an inch
constexpr int kImagePixels = 2;  // a unit

void paintOn(QPaintDevice& device, const PlotWidget& plot, const QSize& size) {
    const QPalette palette = Appearance::palette(false);
    QFont font = plot.font();
    font.setPixelSize(kTextPixels);
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    painter.fillRect(QRect(QPoint(), size), palette.color(QPalette::Base));
    plot.paintPlot(painter, QRectF(QPointF(), size), palette);
}

}  // namespace

QByteArray plotSvg(const PlotWidget& plot, const QSize& size) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kResolution);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(plot.title());
    paintOn(generator, plot, size);
    return buffer.data();
}

QImage plotImage(const PlotWidget& plot, const QSize& size) {
    QImage image(size * kImagePixels, QImage::Format_RGB32);
    image.setDevicePixelRatio(kImagePixels);
    paintOn(image, plot, size);
    return image;
}

QByteArray plotPng(const PlotWidget& plot, const QSize& size) {
    QImage image = plotImage(plot, size);
    image.setText(QStringLiteral("Title"), plot.title());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

QByteArray plotPdf(const PlotWidget& plot, const QSize& size) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(kResolution);
        writer.setTitle(plot.title());
        writer.setPageSize(QPageSize(QSizeF(size) * 72.0 / kResolution, QPageSize::Point, {}, QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF());
        paintOn(writer, plot, size);
    }
    return buffer.data();
}

}  // namespace cullscope::ui
