#pragma once

#include <QAbstractListModel>

namespace cullscope::ui {

/// The registered strategies in the registry's order: name, id, description as tooltip.
class StrategyModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { IdRole = Qt::UserRole + 1 };

    using QAbstractListModel::QAbstractListModel;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// −1: none of this id.
    [[nodiscard]] int rowOf(const std::string& id) const;
    /// The names are in another language now.
    void retranslate();
};

}  // namespace cullscope::ui
