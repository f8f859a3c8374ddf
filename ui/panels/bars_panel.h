#pragma once

#include <QScrollArea>

#include "ui/plots/bars_plot.h"
#include "ui/plots/picture_menu.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The counts that the active view's strategy makes of its frame.
class BarsPanel : public QScrollArea {
    Q_OBJECT

public:
    BarsPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] BarsPlot& plot() { return *m_plot; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    [[nodiscard]] QString emptySentence() const;

    Session& m_session;
    SnapshotReader& m_reader;
    BarsPlot* m_plot;
    PictureMenu* m_pictures;
};

}  // namespace cullscope::ui
