// The metrics of many views fit beside each other.
#include "ui/panels/metrics_panel.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QScrollBar>

#include "core/visibility/registry.h"
#include "tests/support/test_scenes.h"
#include "tests/ui/test_scene.h"
#include "ui/look/appearance.h"
#include "ui/models/metrics_words.h"

namespace cullscope::ui::metrics_panel_test {
namespace {

struct FiguresOfViews : ::testing::Test {
    void SetUp() override {
        panel.resize(380, 320);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
    }

    /// Fills all columns with large numbers.
    void fill() {
        ViewMetrics figures;
        figures.state = ViewMetrics::State::Ready;
        figures.submitted.triangles = 12'345'678;
        figures.frameMilliseconds = 1234.567;
        figures.cullMilliseconds = 0.00712;
        figures.accuracy.coveredPixels = 9'876'543;
        auto* model = panel.findChild<MetricsModel*>();
        ASSERT_TRUE(model);
        std::vector<MetricsModel::Column> columns;
        for (int view = 0; view < session.viewCount(); ++view) columns.push_back({view, figures});
        model->setColumns(columns);
        for (int view = 0; view < session.viewCount(); ++view) emit session.metricsChanged(view);
        model->setColumns(columns);
        panel.resize(panel.width() + 1, panel.height());
        QApplication::processEvents();
    }

    Session session{sessionOptions(false)};
    MetricsPanel panel{session};
};

TEST_F(FiguresOfViews, valuesOfUpToEightColumnsStandWhole) {
    for (const int count : {1, 2, 4, 8}) {
        session.setViewCount(count);
        fill();
        QTableView& table = panel.table();
        ASSERT_GT(table.model()->columnCount(), 0);
        const QFontMetrics metrics(table.font());
        for (int column = 0; column < table.model()->columnCount(); ++column)
            for (int row = 0; row < table.model()->rowCount(); ++row) {
                const QString value = table.model()->index(row, column).data().toString();
                EXPECT_LE(metrics.horizontalAdvance(value) + 4, table.columnWidth(column))
                    << value.toStdString() << " in column " << column << " of " << count;
            }
    }
    QTableView& table = panel.table();
    EXPECT_GT(table.horizontalScrollBar()->maximum(), 0) << "eight columns of large numbers have no room";
    const int titles = table.verticalHeader()->width();
    table.horizontalScrollBar()->setValue(table.horizontalScrollBar()->maximum());
    EXPECT_TRUE(table.verticalHeader()->isVisible());
    EXPECT_EQ(table.verticalHeader()->width(), titles);
    const int last = table.model()->columnCount() - 1;
    EXPECT_LE(table.columnViewportPosition(last) + table.columnWidth(last), table.viewport()->width());
    EXPECT_EQ(table.verticalScrollBar()->maximum(), 0) << "the rows are all seen at once";
}

TEST_F(FiguresOfViews, fewColumnsShareTheRoom) {
    session.setViewCount(1);
    fill();
    EXPECT_TRUE(waitUntil([&] { return panel.table().columnWidth(0) == panel.table().viewport()->width(); }));
}

TEST_F(FiguresOfViews, theTableHasTheColoursOfTheWindowsAppearance) {
    Appearance appearance;
    for (const Appearance::Mode mode : {Appearance::Mode::Dark, Appearance::Mode::Light, Appearance::Mode::Dark}) {
        appearance.setMode(mode);
        QApplication::processEvents();
        const QImage shown = panel.table().grab().toImage();
        const QColor expected = Appearance::palette(mode == Appearance::Mode::Dark).color(QPalette::Base);
        // Pixels of the body, the row titles, the column titles and the corner.
        const QSize size = shown.size();
        for (const QPoint& place : {QPoint(size.width() - 4, size.height() - 4), QPoint(3, size.height() - 4),
                                    QPoint(size.width() - 4, 3), QPoint(3, 3)})
            EXPECT_EQ(shown.pixelColor(place), expected) << place.x() << ", " << place.y();
    }
    appearance.setMode(Appearance::Mode::Light);
}

TEST(MetricsWords, visibleTrianglesAreNotCalledSubmittedWhereSomeWereLeftOut) {
    ViewMetrics figures;
    figures.state = ViewMetrics::State::Ready;
    figures.sceneTriangles = 30;
    figures.submitted.triangles = 10;
    figures.accuracy.visibleTriangles = 15;
    const QString words = metricsDetails(figures, {});
    EXPECT_TRUE(words.contains(QStringLiteral("Submitted: 10 of 30 triangles. Visible, drawn or not: 15")))
        << words.toStdString();
}

/// Figures of views of the test scene, one strategy each, timed in the same turns.
struct FastestOfViews : ::testing::Test {
    ViewMetrics& add(const char* id, std::vector<double> times) {
        ViewMetrics figures;
        figures.state = ViewMetrics::State::Ready;
        figures.timed = true;
        figures.timing = 1;
        figures.subject.strategy = buildStrategy(id, ParameterSet(findStrategy(id).info.parameters), scene, structures);
        figures.frameTimes = std::move(times);
        figures.frameMilliseconds = quantile(figures.frameTimes, 0.5);
        metrics.push_back(std::make_unique<ViewMetrics>(std::move(figures)));
        return *metrics.back();
    }

    QString said() const {
        std::vector<NamedMetrics> views;
        for (size_t i = 0; i < metrics.size(); ++i) views.push_back({viewLetter(int(i)), metrics[i].get()});
        return fastestSentence(views);
    }

    ScenePointer scene = test::sceneOf({test::boxMesh(Vec3f(-1.0F), Vec3f(1.0F))});
    StructureStore structures;
    std::vector<std::unique_ptr<ViewMetrics>> metrics;
};

TEST_F(FastestOfViews, theFastestIsComparedWithTheNextOne) {
    add("all", {8.0, 8.2, 7.8});
    EXPECT_TRUE(said().isEmpty()) << "nothing to compare with";
    add("frustum", {2.0, 2.1, 1.9});
    EXPECT_TRUE(said().startsWith(QStringLiteral("B is 4.00 times as fast as A ("))) << said().toStdString();
    EXPECT_FALSE(said().contains(QStringLiteral("not decided"))) << said().toStdString();
    add("backface", {4.0, 4.2, 3.8});
    EXPECT_TRUE(said().startsWith(QStringLiteral("B is 2.00 times as fast as C ("))) << said().toStdString();
}

TEST_F(FastestOfViews, timesThatCrossAreNotDecided) {
    add("all", {8.0, 2.0, 5.0});
    add("frustum", {4.0, 6.0, 4.9});
    EXPECT_TRUE(said().endsWith(QStringLiteral("Which one is faster is not decided."))) << said().toStdString();
}

TEST_F(FastestOfViews, timesOfOtherTurnsViewsOrOfTheSameStrategyAreNotCompared) {
    add("all", {8.0, 8.2, 7.8});
    ViewMetrics& other = add("frustum", {2.0, 2.1, 1.9});
    other.timing = 2;
    EXPECT_TRUE(said().isEmpty()) << "another moment: " << said().toStdString();
    other.timing = 1;
    other.subject.culling.eye.x += 1.0;
    EXPECT_TRUE(said().isEmpty()) << "another camera: " << said().toStdString();
    other.subject = metrics[0]->subject;
    EXPECT_TRUE(said().isEmpty()) << "the same strategy: " << said().toStdString();
    add("backface", {1.0, 1.0, 1.0}).state = ViewMetrics::State::Stale;
    EXPECT_TRUE(said().isEmpty()) << "not known any more: " << said().toStdString();
}

}  // namespace
}  // namespace cullscope::ui::metrics_panel_test
