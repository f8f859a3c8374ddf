#include "ui/panels/outliner.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <fstream>

#include "core/scene/hidden.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/scene_panel.h"
#include "ui/panels/split_dialog.h"

namespace cullscope::ui::outliner_test {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

/// A scene of five named objects with two meshes.
ScenePointer namedScene() {
    const MeshPointer small = openScene("sphere:triangles=80").scene->meshes().front();
    const MeshPointer large = openScene("torus:triangles=400").scene->meshes().front();
    std::vector<Instance> instances;
    for (const char* name : {"Sphere 1", "torus b", "torus a", "SPHERE 2", "knot"})
        instances.push_back({name[0] == 't' ? 1U : 0U, Mat4(1.0), name});
    return std::make_shared<Scene>("named", std::vector<MeshPointer>{small, large}, instances);
}

QStringList names(const ObjectModel& model) {
    QStringList names;
    for (int row = 0; row < model.rowCount(); ++row) names << model.index(row, ObjectModel::Name).data().toString();
    return names;
}

TEST(ObjectModel, filtersAndSortsAsAnItemModelMay) {
    ObjectModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    model.setScene(namedScene());
    EXPECT_EQ(model.rowCount(), 5);
    const QPersistentModelIndex knot = model.index(4, ObjectModel::Name);
    model.sort(ObjectModel::Name, Qt::AscendingOrder);
    EXPECT_EQ(names(model), (QStringList{"SPHERE 2", "Sphere 1", "knot", "torus a", "torus b"}));
    EXPECT_EQ(knot.data().toString(), QStringLiteral("knot")) << "a selection went to another object";
    model.sort(ObjectModel::Triangles, Qt::DescendingOrder);
    EXPECT_TRUE(model.index(0, ObjectModel::Name).data().toString().startsWith(QStringLiteral("torus")));
    model.setSearch(QStringLiteral("sPhErE"));
    EXPECT_EQ(names(model), (QStringList{"Sphere 1", "SPHERE 2"}));
    EXPECT_EQ(model.rowOf(4), -1);
    EXPECT_EQ(model.objectAt(1), 3U);
    model.setSearch({});
    model.sort(-1, Qt::AscendingOrder);
    EXPECT_EQ(model.objectAt(1), 1U);
    model.setScene(nullptr);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(ObjectModel, verdictsStayWithTheirObjectsWhenOthersAreHidden) {
    ObjectModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    const ScenePointer scene = namedScene();
    model.setScene(scene);
    const std::vector<bool> hidden{true, false, false, false, false};
    model.setHidden(hidden);
    const ScenePointer shown = withoutInstances(scene, hidden);
    auto states = std::make_shared<TriangleStates>();
    states->againstTruth = true;
    states->states.assign(shown->triangleCount(), TriangleState::OutsideFrustum);
    states->states[shown->firstTriangle(0) + 3] = TriangleState::WronglyCulled;  // of object 1
    states->states[shown->firstTriangle(3)] = TriangleState::InVain;             // of object 4
    model.setVerdicts(shown, states, nullptr);
    const auto word = [&](int row) { return model.index(row, ObjectModel::Verdict).data(Qt::ToolTipRole).toString(); };
    EXPECT_EQ(word(0), QStringLiteral("not shown"));
    EXPECT_EQ(word(1), QStringLiteral("wrongly culled"));
    EXPECT_EQ(word(2), QStringLiteral("outside the frustum"));
    EXPECT_EQ(word(4), QStringLiteral("drawn in vain"));
    model.setHidden(std::vector<bool>(5, false));
    EXPECT_EQ(word(1), QStringLiteral("verdict not known yet")) << "of another numbering";
}

struct OutlinerTest : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=3"));
        outliner.resize(280, 400);
        outliner.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&outliner, kPatience));
        ASSERT_EQ(outliner.model().rowCount(), int(session.hidden().size()));
        ASSERT_GT(outliner.model().rowCount(), 4);
    }

    void selectRows(int first, int last) {
        const QItemSelection rows(outliner.model().index(first, 0), outliner.model().index(last, ObjectModel::ColumnCount - 1));
        outliner.view().selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    }
    [[nodiscard]] ptrdiff_t hiddenCount() const { return std::count(session.hidden().begin(), session.hidden().end(), true); }
    QPoint eyeOf(int row) { return outliner.view().visualRect(outliner.model().index(row, ObjectModel::Eye)).center(); }

    Session session{sessionOptions(false)};
    Outliner outliner{session};
};

TEST_F(OutlinerTest, hidesIsolatesAndShowsSelectedObjects) {
    selectRows(1, 2);
    outliner.hideSelected();
    EXPECT_EQ(hiddenCount(), 2);
    EXPECT_TRUE(session.hidden()[1] && session.hidden()[2]);
    EXPECT_EQ(outliner.selected(), (std::vector<uint32_t>{1, 2})) << "hiding lost the selection";
    outliner.showSelected();
    EXPECT_EQ(hiddenCount(), 0);
    outliner.isolateSelected();
    EXPECT_EQ(hiddenCount(), ptrdiff_t(session.hidden().size()) - 2);
    EXPECT_FALSE(session.hidden()[1]);
    outliner.showAll();
    EXPECT_EQ(hiddenCount(), 0);
}

