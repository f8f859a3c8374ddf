// Stepped views of the session, and views whose question is open.
#include "ui/session/session.h"

namespace cullscope::ui {

void Session::setStep(const std::optional<ShownStep>& step) {
    if (step == m_step) return;
    m_step = step;
    emit stepChanged();
    update();
}

void Session::setQuestion(const std::optional<Prediction>& question) {
    if (question == m_question) return;
    m_question = question;
    emit questionChanged();
    update();
}

void Session::nameInQuestion(uint64_t triangle) {
    Prediction named = *m_question;
    named.toggle(named.ofTriangles ? triangle : m_scene->instanceOf(triangle));
    setQuestion(named);
}

void Session::limitToStep(ViewRequest& request) const {
    if (m_question) {
        request.unanswered = true;
        request.look = {};
        request.wipe = Wipe::Mode::None;
        request.other = nullptr;
    } else if (m_step && m_step->view == request.culledBy) {
        request.upTo = m_step->place;
    } else {
        return;
    }
    // The states against the truth are those of the whole frame.
    request.states = nullptr;
}

}  // namespace cullscope::ui
