#pragma once

#include <QLineEdit>
#include <QMenu>

#include "ui/models/object_model.h"
#include "ui/panels/long_list_view.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The list of the scene's objects with a search field. The user can hide, show, isolate and frame the selected objects. The
/// object picked in a view is selected here, and a selected object is picked. Space hides or shows the selected objects, Delete
/// hides them.
class Outliner : public QWidget {
    Q_OBJECT

public:
    explicit Outliner(Session& session, QWidget* parent = nullptr);

    /// Sets the reader of the strategy's decisions, which are listed while the truth is not known.
    void setReader(SnapshotReader& reader);

    [[nodiscard]] ObjectModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }
    [[nodiscard]] QLineEdit& search() { return *m_search; }
    [[nodiscard]] std::vector<uint32_t> selected() const;

    void hideSelected() { setHidden(selected(), true); }
    void showSelected() { setHidden(selected(), false); }
    /// Hides all objects that are not selected.
    void isolateSelected();
    void showAll();
    /// Fits the selected objects into the active view.
    void frameSelected();

signals:
    /// selected() changed, or whether any object is hidden.
    void stateChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpView();
    void refreshScene();
    void refreshVerdicts();
    void setSearch(const QString& text);
    void select(const std::vector<uint32_t>& objects);
    void followPick();
    void takeSelection();
    void clicked(const QModelIndex& index);
    void setHidden(const std::vector<uint32_t>& objects, bool hidden);
    void toggleSelected();
    void showMenu(const QPoint& position);
    bool keyPressed(QObject* watched, int key);
    void retranslate();

    Session& m_session;
    SnapshotReader* m_reader = nullptr;
    ObjectModel* m_model;
    QLineEdit* m_search;
    LongListView* m_view;
    bool m_following = false;
};

}  // namespace cullscope::ui