TEST_F(OutlinerTest, theEyeSpaceAndDeleteHideObjects) {
    QTest::mouseClick(outliner.view().viewport(), Qt::LeftButton, {}, eyeOf(3));
    EXPECT_TRUE(session.hidden()[3]);
    QTest::mouseClick(outliner.view().viewport(), Qt::LeftButton, {}, eyeOf(3));
    EXPECT_FALSE(session.hidden()[3]);
    selectRows(0, 1);
    QTest::keyClick(&outliner.view(), Qt::Key_Space);
    EXPECT_TRUE(session.hidden()[0] && session.hidden()[1]);
    QTest::keyClick(&outliner.view(), Qt::Key_Space);
    EXPECT_EQ(hiddenCount(), 0);
    QTest::keyClick(&outliner.view(), Qt::Key_Delete);
    QTest::keyClick(&outliner.view(), Qt::Key_Delete);
    EXPECT_EQ(hiddenCount(), 2);
}

TEST_F(OutlinerTest, searchFiltersAndEscapeClearsIt) {
    selectRows(2, 2);
    const QString name = outliner.model().index(2, ObjectModel::Name).data().toString();
    QTest::keyClicks(&outliner.search(), name.toUpper());
    EXPECT_LT(outliner.model().rowCount(), int(session.hidden().size()));
    EXPECT_EQ(outliner.selected(), std::vector<uint32_t>{2});
    QTest::keyClick(&outliner.search(), Qt::Key_Escape);
    EXPECT_TRUE(outliner.search().text().isEmpty());
    EXPECT_EQ(outliner.model().rowCount(), int(session.hidden().size()));
    EXPECT_EQ(outliner.selected(), std::vector<uint32_t>{2});
}

TEST_F(OutlinerTest, pickAndSelectionAreOne) {
    const Scene& scene = *session.opened()->scene;
    session.setPick(Pick{4, scene.firstTriangle(4) + 7, Vec3(0.0)});
    EXPECT_EQ(outliner.selected(), std::vector<uint32_t>{4});
    EXPECT_EQ(session.pick()->triangle, scene.firstTriangle(4) + 7) << "the list picked another triangle";
    QTest::mouseClick(outliner.view().viewport(), Qt::LeftButton, {},
                      outliner.view().visualRect(outliner.model().index(1, ObjectModel::Name)).center());
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->object, 1U);
    EXPECT_EQ(session.pick()->triangle, scene.firstTriangle(1));
    session.setPick(std::nullopt);
    EXPECT_TRUE(outliner.selected().empty());
}

TEST_F(OutlinerTest, allObjectsCanBeSelectedAndASearchWithoutHitsSelectsNone) {
    outliner.view().selectAll();
    const size_t all = outliner.selected().size();
    EXPECT_EQ(all, session.hidden().size());
    outliner.search().setText(QStringLiteral("no such name"));
    EXPECT_TRUE(outliner.selected().empty());
    EXPECT_EQ(outliner.model().rowCount(), 0);
}

TEST(ScenePanel, splitIsOfferedForOneObjectOnly) {
    Session session(sessionOptions(false));
    ScenePanel panel(session);
    openAndWait(session, QStringLiteral("sphere:triangles=1280"));
    EXPECT_FALSE(panel.splitButton().isHidden());
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=2"));
    EXPECT_TRUE(panel.splitButton().isHidden());
}

TEST(ScenePanel, saysHowItIsKnownWhatIsUpAndLetsItBeChanged) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("flat.obj"));
    std::ofstream(file.toStdString()) << "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    Session session(sessionOptions(false));
    ScenePanel panel(session);
    EXPECT_TRUE(panel.upAxis().isHidden()) << "nothing is open";
    openAndWait(session, file);
    EXPECT_EQ(panel.upAxis().currentText(), QStringLiteral("z"));
    EXPECT_EQ(panel.upSource().text(), QStringLiteral("guessed from its shape"));
    EXPECT_EQ(session.camera().up, Vec3(0, 0, 1)) << "opens standing";

    const ScenePointer scene = session.scene();
    panel.upAxis().setCurrentIndex(0);
    emit panel.upAxis().activated(0);
    EXPECT_EQ(session.camera().up, Vec3(0, 1, 0));
    EXPECT_EQ(session.scene(), scene) << "nothing is loaded again";
    EXPECT_EQ(panel.upSource().text(), QStringLiteral("chosen"));
    session.setUpAxis(UpAxis::Z);
    EXPECT_EQ(panel.upAxis().currentText(), QStringLiteral("z")) << "changed elsewhere";

    openAndWait(session, QStringLiteral("plant:pipelines=1"));
    EXPECT_EQ(panel.upSource().text(), QStringLiteral("as the scene says"));
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    EXPECT_EQ(panel.upAxis().currentText(), QStringLiteral("y"));
    EXPECT_EQ(panel.upSource().text(), QString());
}

TEST(SplitDialog, specificationsOpenWhatTheySay) {
    for (const char* mesh : {"sphere:triangles=1280", "sphere", "mesh:sphere:triangles=1280"}) {
        const OpenedScene whole = openScene(mesh);
        SplitDialog dialog(QString::fromLatin1(mesh), whole.scene->triangleCount());
        dialog.clusters().setChecked(true);
        dialog.triangles().setValue(100);
        const OpenedScene clusters = openScene(dialog.specification().toStdString());
        EXPECT_EQ(clusters.scene->triangleCount(), whole.scene->triangleCount()) << dialog.specification().toStdString();
        EXPECT_GT(clusters.scene->instances().size(), whole.scene->triangleCount() / 100);
        for (const MeshPointer& part : clusters.scene->meshes()) EXPECT_LE(part->triangleCount(), 100U);
        dialog.components().setChecked(true);
        const OpenedScene components = openScene(dialog.specification().toStdString());
        EXPECT_EQ(components.scene->instances().size(), 1U);
        EXPECT_EQ(components.scene->triangleCount(), whole.scene->triangleCount());
    }
}

}  // namespace
}  // namespace cullscope::ui::outliner_test
