#include "ui/screenshots/screenshot_layout.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QGuiApplication>
#include <cmath>

#include "core/base/error.h"
#include "core/scene/camera.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kFontPixels = 14.0;
constexpr double kMarkRoom = 18.0;   // width of a mark and the gap before its text
constexpr double kLeastUnit = 0.75;  // smaller text cannot be read
constexpr int kFewestPicturePixels = 16;

/// Converts lengths in units into pixels.
struct Units {
    double unit;

    [[nodiscard]] int operator()(double length) const { return std::max(1, int(std::lround(length * unit))); }
};

QFont fontOf(double pixels) {
    QFont font = QGuiApplication::font();
    font.setPixelSize(std::max(1, int(std::lround(pixels))));
    return font;
}

int columnsOf(size_t views) { return int(views > 2 ? views / 2 : views); }
int rowsOf(size_t views) { return views > 2 ? 2 : 1; }

/// Places the legend's entries from left to right in as many rows as needed. Returns the height.
int layOutLegend(ScreenshotPlan& plan, const Units& units, int width, uint64_t largestCount) {
    if (plan.legend.empty()) return 0;
    const QFontMetrics metrics(plan.font);
    const int row = std::max(metrics.height(), units(16.0)) + units(4.0), margin = units(8.0);
    int x = margin, y = units(6.0);
    for (LegendEntry& entry : plan.legend) {
        const QString widest = legendText(entry, largestCount);
        const int length = row + units(4.0) + metrics.horizontalAdvance(widest);
        if (x > margin && x + length > width - margin) {
            x = margin;
            y += row;
        }
        entry.place = QRect(x, y, std::min(length, width - 2 * margin), row);
        // A heading has no mark: its text begins where the marks of the other entries do.
        if (!entry.state && entry.colour.alpha() == 0) entry.place.setLeft(x - units(kMarkRoom));
        x += length + units(14.0);
    }
    return y + row;
}

int layOutCaption(ScreenshotPlan& plan, const Units& units, int top, int width) {
    if (plan.caption.isEmpty()) return 0;
    const int margin = units(8.0), inset = units(6.0);
    const QRect room(margin, top + inset, std::max(1, width - 2 * margin), kMostPixels);
    plan.captionPlace = QFontMetrics(plan.font).boundingRect(room, Qt::TextWordWrap, plan.caption);
    plan.captionPlace.setLeft(room.left());
    plan.captionPlace.setWidth(room.width());
    return plan.captionPlace.height() + 2 * inset;
}

/// Places legend and caption from y = 0 on. Returns their height.
int layOutBelow(ScreenshotPlan& plan, const Units& units, int width, uint64_t largestCount) {
    const int legend = layOutLegend(plan, units, width, largestCount);
    const int caption = layOutCaption(plan, units, legend, width);
    return legend + caption + (legend > 0 && caption == 0 ? units(6.0) : 0);
}

/// Places the pictures, all of the same size; `cells` is the size available for them.
void layOutPictures(ScreenshotPlan& plan, const QSize& cells, int headline, int gap) {
    const int columns = columnsOf(plan.parts.size()), rows = rowsOf(plan.parts.size());
    const QSize cell((cells.width() - gap * (columns - 1)) / columns, (cells.height() - gap * (rows - 1)) / rows);
    for (size_t i = 0; i < plan.parts.size(); ++i) {
        const QPoint corner(int(i) % columns * (cell.width() + gap), int(i) / columns * (cell.height() + gap));
        ScreenshotPlan::Part& part = plan.parts[i];
        part.headline = QRect(corner, QSize(cell.width(), headline));
        part.picture = QRect(corner.x(), corner.y() + headline, cell.width(), cell.height() - headline);
    }
}

/// The size of the largest picture on the screen, which all pictures of the screenshot get.
QSize shownPicture(const ScreenshotPlan& plan) {
    QSize largest(1, 1);
    for (const ScreenshotPlan::Part& part : plan.parts)
        largest = largest.expandedTo({part.request.size.width, part.request.size.height});
    return largest;
}

}  // namespace

QString legendText(const LegendEntry& entry, const std::optional<uint64_t>& count) {
    return count ? QCoreApplication::translate("Screenshot", "%1: %2", "what a colour means, how many")
                       .arg(entry.words, countText(*count))
                 : entry.words;
}

void layOut(ScreenshotPlan& plan, const ScreenshotOptions& options, uint64_t largestCount) {
    const QSize shown = shownPicture(plan);
    const int columns = columnsOf(plan.parts.size()), rows = rowsOf(plan.parts.size());
    const int height = options.size ? options.size->height : rows * shown.height();
    const Units units{std::max(kLeastUnit, height / kUnitHeight)};
    plan.unit = units.unit;
    plan.font = fontOf(kFontPixels * units.unit);
    const int gap = options.grid ? units(2.0) : 0;
    const int headline = options.grid && options.overlays ? QFontMetrics(plan.font).height() + units(4.0) : 0;
    // Without a given size the pictures keep the size that they have in the window; legend and caption increase the height.
    QSize cells(columns * shown.width() + (columns - 1) * gap, rows * (shown.height() + headline) + (rows - 1) * gap);
    if (options.size) cells.setWidth(options.size->width);
    const int below = layOutBelow(plan, units, cells.width(), largestCount);
    if (options.size) cells.setHeight(options.size->height - below);
    plan.size = {cells.width(), cells.height() + below};
    layOutPictures(plan, cells, headline, gap);
    for (LegendEntry& entry : plan.legend) entry.place.translate(0, cells.height());
    plan.captionPlace.translate(0, cells.height());
    if (std::max(plan.size.width, plan.size.height) > kMostPixels)
        throwUsage(QT_TRANSLATE_NOOP("core", "A picture of %1x%2 pixels is too large: at most 16384 pixels a side can be saved."),
                   {std::to_string(plan.size.width), std::to_string(plan.size.height)});
    const QRect& smallest = plan.parts.back().picture;
    if (std::min(smallest.width(), smallest.height()) < (below + headline > 0 ? kFewestPicturePixels : 1))
        throwUsage(
            QT_TRANSLATE_NOOP("core",
                              "In %1x%2 pixels there is no room for the pictures beside legend and caption: choose a larger "
                              "size or leave those out."),
            {std::to_string(plan.size.width), std::to_string(plan.size.height)});
}

}  // namespace cullscope::ui
