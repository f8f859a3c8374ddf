#include "ui/models/structure_model.h"

#include <algorithm>
#include <bit>

#include "core/visibility/triangle_states.h"
#include "ui/look/plane_swatch.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// Index of a node's child list in m_firstChild; the list of the roots (-1) is the first.
size_t place(int64_t node) { return size_t(node + 1); }

bool sameBoxes(const StructureSnapshot& a, const StructureSnapshot& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const SnapshotNode& x, const SnapshotNode& y) {
                          return x.parent == y.parent && x.instance == y.instance && x.objects == y.objects && x.name == y.name;
                      });
}

/// A group that the planes and axes of the frustum rejected, not its size or what lies before it.
bool rejectedByFrustum(const SnapshotNode& node) { return node.isGroup() && node.culled && node.cause == Cause::OutsideFrustum; }

TriangleState stateOf(const SnapshotNode& node) {
    if (!node.reached) return TriangleState::Undecided;
    return node.culled ? stateOfCause(node.cause) : TriangleState::Visible;
}

}  // namespace

void StructureModel::setSnapshot(const ScenePointer& scene, const std::shared_ptr<const StructureSnapshot>& snapshot) {
    if (scene == m_scene && snapshot == m_snapshot) return;
    if (scene != m_scene) m_states = nullptr;
    if (snapshot && m_snapshot && scene == m_scene && sameBoxes(*snapshot, *m_snapshot)) {
        m_snapshot = snapshot;
        countBelow();
        tellOfData();
        return;
    }
    beginResetModel();
    m_scene = scene;
    m_snapshot = snapshot;
    layOut();
    endResetModel();
}

void StructureModel::setStates(const std::shared_ptr<const TriangleStates>& states) {
    if (states == m_states) return;
    m_states = states;
    m_verdicts.set(m_scene, states, nullptr);
    tellOfData();
}

std::optional<TriangleState> StructureModel::stateAgainstTruth(const SnapshotNode& node, size_t number) const {
    if (!m_states || !node.reached || node.culled || holdsOthers(number)) return std::nullopt;
    const std::optional<ObjectVerdicts::Verdict> verdict = m_verdicts.of(node.instance);
    return verdict ? std::optional(verdict->state) : std::nullopt;
}

void StructureModel::layOut() {
    const size_t count = m_snapshot ? m_snapshot->nodes.size() : 0;
    m_firstChild.assign(count + 2, 0);
    m_children.assign(count, 0);
    m_rowOfNode.assign(count, 0);
    m_nodeOfInstance.assign(m_scene ? m_scene->instances().size() : 0, -1);
    for (size_t node = 0; node < count; ++node) {
        uint32_t& number = m_firstChild[place(m_snapshot->nodes[node].parent) + 1];
        m_rowOfNode[node] = number++;
    }
    for (size_t i = 1; i < m_firstChild.size(); ++i) m_firstChild[i] += m_firstChild[i - 1];
    for (size_t node = 0; node < count; ++node)
        m_children[m_firstChild[place(m_snapshot->nodes[node].parent)] + m_rowOfNode[node]] = uint32_t(node);
    for (size_t node = count; node-- > 0;)
        if (!holdsOthers(node)) m_nodeOfInstance[m_snapshot->nodes[node].instance] = int64_t(node);
    countBelow();
}

void StructureModel::countBelow() {
    const size_t count = m_snapshot ? m_snapshot->nodes.size() : 0;
    m_below.assign(count, {});
    for (size_t node = 0; node < count; ++node) {
        if (childCount(place(int64_t(node))) > 0) continue;
        const SnapshotNode& last = m_snapshot->nodes[node];
        for (int32_t above = last.parent; above >= 0; above = m_snapshot->nodes[size_t(above)].parent) {
            Below& below = m_below[size_t(above)];
            ++below.boxes;
            if (!last.culled) continue;
            ++below.leftOut;
            below.causes |= 1U << unsigned(last.cause);
        }
    }
}

std::optional<Cause> StructureModel::causeOfAll(size_t node) const {
    const Below& below = m_below[node];
    if (below.boxes == 0 || below.leftOut < below.boxes || !std::has_single_bit(below.causes)) return std::nullopt;
    return Cause(std::countr_zero(below.causes));
}

QString StructureModel::keptText(size_t node) const {
    const Below& below = m_below[node];
    if (const std::optional<Cause> cause = causeOfAll(node))
        return tr("all %1", "a box whose parts were left out for one cause").arg(translated(causeName(*cause)));
    if (below.boxes > 0 && below.leftOut == below.boxes) return tr("all left out", "the parts of a box");
    if (below.leftOut > 0) return tr("partly kept", "a box that holds others");
    return tr("kept", "a box that holds others");
}

QIcon StructureModel::verdictIconOf(size_t node) const {
    const SnapshotNode& box = m_snapshot->nodes[node];
    const Below& below = m_below[node];
    if (!box.reached || box.culled || below.leftOut == 0) return verdictIcon(stateAgainstTruth(box, node).value_or(stateOf(box)));
    // Of several causes the first, as in their order.
    const TriangleState left = stateOfCause(Cause(std::countr_zero(below.causes)));
    return below.leftOut == below.boxes ? verdictIcon(left) : verdictIcon(TriangleState::Visible, left);
}

