#include "ui/models/listing_model.h"

#include <QFontDatabase>

#include "ui/text/letters.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kSpacesPerLevel = 2;

}  // namespace

void ListingModel::setLines(const std::vector<ListingLine>& lines) {
    beginResetModel();
    m_lines = lines;
    m_frame.reset();
    m_marked.reset();
    endResetModel();
}

void ListingModel::setState(const std::optional<ListingState>& frame, const std::optional<ListingState>& marked) {
    if (frame == m_frame && marked == m_marked) return;
    m_frame = frame;
    m_marked = marked;
    tellOfRows();
}

int ListingModel::currentRow() const { return m_marked ? int(m_marked->current) - 1 : -1; }

int ListingModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_lines.size()); }

QString ListingModel::meaning(int row) const {
    if (current(row)) return tr("the current line");
    const bool decided = m_marked && m_frame != m_marked && m_marked->decisions[size_t(row)] > 0;
    return decided ? tr("decided about the picked triangle") : QString();
}

QString ListingModel::mark(int row) const {
    if (current(row)) return QStringLiteral("▶");
    return meaning(row).isEmpty() ? QString() : QStringLiteral("•");
}

QString ListingModel::lineText(int row) const {
    const ListingLine& line = m_lines[size_t(row)];
    return QStringLiteral("%1 %2%3")
        .arg(row + 1, 2)
        .arg(QString(kSpacesPerLevel * line.indentation, QLatin1Char(' ')), translated(line.text));
}

QString ListingModel::countOf(int row) const {
    // Lines at which nothing is decided, such as that of a loop, have no number.
    const uint64_t count = m_frame ? m_frame->decisions[size_t(row)] : 0;
    return count > 0 ? countText(count) : QString();
}

QVariant ListingModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int row = index.row();
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Mark ? mark(row) : index.column() == Text ? lineText(row) : countOf(row);
        case Qt::AccessibleTextRole:
            return index.column() == Mark ? meaning(row) : data(index, Qt::DisplayRole);
        case Qt::ToolTipRole:
            return index.column() == Mark ? meaning(row) : QVariant();
        case Qt::TextAlignmentRole:
            return int(index.column() == Text ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
        case Qt::FontRole: {
            if (index.column() != Text) return {};
            QFont font = lettersOf(QLocale(), QFontDatabase::systemFont(QFontDatabase::FixedFont));
            font.setBold(current(row));
            return font;
        }
        default:
            return {};
    }
}

QVariant ListingModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
    if (section == Text) return tr("Line");
    if (section == Decisions) return role == Qt::ToolTipRole ? tr("How many decisions fell at the line") : tr("Decisions");
    return {};
}

void ListingModel::tellOfRows() {
    if (!m_lines.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void ListingModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    tellOfRows();
}

}  // namespace cullscope::ui
