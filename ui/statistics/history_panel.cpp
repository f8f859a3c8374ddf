#include "ui/statistics/history_panel.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

namespace cullscope::ui {

HistoryPanel::HistoryPanel(HistoryModel& model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_filter(new QLineEdit(this)),
      m_compare(new QPushButton(this)),
      m_export(new QPushButton(this)),
      m_table(new QTableView(this)) {
    constexpr int kGap = 4;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGap);
    auto* line = new QHBoxLayout;
    line->setContentsMargins(kGap, kGap, kGap, 0);
    line->addWidget(m_filter, 1);
    line->addWidget(m_compare);
    line->addWidget(m_export);
    layout->addLayout(line);
    layout->addWidget(m_table, 1);
    m_filter->setClearButtonEnabled(true);
    m_table->setModel(&model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setAlternatingRowColors(true);
    m_table->setTabKeyNavigation(false);
    m_table->setTextElideMode(Qt::ElideNone);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setSelectionBehavior(QAbstractItemView::SelectColumns);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->setSectionsClickable(false);
    connect(m_filter, &QLineEdit::textChanged, &model, &HistoryModel::setFilter);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HistoryPanel::refresh);
    connect(&model, &QAbstractItemModel::modelReset, this, &HistoryPanel::refresh);
    connect(m_compare, &QPushButton::clicked, this, [this] {
        if (const std::vector<qint64> two = chosen(); two.size() == 2) emit compareRequested(two[0], two[1]);
    });
    connect(m_export, &QPushButton::clicked, this, &HistoryPanel::askWhereTo);
    retranslate();
}

void HistoryPanel::retranslate() {
    m_filter->setPlaceholderText(tr("Filter by scene, strategy or date"));
    m_filter->setAccessibleName(tr("Filter by scene, strategy or date"));
    m_compare->setText(tr("Compare"));
    m_export->setText(tr("Export…"));
    m_export->setToolTip(tr("The chosen experiments, or all that the filter leaves, as JSON or CSV"));
    m_table->setAccessibleName(tr("Experiments beside each other"));
    refresh();
}

std::vector<qint64> HistoryPanel::chosen() const {
    std::vector<int> columns;
    for (const QModelIndex& index : m_table->selectionModel()->selectedColumns()) columns.push_back(index.column());
    // The newest experiment has the first column.
    std::ranges::sort(columns, std::greater());
    std::vector<qint64> numbers;
    for (const int column : columns)
        if (const qint64 number = m_model.number(column); number > 0) numbers.push_back(number);
    return numbers;
}

void HistoryPanel::refresh() {
    const bool two = chosen().size() == 2;
    m_compare->setEnabled(two);
    m_compare->setToolTip(two ? tr("How many times as fast the later one is, with intervals")
                              : tr("Choose two experiments by their headings, the second one with Ctrl"));
    m_export->setEnabled(m_model.columnCount() > 0);
}

void HistoryPanel::askWhereTo() {
    std::vector<qint64> numbers = chosen();
    if (numbers.empty())
        for (int column = m_model.columnCount() - 1; column >= 0; --column)
            if (const qint64 number = m_model.number(column); number > 0) numbers.push_back(number);
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("JSON (*.json);;CSV (*.csv)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
        dialog.setDefaultSuffix(filter.startsWith(QStringLiteral("CSV")) ? QStringLiteral("csv") : QStringLiteral("json"));
    });
    if (dialog.exec() == QDialog::Accepted) emit exportRequested(numbers, dialog.selectedFiles().front());
}

}  // namespace cullscope::ui
