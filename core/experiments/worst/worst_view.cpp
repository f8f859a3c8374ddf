#include "core/experiments/worst/worst_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/measure/single_frames.h"
#include "core/measure/statistics.h"
#include "core/scene/tour.h"

namespace cullscope::worst {
namespace {

constexpr std::array kCoarseParts{30.0, 45.0, 60.0, 90.0, 180.0};  // degrees, of the coarse grid
constexpr size_t kPlaces = 16, kAzimuths = 8;                      // inside
constexpr size_t kRefined = 6;                                     // parts in a step
constexpr size_t kConfirmedViews = 5;                              // the worst of a search for the least gain
constexpr int kConfirmingTurns = 5;                                // times the repetitions of the search
constexpr double kLeastPart = 1.0;                                 // degrees: smaller parts are not divided
constexpr double kMostElevation = 90.0, kInsideElevation = 30.0;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// The direction at degrees of azimuth and elevation: azimuth 0 along +z, 90 along +x, with y up; where z is up, 0 along -y.
Vec3 directionAt(const Scene& scene, double azimuth, double elevation) {
    const double a = radians(azimuth), e = radians(elevation);
    if (scene.upAxis() == UpAxis::Z) return {std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e)};
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

class Search {
public:
    Search(const WorstRequest& request, const Progress& progress)
        : m_request(request), m_progress(progress), m_frames(request.scene, Upload::Vbo, request.size) {
        m_result.request = request;
        m_result.gl = requireOpenGl45();
        requireAvailable(strategyOf(request.strategy).info, m_result.gl);
    }

    WorstResult run() {
        try {
            prepare();
            coarse();
            while (refine()) {
            }
            findWorst();
            if (m_request.of == Of::Ratio) confirm();
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) throw;
            m_result.interrupted = true;
            findWorst();
        }
        return std::move(m_result);
    }

private:
    void prepare() {
        const Scene& scene = *m_request.scene;
        m_built = buildStrategy(strategyOf(m_request.strategy), m_request.strategy.parameters, m_request.scene, m_structures,
                                m_progress.part(0.0, 0.1));
        const StrategyRequest baseline = baselineUnder(m_built->facing());
        m_baseline = buildStrategy(strategyOf(baseline), baseline.parameters, m_request.scene, m_structures);
        if (!m_request.inside) {
            m_result.lens = cameraPath("fibonacci:1", scene);
        } else {
            // Few views look all around from fewer places.
            const size_t places = std::clamp(m_request.views / kAzimuths, size_t(1), kPlaces);
            m_result.lens = tour(scene, places, m_progress.part(0.1, 0.2));
            for (const CameraPath::Pose& pose : m_result.lens.poses) m_places.push_back(pose.eye);
        }
        m_result.lens.poses.clear();
        m_result.lens.name = "worst";
    }

    void coarse() {
        if (m_request.inside) {
            const size_t azimuths = std::min(kAzimuths, m_request.views);
            for (size_t place = 0; place < m_places.size(); ++place)
                for (size_t i = 0; i < azimuths; ++i) {
                    const double width = 360.0 / double(azimuths), left = -180.0 + width * double(i);
                    tryView(left, left + width, -kInsideElevation, kInsideElevation, place);
                }
            return;
        }
        const auto [width, height] = coarsePart();
        for (double bottom = -kMostElevation; bottom < kMostElevation; bottom += height)
            for (double left = -180.0; left < 180.0; left += width) tryView(left, left + width, bottom, bottom + height, 0);
    }

    /// Width and height of the smallest parts of which the views cover the whole sphere.
    [[nodiscard]] std::pair<double, double> coarsePart() const {
        for (const double part : kCoarseParts)
            if (360.0 / part * (180.0 / part) <= double(m_request.views)) return {part, part};
        return {360.0, 180.0};
    }

    /// Divides the worst parts; false: there is nothing more to try.
    bool refine() {
        std::vector<size_t> parts;
        for (size_t i = 0; i < m_result.views.size(); ++i)
            if (const TriedView& view = m_result.views[i]; view.replaced == 0 && view.right - view.left > kLeastPart)
                parts.push_back(i);
        std::ranges::stable_sort(parts, [&](size_t one, size_t other) {
            return m_result.worse(m_result.views[one].value, m_result.views[other].value);
        });
        // Where nothing is lost anywhere so far, the rest of the views goes over the whole sphere, evenly.
        if (m_request.of == Of::Missed && !parts.empty() && m_result.views[parts.front()].value == 0.0)
            std::ranges::stable_sort(parts, std::greater(), [&](size_t i) {
                const TriedView& view = m_result.views[i];
                return (view.right - view.left) * std::cos(radians(view.elevation()));
            });
        const size_t before = m_result.views.size();
        for (size_t i = 0; i < std::min(kRefined, parts.size()) && m_result.views.size() + 4 <= m_request.views; ++i)
            divide(parts[i]);
        return m_result.views.size() > before;
    }

    void divide(size_t number) {
        const TriedView whole = m_result.views[number];
        const double x = whole.azimuth(), y = whole.elevation();
        tryView(whole.left, x, whole.bottom, y, whole.place);
        tryView(x, whole.right, whole.bottom, y, whole.place);
        tryView(whole.left, x, y, whole.top, whole.place);
        tryView(x, whole.right, y, whole.top, whole.place);
        m_result.views[number].replaced = 4;
    }

