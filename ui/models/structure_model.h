#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/visibility/structure_snapshot.h"
#include "ui/jobs/object_verdicts.h"

namespace cullscope::ui {

/// The boxes that a strategy tests, as the tree that their parents make, with what was decided about each. A new reading of the
/// same boxes changes the verdicts only, so that what is opened and selected stays.
class StructureModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Name, Triangles, Verdict, Plane, ColumnCount };

    explicit StructureModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    /// `inside` numbers the instances of `scene`. A parent may come after its children; none may be its own ancestor.
    /// Null: no rows.
    void setSnapshot(const ScenePointer& scene, const std::shared_ptr<const StructureSnapshot>& snapshot);
    /// What became of the objects, against the truth; null: only what the strategy decided is known.
    void setStates(const std::shared_ptr<const TriangleStates>& states);
    [[nodiscard]] bool empty() const { return !m_snapshot || m_snapshot->nodes.empty(); }

    /// Whether any box holds others.
    [[nodiscard]] bool nested() const { return !empty() && size_t(rowCount()) < m_snapshot->nodes.size(); }

    /// Index into StructureSnapshot::nodes.
    [[nodiscard]] size_t nodeOf(const QModelIndex& index) const { return size_t(index.internalId()); }
    /// The instance of the scene; none for a box that holds other boxes.
    [[nodiscard]] std::optional<uint32_t> instanceAt(const QModelIndex& index) const;
    /// The first leaf of an instance; invalid: it has none.
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
    /// Stands for no single object.
    [[nodiscard]] bool holdsOthers(size_t node) const;
    [[nodiscard]] QModelIndex indexOfNode(size_t node) const;
    /// Of a box of one object that was kept; none: not known.
    [[nodiscard]] std::optional<TriangleState> stateAgainstTruth(const SnapshotNode& node, size_t number) const;
    [[nodiscard]] QString text(const SnapshotNode& node, size_t number, int column) const;
    void layOut();
    void tellOfData();

    ScenePointer m_scene;
    std::shared_ptr<const StructureSnapshot> m_snapshot;
    std::shared_ptr<const TriangleStates> m_states;
    ObjectVerdicts m_verdicts;
    // Children lists, one after the other: those of no parent first, then those of node 0, 1, …
    std::vector<uint32_t> m_firstChild;
    std::vector<uint32_t> m_children;
    std::vector<uint32_t> m_rowOfNode;
    std::vector<int64_t> m_nodeOfInstance;  ///< -1: none
};

}  // namespace cullscope::ui
