#include "ui/session/question_first.h"

#include <QCoreApplication>

#include "core/base/error.h"

namespace cullscope::ui {

QuestionFirst::QuestionFirst(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    // Other objects have other numbers.
    connect(&session, &Session::sceneChanged, this, &QuestionFirst::withdraw);
    connect(&session, &Session::hiddenChanged, this, &QuestionFirst::withdraw);
}

void QuestionFirst::ask(Prediction::Question question) {
    if (!m_session.scene() || !m_session.gpu()) return;
    m_session.setQuestion(Prediction{question, m_session.scene()->instances().size() == 1, {}});
}

void QuestionFirst::withdraw() {
    m_jobs.cancel();
    m_session.setQuestion(std::nullopt);
}

void QuestionFirst::reveal() {
    const std::optional<ViewRequest> request = m_session.viewRequest(m_session.activeView());
    if (!m_session.question() || !request) return;
    GpuThread& gpu = *m_session.gpu();
    const auto compare = [this, &gpu, request = *request, prediction = *m_session.question(),
                          frames = m_session.frames()](GpuJobs::Step& step) {
        if (gpu.lost()) return;
        std::vector<PredictionRow> rows;
        Message failure;
        try {
            rows = answerTo(prediction, request.buffers->scene(), frames->of(request.frame(), gpu.renderer())->log);
        } catch (const Error& error) {
            failure = error.message();
        }
        step.deliver([this, prediction, rows, failure] {
            m_session.setQuestion(std::nullopt);
            if (failure.empty())
                emit answered(prediction, rows);
            else
                m_session.raise(Severity::Error, failure);
        });
    };
    m_jobs.start(gpu, compare, {.buffers = {request->buffers}, .urgency = Urgency::Picture});
}

}  // namespace cullscope::ui
