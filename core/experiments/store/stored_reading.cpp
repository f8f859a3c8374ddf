#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/experiments/result_fields.h"
#include "core/experiments/store/judged_frames.h"
#include "core/experiments/store/result_store.h"
#include "core/measure/summary.h"

namespace cullscope::store {
namespace {

constexpr const char* kColumns =
    "number, started, ended, interrupted, experiment, command, tool_name, tool_version, tool_commit, cpu, gl_renderer, "
    "gl_version, gl_software, scene, scene_sha256, triangles, instances, path, poses, width, height, "
    "(SELECT count(DISTINCT pose) FROM frame JOIN run ON run.number = frame.run WHERE run.measurement = measurement.number)";

Listed listedOf(const Statement& row) {
    Listed listed;
    listed.number = row.number(0);
    listed.started = row.text(1);
    if (!row.isNothing(2)) listed.ended = row.text(2);
    listed.interrupted = row.number(3) != 0;
    listed.origin = {row.text(4), row.text(5)};
    listed.tool = {row.text(6), row.text(7), row.text(8)};
    listed.cpu = row.text(9);
    listed.gl.renderer = row.text(10);
    listed.gl.version = row.text(11);
    listed.gl.software = row.number(12) != 0;
    listed.scene = row.text(13);
    listed.sceneSha256 = row.text(14);
    listed.triangles = uint64_t(row.number(15));
    listed.instances = uint64_t(row.number(16));
    listed.path = row.text(17);
    listed.poses = uint64_t(row.number(18));
    listed.size = {static_cast<int>(row.number(19)), static_cast<int>(row.number(20))};
    listed.measured = uint64_t(row.number(21));
    return listed;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return c < 128 ? char(std::tolower(c)) : char(c); });
    return text;
}

bool has(const std::string& text, const std::string& part) { return lower(text).find(lower(part)) != std::string::npos; }

bool shown(const std::string& scene, const std::vector<std::string>& strategies, const std::string& when, const Filter& filter) {
    if (!has(scene, filter.scene)) return false;
    const auto named = [&](const std::string& strategy) { return has(strategy, filter.strategy); };
    if (!filter.strategy.empty() && std::ranges::none_of(strategies, named)) return false;
    if (!filter.since.empty() && when.substr(0, filter.since.size()) < filter.since) return false;
    return filter.until.empty() || when.substr(0, filter.until.size()) <= filter.until;
}

constexpr const char* kReportColumns = "number, added, kind, scene, strategy, command, words, document";

StoredReport reportOf(const Database& database, const Statement& row) {
    StoredReport stored{
        row.number(0), row.text(1), {row.text(2), row.text(3), row.text(4), row.text(5), row.text(6), row.text(7)}};
    if (!ResultFields::accept(stored.report.document)) database.refuse();
    return stored;
}

/// A number that no measurement gives.
struct Damaged {};

/// Milliseconds, with which ratios can be computed.
double time(double milliseconds, double least) {
    constexpr double kMost = 1e12;
    if (!(milliseconds >= least && milliseconds < kMost)) throw Damaged{};
    return milliseconds;
}

std::vector<double> times(const std::string& text, double least) {
    std::vector<double> all = ResultFields::parse(text).get<std::vector<double>>();
    for (const double milliseconds : all) (void)time(milliseconds, least);
    return all;
}

constexpr double kLeastFrame = 1e-9;  // milliseconds

/// What ratios, losses and summaries need of a frame.
FrameMeasurement frameOf(const ResultFields& fields, bool ownRaster, const std::string& frameTimes,
                         const std::string& cullTimes) {
    FrameMeasurement frame;
    frame.pose = fields.at("pose").get<size_t>();
    frame.frameMilliseconds = time(fields.at("frame_ms").get<double>(), kLeastFrame);
    frame.cullMilliseconds = time(fields.at("cull_ms").get<double>(), 0.0);
    frame.repetitions = fields.at("repetitions").get<int>();
    frame.frameTimes = times(frameTimes, kLeastFrame);
    frame.cullTimes = times(cullTimes, 0.0);
    frame.submitted.triangles = fields.at("submitted_triangles").get<uint64_t>();
    frame.consideredTriangles = fields.at("considered_triangles").get<uint64_t>();
    frame.ownRaster = ownRaster;
    if (fields.at("covered_pixels").is_null()) return frame;
    Accuracy accuracy;
    accuracy.coveredPixels = fields.at("covered_pixels").get<uint64_t>();
    accuracy.missedPixels = fields.at("missed_pixels").get<uint64_t>();
    accuracy.extraPixels = fields.at("extra_pixels").get<uint64_t>();
    accuracy.largestHolePixels = fields.at("largest_hole_px").get<uint64_t>();
    frame.accuracy = accuracy;
    frame.missedBeyondSnapping = fields.at("missed_beyond_snapping").get<uint64_t>();
    return frame;
}

