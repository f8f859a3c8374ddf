#include "ui/panels/structure_panel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <random>
#include <set>

#include "core/measure/accuracy.h"
#include "core/scene/camera_moves.h"
#include "tests/ui/test_scene.h"
#include "ui/jobs/object_verdicts.h"
#include "ui/session/object_pick.h"

namespace cullscope::ui::structure_panel_test {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;
constexpr const char* kField = "field:mesh=sphere:triangles=80,n=4";

SnapshotNode node(int32_t parent, uint32_t instance, bool culled = false) {
    SnapshotNode node;
    node.parent = parent;
    node.instance = instance;
    node.triangles = 80;
    node.culled = culled;
    if (culled) node.rejectedBy = FrustumPlane::Top;
    return node;
}

TEST(StructureModel, holdsTreesWhoseParentsComeAfterTheirChildren) {
    const ScenePointer scene = openScene(kField).scene;
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        const size_t count = 1 + random() % 40;
        std::vector<int32_t> order(count);
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), random);
        auto snapshot = std::make_shared<StructureSnapshot>();
        snapshot->nodes.assign(count, node(-1, 0));
        // The parent of each node precedes it in a random permutation: the tree has no cycle, and its order is not that of the
        // indices.
        for (size_t i = 0; i < count; ++i) {
            const size_t parent = random() % (i + 1);
            snapshot->nodes[size_t(order[i])] = node(parent == i ? -1 : order[parent], uint32_t(i % scene->instances().size()));
        }
        StructureModel model;
        const QAbstractItemModelTester tester(&model, kFatal);
        model.setSnapshot(scene, snapshot);
        size_t seen = 0;
        std::function<void(const QModelIndex&, int32_t)> walk = [&](const QModelIndex& parent, int32_t number) {
            for (int row = 0; row < model.rowCount(parent); ++row) {
                const QModelIndex child = model.index(row, 0, parent);
                ++seen;
                EXPECT_EQ(snapshot->nodes[model.nodeOf(child)].parent, number);
                EXPECT_EQ(model.parent(child), parent);
                EXPECT_EQ(model.instanceAt(child).has_value(), model.rowCount(child) == 0);
                walk(child, int32_t(model.nodeOf(child)));
            }
        };
        walk({}, -1);
        EXPECT_EQ(seen, count);
    }
}

TEST(StructureModel, aNewReadingOfTheSameBoxesKeepsTheRows) {
    const ScenePointer scene = openScene(kField).scene;
    StructureModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    auto before = std::make_shared<StructureSnapshot>();
    before->nodes = {node(-1, 0), node(0, 3), node(0, 5)};
    model.setSnapshot(scene, before);
    const QPersistentModelIndex kept = model.indexOfInstance(5);
    ASSERT_TRUE(kept.isValid());
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    auto after = std::make_shared<StructureSnapshot>(*before);
    after->nodes[2] = node(0, 5, true);
    model.setSnapshot(scene, after);
    EXPECT_EQ(resets.count(), 0);
    EXPECT_TRUE(kept.isValid());
    EXPECT_EQ(kept.sibling(kept.row(), StructureModel::Verdict).data().toString(), QStringLiteral("outside the frustum"));
    EXPECT_EQ(kept.sibling(kept.row(), StructureModel::Plane).data().toString(), QStringLiteral("top plane"));
    EXPECT_FALSE(model.indexOfInstance(0).isValid()) << "a box that holds others stands for no object";
    after = std::make_shared<StructureSnapshot>();
    after->nodes = {node(-1, 5)};
    model.setSnapshot(scene, after);
    EXPECT_EQ(resets.count(), 1);
    model.setSnapshot(scene, nullptr);
    EXPECT_EQ(model.rowCount(), 0);
}

