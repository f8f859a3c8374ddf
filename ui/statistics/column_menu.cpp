#include "ui/statistics/column_menu.h"

#include <QHeaderView>
#include <QSettings>

#include "ui/statistics/result_table_model.h"

namespace cullscope::ui {

namespace {

const QString kKey = QStringLiteral("statistics/columns");

QStringList usualColumns() {
    QStringList ids;
    for (int column = 1; column < ResultTableModel::FirstFigure; ++column) ids << ResultTableModel::id(column);
    return ids;
}

}  // namespace

ColumnMenu::ColumnMenu(QTableView& table) : QMenu(&table), m_table(table), m_usual(nullptr) {
    for (int column = 1; column < ResultTableModel::columns(); ++column) {
        if (column == ResultTableModel::FirstFigure) addSeparator();
        QAction* const action = addAction(QString());
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, [this, column](bool on) { m_table.setColumnHidden(column, !on); });
        connect(action, &QAction::triggered, this, &ColumnMenu::keep);
        m_columns << action;
    }
    addSeparator();
    m_usual = addAction(QString());
    connect(m_usual, &QAction::triggered, this, [this] {
        show(usualColumns());
        QSettings().remove(kKey);
    });
    QHeaderView& header = *m_table.horizontalHeader();
    header.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&header, &QHeaderView::customContextMenuRequested, this,
            [this, &header](const QPoint& place) { popup(header.mapToGlobal(place)); });
    show(QSettings().value(kKey, usualColumns()).toStringList());
}

void ColumnMenu::retranslate() {
    for (int i = 0; i < int(m_columns.size()); ++i) m_columns[i]->setText(ResultTableModel::title(i + 1).simplified());
    m_usual->setText(tr("As at the first start"));
}

void ColumnMenu::show(const QStringList& ids) {
    for (int i = 0; i < int(m_columns.size()); ++i) {
        const bool on = ids.contains(ResultTableModel::id(i + 1));
        m_columns[i]->setChecked(on);
        m_table.setColumnHidden(i + 1, !on);
    }
}

QStringList ColumnMenu::shown() const {
    QStringList ids;
    for (int i = 0; i < int(m_columns.size()); ++i)
        if (m_columns[i]->isChecked()) ids << ResultTableModel::id(i + 1);
    return ids;
}

void ColumnMenu::keep() { QSettings().setValue(kKey, shown()); }

}  // namespace cullscope::ui
