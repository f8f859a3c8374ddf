#include "ui/dialogs/answer_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/models/prediction_model.h"

namespace cullscope::ui {

AnswerDialog::AnswerDialog(PredictionModel* model, QWidget* parent) : QDialog(parent), m_model(model) {
    model->setParent(this);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("What was expected, and what happened"));
    auto* score = new QLabel(model->score(), this);
    QFont font = score->font();
    font.setBold(true);
    score->setFont(font);
    auto* table = new QTableView(this);
    table->setModel(model);
    table->verticalHeader()->hide();
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setTabKeyNavigation(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(PredictionModel::Item, QHeaderView::Stretch);
    table->setAccessibleName(windowTitle());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(score);
    layout->addWidget(table, 1);
    layout->addWidget(buttons);
    resize(520, 360);
}

}  // namespace cullscope::ui
