#pragma once

#include <QLayout>

namespace cullscope::ui {

/// A layout that places widgets side by side and begins a new row if there is no more room.
class FlowLayout : public QLayout {
    Q_OBJECT

public:
    /// `between`: pixels between two widgets of a row; `rows`: between two rows.
    FlowLayout(QWidget* parent, int between, int rows);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override { m_items.append(item); }
    [[nodiscard]] int count() const override { return int(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override { return m_items.value(index); }
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
    void setGeometry(const QRect& place) override;

private:
    /// Returns the height of the layout in `place`; moves the widgets if `apply`.
    int arrange(const QRect& place, bool apply) const;

    QList<QLayoutItem*> m_items;
    int m_between, m_rows;
};

}  // namespace cullscope::ui
