// When the session measures which views, and which metrics are still valid.
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

std::optional<MetricsSubject> Session::subject(int view) const {
    const SceneBuffersPointer& uploaded = buffers(setup(view).upload);
    const BuiltStrategyPointer& built = slot(view).built();
    Viewport size = setup(view).role == Role::Frozen ? setup(view).cullingSize.value_or(renderSize(view)) : renderSize(view);
    // A view that was never shown takes the size of its observer.
    for (int other = 0; other < kMostViews && size.width < 1; ++other)
        if (shown(other) && culledBy(other) == view) size = renderSize(other);
    if (!uploaded || !built || built->scenePointer() != uploaded->scenePointer() || size.width < 1 || size.height < 1)
        return std::nullopt;
    return MetricsSubject{uploaded, built, cullingCamera(view), size, m_views[size_t(view)].turn};
}

ViewMetrics Session::figuresWithoutMeasuring() const {
    ViewMetrics figures;
    figures.state = m_opened ? ViewMetrics::State::Stale : ViewMetrics::State::Nothing;
    if (!uploadFailure().empty()) {
        figures.state = ViewMetrics::State::Failed;
        figures.failure = uploadFailure();
    }
    return figures;
}

bool Session::figuresStand(int view) const {
    const ViewMetrics& known = m_views[size_t(view)].figures;
    // A strategy that cannot be built has no metrics; the failure stays until another strategy is chosen.
    if (known.state == ViewMetrics::State::Failed && !slot(view).built() && m_opened && uploadFailure().empty()) return true;
    if (known.state != ViewMetrics::State::Ready && known.state != ViewMetrics::State::Failed) return false;
    const std::optional<MetricsSubject> now = subject(view);
    return now && !slot(view).building() && known.subject == *now;
}

void Session::updateFigures() {
    const bool overtaken = std::any_of(m_underWay.begin(), m_underWay.end(), [this](const ViewMeter::Subject& measured) {
        return subject(measured.view) != measured.what || slot(measured.view).building();
    });
    if (overtaken) cancelFigures();
    const std::vector<int> measured = measuredViews();
    for (int view = 0; view < kMostViews; ++view) {
        if (figuresStand(view)) continue;
        const ViewMetrics next = figuresWithoutMeasuring();
        if (m_views[size_t(view)].figures.state != next.state) setFigures(view, next);
        const bool begun = std::any_of(m_underWay.begin(), m_underWay.end(),
                                       [view](const ViewMeter::Subject& subject) { return subject.view == view; });
        if (!begun && std::find(measured.begin(), measured.end(), view) != measured.end()) m_rest.start();
    }
}

void Session::cancelFigures() {
    if (m_meter) m_meter->cancel();
    m_underWay.clear();
}

void Session::setFigures(int view, const ViewMetrics& figures) {
    m_views[size_t(view)].figures = figures;
    emit metricsChanged(view);
}

void Session::requestFigures() { measure(true); }

void Session::setMeasuring(bool measuring) {
    m_measuring = measuring;
    if (!m_meter) return;
    cancelFigures();
    if (measuring) m_rest.start();
}

void Session::measure(bool asked) {
    if (!m_meter || !m_opened || !m_measuring) return;
    comeToRest();
    // The figures are those of the frame that stays.
    if (letSettle()) return;
    const bool large = m_scene->triangleCount() > kOptionalAnalysisLimit;
    std::vector<ViewMeter::Subject> subjects;
    for (const int view : measuredViews()) {
        const std::optional<MetricsSubject> now = subject(view);
        const ViewMetrics& known = m_views[size_t(view)].figures;
        if (!now || slot(view).building() || (known.timed && known.subject == *now)) continue;
        if (large && !asked) {
            ViewMetrics waiting;
            waiting.state = ViewMetrics::State::OnRequest;
            if (known.state != waiting.state) setFigures(view, waiting);
            continue;
        }
        if (known.state == ViewMetrics::State::OnRequest) setFigures(view, figuresWithoutMeasuring());
        subjects.push_back({view, *now});
    }
    if (subjects.empty()) return;
    addTimedViews(subjects);
    m_underWay = subjects;
    m_meter->measure(std::move(subjects));
}

void Session::addTimedViews(std::vector<ViewMeter::Subject>& subjects) const {
    const size_t due = subjects.size();
    for (const int view : measuredViews()) {
        const std::optional<MetricsSubject> now = subject(view);
        const ViewMetrics& known = m_views[size_t(view)].figures;
        // What a frozen view shows stays.
        if (!now || setup(view).role == Role::Frozen || !known.timed || known.subject != *now) continue;
        const bool besideOne = std::any_of(subjects.begin(), subjects.begin() + std::ptrdiff_t(due), [&](const auto& other) {
            return other.view != view && other.what.culling == now->culling && other.what.size == now->size;
        });
        if (besideOne) subjects.push_back({view, *now, std::make_shared<const ViewMetrics>(known)});
    }
}

bool Session::metricsSettled() const {
    for (const int view : measuredViews()) {
        const ViewMetrics& known = figures(view);
        if (known.state == ViewMetrics::State::Stale || (known.state == ViewMetrics::State::Ready && !known.timed)) return false;
    }
    return true;
}

}  // namespace cullscope::ui
