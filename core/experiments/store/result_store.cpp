#include "core/experiments/store/result_store.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "core/base/error.h"
#include "core/experiments/result_fields.h"
#include "core/experiments/store/judged_frames.h"
#include "core/experiments/store/schema.h"

namespace cullscope::store {
namespace {

int64_t numberIn(const Database& database, const char* pragma) {
    Statement statement(database, pragma);
    return statement.next() ? statement.number(0) : 0;
}

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

struct NewRun {
    int64_t measurement;
    size_t place;
    std::string strategy;
    bool askedFor, isLimit;
    std::string head;
    std::optional<std::string> figures{};
};

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

/// `judged`: what a summary needs of a judged frame besides its fields (judgedText); empty: nothing is known.
void addFrame(const Database& database, int64_t run, bool ownRaster, const ResultFields& fields,
              const std::vector<double>& frameTimes, const std::vector<double>& cullTimes, const std::string& judged) {
    Statement insert(
        database,
        "INSERT INTO frame (run, pose, own_raster, fields, frame_times, cull_times, judged) VALUES (?,?,?,?,?,?,nullif(?,''))");
    insert.bind(run).bind(fields.at("pose").get<int64_t>()).bind(int64_t(ownRaster)).bind(compact(fields));
    insert.bind(compact(ResultFields(frameTimes))).bind(compact(ResultFields(cullTimes))).bind(judged);
    insert.run();
}

std::string figuresText(const KeptFigures& kept) {
    ResultFields figures{{"baseline", kept.baseline}};
    if (kept.ratio) figures["ratio"] = kept.ratio->ratio;
    if (kept.ratio && kept.ratio->hasInterval) figures["ratio_ci95"] = kept.ratio->ci95;
    if (kept.missedPpm) figures["missed_ppm"] = *kept.missedPpm;
    return compact(figures);
}

/// The numbers of a measurement's runs, by place.
std::vector<int64_t> runNumbers(const Database& database, int64_t measurement) {
    Statement select(database, "SELECT number FROM run WHERE measurement = ? ORDER BY place");
    select.bind(measurement);
    std::vector<int64_t> numbers;
    while (select.next()) numbers.push_back(select.number(0));
    return numbers;
}

/// Adds a result file's measurement and returns its number.
int64_t addDocument(const Database& database, const ResultFields& document, const Origin& origin) {
    Listed listed;
    listed.started = timeText();
    listed.ended = listed.started;
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
    Transaction transaction(database);
    const int64_t number = addMeasurement(database, listed);
    for (size_t place = 0; place < runs.size(); ++place) {
        ResultFields head = runs[place];
        head.erase("frames");
        head.erase("summary");
        const std::string text = compact(head);
        const int64_t run = addRun(database, {number, place + 1, strategyText(strategyOfHead(text)), place < asked,
                                              !limit.is_null() && sameRun(runs[place]), text});
        for (const ResultFields& frame : runs[place].at("frames"))
            addFrame(database, run, false, frame, {frame.at("frame_ms").get<double>()}, {frame.at("cull_ms").get<double>()}, "");
    }
    transaction.commit();
    return number;
}

}  // namespace

std::string timeText() {
    using namespace std::chrono;
    const auto now = floor<milliseconds>(system_clock::now());
    const std::time_t seconds = system_clock::to_time_t(now);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour,
                       utc.tm_min, utc.tm_sec, (now.time_since_epoch() % 1000).count());
}

ResultStore::ResultStore(const std::filesystem::path& file, Database::Access access) : m_database(file, access) {
    bringToVersion();
}

void ResultStore::bringToVersion() const {
    const auto version = [&] { return numberIn(m_database, "PRAGMA user_version"); };
    const auto refuseOthers = [&] {
        const bool empty = numberIn(m_database, "SELECT count(*) FROM sqlite_schema") == 0;
        if (empty && version() == 0) return;
        if (numberIn(m_database, "PRAGMA application_id") != kApplication || version() < 1) m_database.refuse();
        if (version() > kVersion)
            throwInput(
                CULLSCOPE_TR("%1 was written by a newer version of Cullscope (layout %2, this one knows %3): use that one."),
                {m_database.file().string(), std::to_string(version()), std::to_string(kVersion)});
        // What a store never has could make a reader of it busy without end.
        if (numberIn(m_database,
                     "SELECT count(*) FROM sqlite_schema WHERE type IN ('trigger', 'view') OR "
                     "sql LIKE '%VIRTUAL%' OR sql LIKE '%GENERATED%'") != 0)
            m_database.refuse();
    };
    refuseOthers();
    if (version() == kVersion) return;
    m_database.useWriteAheadLog();
    Transaction transaction(m_database);
    // Another program may have been faster.
    refuseOthers();
    for (int64_t next = version(); next < kVersion; ++next) m_database.run(kLayouts[size_t(next)]);
    m_database.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication, kVersion).c_str());
    transaction.commit();
}

