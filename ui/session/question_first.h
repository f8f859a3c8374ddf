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

    /// Opens a question without anything named. Of a scene of one object, triangles are named, else objects.
    void ask(Prediction::Question question);
    /// Closes it without an answer.
    void withdraw();
    /// Reads the frame, closes the question and emits `answered`. Does nothing where no question is open.
    void reveal();

signals:
    /// `rows` number instances or triangles as the session's scene does.
    void answered(const cullscope::Prediction& prediction, const std::vector<cullscope::PredictionRow>& rows);

private:
    Session& m_session;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
