#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <optional>

#include "core/experiments/worst/worst_view.h"
#include "ui/jobs/background.h"
#include "ui/plots/line_plot_widget.h"
#include "ui/plots/result_exporter.h"
#include "ui/session/session.h"

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
class WorstDialog : public QDialog {
    Q_OBJECT

public:
    explicit WorstDialog(Session& session, QWidget* parent = nullptr);
    ~WorstDialog() override;

    [[nodiscard]] QComboBox& of() { return *m_of; }
    [[nodiscard]] QComboBox& from() { return *m_from; }
    [[nodiscard]] QSpinBox& views() { return *m_views; }
    [[nodiscard]] QLabel& answer() { return *m_answer; }
    [[nodiscard]] WorstMap& map() { return *m_map; }
    [[nodiscard]] QPushButton& startButton() { return *m_start; }
    [[nodiscard]] QPushButton& goButton() { return *m_go; }
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] const std::optional<worst::WorstResult>& result() const { return m_result; }
    /// Closes the dialog and stops what is under way.
    void reject() override;

signals:
    void ended();

private:
    void start();
    void end(const Message& failure);
    void showState();
    void goTo(const worst::TriedView& view);
    void save();

    Session& m_session;
    QComboBox *m_of, *m_from;
    QSpinBox* m_views;
    QLabel* m_answer;
    WorstMap* m_map;
    QProgressBar* m_progress;
    QPushButton *m_start, *m_cancel, *m_go, *m_save, *m_close;
    ResultExporter* m_exporter;
    std::optional<worst::WorstResult> m_result;
    bool m_running = false;
    std::stop_source m_stop;
    Background m_work;
};

}  // namespace cullscope::ui
