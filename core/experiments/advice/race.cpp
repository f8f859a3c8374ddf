#include "core/experiments/advice/race.h"

#include <algorithm>
#include <bit>

#include "core/base/error.h"
#include "core/measure/render_frame.h"

namespace cullscope::advice {

Deadline::Deadline(double seconds, const std::stop_token& whole)
    : m_whole(whole, [this] { m_stop.request_stop(); }), m_clock([this, seconds](const std::stop_token& ended) {
          std::unique_lock lock(m_mutex);
          const auto over = std::chrono::duration<double>(std::min(seconds, 1e6));
          // False where the time is over and the work has not ended.
          if (!m_wake.wait_for(lock, ended, over, [&] { return ended.stop_requested(); }) && !ended.stop_requested()) {
              m_passed = true;
              m_stop.request_stop();
          }
      }) {}

Race::Race(const AdviseRequest& request, const Progress& progress)
    : m_request(request),
      m_progress(progress),
      m_gl(requireOpenGl45()),
      m_buffers(std::make_shared<const SceneBuffers>(request.scene, request.upload)),
      m_target(request.size) {}

std::optional<double> Race::draw(Entrant& entrant, size_t pose, double seconds) {
    const Deadline deadline(seconds, m_progress.stop);
    const ViewStatePointer memory = entrant.built->begin();
    try {
        double milliseconds = 0.0;
        const size_t before = entrant.built->info().remembers && pose > 0 ? 1 : 0;
        for (size_t back = before + 1; back-- > 0;) {
            FrameResult frame =
                renderFrame(m_renderer, *m_buffers, *entrant.built, *memory, viewOf(pose - back), m_target, {}, deadline.token());
            milliseconds = frame.frameMilliseconds;
            m_log = std::move(frame.log);
            ++m_frames;
        }
        return milliseconds;
    } catch (const Error& error) {
        m_progress.check();
        entrant.racing = entrant.eligible = false;
        if (deadline.passed()) {
            entrant.figures.standing = Standing::FarBehind;
        } else {
            entrant.figures.standing = Standing::Refused;
            entrant.figures.why = error.message();
        }
        return std::nullopt;
    }
}

void Race::judge(Entrant& entrant, size_t pose) {
    if (entrant.judged[pose]) return;
    if (pose != m_shownPose) m_references.clear();
    m_shownPose = pose;
    const auto truth = m_references.of(m_renderer, *m_buffers, viewOf(pose), entrant.built->referenceFacing());
    const JudgedFrame judged = cullscope::judge(m_renderer, *m_buffers, m_log, *truth, m_target);
    entrant.judged[pose] = true;
    AdvisedStrategy& figures = entrant.figures;
    ++figures.judgedViews;
    figures.coveredPixels += judged.accuracy.coveredPixels;
    figures.lostPixels += judged.lostPixels();
    if (judged.lostPixels() > 0) ++figures.viewsWithLoss;
}

std::vector<size_t> spreadOrder(size_t n) {
    std::vector<size_t> order;
    const size_t places = std::bit_ceil(n);
    const int digits = std::countr_zero(places);
    for (size_t i = 0; i < places; ++i) {
        size_t mirrored = 0;
        for (int digit = 0; digit < digits; ++digit)
            if ((i >> digit & 1u) != 0) mirrored |= size_t(1) << (digits - 1 - digit);
        if (mirrored < n) order.push_back(mirrored);
    }
    return order;
}

RatioEstimate ratioBetween(const std::vector<std::vector<double>>& baseline, const std::vector<std::vector<double>>& subject) {
    std::vector<ViewTimes> views;
    for (size_t pose = 0; pose < std::min(baseline.size(), subject.size()); ++pose)
        if (!baseline[pose].empty() && !subject[pose].empty()) views.push_back({baseline[pose], subject[pose]});
    return ratioOfTotals(views);
}

}  // namespace cullscope::advice
