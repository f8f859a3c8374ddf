#pragma once

#include <QAbstractListModel>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/load.h"

namespace cullscope::ui {

/// What was found in a file and what became of it, a sentence a row; one row that says so where nothing was wrong.
class ReportModel : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    void setReport(const std::optional<LoadReport>& report);
    [[nodiscard]] bool clean() const { return m_clean; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    void retranslate();

private:
    std::vector<Message> m_sentences;
    bool m_clean = true;
};

}  // namespace cullscope::ui
