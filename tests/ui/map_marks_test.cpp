// The positions of numbers beside marks and of sector edges on the map.
#include <gtest/gtest.h>

#include "tests/ui/made_up_map.h"
#include "ui/plots/map_overlay.h"
#include "ui/plots/map_painter.h"

namespace cullscope::ui::map_marks_test {
namespace {

TEST(MapMarks, numbersOfCornersStandBesideTheMarkers) {
    const QFontMetricsF metrics{QFont()};
    const MapLayout layout({0, 0, 400, 220}, metrics);
    for (const auto& [from, to] : {std::pair<Vec2, Vec2>{{0.01, 0.02}, {3.13, 6.27}},
                                   {{0.9, -0.05}, {1.9, 0.05}},
                                   {{0.02, 1.0}, {0.3, 2.0}},
                                   {{2.9, 5.9}, {3.13, 6.26}}}) {
        std::vector<MapMark> marks;
        for (const spherical::CornerRay& ray : cutDecision(from, to, 2).rays)
            marks.push_back({MapSymbol::Miss, mapAngles(ray.point), uint32_t(marks.size() + 1), {}});
        const std::vector<QRectF> numbers = markNumbers(layout, marks, metrics);
        for (size_t i = 0; i < numbers.size(); ++i) {
            EXPECT_TRUE(layout.area.adjusted(1, 1, -1, -1).contains(numbers[i])) << "on the frame";
            for (const MapMark& mark : marks)
                EXPECT_FALSE(numbers[i].adjusted(-3, -3, 3, 3).contains(layout.placeOf(mark.place))) << from.x << " " << i;
            for (size_t j = 0; j < i; ++j) EXPECT_FALSE(numbers[i].intersects(numbers[j])) << from.x;
        }
    }
}

TEST(MapMarks, labelsOfCirclesDoNotOverlapAndTheRightAngleHasOne) {
    const QFontMetricsF metrics{QFont()};
    MapCircles circles;
    circles.width = std::numbers::pi / 36;
    circles.bands = 36;
    for (const double slope : {0.0, 0.5, 1.2}) {
        circles.axis = {std::sin(slope), 0.0, std::cos(slope)};
        circles.side = {std::cos(slope), 0.0, -std::sin(slope)};
        for (const double height : {60.0, 90.0, 130.0, 600.0}) {
            const MapLayout layout({0, 0, 2 * height, height}, metrics);
            const std::vector<CircleLabel> labels = circleLabels(layout, circles, metrics);
            ASSERT_FALSE(labels.empty());
            EXPECT_EQ(labels.front().degrees, 90);
            for (size_t i = 0; i < labels.size(); ++i)
                for (size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(labels[i].place.intersects(labels[j].place))
                        << labels[i].degrees << "° and " << labels[j].degrees << "°, map of " << height << " pixels";
            if (height == 600.0) EXPECT_EQ(labels.size(), 5U);
        }
    }
}

TEST(MapMarks, labelsNameCirclesThatAreDrawn) {
    const QFontMetricsF metrics{QFont()};
    const MapLayout layout({0, 0, 1200, 600}, metrics);
    struct Case {
        double width;  // degrees
        uint32_t every;
        std::vector<int> degrees;
    };
    for (const Case& each : {Case{5.0, 3, {90, 60, 120, 30, 150}}, Case{20.0, 1, {90, 60, 120, 40, 140}},
                             Case{45.0, 1, {90, 45, 135}}, Case{5.5, 3, {90, 66, 33}}}) {
        MapCircles circles;
        circles.axis = {1.0, 0.0, 0.0};
        circles.side = {0.0, 1.0, 0.0};
        circles.width = each.width * std::numbers::pi / 180.0;
        circles.every = each.every;
        circles.bands = uint32_t(std::ceil(180.0 / each.width));
        std::vector<int> degrees;
        for (const CircleLabel& label : circleLabels(layout, circles, metrics)) degrees.push_back(label.degrees);
        EXPECT_EQ(degrees, each.degrees) << each.width;
    }
}

TEST(MapMarks, numbersAndNamesOfTheAxesDoNotOverlap) {
    QFont font;
    for (const int letters : {13, 20, 30}) {
        font.setPixelSize(letters);
        const QFontMetricsF metrics(font);
        bool named = false, unnamed = false;
        for (int height = 40; height < 700; height += 7) {
            const MapLayout layout({0, 0, 2.0 * height, double(height)}, metrics);
            const std::vector<MapLayout::AxisLabel> labels = layout.axisLabels(metrics);
            const bool names = std::ranges::any_of(labels, [](const auto& label) { return label.words == QStringLiteral("φ"); });
            (names ? named : unnamed) = true;
            for (size_t i = 0; i < labels.size(); ++i)
                for (size_t j = 0; j < i; ++j) {
                    const bool sameAxis =
                        (labels[i].place.top() >= layout.area.bottom()) == (labels[j].place.top() >= layout.area.bottom());
                    EXPECT_FALSE(sameAxis && labels[i].place.adjusted(-2, 0, 2, 0).intersects(labels[j].place))
                        << labels[i].words.toStdString() << " and " << labels[j].words.toStdString() << ", " << letters
                        << " pixels, map of " << height;
                }
        }
        EXPECT_TRUE(named && unnamed) << "else nothing was tried";
    }
}

TEST(MapMarks, noLineCrossesTheLabelOfACircle) {
    const ScenePointer scene = openScene("sphere:triangles=80").scene;
    const ShownMap shown = MadeUpMap(scene, SphericalGrid(16, 8)).shown();
    auto map = std::make_shared<CellMap>(*shown.map);
    MapCircles circles;
    circles.width = std::numbers::pi / 36;
    circles.bands = 36;
    circles.axis = {0.0, 0.0, 1.0};
    circles.side = {1.0, 0.0, 0.0};
    map->circles = circles;
    map->curves.clear();
    const QRect place(0, 0, 600, 340);
    const auto painted = [&] {
        MapPainter painter;
        painter.setContents({ShownMap{shown.scene, map}, nullptr, {}, {}});
        painter.setBrief();
        QImage image(place.size(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter on(&image);
        painter.paint(on, place, QPalette());
        const QFontMetricsF metrics(on.font());
        QRect label = circleLabels(painter.layout(place, metrics), circles, metrics).front().place.toAlignedRect();
        return image.copy(label.adjusted(2, 2, -2, -2)).convertToFormat(QImage::Format_Grayscale8);
    };
    const QImage without = painted();
    // A line along the right angle, where the label stands, from one side of the map to the other.
    map->curves.push_back({MapSymbol::Horizon, {{std::numbers::pi / 2, 0.0}, {std::numbers::pi / 2, 6.28}}, false});
    const QImage with = painted();
    // What shines through the label's ground is faint.
    int most = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x)
            most = std::max(most, std::abs(qGray(with.pixel(x, y)) - qGray(without.pixel(x, y))));
    EXPECT_LT(most, 48);
}

TEST(MapMarks, captionOfGlyphsOfAnotherFontStandsOnTheSameLine) {
    const ScenePointer scene = openScene("sphere:triangles=80").scene;
    const ShownMap shown = MadeUpMap(scene, SphericalGrid(16, 8)).shown();
    const QString latin = QStringLiteral("gypsy ");
    const auto caption = [&](const QString& words) {
        auto map = std::make_shared<CellMap>(*shown.map);
        map->objectWords = {"%1", {Term::name(words.toStdString())}};
        MapPainter painter;
        painter.setContents({ShownMap{shown.scene, map}, nullptr, {}, {}});
        QImage image(400, 300, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter on(&image);
        painter.paint(on, image.rect(), QPalette());
        return image.copy(0, 0, QFontMetrics(on.font()).horizontalAdvance(latin), int(QFontMetricsF(on.font()).height()) + 6);
    };
    EXPECT_EQ(caption(latin), caption(latin + QStringLiteral("가中")));
}

TEST(MapMarks, edgesOfSectorsKeepTheirAngleOverThePolesToo) {
    spherical::ContourBands bands = *withinDecision({5, 0, 0}).bands;
    bands.axis = {1, 0, 0};
    bands.side = {0, 1, 0};
    bands.over = {0, 0, 1};
    for (const double beta : {0.7, std::numbers::pi / 2, 4.0}) {
        const std::vector<std::vector<Vec2>> lines = meridianOnMap(bands, beta);
        EXPECT_EQ(lines.size(), beta == std::numbers::pi / 2 ? 2U : 1U) << beta;
        for (const std::vector<Vec2>& line : lines)
            for (size_t i = 0; i < line.size(); ++i) {
                const double theta = line[i].x, phi = line[i].y;
                const Vec3 direction{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
                const Vec2 angles = bands.anglesOf(direction);
                if (std::sin(angles.x) > 1e-6) {
                    EXPECT_NEAR(angles.y, beta, 1e-6);
                }
                if (i > 0) {
                    EXPECT_LT(std::abs(phi - line[i - 1].y), 1.6) << "a line across the map";
                }
            }
    }
}

}  // namespace
}  // namespace cullscope::ui::map_marks_test