/// A panel for a field of spheres, half of which lies outside the active view's frustum.
struct StructurePanelTest : ::testing::Test {
    void SetUp() override {
        session.slot(1).choose("frustum");
        session.setViewport(0, {160, 120});
        session.setViewport(1, {160, 120});
        openAndWait(session, QString::fromLatin1(kField));
        panel.resize(400, 500);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
        session.setCamera(zoomedCamera());
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return !session.slot(1).building() && reader.fresh() && session.metricsSettled(); }));
        QApplication::processEvents();
    }

    [[nodiscard]] Camera zoomedCamera() const {
        Camera camera = session.camera();
        camera.eye = camera.target + 0.3 * (camera.eye - camera.target);
        return camera;
    }
    [[nodiscard]] const StructureSnapshot& snapshot() const { return *reader.reading()->snapshot; }
    [[nodiscard]] uint32_t firstCulled() const {
        for (const SnapshotNode& node : snapshot().nodes)
            if (node.culled) return node.instance;
        ADD_FAILURE() << "nothing is culled";
        return 0;
    }

    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    StructurePanel panel{session, reader};
};

TEST_F(StructurePanelTest, treeShowsWhatTheStrategyDecided) {
    const BuiltStrategy& built = *session.slot(1).built();
    const FrameLog log = built.decide(View(session.camera(), {160, 120}), *built.begin(), true);
    const StructureSnapshot expected = built.snapshot(log);
    const StructureModel& model = panel.tree().model();
    ASSERT_EQ(model.rowCount(), int(expected.nodes.size()));
    int culled = 0;
    for (int row = 0; row < model.rowCount(); ++row) {
        const SnapshotNode& node = expected.nodes[size_t(row)];
        culled += node.culled ? 1 : 0;
        EXPECT_EQ(model.index(row, StructureModel::Name).data().toString().toStdString(),
                  session.scene()->instances()[node.instance].name);
        const QString verdict = model.index(row, StructureModel::Verdict).data().toString();
        if (node.culled)
            EXPECT_EQ(verdict, QStringLiteral("outside the frustum"));
        else  // the truth is known at this point
            EXPECT_TRUE(verdict == QStringLiteral("drawn and visible") || verdict == QStringLiteral("drawn in vain"))
                << verdict.toStdString();
        EXPECT_EQ(model.index(row, StructureModel::Plane).data().toString().isEmpty(), !node.culled);
    }
    EXPECT_GT(culled, 0);
    EXPECT_LT(culled, model.rowCount());
}

TEST_F(StructurePanelTest, selectingARowPicksAndAPickSelectsTheRow) {
    StructureTree& tree = panel.tree();
    tree.view().setCurrentIndex(tree.model().index(3, 0));
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->object, *tree.model().instanceAt(tree.model().index(3, 0)));
    const uint32_t picked = session.pick()->object;
    EXPECT_EQ(uint32_t(session.scene()->instanceOf(session.pick()->triangle)), picked);
    // The picked triangle stands for its object: it is visible if any triangle of the object is.
    const ViewMetrics& figures = session.figures(session.activeView());
    ASSERT_TRUE(figures.states);
    ObjectVerdicts verdicts;
    verdicts.set(session.scene(), figures.states, nullptr);
    ASSERT_TRUE(verdicts.of(picked));
    EXPECT_EQ(figures.states->states[session.pick()->triangle], verdicts.of(picked)->state);
    session.setPick(Pick{5, session.scene()->firstTriangle(5) + 9, Vec3(0.0)});
    EXPECT_EQ(tree.view().currentIndex(), tree.model().indexOfInstance(5));
    EXPECT_EQ(session.pick()->triangle, session.scene()->firstTriangle(5) + 9) << "the tree picked another triangle";
    session.setPick(std::nullopt);
    EXPECT_FALSE(tree.view().selectionModel()->hasSelection());
}

