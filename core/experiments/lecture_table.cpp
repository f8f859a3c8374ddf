#include "core/experiments/lecture_table.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/experiments/run_rows.h"
#include "core/measure/accuracy.h"
#include "core/measure/statistics.h"
#include "core/measure/timed_rounds.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char* kOverlap = "overlap";
constexpr const char* kSurfaces = "surfaces";
constexpr const char* kViews = "views";

/// For what the lecture recommends a method.
struct Method {
    const char* id;
    bool littleOverlap = false, someOverlap = false, fewSurfaces = false, manySurfaces = false, manyViews = false;
    bool onGpu = false;  ///< draws with OpenGL's depth test: its depth buffer counts as memory
    bool ranked = true;  ///< among those that the verdicts compare
};
constexpr std::array kMethods{Method{.id = "painter", .littleOverlap = true, .fewSurfaces = true},
                              Method{.id = "bsp", .littleOverlap = true, .fewSurfaces = true, .manyViews = true},
                              Method{.id = "octree-query", .manySurfaces = true, .onGpu = true},
                              Method{.id = "depth-buffer", .manySurfaces = true},
                              Method{.id = "scan-line", .someOverlap = true, .fewSurfaces = true},
                              Method{.id = "all", .onGpu = true, .ranked = false},
                              Method{.id = "backface", .onGpu = true, .ranked = false}};

// ---- The lecture's verdicts

constexpr double kLittleOverlap = 1, kSomeOverlap = 2, kFewSurfaces = 10, kManySurfaces = 100'000, kManyViews = 100;

/// Why the lecture recommends a method for a setting; empty: it does not.
std::string verdict(const Method& method, const Setting& setting) {
    const double overlap = setting.number(kOverlap), surfaces = setting.number(kSurfaces);
    std::string reasons;
    const auto add = [&](bool holds, const char* reason) {
        if (holds) reasons += (reasons.empty() ? "" : ", ") + std::string(reason);
    };
    add(method.littleOverlap && overlap <= kLittleOverlap, "very little overlap");
    add(method.someOverlap && overlap == kSomeOverlap, "little overlap");
    add(method.fewSurfaces && surfaces <= kFewSurfaces, "few surfaces");
    add(method.manySurfaces && surfaces >= kManySurfaces, "many surfaces");
    add(method.manyViews && setting.number(kViews) >= kManyViews, "many views");
    return reasons;
}

constexpr double kAsGoodAs = 1.25;  // of the least time

/// What the measurement says to the verdict. `times`: of the least time of the ranked methods; 0: the method could not serve.
const char* agreement(bool recommended, bool anyRecommended, double times) {
    if (recommended) return times > 0.0 && times <= kAsGoodAs ? "agrees" : "disagrees: slower";
    return anyRecommended && times > 0.0 && times <= 1.0 ? "disagrees: fastest" : "";
}

// ---- What is measured

/// One method at one setting.
class Entrant {
public:
    Entrant(const Method& method, const ScenePointer& scene, StructureStore& structures, const Progress& progress)
        : m_method(method) {
        try {
            const StrategyRequest request = strategyFromText(method.id);
            requireAvailable(strategyOf(request).info, requireOpenGl45());
            m_built = buildStrategy(strategyOf(request), request.parameters, scene, structures, progress);
            m_memories.push_back(m_built->begin());
        } catch (const Error& error) {
            fail(error);
        }
    }

    [[nodiscard]] const Method& method() const { return m_method; }
    [[nodiscard]] const BuiltStrategyPointer& built() const { return m_built; }
    /// Why it cannot serve the setting; empty: it can.
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// The newest frame that was timed.
    [[nodiscard]] const FrameLog& log() const { return m_log; }

