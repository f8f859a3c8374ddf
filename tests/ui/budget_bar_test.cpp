#include "ui/views/budget_bar.h"

#include <gtest/gtest.h>

#include <QPixmap>
#include <numeric>

#include "ui/look/verdict_swatch.h"

namespace cullscope::ui::budget_bar_test {
namespace {

constexpr auto kLoss = size_t(TriangleState::WronglyCulled);

ViewMetrics figuresOf(const std::array<uint64_t, kTriangleStateCount>& counts) {
    auto states = std::make_shared<TriangleStates>();
    states->counts = counts;
    ViewMetrics figures;
    figures.state = ViewMetrics::State::Ready;
    figures.states = states;
    return figures;
}

int sum(const std::array<int, kTriangleStateCount>& widths) { return std::accumulate(widths.begin(), widths.end(), 0); }

TEST(BudgetBar, segmentsAreProportionalAndFillTheWidth) {
    BudgetBar bar;
    bar.resize(300, 12);
    bar.setFigures(figuresOf({100, 50, 100, 0, 50, 0, 0, 0}));
    EXPECT_EQ(bar.widths(), (std::array<int, kTriangleStateCount>{100, 50, 100, 0, 50, 0, 0, 0}));
    for (const int width : {1, 2, 7, 299, 1001}) {
        bar.resize(width, 12);
        bar.setFigures(figuresOf({1, 1, 1, 1, 1, 1, 1}));
        EXPECT_EQ(sum(bar.widths()), width);
    }
}

TEST(BudgetBar, oneLostTriangleOfManyIsVisible) {
    BudgetBar bar;
    bar.resize(320, 12);
    bar.setFigures(figuresOf({1'000'000'000, 0, 1'000'000'000, 0, 0, 0, 1}));
    EXPECT_EQ(bar.widths()[kLoss], 2);
    EXPECT_EQ(sum(bar.widths()), 320);
    const QImage picture = bar.grab().toImage();
    EXPECT_EQ(QColor(picture.pixel(319, 6)), verdictColour(TriangleState::WronglyCulled, bar.palette()));
    EXPECT_EQ(QColor(picture.pixel(318, 6)), verdictColour(TriangleState::WronglyCulled, bar.palette()));
    EXPECT_EQ(QColor(picture.pixel(10, 6)), verdictColour(TriangleState::Visible, bar.palette()));
    bar.setFigures(figuresOf({0, 0, 0, 0, 0, 0, 5}));
    EXPECT_EQ(bar.widths()[kLoss], 320);
    bar.setFigures(figuresOf({5, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(bar.widths()[kLoss], 0);
}

TEST(BudgetBar, staleNumbersStayPaleAndThoseOfAnotherSceneGo) {
    BudgetBar bar;
    bar.resize(100, 12);
    bar.setFigures(figuresOf({1, 0, 0, 0, 0, 0, 0}));
    const QColor fresh = QColor(bar.grab().toImage().pixel(50, 6));
    ViewMetrics stale;
    stale.state = ViewMetrics::State::Stale;
    bar.setFigures(stale);
    EXPECT_TRUE(bar.stale());
    EXPECT_EQ(sum(bar.widths()), 100);
    EXPECT_NE(QColor(bar.grab().toImage().pixel(50, 6)), fresh);
    bar.clear();
    EXPECT_FALSE(bar.stale());
    EXPECT_EQ(sum(bar.widths()), 0);
    bar.setFigures(stale);
    EXPECT_FALSE(bar.stale()) << "nothing was known";
}

TEST(BudgetBar, numbersAreInTheTooltipAndForScreenReaders) {
    BudgetBar bar;
    bar.setFigures(figuresOf({1234, 0, 0, 0, 0, 0, 3}));
    for (const QString& text : {bar.toolTip(), bar.accessibleDescription()}) {
        EXPECT_TRUE(text.contains(QStringLiteral("1,234"))) << text.toStdString();
        EXPECT_TRUE(text.contains(QStringLiteral("wrongly culled: 3"))) << text.toStdString();
        EXPECT_FALSE(text.contains(QStringLiteral("too small")));
    }
    EXPECT_FALSE(bar.accessibleName().isEmpty());
}

}  // namespace
}  // namespace cullscope::ui::budget_bar_test
