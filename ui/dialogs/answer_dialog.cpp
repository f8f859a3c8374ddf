#include "ui/dialogs/answer_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/prediction_model.h"

namespace cullscope::ui {

namespace {

constexpr int kAnswerWidth = 520;
constexpr int kLeastAnswerColumn = 96;  // pixels, so that short words of some languages are not cramped
constexpr int kAnswersShown = 14;       // of more rows the table scrolls

}  // namespace

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
    table->setWordWrap(false);
    table->horizontalHeader()->setMinimumSectionSize(kLeastAnswerColumn);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(PredictionModel::Item, QHeaderView::Stretch);
    table->setAccessibleName(windowTitle());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(score);
    layout->addWidget(table, 1);
    layout->addWidget(buttons);
    // As high as its rows: an empty table looks as if something were missing.
    const int rows = std::clamp(model->rowCount(), 1, kAnswersShown);
    table->setMinimumHeight(table->horizontalHeader()->sizeHint().height() +
                            rows * table->verticalHeader()->defaultSectionSize() + 2 * table->frameWidth());
    resize(kAnswerWidth, sizeHint().height());
}

}  // namespace cullscope::ui
