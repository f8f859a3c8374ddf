#include "core/measure/view_rounds.h"

#include <algorithm>

#include "core/measure/field_figures.h"
#include "core/measure/statistics.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

bool sameWork(const TimedFrames& a, const TimedFrames& b) {
    return a.buffers == b.buffers && a.view.camera() == b.view.camera() && a.view.viewport() == b.view.viewport() &&
           a.strategy->id() == b.strategy->id() && a.strategy->parameters() == b.strategy->parameters();
}

/// The number of that work among those that are timed, which it joins if it is not there yet.
size_t joined(std::vector<TimedFrames>& timed, TimedFrames work) {
    for (size_t i = 0; i < timed.size() && !work.strategy->info().remembers; ++i)
        if (sameWork(timed[i], work)) return i;
    timed.push_back(std::move(work));
    return timed.size() - 1;
}

/// What is known of a view that shows a frame when its first timed frame is judged.
ViewFigures figuresOf(const ViewSubject& subject, const FrameLog& timed, const JudgedFrame& judged, const Reference& truth) {
    const Scene& scene = subject.buffers->scene();
    ViewFigures figures;
    figures.promise = subject.strategy->promiseAt(subject.view);
    figures.cullMilliseconds = timed.cullMilliseconds;
    figures.submitted = submittedBy(scene, timed);
    figures.consideredTriangles = timed.consideredTriangles();
    figures.sceneTriangles = scene.triangleCount();
    figures.size = subject.view.viewport();
    figures.truthFacing = truth.facing;
    figures.accuracy = judged.accuracy;
    figures.missedBeyondSnapping = judged.missedBeyondSnapping;
    if (figures.lostPixels() < figures.accuracy.missedPixels)
        figures.lost = std::make_shared<const std::vector<uint32_t>>(judged.lost);
    figures.states =
        std::make_shared<const TriangleStates>(triangleStates(scene, *subject.shown, truth.visible(), judged.lostTriangles));
    figures.lostObjects = lostObjects(scene, truth, judged.lost);
    figures.holes = figures.lostPixels() > 0 ? judged.holes(truth.size) : holes(missedMask(truth, judged.shown), truth.size);
    return figures;
}

}  // namespace

ViewRounds::ViewRounds(std::vector<ViewSubject> subjects, const TimingProtocol& protocol, bool backwards)
    : m_subjects(std::move(subjects)), m_judged(m_subjects.size()), m_further(m_subjects.size()), m_figures(m_subjects.size()) {
    std::vector<TimedFrames> timed;
    for (ViewSubject& subject : m_subjects) {
        TimedFrames work{subject.buffers.get(), subject.strategy, subject.view, std::move(subject.memories),
                         subject.shown != nullptr};
        work.others = subject.others;
        if (subject.shown) {
            m_places.push_back({joined(timed, std::move(work))});
        } else {
            // The memories of its frames go on to the next view: they are its own.
            m_places.push_back({timed.size()});
            timed.push_back(std::move(work));
        }
    }
    for (size_t i = 0; i < m_subjects.size(); ++i) {
        const ViewSubject& subject = m_subjects[i];
        const auto beside = [&](const BuiltStrategyPointer& baseline) -> std::optional<size_t> {
            if (!baseline) return std::nullopt;
            TimedFrames work{subject.buffers.get(), baseline, subject.view, {}};
            work.memories.push_back(baseline->begin());
            return joined(timed, std::move(work));
        };
        m_places[i].baseline = beside(subject.baseline);
        m_places[i].frontFaces = beside(subject.frontFaces);
        m_places[i].limit = beside(subject.limit);
        m_places[i].baselineOfLimit = beside(subject.baselineOfLimit);
    }
    m_rounds = std::make_unique<TimedRounds>(std::move(timed), protocol, backwards);
}

std::optional<size_t> ViewRounds::toJudge(bool shown) const {
    for (size_t i = 0; i < m_subjects.size(); ++i)
        if (m_subjects[i].judged && !m_judged[i] && (m_subjects[i].shown != nullptr) == shown && !dropped(i)) return i;
    return std::nullopt;
}

size_t ViewRounds::next() const {
    const auto drawn = std::ranges::find(m_places, m_rounds->next(), &Place::own);
    return size_t(drawn - m_places.begin());
}

bool ViewRounds::complete() const { return m_rounds->complete() && !toJudge(true) && !toJudge(false); }

