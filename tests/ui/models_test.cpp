#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "core/visibility/built_strategy.h"
#include "tests/ui/test_scene.h"
#include "ui/models/metrics_model.h"
#include "ui/models/metrics_words.h"
#include "ui/models/report_model.h"
#include "ui/models/scene_model.h"
#include "ui/models/strategy_model.h"
#include "ui/text/wording.h"

namespace cullscope::ui::models_test {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

ViewMetrics someFigures() {
    ViewMetrics figures;
    figures.state = ViewMetrics::State::Ready;
    figures.speedup = RatioEstimate{3.14, {2.9, 3.3}};
    figures.frameMilliseconds = 4.0;
    figures.submitted.triangles = 15;
    figures.sceneTriangles = 100;
    return figures;
}

TEST(Models, strategiesAreTheRegistrys) {
    StrategyModel model([](const StrategyInfo&) { return std::nullopt; });
    const QAbstractItemModelTester tester(&model, kFatal);
    ASSERT_EQ(model.rowCount(), int(strategies().size()));
    for (int row = 0; row < model.rowCount(); ++row) {
        const std::string id = model.index(row).data(StrategyModel::IdRole).toString().toStdString();
        EXPECT_EQ(id, strategies()[size_t(row)].info.id);
        EXPECT_EQ(model.rowOf(id), row);
        EXPECT_EQ(Promise(model.index(row).data(StrategyModel::PromiseRole).toInt()), usualPromise(id)) << id;
    }
    EXPECT_EQ(model.rowOf("none of these"), -1);
    model.retranslate();
}

TEST(Models, reportSaysWhatWasRepairedOrThatNothingWas) {
    ReportModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    EXPECT_EQ(model.rowCount(), 0);
    model.setReport(LoadReport{});
    EXPECT_EQ(model.rowCount(), 1);
    EXPECT_TRUE(model.clean());
    LoadReport report;
    report.degenerateFaces = 12;
    report.duplicateFaces = 3;
    model.setReport(report);
    EXPECT_FALSE(model.clean());
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_TRUE(model.index(0).data().toString().contains(QStringLiteral("12")));
    model.setReport(std::nullopt);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(Models, sceneFactsNameTheTriangles) {
    SceneModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    EXPECT_EQ(model.rowCount(), 0);
    model.setScene(openScene("sphere:triangles=1280").scene);
    ASSERT_GT(model.rowCount(), 1);
    EXPECT_EQ(model.index(1, 1).data().toString().toStdString(), "1,280");
    model.retranslate();
    model.setScene(nullptr);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(Models, sceneFactsCountPrimitivesByKindAndAllTogether) {
    SceneModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    const ScenePointer plant = openScene("plant:pipelines=2").scene;
    model.setScene(plant);
    const std::map<std::string, uint64_t> kinds = plant->partCounts();
    ASSERT_GT(kinds.size(), 3u);
    const int all = model.rowCount() - int(kinds.size()) - 1;
    EXPECT_EQ(model.index(all, 0).data().toString(), QStringLiteral("Primitives"));
    uint64_t sum = 0, last = std::numeric_limits<uint64_t>::max();
    for (int row = all + 1; row < model.rowCount(); ++row) {
        const QString kind = model.index(row, 0).data().toString().mid(2);
        ASSERT_TRUE(kinds.contains(kind.toStdString())) << kind.toStdString();
        const uint64_t count = kinds.at(kind.toStdString());
        EXPECT_EQ(model.index(row, 1).data().toString(), countText(count));
        EXPECT_LE(count, last) << "the most frequent first";
        last = count;
        sum += count;
    }
    EXPECT_EQ(model.index(all, 1).data().toString(), countText(sum));
}

TEST(Models, aSpeedThatIsStillBeingMeasuredIsNotWrittenAsANumber) {
    MetricsModel model;
    ViewMetrics figures = someFigures();
    figures.timed = false;
    figures.speedup.reset();
    figures.frameMilliseconds = 0.0;
    figures.cullMilliseconds = 0.7;
    model.setColumns({{0, figures}});
    for (int row = 0; row < model.rowCount(); ++row) {
        const QString title = model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
        const QString value = model.index(row, 0).data().toString();
        const bool time = QStringList{QStringLiteral("Speed, same sides drawn"),
                                      QStringLiteral("– 95 % interval"),
                                      QStringLiteral("Any culling, at most"),
                                      QStringLiteral("Of the headroom"),
                                      QStringLiteral("Frame"),
                                      QStringLiteral("Culling"),
                                      QStringLiteral("Frames per second")}
                              .contains(title);
        EXPECT_EQ(value == QStringLiteral("…"), time) << title.toStdString() << ": " << value.toStdString();
    }
    EXPECT_FALSE(metricsDetails(figures, {}).contains(QStringLiteral("fps"))) << metricsDetails(figures, {}).toStdString();
}

TEST(Models, theMostThatCullingCanGainIsNeverLessThanNothing) {
    MetricsModel model;
    ViewMetrics figures = someFigures();
    for (const double most : {2.0, 0.92}) {
        figures.headroom = ViewHeadroom{{most, {most - 0.1, most + 0.1}}, "all", std::nullopt};
        model.setColumns({{0, figures}});
        QStringList values;
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString() == QStringLiteral("Any culling, at most"))
                values << model.index(row, 0).data().toString();
        EXPECT_EQ(values, QStringList{most < 1.0 ? QStringLiteral("nothing") : QStringLiteral("×2.0")});
    }
}

TEST(Models, missedEdgePixelsOfBackfaceAreExplained) {
    MetricsModel model;
    ViewMetrics figures = someFigures();
    figures.accuracy.missedPixels = 7;
    model.setColumns({{0, figures}});
    const auto valueOf = [&](const QString& title) {
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString() == title)
                return model.index(row, 0).data().toString();
        return QStringLiteral("no such row");
    };
    EXPECT_EQ(valueOf(QStringLiteral("– within snapping")), QStringLiteral("–"));
    figures.missedBeyondSnapping = 2;
    model.setFigures(0, figures);
    EXPECT_EQ(valueOf(QStringLiteral("Missed pixels")), QStringLiteral("2"));
    EXPECT_EQ(valueOf(QStringLiteral("– within snapping")), QStringLiteral("5"));
    EXPECT_TRUE(metricsDetails(figures, {}).contains(QStringLiteral("Within the raster's snapping, and not lost: 5")));
}

TEST(Models, fragmentsAreCountedApartFromTheTrianglesThatAreSubmitted) {
    MetricsModel model;
    ViewMetrics figures = someFigures();
    figures.submitted = {15, 157};
    model.setColumns({{0, figures}});
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString() != QStringLiteral("Submitted triangles")) continue;
        EXPECT_EQ(model.index(row, 0).data().toString(), QStringLiteral("15"));
        EXPECT_TRUE(model.index(row, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("157")));
    }
    EXPECT_TRUE(metricsLine(figures).contains(QStringLiteral("15 %"))) << metricsLine(figures).toStdString();
    EXPECT_TRUE(metricsDetails(figures, {}).contains(QStringLiteral("Submitted in 157 fragments")));
}

