#pragma once

#include <QTreeView>

namespace cullscope::ui {

/// A tree view for 100,000 rows: of equal height, and repainted as a whole when many of them change. Qt's own asks for the place
/// of every changed cell first, which takes a tenth of a second.
class LongListView : public QTreeView {
    Q_OBJECT

public:
    explicit LongListView(QWidget* parent = nullptr);

    /// Opens as many whole levels of a tree as make no more than `rows` rows.
    void expandFirstLevels(int rows);

    void dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles = {}) override;
};

}  // namespace cullscope::ui
