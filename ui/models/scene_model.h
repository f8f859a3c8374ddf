#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope::ui {

/// The properties of a scene: names in column 0, values in column 1.
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
    enum Row { Name, Triangles, Vertices, Objects, Meshes, Size, Memory, RowCount };

    [[nodiscard]] static QString title(int row);
    [[nodiscard]] QString value(int row) const;

    ScenePointer m_scene;
};

}  // namespace cullscope::ui