Facing facingFrom(const std::string& id) {
    for (size_t facing = 0; facing < kFacingRules; ++facing)
        if (id == facingId(static_cast<Facing>(facing))) return static_cast<Facing>(facing);
    return Facing::TwoSided;
}

/// A strategy as text, one of which this program knows nothing as well.
StrategyRequest requestFrom(const std::string& text) {
    try {
        return strategyFromText(text);
    } catch (const Error&) {
        return {text, {}};
    }
}

void readHead(StoredRun& stored) {
    const ResultFields head = ResultFields::parse(stored.head);
    RunMeasurement& run = stored.run;
    run.strategy = requestFrom(stored.strategy);
    if (head.empty()) return;
    for (const Promise promise : {Promise::Exact, Promise::Conservative, Promise::Approximate})
        if (head.at("promise") == promiseId(promise)) run.promise = promise;
    run.facing = facingFrom(head.at("facing").get<std::string>());
    run.referenceFacing = facingFrom(head.at("reference_facing").get<std::string>());
    run.ownRule = requestFrom(head.at("same_sides_baseline").get<std::string>());
    run.structure.buildMilliseconds = head.at("build_ms").get<double>();
    run.structure.bytes = head.at("structure_bytes").get<uint64_t>();
}

void readFrames(const Database& database, int64_t number, StoredRun& stored) {
    Statement select(database,
                     "SELECT fields, own_raster, frame_times, cull_times, judged FROM frame WHERE run = ? ORDER BY pose");
    select.bind(number);
    while (select.next()) {
        stored.frames.push_back(select.text(0));
        stored.run.frames.push_back(
            frameOf(ResultFields::parse(stored.frames.back()), select.number(1) != 0, select.text(2), select.text(3)));
        if (!select.isNothing(4)) addJudged(select.text(4), stored.run.frames.back());
    }
}

void summarize(Stored& stored) {
    std::vector<RunMeasurement> all;
    for (const StoredRun& each : stored.runs) all.push_back(each.run);
    for (StoredRun& each : stored.runs) each.run.summary = summaryOf(each.run, all, stored.listed.triangles);
}

}  // namespace

const StoredRun* Stored::find(const std::string& strategy) const {
    const auto found = std::ranges::find(runs, strategy, &StoredRun::strategy);
    return found == runs.end() ? nullptr : &*found;
}

StrategyRequest strategyOfHead(const std::string& head) {
    const ResultFields fields = ResultFields::parse(head);
    const auto id = fields.at("strategy").get<std::string>();
    std::string text = id;
    for (const auto& [key, value] : fields.at("parameters").items())
        text += ":" + key + "=" + (value.is_string() ? value.get<std::string>() : value.dump());
    StrategyRequest request = requestFrom(text);
    return request;
}

std::vector<Listed> ResultStore::list(const Filter& filter) const {
    const Transaction reading(m_database, Transaction::Purpose::Read);
    std::vector<Listed> all;
    Statement select(m_database, (std::string("SELECT ") + kColumns + " FROM measurement ORDER BY started, number").c_str());
    while (select.next()) {
        Listed listed = listedOf(select);
        Statement strategies(m_database, "SELECT strategy FROM run WHERE measurement = ? AND asked_for ORDER BY place");
        strategies.bind(listed.number);
        while (strategies.next()) listed.strategies.push_back(strategies.text(0));
        if (shown(listed.scene, listed.strategies, listed.started, filter)) all.push_back(std::move(listed));
    }
    return all;
}

