#pragma once

#include <QLabel>
#include <QStandardItemModel>

#include "ui/panels/long_list_view.h"
#include "ui/session/question_first.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The tree of the active view's strategy while a question is open: the names of its nodes and objects, and nothing that the
/// frame decided. A click on a row answers (QuestionFirst::answerBy).
class QuestionTree : public QWidget {
    Q_OBJECT

public:
    QuestionTree(Session& session, SnapshotReader& reader, QuestionFirst& questions, QWidget* parent = nullptr);

    [[nodiscard]] QStandardItemModel& model() { return *m_model; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();
    void answer(const QModelIndex& row);
    /// The strategy's tree; of one without boxes, the scene's objects.
    [[nodiscard]] static std::shared_ptr<const StructureSnapshot> treeOf(const SnapshotReading& reading);
    /// A row's text, which tells nothing that a question may be about.
    [[nodiscard]] static QString nameOf(const Scene& scene, const StructureSnapshot& snapshot, size_t node);

    Session& m_session;
    SnapshotReader& m_reader;
    QuestionFirst& m_questions;
    QStandardItemModel* m_model;
    LongListView* m_view;
    QLabel* m_words;
    SnapshotReadingPointer m_shown;
    std::shared_ptr<const StructureSnapshot> m_tree;  ///< of `m_shown`
    bool m_placed = false;                            ///< shown for a question about places
};

}  // namespace cullscope::ui
