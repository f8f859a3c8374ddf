// The tabs "Listing" and "Counts" of the panel with the structure of a strategy.

#include "ui/panels/listing_panel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QHeaderView>

#include "tests/ui/test_scene.h"
#include "ui/panels/structure_panel.h"
#include "ui/plots/plot_file.h"
#include "ui/session/object_pick.h"
#include "ui/text/wording.h"

namespace cullscope::ui::listing_panel_test {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

TEST(ListingModel, marksTheCurrentLineInWordsToo) {
    ListingModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    model.setLines({{"for each object", 0}, {"test it", 1}, {"leave it out", 1}, {"draw it", 1}});
    const auto text = [&](int row, int column, int role = Qt::DisplayRole) {
        return model.index(row, column).data(role).toString();
    };
    EXPECT_EQ(text(1, ListingModel::Text), QStringLiteral(" 2   test it"));
    EXPECT_TRUE(text(1, ListingModel::Decisions).isEmpty()) << "nothing is known yet";
    const ListingState frame{{0, 12'345, 3, 4}, 4};
    model.setState(frame, frame);
    EXPECT_EQ(text(1, ListingModel::Decisions), countText(12'345));
    EXPECT_TRUE(text(0, ListingModel::Decisions).isEmpty());
    for (int row = 0; row < 4; ++row) {
        EXPECT_EQ(text(row, ListingModel::Mark), row == 3 ? QStringLiteral("▶") : QString()) << row;
        EXPECT_EQ(text(row, ListingModel::Mark, Qt::AccessibleTextRole),
                  row == 3 ? QStringLiteral("the current line") : QString());
    }
    // With a pick, the lines that decided about it.
    model.setState(frame, ListingState{{0, 2, 1, 0}, 3});
    EXPECT_EQ(text(1, ListingModel::Mark), QStringLiteral("•"));
    EXPECT_FALSE(text(1, ListingModel::Mark, Qt::AccessibleTextRole).isEmpty());
    EXPECT_EQ(text(2, ListingModel::Mark), QStringLiteral("▶"));
    EXPECT_TRUE(text(3, ListingModel::Mark).isEmpty());
    EXPECT_EQ(text(1, ListingModel::Decisions), countText(12'345)) << "the counts stay those of the frame";
    EXPECT_TRUE(model.index(2, ListingModel::Text).data(Qt::FontRole).value<QFont>().bold());
    EXPECT_FALSE(model.index(3, ListingModel::Text).data(Qt::FontRole).value<QFont>().bold());
}

/// A panel for a field of spheres, of which half lies outside the active view's frustum.
struct ListingPanelTest : ::testing::Test {
    void SetUp() override {
        session.slot(1).choose("frustum");
        session.setViewport(0, {160, 120});
        session.setViewport(1, {160, 120});
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=4"));
        panel.resize(400, 500);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
        Camera camera = session.camera();
        camera.eye = camera.target + 0.3 * (camera.eye - camera.target);
        session.setCamera(camera);
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitUntil([&] { return !session.slot(1).building() && reader.fresh() && session.metricsSettled(); }));
        QApplication::processEvents();
    }
    [[nodiscard]] bool shows(QWidget& page) { return panel.tabs().isTabVisible(panel.tabs().indexOf(&page)); }
    [[nodiscard]] QString mark(int line) { return panel.listing().model().index(line - 1, ListingModel::Mark).data().toString(); }

    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    StructurePanel panel{session, reader};
};

TEST_F(ListingPanelTest, tabsAreThereWhereTheStrategyDeclaresThem) {
    EXPECT_TRUE(shows(panel.listing()) && shows(panel.bars()));
    panel.tabs().setCurrentWidget(&panel.bars());
    session.slot(1).choose("all");
    EXPECT_TRUE(shows(panel.listing())) << "every strategy has one";
    EXPECT_FALSE(shows(panel.bars()));
    EXPECT_EQ(panel.tabs().currentWidget(), &panel.tree());
    session.slot(1).choose("frustum-octree");
    EXPECT_TRUE(shows(panel.listing()) && shows(panel.bars()));
    EXPECT_EQ(panel.tabs().currentWidget(), &panel.bars()) << "it comes back as it went";
    session.slot(1).choose("all");
    panel.showWhy();
    session.slot(1).choose("frustum");
    EXPECT_EQ(panel.tabs().currentWidget(), &panel.why()) << "another one was chosen meanwhile";
    session.slot(1).choose("spherical");
    EXPECT_TRUE(shows(panel.listing()));
    EXPECT_FALSE(shows(panel.bars()));
    session.observe(0, 1);
    session.setActiveView(0);
    EXPECT_TRUE(shows(panel.listing())) << "an observer shows the inside of what it watches";
}

TEST_F(ListingPanelTest, flowChartIsLitAtTheListingsCurrentLine) {
    EXPECT_FALSE(shows(panel.flowChart())) << "frustum culling has none";
    session.slot(1).choose("spherical");
    settle();
    EXPECT_TRUE(shows(panel.flowChart()));
    FlowChartPlot& plot = panel.flowChart().plot();
    ASSERT_FALSE(plot.empty());
    ASSERT_GT(reader.reading()->listing->current, 0);
    EXPECT_EQ(plot.line(), reader.reading()->listing->current);
    // What is lit is told in words, too, and in the user's language.
    EXPECT_EQ(plot.accessibleDescription().count(QStringLiteral("the step in hand")), 1)
        << plot.accessibleDescription().toStdString();
    EXPECT_FALSE(plot.litPlace().isEmpty());
    panel.tabs().setCurrentWidget(&panel.flowChart());
    QApplication::processEvents();
    EXPECT_TRUE(plot.visibleRegion().boundingRect().intersects(plot.litPlace())) << "it is scrolled to";
    EXPECT_GT(plot.neededHeight(360), plot.neededHeight(900)) << "words break into more lines in a narrow dock";
    EXPECT_FALSE(plotImage(plot, {720, 640}).isNull());
    session.slot(1).choose("all");
    EXPECT_FALSE(shows(panel.flowChart()));
}

TEST_F(ListingPanelTest, countsAreThoseOfTheFrame) {
    const BuiltStrategy& built = *session.slot(1).built();
    const FrameLog log = built.decide(View(session.camera(), {160, 120}), *built.begin(), true);
    const ListingState expected = *built.listing(log);
    const ListingModel& model = panel.listing().model();
    ASSERT_EQ(model.rowCount(), int(expected.decisions.size()));
    for (int row = 0; row < model.rowCount(); ++row) {
        const uint64_t count = expected.decisions[size_t(row)];
        EXPECT_EQ(model.index(row, ListingModel::Decisions).data().toString(), count > 0 ? countText(count) : QString());
    }
    EXPECT_TRUE(mark(expected.current).isEmpty()) << "which line the frame's last decision fell at says nothing of the frame";
    EXPECT_TRUE(panel.listing().summary().contains(countText(expected.total()))) << panel.listing().summary().toStdString();
}

TEST_F(ListingPanelTest, linesThatDecidedAboutThePickAreMarked) {
    const auto instanceWith = [&](bool culled) {
        for (const SnapshotNode& node : reader.reading()->snapshot->nodes)
            if (node.culled == culled) return node.instance;
        ADD_FAILURE();
        return 0u;
    };
    const uint32_t culled = instanceWith(true), drawn = instanceWith(false);
    pickObject(session, culled);
    settle();
    EXPECT_EQ(mark(4), QStringLiteral("•")) << "a plane that it lies outside of";
    EXPECT_EQ(mark(6), QStringLiteral("▶")) << "the line that left it out";
    EXPECT_TRUE(mark(7).isEmpty());
    EXPECT_TRUE(panel.listing().summary().endsWith(QStringLiteral("decided at line 6.")))
        << panel.listing().summary().toStdString();
    pickObject(session, drawn);
    settle();
    EXPECT_EQ(mark(3), QStringLiteral("•"));
    EXPECT_EQ(mark(7), QStringLiteral("▶"));
    EXPECT_TRUE(mark(4).isEmpty());
    EXPECT_TRUE(mark(6).isEmpty());
    session.setPick(std::nullopt);
    settle();
    for (int line = 1; line <= 7; ++line) EXPECT_TRUE(mark(line).isEmpty()) << "without a pick " << line;
}

TEST_F(ListingPanelTest, noLineAndNoNameIsCutInANarrowDock) {
    for (const RegisteredStrategy& strategy : strategies()) {
        if (strategy.info.first(Show::Kind::Listing) == nullptr || strategy.info.glRequirement != GlRequirement::None) continue;
        SCOPED_TRACE(strategy.info.id);
        session.slot(1).choose(strategy.info.id);
        settle();
        panel.tabs().setCurrentWidget(&panel.listing());
        QApplication::processEvents();
        QTableView& view = panel.listing().view();
        EXPECT_LE(view.horizontalHeader()->length(), view.viewport()->width());
        for (int row = 0; row < view.model()->rowCount(); ++row) {
            QStyleOptionViewItem option;
            option.initFrom(&view);
            option.features = QStyleOptionViewItem::WrapText;
            option.rect = QRect(0, 0, view.columnWidth(ListingModel::Text), 1000);
            const QSize needed = view.itemDelegate()->sizeHint(option, view.model()->index(row, ListingModel::Text));
            EXPECT_LE(needed.height(), view.rowHeight(row)) << row;
        }
        if (!shows(panel.bars())) continue;
        panel.tabs().setCurrentWidget(&panel.bars());
        QApplication::processEvents();
        const PlotDrawing drawing = panel.bars().plot().drawing();
        for (const Bar& bar : reader.reading()->bars.front().bars) {
            const bool written = std::ranges::any_of(drawing.items, [&](const auto& item) {
                const auto* text = std::get_if<DrawnText>(&item);
                return text != nullptr && text->words == bar.name;
            });
            EXPECT_TRUE(written) << bar.name;
        }
    }
}

TEST_F(ListingPanelTest, theCurrentLineIsInSightAndNoLineIsHalf) {
    session.slot(1).choose("frustum");
    settle();
    panel.tabs().setCurrentWidget(&panel.listing());
    for (const SnapshotNode& node : reader.reading()->snapshot->nodes)
        if (node.culled) pickObject(session, node.instance);
    settle();
    ListingView& view = panel.listing().view();
    const int current = panel.listing().model().currentRow();
    ASSERT_GE(current, 5) << "else a low view begins with it";
    const int line = view.rowHeight(current);
    // Room for some lines and a half.
    for (const int lines : {2, 4, 3}) {
        const int others = panel.height() - view.viewport()->height();
        panel.setMinimumSize(1, 1);
        panel.tabs().setMinimumSize(1, 1);
        panel.resize(panel.width(), others + lines * line + line / 2);
        QApplication::processEvents();
        QApplication::processEvents();
        const QRect place = view.visualRect(panel.listing().model().index(current, ListingModel::Text));
        EXPECT_TRUE(place.top() >= 0 && place.bottom() < view.viewport()->height())
            << lines << " lines: at " << place.top() << " of " << view.viewport()->height();
        const QImage shown = view.viewport()->grab().toImage();
        int end = 0;
        for (int row = 0; row < view.model()->rowCount(); ++row)
            if (const int below = view.rowViewportPosition(row) + view.rowHeight(row); below <= shown.height())
                end = std::max(end, below);
        for (int y = end; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x)
                ASSERT_EQ(shown.pixel(x, y), shown.pixel(0, shown.height() - 1))
                    << lines << " lines: something at " << x << ", " << y;
    }
}

TEST_F(ListingPanelTest, countsAreSavedAsAPicture) {
    ASSERT_FALSE(panel.bars().plot().empty());
    const QByteArray svg = plotSvg(panel.bars().plot(), {720, 320});
    for (const char* words : {"Objects by the plane that rejected them", "left plane", "far plane"})
        EXPECT_TRUE(svg.contains(words)) << words;
    EXPECT_TRUE(plotPdf(panel.bars().plot(), {720, 320}).startsWith("%PDF"));
}

TEST(ListingPanel, withoutASceneSaysSo) {
    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    session.slot(session.activeView()).choose("frustum");
    StructurePanel panel{session, reader};
    EXPECT_EQ(panel.listing().model().rowCount(), 7) << "the lines are there before a frame is";
    EXPECT_TRUE(panel.listing().summary().startsWith(QStringLiteral("There is no scene")));
    EXPECT_TRUE(panel.bars().plot().empty());
    EXPECT_TRUE(panel.bars().plot().accessibleDescription().startsWith(QStringLiteral("There is no scene")));
}

}  // namespace
}  // namespace cullscope::ui::listing_panel_test
