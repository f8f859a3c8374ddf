#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/experiments/result_file.h"
#include "core/experiments/store/database.h"
#include "core/experiments/store/report.h"
#include "core/image/line_plot.h"
#include "core/measure/meter.h"

namespace cullscope::store {

/// What is measured, by whom and why.
struct Origin {
    std::string experiment;  ///< its id, where it is one of several settings; "measure" of a measurement by itself
    std::string command;     ///< that repeats it
};

/// A measurement of the store, without its frames.
struct Listed {
    int64_t number = 0;
    std::string started;               ///< UTC, as 2026-11-25T16:50:46.123Z
    std::optional<std::string> ended;  ///< none: it is still measured, or its program was killed
    bool interrupted = true;           ///< poses are missing
    Origin origin;
    ToolVersion tool;
    std::string cpu;
    GlInfo gl;
    std::string scene, sceneSha256;
    uint64_t triangles = 0, instances = 0;
    std::string path;
    uint64_t poses = 0;     ///< of the path
    uint64_t measured = 0;  ///< of them
    Viewport size{};
    std::vector<std::string> strategies;  ///< strategyText of those that were asked for
};

/// The figures that a list of measurements shows of a run, kept when it ends: a list need not read all frames. Of an experiment
/// that the desktop's history had before there was a store they are all that is left.
struct KeptFigures {
    std::string strategy, baseline;
    std::optional<RatioEstimate> ratio;
    std::optional<double> missedPpm;
};
/// The figures of a strategy's run from their text, JSON as a store and the desktop's former history have it. Throws
/// nlohmann::json::exception where a field is wanting or of another kind.
[[nodiscard]] KeptFigures keptFigures(std::string strategy, const std::string& text);
struct OldExperiment {
    std::string started, scene, path;
    Viewport size{};
    std::vector<KeptFigures> rows;
};

/// A run with its frames.
struct StoredRun {
    std::string strategy;              ///< strategyText
    RunMeasurement run;                ///< what ratios, losses and summaries need of it
    bool askedFor = true;              ///< false: a baseline that was measured only for the ratios
    bool isLimit = false;              ///< MeasureResult::limit
    std::string head;                  ///< its fields as JSON
    std::vector<std::string> frames;   ///< likewise, by pose
    std::optional<KeptFigures> old{};  ///< of an experiment of an older program: all that is left of it
};

struct Stored {
    Listed listed;
    std::vector<StoredRun> runs;

    /// The run of a strategy, baselines that were not asked for and the limit included; null: there is none.
    [[nodiscard]] const StoredRun* find(const std::string& strategy) const;
};

/// What a list is to show; empty members take all.
struct Filter {
    std::string scene;         ///< a part of its name, whatever its case
    std::string strategy;      ///< a part of a strategy's text
    std::string since, until;  ///< the beginnings of a date, both included: 2026, 2026-11, 2026-11-25
};

/// What was to be added. A measurement is there already where one was begun at the same millisecond on the same machine, of the
/// same scene, path and experiment, with the same runs; a certificate where one has the same document, and another report where
/// one was added at the same time, too.
struct Added {
    int64_t number = 0;  ///< of the new one, or of the one that is there
    bool isNew = true;
    std::string kind{};  ///< of a report; empty: it is a measurement
};

/// One file with measurements (SQLite, write-ahead log). Several programs may write at once. What was committed stays, whatever
/// ends the program.
class ResultStore {
public:
    /// The version of the file's layout. A newer file is refused with a sentence, an older one is migrated.
    static constexpr int kVersion = 4;

    /// Opens a store, or makes one.
    explicit ResultStore(const std::filesystem::path& file, Database::Access access = Database::Access::Write);

    [[nodiscard]] std::vector<Listed> list(const Filter& filter = {}) const;
    /// Throws Error(Usage) where there is no measurement of that number.
    [[nodiscard]] Stored read(int64_t number) const;
    /// The kept figures of a measurement's strategies that were asked for; of one that has no end they are computed.
    [[nodiscard]] std::vector<KeptFigures> figures(int64_t number) const;
    void remove(int64_t number) const;

    /// Adds a measurement without frames and returns its number; a pose's frames, all of them or none; and its end.
    [[nodiscard]] int64_t begin(const Meter& meter, const Origin& origin) const;
    void addPose(int64_t number, const Meter& meter) const;
    void end(int64_t number, bool interrupted) const;
    /// Adds a result file of `cullbench measure`. Its frames have no repetitions: they are one number each.
    /// `started`: when it was measured. Throws Error(Input), naming `file`, where the text is none.
    [[nodiscard]] Added addFile(const std::string& json, const std::string& file, const Origin& origin,
                                const std::string& started) const;
    /// Adds the measurements and reports of another store, each as a whole, as a study's parts are brought together.
    [[nodiscard]] std::vector<Added> addAll(const ResultStore& other) const;

    /// Adds them all, or none.
    void addOld(const std::vector<OldExperiment>& experiments) const;

    [[nodiscard]] Added add(const Report& report) const;
    [[nodiscard]] std::vector<StoredReport> reports(const Filter& filter = {}) const;
    /// Throws Error(Usage) where there is no report of that number.
    [[nodiscard]] StoredReport report(int64_t number) const;

    [[nodiscard]] const Database& database() const { return m_database; }

private:
    void bringToVersion() const;

    Database m_database;
};

/// Of a run with its summary.
[[nodiscard]] KeptFigures figuresOf(const StoredRun& run);

/// The time now as the store has it.
[[nodiscard]] std::string timeText();
[[nodiscard]] std::string timeText(std::chrono::sys_time<std::chrono::milliseconds> time);

/// The strategy of a run's fields, as a request; one that this program does not know has its text as id and no parameters.
[[nodiscard]] StrategyRequest strategyOfHead(const std::string& head);

/// A measurement as the result files that `cullbench measure` writes.
[[nodiscard]] std::string storedJson(const Stored& stored);
/// Several: their result files as an array of `measurements`, and what the reports say as one of `reports`, with their numbers.
[[nodiscard]] std::string storedJson(const std::vector<Stored>& stored, const std::vector<StoredReport>& reports = {});
/// The time of a frame by pose, a line for each strategy.
[[nodiscard]] LinePlot framePlot(const Stored& stored);
/// One row a frame. Of several measurements each row begins with the measurement's number.
[[nodiscard]] std::string storedCsv(const std::vector<Stored>& stored);

}  // namespace cullscope::store
