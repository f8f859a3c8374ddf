#include "core/experiments/result_fields.h"

#include <array>
#include <cmath>

#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"
#include "core/measure/field_figures.h"

namespace cullscope {
namespace {

Json parametersJson(const ParameterSet& parameters) {
    Json json = Json::object();
    for (const ParameterDeclaration& declaration : parameters.declarations())
        std::visit([&](const auto& value) { json[declaration.key] = value; }, parameters.value(declaration.key));
    return json;
}

/// By Cause.
constexpr std::array<const char*, kCauseCount> kCulledFields{"culled_outside_frustum", "culled_back_facing", "culled_hidden",
                                                             "culled_too_small", "culled_no_sample"};

/// A whole number without a fraction.
Json numberJson(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15 ? Json(int64_t(value)) : Json(value);
}

Json intervalJson(const RatioEstimate& estimate) { return estimate.hasInterval ? Json(estimate.ci95) : Json(nullptr); }

/// The field's figures with their intervals; null where they were not counted.
void addFieldFigures(Json& json, const Summary& summary) {
    for (size_t i = 0; i < fieldFigures().size(); ++i) {
        const std::optional<RatioEstimate> estimate = i < summary.field.size() ? summary.field[i] : std::nullopt;
        const std::string key = fieldFigures()[i].key;
        json[key] = estimate ? Json(estimate->ratio) : Json(nullptr);
        json[key + "_ci95"] = estimate ? intervalJson(*estimate) : Json(nullptr);
    }
    json["views_with_loss_below"] = summary.lossBelow ? Json(*summary.lossBelow) : Json(nullptr);
}

std::string csvCell(const Json& value) {
    if (value.is_null()) return "";
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

void appendRow(std::string& csv, const Json& head, const Json& frame, bool names) {
    bool first = true;
    for (const Json* part : {&head, &frame})
        for (const auto& [key, value] : part->items()) {
            csv += first ? "" : ",";
            csv += names ? key : csvCell(value);
            first = false;
        }
    csv += '\n';
}

}  // namespace

Json frameFields(const FrameMeasurement& frame) {
    Json json{{"pose", frame.pose},
              {"frame_ms", frame.frameMilliseconds},
              {"cull_ms", frame.cullMilliseconds},
              {"repetitions", frame.repetitions},
              {"considered_triangles", frame.consideredTriangles},
              {"submitted_triangles", frame.submitted.triangles},
              {"submitted_fragments", frame.submitted.fragments}};
    for (size_t cause = 0; cause < kCauseCount; ++cause) json[kCulledFields[cause]] = frame.culledTriangles[cause];
    const auto figure = [&](uint64_t Accuracy::*member) {
        return frame.accuracy ? Json((*frame.accuracy).*member) : Json(nullptr);
    };
    json["visible_triangles"] = figure(&Accuracy::visibleTriangles);
    json["missed_pixels"] = figure(&Accuracy::missedPixels);
    json["extra_pixels"] = figure(&Accuracy::extraPixels);
    json["unresolved_pixels"] = figure(&Accuracy::unresolvedPixels);
    json["covered_pixels"] = figure(&Accuracy::coveredPixels);
    json["largest_hole_px"] = figure(&Accuracy::largestHolePixels);
    json["false_culled_triangles"] = figure(&Accuracy::falselyCulledTriangles);
    json["needlessly_drawn_triangles"] = figure(&Accuracy::needlesslyDrawnTriangles);
    json["missed_beyond_snapping"] = frame.accuracy ? Json(frame.missedBeyondSnapping) : Json(nullptr);
    json["pixels"] = figure(&Accuracy::pixels);
    json["visible_objects"] = figure(&Accuracy::visibleObjects);
    json["submitted_objects"] = figure(&Accuracy::submittedObjects);
    json["false_culled_objects"] = figure(&Accuracy::falselyCulledObjects);
    json["needlessly_drawn_objects"] = figure(&Accuracy::needlesslyDrawnObjects);
    json["outline_px"] = figure(&Accuracy::outlinePixels);
    json["differently_covered_px"] = figure(&Accuracy::differentlyCovered);
    const auto judged = [&](auto value) { return frame.accuracy ? Json(value) : Json(nullptr); };
    json["lost_pixels"] = judged(frame.lostPixels);
    json["lost_objects"] = judged(frame.lostObjects.size());
    json["toggled_pixels"] = judged(frame.toggledPixels);
    json["image_difference_mean"] = judged(meanDifference(frame.pictureDifferences));
    json["image_difference_p99"] = judged(differenceQuantile(frame.pictureDifferences, 0.99));
    json["stages_ms"] = Json::object();
    for (const Stage& stage : frame.stages) json["stages_ms"][stage.name] = stage.milliseconds;
    json["parts"] = Json::object();
    for (const CullPart& part : frame.parts)
        json["parts"][part.name] = {{"objects", part.objects}, {"culled_triangles", part.culledTriangles}};
    for (const NamedFigure& named : frame.figures) json[named.name] = numberJson(named.value);
    return json;
}

Json summaryFields(const Summary& summary) {
    Json json{{"fps_overall", summary.fpsOverall},
              {"fps_mean", summary.fpsMean},
              {"fps_min", summary.fpsMin},
              {"fps_max", summary.fpsMax},
              {"frame_ms_median", summary.frameMillisecondsMedian},
              {"frame_ms_p95", summary.frameMillisecondsP95},
              {"frame_ms_p99", summary.frameMillisecondsP99},
              {"cull_share", summary.cullShare},
              {"culled_fraction", summary.culledFraction},
              {"missed_pixel_rate", summary.missedPixelRate ? Json(*summary.missedPixelRate) : Json(nullptr)},
              {"ratio_to_same_sides", summary.ratioToOwnRule.ratio},
              {"ratio_to_same_sides_ci95", intervalJson(summary.ratioToOwnRule)},
              {"headroom_share", summary.headroomShare ? Json(summary.headroomShare->ratio) : Json(nullptr)},
              {"headroom_share_ci95", summary.headroomShare ? intervalJson(*summary.headroomShare) : Json(nullptr)},
              {"ratio_to_all", summary.ratioToTriangles.ratio},
              {"ratio_to_all_ci95", intervalJson(summary.ratioToTriangles)},
              {"ratio_to_backface", summary.ratioToFrontFaces.ratio},
              {"ratio_to_backface_ci95", intervalJson(summary.ratioToFrontFaces)},
              {"speedup_vs_all", summary.speedupVsTriangles.ratio},
              {"speedup_vs_all_ci95", intervalJson(summary.speedupVsTriangles)},
              {"speedup_vs_backface", summary.speedupVsFrontFaces.ratio},
              {"speedup_vs_backface_ci95", intervalJson(summary.speedupVsFrontFaces)}};
    addFieldFigures(json, summary);
    return json;
}

Json runHeadFields(const RunMeasurement& run, const MeasureRequest& request) {
    return {{"strategy", run.strategy.id},
            {"promise", promiseId(run.promise)},
            {"facing", facingId(run.facing)},
            {"reference_facing", facingId(run.referenceFacing)},
            {"same_sides_baseline", strategyText(run.ownRule)},
            {"parameters", parametersJson(run.strategy.parameters)},
            {"width", request.size.width},
            {"height", request.size.height},
            {"windows", request.windows},
            {"window_views", request.differentViews ? "different" : "one"},
            {"upload", request.upload == Upload::Vbo ? "vbo" : "vertex-array"},
            {"build_ms", run.structure.buildMilliseconds},
            {"structure_bytes", run.structure.bytes}};
}

Json headFields(const ToolVersion& tool, const std::string& cpu, const GlInfo& gl) {
    return {{"tool", {{"name", tool.name}, {"version", tool.version}, {"commit", tool.commit}}},
            {"machine", {{"cpu", cpu}, {"gl_renderer", gl.renderer}, {"gl_version", gl.version}, {"gl_software", gl.software}}}};
}

Json runFields(const FieldsOfRun& run, const Summary& summary) {
    Json json = run.head;
    json["frames"] = run.frames;
    json["summary"] = summaryFields(summary);
    return json;
}

std::string fieldsText(const Json& fields) {
    return plainJson(fields.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string framesCsv(const std::vector<FieldsOfRun>& runs) {
    std::string csv;
    // Every row has the columns of all: families have figures of their own.
    Json columns = frameFields({});
    for (const FieldsOfRun& run : runs)
        for (const Json& frame : run.frames)
            for (const auto& [key, value] : frame.items()) columns.emplace(key, nullptr);
    const auto first = [](const FieldsOfRun& run) {
        Json head = run.before;
        head.update(run.head);
        return head;
    };
    if (!runs.empty()) appendRow(csv, first(runs.front()), columns, true);
    for (const FieldsOfRun& run : runs)
        for (const Json& frame : run.frames) {
            Json row = columns;
            for (auto& [key, value] : row.items()) value = frame.contains(key) ? frame[key] : Json(nullptr);
            appendRow(csv, first(run), row, false);
        }
    return terminalText(csv);
}

}  // namespace cullscope
