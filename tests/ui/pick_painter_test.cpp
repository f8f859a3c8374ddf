// What is painted over a picture to mark the pick.

#include "ui/views/pick_painter.h"

#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <numbers>

#include "tests/support/test_scenes.h"

namespace cullscope::ui::pick_painter_test {
namespace {

/// The rectangle of the pixels that the mark of the first triangle changes, of a square seen from a distance.
QRect markedFrom(double distance) {
    const ScenePointer scene = test::sceneOf({test::squareMesh(1.0f, 0.0f)});
    const Viewport size{200, 160};
    const View viewing({{0, 0, distance}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 1e5}, size);
    QImage image(size.width, size.height, QImage::Format_ARGB32);
    image.fill(Qt::gray);
    QPainter painter(&image);
    paintPick(painter, *scene, {}, {}, viewing, PictureLayout(image.size(), 1.0, size));
    painter.end();
    const QRgb gray = QColor(Qt::gray).rgba();
    QRect marked;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (image.pixel(x, y) != gray) marked |= QRect(x, y, 1, 1);
    return marked;
}

TEST(PaintPick, triangleTooSmallToBeSeenHasARoundRing) {
    const QRect ring = markedFrom(1000.0);
    EXPECT_EQ(ring.width(), ring.height());
    EXPECT_GE(ring.width(), 16);
    EXPECT_LE(ring.width(), 22);
    EXPECT_LE((ring.center() - QPoint(100, 80)).manhattanLength(), 2) << "about the triangle";
}

TEST(PaintPick, triangleThatIsSeenHasItsOutlineAlone) {
    const QRect outline = markedFrom(5.0);
    const int side = int(2.0 / 5.0 / (2.0 * std::tan(std::numbers::pi / 8)) * 160);  // of the square in the picture
    EXPECT_NEAR(outline.width(), side, 8) << "a line of 3.5 px and the miter of its corners";
    EXPECT_NEAR(outline.height(), side, 8);
}

}  // namespace
}  // namespace cullscope::ui::pick_painter_test
