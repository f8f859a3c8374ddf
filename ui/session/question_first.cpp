#include "ui/session/question_first.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/error.h"

namespace cullscope::ui {

QuestionFirst::QuestionFirst(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    // Other objects have other numbers.
    connect(&session, &Session::sceneChanged, this, &QuestionFirst::withdraw);
    connect(&session, &Session::hiddenChanged, this, &QuestionFirst::withdraw);
    // Another frame may have other parts.
    for (const auto signal : {&Session::cameraChanged, &Session::activeViewChanged})
        connect(&session, signal, this, &QuestionFirst::readParts);
    for (const auto signal : {&Session::strategyBuilt, &Session::setupChanged})
        connect(&session, signal, this, &QuestionFirst::readParts);
}

void QuestionFirst::ask(Prediction::Question question) {
    if (!m_session.scene() || !m_session.gpu()) return;
    const bool one = m_session.scene()->instances().size() == 1;
    m_session.setQuestion(Prediction{question, one ? Prediction::Items::Triangles : Prediction::Items::Objects});
    readParts();
}

void QuestionFirst::place(size_t place) {
    if (!m_session.question()) return;
    Prediction placed = *m_session.question();
    placed.place(place);
    m_session.setQuestion(placed);
}

void QuestionFirst::readParts() {
    const std::optional<ViewRequest> request = m_session.viewRequest(m_session.activeView());
    if (!m_session.question() || m_session.question()->question == Prediction::Question::Vanish || !request) return;
    GpuThread& gpu = *m_session.gpu();
    const auto read = [this, &gpu, request = *request, frames = m_session.frames()](GpuJobs::Step& step) {
        if (gpu.lost()) return;
        try {
            const ViewFramePointer frame = frames->of(request.frame(), gpu.renderer());
            const auto parts = std::make_shared<const NamedParts>(request.strategy->parts(frame->log));
            step.deliver([this, parts] { take(parts); });
        } catch (const Error&) {
            // The question stays one about objects; the view tells of the failure.
        }
    };
    m_reading.start(gpu, read, {.buffers = {request->buffers}, .urgency = Urgency::Picture});
}

void QuestionFirst::take(const NamedPartsPointer& parts) {
    if (!m_session.question() || m_session.question()->question == Prediction::Question::Vanish) return;
    const bool byPlace = m_session.question()->question == Prediction::Question::Place;
    if (!byPlace && !(parts->divides() && parts->parts.size() <= kMostParts)) return;
    Prediction question = *m_session.question();
    const NamedPartsPointer& before = m_session.questionParts();
    const bool same =
        before && std::ranges::equal(before->parts, parts->parts, {}, &NamedParts::Part::name, &NamedParts::Part::name);
    if (!same) question = Prediction{question.question};
    question.of = Prediction::Items::Parts;
    m_session.setQuestion(question, parts);
}

void QuestionFirst::withdraw() {
    m_jobs.cancel();
    m_reading.cancel();
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
        NamedPartsPointer parts;
        Message failure;
        try {
            const bool ofParts = prediction.of == Prediction::Items::Parts;
            const ViewFramePointer frame = frames->of(request.frame(), gpu.renderer());
            if (ofParts) parts = std::make_shared<const NamedParts>(request.strategy->parts(frame->log));
            rows = answerTo(prediction, request.buffers->scene(), frame->log, ofParts ? *parts : NamedParts());
        } catch (const Error& error) {
            failure = error.message();
        }
        step.deliver([this, prediction, rows, parts, failure] {
            m_session.setQuestion(std::nullopt);
            if (failure.empty())
                emit answered(prediction, rows, parts);
            else
                m_session.raise(Severity::Error, failure);
        });
    };
    m_jobs.start(gpu, compare, {.buffers = {request->buffers}, .urgency = Urgency::Picture});
}

}  // namespace cullscope::ui