std::optional<size_t> ViewRounds::step(Renderer& renderer, References& references, const TimedRounds::TargetOf& targetOf,
                                       const std::stop_token& stop) {
    std::optional<size_t> next = m_rounds->counted() ? toJudge(true) : std::nullopt;
    if (!next && !m_rounds->complete()) {
        m_rounds->step(renderer, targetOf, stop);
        return std::nullopt;
    }
    if (!next) next = toJudge(false);
    if (next) judgeNow(*next, renderer, references, targetOf);
    return next;
}

void ViewRounds::judgeNow(size_t subject, Renderer& renderer, References& references, const TimedRounds::TargetOf& targetOf) {
    const ViewSubject& what = m_subjects[subject];
    const FrameLog& log = timed(m_places[subject].own).log;
    const auto truth = references.of(renderer, *what.buffers, what.view, what.strategy->referenceFacing());
    JudgedFrame judged = judge(renderer, *what.buffers, log, *truth, targetOf(what.view.viewport(), 0));
    if (what.shown) m_figures[subject] = figuresOf(what, log, judged, *truth);
    if (!what.shown) {
        const Accuracy& errors = judged.accuracy;
        m_further[subject].lostObjects = lostObjects(what.buffers->scene(), *truth, judged.lost);
        // Where every pixel shows the surface that is truly there, the shaded pictures are equal.
        if (judged.ownRaster || errors.missedPixels + errors.extraPixels > 0)
            m_further[subject].pictureDifferences =
                pictureDifferences(renderer, *what.buffers, log, *truth, targetOf(what.view.viewport(), 0));
    }
    judged.shown = {};
    m_judged[subject] = std::move(judged);
}

void ViewRounds::addTimes(size_t subject, ViewFigures& figures) const {
    const FrameMeasurement own = measurementOf(timed(m_places[subject].own));
    figures.frameMilliseconds = own.frameMilliseconds;
    figures.cullMilliseconds = own.cullMilliseconds;
    figures.frameTimes = own.frameTimes;
    figures.timed = true;
    const auto over = [&](const std::optional<size_t>& place) -> std::optional<RatioEstimate> {
        if (!place) return std::nullopt;
        const FrameMeasurement baseline = measurementOf(timed(*place));
        return ratioOver({&baseline, 1}, {&own, 1});
    };
    figures.speedup = over(m_places[subject].baseline);
    figures.speedupOverFrontFaces = over(m_places[subject].frontFaces);
    if (const BuiltStrategyPointer& baseline = m_subjects[subject].baseline)
        figures.baseline = strategyLabel({baseline->id(), baseline->parameters()});
    figures.headroom = headroom(subject, own);
}

std::optional<ViewHeadroom> ViewRounds::headroom(size_t subject, const FrameMeasurement& own) const {
    const Place& place = m_places[subject];
    if (!place.baseline || !place.limit || !place.baselineOfLimit) return std::nullopt;
    const FrameMeasurement baseline = measurementOf(timed(*place.baseline)), limit = measurementOf(timed(*place.limit)),
                           baselineOfLimit = measurementOf(timed(*place.baselineOfLimit));
    const TimesBesideLimit times{baseline.frameTimes, own.frameTimes, baselineOfLimit.frameTimes, limit.frameTimes};
    const BuiltStrategy& compared = *m_subjects[subject].baselineOfLimit;
    return ViewHeadroom{ratioOver({&baselineOfLimit, 1}, {&limit, 1}), strategyLabel({compared.id(), compared.parameters()}),
                        shareOfHeadroom({&times, 1})};
}

FrameMeasurement ViewRounds::measurement(size_t subject) const {
    FrameMeasurement figures = measurementOf(timed(m_places[subject].own));
    if (!m_judged[subject]) return figures;
    addLosses(figures, *m_judged[subject], m_further[subject].lostObjects);
    figures.pictureDifferences = m_further[subject].pictureDifferences;
    return figures;
}

std::vector<uint32_t> ViewRounds::takeLost(size_t subject) {
    return m_judged[subject] ? std::move(m_judged[subject]->lost) : std::vector<uint32_t>();
}

std::vector<ViewStatePointer> ViewRounds::takeMemories(size_t subject) {
    return m_rounds->entrants()[m_places[subject].own].takeMemories();
}

}  // namespace cullscope
