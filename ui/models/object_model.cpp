#include "ui/models/object_model.h"

#include <QLocale>
#include <algorithm>
#include <numeric>

#include "ui/look/tinted_icon.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

void ObjectModel::setScene(const ScenePointer& opened) {
    beginResetModel();
    m_opened = opened;
    m_hidden.assign(opened ? opened->instances().size() : 0, false);
    m_instance.resize(m_hidden.size());
    std::iota(m_instance.begin(), m_instance.end(), 0U);
    m_verdictsFit = false;
    findRows();
    endResetModel();
}

void ObjectModel::setHidden(const std::vector<bool>& hidden) {
    if (hidden.size() != m_hidden.size() || hidden == m_hidden) return;
    m_hidden = hidden;
    m_verdictsFit = false;
    uint32_t instance = 0;
    for (size_t object = 0; object < m_hidden.size(); ++object) m_instance[object] = m_hidden[object] ? 0 : instance++;
    tellOfData();
}

void ObjectModel::setVerdicts(const ScenePointer& shown, const std::shared_ptr<const TriangleStates>& states,
                              const SnapshotReadingPointer& reading) {
    const auto visible = size_t(std::count(m_hidden.begin(), m_hidden.end(), false));
    m_verdictsFit = shown && shown->instances().size() == visible;
    m_verdicts.set(shown, states, reading);
    tellOfData();
}

void ObjectModel::setSearch(const QString& text) {
    if (text == m_search) return;
    beginResetModel();
    m_search = text;
    findRows();
    endResetModel();
}

void ObjectModel::findRows() {
    m_rows.clear();
    for (uint32_t object = 0; object < m_hidden.size(); ++object)
        if (m_search.isEmpty() ||
            QString::fromStdString(m_opened->instances()[object].name).contains(m_search, Qt::CaseInsensitive))
            m_rows.push_back(object);
    if (m_sortedBy >= 0) std::stable_sort(m_rows.begin(), m_rows.end(), [this](uint32_t a, uint32_t b) { return less(a, b); });
}

int ObjectModel::rowOf(uint32_t object) const {
    const auto place = std::find(m_rows.begin(), m_rows.end(), object);
    return place == m_rows.end() ? -1 : int(place - m_rows.begin());
}

int ObjectModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

double ObjectModel::extent(uint32_t object) const { return m_opened->instanceBox(object).diagonal(); }

std::optional<ObjectVerdicts::Verdict> ObjectModel::verdict(uint32_t object) const {
    if (!m_verdictsFit || m_hidden[object]) return std::nullopt;
    return m_verdicts.of(m_instance[object]);
}

QString ObjectModel::verdictWord(uint32_t object) const {
    if (m_hidden[object]) return tr("not shown");
    const std::optional<ObjectVerdicts::Verdict> verdict = this->verdict(object);
    if (!verdict) return tr("verdict not known yet");
    if (!verdict->againstTruth && verdict->state == TriangleState::Visible) return tr("submitted");
    return translated(triangleStateName(verdict->state));
}

QString ObjectModel::text(uint32_t object, int column) const {
    switch (column) {
        case Name:
            return QString::fromStdString(m_opened->instances()[object].name);
        case Triangles:
            return countText(m_opened->meshOf(object).triangleCount());
        case Size:
            return m_opened->instanceBox(object).empty() ? QStringLiteral("0") : QLocale().toString(extent(object), 'g', 3);
        default:
            return {};
    }
}

QVariant ObjectModel::decoration(uint32_t object, int column) const {
    if (column == Eye) return tintedIcon(m_hidden[object] ? QStringLiteral("eye-closed") : QStringLiteral("eye"));
    const std::optional<ObjectVerdicts::Verdict> verdict = column == Verdict ? this->verdict(object) : std::nullopt;
    return verdict ? QVariant(verdictIcon(verdict->state)) : QVariant();
}

QVariant ObjectModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    const uint32_t object = objectAt(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return text(object, index.column());
        case Qt::DecorationRole:
            return decoration(object, index.column());
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            if (index.column() == Eye) return m_hidden[object] ? tr("not shown") : tr("shown");
            return index.column() == Verdict ? verdictWord(object) : text(object, index.column());
        case Qt::TextAlignmentRole:
            if (index.column() == Triangles || index.column() == Size) return int(Qt::AlignRight | Qt::AlignVCenter);
            return {};
        default:
            return {};
    }
}

QVariant ObjectModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const bool spoken = role == Qt::ToolTipRole || role == Qt::AccessibleTextRole;
    if (role != Qt::DisplayRole && !spoken) return {};
    switch (section) {
        case Eye:
            return spoken ? tr("Whether it is shown") : QString();
        case Name:
            return tr("Object");
        case Triangles:
            return tr("Triangles");
        case Verdict:
            return spoken ? tr("Verdict") : QString();
        case Size:
            return spoken ? tr("Diagonal of its box, scene units") : tr("Size");
        default:
            return {};
    }
}

bool ObjectModel::less(uint32_t a, uint32_t b) const {
    const bool down = m_order == Qt::DescendingOrder;
    if (down) std::swap(a, b);
    switch (m_sortedBy) {
        case Eye:
            return m_hidden[a] < m_hidden[b];
        case Name:
            return m_opened->instances()[a].name < m_opened->instances()[b].name;
        case Triangles:
            return m_opened->meshOf(a).triangleCount() < m_opened->meshOf(b).triangleCount();
        case Verdict: {
            const auto rank = [this](uint32_t object) {
                const std::optional<ObjectVerdicts::Verdict> verdict = this->verdict(object);
                return verdict ? int(verdict->state) : int(kTriangleStateCount);
            };
            return rank(a) < rank(b);
        }
        default:
            return extent(a) < extent(b);
    }
}

void ObjectModel::sort(int column, Qt::SortOrder order) {
    m_sortedBy = column;
    m_order = order;
    emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::vector<uint32_t> objects;
    for (const QModelIndex& index : before) objects.push_back(objectAt(index.row()));
    findRows();
    std::vector<int> rowOfObject(m_hidden.size(), -1);
    for (size_t row = 0; row < m_rows.size(); ++row) rowOfObject[m_rows[row]] = int(row);
    QModelIndexList after;
    for (int i = 0; i < before.size(); ++i) after << index(rowOfObject[objects[size_t(i)]], before[i].column());
    changePersistentIndexList(before, after);
    emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

void ObjectModel::tellOfData() {
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void ObjectModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    tellOfData();
}

}  // namespace cullscope::ui
