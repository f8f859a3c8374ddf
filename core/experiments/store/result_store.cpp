#include "core/experiments/store/result_store.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "core/base/error.h"
#include "core/experiments/result_fields.h"
#include "core/experiments/store/judged_frames.h"
#include "core/experiments/store/rows.h"
#include "core/experiments/store/schema.h"

namespace cullscope::store {
namespace {

int64_t numberIn(const Database& database, const char* pragma) {
    Statement statement(database, pragma);
    return statement.next() ? statement.number(0) : 0;
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

}  // namespace

std::string timeText() {
    using namespace std::chrono;
    return timeText(floor<milliseconds>(system_clock::now()));
}

std::string timeText(std::chrono::sys_time<std::chrono::milliseconds> now) {
    using namespace std::chrono;
    const std::time_t seconds = system_clock::to_time_t(now);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour,
                       utc.tm_min, utc.tm_sec, (now.time_since_epoch() % 1000).count());
}

ResultStore::ResultStore(const std::filesystem::path& file, Database::Access access) : m_database(file, access) {
    // An empty file would become a store.
    std::error_code unknown;
    if (access == Database::Access::Existing && std::filesystem::file_size(file, unknown) == 0 && !unknown) m_database.refuse();
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

}  // namespace cullscope::store
