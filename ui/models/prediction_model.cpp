#include "ui/models/prediction_model.h"

#include <algorithm>
#include <cstdint>

#include "ui/text/wording.h"

namespace cullscope::ui {

PredictionModel::PredictionModel(ScenePointer scene, Prediction prediction, std::vector<PredictionRow> rows,
                                 std::shared_ptr<const NamedParts> parts, QObject* parent)
    : QAbstractTableModel(parent),
      m_scene(std::move(scene)),
      m_prediction(std::move(prediction)),
      m_rows(std::move(rows)),
      m_parts(std::move(parts)) {
    // An order is read from the first to the last; what has no place in it comes at the end.
    if (m_prediction.question == Prediction::Question::Order)
        std::ranges::stable_sort(m_rows, {}, [](const PredictionRow& row) { return row.actual.value_or(SIZE_MAX); });
}

int PredictionModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

QString PredictionModel::itemText(uint64_t item) const {
    if (m_prediction.of == Prediction::Items::Triangles) {
        // As in the sentences of steps.
        const QString object = QString::fromStdString(m_scene->instances()[m_scene->instanceOf(item)].name);
        const bool several = m_scene->instances().size() > 1;
        return tr("triangle %1").arg(several ? countText(item) + QStringLiteral(" (%1)").arg(object) : countText(item));
    }
    if (m_prediction.of == Prediction::Items::Parts) return QString::fromStdString(m_parts->parts[item].name);
    return QString::fromStdString(m_scene->instances()[item].name);
}

QString PredictionModel::placeName(const NamedParts& parts, size_t place) {
    const QString name = QString::fromStdString(parts.places[place]);
    return place < parts.leaves ? name : tr("in %1", "a plane that divides space, in which a polygon lies").arg(name);
}

QString PredictionModel::placeText(const std::optional<size_t>& place) const {
    if (m_prediction.question == Prediction::Question::Vanish) return place == 1 ? tr("vanishes") : tr("is drawn");
    if (m_prediction.question == Prediction::Question::Place) return place ? placeName(*m_parts, *place) : QStringLiteral("–");
    return place ? countText(*place) : QStringLiteral("–");
}

QVariant PredictionModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || role != Qt::DisplayRole) return {};
    const PredictionRow& row = m_rows[size_t(index.row())];
    switch (index.column()) {
        case Item:
            return itemText(row.item);
        case Expected:
            return placeText(row.expected);
        case Actual:
            return placeText(row.actual);
        default:
            return row.right() ? tr("✓ right") : tr("✗ wrong");
    }
}

QVariant PredictionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Item:
            if (m_prediction.of == Prediction::Items::Parts) return tr("Part");
            return m_prediction.of == Prediction::Items::Triangles ? tr("Triangle") : tr("Object");
        case Expected:
            return tr("Expected");
        case Actual:
            return tr("What happened");
        default:
            return tr("Right or wrong");
    }
}

QString PredictionModel::score() const {
    return tr("Right: %1 of %2").arg(countText(rightRows(m_rows)), countText(m_rows.size()));
}

}  // namespace cullscope::ui
