#include "core/experiments/han_hong_rows.h"

#include <algorithm>
#include <iterator>

#include "core/scene/frustum_share.h"

namespace cullscope::han_hong {
namespace {

using Origin = ResultColumn::Origin;

/// How often each of the cases 1 to 3 occurred, as in "1 ×11, 2 ×1"; empty where none did.
CellValue casesFound(const RunMeasurement& run) {
    std::map<int, int> counts;
    for (const FrameMeasurement& frame : run.frames)
        for (const NamedFigure& figure : frame.figures)
            if (figure.name == "case") ++counts[int(figure.value)];
    std::string words;
    for (const auto& [number, count] : counts)
        words += (words.empty() ? "" : ", ") + std::to_string(number) + " ×" + std::to_string(count);
    return words.empty() ? CellValue() : CellValue(words);
}

/// The mean of a figure over the frames that have it; none where no frame does.
std::optional<double> meanOf(const RunMeasurement& run, std::string_view name) {
    double sum = 0.0;
    size_t count = 0;
    for (const FrameMeasurement& frame : run.frames)
        for (const NamedFigure& figure : frame.figures)
            if (figure.name == name) sum += figure.value, ++count;
    return count > 0 ? std::optional(sum / double(count)) : std::nullopt;
}

/// Faces that intersect the frustum by an exact test, back faces included: the mean over the poses measured.
double facesInFrustum(const MeasureResult& result) {
    const MeasureRequest& request = result.request;
    double faces = 0.0;
    for (const FrameMeasurement& frame : result.runs.front().frames)
        faces += double(trianglesInFrustum(*request.scene, View(request.path.camera(frame.pose), request.size)));
    return faces / double(result.runs.front().frames.size());
}

/// An experiment of another scene: without what the paper states of its own.
Experiment ofOtherScene(Experiment experiment, const std::string& scene) {
    std::erase_if(experiment.columns, [](const ResultColumn& column) { return column.origin == Origin::Stated; });
    for (Setting& setting : experiment.settings) {
        setting.scene = scene;
        setting.stated.clear();
    }
    experiment.checks.clear();
    std::erase_if(experiment.notes, [](const Message& each) { return each.text == facesNote().text; });
    experiment.ofScene = {};
    return experiment;
}

}  // namespace

Message lossNote() {
    return note(CULLSCOPE_TR("The paper counts no lost pixels; here every picture is compared with the exact one."));
}

Message facesNote() {
    return note(
        CULLSCOPE_TR("The paper's text has 144,046 faces, its Table 2 has 144,078: 144,046 are measured here, by subdividing the "
                     "bunny that is installed."));
}

Rows sphericalRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    if (result.runs.empty() || result.runs.front().frames.empty()) return rows;
    const double inFrustum = facesInFrustum(result);
    for (const RunMeasurement& run : result.runs) {
        Row cells = rowCells(setting, run);
        double considered = 0.0;
        for (const FrameMeasurement& frame : run.frames) considered += double(frame.consideredTriangles);
        cells["considered_triangles"] = considered / double(run.frames.size());
        cells["triangles_in_frustum"] = inFrustum;
        cells["cases"] = casesFound(run);
        if (const std::optional<double> hits = meanOf(run, "rays_hit")) cells["rays_hit"] = *hits;
        rows.push_back(std::move(cells));
    }
    return rows;
}

std::vector<ResultColumn> timedColumns(const std::vector<Axis>& axes, const std::vector<ResultColumn>& paper) {
    std::vector<ResultColumn> columns = columnsOf(axes);
    columns.insert(columns.end(), paper.begin(), paper.end());
    const std::vector<ResultColumn> measured{{"considered_triangles", CULLSCOPE_TR("faces"), Origin::Measured},
                                             {"triangles_in_frustum", CULLSCOPE_TR("in frustum"), Origin::Measured},
                                             {"cases", CULLSCOPE_TR("cases found"), Origin::Measured},
                                             {"rays_hit", CULLSCOPE_TR("rays that hit, of 4"), Origin::Measured, 2},
                                             {"poses", CULLSCOPE_TR("views"), Origin::Measured},
                                             {"fps_max", CULLSCOPE_TR("fps max"), Origin::Measured, 1},
                                             {"fps_min", CULLSCOPE_TR("fps min"), Origin::Measured, 1},
                                             {"fps_mean", CULLSCOPE_TR("fps mean"), Origin::Measured, 1},
                                             {"ratio_to_all", CULLSCOPE_TR("× all [95 %]"), Origin::Measured, 2},
                                             {"ratio_to_backface", CULLSCOPE_TR("× backface [95 %]"), Origin::Measured, 2},
                                             headroomColumn(),
                                             {"missed_pixels", CULLSCOPE_TR("missed px"), Origin::Measured},
                                             {"missed_pixel_rate", CULLSCOPE_TR("missed ppm"), Origin::Measured, 0, 1e6},
                                             {"largest_hole_px", CULLSCOPE_TR("largest hole, px"), Origin::Measured}};
    columns.insert(columns.end(), measured.begin(), measured.end());
    return columns;
}

Setting bunnySetting(const std::string& path, Viewport size) {
    Setting setting;
    setting.scene = kBunny;
    setting.shown = "spherical";
    setting.path = path;
    setting.size = size;
    return setting;
}

Axis strategiesAxis(const std::vector<std::string>& further) {
    Axis axis{"strategy", CULLSCOPE_TR("strategy"), Axis::Kind::Strategy, {std::string("all"), std::string("backface")}};
    axis.values.insert(axis.values.end(), further.begin(), further.end());
    axis.values.emplace_back(limitText());
    return axis;
}

void addTimed(Experiment& experiment, const Setting& setting) {
    std::vector<Axis> inTurns;
    std::ranges::copy_if(experiment.axes, std::back_inserter(inTurns), &Axis::inTurns);
    experiment.settings.push_back(settingsOf(inTurns, setting).front());
}

Experiment withOtherScenes(Experiment experiment) {
    experiment.ofScene = [experiment](const std::string& scene) { return ofOtherScene(experiment, scene); };
    return experiment;
}

}  // namespace cullscope::han_hong