TEST_F(StructurePanelTest, picksKeepTheirObjectWhenOthersAreHidden) {
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[0] = hidden[2] = true;
    session.setHidden(hidden);
    settle();
    pickObject(session, 5);
    settle();
    ASSERT_TRUE(reader.reading()->triangle);
    EXPECT_EQ(session.scene()->instanceOf(*reader.reading()->triangle), 3u);
    EXPECT_EQ(panel.tree().view().currentIndex(), panel.tree().model().indexOfInstance(3));
    ASSERT_FALSE(panel.why().sentences().isEmpty());
    const QString name = QString::fromStdString(session.opened()->scene->instances()[5].name);
    EXPECT_TRUE(panel.why().sentences().front().contains(name)) << panel.why().sentences().front().toStdString();
    EXPECT_TRUE(panel.why().heading().startsWith(name));
    hidden[5] = true;
    session.setHidden(hidden);
    EXPECT_TRUE(panel.why().sentences().isEmpty());
    EXPECT_FALSE(reader.pickedTriangle());
}

TEST_F(StructurePanelTest, whySaysPlaneByPlaneAndTheVerdictLast) {
    EXPECT_TRUE(panel.why().sentences().isEmpty());
    const uint32_t culled = firstCulled();
    pickObject(session, culled);
    EXPECT_TRUE(panel.why().sentences().isEmpty()) << "of what was picked before";
    settle();
    const QStringList sentences = panel.why().sentences();
    ASSERT_EQ(sentences.size(), int(reader.reading()->why.size()));
    EXPECT_EQ(sentences.back(), QStringLiteral("The triangle is not given to OpenGL."));
    std::set<FrustumPlane> planes;
    for (const WhyStep& step : reader.reading()->why)
        if (step.plane) planes.insert(*step.plane);
    EXPECT_GT(planes.size(), 0u);
    PlaneTable& table = panel.why().planes();
    ASSERT_EQ(table.rowCount(), 6) << "one for each plane, by sphere or box; those that were not tested stand below";
    int outside = 0;
    for (int row = 0; row < int(planes.size()); ++row) outside += table.item(row, 1)->text().toDouble() < 0.0 ? 1 : 0;
    EXPECT_GT(outside, 0) << "the rejecting plane is among those tested";
    EXPECT_EQ(reader.pickedState(), TriangleState::OutsideFrustum);
}

TEST(PlaneTable, headingOfItsBarsIsWholeOrLeftOut) {
    QWidget window;
    window.resize(900, 100);
    PlaneTable table(&window);
    table.setSteps({}, {{FrustumPlane::Left, -1.0, 0.5, Containment::Outside}});
    table.resize(600, 100);
    window.show();
    QApplication::processEvents();
    EXPECT_EQ(table.horizontalHeaderItem(3)->text(), QStringLiteral("Outside | inside"));
    table.resize(600 - table.columnWidth(3) + 40, 100);
    QApplication::processEvents();
    EXPECT_LT(table.columnWidth(3), 60);
    EXPECT_TRUE(table.horizontalHeaderItem(3)->text().isEmpty()) << "so few pixels hold no heading";
}

TEST_F(StructurePanelTest, allHasNoBoxesAndNoTree) {
    session.slot(1).choose("all");
    settle();
    EXPECT_EQ(panel.tree().model().rowCount(), 0);
    EXPECT_TRUE(panel.tree().view().isHidden());
    session.slot(1).choose("frustum");
    settle();
    EXPECT_FALSE(panel.tree().view().isHidden());
}

TEST_F(StructurePanelTest, readingsFollowTheViewAndAreNeverStale) {
    int stale = 0;
    QObject::connect(&reader, &SnapshotReader::changed, [&] {
        if (!reader.reading()) return;
        const bool present = reader.reading()->culling == session.camera();
        if (reader.fresh() && !present) ++stale;
    });
    const size_t begun = reader.begun();
    QElapsedTimer time;
    time.start();
    int moves = 0;
    for (; time.elapsed() < 600; ++moves) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(0.5), {}));
        QTest::qWait(1);
    }
    ASSERT_TRUE(waitUntil([&] { return reader.fresh(); }));
    EXPECT_EQ(stale, 0);
    EXPECT_LE(reader.begun() - begun, size_t(time.elapsed() / 100 + 2)) << "more often than ten times a second";
    EXPECT_EQ(reader.reading()->culling, session.camera());
}