TEST(Models, figuresAreColumnsOfTheShownViews) {
    MetricsModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    ViewMetrics stale;
    stale.state = ViewMetrics::State::Stale;
    model.setColumns({{0, stale}, {1, someFigures()}});
    ASSERT_EQ(model.columnCount(), 2);
    EXPECT_EQ(model.index(0, 0).data().toString(), QStringLiteral("…"));
    EXPECT_EQ(model.index(0, 1).data().toString(), QStringLiteral("×3.1"));
    model.setFigures(0, someFigures());
    EXPECT_EQ(model.index(0, 0).data().toString(), QStringLiteral("×3.1"));
    EXPECT_EQ(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("B"));
    model.setColumns({});
    EXPECT_EQ(model.columnCount(), 0);
}

TEST(Wording, headerSaysSpeedupShareAndMissedPixels) {
    ViewMetrics figures = someFigures();
    EXPECT_EQ(metricsLine(figures), QStringLiteral("×3.1 · 15 % · 0 missed"));
    figures.accuracy.missedPixels = 1234;
    figures.speedup.reset();
    EXPECT_EQ(metricsLine(figures), QStringLiteral("×… · 15 % · 1,234 missed"));
    figures.state = ViewMetrics::State::Stale;
    EXPECT_EQ(metricsLine(figures), QStringLiteral("…"));
    figures.state = ViewMetrics::State::Nothing;
    EXPECT_EQ(metricsLine(figures), QString());
}

TEST(Wording, pixelsWithinTheRastersSnappingAreNotMissedAndStatedApart) {
    ViewMetrics figures = someFigures();
    figures.accuracy.missedPixels = 3;
    figures.missedBeyondSnapping = 0;
    EXPECT_EQ(metricsLine(figures), QStringLiteral("×3.1 · 15 % · 0 missed"));
    const QString sentence = missedSentence(figures);
    EXPECT_TRUE(sentence.startsWith(QStringLiteral("Missed: 0 of "))) << sentence.toStdString();
    EXPECT_TRUE(sentence.contains(QStringLiteral("largest hole 0"))) << sentence.toStdString();
    EXPECT_TRUE(sentence.endsWith(QStringLiteral("Within the raster's snapping, and not lost: 3"))) << sentence.toStdString();
    figures.missedBeyondSnapping.reset();
    EXPECT_EQ(metricsLine(figures), QStringLiteral("×3.1 · 15 % · 3 missed"));
    EXPECT_TRUE(snappedSentence(figures).isEmpty());
}

TEST(Wording, aShareIsNeverRoundedToNothingOrToAll) {
    EXPECT_EQ(percentText(0.0), QStringLiteral("0"));
    EXPECT_EQ(percentText(1e-6), QStringLiteral("<0.1"));
    EXPECT_EQ(percentText(0.015), QStringLiteral("1.5"));
    EXPECT_EQ(percentText(0.999), QStringLiteral("99"));
    EXPECT_EQ(percentText(1.0), QStringLiteral("100"));
}

TEST(Wording, ratiosHaveTwoDigits) {
    EXPECT_EQ(ratioText(0.97), QStringLiteral("0.97"));
    EXPECT_EQ(ratioText(3.14), QStringLiteral("3.1"));
    EXPECT_EQ(ratioText(15.2), QStringLiteral("15"));
}

}  // namespace
}  // namespace cullscope::ui::models_test
