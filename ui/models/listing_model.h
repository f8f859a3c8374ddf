#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/frame/listing.h"

namespace cullscope::ui {

/// A strategy's listing, a row a line: a mark, the line with its number, and how many decisions of a frame fell there.
class ListingModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Text, Decisions, ColumnCount };

    explicit ListingModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setLines(const std::vector<ListingLine>& lines);
    /// `frame`: the counts; none: they are not known. `marked`: whose lines are marked, the current one as such.
    void setState(const std::optional<ListingState>& frame, const std::optional<ListingState>& marked);

    /// The row of the current line; -1: there is none.
    [[nodiscard]] int currentRow() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    [[nodiscard]] bool current(int row) const { return m_marked && m_marked->current == row + 1; }
    /// What the mark of a row means; empty: it has none.
    [[nodiscard]] QString meaning(int row) const;
    [[nodiscard]] QString mark(int row) const;
    [[nodiscard]] QString lineText(int row) const;
    [[nodiscard]] QString countOf(int row) const;
    void tellOfRows();

    std::vector<ListingLine> m_lines;
    std::optional<ListingState> m_frame, m_marked;
};

}  // namespace cullscope::ui
