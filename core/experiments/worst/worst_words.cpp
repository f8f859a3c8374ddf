#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"
#include "core/experiments/worst/worst_view.h"
#include "core/image/cell_map_picture.h"
#include "core/measure/field_figures.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::worst {
namespace {

constexpr size_t kColours = 8;
constexpr size_t kPosesInFile = 16;
constexpr double kPlaceSize = 16.0;  // pixels

std::string shown(const WorstResult& result, double value) {
    if (result.request.of == Of::Ratio) return fmt::format("{:.2f}", value);
    const double perMillion = 1e6 * value;
    return value == 0.0 ? std::string("0") : fmt::format("{:.{}f}", perMillion, perMillion < 100.0 ? 1 : 0);
}

/// "1.05 [1.01, 1.10]" of the frames after the search; before them the least that it found.
std::string shownRatio(const WorstResult& result) {
    if (!result.confirmed) return shown(result, result.views[result.worst].value);
    const RatioEstimate& again = *result.confirmed;
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", again.ratio, again.ci95[0], again.ci95[1]);
}

PlotColour colourAt(size_t step) {
    const Vec3f colour = 255.0f * rampColour(float(double(step) / double(kColours - 1)), Vec3f(1.0f));
    return 0xFF000000 | PlotColour(colour.x) << 16 | PlotColour(colour.y) << 8 | PlotColour(colour.z);
}

/// Equal steps from the least value to the largest.
struct Steps {
    double least = 0.0, step = 0.0;

