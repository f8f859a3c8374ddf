#pragma once

#include <QAbstractItemModel>
#include <QIcon>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/visibility/structure_snapshot.h"
#include "ui/jobs/object_verdicts.h"

namespace cullscope::ui {

/// The boxes that a strategy tests, as the tree of their parents, with the decision on each box. A new snapshot with the same
/// boxes changes only the verdicts, so that expanded and selected rows stay.
class StructureModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Name, Triangles, Verdict, Plane, ColumnCount };

    explicit StructureModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    /// Sets the boxes; null: the model has no rows. `snapshot` numbers instances as `scene` does. A parent may come after its
    /// children in the list; no node may be its own ancestor.
    void setSnapshot(const ScenePointer& scene, const std::shared_ptr<const StructureSnapshot>& snapshot);
    /// Sets the states against the truth; null: only the strategy's decisions are shown.
    void setStates(const std::shared_ptr<const TriangleStates>& states);
    [[nodiscard]] bool empty() const { return !m_snapshot || m_snapshot->nodes.empty(); }

    /// Whether any box has child boxes.
    [[nodiscard]] bool nested() const { return !empty() && size_t(rowCount()) < m_snapshot->nodes.size(); }
    /// Whether any box has words in the column of planes.
    [[nodiscard]] bool namesPlanes() const;

    /// The node of a row, as an index into StructureSnapshot::nodes.
    [[nodiscard]] size_t nodeOf(const QModelIndex& index) const { return size_t(index.internalId()); }
    /// The row of the group with a number in the structure (SnapshotNode::number); invalid: there is none.
    [[nodiscard]] QModelIndex indexOfGroup(uint32_t number) const;
    /// The instance of a row; none for a box with child boxes or a group.
    [[nodiscard]] std::optional<uint32_t> instanceAt(const QModelIndex& index) const;
    /// The number of a row's group in the structure; none: the row is no group.
    [[nodiscard]] std::optional<uint32_t> groupAt(const QModelIndex& index) const;
    /// The row of the first leaf of an instance; invalid: it has none.
    [[nodiscard]] QModelIndex indexOfInstance(uint32_t instance) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    using QObject::parent;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    [[nodiscard]] size_t childCount(size_t place) const { return m_firstChild[place + 1] - m_firstChild[place]; }
    /// Whether the node is a group or has children, and so represents no single object.
    [[nodiscard]] bool holdsOthers(size_t node) const;
    [[nodiscard]] QModelIndex indexOfNode(size_t node) const;
    /// The state of a box that was kept and holds one object; none: not known.
    [[nodiscard]] std::optional<TriangleState> stateAgainstTruth(const SnapshotNode& node, size_t number) const;
    /// What became of the boxes below one that was kept and that have no others below them.
    struct Below {
        uint32_t boxes = 0, leftOut = 0;
        uint32_t causes = 0;  ///< of those left out, as bits
    };
    void countBelow();
    /// The cause by which everything below a kept box was left out; none: not everything was, or by several causes.
    [[nodiscard]] std::optional<Cause> causeOfAll(size_t node) const;
    [[nodiscard]] QString keptText(size_t node) const;
    [[nodiscard]] QIcon verdictIconOf(size_t node) const;
    /// What a group with a name is called.
    [[nodiscard]] QString namedText(const SnapshotNode& node) const;
    [[nodiscard]] QString text(const SnapshotNode& node, size_t number, int column) const;
    void layOut();
    void tellOfData();

    ScenePointer m_scene;
    std::shared_ptr<const StructureSnapshot> m_snapshot;
    std::shared_ptr<const TriangleStates> m_states;
    ObjectVerdicts m_verdicts;
    // Child lists, one after the other: that of the roots first, then those of nodes 0, 1, …
    std::vector<uint32_t> m_firstChild;
    std::vector<uint32_t> m_children;
    std::vector<uint32_t> m_rowOfNode;
    std::vector<Below> m_below;             ///< by node
    std::vector<int64_t> m_nodeOfInstance;  ///< by instance: its first leaf; -1: none
};

}  // namespace cullscope::ui
