#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QTableWidget>
#include <optional>

#include "core/experiments/advice/adviser.h"
#include "ui/dialogs/run_dialog.h"
#include "ui/plots/result_exporter.h"
#include "ui/statistics/pareto_plot.h"

namespace cullscope::ui {

/// Which strategy suits the open scene: the answer's sentences first, then the ranked strategies and the plot of speed against
/// loss. Measures on a thread and an OpenGL context of its own, so that the window can be used. A double click on a row, a click
/// on a point, or the button, shows a strategy in the active view.
class AdviseDialog : public RunDialog {
    Q_OBJECT

public:
    enum class File { Json, Csv, Svg, Pdf };

    explicit AdviseDialog(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& path() { return *m_path; }
    [[nodiscard]] QComboBox& size() { return *m_size; }
    [[nodiscard]] QDoubleSpinBox& mayMiss() { return *m_mayMiss; }
    [[nodiscard]] QLabel& answer() { return *m_answer; }
    [[nodiscard]] QTableWidget& table() { return *m_table; }
    [[nodiscard]] ParetoPlot& plot() { return *m_plot; }
    [[nodiscard]] QPushButton& startButton() { return *m_start; }
    [[nodiscard]] QPushButton& cancelButton() { return *m_cancel; }
    [[nodiscard]] QPushButton& showButton() { return *m_show; }
    /// Shows an advice, as when one was measured.
    void setAdvice(const advice::Advice& advice);
    /// Writes the newest advice in the background. Reports success or failure through the session.
    void exportTo(File file, const std::filesystem::path& path);

signals:
    void strategyWanted(const cullscope::StrategyRequest& strategy);

private:
    void setUpTop(QLayout& layout);
    void setUpTable();
    void setUpBottom(QLayout& layout);
    void start();
    void showChosen();
    void askWhereTo(File file);
    void showState() override;
    void showProgress(double share) override;
    void showFailure(const Message& failure) override;

    QComboBox *m_path, *m_size;
    QDoubleSpinBox* m_mayMiss;
    QLabel* m_answer;
    QTableWidget* m_table;
    ParetoPlot* m_plot;
    QProgressBar* m_progress;
    QPushButton *m_start, *m_cancel, *m_show, *m_export, *m_close;
    ResultExporter* m_exporter;
    std::optional<advice::Advice> m_advice;
};

}  // namespace cullscope::ui