    [[nodiscard]] size_t of(double value) const {
        return step > 0.0 ? std::min(size_t((value - least) / step), kColours - 1) : 0;
    }
};

Steps stepsOf(const WorstResult& result) {
    const auto [least, most] = std::ranges::minmax_element(result.views, {}, &TriedView::value);
    return {least->value, (most->value - least->value) / double(kColours)};
}

std::string stepName(const WorstResult& result, const Steps& steps, size_t number) {
    if (steps.step <= 0.0) return shown(result, steps.least);
    return shown(result, steps.least + double(number) * steps.step) + " – " +
           shown(result, steps.least + double(number + 1) * steps.step);
}

Vec2 planOf(const WorstResult& result, const Vec3& point) {
    return result.request.scene->upAxis() == UpAxis::Z ? Vec2(point.x, point.y) : Vec2(point.x, -point.z);
}

void addDirections(LinePlot& plot, const WorstResult& result, const Steps& steps) {
    const PlotAxis degrees{{}, PlotScale::Linear, -180.0, 180.0};
    plot.x = degrees;
    plot.x.title = CULLSCOPE_TR("azimuth of the eye, degrees");
    plot.x.ticks = {{-180.0, "-180"}, {-90.0, "-90"}, {0.0, "0"}, {90.0, "90"}, {180.0, "180"}};
    plot.y = {CULLSCOPE_TR("elevation of the eye, degrees"), PlotScale::Linear, -90.0, 90.0};
    plot.y.ticks = {{-90.0, "-90"}, {-45.0, "-45"}, {0.0, "0"}, {45.0, "45"}, {90.0, "90"}};
    plot.widest = 2.2;
    for (size_t number = 0; number < (steps.step > 0.0 ? kColours : 1); ++number) {
        PlotBars bars{stepName(result, steps, number), colourAt(number), {}};
        for (const TriedView& view : result.views)
            if (view.replaced == 0 && steps.of(view.value) == number)
                bars.boxes.push_back({view.left, view.top, view.right, view.bottom});
        plot.bars.push_back(std::move(bars));
    }
    const TriedView& worst = result.views[result.worst];
    plot.marks.push_back(
        {CULLSCOPE_TR("the worst view"), {worst.azimuth(), worst.elevation()}, PlotShape::Disc, {0xFFE7120E, 2.5}, 0});
}

void addPlaces(LinePlot& plot, const WorstResult& result, const Steps& steps) {
    plot.x = {CULLSCOPE_TR("plan of the places: x"), PlotScale::Linear};
    plot.y = {result.request.scene->upAxis() == UpAxis::Z ? "y" : "-z", PlotScale::Linear};
    std::map<size_t, const TriedView*> worstOf;
    for (const TriedView& view : result.views) {
        const TriedView*& known = worstOf[view.place];
        if (known == nullptr || result.worse(view.value, known->value)) known = &view;
    }
    const Scene& scene = *result.request.scene;
    for (const auto& [place, view] : worstOf) {
        const Vec2 eye = planOf(result, view->pose.eye);
        const Vec2 toward = planOf(result, view->pose.target) - eye;
        const Vec2 end = eye + toward * (0.12 * scene.boundingSphere().radius / std::max(1e-12, glm::length(toward)));
        plot.lines.push_back(plainLine({}, {{eye.x, eye.y}, {end.x, end.y}}, {0xFF777777, 1.5}));
        const bool worst = view == &result.views[result.worst];
        plot.marks.push_back({worst ? CULLSCOPE_TR("the worst view") : std::string(),
                              {eye.x, eye.y},
                              PlotShape::Disc,
                              {worst ? 0xFFE7120E : 0xFF222222, worst ? 2.5 : 1.0},
                              colourAt(steps.of(view->value)),
                              shown(result, view->value),
                              kPlaceSize});
    }
    for (size_t number = 0; number < (steps.step > 0.0 ? kColours : 1); ++number)
        plot.bars.push_back({stepName(result, steps, number), colourAt(number), {}});
}

Json vectorJson(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

std::vector<Message> sentences(const WorstResult& result) {
    if (result.views.empty()) return {{CULLSCOPE_TR("No view was tried."), {}}};
    const TriedView& worst = result.views[result.worst];
    const std::string label = strategyLabel(result.request.strategy), count = std::to_string(result.views.size());
    const auto losing = std::ranges::count_if(result.views, [](const TriedView& view) { return view.lostPixels > 0; });
    if (result.request.of == Of::Ratio)
        return {{CULLSCOPE_TR("%1 gains least where it has ×%2 the speed of drawing the same sides; %3 views were tried."),
                 {label, shownRatio(result), count}}};
    if (losing == 0)
        return {{boundSaysSomething(result.views.size()) ? CULLSCOPE_TR("%1 lost nothing in %2 views (< 3/%2).")
                                                         : CULLSCOPE_TR("%1 lost nothing in %2 views."),
                 {label, count}}};
    return {{CULLSCOPE_TR("%1 loses most where it loses %2 of %3 covered pixels; it loses something in %4 of %5 views."),
             {label, std::to_string(worst.lostPixels), std::to_string(worst.coveredPixels), std::to_string(losing), count}}};
}

LinePlot worstMap(const WorstResult& result) {
    LinePlot plot;
    plot.heading =
        result.request.of == Of::Missed
            ? Message{CULLSCOPE_TR("Missed of a million covered pixels: %1"), {strategyLabel(result.request.strategy)}}
            : Message{CULLSCOPE_TR("Speed against drawing the same sides: %1"), {strategyLabel(result.request.strategy)}};
    plot.title = plot.heading.english();
    if (result.views.empty()) return plot;
    if (result.request.inside)
        addPlaces(plot, result, stepsOf(result));
    else
        addDirections(plot, result, stepsOf(result));
    return plot;
}

std::string worstText(const WorstResult& result) {
    std::string text;
    for (const Message& sentence : sentences(result)) text += terminalLine(sentence.english()) + "\n";
    if (result.interrupted) text += "Stopped: this is what was known by then.\n";
    if (result.views.empty()) return text;
    const CameraPath::Pose& pose = result.views[result.worst].pose;
    const auto vector = [](const Vec3& v) { return fmt::format("{:.6g},{:.6g},{:.6g}", v.x, v.y, v.z); };
    text += fmt::format("--eye {} --target {} --up {} --fovy {:.6g} --size {}x{}\n", vector(pose.eye), vector(pose.target),
                        vector(pose.up), result.lens.fovy.degrees(), result.request.size.width, result.request.size.height);
    return text;
}

std::string worstJson(const WorstResult& result) {
    const ToolVersion tool = toolVersion();
    const CameraPath path = result.path(kPosesInFile);
    Json json{{"tool", {{"name", tool.name}, {"version", tool.version}, {"commit", tool.commit}}},
              {"scene", {{"name", result.request.scene->name()}, {"sha256", result.request.scene->sha256()}}},
              {"gl_renderer", result.gl.renderer},
              {"strategy", strategyText(result.request.strategy)},
              {"of", result.request.of == Of::Missed ? "missed" : "ratio"},
              {"inside", result.request.inside},
              {"size", {result.request.size.width, result.request.size.height}},
              {"confirmed_ratio", result.confirmed ? Json(result.confirmed->ratio) : Json(nullptr)},
              {"confirmed_ratio_ci95", result.confirmed ? Json(result.confirmed->ci95) : Json(nullptr)},
              {"interrupted", result.interrupted},
              {"fovy_deg", path.fovy.degrees()},
              {"near", path.nearDistance},
              {"far", path.farDistance},
              {"poses", Json::array()},
              {"views", Json::array()}};
    for (const CameraPath::Pose& pose : path.poses)
        json["poses"].push_back(
            {{"eye", vectorJson(pose.eye)}, {"target", vectorJson(pose.target)}, {"up", vectorJson(pose.up)}});
    const bool counted = result.request.of == Of::Missed;
    for (const TriedView& view : result.views)
        json["views"].push_back({{"azimuth_deg", view.azimuth()},
                                 {"elevation_deg", view.elevation()},
                                 {"width_deg", view.right - view.left},
                                 {"place", view.place},
                                 {"eye", vectorJson(view.pose.eye)},
                                 {"target", vectorJson(view.pose.target)},
                                 {"value", view.value},
                                 {"lost_pixels", counted ? Json(view.lostPixels) : Json(nullptr)},
                                 {"covered_pixels", counted ? Json(view.coveredPixels) : Json(nullptr)}});
    return plainJson(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace cullscope::worst
