#include "ui/models/report_model.h"

#include <QCoreApplication>

#include "ui/text/translated.h"

namespace cullscope::ui {

void ReportModel::setReport(const std::optional<LoadReport>& report) {
    beginResetModel();
    m_clean = !report || report->clean();
    m_sentences.clear();
    if (report) {
        m_sentences = report->sentences();
        if (m_sentences.empty())
            m_sentences.push_back({QT_TRANSLATE_NOOP("core", "Nothing in the file had to be repaired."), {}});
    }
    endResetModel();
}

int ReportModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_sentences.size()); }

QVariant ReportModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    return translated(m_sentences[size_t(index.row())]);
}

void ReportModel::retranslate() {
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {Qt::DisplayRole, Qt::ToolTipRole});
}

}  // namespace cullscope::ui
