#include "ui/dialogs/reproduce_dialog.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QHeaderView>
#include <QRegularExpression>
#include <QScreen>
#include <QTemporaryDir>

#include "core/experiments/experiment_list.h"
#include "core/measure/statistics.h"
#include "tests/ui/test_scene.h"
#include "ui/statistics/history_store.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::reproduce_dialog_test {
namespace {

/// A window with a small scene.
struct Reproduce : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        const QRect screen = window.screen()->availableGeometry();
        // Place the window partly off the screen, as a user may do.
        window.move(screen.left() + 10, screen.bottom() - 600);
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
        QObject::connect(&window.papers().runner(), &PaperRunner::ended, [this] { ++endings; });
    }

    void expectDialogIsOnTheScreen() {
        const QRect screen = dialog().screen()->availableGeometry(), frame = dialog().frameGeometry();
        EXPECT_TRUE(screen.contains(frame)) << frame.top() << " to " << frame.bottom() << " of " << screen.bottom();
    }

    ReproduceDialog& dialog() {
        if (!window.findChild<ReproduceDialog*>()) window.actions().reproduce->trigger();
        return *window.findChild<ReproduceDialog*>();
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
    int endings = 0;
};

int indexOf(const std::string& id) {
    for (size_t i = 0; i < knownExperiments().size(); ++i)
        if (knownExperiments()[i].id == id) return int(i);
    return -1;
}

TEST_F(Reproduce, everyTableCanBeChosenAndStatesItsColumns) {
    EXPECT_EQ(dialog().choice().count(), int(knownExperiments().size()));
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_FALSE(dialog().cancelButton().isEnabled());
    for (int table = 0; table < dialog().choice().count(); ++table) {
        dialog().choice().setCurrentIndex(table);
        EXPECT_EQ(dialog().model().columnCount(), int(knownExperiments()[size_t(table)].columns.size()));
        EXPECT_EQ(dialog().model().rowCount(), 0);
    }
}

TEST_F(Reproduce, headersStandWhole) {
    for (int table = 0; table < dialog().choice().count(); ++table) {
        dialog().choice().setCurrentIndex(table);
        const QHeaderView& header = *dialog().table().horizontalHeader();
        for (int column = 0; column < header.count(); ++column)
            EXPECT_GE(header.sectionSize(column), header.sectionSizeHint(column)) << "table " << table + 1 << ": " << column;
    }
}

TEST_F(Reproduce, table1ComesWithThePapersNumbersAndCanBeExported) {
    const SessionState before = captureState(session);
    const OpenedScenePointer opened = session.opened();
    dialog().choice().setCurrentIndex(0);
    QTest::mouseClick(&dialog().startButton(), Qt::LeftButton);
    EXPECT_FALSE(dialog().startButton().isEnabled());
    EXPECT_TRUE(dialog().cancelButton().isEnabled());
    EXPECT_FALSE(dialog().choice().isEnabled());
    expectDialogIsOnTheScreen();
    EXPECT_LE(dialog().frameGeometry().height(), window.screen()->availableGeometry().height() / 3) << "it hides the views";
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_TRUE(dialog().startButton().isEnabled());
    expectDialogIsOnTheScreen();
    EXPECT_EQ(dialog().progressBar().value(), dialog().progressBar().maximum());
    ASSERT_EQ(dialog().model().rowCount(), 5);
    EXPECT_EQ(dialog().model().index(1, 1).data().toString(), QStringLiteral("4.30"));
    EXPECT_EQ(session.opened(), opened);
    EXPECT_EQ(captureState(session), before);
    EXPECT_FALSE(window.document().undo().canUndo()) << "the experiment's views can be undone to";

    const QTemporaryDir folder;
    const QString csv = folder.filePath(QStringLiteral("table.csv")), json = folder.filePath(QStringLiteral("table.json"));
    dialog().exportTo(ReproduceDialog::File::Csv, csv.toStdString());
    dialog().exportTo(ReproduceDialog::File::Json, json.toStdString());
    ASSERT_TRUE(waitUntil([&] { return QFile::exists(csv) && QFile::exists(json); }));
    QFile file(csv);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().toStdString(), tableCsv(dialog().model().table()));
}

