#pragma once

#include <QLabel>
#include <QPushButton>

#include "ui/models/loss_model.h"
#include "ui/panels/long_list_view.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The losses of the active view: its objects by missed pixels, and the number of holes. A click on an object picks it and fits
/// it into the view.
class LossPanel : public QWidget {
    Q_OBJECT

public:
    explicit LossPanel(Session& session, QWidget* parent = nullptr);

    /// The text above the list.
    [[nodiscard]] QString summary() const;
    [[nodiscard]] LossModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    /// Picks the object of a row and fits it into the view.
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
