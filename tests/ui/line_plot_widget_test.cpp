#include "ui/plots/line_plot_widget.h"

#include <gtest/gtest.h>

#include <QImage>

#include "ui/look/appearance.h"
#include "ui/plots/plot_file.h"
#include "ui/text/language.h"

namespace cullscope::ui::line_plot_widget_test {
namespace {

LinePlot madeUp() {
    LinePlot plot;
    plot.title = "Frames per second by viewpoint";
    plot.x = {"viewpoint", PlotScale::Linear, 1.0, 40.0};
    plot.y = {"frames per second", PlotScale::Logarithmic};
    PlotLine line;
    line.name = "frustum";
    line.points = {{1, 20}, {2, 30}, {3, 0}, {4, 25}};
    plot.lines = {line};
    plot.references = {{"paper, every bunny drawn:", 0.83}};
    return plot;
}

/// The number of pixels of one colour in a picture of the plot.
int pixelsOf(const LinePlotWidget& widget, const QColor& colour, bool dark) {
    QImage image(600, 300, QImage::Format_RGB32);
    const QPalette palette = Appearance::palette(dark);
    image.fill(palette.color(QPalette::Base));
    QPainter painter(&image);
    widget.paintPlot(painter, image.rect(), palette);
    painter.end();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

TEST(LinePlotWidget, lineIsPainted) {
    for (const bool dark : {false, true}) {
        LinePlotWidget widget;
        LinePlot plot = madeUp();
        widget.setPlot(plot);
        const QColor colour = PlotColours(Appearance::palette(dark)).series(0);
        const int painted = pixelsOf(widget, colour, dark);
        EXPECT_GT(painted, 30) << dark;
        plot.lines[0].points.clear();
        widget.setPlot(plot);
        EXPECT_LT(pixelsOf(widget, colour, dark), painted) << "the legend alone has as much of it";
    }
}

TEST(LinePlotWidget, aLongLegendStaysWithinTheNeededHeight) {
    LinePlot plot = madeUp();
    plot.lines.resize(11, plot.lines.front());
    LinePlotWidget widget;
    widget.setPlot(plot);
    const QPalette palette = Appearance::palette(false);
    for (const int width : {260, 500, 700, 1100}) {
        const int height = widget.neededHeight(width);
        QImage image(width, height + 100, QImage::Format_RGB32);
        image.fill(palette.color(QPalette::Base));
        const QImage ground = image.copy(0, height, width, 100);
        QPainter painter(&image);
        widget.paintPlot(painter, QRect(0, 0, width, height), palette);
        painter.end();
        EXPECT_EQ(image.copy(0, height, width, 100), ground) << "something stands below a plot as wide as " << width;
    }
}

TEST(LinePlotWidget, textIsTextInTheFile) {
    LinePlotWidget widget;
    widget.setPlot(madeUp());
    const QByteArray svg = plotSvg(widget, {900, 400});
    for (const char* words : {"frustum", "paper, every bunny drawn: 0.83", ">0.83<", ">10<", ">40<", "viewpoint"})
        EXPECT_TRUE(svg.contains(words)) << words;
}

TEST(LinePlotWidget, whoCannotSeeItIsToldItsPoints) {
    LinePlotWidget widget;
    EXPECT_TRUE(widget.empty());
    widget.setPlot(madeUp());
    EXPECT_FALSE(widget.empty());
    EXPECT_EQ(widget.accessibleName(), QStringLiteral("Frames per second by viewpoint"));
    EXPECT_TRUE(widget.accessibleDescription().contains(QStringLiteral("frustum: 20 30 0 25")))
        << widget.accessibleDescription().toStdString();
    EXPECT_TRUE(widget.accessibleDescription().contains(QStringLiteral("0.83")));
}

TEST(LinePlotWidget, plotWithoutLinesOrLevelsCanBePainted) {
    LinePlotWidget widget;
    LinePlot plot = madeUp();
    plot.lines.clear();
    widget.setPlot(plot);
    EXPECT_TRUE(plotSvg(widget, {300, 160}).contains(">0.83<"));
    plot.references.clear();
    widget.setPlot(plot);
    EXPECT_TRUE(plotSvg(widget, {300, 160}).contains("viewpoint"));
}

TEST(LinePlotWidget, titleIsTranslatedWithItsValues) {
    Language language;
    LinePlot plot;
    plot.heading = {"Loss by threshold: %1", {"huldra"}};
    plot.title = plot.heading.english();
    LinePlotWidget widget;
    widget.setPlot(plot);
    EXPECT_EQ(widget.title(), QStringLiteral("Loss by threshold: huldra"));
    language.use(QStringLiteral("ko"));
    EXPECT_TRUE(widget.title().contains(QStringLiteral("huldra"))) << widget.title().toStdString();
    EXPECT_FALSE(widget.title().contains(QStringLiteral("Loss"))) << widget.title().toStdString();
    EXPECT_EQ(widget.plots(widget.palette()).front().title, widget.title().toStdString());
    language.use(QStringLiteral("en"));
}

}  // namespace
}  // namespace cullscope::ui::line_plot_widget_test
