#include "core/experiments/lecture_table.h"

#include <algorithm>
#include <array>

#include "core/experiments/run_rows.h"

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
                              Method{.id = "backface", .onGpu = true, .ranked = false},
                              Method{.id = "oracle", .onGpu = true, .ranked = false}};

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

// ---- What was measured

/// A method at one setting.
struct Served {
    const Method* method = nullptr;
    const RunMeasurement* run = nullptr;  ///< null where it could not be built
    std::string failure{};                ///< why it did not serve; empty: it did
    double viewsMilliseconds = 0.0;

    /// The structure, built once, and all views.
    [[nodiscard]] std::optional<double> total() const {
        if (run == nullptr || !failure.empty()) return std::nullopt;
        return run->structure.buildMilliseconds + viewsMilliseconds;
    }
};

Served servedBy(const Method& method, const Setting& setting, const MeasureResult& result) {
    Served made{&method};
    for (const RunMeasurement& run : result.runs)
        if (run.strategy.id == method.id) made.run = &run;
    if (made.run != nullptr) {
        for (const FrameMeasurement& frame : made.run->frames) made.viewsMilliseconds += frame.frameMilliseconds;
        const size_t drawn = made.run->frames.size(), views = result.request.path.poses.size();
        if (drawn < views)
            made.failure = "more than " + std::to_string(int(setting.secondsOfAStrategy)) + " s: " + std::to_string(drawn) +
                           " of " + std::to_string(views) + " views";
    }
    // What a method refuses, such as more fragments than its limit, is what its cells say.
    for (const Refusal& refusal : result.refused)
        if (refusal.strategy.id == method.id) made.failure = refusal.why.english();
    return made;
}

/// What the structure takes, what a frame needs at most besides, and the depth buffer of OpenGL where it is used.
double bytesOf(const Served& served, const Viewport& size) {
    constexpr double kDepthBytes = 4.0;
    uint64_t most = 0;
    for (const FrameMeasurement& frame : served.run->frames) most = std::max(most, frame.frameBytes);
    return double(served.run->structure.bytes) + double(most) +
           (served.method->onGpu ? kDepthBytes * size.width * size.height : 0.0);
}

/// Pixels lost in all views, beyond the raster's snapping where they were rasterised otherwise than the reference.
double lostPixels(const RunMeasurement& run) {
    const std::optional<Losses> losses = run.losses();
    if (!losses) return 0.0;
    return double(losses->beyondSnapping ? losses->missedBeyondSnapping : losses->missedPixels);
}

Rows methodRows(const Setting& setting, const MeasureResult& result) {
    // Sums over some of the views are no rows.
    if (result.interrupted) return {};
    std::vector<Served> methods;
    for (const Method& method : kMethods) methods.push_back(servedBy(method, setting, result));
    std::optional<double> least;
    bool anyRecommended = false;
    for (const Served& each : methods) {
        if (!each.method->ranked) continue;
        anyRecommended = anyRecommended || !verdict(*each.method, setting).empty();
        if (each.total() && (!least || *each.total() < *least)) least = each.total();
    }
    Rows rows;
    for (const Served& each : methods) {
        const std::string recommended = verdict(*each.method, setting);
        Row row = setting.labels;
        row["method"] = std::string(each.method->id);
        row["triangles"] = double(result.request.scene->triangleCount());
        if (each.method->ranked) row["lecture"] = recommended;
        if (each.run != nullptr) {
            row["build_ms"] = each.run->structure.buildMilliseconds;
            row["bytes"] = bytesOf(each, setting.size);
        }
        const std::optional<double> total = each.total();
        const double times = total && least ? *total / *least : 0.0;
        if (total) {
            row["views_ms"] = each.viewsMilliseconds;
            row["total_ms"] = *total;
            row["missed_pixels"] = lostPixels(*each.run);
            row["to_fastest"] = times;
        } else {
            row["total_ms"] = each.failure;
        }
        if (each.method->ranked) row["agreement"] = std::string(agreement(!recommended.empty(), anyRecommended, times));
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
            "picture), and of the GPU's depth buffer where it is used. Missed pixels are those of all "
            "views."))};
}

std::vector<ResultColumn> lectureColumns(const std::vector<Axis>& axes) {
    std::vector<ResultColumn> columns = columnsOf(axes);
    const std::vector<ResultColumn> others{{"lecture", CULLSCOPE_TR("lecture: good for"), Origin::Stated},
                                           {"triangles", CULLSCOPE_TR("triangles"), Origin::Measured},
                                           {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 2},
                                           {"views_ms", CULLSCOPE_TR("all views, ms"), Origin::Measured, 2},
                                           {"total_ms", CULLSCOPE_TR("both, ms"), Origin::Measured, 2},
                                           {"to_fastest", CULLSCOPE_TR("both ÷ least of five"), Origin::Measured, 2},
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
                       {"method", CULLSCOPE_TR("method"), Axis::Kind::Strategy, methods}};
    Setting common;
    common.shown = "backface";
    common.size = size.size;
    common.refusalsAreResults = true;
    common.secondsOfAStrategy = size.secondsOfAMethod;
    experiment.settings = settingsOf(experiment.axes, common);
    for (Setting& setting : experiment.settings) {
        const int layers = int(setting.number(kOverlap)), each = std::max(2, int(setting.number(kSurfaces)) / layers);
        setting.scene = "layers:count=" + std::to_string(layers) + ",triangles=" + std::to_string(each) + ",waves=0.02";
        const int views = int(setting.number(kViews));
        setting.path = "front:" + std::to_string(views);
        setting.timing.fixedRepetitions = views > 1 ? 1 : size.repetitions;
        // Meshes are uploaded and programs compiled when they are first used.
        setting.timing.warmUpOnce = true;
    }
    experiment.columns = lectureColumns(experiment.axes);
    const auto middle = [](const std::vector<int>& values) { return CellValue(double(values[values.size() / 2])); };
    const CellValue surfaces = middle(size.surfaces), layers = middle(size.overlaps), one = double(size.views.front());
    experiment.plots = {
        plotOver(kOverlap, CULLSCOPE_TR("Time by layers"), CULLSCOPE_TR("layers"), {{kSurfaces, {surfaces}}, {kViews, {one}}}),
        plotOver(kSurfaces, CULLSCOPE_TR("Time by surfaces"), CULLSCOPE_TR("surfaces"), {{kOverlap, {layers}}, {kViews, {one}}}),
        plotOver(kViews, CULLSCOPE_TR("Time by views of a static scene"), CULLSCOPE_TR("views"),
                 {{kOverlap, {layers}}, {kSurfaces, {surfaces}}})};
    experiment.rowsOfRuns = methodRows;
    return experiment;
}

}  // namespace cullscope
