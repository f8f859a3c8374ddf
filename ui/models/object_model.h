#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/jobs/object_verdicts.h"

namespace cullscope::ui {

/// The objects of the opened scene. Columns: shown or hidden, name, triangles, verdict, size. The rows are the objects whose name
/// contains the search text, sorted by a column. Made for 100,000 objects: stores only an object number per row.
class ObjectModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Eye, Name, Triangles, Verdict, Size, ColumnCount };

    explicit ObjectModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Sets the scene; null: the model has no rows.
    void setScene(const ScenePointer& opened);
    /// Sets one flag per object.
    void setHidden(const std::vector<bool>& hidden);
    /// Sets the inputs of the verdicts, which are numbered as the instances of `shown`: the objects that are not hidden, in
    /// order.
    void setVerdicts(const ScenePointer& shown, const std::shared_ptr<const TriangleStates>& states,
                     const SnapshotReadingPointer& reading);
    /// Keeps only rows whose name contains `text`, ignoring case; empty: all rows.
    void setSearch(const QString& text);

    [[nodiscard]] const ScenePointer& scene() const { return m_opened; }
    [[nodiscard]] uint32_t objectAt(int row) const { return m_rows[size_t(row)]; }
    /// The row of an object; -1: the search excludes it.
    [[nodiscard]] int rowOf(uint32_t object) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Sorts by a column. A value that is no column of this model (such as -1) restores the scene's order.
    void sort(int column, Qt::SortOrder order) override;
    void retranslate();

private:
    [[nodiscard]] QString text(uint32_t object, int column) const;
    [[nodiscard]] QVariant decoration(uint32_t object, int column) const;
    [[nodiscard]] std::optional<ObjectVerdicts::Verdict> verdict(uint32_t object) const;
    [[nodiscard]] QString verdictWord(uint32_t object) const;
    [[nodiscard]] double extent(uint32_t object) const;
    [[nodiscard]] bool less(uint32_t a, uint32_t b) const;
    void findRows();
    void tellOfData();

    ScenePointer m_opened;
    std::vector<bool> m_hidden;
    std::vector<uint32_t> m_instance;  ///< by object: its instance in the shown scene
    ObjectVerdicts m_verdicts;
    bool m_verdictsFit = false;  ///< m_verdicts is numbered as the objects shown now
    QString m_search;
    int m_sortedBy = -1;
    Qt::SortOrder m_order = Qt::AscendingOrder;
    std::vector<uint32_t> m_rows;
};

}  // namespace cullscope::ui
