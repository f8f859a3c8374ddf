#pragma once

#include <QAbstractListModel>
#include <functional>
#include <optional>

#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// The registered strategies in the registry's order: name, id, description as tooltip. What this machine cannot do is disabled,
/// with the reason as tooltip.
class StrategyModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { IdRole = Qt::UserRole + 1 };

    /// Why a strategy cannot be used; nothing: it can.
    using Refusal = std::function<std::optional<Message>(const StrategyInfo&)>;

    explicit StrategyModel(Refusal refusal, QObject* parent = nullptr)
        : QAbstractListModel(parent), m_refusal(std::move(refusal)) {}

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// −1: none of this id.
    [[nodiscard]] int rowOf(const std::string& id) const;
    /// The names are in another language now.
    void retranslate();

private:
    Refusal m_refusal;
};

}  // namespace cullscope::ui
