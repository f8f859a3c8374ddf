#include "core/experiments/result_file.h"

#include <fstream>

#include "core/base/version.h"
#include "core/experiments/result_fields.h"

namespace cullscope {
namespace {

FieldsOfRun fieldsOf(const RunMeasurement& run, const MeasureResult& result) {
    FieldsOfRun fields{
        {{"scene", result.request.scene->name()}, {"gl_renderer", result.gl.renderer}}, runHeadFields(run, result.request), {}};
    for (const FrameMeasurement& frame : run.frames) fields.frames.push_back(frameFields(frame));
    return fields;
}

ResultFields runJson(const RunMeasurement& run, const MeasureResult& result) {
    return runFields(fieldsOf(run, result), run.summary);
}

}  // namespace

std::string resultJson(const MeasureResult& result) {
    const Scene& scene = *result.request.scene;
    ResultFields json = headFields(toolVersion(), cpuName(), result.gl);
    json["scene"] = {{"name", scene.name()},
                     {"sha256", scene.sha256()},
                     {"triangles", scene.triangleCount()},
                     {"instances", scene.instances().size()}};
    json["path"] = result.request.path.name;
    json["interrupted"] = result.interrupted;
    json["runs"] = ResultFields::array();
    for (const RunMeasurement& run : result.runs) json["runs"].push_back(runJson(run, result));
    json["limit"] = result.limit ? runJson(*result.limit, result) : ResultFields(nullptr);
    return fieldsText(json);
}

std::string resultCsv(const MeasureResult& result) {
    std::vector<FieldsOfRun> runs;
    for (const RunMeasurement& run : result.runs) runs.push_back(fieldsOf(run, result));
    return framesCsv(runs);
}

const char* facingId(Facing facing) {
    switch (facing) {
        case Facing::TwoSided:
            return CULLSCOPE_TR("two-sided");
        case Facing::Front:
            return CULLSCOPE_TR("front");
        case Facing::ByObject:
            return CULLSCOPE_TR("by-object");
    }
    return "";
}

ToolVersion toolVersion() { return {"cullscope", CULLSCOPE_VERSION, buildCommit()}; }

std::string cpuName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
}

}  // namespace cullscope
