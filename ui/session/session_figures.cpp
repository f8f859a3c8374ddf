// When the session measures what, and which figures still stand.
#include "ui/session/session.h"

#include <algorithm>

namespace cullscope::ui {

std::vector<int> Session::measuredViews() const {
    std::vector<int> views;
    for (const int view : shownViews())
        if (setup(view).panel.empty()) views.push_back(culledBy(view));
    std::sort(views.begin(), views.end());
    views.erase(std::unique(views.begin(), views.end()), views.end());
    return views;
}

std::optional<FigureSubject> Session::subject(int view) const {
    const SceneBuffersPointer& uploaded = buffers(setup(view).upload);
    const BuiltStrategyPointer& built = slot(view).built();
    Viewport size = setup(view).role == Role::Frozen ? setup(view).cullingSize.value_or(renderSize(view)) : renderSize(view);
    // A view that was never shown has the size of the one that watches it.
    for (int other = 0; other < kMostViews && size.width < 1; ++other)
        if (shown(other) && culledBy(other) == view) size = renderSize(other);
    if (!uploaded || !built || built->scene != uploaded->scenePointer() || size.width < 1 || size.height < 1) return std::nullopt;
    return FigureSubject{uploaded, built, cullingCamera(view), size};
}

Figures Session::figuresWithoutMeasuring() const {
    Figures figures;
    figures.state = m_opened ? Figures::State::Stale : Figures::State::Nothing;
    if (!uploadFailure().empty()) {
        figures.state = Figures::State::Failed;
        figures.failure = uploadFailure();
    }
    return figures;
}

bool Session::figuresStand(int view) const {
    const Figures& known = m_views[size_t(view)].figures;
    // What cannot be built has no figures, and that is said until it is chosen anew.
    if (known.state == Figures::State::Failed && !slot(view).built() && m_opened && uploadFailure().empty()) return true;
    if (known.state != Figures::State::Ready && known.state != Figures::State::Failed) return false;
    const std::optional<FigureSubject> now = subject(view);
    return now && !slot(view).building() && known.subject == *now;
}

void Session::updateFigures() {
    const bool overtaken = std::any_of(m_underWay.begin(), m_underWay.end(), [this](const FigureMeter::Subject& measured) {
        return subject(measured.view) != measured.what || slot(measured.view).building();
    });
    if (overtaken) {
        m_meter->cancel();
        m_underWay.clear();
    }
    const std::vector<int> measured = measuredViews();
    for (int view = 0; view < kMostViews; ++view) {
        if (figuresStand(view)) continue;
        const Figures next = figuresWithoutMeasuring();
        if (m_views[size_t(view)].figures.state != next.state) setFigures(view, next);
        const bool begun = std::any_of(m_underWay.begin(), m_underWay.end(),
                                       [view](const FigureMeter::Subject& subject) { return subject.view == view; });
        if (!begun && std::find(measured.begin(), measured.end(), view) != measured.end()) m_rest.start();
    }
}

void Session::setFigures(int view, const Figures& figures) {
    m_views[size_t(view)].figures = figures;
    emit figuresChanged(view);
}

void Session::requestFigures() { measure(true); }

void Session::setMeasuring(bool measuring) {
    m_measuring = measuring;
    if (!m_meter) return;
    m_meter->cancel();
    m_underWay.clear();
    if (measuring) m_rest.start();
}

void Session::measure(bool asked) {
    if (!m_meter || !m_opened || !m_measuring) return;
    const bool large = m_scene->triangleCount() > kOptionalAnalysisLimit;
    std::vector<FigureMeter::Subject> subjects;
    for (const int view : measuredViews()) {
        const std::optional<FigureSubject> now = subject(view);
        const Figures& known = m_views[size_t(view)].figures;
        if (!now || slot(view).building() || (known.timed && known.subject == *now)) continue;
        if (large && !asked) {
            Figures waiting;
            waiting.state = Figures::State::OnRequest;
            if (known.state != waiting.state) setFigures(view, waiting);
            continue;
        }
        if (known.state == Figures::State::OnRequest) setFigures(view, figuresWithoutMeasuring());
        subjects.push_back({view, *now});
    }
    if (subjects.empty()) return;
    m_underWay = subjects;
    m_meter->measure(std::move(subjects));
}

bool Session::figuresSettled() const {
    for (const int view : measuredViews()) {
        const Figures& known = figures(view);
        if (known.state == Figures::State::Stale || (known.state == Figures::State::Ready && !known.timed)) return false;
    }
    return true;
}

}  // namespace cullscope::ui
