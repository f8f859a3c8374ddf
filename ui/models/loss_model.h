#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/scene/scene.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// The objects with missed pixels in a view, most pixels first. Columns: name, pixels, share of all missed pixels.
class LossModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Pixels, Share, ColumnCount };

    explicit LossModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// `objects` are numbered as in `scene`, which may be null if `objects` is empty.
    void setObjects(const ScenePointer& scene, const std::vector<LostObject>& objects, uint64_t missedPixels);
    [[nodiscard]] const ScenePointer& scene() const { return m_scene; }
    [[nodiscard]] uint32_t instanceAt(int row) const { return m_objects[size_t(row)].instance; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    ScenePointer m_scene;
    std::vector<LostObject> m_objects;
    uint64_t m_missed = 0;
};

}  // namespace cullscope::ui