    /// What a method refuses, such as more fragments than its limit, is what its cells say.
    void fail(const Error& error) {
        if (error.kind() == ErrorKind::Interrupted) throw;
        m_failure = error.message().english();
    }
    [[nodiscard]] TimedFrames at(const View& view, const SceneBuffers& buffers) {
        return {&buffers, m_built, view, std::move(m_memories)};
    }
    /// What was timed at one more view.
    void add(TimedFrames timed) {
        m_memories = timed.takeMemories();
        m_viewsMilliseconds += quantile(timed.frameMilliseconds, 0.5);
        for (const double milliseconds : timed.frameMilliseconds) m_drawingMilliseconds += milliseconds;
        m_log = std::move(timed.log);
        ++m_views;
    }
    void giveUpAfter(double seconds, size_t views) {
        if (m_failure.empty() && m_views < views && m_drawingMilliseconds > 1000.0 * seconds)
            m_failure = "more than " + std::to_string(int(seconds)) + " s: " + std::to_string(m_views) + " of " +
                        std::to_string(views) + " views";
    }
    [[nodiscard]] double viewsMilliseconds() const { return m_viewsMilliseconds; }
    /// The structure, built once, and all views.
    [[nodiscard]] std::optional<double> total() const {
        if (!m_failure.empty()) return std::nullopt;
        return m_built->report().buildMilliseconds + m_viewsMilliseconds;
    }

private:
    const Method& m_method;
    BuiltStrategyPointer m_built;
    std::vector<ViewStatePointer> m_memories;
    std::string m_failure;
    FrameLog m_log;
    double m_drawingMilliseconds = 0.0, m_viewsMilliseconds = 0.0;
    size_t m_views = 0;
};

/// Times the methods at one view by the one protocol; every other view in reverse order. `missed`: gets, by method, the missed
/// pixels of the frames that were timed, beyond the raster's snapping where they were rasterised otherwise than the reference;
/// null: they are not counted.
void timeView(Renderer& renderer, Framebuffer& target, std::vector<Entrant>& entrants, const View& view,
              const SceneBuffers& buffers, const TimingProtocol& protocol, bool reverse, const Progress& progress,
              std::vector<double>* missed) {
    std::vector<size_t> numbers;
    for (size_t i = 0; i < entrants.size(); ++i)
        if (entrants[i].failure().empty()) numbers.push_back(i);
    if (reverse) std::ranges::reverse(numbers);
    std::vector<TimedFrames> frames;
    for (const size_t number : numbers) frames.push_back(entrants[number].at(view, buffers));
    TimedRounds rounds(std::move(frames), protocol);
    while (!rounds.complete()) {
        progress.check();
        try {
            rounds.step(
                renderer, [&](const Viewport&, size_t) -> Framebuffer& { return target; }, progress.stop);
        } catch (const Error& error) {
            entrants[numbers[rounds.next()]].fail(error);
            rounds.dropNext();
        }
    }
    References references;
    for (size_t i = 0; i < numbers.size(); ++i) {
        TimedFrames& timed = rounds.entrants()[i];
        if (timed.dropped) continue;
        if (missed != nullptr) {
            const auto truth = references.of(renderer, buffers, view, timed.strategy->referenceFacing());
            (*missed)[numbers[i]] = double(judge(renderer, buffers, timed.log, *truth, target).lostPixels());
        }
        entrants[numbers[i]].add(std::move(timed));
    }
}

/// Times all views.
void timeViews(std::vector<Entrant>& entrants, const SceneBuffers& buffers, const CameraPath& path, const LectureTableSize& size,
               const Progress& progress, std::vector<double>& missed) {
    const size_t views = path.poses.size();
    Renderer renderer;
    Framebuffer target(size.size);
    TimingProtocol protocol;
    protocol.fixedRepetitions = views > 1 ? 1 : size.repetitions;
    for (size_t pose = 0; pose < views; ++pose) {
        // Meshes are uploaded and programs compiled when they are first used.
        protocol.warmUp = pose == 0 ? 1 : 0;
        timeView(renderer, target, entrants, View(path.camera(pose), size.size), buffers, protocol, pose % 2 != 0, progress,
                 pose == 0 ? &missed : nullptr);
        for (Entrant& entrant : entrants) entrant.giveUpAfter(size.secondsOfAMethod, views);
        progress.tell(double(pose + 1) / double(views), CULLSCOPE_TR("measuring"));
    }
}

