#pragma once

#include <QMenu>
#include <QTableView>

namespace cullscope::ui {

/// Which columns of a table of results are shown: a menu with one check box for each, of the table's header and of a button. The
/// first column always is. The choice is kept from start to start.
class ColumnMenu : public QMenu {
    Q_OBJECT

public:
    /// Shows the columns that were chosen before, or else those before ResultTableModel::FirstFigure. The table has its model.
    explicit ColumnMenu(QTableView& table);

    /// Takes the titles of the columns and its own words in the user's language.
    void retranslate();

private:
    void show(const QStringList& ids);
    void keep();
    [[nodiscard]] QStringList shown() const;

    QTableView& m_table;
    QList<QAction*> m_columns;  ///< of the columns after the first one
    QAction* m_usual;           ///< shows those that are shown at the first start
};

}  // namespace cullscope::ui
