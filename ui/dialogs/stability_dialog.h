#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QTreeWidget>
#include <vector>

#include "core/experiments/stability/battery.h"
#include "ui/dialogs/run_dialog.h"
#include "ui/plots/result_exporter.h"

namespace cullscope::ui {

/// The battery of extreme cases: a row for each case with its right answer and what was found, and below it a row for each
/// finding. Cases run on a thread and an OpenGL context of their own, so that the views go on. A double click opens the scene of
/// a case in the views.
class StabilityDialog : public RunDialog {
    Q_OBJECT

public:
    explicit StabilityDialog(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QTreeWidget& cases() { return *m_cases; }
    [[nodiscard]] QPushButton& runButton() { return *m_run; }
    [[nodiscard]] QPushButton& runChosenButton() { return *m_runChosen; }
    [[nodiscard]] QPushButton& cancelButton() { return *m_cancel; }
    [[nodiscard]] QLabel& conclusion() { return *m_conclusion; }

signals:
    /// A scene of the gallery is to be shown in the views.
    void sceneWanted(const QString& scene);

private:
    void fill();
    void start(const std::vector<const stability::StabilityCase*>& cases);
    void showResult(const stability::CaseResult& result);
    void showState() override;
    void showFailure(const Message& failure) override;
    void openSceneOf(const QTreeWidgetItem& item);
    [[nodiscard]] std::vector<const stability::StabilityCase*> chosen() const;
    [[nodiscard]] QTreeWidgetItem* itemOf(const stability::StabilityCase& which) const;

    QLabel* m_conclusion;
    QTreeWidget* m_cases;
    QProgressBar* m_progress;
    QPushButton *m_run, *m_runChosen, *m_cancel, *m_close;
    std::vector<stability::CaseResult> m_results;  ///< of the newest run
    size_t m_asked = 0;                            ///< cases of that run
};

}  // namespace cullscope::ui
