#pragma once

#include <QTreeView>

namespace cullscope::ui {

/// A tree view for 100,000 rows of equal height. It is repainted completely when several cells change: QTreeView computes the
/// rectangle of every changed cell first, which takes a tenth of a second.
class LongListView : public QTreeView {
    Q_OBJECT

public:
    explicit LongListView(QWidget* parent = nullptr);

    /// Expands as many complete levels of the tree as have together at most `rows` rows.
    void expandFirstLevels(int rows);

    /// Whether a row that does not fit at the lower end is left out, as for an audience, which cannot scroll.
    void setWholeRows(bool whole);

    void dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles = {}) override;

protected:
    void paintEvent(QPaintEvent* event) override;
    /// The current row stays in view where it was.
    void resizeEvent(QResizeEvent* event) override;

private:
    bool m_wholeRows = false;
};

}  // namespace cullscope::ui
