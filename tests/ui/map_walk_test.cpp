// The panels for the strategy `spherical-lossless`: quadtree, kernel, horizon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/scene/camera_moves.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_details.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/map_panel.h"
#include "ui/plots/map_words.h"
#include "ui/plots/plot_file.h"
#include "ui/session/cullbench_command.h"
#include "ui/session/object_pick.h"
#include "ui/text/terms.h"

namespace cullscope::ui::map_walk_test {
namespace {

/// A panel that reads the strategy on a scene.
struct WalkMap : ::testing::Test {
    void SetUp() override {
        session.slot(1).choose("spherical-lossless");
        session.setViewport(0, {160, 120});
        session.setViewport(1, {160, 120});
        open(QStringLiteral("star:seed=7,triangles=4000"));
        reader.readFor(&panel);
        panel.resize(420, 460);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
        settle();
    }

    void open(const QString& scene) { openAndWait(session, scene); }
    void settle() {
        ASSERT_TRUE(waitUntil([&] { return !session.slot(1).building() && reader.fresh() && session.metricsSettled(); }));
        QApplication::processEvents();
    }
    /// A scene of so many triangles that the horizon is tested though all is in view.
    void openWithHorizon() {
        open(QStringLiteral("star:seed=7,triangles=24000"));
        settle();
    }
    void choose(const char* colouring) {
        const int index = panel.colouring().findData(QString::fromLatin1(colouring));
        ASSERT_GE(index, 0);
        panel.colouring().setCurrentIndex(index);
        emit panel.colouring().activated(index);
    }
    [[nodiscard]] bool offers(const char* colouring) { return panel.colouring().findData(QString::fromLatin1(colouring)) >= 0; }
    /// The map with the decision that is shown.
    [[nodiscard]] const spherical::MapSnapshot& snapshot() {
        return *spherical::mapOf(*reader.reading()->snapshot, shown().map->object);
    }
    [[nodiscard]] QStringList lines() { return translatedLines(shown().map->lines); }
    [[nodiscard]] const ShownMap& shown() { return panel.map().contents().shown; }
    [[nodiscard]] QString words() { return QString::fromUtf8(plotSvg(panel.map(), {960, 560})); }

    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    MapPanel panel{session, reader};
};

TEST_F(WalkMap, levelAndKernelAreOfferedAndGivenUpWithTheStrategy) {
    EXPECT_TRUE(offers("level"));
    EXPECT_TRUE(offers("kernel"));
    choose("kernel");
    EXPECT_EQ(panel.map().colouring(), "kernel");
    EXPECT_TRUE(words().contains(QStringLiteral("R of the kernel"))) << "no scale";
    choose("level");
    EXPECT_TRUE(words().contains(QStringLiteral("level where the walk ended")));
    session.slot(1).choose("spherical");
    settle();
    EXPECT_FALSE(offers("level"));
    EXPECT_FALSE(offers("kernel"));
    EXPECT_EQ(panel.map().colouring(), "entries");
    EXPECT_EQ(panel.colouring().currentData().toString(), QStringLiteral("entries"));
    choose("state");
    session.slot(1).choose("spherical-lossless");
    settle();
    EXPECT_EQ(panel.map().colouring(), "state") << "what every map has stays";
}

TEST_F(WalkMap, aMeshWithoutAKernelSaysWhyAndHasNoKernelColours) {
    choose("kernel");
    open(QStringLiteral("bowl:triangles=4000"));
    settle();
    EXPECT_TRUE(offers("level"));
    EXPECT_FALSE(offers("kernel"));
    EXPECT_EQ(panel.map().colouring(), "entries");
    const QStringList said = lines();
    ASSERT_GE(said.size(), 2);
    EXPECT_TRUE(said.back().startsWith(QStringLiteral("No kernel: "))) << said.back().toStdString();
    EXPECT_TRUE(said.back().contains(QString::fromLatin1(InnerKernel::stateName(snapshot().kernel->state()))));
    EXPECT_TRUE(said[0].contains(QStringLiteral("horizon not used")));
}

TEST_F(WalkMap, wordsCountWhatEachTestCulled) {
    openWithHorizon();
    const spherical::CellWalk& walk = *snapshot().decision.walk;
    ASSERT_TRUE(walk.cones && walk.hiding);
    ASSERT_GT(walk.culled[size_t(Cause::BackFacing)], 0U);
    const QStringList said = lines();
    ASSERT_GE(said.size(), 2);
    EXPECT_TRUE(said[0].contains(QLocale().toString(qulonglong(walk.culled[size_t(Cause::BackFacing)]))))
        << said[0].toStdString();
    EXPECT_FALSE(said[0].contains(QStringLiteral("not used")));
    EXPECT_TRUE(said.back().startsWith(QStringLiteral("Kernel filled to R ")));
    EXPECT_TRUE(panel.map().accessibleDescription().contains(said[0]));
    ParameterSet without = session.slot(1).parameters();
    without.set("cones", false);
    without.set("horizon", false);
    session.slot(1).setParameters(without);
    settle();
    EXPECT_EQ(lines()[0].count(QStringLiteral("not used")), 2);
    EXPECT_TRUE(lines().back().startsWith(QStringLiteral("No kernel")));
}

TEST_F(WalkMap, cellsSayTheirLevelTrianglesAndCause) {
    const spherical::MapSnapshot& map = snapshot();
    const SphericalGrid& grid = shown().grid();
    bool drawn = false, backFacing = false;
    for (uint32_t row = 0; row < grid.rows(); row += 3)
        for (uint32_t column = 0; column < grid.columns(); column += 3) {
            const double theta = (grid.thetaOf(row) + grid.thetaOf(row + 1)) / 2;
            const double phi = (grid.phiOf(column) + grid.phiOf(column + 1)) / 2;
            const spherical::JudgedCell* judged =
                judgedCellAt(map, {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
            const QString said = cellWords(shown(), nullptr, grid.number({row, column}));
            ASSERT_EQ(said.contains(QStringLiteral("Quadtree: level")), judged != nullptr) << said.toStdString();
            if (!judged) continue;
            const CellTree::Node& node = map.tree->nodes()[judged->node];
            const char* verdict = judged->cause ? causeName(*judged->cause) : "drawn";
            EXPECT_TRUE(said.contains(QStringLiteral("level %1, triangles: %2, %3")
                                          .arg(int(node.level))
                                          .arg(node.count)
                                          .arg(QString::fromLatin1(verdict))))
                << said.toStdString();
            drawn = drawn || !judged->cause;
            backFacing = backFacing || judged->cause == Cause::BackFacing;
        }
    EXPECT_TRUE(drawn && backFacing);
}

TEST_F(WalkMap, legendHasCellsAndHorizonAndTheStatesThatThereAre) {
    openWithHorizon();
    EXPECT_TRUE(words().contains(QStringLiteral("cell of the quadtree")));
    EXPECT_TRUE(words().contains(QStringLiteral("horizon of the kernel")));
    choose("state");
    EXPECT_TRUE(words().contains(QStringLiteral(">back-facing<")));
    session.slot(1).choose("spherical");
    settle();
    EXPECT_FALSE(words().contains(QStringLiteral("quadtree")));
    EXPECT_FALSE(words().contains(QStringLiteral("horizon of the kernel")));
}

TEST_F(WalkMap, roomDoesNotChangeWithTheDecision) {
    const int before = panel.map().neededHeight(400);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(50.0), {}));
    settle();
    EXPECT_EQ(panel.map().neededHeight(400), before);
}

TEST_F(WalkMap, aPickedObjectOfAnotherMeshIsShownOnlyWhenItsMapIsMade) {
    open(QStringLiteral("split:mesh=torus:triangles=4000,by=clusters,triangles=1000"));
    settle();
    const uint32_t before = shown().map->object;
    const uint32_t other = before == 0 ? 1 : 0;
    const CellMapPointer map = shown().map;
    pickObject(session, other);
    EXPECT_EQ(shown().map, map) << "the other map would be made in the window's thread";
    settle();
    EXPECT_EQ(shown().map->object, other);
    EXPECT_NE(shown().source().key(), map->source->key());
    EXPECT_TRUE(panel.map().contents().picked);
}

TEST_F(WalkMap, aCellPicksATriangleAndThePickMarksItsCells) {
    uint32_t cell = 0;
    while (shown().source().owned(cell).empty()) ++cell;
    panel.pickIn(cell);
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->triangle, shown().source().owned(cell).back());
    settle();
    EXPECT_EQ(panel.map().contents().picked, uint32_t(session.pick()->triangle));
}

TEST_F(WalkMap, kernelsOfStrategiesWithoutOneAreNotAskedFor) {
    const ViewLook wanted{"kernel"};
    EXPECT_TRUE(shownLook(*session.picture(1)->frame, wanted).shows("kernel"));
    PictureSubject picture;
    picture.scene = "bunny";
    picture.look = wanted;
    EXPECT_TRUE(cullbenchArguments(picture, {}).join(QLatin1Char(' ')).contains(QStringLiteral("--overlay kernel")));
    session.slot(1).choose("spherical");
    settle();
    EXPECT_FALSE(shownLook(*session.picture(1)->frame, wanted).shows("kernel"));
}

}  // namespace
}  // namespace cullscope::ui::map_walk_test
