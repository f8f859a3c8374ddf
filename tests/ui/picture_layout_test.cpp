// Where a picture lies in its place, and how its pixels are enlarged or reduced.
#include "ui/views/picture_layout.h"

#include <gtest/gtest.h>

#include <QImage>
#include <random>

#include "ui/views/picture_painter.h"

namespace cullscope::ui::picture_layout_test {
namespace {

double scaleIn(const QSizeF& place, double pixelRatio, const Viewport& picture) {
    return PictureLayout(place, pixelRatio, picture).scale();
}

TEST(PictureLayout, fillsItsPlaceAndPrefersWholeNumbersOfDevicePixels) {
    const Viewport usual{640, 480};
    EXPECT_DOUBLE_EQ(scaleIn({640, 480}, 1.0, usual), 1.0);
    EXPECT_DOUBLE_EQ(scaleIn({700, 500}, 1.0, usual), 1.0) << "little is left empty";
    EXPECT_DOUBLE_EQ(scaleIn({800, 600}, 1.0, usual), 1.25) << "much would be left empty";
    EXPECT_DOUBLE_EQ(scaleIn({1300, 1000}, 1.0, usual), 2.0);
    EXPECT_DOUBLE_EQ(scaleIn({320, 480}, 1.0, usual), 0.5);
    // Of a screen with two device pixels for each of the window's.
    EXPECT_DOUBLE_EQ(scaleIn({320, 240}, 2.0, usual), 1.0);
    EXPECT_DOUBLE_EQ(scaleIn({640, 480}, 2.0, usual), 2.0);
    EXPECT_DOUBLE_EQ(scaleIn({1, 1}, 1.0, usual), 1.0 / 640.0);
}

TEST(PictureLayout, liesWithinItsPlaceAndMapsEveryPixelToItself) {
    std::mt19937 random(3);
    const auto number = [&](int least, int most) { return least + int(random() % unsigned(most - least + 1)); };
    for (int i = 0; i < 2000; ++i) {
        const QSizeF place(number(1, 2000), number(1, 1200));
        const double ratio = std::array{1.0, 1.25, 1.5, 2.0}[size_t(number(0, 3))];
        const Viewport size{number(1, 2000), number(1, 1500)};
        const PictureLayout layout(place, ratio, size);
        EXPECT_TRUE(QRectF({}, place).adjusted(-1, -1, 1, 1).contains(layout.rect()))
            << place.width() << " x " << place.height() << ", " << size.width << " x " << size.height << ", seed 3, case " << i;
        const int x = number(0, size.width - 1), y = number(0, size.height - 1);
        const Vec2 pixel = layout.pixelAt(layout.positionOf(Vec2(x + 0.5, y + 0.5)));
        EXPECT_EQ(int(pixel.x), x) << i;
        EXPECT_EQ(int(pixel.y), y) << i;
    }
}

TEST(ScaledPicture, staysCrispAtAnyEnlargement) {
    QImage board(8, 8, QImage::Format_RGB32);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) board.setPixel(x, y, (x + y) % 2 == 0 ? qRgb(255, 255, 255) : qRgb(0, 0, 0));
    for (const int side : {8, 12, 14, 16, 18, 21, 24, 30}) {
        QImage target(side, side, QImage::Format_RGB32);
        target.fill(Qt::red);
        QPainter painter(&target);
        paintScaled(painter, QRectF(0, 0, side, side), board);
        painter.end();
        const double scale = side / 8.0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                // The device pixel in the middle of each enlarged one.
                const QRgb middle = target.pixel(int((x + 0.5) * scale), int((y + 0.5) * scale));
                const bool white = (x + y) % 2 == 0;
                EXPECT_EQ(qRed(middle) > 127, white) << side << ": " << x << ", " << y;
                if (scale >= 2.0) EXPECT_LE(std::abs(qRed(middle) - (white ? 255 : 0)), 40) << side << ": " << x << ", " << y;
            }
    }
}

TEST(ScaledPicture, reducedItHasTheMeanOfWhatFallsTogether) {
    QImage board(8, 8, QImage::Format_RGB32);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) board.setPixel(x, y, (x + y) % 2 == 0 ? qRgb(255, 255, 255) : qRgb(0, 0, 0));
    QImage target(4, 4, QImage::Format_RGB32);
    target.fill(Qt::red);
    QPainter painter(&target);
    paintScaled(painter, QRectF(0, 0, 4, 4), board);
    painter.end();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_NEAR(qRed(target.pixel(x, y)), 127, 20) << x << ", " << y;
}

}  // namespace
}  // namespace cullscope::ui::picture_layout_test
