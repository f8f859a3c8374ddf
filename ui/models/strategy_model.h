#pragma once

#include <QAbstractListModel>
#include <functional>
#include <optional>

#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// The registered strategies in the registry's order: name, id and usual promise, with the description as tooltip. Strategies
/// that this machine does not support are disabled, with the reason as tooltip.
class StrategyModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { IdRole = Qt::UserRole + 1, PromiseRole };

    /// Returns why a strategy cannot be used; none: it can be used.
    using Refusal = std::function<std::optional<Message>(const StrategyInfo&)>;

    explicit StrategyModel(Refusal refusal, QObject* parent = nullptr)
        : QAbstractListModel(parent), m_refusal(std::move(refusal)) {}

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// The row of a strategy; −1: the id is unknown.
    [[nodiscard]] int rowOf(const std::string& id) const;
    /// Updates the names after a change of language.
    void retranslate();

private:
    Refusal m_refusal;
};

}  // namespace cullscope::ui
