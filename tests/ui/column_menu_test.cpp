#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSettings>
#include <QTableView>

#include "core/measure/field_figures.h"
#include "tests/ui/made_up_result.h"
#include "ui/statistics/column_menu.h"
#include "ui/statistics/html_report.h"
#include "ui/statistics/result_table_model.h"

namespace cullscope::ui::column_menu_test {
namespace {

int columnOf(const char* key) {
    for (int column = 0; column < ResultTableModel::columns(); ++column)
        if (ResultTableModel::id(column) == QLatin1String(key)) return column;
    return -1;
}

RatioEstimate estimate(double value, double low, double high) { return {value, {low, high}, true}; }

/// The made-up result, whose third strategy has figures of the field.
MeasureResult withFigures() {
    MeasureResult result = madeUpResult();
    FieldEstimates& field = result.runs[2].summary.field;
    field.resize(fieldFigures().size());
    field[fieldFigurePlace("triangle_false_negative_rate")] = estimate(0.0125, 0.011, 0.0133);
    field[fieldFigurePlace("object_false_negative_rate")] = RatioEstimate{0.0, {0.0, 0.0}, false};
    field[fieldFigurePlace("popping_events_per_1000_frames")] = estimate(250.0, 0.0, 500.0);
    return result;
}

class Columns : public ::testing::Test {
protected:
    Columns() {
        QSettings().remove(QStringLiteral("statistics/columns"));
        table.setModel(&model);
    }
    ~Columns() override { QSettings().remove(QStringLiteral("statistics/columns")); }

    [[nodiscard]] QStringList shown() const {
        QStringList ids;
        for (int column = 0; column < model.columnCount(); ++column)
            if (!table.isColumnHidden(column)) ids << ResultTableModel::id(column);
        return ids;
    }
    static QAction* actionOf(ColumnMenu& menu, const char* key) {
        const QString title = ResultTableModel::title(columnOf(key)).simplified();
        for (QAction* action : menu.actions())
            if (action->text() == title) return action;
        return nullptr;
    }

    ResultTableModel model;
    QTableView table;
};

TEST(ResultTable, theFieldsFiguresAreColumnsWithTheirIntervals) {
    ResultTableModel model;
    model.setRows(resultRows(withFigures()));
    const auto cell = [&](const char* key) { return model.index(2, columnOf(key)).data().toString(); };
    EXPECT_EQ(cell("triangle_false_negative_rate"), QStringLiteral("1.3 [1.1, 1.3]"));
    EXPECT_EQ(cell("object_false_negative_rate"), QStringLiteral("0"));
    EXPECT_EQ(cell("popping_events_per_1000_frames"), QStringLiteral("250 [0, 500]"));
    EXPECT_EQ(cell("silhouette_error_px"), QStringLiteral("–")) << "not measured";
    EXPECT_EQ(ResultTableModel::columns(), int(ResultTableModel::FirstFigure + fieldFigures().size()) - 1);
    for (int column = ResultTableModel::FirstFigure; column < ResultTableModel::columns(); ++column) {
        EXPECT_FALSE(ResultTableModel::title(column).isEmpty()) << column;
        EXPECT_FALSE(model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty()) << column;
    }
}

TEST(ResultTable, figuresOfOneViewAreThoseThatOneViewHas) {
    LiveFigures live{QStringLiteral("A"), test::request("frustum"), Promise::Approximate, {}};
    live.figures.state = ViewMetrics::State::Ready;
    live.figures.frameMilliseconds = 5.0;
    Accuracy& errors = live.figures.accuracy;
    errors.visibleTriangles = 200;
    errors.falselyCulledTriangles = 3;
    errors.sceneTriangles = 1000;
    errors.needlesslyDrawnTriangles = 400;
    errors.visibleObjects = 4;
    errors.sceneObjects = 4;
    errors.outlinePixels = 50;
    errors.differentlyCovered = 5;
    const std::vector<ResultRow> rows = liveRows({live});
    const auto value = [&](const char* key) { return ResultTableModel::value(rows[0], columnOf(key)); };
    EXPECT_EQ(value("triangle_false_negative_rate"), QStringLiteral("1.5"));
    EXPECT_EQ(value("triangle_false_positive_rate"), QStringLiteral("50"));
    EXPECT_EQ(value("object_false_negative_rate"), QStringLiteral("0"));
    EXPECT_EQ(value("object_false_positive_rate"), QString()) << "all objects are visible";
    EXPECT_EQ(value("silhouette_error_px"), QStringLiteral("0.10"));
    EXPECT_EQ(value("popping_events_per_1000_frames"), QString());
    EXPECT_EQ(value("image_difference_mean"), QString());
}

TEST_F(Columns, figuresAreShownWhereTheyAreChosenAndStayChosen) {
    QStringList usual;
    for (int column = 0; column < ResultTableModel::FirstFigure; ++column) usual << ResultTableModel::id(column);
    {
        ColumnMenu menu(table);
        menu.retranslate();
        EXPECT_EQ(shown(), usual);
        actionOf(menu, "triangle_false_negative_rate")->trigger();
        actionOf(menu, "fps-range")->trigger();
        EXPECT_THAT(shown(), testing::Contains(QStringLiteral("triangle_false_negative_rate")));
        EXPECT_THAT(shown(), testing::Not(testing::Contains(QStringLiteral("fps-range"))));
    }
    const QStringList chosen = shown();
    QTableView other;
    other.setModel(&model);
    ColumnMenu later(other);
    for (int column = 0; column < model.columnCount(); ++column)
        EXPECT_EQ(other.isColumnHidden(column), table.isColumnHidden(column)) << column;
    later.actions().last()->trigger();
    for (int column = 0; column < model.columnCount(); ++column)
        EXPECT_EQ(other.isColumnHidden(column), column >= ResultTableModel::FirstFigure) << column;
    EXPECT_FALSE(QSettings().contains(QStringLiteral("statistics/columns")));
}

TEST(HtmlReport, hasTheFieldsFiguresByStrategy) {
    const QString page = QString::fromUtf8(htmlReport(withFigures(), {}));
    EXPECT_TRUE(page.contains(QStringLiteral("False negatives, triangles, %</td>"))) << page.toStdString();
    EXPECT_TRUE(page.contains(QStringLiteral("<td>1.3 [1.1, 1.3]</td>")));
}

}  // namespace
}  // namespace cullscope::ui::column_menu_test