int64_t ResultStore::begin(const Meter& meter, const Origin& origin) const {
    const MeasureRequest& request = meter.request();
    const Scene& scene = *request.scene;
    Listed listed;
    listed.started = timeText();
    listed.origin = origin;
    listed.tool = toolVersion();
    listed.cpu = cpuName();
    listed.gl = meter.gl();
    listed.scene = scene.name();
    listed.sceneSha256 = scene.sha256();
    listed.triangles = scene.triangleCount();
    listed.instances = scene.instances().size();
    listed.path = request.path.name;
    listed.poses = request.path.poses.size();
    listed.size = request.size;
    Transaction transaction(m_database);
    const int64_t number = addMeasurement(m_database, listed);
    size_t place = 0;
    for (const Meter::Measuring& each : meter.runs())
        (void)addRun(m_database, {number, ++place, strategyText(each.run->strategy), each.askedFor, each.isLimit,
                                  compact(runHeadFields(*each.run, request))});
    transaction.commit();
    return number;
}

void ResultStore::addPose(int64_t number, const Meter& meter) const {
    Transaction transaction(m_database);
    const std::vector<int64_t> numbers = runNumbers(m_database, number);
    const std::vector<Meter::Measuring> runs = meter.runs();
    for (size_t i = 0; i < std::min(numbers.size(), runs.size()); ++i) {
        const RunMeasurement& run = *runs[i].run;
        // A strategy that was dropped has no frame of this pose.
        if (run.frames.empty() || run.frames.back().pose + 1 != meter.poses()) continue;
        const FrameMeasurement& frame = run.frames.back();
        addFrame(m_database, numbers[i], frame.ownRaster, frameFields(frame), frame.frameTimes, frame.cullTimes,
                 judgedText(frame));
        // The promise is the weakest over the poses.
        Statement update(m_database, "UPDATE run SET head = ?1 WHERE number = ?2 AND head <> ?1");
        update.bind(compact(runHeadFields(run, meter.request()))).bind(numbers[i]).run();
    }
    transaction.commit();
}

void ResultStore::end(int64_t number, bool interrupted) const {
    const Stored stored = read(number);
    Transaction transaction(m_database);
    for (size_t place = 0; place < stored.runs.size(); ++place) {
        Statement keep(m_database, "UPDATE run SET figures = ? WHERE measurement = ? AND place = ?");
        keep.bind(figuresText(figuresOf(stored.runs[place]))).bind(number).bind(int64_t(place) + 1).run();
    }
    Statement update(m_database, "UPDATE measurement SET ended = ?, interrupted = ? WHERE number = ?");
    update.bind(timeText()).bind(int64_t(interrupted)).bind(number).run();
    transaction.commit();
}

void ResultStore::remove(int64_t number) const {
    Transaction transaction(m_database);
    for (const char* sql : {"DELETE FROM frame WHERE run IN (SELECT number FROM run WHERE measurement = ?)",
                            "DELETE FROM run WHERE measurement = ?", "DELETE FROM measurement WHERE number = ?"}) {
        Statement statement(m_database, sql);
        statement.bind(number).run();
    }
    transaction.commit();
}

int64_t ResultStore::addFile(const std::string& json, const std::string& file, const Origin& origin) const {
    try {
        return addDocument(m_database, ResultFields::parse(json), origin);
    } catch (const ResultFields::exception&) {
        throwInput(CULLSCOPE_TR("%1 is no result file of cullbench measure."), {file});
    }
}
void ResultStore::addOld(const std::vector<OldExperiment>& experiments) const {
    Transaction transaction(m_database);
    for (const OldExperiment& experiment : experiments) {
        Listed listed;
        listed.started = experiment.started;
        listed.ended = experiment.started;
        listed.interrupted = false;
        listed.origin = {"measure", ""};
        listed.scene = experiment.scene;
        listed.path = experiment.path;
        listed.size = experiment.size;
        const int64_t number = addMeasurement(m_database, listed);
        size_t place = 0;
        for (const KeptFigures& row : experiment.rows) {
            (void)addRun(m_database, {number, ++place, row.strategy, true, false, "{}", figuresText(row)});
        }
    }
    transaction.commit();
}

int64_t ResultStore::addCertificate(const certify::Certificate& certificate) const {
    Transaction transaction(m_database);
    Statement insert(m_database, "INSERT INTO certificate (added, strategy, document) VALUES (?,?,?)");
    insert.bind(timeText()).bind(certificate.strategy).bind(certify::certificateJson(certificate)).run();
    const int64_t number = m_database.newestRow();
    transaction.commit();
    return number;
}

}  // namespace cullscope::store
