#pragma once

#include <QDialog>

class QTableView;

namespace cullscope::ui {

class PredictionModel;

/// The answer to a question that was asked first: what was expected beside what happened, with the score.
class AnswerDialog : public QDialog {
    Q_OBJECT

public:
    /// Takes the model.
    explicit AnswerDialog(PredictionModel* model, QWidget* parent = nullptr);

    [[nodiscard]] PredictionModel& model() { return *m_model; }

private:
    PredictionModel* m_model;
};

}  // namespace cullscope::ui
