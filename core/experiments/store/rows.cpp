#include "core/experiments/store/rows.h"

namespace cullscope::store {

int64_t addMeasurement(const Database& database, const Listed& listed) {
    Statement insert(database,
                     "INSERT INTO measurement (started, ended, interrupted, experiment, command, tool_name, tool_version, "
                     "tool_commit, cpu, gl_renderer, gl_version, gl_software, scene, scene_sha256, triangles, instances, path, "
                     "poses, width, height) VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    insert.bind(listed.started);
    if (listed.ended)
        insert.bind(*listed.ended);
    else
        insert.bindNothing();
    insert.bind(int64_t(listed.interrupted)).bind(listed.origin.experiment).bind(listed.origin.command);
    insert.bind(listed.tool.name).bind(listed.tool.version).bind(listed.tool.commit).bind(listed.cpu);
    insert.bind(listed.gl.renderer).bind(listed.gl.version).bind(int64_t(listed.gl.software));
    insert.bind(listed.scene).bind(listed.sceneSha256).bind(int64_t(listed.triangles)).bind(int64_t(listed.instances));
    insert.bind(listed.path).bind(int64_t(listed.poses)).bind(int64_t(listed.size.width)).bind(int64_t(listed.size.height));
    insert.run();
    return database.newestRow();
}

int64_t addRun(const Database& database, const NewRun& run) {
    Statement insert(database,
                     "INSERT INTO run (measurement, place, strategy, asked_for, is_limit, head, figures) VALUES (?,?,?,?,?,?,?)");
    insert.bind(run.measurement).bind(int64_t(run.place)).bind(run.strategy);
    insert.bind(int64_t(run.askedFor)).bind(int64_t(run.isLimit)).bind(run.head);
    if (run.figures)
        insert.bind(*run.figures);
    else
        insert.bindNothing();
    insert.run();
    return database.newestRow();
}

std::string compact(const ResultFields& fields) { return fields.dump(-1, ' ', false, ResultFields::error_handler_t::replace); }

void addFrame(const Database& database, int64_t run, bool ownRaster, const ResultFields& fields,
              const std::vector<double>& frameTimes, const std::vector<double>& cullTimes, const std::string& judged) {
    Statement insert(
        database,
        "INSERT INTO frame (run, pose, own_raster, fields, frame_times, cull_times, judged) VALUES (?,?,?,?,?,?,nullif(?,''))");
    insert.bind(run).bind(fields.at("pose").get<int64_t>()).bind(int64_t(ownRaster)).bind(compact(fields));
    insert.bind(compact(ResultFields(frameTimes))).bind(compact(ResultFields(cullTimes))).bind(judged);
    insert.run();
}

}  // namespace cullscope::store