TEST_F(Reproduce, tableOutlivesItsDialog) {
    dialog().choice().setCurrentIndex(indexOf("quiz"));
    QTest::mouseClick(&dialog().startButton(), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    const std::string measured = tableCsv(dialog().model().table());
    dialog().choice().setCurrentIndex(1);
    EXPECT_EQ(dialog().model().rowCount(), 0);
    EXPECT_FALSE(dialog().exportButton().isEnabled());
    dialog().reject();
    ASSERT_TRUE(waitUntil([this] { return window.findChild<ReproduceDialog*>() == nullptr; }));
    EXPECT_EQ(dialog().choice().currentIndex(), indexOf("quiz"));
    EXPECT_EQ(tableCsv(dialog().model().table()), measured);
    EXPECT_TRUE(dialog().exportButton().isEnabled());
    EXPECT_EQ(dialog().progressBar().value(), dialog().progressBar().maximum());
}

TEST_F(Reproduce, closingTheDialogStopsTheExperiment) {
    const SessionState before = captureState(session);
    dialog().choice().setCurrentIndex(1);
    QTest::mouseClick(&dialog().startButton(), Qt::LeftButton);
    dialog().reject();
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_EQ(captureState(session), before);
    ASSERT_TRUE(waitUntil([this] { return window.findChild<ReproduceDialog*>() == nullptr; }));
}

TEST_F(Reproduce, plotIsShownOnlyWhereThereIsOne) {
    for (size_t i = 0; i < knownExperiments().size(); ++i) {
        dialog().choice().setCurrentIndex(int(i));
        const bool plot = !knownExperiments()[i].plots.empty();
        EXPECT_EQ(dialog().pages().tabBar()->isVisible(), plot) << knownExperiments()[i].id;
        EXPECT_EQ(dialog().plot().empty(), !plot);
        if (!plot) {
            EXPECT_EQ(dialog().pages().currentWidget(), &dialog().table());
        }
    }
    dialog().choice().setCurrentIndex(indexOf("vfc-40-views"));
    dialog().pages().setCurrentWidget(&dialog().plot());
    dialog().choice().setCurrentIndex(0);
    EXPECT_TRUE(dialog().table().isVisible()) << "the plot of another table stays in front";
}

TEST_F(Reproduce, everyPlotHasATabOfItsOwn) {
    for (const Experiment& experiment : knownExperiments()) {
        dialog().choice().setCurrentIndex(indexOf(experiment.id));
        ASSERT_EQ(dialog().plots().size(), std::max<size_t>(1, experiment.plots.size())) << experiment.id;
        ASSERT_EQ(dialog().pages().count(), int(dialog().plots().size()) + 1);
        for (size_t i = 0; i < experiment.plots.size(); ++i) {
            const LinePlotWidget& plot = *dialog().plots()[i];
            EXPECT_EQ(plot.plot().y.title, experiment.plots[i].plot.y.title) << experiment.id;
            EXPECT_FALSE(plot.title().contains(QRegularExpression(QStringLiteral("%[0-9]"))))
                << "a place without a value: " << plot.title().toStdString();
            const QString tab = dialog().pages().tabText(int(i) + 1);
            EXPECT_EQ(tab, experiment.plots.size() == 1 ? QStringLiteral("Plot") : plot.title()) << experiment.id;
        }
    }
    dialog().choice().setCurrentIndex(indexOf("plant-pipelines"));
    ASSERT_EQ(dialog().plots().size(), 3u);
    dialog().pages().setCurrentIndex(3);
    EXPECT_TRUE(dialog().plots().back()->isVisible());
    const QTemporaryDir folder;
    const QString svg = folder.filePath(QStringLiteral("plot.svg"));
    dialog().exportTo(ReproduceDialog::File::Svg, svg.toStdString());
    ASSERT_TRUE(waitUntil([&] { return QFile::exists(svg); }));
    QFile written(svg);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_TRUE(written.readAll().contains("Culling by visible leaves")) << "the plot in front is written";
    dialog().choice().setCurrentIndex(0);
    EXPECT_TRUE(dialog().table().isVisible());
}

TEST_F(Reproduce, plotShowsPointsBeforeTheEndAndCancelGivesTheSessionBack) {
    const SessionState before = captureState(session);
    const size_t stored = store::ResultStore(historyStore()).list().size();
    dialog().choice().setCurrentIndex(indexOf("vfc-40-views"));
    EXPECT_TRUE(dialog().plot().plot().lines.empty());
    int shown = 0;
    QObject::connect(&window.papers().runner(), &PaperRunner::progressed, [&](double, const QString&) { ++shown; });
    QTest::mouseClick(&dialog().startButton(), Qt::LeftButton);
    EXPECT_TRUE(dialog().plot().isVisible()) << "rows come in the end, points before";
    // Wait until the bunnies are opened and the first views are measured.
    ASSERT_TRUE(waitUntil([&] { return !dialog().plot().plot().lines.empty(); }));
    expectDialogIsOnTheScreen();
    EXPECT_GE(dialog().plot().height(), dialog().plot().neededHeight(dialog().plot().width()));
    EXPECT_EQ(dialog().plot().visibleRegion().boundingRect(), dialog().plot().rect()) << "its lower end is cut";
    EXPECT_FALSE(dialog().plot().plot().lines.front().points.empty());
    EXPECT_EQ(session.viewCount(), 1);
    EXPECT_TRUE(dialog().heading().contains(QStringLiteral("frustum"))) << dialog().heading().toStdString();
    QTest::mouseClick(&dialog().cancelButton(), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_GT(shown, 1);
    EXPECT_TRUE(dialog().model().table().interrupted);
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_TRUE(dialog().startButton().isEnabled());
    EXPECT_LT(dialog().progressBar().value(), dialog().progressBar().maximum() / 2) << "the bar looks complete";
    EXPECT_EQ(captureState(session), before);
    EXPECT_TRUE(dialog().exportButton().isEnabled());
    expectDialogIsOnTheScreen();
    // The views that were measured until then are in the store.
    const std::vector<store::Listed> list = store::ResultStore(historyStore()).list();
    ASSERT_EQ(list.size(), stored + 1);
    EXPECT_EQ(list.back().origin.experiment, "vfc-40-views");
    EXPECT_TRUE(list.back().interrupted);
    EXPECT_GT(list.back().measured, 0U);

    const QTemporaryDir folder;
    const QString svg = folder.filePath(QStringLiteral("plot.svg")), pdf = folder.filePath(QStringLiteral("plot.pdf"));
    dialog().exportTo(ReproduceDialog::File::Svg, svg.toStdString());
    dialog().exportTo(ReproduceDialog::File::Pdf, pdf.toStdString());
    ASSERT_TRUE(waitUntil([&] { return QFile::exists(svg) && QFile::exists(pdf); }));
    QFile written(svg);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray text = written.readAll();
    for (const char* words : {"spherical-lossless", "0.83", "paper, culled, mean: 10"})
        EXPECT_TRUE(text.contains(words)) << words;
    QFile document(pdf);
    ASSERT_TRUE(document.open(QIODevice::ReadOnly));
    EXPECT_TRUE(document.readAll().startsWith("%PDF"));
}

TEST(PaperTableModel, keepsTheRulesOfModels) {
    PaperTableModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    ResultTable table = emptyTable(findExperiment("table-2"));
    model.setTable(table);
    table.addRow({{"field_degrees", 10.0},
                  {"case", 1.0},
                  {"strategy", std::string("all")},
                  {"ratio_to_all", RatioEstimate{2.0, {1.5, 2.5}}}});
    model.setTable(table);
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column) cells << model.index(0, column).data().toString();
    EXPECT_TRUE(cells.contains(QStringLiteral("2.00 [1.50, 2.50]"))) << cells.join(u'|').toStdString();
    EXPECT_EQ(cells.first(), QStringLiteral("10"));
}

}  // namespace
}  // namespace cullscope::ui::reproduce_dialog_test