TEST_F(StructurePanelTest, nothingIsReadWhileNobodyLooks) {
    panel.hide();
    const size_t begun = reader.begun();
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    ASSERT_TRUE(waitUntil([&] { return session.metricsSettled(); }));
    EXPECT_EQ(reader.begun(), begun);
    EXPECT_FALSE(reader.fresh());
    panel.show();
    EXPECT_TRUE(waitUntil([&] { return reader.fresh(); }));
}

TEST_F(StructurePanelTest, observersShowTheInsideOfWhatTheyWatch) {
    session.observe(0, 1);
    session.setActiveView(0);
    settle();
    EXPECT_EQ(reader.reading()->strategy, session.slot(1).built());
    EXPECT_EQ(reader.reading()->culling, session.cullingCamera(1));
}

TEST_F(StructurePanelTest, noLossIsSaidWithItsUpperBound) {
    const Accuracy& accuracy = session.figures(1).accuracy;
    ASSERT_EQ(accuracy.missedPixels, 0U);
    EXPECT_EQ(panel.losses().model().rowCount(), 0);
    EXPECT_TRUE(panel.losses().summary().startsWith(QStringLiteral("0 of "))) << panel.losses().summary().toStdString();
    EXPECT_TRUE(panel.losses().summary().contains(QStringLiteral("3 in ")));
}

TEST_F(StructurePanelTest, theSectorOfTheShownBandsIsMarkedOnTheMap) {
    session.slot(1).choose("spherical");
    openAndWait(session, QStringLiteral("star:seed=3,triangles=2000"));
    Camera camera = session.camera();
    camera.eye = camera.target + 2.0 * (camera.eye - camera.target);
    session.setCamera(camera);
    settle();
    ASSERT_EQ(panel.curves().size(), 1U);
    CurvePanel& bands = *panel.curves().front();
    ASSERT_FALSE(bands.plot().empty());
    const auto marked = [&] { return panel.map().map().contents().part; };
    EXPECT_FALSE(marked()) << "without the chart it means nothing";
    panel.tabs().setCurrentWidget(&bands);
    ASSERT_TRUE(marked());
    EXPECT_EQ(marked(), bands.shownPart());
    bands.part().setValue(2);
    EXPECT_EQ(marked(), 2U);
    bands.part().setValue(0);
    EXPECT_FALSE(marked());
}

TEST_F(StructurePanelTest, curvesHaveTabsWhileTheirStrategyIsShown) {
    EXPECT_TRUE(panel.curves().empty());
    const int tabs = panel.tabs().count();
    session.slot(1).choose("spherical");
    ASSERT_EQ(panel.curves().size(), 1U);
    EXPECT_EQ(panel.tabs().count(), tabs + 1);
    CurvePanel* bands = panel.curves().front();
    EXPECT_EQ(panel.tabs().tabText(panel.tabs().indexOf(bands)), QStringLiteral("Bands"));
    panel.tabs().setCurrentWidget(bands);
    session.slot(1).choose("spherical-horizon");
    EXPECT_EQ(panel.tabs().currentWidget(), bands) << "it has bands too";
    session.slot(1).choose("frustum");
    EXPECT_EQ(panel.tabs().count(), tabs);
    EXPECT_EQ(panel.tabs().currentWidget(), &panel.tree());
    session.slot(1).choose("spherical");
    EXPECT_EQ(panel.tabs().currentWidget(), bands) << "its tab was open when its strategy left";
    settle();
}

TEST(LossModel, objectsHaveNamesPixelsAndShares) {
    LossModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    const ScenePointer scene = openScene(kField).scene;
    model.setObjects(scene, {{4, 150}, {1, 50}}, 200);
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_EQ(model.index(0, LossModel::Name).data().toString().toStdString(), scene->instances()[4].name);
    EXPECT_EQ(model.index(0, LossModel::Pixels).data().toString(), QStringLiteral("150"));
    EXPECT_EQ(model.index(1, LossModel::Share).data().toString(), QStringLiteral("25 %"));
    EXPECT_EQ(model.instanceAt(1), 1U);
    model.setObjects(nullptr, {}, 0);
    EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace cullscope::ui::structure_panel_test
