#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>

#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// A plot on white as an SVG document of a size in pixels, text as text.
[[nodiscard]] QByteArray plotSvg(const PlotWidget& plot, const QSize& size);

/// A plot on white as an image, two pixels a unit of the size.
[[nodiscard]] QImage plotImage(const PlotWidget& plot, const QSize& size);
/// The same as a PNG file.
[[nodiscard]] QByteArray plotPng(const PlotWidget& plot, const QSize& size);

/// A plot on white as a PDF document of one page of a size in pixels of 1/96 inch, text as text in embedded fonts.
[[nodiscard]] QByteArray plotPdf(const PlotWidget& plot, const QSize& size);

}  // namespace cullscope::ui
