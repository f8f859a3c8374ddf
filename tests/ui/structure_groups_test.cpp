// Groups of objects in the tree of boxes.

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "tests/ui/test_scene.h"
#include "ui/models/structure_model.h"
#include "ui/panels/long_list_view.h"

namespace cullscope::ui::structure_groups_test {
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

/// A snapshot of objects 0 … 15 in four groups of four below one root; the last group is culled. Objects come first, as a
/// strategy lists them.
std::shared_ptr<StructureSnapshot> groupedSnapshot() {
    auto snapshot = std::make_shared<StructureSnapshot>();
    for (uint32_t i = 0; i < 16; ++i) snapshot->nodes.push_back(node(int32_t(17 + i / 4), i, i >= 12));
    for (int32_t group = 0; group < 5; ++group) {
        snapshot->nodes.push_back(node(group == 0 ? -1 : 16, SnapshotNode::kGroup, group == 4));
        snapshot->nodes.back().objects = group == 0 ? 16 : 4;
    }
    return snapshot;
}

TEST(StructureModel, keptGroupSaysWhatBecameOfItsLeaves) {
    const ScenePointer scene = openScene(kField).scene;
    StructureModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    const auto verdict = [&](auto change) {
        auto snapshot = std::make_shared<StructureSnapshot>(*groupedSnapshot());
        for (SnapshotNode& node : snapshot->nodes) {
            node.culled = false;
            if (node.parent >= 0) change(node);
        }
        model.setSnapshot(scene, snapshot);
        const QModelIndex root = model.index(0, 0).siblingAtColumn(StructureModel::Verdict);
        return root.data().toString().toStdString();
    };
    EXPECT_EQ(verdict([](SnapshotNode&) {}), "kept");
    EXPECT_EQ(verdict([](SnapshotNode& node) {
                  node.culled = true;
                  node.cause = Cause::TooSmall;
              }),
              "all too small");
    EXPECT_EQ(verdict([](SnapshotNode& node) {
                  node.culled = true;
                  node.cause = !node.isGroup() && node.instance % 2 == 0 ? Cause::TooSmall : Cause::OutsideFrustum;
              }),
              "all left out");
    EXPECT_EQ(verdict([](SnapshotNode& node) { node.culled = !node.isGroup() && node.instance == 3; }), "partly kept");
}

TEST(StructureModel, groupStandsForNoObjectAndHasAVerdict) {
    const ScenePointer scene = openScene(kField).scene;
    StructureModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    model.setSnapshot(scene, groupedSnapshot());
    ASSERT_TRUE(model.nested());
    const QModelIndex root = model.index(0, 0);
    EXPECT_EQ(root.data().toString(), QStringLiteral("16 objects"));
    ASSERT_EQ(model.rowCount(root), 4);
    const QModelIndex culled = model.index(3, 0, root);
    EXPECT_EQ(culled.data().toString(), QStringLiteral("4 objects"));
    EXPECT_EQ(culled.siblingAtColumn(StructureModel::Verdict).data().toString(), QStringLiteral("outside the frustum"));
    EXPECT_EQ(culled.siblingAtColumn(StructureModel::Plane).data().toString(), QStringLiteral("top plane"));
    EXPECT_EQ(root.siblingAtColumn(StructureModel::Verdict).data().toString(), QStringLiteral("partly kept"));
    EXPECT_FALSE(model.instanceAt(root) || model.instanceAt(culled));
    for (uint32_t i = 0; i < 16; ++i) {
        const QModelIndex index = model.indexOfInstance(i);
        ASSERT_TRUE(index.isValid());
        EXPECT_EQ(model.instanceAt(index), i);
        EXPECT_EQ(model.parent(index), model.index(int(i / 4), 0, root));
    }
    auto alone = std::make_shared<StructureSnapshot>();
    alone->nodes = {node(1, 5), node(-1, SnapshotNode::kGroup)};
    model.setSnapshot(scene, alone);
    EXPECT_EQ(model.index(0, 0).data().toString(), QStringLiteral("1 object"));
    alone = std::make_shared<StructureSnapshot>();
    alone->nodes = {node(-1, SnapshotNode::kGroup)};
    model.setSnapshot(scene, alone);
    EXPECT_FALSE(model.instanceAt(model.index(0, 0))) << "a group stays one without rows below it";
}

TEST(StructureModel, planesAreNamedOnlyOfWhatTheFrustumRejected) {
    const ScenePointer scene = openScene(kField).scene;
    const auto words = [&](Cause cause) {
        auto snapshot = groupedSnapshot();
        for (SnapshotNode& node : snapshot->nodes) {
            node.cause = cause;
            node.rejectedBy.reset();
        }
        StructureModel model;
        model.setSnapshot(scene, snapshot);
        const QModelIndex culled = model.index(3, 0, model.index(0, 0));
        const QString plane = culled.siblingAtColumn(StructureModel::Plane).data().toString();
        EXPECT_EQ(model.namesPlanes(), !plane.isEmpty());
        return plane;
    };
    EXPECT_EQ(words(Cause::OutsideFrustum), QStringLiteral("no single plane")) << "an axis parts it from the frustum";
    for (const Cause cause : {Cause::Hidden, Cause::TooSmall, Cause::NoSample}) EXPECT_EQ(words(cause), QString());
    StructureModel rejected;
    rejected.setSnapshot(scene, groupedSnapshot());
    EXPECT_TRUE(rejected.namesPlanes()) << "the top plane";
}

TEST(ObjectVerdicts, objectsHaveTheirOwnVerdictAndNotTheirGroups) {
    const ScenePointer scene = openScene(kField).scene;
    auto reading = std::make_shared<SnapshotReading>();
    const std::shared_ptr<StructureSnapshot> snapshot = groupedSnapshot();
    snapshot->nodes[1].culled = true;
    reading->snapshot = snapshot;
    ObjectVerdicts verdicts;
    verdicts.set(scene, nullptr, reading);
    for (uint32_t i = 0; i < 16; ++i) {
        ASSERT_TRUE(verdicts.of(i));
        EXPECT_EQ(verdicts.of(i)->state, i == 1 || i >= 12 ? TriangleState::OutsideFrustum : TriangleState::Visible) << i;
    }
}

TEST(LongListView, levelsOfATreeAreOpenAsFarAsTheRowsAllow) {
    const ScenePointer scene = openScene(kField).scene;
    StructureModel model;
    model.setSnapshot(scene, groupedSnapshot());
    LongListView view;
    view.setModel(&model);
    const QModelIndex root = model.index(0, 0), group = model.index(3, 0, root);
    view.expandFirstLevels(20);
    EXPECT_TRUE(view.isExpanded(root));
    EXPECT_FALSE(view.isExpanded(group)) << "with them there are 21 rows";
    view.scrollTo(model.indexOfInstance(13));
    EXPECT_TRUE(view.isExpanded(group)) << "what is picked is not seen";
    EXPECT_FALSE(view.isExpanded(model.index(0, 0, root)));
    view.collapseAll();
    view.expandFirstLevels(21);
    EXPECT_TRUE(view.isExpanded(root) && view.isExpanded(group) && view.isExpanded(model.index(0, 0, root)));
}

}  // namespace
}  // namespace cullscope::ui::structure_groups_test
