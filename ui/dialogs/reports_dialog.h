#pragma once

#include <QDialog>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <vector>

#include "core/experiments/store/report.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The reports of the desktop's result store, the newest first, and what the chosen one says.
class ReportsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ReportsDialog(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QTableWidget& table() { return *m_table; }
    [[nodiscard]] QPlainTextEdit& words() { return *m_words; }
    /// Writes the chosen report's document.
    void save(const QString& path);

protected:
    /// What was found meanwhile is there when the user comes back to the dialog.
    bool event(QEvent* event) override;

private:
    void read();
    void fill();
    void showChosen();
    void askWhereTo();
    [[nodiscard]] const store::StoredReport* chosen() const;

    Session& m_session;
    std::vector<store::StoredReport> m_reports;  ///< by row
    QTableWidget* m_table;
    QPlainTextEdit* m_words;
    QPushButton* m_export;
};

}  // namespace cullscope::ui