bool StructureModel::holdsOthers(size_t node) const {
    return m_snapshot->nodes[node].isGroup() || childCount(place(int64_t(node))) > 0;
}

bool StructureModel::namesPlanes() const {
    return m_snapshot && std::ranges::any_of(m_snapshot->nodes, [](const SnapshotNode& node) {
               return node.rejectedBy.has_value() || rejectedByFrustum(node);
           });
}

QModelIndex StructureModel::indexOfNode(size_t node) const { return createIndex(int(m_rowOfNode[node]), 0, quintptr(node)); }

std::optional<uint32_t> StructureModel::instanceAt(const QModelIndex& index) const {
    if (!index.isValid() || holdsOthers(nodeOf(index))) return std::nullopt;
    return m_snapshot->nodes[nodeOf(index)].instance;
}

std::optional<uint32_t> StructureModel::groupAt(const QModelIndex& index) const {
    if (!index.isValid() || !m_snapshot->nodes[nodeOf(index)].isGroup()) return std::nullopt;
    return m_snapshot->nodes[nodeOf(index)].number;
}

QModelIndex StructureModel::indexOfInstance(uint32_t instance) const {
    if (instance >= m_nodeOfInstance.size() || m_nodeOfInstance[instance] < 0) return {};
    return indexOfNode(size_t(m_nodeOfInstance[instance]));
}

QModelIndex StructureModel::indexOfGroup(uint32_t number) const {
    if (empty()) return {};
    const auto found = std::ranges::find_if(
        m_snapshot->nodes, [number](const SnapshotNode& node) { return node.isGroup() && node.number == number; });
    return found == m_snapshot->nodes.end() ? QModelIndex() : indexOfNode(size_t(found - m_snapshot->nodes.begin()));
}

QModelIndex StructureModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    const size_t list = place(parent.isValid() ? int64_t(nodeOf(parent)) : -1);
    return createIndex(row, column, quintptr(m_children[m_firstChild[list] + size_t(row)]));
}

QModelIndex StructureModel::parent(const QModelIndex& index) const {
    if (!index.isValid()) return {};
    const int32_t parent = m_snapshot->nodes[nodeOf(index)].parent;
    return parent < 0 ? QModelIndex() : indexOfNode(size_t(parent));
}

int StructureModel::rowCount(const QModelIndex& parent) const {
    if (empty() || parent.column() > 0) return 0;
    return int(childCount(place(parent.isValid() ? int64_t(nodeOf(parent)) : -1)));
}

int StructureModel::columnCount(const QModelIndex& /*parent*/) const { return ColumnCount; }

QString StructureModel::namedText(const SnapshotNode& node) const {
    const QString name = QString::fromStdString(node.name), objects = countText(node.objects);
    if (m_snapshot->groupName) return translated(m_snapshot->groupName).arg(name, objects);
    return tr("%1: %2 objects", "a group by its name").arg(name, objects);
}

QString StructureModel::text(const SnapshotNode& node, size_t number, int column) const {
    switch (column) {
        case Name:
            if (!node.name.empty()) return namedText(node);
            if (node.isGroup())
                return node.objects == 1 ? tr("1 object", "a group of one")
                                         : tr("%1 objects", "a group of so many").arg(countText(node.objects));
            if (holdsOthers(number)) return tr("Node %1", "of a tree of boxes").arg(number);
            return QString::fromStdString(m_scene->instances()[node.instance].name);
        case Triangles:
            return countText(node.triangles);
        case Verdict:
            if (!node.reached) return translated(triangleStateName(TriangleState::Undecided));
            if (node.culled) return translated(causeName(node.cause));
            if (const auto state = stateAgainstTruth(node, number)) return translated(triangleStateName(*state));
            return holdsOthers(number) ? keptText(number) : tr("submitted");
        case Plane:
            if (node.rejectedBy) return translated(planeName(*node.rejectedBy));
            return rejectedByFrustum(node) ? tr("no single plane", "has a group outside") : QString();
        default:
            return {};
    }
}

QVariant StructureModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const SnapshotNode& node = m_snapshot->nodes[nodeOf(index)];
    if (role == Qt::ToolTipRole && index.column() == Name)
        return tr("%1: %2 triangles", "an object or a group").arg(text(node, nodeOf(index), Name), countText(node.triangles));
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return text(node, nodeOf(index), index.column());
    if (role == Qt::DecorationRole && index.column() == Verdict) return verdictIconOf(nodeOf(index));
    if (role == Qt::DecorationRole && index.column() == Plane && node.rejectedBy) return planeIcon(*node.rejectedBy);
    if (role == Qt::TextAlignmentRole && index.column() == Triangles) return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
    switch (section) {
        case Name:
            return tr("Object");
        case Triangles:
            return tr("Triangles");
        case Verdict:
            return tr("Verdict");
        case Plane:
            return tr("Rejected by");
        default:
            return {};
    }
}

void StructureModel::tellOfData() {
    // One signal for the top level makes attached views repaint completely. Signals for the children of every node would make
    // them search for each of these rows.
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void StructureModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    tellOfData();
}

}  // namespace cullscope::ui