Rows methodRows(const Setting& setting, const ScenePointer& scene, const LectureTableSize& size, const Progress& progress) {
    constexpr double kBuilt = 0.3;
    constexpr double kDepthBytes = 4.0;
    StructureStore structures;
    std::vector<Entrant> entrants;
    for (const Method& method : kMethods) {
        progress.part(0.0, kBuilt).tell(double(entrants.size()) / double(kMethods.size()), CULLSCOPE_TR("building"));
        entrants.emplace_back(method, scene, structures, Progress{nullptr, progress.stop});
    }
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CameraPath path = cameraPath("front:" + std::to_string(int(setting.number(kViews))), *scene);
    std::vector<double> missed(entrants.size(), 0.0);
    timeViews(entrants, buffers, path, size, progress.part(kBuilt, 1.0), missed);

    std::optional<double> least;
    bool anyRecommended = false;
    for (const Entrant& entrant : entrants) {
        if (!entrant.method().ranked) continue;
        anyRecommended = anyRecommended || !verdict(entrant.method(), setting).empty();
        if (entrant.total() && (!least || *entrant.total() < *least)) least = entrant.total();
    }
    Rows rows;
    for (size_t i = 0; i < entrants.size(); ++i) {
        const Entrant& entrant = entrants[i];
        const std::string recommended = verdict(entrant.method(), setting);
        Row row{{"method", std::string(entrant.method().id)}, {"triangles", double(scene->triangleCount())}};
        if (entrant.method().ranked) row["lecture"] = recommended;
        if (entrant.built() != nullptr) {
            row["build_ms"] = entrant.built()->report().buildMilliseconds;
            row["bytes"] = double(entrant.built()->report().bytes) + double(entrant.log().frameBytes()) +
                           (entrant.method().onGpu ? kDepthBytes * size.size.width * size.size.height : 0.0);
        }
        const std::optional<double> total = entrant.total();
        const double times = total && least ? *total / *least : 0.0;
        if (total) {
            row["views_ms"] = entrant.viewsMilliseconds();
            row["total_ms"] = *total;
            row["missed_pixels"] = missed[i];
            row["to_fastest"] = times;
        } else {
            row["total_ms"] = entrant.failure();
        }
        if (entrant.method().ranked) row["agreement"] = std::string(agreement(!recommended.empty(), anyRecommended, times));
        rows.push_back(std::move(row));
    }
    return rows;
}

// ---- The table

std::vector<Message> lectureNotes() {
    return {
        note(CULLSCOPE_TR("The lecture's verdicts: very little depth overlap, painter's algorithm or BSP tree; little overlap, "
                          "scan line; few surfaces, painter, BSP tree, scan line; many surfaces, depth buffer, octree; several "
                          "views of a static scene, BSP tree. It gives no numbers: here 1 layer is very little overlap, 2 are "
                          "little, 10 surfaces are few, 100,000 many.")),
        note(CULLSCOPE_TR("A verdict and the measurement agree where the method takes at most 1.25 times the least time of the "
                          "first five methods, the structure built once and all views drawn.")),
        note(CULLSCOPE_TR("all and backface are the GPU's depth buffer, which the lecture says is used most; they are not among "
                          "those that its verdicts compare. painter, bsp and octree-query draw with OpenGL, depth-buffer and "
                          "scan-line on the processor.")),
        note(CULLSCOPE_TR(
            "The scenes are layers with waves of height 0.02, so that their triangles lie in planes of their own and "
            "the layers do not meet: a BSP tree of flat layers would have a node a layer. With more layers than "
            "surfaces each has two triangles.")),
        note(CULLSCOPE_TR(
            "Bytes are of what the method built, of what a frame needed besides (tables, lists, its triangles or its "
            "picture), and of the GPU's depth buffer where it is used. Missed pixels are those of the first "
            "view."))};
}

