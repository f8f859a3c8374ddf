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
    if (!question || question->of != Prediction::Items::Parts) m_questionParts = nullptr;
    emit questionChanged();
    update();
}

void Session::setQuestion(const Prediction& question, const NamedPartsPointer& parts) {
    m_question = question;
    m_questionParts = parts;
    emit questionChanged();
    update();
}

void Session::nameInQuestion(uint64_t triangle, const Vec3& point) {
    Prediction named = *m_question;
    if (named.of == Prediction::Items::Parts) {
        const std::optional<size_t> part = m_questionParts ? m_questionParts->partAt(*m_scene, triangle, point) : std::nullopt;
        if (!part) return;
        named.toggle(*part);
    } else {
        named.toggle(named.of == Prediction::Items::Triangles ? triangle : m_scene->instanceOf(triangle));
    }
    setQuestion(named);
}

void Session::setGroup(const std::optional<ChosenGroup>& group) {
    if (group == m_group) return;
    m_group = group;
    emit groupChanged();
}

const ChosenGroup* Session::groupOf(int view) const {
    const bool shows = m_group && slot(culledBy(view)).built() == m_group->strategy && !stepOf(view) && !m_question;
    return shows ? &*m_group : nullptr;
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
