// Stepped views of the session, and views whose question is open.
#include <algorithm>

#include "ui/session/session.h"

namespace cullscope::ui {

namespace {

constexpr int kPainting = 1;  // ms of a timer that elapses once the window was painted
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
    // Panels follow the picture, which would wait for them: to paint a map takes longer than the picture.
    auto* waiting = new QObject(this);
    waiting->setObjectName(QLatin1String(kWaitingStep));
    const auto tell = [this, waiting] {
        if (waiting->objectName().isEmpty()) return;  // told already
        waiting->setObjectName(QString());
        waiting->deleteLater();
        emit stepChanged();
    };
    connect(this, &Session::pictureChanged, waiting, [this, waiting, tell](int view) {
        // Events of painting are posted by now and come before timers. With 0 ms it would be an event that comes before them.
        if (stepOf(view) != nullptr && pictures()->isCurrent(view)) QTimer::singleShot(kPainting, waiting, tell);
    });
    QTimer::singleShot(m_waitForStep, waiting, tell);
}

bool Session::stepAwaitsPicture() const {
    return findChild<QObject*>(QLatin1String(kWaitingStep), Qt::FindDirectChildrenOnly) != nullptr;
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

void Session::nameIn(int view, const PictureTile& within) {
    const std::optional<ViewRequest> request = viewRequest(view);
    if (!request || !m_question || m_question->of == Prediction::Items::Parts || within.size.width < 1 || within.size.height < 1)
        return;
    m_pictures->pickIn(*request, within, [this, request = *request](const std::vector<uint64_t>& shown) {
        // As where a single place is looked up.
        if (m_scene != request.buffers->scenePointer() || !m_question || m_question->of == Prediction::Items::Parts) return;
        std::vector<uint64_t> items = shown;
        if (m_question->of == Prediction::Items::Objects) {
            for (uint64_t& item : items) item = m_scene->instanceOf(item);
            items.erase(std::unique(items.begin(), items.end()), items.end());
        }
        Prediction named = *m_question;
        if (!items.empty()) named.toggle(items);
        setQuestion(named);
    });
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
    request.lost = nullptr;
}

}  // namespace cullscope::ui
