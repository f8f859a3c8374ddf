#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/experiments/checks.h"
#include "core/experiments/result_table.h"
#include "core/experiments/row_plots.h"
#include "core/scene/scene_source.h"

namespace cullscope {

/// What is varied in an experiment, by its values.
struct Axis {
    enum class Kind {
        Label,     ///< a label of the settings, which what measures them reads
        Scene,     ///< the settings' scenes, by specification
        Path,      ///< the settings' camera paths
        InTurns,   ///< varied within each setting, by what measures it
        Strategy,  ///< likewise: the settings' strategies, as `strategyFromText` reads them
        Parameter  ///< likewise: the parameter `key` of `strategy`, whose other parameters stay as they are
    };

    std::string key;    ///< of its column
    std::string title;  ///< of its column
    Kind kind = Kind::Label;
    std::vector<CellValue> values;  ///< words but for numbers that are labels
    std::string strategy{};         ///< of a parameter, as `strategyFromText` reads it

    /// Whether its values are compared within a setting, and make no settings.
    [[nodiscard]] bool inTurns() const { return kind == Kind::InTurns || kind == Kind::Strategy || kind == Kind::Parameter; }
};

/// One point of an experiment's axes: strategies timed over a camera path in turns, or (without strategies) what the experiment's
/// own function measures.
struct Setting {
    std::string scene{};                    ///< a scene specification; empty: the experiment's function makes what it measures
    std::vector<std::string> strategies{};  ///< as `strategyFromText` reads them; those that this OpenGL cannot run are left out
    std::string shown{};                    ///< the strategy that is shown on screen during the measurement
    std::string path{};                     ///< name of a built-in camera path, or a file; with `views` a name for these
    std::function<CameraPath(const Scene& scene)> views{};  ///< in place of the camera path of that name
    Viewport size{};
    int windows = 1;
    bool differentViews = false;  ///< MeasureRequest
    Upload upload = Upload::Vbo;
    TimingProtocol timing{};                                              ///< but for the repetitions where the user states them
    bool baselinesToo = false;                                            ///< MeasureRequest
    bool limitToo = false;                                                ///< MeasureRequest
    bool refusalsAreResults = false;                                      ///< MeasureRequest
    double secondsOfAStrategy = std::numeric_limits<double>::infinity();  ///< MeasureRequest
    Row labels{};                                                         ///< of each of its rows
    std::map<std::string, Row> stated{};                                  ///< what the source states, by `strategyText`

    [[nodiscard]] bool timed() const { return baselinesToo || !strategies.empty(); }
    /// A label that is a number, or words; both must be there.
    [[nodiscard]] double number(const std::string& label) const { return std::get<double>(labels.at(label)); }
    [[nodiscard]] const std::string& words(const std::string& label) const { return std::get<std::string>(labels.at(label)); }
};

/// An experiment as data, the one form of a paper's table, a sweep and a benchmark: what is varied, what is measured at each
/// point, what its table and plots show, and what must hold.
struct Experiment {
    std::string id;
    std::string title;  ///< English, marked for translation where it is shown in the desktop
    std::string source{};
    std::vector<Message> notes{};  ///< where the source is wrong or leaves something open, and what is done here
    std::vector<Axis> axes{};
    std::vector<Setting> settings{};  ///< the product of the axes (`settingsOf`); of tables without such an order a list
    std::vector<ResultColumn> columns{};
    std::vector<RowPlot> plots{};  ///< those of single frames first
    std::vector<Check> checks{};
    bool draws = false;  ///< the function `measured` needs a current OpenGL context; it is given one where there is none

    /// The rows of a timed setting; empty: `runRows`. After an early stop: of the poses measured completely.
    std::function<Rows(const Setting& setting, const MeasureResult& result)> rowsOfRuns{};
    /// Replaces the lines of the plots of single frames by those of the poses measured completely so far; empty: there are none.
    std::function<void(ResultTable& table, const Setting& setting, const MeasureResult& result)> plotFrames{};
    /// Measures a setting that is not timed: builds structures, reads files, counts. `scene`: the setting's; null where it names
    /// none. Its rows get the setting's labels. Throws Error(Interrupted) on a stop request.
    std::function<Rows(const Setting& setting, const ScenePointer& scene, const Progress& progress)> measured{};
    /// The same of a scene of the user's, by its specification, without what the source states of its own scenes and without the
    /// checks against that; empty: it has only its own.
    std::function<Experiment(const std::string& scene)> ofScene{};

    /// Whether OpenGL must be current where it runs.
    [[nodiscard]] bool needsOpenGl() const;
};

/// The product of those axes that make settings, the first one varying slowest. Strategies and parameters add to each setting's
/// strategies, to be measured in turns: one parameter over its values, all others as they stand in the axis. `common`: what all
/// settings share.
[[nodiscard]] std::vector<Setting> settingsOf(const std::vector<Axis>& axes, const Setting& common = {});
/// The columns of axes.
[[nodiscard]] std::vector<ResultColumn> columnsOf(const std::vector<Axis>& axes);
/// Numbers as an axis has them.
template <typename Numbers>
[[nodiscard]] std::vector<CellValue> axisValues(const Numbers& numbers) {
    std::vector<CellValue> values;
    for (const auto number : numbers) values.emplace_back(double(number));
    return values;
}

/// The experiment's table before any measurement.
[[nodiscard]] ResultTable emptyTable(const Experiment& experiment);

/// A timed setting's views of its scene.
[[nodiscard]] CameraPath pathOf(const Setting& setting, const Scene& scene, const Progress& progress = {});
/// A setting's strategies.
[[nodiscard]] std::vector<StrategyRequest> requestsOf(const Setting& setting);
/// The request for `measure` that a timed setting needs. `repetitions` of each frame; 0: as the setting says.
[[nodiscard]] MeasureRequest measureRequest(const Setting& setting, const ScenePointer& scene, int repetitions);
/// The same over a path that the caller has, in place of the setting's.
[[nodiscard]] MeasureRequest measureRequest(const Setting& setting, const ScenePointer& scene, const CameraPath& path,
                                            int repetitions);

/// Adds what a timed setting gave to its experiment's table: rows, plots, checks, scene, OpenGL, broken promises, whether it was
/// stopped.
void addRuns(ResultTable& table, const Experiment& experiment, const Setting& setting, const MeasureResult& result);

struct ExperimentOptions {
    SceneSourceOptions sceneSource{};
    int repetitions = 0;  ///< of each frame; 0: as each setting says, by default until the median is steady
};

/// Called with the table after every setting.
using TableObserver = std::function<void(const ResultTable& soFar)>;

/// Where an experiment runs: what opens a setting's scene, and what measures its strategies. What is not given happens on the
/// calling thread: `openScene`, which keeps the newest scene, and `measure`.
struct ExperimentStage {
    /// Called once for each setting, before it is measured, with its number; null for a setting that needs no scene.
    std::function<ScenePointer(size_t setting, const Progress& progress)> scene{};
    std::function<MeasureResult(const MeasureRequest& request, const Progress& progress)> measure{};
};

/// The one driver of experiments: measures all settings, one after the other, on the calling thread. Without a stage a current
/// OpenGL context is needed where the experiment says so. A stop request ends it at the next frame, and what was measured until
/// then is returned; errors are thrown.
[[nodiscard]] ResultTable runExperiment(const Experiment& experiment, const ExperimentOptions& options,
                                        const Progress& progress = {}, const TableObserver& afterSetting = {},
                                        const ExperimentStage& stage = {});

}  // namespace cullscope
