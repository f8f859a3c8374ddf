#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/frame/prediction.h"

namespace cullscope::ui {

/// What was expected of each object, triangle or part, beside what the frame did with it.
class PredictionModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Item, Expected, Actual, Right, ColumnCount };

    /// `parts`: of a question about parts, else null.
    PredictionModel(ScenePointer scene, Prediction prediction, std::vector<PredictionRow> rows,
                    std::shared_ptr<const NamedParts> parts, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// How a place (NamedParts::places) is called among answers: "C1", of a plane "in P1".
    [[nodiscard]] static QString placeName(const NamedParts& parts, size_t place);
    /// "Right: 3 of 4".
    [[nodiscard]] QString score() const;

private:
    [[nodiscard]] QString itemText(uint64_t item) const;
    [[nodiscard]] QString placeText(const std::optional<size_t>& place) const;

    ScenePointer m_scene;
    Prediction m_prediction;
    std::vector<PredictionRow> m_rows;
    std::shared_ptr<const NamedParts> m_parts;
};

}  // namespace cullscope::ui
