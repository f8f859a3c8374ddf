#include "core/experiments/result_fields.h"
#include "core/experiments/store/result_store.h"

namespace cullscope::store {
namespace {

FieldsOfRun fieldsOf(const StoredRun& run) {
    FieldsOfRun fields{{}, ResultFields::parse(run.head), {}};
    for (const std::string& frame : run.frames) fields.frames.push_back(ResultFields::parse(frame));
    return fields;
}

ResultFields document(const Stored& stored) {
    const Listed& listed = stored.listed;
    ResultFields json = headFields(listed.tool, listed.cpu, listed.gl);
    json["scene"] = {
        {"name", listed.scene}, {"sha256", listed.sceneSha256}, {"triangles", listed.triangles}, {"instances", listed.instances}};
    json["path"] = listed.path;
    json["interrupted"] = listed.interrupted;
    json["runs"] = ResultFields::array();
    json["limit"] = nullptr;
    for (const StoredRun& run : stored.runs) {
        if (run.old || !(run.askedFor || run.isLimit)) continue;
        const ResultFields fields = runFields(fieldsOf(run), run.run.summary);
        if (run.askedFor) json["runs"].push_back(fields);
        if (run.isLimit) json["limit"] = fields;
    }
    return json;
}

}  // namespace

std::string storedJson(const Stored& stored) { return fieldsText(document(stored)); }

std::string storedJson(const std::vector<Stored>& stored, const std::vector<StoredReport>& reports) {
    ResultFields all{{"measurements", ResultFields::array()}};
    for (const Stored& each : stored) {
        const Listed& listed = each.listed;
        ResultFields json{{"measurement", listed.number},
                          {"started", listed.started},
                          {"ended", listed.ended ? ResultFields(*listed.ended) : ResultFields(nullptr)},
                          {"experiment", listed.origin.experiment},
                          {"command", listed.origin.command}};
        json.update(document(each));
        all["measurements"].push_back(std::move(json));
    }
    for (const StoredReport& each : reports)
        all["reports"].push_back({{"report", each.number},
                                  {"added", each.added},
                                  {"kind", each.report.kind},
                                  {"scene", each.report.scene},
                                  {"strategy", each.report.strategy},
                                  {"command", each.report.command},
                                  {"document", ResultFields::parse(each.report.document)}});
    return fieldsText(all);
}

LinePlot framePlot(const Stored& stored) {
    LinePlot plot;
    plot.title = std::to_string(stored.listed.number) + ": " + stored.listed.scene + ", " + stored.listed.path;
    plot.x.title = CULLSCOPE_TR("pose");
    plot.x.whole = true;
    plot.y.title = CULLSCOPE_TR("frame, ms");
    plot.y.zero = true;
    for (const StoredRun& run : stored.runs) {
        if (run.frames.empty() || !(run.askedFor || run.isLimit)) continue;
        PlotLine line;
        line.name = run.strategy;
        for (const FrameMeasurement& frame : run.run.frames) line.points.push_back({double(frame.pose), frame.frameMilliseconds});
        plot.lines.push_back(std::move(line));
    }
    return plot;
}

std::string storedCsv(const std::vector<Stored>& stored) {
    std::vector<FieldsOfRun> runs;
    for (const Stored& each : stored)
        for (const StoredRun& run : each.runs) {
            if (!run.askedFor || run.old) continue;
            runs.push_back(fieldsOf(run));
            if (stored.size() > 1) {
                runs.back().before["measurement"] = each.listed.number;
                runs.back().before["started"] = each.listed.started;
            }
            runs.back().before["scene"] = each.listed.scene;
            runs.back().before["gl_renderer"] = each.listed.gl.renderer;
        }
    return framesCsv(runs);
}

}  // namespace cullscope::store