    void tryView(double left, double right, double bottom, double top, size_t place) {
        if (m_result.views.size() >= m_request.views) return;
        m_progress.check();
        m_progress.tell(0.2 + 0.8 * double(m_result.views.size()) / double(m_request.views), CULLSCOPE_TR("trying views"));
        TriedView view{left, right, bottom, top, place};
        const Scene& scene = *m_request.scene;
        const Vec3 direction = directionAt(scene, view.azimuth(), view.elevation());
        const Vec3 up = scene.upAxis() == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
        if (m_request.inside) {
            view.pose = {m_places[place], m_places[place] + direction * scene.boundingSphere().radius, up};
        } else {
            const Sphere around = scene.boundingSphere();
            view.pose = {around.centre + direction * around.radius * m_request.distance, around.centre, up};
        }
        measure(view);
        m_result.views.push_back(view);
    }

    [[nodiscard]] Camera cameraOf(const CameraPath::Pose& pose) const {
        CameraPath one = m_result.lens;
        one.poses = {pose};
        Camera camera = one.camera(0);
        if (!m_request.inside) fitDepthRange(camera, *m_request.scene);
        return camera;
    }

    void findWorst() {
        for (size_t i = 0; i < m_result.views.size(); ++i)
            if (m_result.worse(m_result.views[i].value, m_result.views[m_result.worst].value)) m_result.worst = i;
    }

    /// Draws the few worst views anew, and takes the worst one by these frames.
    void confirm() {
        std::vector<size_t> order(m_result.views.size());
        std::iota(order.begin(), order.end(), size_t(0));
        std::ranges::stable_sort(order, {}, [&](size_t i) { return m_result.views[i].value; });
        order.resize(std::min(order.size(), kConfirmedViews));
        std::optional<RatioEstimate> least;
        for (const size_t i : order) {
            const View view(cameraOf(m_result.views[i].pose), m_request.size);
            const RatioEstimate again = ratioOfTotals(std::array{timesAt(view, kConfirmingTurns * m_request.repetitions)});
            if (least && least->ratio <= again.ratio) continue;
            least = again;
            m_result.worst = i;
        }
        m_result.confirmed = least;
    }

    /// The strategy and the baseline in turns, the order changing; a turn before them is not counted.
    ViewTimes timesAt(const View& view, int repetitions) {
        ViewTimes times;
        for (int turn = -1; turn < repetitions; ++turn)
            for (const bool first : {turn % 2 == 0, turn % 2 != 0}) {
                const double time = draw(first ? *m_built : *m_baseline, view).milliseconds;
                if (turn >= 0) (first ? times.subject : times.baseline).push_back(time);
            }
        return times;
    }

    void measure(TriedView& tried) {
        const View view(cameraOf(tried.pose), m_request.size);
        if (m_request.of == Of::Ratio) {
            const ViewTimes times = timesAt(view, m_request.repetitions);
            tried.value = quantile(times.baseline, 0.5) / quantile(times.subject, 0.5);
            return;
        }
        const FrameLog log = draw(*m_built, view).log;
        const JudgedFrame judged = m_frames.judge(*m_built, log);
        tried.lostPixels = judged.lostPixels();
        tried.coveredPixels = judged.accuracy.coveredPixels;
        tried.value = tried.coveredPixels == 0 ? 0.0 : double(tried.lostPixels) / double(tried.coveredPixels);
    }

    // Without a past: the worst view must be found again by itself.
    SingleFrames::Frame draw(const BuiltStrategy& strategy, const View& view) {
        return m_frames.draw(strategy, view, nullptr, m_progress.stop);
    }

    const WorstRequest& m_request;
    const Progress& m_progress;
    SingleFrames m_frames;
    StructureStore m_structures;
    BuiltStrategyPointer m_built, m_baseline;
    std::vector<Vec3> m_places;
    WorstResult m_result;
};

}  // namespace

CameraPath WorstResult::path(size_t most) const {
    std::vector<size_t> order(views.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::ranges::stable_sort(order, [&](size_t one, size_t other) {
        if (one == worst || other == worst) return one == worst && other != worst;
        return worse(views[one].value, views[other].value);
    });
    CameraPath path = lens;
    for (size_t i = 0; i < std::min(most, order.size()); ++i) path.poses.push_back(views[order[i]].pose);
    return path;
}

const TriedView* WorstResult::at(const PlotPoint& point) const {
    const TriedView* found = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const TriedView& view : views) {
        if (!request.inside) {
            const bool within = point.x >= view.left && point.x < view.right && point.y >= view.bottom && point.y < view.top;
            if (view.replaced == 0 && within) return &view;
            continue;
        }
        const bool zUp = request.scene->upAxis() == UpAxis::Z;
        const Vec2 place(view.pose.eye.x, zUp ? view.pose.eye.y : -view.pose.eye.z);
        const double distance = glm::length(place - Vec2(point.x, point.y));
        if (distance < nearest || (distance == nearest && worse(view.value, found->value))) found = &view;
        nearest = std::min(nearest, distance);
    }
    return found;
}

WorstResult worstView(const WorstRequest& request, const Progress& progress) {
    if (request.scene->triangleCount() == 0) throwUsage(CULLSCOPE_TR("The scene has no triangles: there is nothing to measure."));
    return Search(request, progress).run();
}

}  // namespace cullscope::worst
