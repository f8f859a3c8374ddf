#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/jobs/object_verdicts.h"

namespace cullscope::ui {

/// The objects of the opened scene: whether each is shown, its name, triangles, verdict and size. Only those are rows whose names
/// hold the search text, in the order of a column. Made for 100,000 objects: nothing is kept for a row but its object's number.
class ObjectModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Eye, Name, Triangles, Verdict, Size, ColumnCount };

    explicit ObjectModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Null: no rows.
    void setScene(const ScenePointer& opened);
    /// One flag an object.
    void setHidden(const std::vector<bool>& hidden);
    /// `verdicts` are numbered by the instances of the shown scene: the objects that are not hidden, in order.
    void setVerdicts(const ScenePointer& shown, const std::shared_ptr<const TriangleStates>& states,
                     const SnapshotReadingPointer& reading);
    /// Only names that hold this are shown, whatever their case; empty: all.
    void setSearch(const QString& text);

    [[nodiscard]] const ScenePointer& scene() const { return m_opened; }
    [[nodiscard]] uint32_t objectAt(int row) const { return m_rows[size_t(row)]; }
    /// -1: the search leaves it out.
    [[nodiscard]] int rowOf(uint32_t object) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Anything but a column of this model (such as -1): the scene's own order.
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
    std::vector<uint32_t> m_instance;  ///< of the shown scene, by object
    ObjectVerdicts m_verdicts;
    bool m_verdictsFit = false;  ///< they are of the objects that are shown now
    QString m_search;
    int m_sortedBy = -1;
    Qt::SortOrder m_order = Qt::AscendingOrder;
    std::vector<uint32_t> m_rows;
};

}  // namespace cullscope::ui
