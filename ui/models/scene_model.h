#pragma once

#include <QAbstractTableModel>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope::ui {

/// The properties of a scene: names in column 0, values in column 1. Of one that was modelled of primitives also their number by
/// kind, and all together.
class SceneModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Sets the scene; null: the model has no rows.
    void setScene(const ScenePointer& scene);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : 2; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    void retranslate();

private:
    enum Row { Name, Triangles, Vertices, Objects, Meshes, Size, Memory, Primitives, RowCount };
    /// Rows behind the fixed ones: a kind of primitive each. Without primitives there is no row of them.
    [[nodiscard]] bool isKind(int row) const { return row >= RowCount; }
    [[nodiscard]] QString rowTitle(int row) const;

    [[nodiscard]] static QString title(int row);
    [[nodiscard]] QString value(int row) const;

    ScenePointer m_scene;
    std::vector<std::pair<std::string, uint64_t>> m_kinds;  ///< of primitives with their numbers, the most frequent first
};

}  // namespace cullscope::ui
