#pragma once

#include <QScrollArea>

#include "ui/plots/flow_chart_plot.h"
#include "ui/plots/picture_menu.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The flow chart of the active view's strategy, with the step in hand lit: that of the frame's last decision; with a pick, that
/// which decided about the picked triangle.
class FlowChartPanel : public QScrollArea {
    Q_OBJECT

public:
    FlowChartPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] FlowChartPlot& plot() { return *m_plot; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    /// Scrolls to the lit box.
    void showLit();
    /// The listing's line that is lit; 0: none.
    [[nodiscard]] uint8_t currentLine() const;

    Session& m_session;
    SnapshotReader& m_reader;
    FlowChartPlot* m_plot;
    PictureMenu* m_pictures;
};

}  // namespace cullscope::ui
