#include "ui/screenshots/screenshot_painter.h"

#include "core/frame/submitted.h"
#include "core/gpu/colour.h"
#include "ui/jobs/picture_tiles.h"
#include "ui/look/verdict_swatch.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

namespace {

constexpr double kSwatch = 12.0;  // units

QColor colourOf(const Vec3f& rgb, float alpha = 1.0f) { return QColor::fromRgbF(rgb.x, rgb.y, rgb.z, alpha); }

void paintPart(QPainter& painter, const ScreenshotPlan& plan, const ScreenshotPlan::Part& part, const ViewPicture& picture) {
    paintPicture(painter, part.picture, picture, part.overlays ? part.extras : PictureExtras());
    if (part.headline.isEmpty()) return;
    const int inset = int(4.0 * plan.unit);
    const QRect place = part.headline.adjusted(inset, 0, -inset, 0);
    painter.setPen(colourOf(contrastTo(plan.style.background)));
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(plan.font).elidedText(part.words, Qt::ElideRight, place.width()));
}

void paintSwatch(QPainter& painter, const LegendEntry& entry, const ScreenshotPlan& plan) {
    const double side = kSwatch * plan.unit;
    painter.save();
    painter.translate(entry.place.x(), entry.place.center().y() - side / 2.0);
    painter.scale(plan.unit, plan.unit);
    const QRectF place(0.0, 0.0, kSwatch, kSwatch);
    if (entry.state) {
        QPalette palette;
        palette.setColor(QPalette::Base, colourOf(plan.style.background));
        drawVerdictSwatch(painter, place, *entry.state, palette);
    } else {
        painter.fillRect(place, entry.colour);
    }
    painter.restore();
}

void paintLegend(QPainter& painter, const ScreenshotPlan& plan) {
    painter.setPen(colourOf(contrastTo(plan.style.background)));
    for (const LegendEntry& entry : plan.legend) {
        paintSwatch(painter, entry, plan);
        std::optional<uint64_t> count;
        if (entry.state && plan.counts) count = (*plan.counts)[size_t(*entry.state)];
        const QRect words = entry.place.adjusted(int((kSwatch + 6.0) * plan.unit), 0, 0, 0);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(plan.font).elidedText(legendText(entry, count), Qt::ElideRight, words.width()));
    }
}

bool isOnePlainPicture(const ScreenshotPlan& plan) {
    const ScreenshotPlan::Part& first = plan.parts.front();
    const bool whole = first.picture == QRect(0, 0, plan.size.width, plan.size.height);
    return whole && first.request.wipe == Wipe::Mode::None &&
           !(first.overlays && (first.extras.markedLoss || first.extras.modelScales));
}

}  // namespace

QImage paintScreenshot(const ScreenshotPlan& plan, const std::vector<TiledPicture::Result>& pictures) {
    if (isOnePlainPicture(plan)) return pictures.front().picture->colour;
    QImage image = newImage(plan.size, QImage::Format_ARGB32_Premultiplied);
    image.fill(colourOf(plan.style.background, plan.style.backgroundAlpha));
    QPainter painter(&image);
    painter.setFont(plan.font);
    for (size_t i = 0; i < plan.parts.size(); ++i) paintPart(painter, plan, plan.parts[i], *pictures[i].picture);
    paintLegend(painter, plan);
    painter.setPen(colourOf(contrastTo(plan.style.background)));
    painter.drawText(plan.captionPlace, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, plan.caption);
    painter.end();
    image.convertTo(QImage::Format_RGBA8888);
    return image;
}

Picture screenshotPicture(const ScreenshotPlan& plan, std::vector<TiledPicture::Result> pictures) {
    Picture result;
    result.size = plan.size;
    result.metadata = plan.metadata;
    for (size_t i = 0; i < plan.parts.size(); ++i) {
        PictureSubject subject = plan.parts[i].subject;
        const ViewPicture& picture = *pictures[i].picture;
        subject.submittedTriangles = submittedBy(picture.request.buffers->scene(), picture.frame->log).triangles;
        // In a grid the letter of the view precedes the names.
        const std::string prefix =
            plan.parts.size() == 1 ? "cullscope:" : "cullscope:view_" + std::string(1, char('A' + plan.parts[i].view)) + ":";
        std::ranges::move(subjectMetadata(subject, prefix), std::back_inserter(result.metadata));
    }
    const size_t pixels = size_t(plan.size.width) * size_t(plan.size.height);
    const QRect place = plan.parts.front().picture;
    const PictureTile tile{place.x(), plan.size.height - place.y() - place.height(), {place.width(), place.height()}};
    if (!pictures.front().triangle.empty()) {
        result.depth.assign(pixels, std::numeric_limits<float>::infinity());
        result.triangle.assign(pixels, 0);
        copyTile(pictures.front().depth, tile, result.depth, plan.size.width);
        copyTile(pictures.front().triangle, tile, result.triangle, plan.size.width);
    }
    const QImage image = paintScreenshot(plan, pictures);
    pictures.clear();
    result.rgba.resize(4 * pixels);
    const size_t rowBytes = 4 * size_t(plan.size.width);
    for (int y = 0; y < plan.size.height; ++y)
        std::copy_n(image.constScanLine(plan.size.height - 1 - y), rowBytes, result.rgba.begin() + std::ptrdiff_t(rowBytes) * y);
    return result;
}

}  // namespace cullscope::ui
