#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <vector>

#include "core/experiments/stability/battery.h"
#include "ui/jobs/background.h"
#include "ui/plots/result_exporter.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The battery of extreme cases: a row for each case with its right answer and what was found, and below it a row for each
/// finding. Cases run on a thread and an OpenGL context of their own, so that the views go on. A double click opens the scene of
/// a case in the views.
class StabilityDialog : public QDialog {
    Q_OBJECT

public:
    explicit StabilityDialog(Session& session, QWidget* parent = nullptr);
    ~StabilityDialog() override;

    [[nodiscard]] QTreeWidget& cases() { return *m_cases; }
    [[nodiscard]] QPushButton& runButton() { return *m_run; }
    [[nodiscard]] QPushButton& runChosenButton() { return *m_runChosen; }
    [[nodiscard]] QPushButton& cancelButton() { return *m_cancel; }
    [[nodiscard]] QLabel& conclusion() { return *m_conclusion; }
    [[nodiscard]] bool running() const { return m_running; }
    /// Closes the dialog and stops the cases under way.
    void reject() override;

signals:
    /// A scene of the gallery is to be shown in the views.
    void sceneWanted(const QString& scene);
    void ended();

private:
    void fill();
    void start(const std::vector<const stability::StabilityCase*>& cases);
    void showResult(const stability::CaseResult& result);
    void end(const Message& failure);
    void showState();
    void openSceneOf(const QTreeWidgetItem& item);
    [[nodiscard]] std::vector<const stability::StabilityCase*> chosen() const;
    [[nodiscard]] QTreeWidgetItem* itemOf(const stability::StabilityCase& which) const;

    Session& m_session;
    QLabel* m_conclusion;
    QTreeWidget* m_cases;
    QProgressBar* m_progress;
    QPushButton *m_run, *m_runChosen, *m_cancel, *m_close;
    std::vector<stability::CaseResult> m_results;  ///< of the newest run
    size_t m_asked = 0;                            ///< cases of that run
    bool m_running = false;
    std::stop_source m_stop;
    Background m_work;
};

}  // namespace cullscope::ui
