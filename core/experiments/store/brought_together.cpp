#include "core/base/error.h"
#include "core/experiments/store/result_store.h"
#include "core/experiments/store/rows.h"

// What comes into a store from files: results of other runs, parts of a study.
namespace cullscope::store {
namespace {

/// The fields of a measurement's runs, by place.
std::vector<std::string> headsOf(const Database& database, int64_t measurement) {
    Statement select(database, "SELECT head FROM run WHERE measurement = ? ORDER BY place");
    select.bind(measurement);
    std::vector<std::string> heads;
    while (select.next()) heads.push_back(select.text(0));
    return heads;
}

/// The measurement that is there already; none: there is none. `heads`: the fields of its runs, by place.
std::optional<int64_t> numberOf(const Database& database, const Listed& listed, const std::vector<std::string>& heads) {
    Statement select(database,
                     "SELECT number FROM measurement WHERE started = ? AND experiment = ? AND cpu = ? AND scene = ? AND "
                     "scene_sha256 = ? AND path = ?");
    select.bind(listed.started).bind(listed.origin.experiment).bind(listed.cpu);
    select.bind(listed.scene).bind(listed.sceneSha256).bind(listed.path);
    while (select.next())
        if (headsOf(database, select.number(0)) == heads) return select.number(0);
    return std::nullopt;
}

/// Adds a result file's measurement.
Added addDocument(const Database& database, const ResultFields& document, const Origin& origin, const std::string& started) {
    Listed listed;
    listed.started = started;
    listed.ended = started;
    listed.interrupted = document.at("interrupted").get<bool>();
    listed.origin = origin;
    const ResultFields& tool = document.at("tool");
    listed.tool = {tool.at("name").get<std::string>(), tool.at("version").get<std::string>(),
                   tool.at("commit").get<std::string>()};
    const ResultFields& machine = document.at("machine");
    listed.cpu = machine.at("cpu").get<std::string>();
    listed.gl.renderer = machine.at("gl_renderer").get<std::string>();
    listed.gl.version = machine.at("gl_version").get<std::string>();
    listed.gl.software = machine.at("gl_software").get<bool>();
    const ResultFields& scene = document.at("scene");
    listed.scene = scene.at("name").get<std::string>();
    listed.sceneSha256 = scene.at("sha256").get<std::string>();
    listed.triangles = scene.at("triangles").get<uint64_t>();
    listed.instances = scene.at("instances").get<uint64_t>();
    listed.path = document.at("path").get<std::string>();
    std::vector<ResultFields> runs;
    for (const ResultFields& run : document.at("runs")) runs.push_back(run);
    const ResultFields& limit = document.at("limit");
    const auto sameRun = [&](const ResultFields& run) {
        return run.at("strategy") == limit.at("strategy") && run.at("parameters") == limit.at("parameters");
    };
    const size_t asked = runs.size();
    if (!limit.is_null() && std::ranges::none_of(runs, sameRun)) runs.push_back(limit);
    for (const ResultFields& run : runs) {
        listed.poses = std::max<uint64_t>(listed.poses, run.at("frames").size());
        listed.size = {run.at("width").get<int>(), run.at("height").get<int>()};
    }
    std::vector<std::string> heads;
    for (ResultFields head : runs) {
        head.erase("frames");
        head.erase("summary");
        heads.push_back(compact(head));
    }
    Transaction transaction(database);
    if (const std::optional<int64_t> there = numberOf(database, listed, heads)) return {*there, false};
    const int64_t number = addMeasurement(database, listed);
    for (size_t place = 0; place < runs.size(); ++place) {
        const int64_t run = addRun(database, {number, place + 1, strategyText(strategyOfHead(heads[place])), place < asked,
                                              !limit.is_null() && sameRun(runs[place]), heads[place]});
        for (const ResultFields& frame : runs[place].at("frames"))
            addFrame(database, run, false, frame, {frame.at("frame_ms").get<double>()}, {frame.at("cull_ms").get<double>()}, "");
    }
    transaction.commit();
    return {number};
}

void bindAsRead(Statement& to, const Statement& from, int column) {
    if (from.isNothing(column))
        to.bindNothing();
    else
        to.bind(from.text(column));
}

/// Adds the runs and frames of a measurement of another store to one of this one.
void copyRuns(const Database& from, int64_t number, const Database& to, int64_t copy) {
    Statement runs(from, "SELECT number, place, strategy, asked_for, is_limit, head, figures FROM run WHERE measurement = ?");
    runs.bind(number);
    while (runs.next()) {
        const std::optional<std::string> figures = runs.isNothing(6) ? std::nullopt : std::optional(runs.text(6));
        const int64_t run = addRun(
            to, {copy, size_t(runs.number(1)), runs.text(2), runs.number(3) != 0, runs.number(4) != 0, runs.text(5), figures});
        Statement frames(from, "SELECT pose, own_raster, fields, frame_times, cull_times, judged FROM frame WHERE run = ?");
        frames.bind(runs.number(0));
        while (frames.next()) {
            Statement insert(to,
                             "INSERT INTO frame (run, pose, own_raster, fields, frame_times, cull_times, judged) "
                             "VALUES (?,?,?,?,?,?,?)");
            insert.bind(run).bind(frames.number(0)).bind(frames.number(1));
            for (int column = 2; column < 6; ++column) bindAsRead(insert, frames, column);
            insert.run();
        }
    }
}

Added addReport(const Database& database, const std::string& added, const Report& report) {
    Transaction transaction(database);
    Statement select(database,
                     "SELECT number FROM report WHERE kind = ? AND strategy = ? AND document = ? AND "
                     "(kind = 'certificate' OR added = ?)");
    select.bind(report.kind).bind(report.strategy).bind(report.document).bind(added);
    if (select.next()) return {select.number(0), false, report.kind};
    Statement insert(database,
                     "INSERT INTO report (added, kind, scene, strategy, command, words, document) VALUES (?,?,?,?,?,?,?)");
    insert.bind(added).bind(report.kind).bind(report.scene).bind(report.strategy).bind(report.command);
    insert.bind(report.words).bind(report.document).run();
    const int64_t number = database.newestRow();
    transaction.commit();
    return {number, true, report.kind};
}

}  // namespace

Added ResultStore::addFile(const std::string& json, const std::string& file, const Origin& origin,
                           const std::string& started) const {
    try {
        return addDocument(m_database, ResultFields::parse(json), origin, started);
    } catch (const ResultFields::exception&) {
        throwInput(
            CULLSCOPE_TR("%1 is no result file of cullbench measure, race or certify, and no result store. Those of sweeps "
                         "and experiments have no frames: measure them with --store. Of what a store exported, add that store."),
            {file});
    }
}

std::vector<Added> ResultStore::addAll(const ResultStore& other) const {
    std::vector<Added> all;
    for (const Listed& listed : other.list()) {
        Transaction transaction(m_database);
        if (const std::optional<int64_t> there = numberOf(m_database, listed, headsOf(other.m_database, listed.number))) {
            all.push_back({*there, false});
            continue;
        }
        const int64_t copy = addMeasurement(m_database, listed);
        copyRuns(other.m_database, listed.number, m_database, copy);
        transaction.commit();
        all.push_back({copy});
    }
    for (const StoredReport& each : other.reports()) all.push_back(addReport(m_database, each.added, each.report));
    return all;
}

Added ResultStore::add(const Report& report) const { return addReport(m_database, timeText(), report); }

}  // namespace cullscope::store
