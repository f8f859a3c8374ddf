#pragma once

#include <QLabel>

#include "ui/models/structure_model.h"
#include "ui/panels/long_list_view.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The boxes that the active view's strategy tests, or the nodes of its tree, with their verdicts. The selected object is picked
/// and the selected group is marked in the views; the row of what is picked is selected.
class StructureTree : public QWidget {
    Q_OBJECT

public:
    StructureTree(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] StructureModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpView();
    void fitLetters();
    void refresh();
    [[nodiscard]] std::shared_ptr<const TriangleStates> statesOfTruth() const;
    /// The row of the subject in hand where the active view is stepped, else of the picked object; invalid: there is none.
    [[nodiscard]] QModelIndex followedRow() const;
    void followPick();
    void pickSelected();
    void retranslate();
    [[nodiscard]] QString emptySentence() const;

    Session& m_session;
    SnapshotReader& m_reader;
    StructureModel* m_model;
    LongListView* m_view;
    QLabel* m_empty;
    bool m_large = false;        ///< the letters of a lecture
    bool m_namesPlanes = false;  ///< a plane rejected a box since the tree was made anew
    bool m_following = false;
};

}  // namespace cullscope::ui
