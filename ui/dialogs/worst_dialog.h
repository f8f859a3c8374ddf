#pragma once

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>
#include <optional>

#include "core/experiments/worst/worst_view.h"
#include "ui/dialogs/run_dialog.h"
#include "ui/plots/line_plot_widget.h"
#include "ui/plots/result_exporter.h"

namespace cullscope::ui {

/// The map of a search for the worst view: a click, or Enter for the worst one, chooses a view.
class WorstMap : public LinePlotWidget {
    Q_OBJECT

public:
    using LinePlotWidget::LinePlotWidget;

    /// The value at a place of the widget; none: it is not on the plot.
    [[nodiscard]] std::optional<PlotPoint> valueAt(const QPointF& place) const;

signals:
    void valueChosen(const cullscope::PlotPoint& value);

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
};

/// The view in which the active view's strategy loses most or gains least, searched on a thread and an OpenGL context of its own:
/// a sentence, and a map whose places fly the linked views there.
class WorstDialog : public RunDialog {
    Q_OBJECT

public:
    explicit WorstDialog(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& of() { return *m_of; }
    [[nodiscard]] QComboBox& from() { return *m_from; }
    [[nodiscard]] QSpinBox& views() { return *m_views; }
    [[nodiscard]] QLabel& answer() { return *m_answer; }
    [[nodiscard]] WorstMap& map() { return *m_map; }
    [[nodiscard]] QPushButton& startButton() { return *m_start; }
    [[nodiscard]] QPushButton& goButton() { return *m_go; }
    [[nodiscard]] const std::optional<worst::WorstResult>& result() const { return m_result; }

private:
    void start();
    void goTo(const worst::TriedView& view);
    void save();
    void showState() override;
    void showProgress(double share) override;
    void showFailure(const Message& failure) override;

    QComboBox *m_of, *m_from;
    QSpinBox* m_views;
    QLabel* m_answer;
    WorstMap* m_map;
    QProgressBar* m_progress;
    QPushButton *m_start, *m_cancel, *m_go, *m_save, *m_close;
    ResultExporter* m_exporter;
    std::optional<worst::WorstResult> m_result;
};

}  // namespace cullscope::ui
