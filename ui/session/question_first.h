#pragma once

#include <QObject>
#include <vector>

#include "core/frame/prediction.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// "Predict, then reveal": opens a question about the active view's frame, which the session's views hide until the answer is
/// asked for, and compares what was expected with what the frame did.
class QuestionFirst : public QObject {
    Q_OBJECT

public:
    explicit QuestionFirst(Session& session, QObject* parent = nullptr);

    /// Opens a question without anything named. What is named are the parts of a frame that cuts objects, or triangles in a
    /// scene of one object, else objects; a question about places is always about parts. `of`: what is named where something may
    /// vanish.
    void ask(Prediction::Question question, const std::optional<Prediction::Items>& of = {});
    /// What is asked first of the session's scene: the order where the scene names planes, as the lecture's quiz does, which
    /// divide its polygons for it; else what vanishes.
    [[nodiscard]] Prediction::Question usualQuestion() const;
    /// Says where what was named last is expected, as a number of NamedParts::places.
    void place(size_t place);
    /// Answers by a node of the strategy's tree (StructureSnapshot::nodes): a place says where what was named last is expected,
    /// and an object is named; in other questions all that lies at or below the node is named, or taken back. Both are of the
    /// shown scene.
    void answerBy(const BuiltStrategy& strategy, const StructureSnapshot& snapshot, size_t node);
    /// Closes it without an answer.
    void withdraw();
    /// Whether the open question was answered at all: something is named, and of places, where at least one item is expected.
    [[nodiscard]] bool isAnswered() const;
    /// Reads the frame, closes the question and emits `answered`. Does nothing where no question is open, or before it
    /// isAnswered: there would be nothing to compare with what happened.
    void reveal();

signals:
    /// `rows` number instances and triangles as the session's scene does, and parts as `parts`, which is null without them.
    void answered(const cullscope::Prediction& prediction, const std::vector<cullscope::PredictionRow>& rows,
                  const cullscope::ui::NamedPartsPointer& parts);

private:
    /// Of more parts, only objects are asked about in an order.
    static constexpr size_t kMostParts = 200;
    /// So many triangles are named at once by a row of the tree; groups that hold triangles are searched in smaller scenes.
    static constexpr size_t kMostTriangles = 100'000, kMostSearched = 2'000;

    /// Reads the parts of the active view's frame, where the open question may be about them.
    void readParts();
    void take(const NamedPartsPointer& parts);
    /// Answers a question about places by a row of the tree: a leaf, what lies in it, a plane in which something lies, or an
    /// object, which is named. Says why another row is no answer.
    void answerPlaceBy(const StructureSnapshot& snapshot, size_t node);
    /// What a question may be about.
    [[nodiscard]] static NamedParts partsFor(Prediction::Question question, const BuiltStrategy& strategy, const FrameLog& log);
    [[nodiscard]] Prediction::Items usualItems() const;
    /// The question's items that lie at or below a node.
    [[nodiscard]] std::vector<uint64_t> itemsBelow(const BuiltStrategy& strategy, const StructureSnapshot& snapshot,
                                                   size_t node) const;

    Session& m_session;
    GpuJobs m_jobs, m_reading;
};

}  // namespace cullscope::ui