Stored ResultStore::read(int64_t number) const {
    const Transaction reading(m_database, Transaction::Purpose::Read);
    Stored stored;
    {
        Statement select(m_database, (std::string("SELECT ") + kColumns + " FROM measurement WHERE number = ?").c_str());
        select.bind(number);
        if (!select.next())
            throwUsage(CULLSCOPE_TR("%1 has no measurement %2: list them with cullbench store %1 list."),
                       {m_database.file().string(), std::to_string(number)});
        stored.listed = listedOf(select);
    }
    try {
        Statement select(
            m_database,
            "SELECT number, strategy, asked_for, is_limit, head, figures FROM run WHERE measurement = ? ORDER BY place");
        select.bind(number);
        while (select.next()) {
            StoredRun run;
            run.strategy = select.text(1);
            run.askedFor = select.number(2) != 0;
            run.isLimit = select.number(3) != 0;
            run.head = select.text(4);
            readHead(run);
            readFrames(m_database, select.number(0), run);
            if (!select.isNothing(5) && run.frames.empty()) run.old = keptFigures(run.strategy, select.text(5));
            if (run.askedFor) stored.listed.strategies.push_back(run.strategy);
            stored.runs.push_back(std::move(run));
        }
    } catch (const ResultFields::exception&) {
        m_database.refuse();
    } catch (const Damaged&) {
        m_database.refuse();
    }
    summarize(stored);
    return stored;
}

KeptFigures keptFigures(std::string strategy, const std::string& text) {
    const ResultFields json = ResultFields::parse(text);
    KeptFigures figures;
    figures.strategy = std::move(strategy);
    figures.baseline = json.at("baseline").get<std::string>();
    if (json.contains("ratio")) {
        RatioEstimate ratio;
        ratio.ratio = json.at("ratio").get<double>();
        ratio.hasInterval = json.contains("ratio_ci95");
        ratio.ci95 = {2.0 * ratio.ratio, 2.0 * ratio.ratio};
        if (ratio.hasInterval) ratio.ci95 = json.at("ratio_ci95").get<std::array<double, 2>>();
        figures.ratio = ratio;
    }
    if (json.contains("missed_ppm")) figures.missedPpm = json.at("missed_ppm").get<double>();
    return figures;
}

KeptFigures figuresOf(const StoredRun& run) {
    KeptFigures figures{run.strategy, strategyText(run.run.ownRule), {}, {}};
    if (run.run.summary.ratioToOwnRule.ratio > 0.0) figures.ratio = run.run.summary.ratioToOwnRule;
    constexpr double kMillion = 1e6;
    if (const std::optional<Losses> losses = run.run.losses(); losses && losses->coveredPixels > 0)
        figures.missedPpm = kMillion * double(losses->beyondSnapping ? losses->missedBeyondSnapping : losses->missedPixels) /
                            double(losses->coveredPixels);
    return figures;
}

std::vector<KeptFigures> ResultStore::figures(int64_t number) const {
    std::vector<KeptFigures> all;
    try {
        Statement select(m_database, "SELECT strategy, figures FROM run WHERE measurement = ? AND asked_for ORDER BY place");
        select.bind(number);
        while (select.next()) {
            if (select.isNothing(1)) {
                all.clear();
                break;
            }
            all.push_back(keptFigures(select.text(0), select.text(1)));
        }
    } catch (const ResultFields::exception&) {
        m_database.refuse();
    }
    if (!all.empty()) return all;
    for (const StoredRun& run : read(number).runs)
        if (run.askedFor) all.push_back(run.old ? *run.old : figuresOf(run));
    return all;
}

std::vector<StoredReport> ResultStore::reports(const Filter& filter) const {
    std::vector<StoredReport> all;
    Statement select(m_database, (std::string("SELECT ") + kReportColumns + " FROM report ORDER BY number").c_str());
    while (select.next()) {
        StoredReport stored = reportOf(m_database, select);
        if (shown(stored.report.scene, {stored.report.strategy}, stored.added, filter)) all.push_back(std::move(stored));
    }
    return all;
}

StoredReport ResultStore::report(int64_t number) const {
    Statement select(m_database, (std::string("SELECT ") + kReportColumns + " FROM report WHERE number = ?").c_str());
    select.bind(number);
    if (!select.next())
        throwUsage(CULLSCOPE_TR("%1 has no report %2: list them with cullbench store %1 list."),
                   {m_database.file().string(), std::to_string(number)});
    return reportOf(m_database, select);
}

}  // namespace cullscope::store
