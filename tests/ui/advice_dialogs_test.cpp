// The dialogs of advice and of the worst view, the axes of the Pareto plot, and the table of a race.
#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/experiments/trade_plot.h"
#include "tests/ui/made_up_result.h"
#include "tests/ui/test_scene.h"
#include "ui/dialogs/advise_dialog.h"
#include "ui/dialogs/reports_dialog.h"
#include "ui/dialogs/worst_dialog.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::advice_dialogs_test {
namespace {

struct AdviceDialogs : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("star:seed=7,triangles=500"));
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(AdviceDialogs, adviceAnswersFirstAndShowsAStrategyInTheActiveView) {
    window.actions().advise->trigger();
    auto* dialog = window.findChild<AdviseDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->showButton().isEnabled()) << "nothing is advised yet";
    const QString button = dialog->startButton().text().remove(QLatin1Char('&'));
    EXPECT_TRUE(dialog->plot().accessibleDescription().contains(button)) << "the empty plot names the button to press";
    dialog->path().setCurrentText(QStringLiteral("fibonacci:2"));
    dialog->size().setCurrentIndex(0);
    QSignalSpy ended(dialog, &AdviseDialog::ended);
    dialog->startButton().click();
    EXPECT_TRUE(dialog->running());
    ASSERT_TRUE(ended.wait(kPatience));
    EXPECT_TRUE(dialog->answer().text().contains(QStringLiteral("best here"))) << dialog->answer().text().toStdString();
    EXPECT_EQ(dialog->table().rowCount(), int(advice::candidates().size()) + 1);
    EXPECT_FALSE(dialog->plot().empty());
    // It is in the store, too.
    window.actions().reports->trigger();
    auto* reports = window.findChild<ReportsDialog*>();
    ASSERT_NE(reports, nullptr);
    ASSERT_GT(reports->table().rowCount(), 0);
    EXPECT_EQ(reports->table().item(0, 2)->text(), QStringLiteral("Advice")) << "the newest first";
    EXPECT_TRUE(reports->words().toPlainText().contains(QStringLiteral("best here")));
    reports->close();
    // Any row may be looked at, not only the advised one.
    int row = 0;
    while (row < dialog->table().rowCount() && dialog->table().item(row, 0)->text() != QStringLiteral("frustum-octree")) ++row;
    ASSERT_LT(row, dialog->table().rowCount());
    dialog->table().selectRow(row);
    dialog->showButton().click();
    EXPECT_EQ(session.slot(session.activeView()).id(), "frustum-octree");
    window.actions().advise->trigger();
    EXPECT_EQ(window.findChildren<AdviseDialog*>().size(), 1);
}

TEST_F(AdviceDialogs, aPathThatThereIsNotIsSaidInThePlaceOfTheAnswer) {
    AdviseDialog dialog(session);
    dialog.path().setCurrentText(QStringLiteral("nowhere:2"));
    QSignalSpy ended(&dialog, &AdviseDialog::ended);
    dialog.startButton().click();
    ASSERT_TRUE(ended.wait(kPatience));
    EXPECT_TRUE(dialog.answer().text().contains(QStringLiteral("nowhere"))) << dialog.answer().text().toStdString();
    EXPECT_TRUE(dialog.startButton().isEnabled());
}

TEST_F(AdviceDialogs, aClickOnTheMapOfTheWorstViewFliesThere) {
    window.actions().worst->trigger();
    auto* dialog = window.findChild<WorstDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->from().setCurrentIndex(0);
    dialog->views().setValue(72);
    QSignalSpy ended(dialog, &WorstDialog::ended);
    dialog->startButton().click();
    ASSERT_TRUE(ended.wait(kPatience));
    ASSERT_TRUE(dialog->result());
    EXPECT_EQ(dialog->result()->views.size(), 72U);
    ReportsDialog reports(session);
    EXPECT_EQ(reports.table().item(0, 2)->text(), QStringLiteral("Worst view"));
    QTemporaryDir folder;
    reports.save(folder.filePath(QStringLiteral("worst.json")));
    QFile saved(folder.filePath(QStringLiteral("worst.json")));
    ASSERT_TRUE(saved.open(QFile::ReadOnly));
    EXPECT_EQ(saved.readAll().toStdString(), worst::worstJson(*dialog->result()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->map().isVisible() && dialog->map().height() > 100; }, kPatience));
    const PlotDrawing drawn = dialog->map().drawing();
    // The part of azimuth 15 and elevation 15 degrees.
    const PlotPoint pixel = drawn.places.front().pixel({15.0, 15.0});
    QTest::mouseClick(&dialog->map(), Qt::LeftButton, {}, QPoint(int(pixel.x), int(pixel.y)));
    const worst::TriedView* view = dialog->result()->at({15.0, 15.0});
    ASSERT_NE(view, nullptr);
    EXPECT_NEAR(glm::length(session.camera().eye - view->pose.eye), 0.0, 1e-9);
    dialog->goButton().click();
    EXPECT_NEAR(glm::length(session.camera().eye - dialog->result()->views[dialog->result()->worst].pose.eye), 0.0, 1e-9);
}

TEST(ParetoAxes, anyTwoFiguresAreChosenAndAPointIsChosenByAClick) {
    ParetoPlot plot;
    plot.resize(700, 320);
    plot.setRuns(runFigures(madeUpResult()));
    const auto at = plot.pointOf(2);
    ASSERT_TRUE(at);
    EXPECT_TRUE(plot.pointText(2).contains(QStringLiteral("frustum box=length")));
    std::vector<StrategyRequest> chosen;
    QObject::connect(&plot, &ParetoPlot::strategyChosen, [&](const StrategyRequest& strategy) { chosen.push_back(strategy); });
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at->toPoint());
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(strategyText(chosen[0]), "frustum:box=length");
    QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Return);
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[1].id, "all");
    plot.setAxes(tradeFigure("culled_fraction"), tradeFigure("ratio_to_all"));
    EXPECT_FALSE(plot.empty());
    EXPECT_TRUE(plot.title().contains(QStringLiteral("Culled triangles")));
    plot.setAxes(tradeFigure("culled_fraction"), tradeFigure("silhouette_error_px"));
    EXPECT_TRUE(plot.empty()) << "it was not counted";
    EXPECT_TRUE(plot.accessibleDescription().contains(QStringLiteral("No strategy")));
}

TEST(RaceTable, eachStrategyStandsAgainstEach) {
    StatisticsPanel panel;
    MeasureResult result = madeUpResult();
    for (RunMeasurement& run : result.runs)
        for (FrameMeasurement& frame : run.frames) frame.frameTimes = {frame.frameMilliseconds};
    panel.setScene(result.request.scene);
    panel.setResult(tableOf(result), result);
    panel.showTab(StatisticsPanel::Race);
    const auto tables = panel.findChildren<QTableWidget*>();
    ASSERT_EQ(tables.size(), 1);
    EXPECT_EQ(tables[0]->rowCount(), 3);
    EXPECT_EQ(tables[0]->item(0, 0), nullptr);
    EXPECT_TRUE(tables[0]->item(2, 0)->text().startsWith(QStringLiteral("2.50"))) << tables[0]->item(2, 0)->text().toStdString();
    EXPECT_TRUE(tables[0]->item(2, 0)->text().contains(QStringLiteral(" ms"))) << "and what it saves";
    EXPECT_TRUE(tables[0]->item(2, 0)->font().bold());
    EXPECT_FALSE(tables[0]->item(0, 2)->font().bold()) << "slower";
}

}  // namespace
}  // namespace cullscope::ui::advice_dialogs_test
