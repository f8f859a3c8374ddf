#include "ui/models/strategy_model.h"

#include "core/visibility/built_strategy.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

int StrategyModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(strategies().size()); }

Qt::ItemFlags StrategyModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractListModel::flags(index);
    const bool usable = index.isValid() && !m_refusal(strategies()[size_t(index.row())].info);
    return usable ? usual : usual & ~(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
}

QVariant StrategyModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    const StrategyInfo& info = strategies()[size_t(index.row())].info;
    switch (role) {
        case Qt::DisplayRole:
            return translated(info.name);
        case Qt::ToolTipRole:
            return translated(m_refusal(info).value_or(Message{info.description, {}}));
        case IdRole:
            return QString::fromStdString(info.id);
        case PromiseRole:
            return int(usualPromise(info.id));
        default:
            return {};
    }
}

int StrategyModel::rowOf(const std::string& id) const {
    for (size_t row = 0; row < strategies().size(); ++row)
        if (strategies()[row].info.id == id) return int(row);
    return -1;
}

void StrategyModel::retranslate() {
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {Qt::DisplayRole, Qt::ToolTipRole});
}

}  // namespace cullscope::ui
