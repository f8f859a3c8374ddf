#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <filesystem>

#include "ui/models/paper_table_model.h"
#include "ui/plots/line_plot_widget.h"
#include "ui/plots/result_exporter.h"
#include "ui/session/paper_runner.h"

namespace cullscope::ui {

/// Reproduces a table of a paper: the window shows its settings while they are measured, and the dialog lists the measured
/// numbers beside the paper's. The runner keeps the newest table, so that a dialog opened later shows it again. A table with
/// plots has a tab for each of them; the first one is in front during the measurement.
class ReproduceDialog : public QDialog {
    Q_OBJECT

public:
    enum class File { Csv, Json, Svg, Pdf };

    ReproduceDialog(Session& session, PaperRunner& runner, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& choice() { return *m_choice; }
    [[nodiscard]] QPushButton& startButton() { return *m_start; }
    [[nodiscard]] QPushButton& cancelButton() { return *m_cancel; }
    [[nodiscard]] QPushButton& exportButton() { return *m_export; }
    [[nodiscard]] QTableView& table() { return *m_table; }
    [[nodiscard]] QTabWidget& pages() { return *m_pages; }
    /// The first plot; the empty one where the table has none.
    [[nodiscard]] LinePlotWidget& plot() { return *m_plots.front(); }
    /// All plots of the shown table, each with a tab of its own; one at least.
    [[nodiscard]] const std::vector<LinePlotWidget*>& plots() const { return m_plots; }
    /// The source of the paper's numbers; during a measurement, what the views show.
    [[nodiscard]] QString heading() const { return m_source->text(); }
    [[nodiscard]] QProgressBar& progressBar() { return *m_progress; }
    [[nodiscard]] const PaperTableModel& model() const { return *m_model; }
    /// Writes the shown table in the background (SVG and PDF: the plot in front, else the first one). Reports success or failure
    /// through the session.
    void exportTo(File file, const std::filesystem::path& path);

    /// Closes the dialog and stops a running measurement.
    void reject() override;

private:
    [[nodiscard]] const Experiment& chosen() const;
    void chooseNewest();
    void makeRows();
    void wire(Session& session);
    void start();
    void makeWay();
    [[nodiscard]] int leastHeight(int width) const;
    void growTo(int height);
    void makeRoom();
    void moveOnScreen(const QPoint& corner);
    void showChosen();
    void showTable();
    void showPlots(const ResultTable& table);
    [[nodiscard]] LinePlotWidget& plotInFront() const;
    [[nodiscard]] bool hasPlot() const { return !chosen().plots.empty(); }
    void showNotes();
    void makePages();
    void makeMenu();
    void showProgress(double share, const QString& stage);
    void showState();
    void showHeading();
    void askWhereTo(File file);

    PaperRunner& m_runner;
    ResultExporter* m_exporter;
    PaperTableModel* m_model;
    QComboBox* m_choice;
    QLabel* m_source;
    QLabel* m_notes;
    QTableView* m_table;
    std::vector<LinePlotWidget*> m_plots;  ///< the pages after the table
    QTabWidget* m_pages;
    QProgressBar* m_progress;
    QPushButton *m_start, *m_cancel, *m_export, *m_close;
    QMenu* m_files;
};

}  // namespace cullscope::ui
