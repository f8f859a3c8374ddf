// Marks of the subject in hand of a stepped view.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QPainter>

#include "core/geometry/random.h"
#include "ui/views/pick_painter.h"

namespace cullscope::ui::subject_painter_test {
namespace {

constexpr int kTimes = 5;

/// The shortest time of several, in nanoseconds.
template <typename Work>
double shortest(const Work& work) {
    double best = 1e18;
    for (int i = 0; i < kTimes; ++i) {
        QElapsedTimer timer;
        timer.start();
        work();
        best = std::min(best, double(timer.nsecsElapsed()));
    }
    return best;
}

TEST(SubjectPainter, aThousandTrianglesTakeAFewTimesOfTheirLines) {
    const Viewport size{640, 480};
    const View view(Camera{.eye = Vec3(0.0, 0.0, 4.0), .target = Vec3(0.0)}, size);
    const PictureLayout layout(QSizeF(size.width, size.height), 1.0, size);
    Random random(17);
    SubjectShape shape;
    QVector<QLineF> lines;
    const auto within = [&](double reach) {
        return Vec3(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
    };
    for (size_t i = 0; i < SubjectShape::kMostTriangles; ++i) {
        const Vec3 middle = within(1.0);
        shape.triangles.push_back({middle + within(0.3), middle + within(0.3), middle + within(0.3)});
        const auto& corners = shape.triangles.back();
        for (size_t corner = 0; corner < 3; ++corner) {
            const Vec3 &from = corners[corner], &to = corners[(corner + 1) % 3];
            lines << QLineF(320.0 + 145.0 * from.x, 240.0 + 145.0 * from.y, 320.0 + 145.0 * to.x, 240.0 + 145.0 * to.y);
        }
    }
    QImage image(size.width, size.height, QImage::Format_RGB32);
    image.fill(Qt::white);
    const QImage blank = image;
    const double plain = shortest([&] {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Qt::black, 2.0));
        painter.drawLines(lines);
    });
    image = blank;
    const double marked = shortest([&] {
        QPainter painter(&image);
        paintSubject(painter, shape, view, layout, true);
    });
    EXPECT_NE(image, blank);
    EXPECT_LT(marked, 8.0 * plain) << "a step must be shown within 50 ms";
}

}  // namespace
}  // namespace cullscope::ui::subject_painter_test
