#pragma once

#include <QLabel>
#include <QPushButton>

#include "ui/models/loss_model.h"
#include "ui/panels/long_list_view.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// What the active view lost: its objects by pixels, and how many holes. A click on one picks it and brings it into the view.
class LossPanel : public QWidget {
    Q_OBJECT

public:
    explicit LossPanel(Session& session, QWidget* parent = nullptr);

    /// What is said above the list.
    [[nodiscard]] QString summary() const;
    [[nodiscard]] LossModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    /// Picks and frames it.
    void goTo(const QModelIndex& index);
    [[nodiscard]] std::optional<uint32_t> objectAt(const QModelIndex& index) const;
    [[nodiscard]] const ViewMetrics& figures() const { return m_session.figures(m_session.activeView()); }

    Session& m_session;
    LossModel* m_model;
    QLabel* m_summary;
    QPushButton* m_measure;
    LongListView* m_view;
};

}  // namespace cullscope::ui
