#include "ui/models/paper_table_model.h"

#include <QFont>
#include <QLocale>

#include "core/measure/statistics.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

QString numberText(const ResultColumn& column, double number) {
    return QLocale().toString(number * column.scale, 'f', column.decimals);
}

QString cellText(const ResultColumn& column, const CellValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return numberText(column, *number);
    if (const auto* words = std::get_if<std::string>(&value)) return translated(*words);
    if (const auto* estimate = std::get_if<RatioEstimate>(&value); estimate && !estimate->hasInterval)
        return numberText(column, estimate->ratio);
    if (const auto* estimate = std::get_if<RatioEstimate>(&value))
        return QStringLiteral("%1 [%2, %3]")
            .arg(numberText(column, estimate->ratio), numberText(column, estimate->ci95[0]),
                 numberText(column, estimate->ci95[1]));
    return {};
}

/// A column title with line breaks after its punctuation, because the numbers below it are narrower.
QString headerText(const ResultColumn& column) {
    QString text = translated(column.title);
    for (const QString& mark : {QStringLiteral(": "), QStringLiteral(", "), QStringLiteral("："), QStringLiteral("，")})
        text.replace(mark, mark.left(1) + QLatin1Char('\n'));
    return text;
}

}  // namespace

void PaperTableModel::setTable(const ResultTable& table) {
    beginResetModel();
    m_table = table;
    endResetModel();
}

int PaperTableModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_table.rows.size()); }

int PaperTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_table.columns.size()); }

QVariant PaperTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    const ResultColumn& column = m_table.columns[size_t(index.column())];
    if (role == Qt::DisplayRole) return cellText(column, m_table.rows[size_t(index.row())][size_t(index.column())]);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (column.origin == ResultColumn::Origin::Axis ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::FontRole && column.origin == ResultColumn::Origin::Stated) {
        QFont font;
        font.setItalic(true);
        return font;
    }
    return {};
}

QVariant PaperTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    const ResultColumn& column = m_table.columns[size_t(section)];
    if (role == Qt::DisplayRole) return headerText(column);
    if (role != Qt::ToolTipRole) return {};
    if (column.origin == ResultColumn::Origin::Stated) return tr("As the paper prints it");
    return column.origin == ResultColumn::Origin::Measured ? tr("Measured here") : QString();
}

}  // namespace cullscope::ui
