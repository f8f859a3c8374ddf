// Stepped views of the session, and views whose question is open.
#include <algorithm>

#include "ui/session/session.h"

namespace cullscope::ui {

namespace {

constexpr int kLongestWait = 100;  // ms for a step's picture, before panels show the step without it
constexpr const char* kWaitingStep = "waiting step";

}  // namespace

void Session::setStep(const std::optional<ShownStep>& step) {
    if (step == m_step) return;
    m_step = step;
    delete findChild<QObject*>(QLatin1String(kWaitingStep), Qt::FindDirectChildrenOnly);
    update();
    const std::vector<int> views = shownViews();
    const bool drawn = step && pictures() && std::ranges::any_of(views, [this](int view) {
                           return stepOf(view) != nullptr && viewRequest(view) && !pictures()->isCurrent(view);
                       });
    if (!drawn) {
        emit stepChanged();
        return;
    }
    // Panels follow the picture: painted before it, the window would be composed twice, and the picture would wait for it.
    auto* waiting = new QObject(this);
    waiting->setObjectName(QLatin1String(kWaitingStep));
    const auto tell = [this, waiting] {
        if (waiting->objectName().isEmpty()) return;  // told already
        waiting->setObjectName(QString());
        waiting->deleteLater();
        emit stepChanged();
    };
    connect(this, &Session::pictureChanged, waiting, [this, waiting, tell](int view) {
        // After the events of painting, which are posted by now.
        if (stepOf(view) != nullptr && pictures()->isCurrent(view)) QTimer::singleShot(0, waiting, tell);
    });
    QTimer::singleShot(kLongestWait, waiting, tell);
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
