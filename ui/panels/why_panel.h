#pragma once

#include <QLabel>
#include <QScrollArea>

#include "ui/look/verdict_swatch.h"
#include "ui/panels/plane_table.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// Explains why the picked triangle was drawn or culled: the chain of decisions of the active view's strategy.
class WhyPanel : public QScrollArea {
    Q_OBJECT

public:
    WhyPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    /// The sentences from top to bottom, for tests and screen readers; empty: no triangle is picked.
    [[nodiscard]] QStringList sentences() const;
    /// The comparison with the truth; empty: the truth is not known or adds nothing, as at a step of the frame.
    [[nodiscard]] QString outcome() const;
    [[nodiscard]] QString heading() const;
    /// Whether the truth shows the picked triangle, which was left out without the loss of a pixel: the raster's snapping
    /// explains it (TriangleStates::withinSnapping).
    [[nodiscard]] bool withinSnapping() const;
    /// The first line: the cause, and what decided with its numbers; empty where nothing is known yet.
    [[nodiscard]] QString decided() const;
    [[nodiscard]] PlaneTable& planes() { return *m_planes; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    void refresh();
    [[nodiscard]] QString missingSentence() const;
    void showPlanes(bool known);
    void showState();
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString emptySentence() const;

    Session& m_session;
    SnapshotReader& m_reader;
    QLabel* m_empty;
    QWidget* m_content;
    QLabel* m_heading;
    VerdictSwatch* m_swatch;
    QLabel* m_state;
    QLabel* m_verdict;
    PlaneTable* m_planes;
    QLabel* m_untested;
    QLabel* m_steps;
};

}  // namespace cullscope::ui
