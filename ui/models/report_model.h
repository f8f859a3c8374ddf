#pragma once

#include <QAbstractListModel>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/load.h"

namespace cullscope::ui {

/// The defects found in a file and how they were repaired, one sentence a row; a single row if the file has none.
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
