#pragma once

#include <QLabel>
#include <QTableView>

#include "ui/models/listing_model.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The listing of the active view's strategy, with the number of decisions that fell at each line. Marked is the line of the
/// frame's last decision; with a pick, the lines that decided about the picked triangle, the last of them as the current one.
class ListingPanel : public QWidget {
    Q_OBJECT

public:
    ListingPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] ListingModel& model() { return *m_model; }
    [[nodiscard]] QTableView& view() { return *m_view; }
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
    QTableView* m_view;
    const Show* m_show = nullptr;
};

}  // namespace cullscope::ui
