#include "ui/jobs/picture_tiles.h"

#include <QCoreApplication>

#include "core/base/error.h"

namespace cullscope::ui {

QImage newImage(const Viewport& size, QImage::Format format) {
    QImage image(size.width, size.height, format);
    if (image.isNull())
        throwUsage(QT_TRANSLATE_NOOP("core", "There is no memory for a picture of %1x%2 pixels: choose a smaller size."),
                   {std::to_string(size.width), std::to_string(size.height)});
    return image;
}

}  // namespace cullscope::ui
