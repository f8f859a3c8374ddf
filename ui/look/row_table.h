#pragma once

#include <QStringList>
#include <QTableWidget>

namespace cullscope::ui {

/// Gives a table its columns. Its rows are read and chosen one at a time: nothing is edited, and the Tab key leaves the table.
void setUpRows(QTableWidget& table, const QStringList& titles);

}  // namespace cullscope::ui
