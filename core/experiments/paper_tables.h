#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/experiments/paper_table.h"
#include "core/scene/scene_source.h"

namespace cullscope {

/// One step of an experiment: strategies timed over a camera path, or (without strategies) structures built for a scene.
struct PaperSetting {
    std::string scene;                    ///< a scene specification
    std::vector<std::string> strategies;  ///< as `strategyFromText` reads them; those that this OpenGL cannot run are left out
    std::string shown;                    ///< the strategy that is shown on screen during the measurement
    std::string path;                     ///< name of a built-in camera path
    Viewport size;
    int windows = 1;
    Upload upload = Upload::Vbo;
    std::map<std::string, PaperValue> labels;                        ///< by column
    std::map<std::string, std::map<std::string, PaperValue>> paper;  ///< the paper's values, by `strategyText` and column

    [[nodiscard]] bool timed() const { return !strategies.empty(); }
};

/// One experiment of a paper, as data: the values that the paper states and how the same are measured here.
struct PaperExperiment {
    std::string id;
    std::string title;  ///< English, marked for translation
    std::string source;
    std::vector<Message> notes;  ///< where the paper is wrong or leaves something open, and what is done here
    std::vector<PaperColumn> columns;
    std::vector<LinePlot> plots;  ///< axes and the paper's reference levels; without lines
    std::vector<PaperSetting> settings;
    /// Adds the rows of a timed setting. After an early stop: of the poses measured completely.
    void (*addMeasured)(PaperTable& table, const PaperSetting& setting, const MeasureResult& result) = nullptr;
    /// Replaces the plots' lines of a setting by those of the poses measured completely so far; null where there are no plots.
    void (*plotMeasured)(PaperTable& table, const PaperSetting& setting, const MeasureResult& result) = nullptr;
    /// Builds the structures of a setting that is not timed, and adds its rows. Throws Error(Interrupted) on a stop request.
    void (*addBuilt)(PaperTable& table, const Scene& scene, const Progress& progress) = nullptr;

    /// Whether any setting is timed and therefore needs OpenGL.
    [[nodiscard]] bool timed() const;
};

/// Every experiment, in the order in which lists show them.
[[nodiscard]] const std::vector<PaperExperiment>& paperExperiments();
/// Stands for all of them where one is asked for by its id.
inline constexpr const char* kAllExperiments = "all";

/// The experiment with this id. Throws Error(Usage) naming the known ids where there is none.
[[nodiscard]] const PaperExperiment& findPaperExperiment(std::string_view id);

/// The experiment's table before any measurement.
[[nodiscard]] PaperTable emptyTable(const PaperExperiment& experiment);

/// The request for `measure` that a timed setting needs. `repetitions` of each frame; 0: until the median is steady.
[[nodiscard]] MeasureRequest measureRequest(const PaperSetting& setting, const ScenePointer& scene, int repetitions);

/// Adds the results of a setting to its experiment's table: rows, scene, OpenGL, broken promises, whether it was stopped.
void addMeasured(PaperTable& table, const PaperExperiment& experiment, const PaperSetting& setting, const MeasureResult& result);
void addBuilt(PaperTable& table, const PaperExperiment& experiment, const Scene& scene, const Progress& progress);

struct ReproduceOptions {
    SceneSourceOptions sceneSource;
    int repetitions = 0;  ///< of each frame; 0: until the median is steady
};

/// Called with the table after every setting.
using TableObserver = std::function<void(const PaperTable& soFar)>;

/// Opens the experiment's scenes and measures all settings on the calling thread; needs a current OpenGL context if any setting
/// is timed. A stop request ends it at the next frame, and what was measured until then is returned; errors are thrown.
[[nodiscard]] PaperTable reproduce(const PaperExperiment& experiment, const ReproduceOptions& options,
                                   const Progress& progress = {}, const TableObserver& afterSetting = {});

}  // namespace cullscope
