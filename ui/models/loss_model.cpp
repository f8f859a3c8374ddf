#include "ui/models/loss_model.h"

#include "ui/text/wording.h"

namespace cullscope::ui {

void LossModel::setObjects(const ScenePointer& scene, const std::vector<LostObject>& objects, uint64_t missedPixels) {
    beginResetModel();
    m_scene = scene;
    m_objects = objects;
    m_missed = missedPixels;
    endResetModel();
}

int LossModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_objects.size()); }

QVariant LossModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    if (role == Qt::TextAlignmentRole && index.column() != Name) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const LostObject& object = m_objects[size_t(index.row())];
    switch (index.column()) {
        case Name:
            return QString::fromStdString(m_scene->instances()[object.instance].name);
        case Pixels:
            return countText(object.pixels);
        default:
            return percentText(double(object.pixels) / double(std::max<uint64_t>(1, m_missed))) + QStringLiteral(" %");
    }
}

QVariant LossModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
    switch (section) {
        case Name:
            return tr("Object");
        case Pixels:
            return tr("Pixels lost");
        default:
            return tr("Share", "of all lost pixels");
    }
}

void LossModel::retranslate() { emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1); }

}  // namespace cullscope::ui
