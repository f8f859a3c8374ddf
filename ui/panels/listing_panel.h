#pragma once

#include <QLabel>
#include <QTableView>

#include "ui/models/listing_model.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The lines of a listing. The current line stays in sight, and a line that does not fit is not painted: half a line cannot be
/// read.
class ListingView : public QTableView {
    Q_OBJECT

public:
    ListingView(ListingModel& model, QWidget* parent);

    /// Whether what the panel stands in is scrolled to the current line too, as while a frame is stepped.
    void follow(bool follows);
    /// The height of all lines, with the header where it is shown.
    [[nodiscard]] int wholeHeight() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void updateGeometries() override;

private:
    void showCurrent();
    void showCurrentLater();
    /// The part of the viewport that has whole lines. Scrolled to its end, the view has half a line at the top.
    [[nodiscard]] QRect wholeLines() const;

    ListingModel& m_model;
    bool m_follows = false;
    QSize m_laidOut;  ///< the heights of all lines and of the viewport when the current line was last brought into sight
};

/// The listing of the active view's strategy, with the number of decisions that fell at each line. Marked is the line of the
/// frame's last decision; with a pick, the lines that decided about the picked triangle, the last of them as the current one.
class ListingPanel : public QWidget {
    Q_OBJECT

public:
    ListingPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] ListingModel& model() { return *m_model; }
    [[nodiscard]] ListingView& view() { return *m_view; }
    /// The sentence above the lines.
    [[nodiscard]] QString summary() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpView();
    void refresh();
    /// The newest reading, if it is of the chosen strategy and succeeded; else null.
    [[nodiscard]] SnapshotReadingPointer reading() const;

    Session& m_session;
    SnapshotReader& m_reader;
    ListingModel* m_model;
    QLabel* m_summary;
    ListingView* m_view;
    const Show* m_show = nullptr;
};

}  // namespace cullscope::ui