std::vector<ResultColumn> lectureColumns(const std::vector<Axis>& axes) {
    std::vector<ResultColumn> columns = columnsOf(axes);
    const std::vector<ResultColumn> others{{"lecture", CULLSCOPE_TR("lecture: good for"), Origin::Stated},
                                           {"triangles", CULLSCOPE_TR("triangles"), Origin::Measured},
                                           {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 2},
                                           {"views_ms", CULLSCOPE_TR("all views, ms"), Origin::Measured, 2},
                                           {"total_ms", CULLSCOPE_TR("both, ms"), Origin::Measured, 2},
                                           {"to_fastest", CULLSCOPE_TR("× fastest of five"), Origin::Measured, 2},
                                           {"agreement", CULLSCOPE_TR("verdict"), Origin::Measured},
                                           {"bytes", CULLSCOPE_TR("bytes"), Origin::Measured},
                                           {"missed_pixels", CULLSCOPE_TR("missed px"), Origin::Measured}};
    columns.insert(columns.end(), others.begin(), others.end());
    return columns;
}

/// The total time over one axis, a line for each method; the others at one of their values.
RowPlot plotOver(const char* key, const char* title, const char* xTitle, RowFilter rows) {
    RowPlot described{logPlot(title, xTitle, CULLSCOPE_TR("milliseconds, built and all views drawn"))};
    described.x = key;
    described.y = {{"total_ms"}};
    described.lines = {"method"};
    described.rows = std::move(rows);
    return described;
}

}  // namespace

std::vector<std::string> lectureMethods() {
    std::vector<std::string> ids;
    for (const Method& method : kMethods) ids.emplace_back(method.id);
    return ids;
}

Experiment lectureTable(const LectureTableSize& size) {
    Experiment experiment;
    experiment.id = "lecture-table";
    experiment.title = CULLSCOPE_TR("The lecture's methods by overlap, surfaces and views");
    experiment.source = "lecture, Comparisons";
    experiment.notes = lectureNotes();
    std::vector<CellValue> methods;
    for (const std::string& id : lectureMethods()) methods.emplace_back(id);
    experiment.axes = {{kOverlap, CULLSCOPE_TR("layers"), Axis::Kind::Label, axisValues(size.overlaps)},
                       {kSurfaces, CULLSCOPE_TR("surfaces"), Axis::Kind::Label, axisValues(size.surfaces)},
                       {kViews, CULLSCOPE_TR("views"), Axis::Kind::Label, axisValues(size.views)},
                       {"method", CULLSCOPE_TR("method"), Axis::Kind::InTurns, methods}};
    experiment.settings = settingsOf(experiment.axes);
    for (Setting& setting : experiment.settings) {
        const int layers = int(setting.number(kOverlap)), each = std::max(2, int(setting.number(kSurfaces)) / layers);
        setting.scene = "layers:count=" + std::to_string(layers) + ",triangles=" + std::to_string(each) + ",waves=0.02";
    }
    experiment.columns = lectureColumns(experiment.axes);
    const auto middle = [](const std::vector<int>& values) { return CellValue(double(values[values.size() / 2])); };
    const CellValue surfaces = middle(size.surfaces), layers = middle(size.overlaps), one = double(size.views.front());
    experiment.plots = {
        plotOver(kOverlap, CULLSCOPE_TR("Time by layers"), CULLSCOPE_TR("layers"), {{kSurfaces, {surfaces}}, {kViews, {one}}}),
        plotOver(kSurfaces, CULLSCOPE_TR("Time by surfaces"), CULLSCOPE_TR("surfaces"), {{kOverlap, {layers}}, {kViews, {one}}}),
        plotOver(kViews, CULLSCOPE_TR("Time by views of a static scene"), CULLSCOPE_TR("views"),
                 {{kOverlap, {layers}}, {kSurfaces, {surfaces}}})};
    experiment.draws = true;
    experiment.measured = [size](const Setting& setting, const ScenePointer& scene, const Progress& progress) {
        return methodRows(setting, scene, size, progress);
    };
    return experiment;
}

}  // namespace cullscope
