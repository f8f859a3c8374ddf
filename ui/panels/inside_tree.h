#pragma once

#include <QLabel>

#include "ui/models/inside_model.h"
#include "ui/panels/long_list_view.h"
#include "ui/session/inside_reader.h"

namespace cullscope::ui {

/// The boxes that the active view's strategy tests, by verdict. A selected row is picked, and what is picked is selected.
class InsideTree : public QWidget {
    Q_OBJECT

public:
    InsideTree(Session& session, InsideReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] InsideModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpView();
    void refresh();
    [[nodiscard]] std::shared_ptr<const TriangleStates> statesOfTruth() const;
    void followPick();
    void pickSelected();
    void retranslate();
    [[nodiscard]] QString emptySentence() const;

    Session& m_session;
    InsideReader& m_reader;
    InsideModel* m_model;
    LongListView* m_view;
    QLabel* m_empty;
    bool m_following = false;
};

}  // namespace cullscope::ui
