#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/experiments/paper_table.h"
#include "core/scene/scene_source.h"

namespace cullscope {

/// One thing that an experiment does: strategies timed over a path, or (without strategies) structures built for a scene.
struct PaperSetting {
    std::string scene;                    ///< a specification
    std::vector<std::string> strategies;  ///< as `strategyFromText` reads them; what this OpenGL cannot do is left out
    std::string shown;                    ///< the strategy that an audience sees meanwhile
    std::string path;                     ///< built-in name
    Viewport size;
    int windows = 1;
    Upload upload = Upload::Vbo;
    std::map<std::string, PaperValue> labels;                        ///< by column
    std::map<std::string, std::map<std::string, PaperValue>> paper;  ///< what the paper states, by `strategyText` and column

    [[nodiscard]] bool timed() const { return !strategies.empty(); }
};

/// A paper's table, as data: what it states and how the same is measured here. A later experiment is one more of them.
struct PaperExperiment {
    std::string id;
    std::string title;  ///< English, marked for translation
    std::string source;
    std::vector<Message> notes;  ///< where the paper is wrong or silent, and what is done here
    std::vector<PaperColumn> columns;
    std::vector<LinePlot> plots;  ///< axes and the paper's levels; without lines
    std::vector<PaperSetting> settings;
    /// Adds the rows of a setting that was timed; those of the whole poses measured so far where it was stopped.
    void (*addMeasured)(PaperTable& table, const PaperSetting& setting, const MeasureResult& result) = nullptr;
    /// Puts the lines of a setting into the plots, of the whole poses measured so far, in place of those that were there; null
    /// where there are no plots.
    void (*plotMeasured)(PaperTable& table, const PaperSetting& setting, const MeasureResult& result) = nullptr;
    /// Builds the structures of a setting that is not timed and adds its rows. Throws Error(Interrupted) on stop.
    void (*addBuilt)(PaperTable& table, const Scene& scene, const Progress& progress) = nullptr;

    /// Whether any of it needs OpenGL.
    [[nodiscard]] bool timed() const;
};

/// Every experiment, in the order in which lists show them.
[[nodiscard]] const std::vector<PaperExperiment>& paperExperiments();

/// Throws Error(Usage) naming the known ids where there is none of this id.
[[nodiscard]] const PaperExperiment& findPaperExperiment(std::string_view id);

/// The experiment's table before anything is measured.
[[nodiscard]] PaperTable emptyTable(const PaperExperiment& experiment);

/// What `measure` is to do for a timed setting. `repetitions` of each frame; 0: until the median is steady.
[[nodiscard]] MeasureRequest measureRequest(const PaperSetting& setting, const ScenePointer& scene, int repetitions);

/// Adds what came of a setting to its experiment's table: rows, scene, OpenGL, broken promises, whether it was stopped.
void addMeasured(PaperTable& table, const PaperExperiment& experiment, const PaperSetting& setting, const MeasureResult& result);
void addBuilt(PaperTable& table, const PaperExperiment& experiment, const Scene& scene, const Progress& progress);

struct ReproduceOptions {
    SceneSourceOptions sceneSource;
    int repetitions = 0;  ///< of each frame; 0: until the median is steady
};

/// Gets the table after every setting.
using TableObserver = std::function<void(const PaperTable& soFar)>;

/// Opens the experiment's scenes and measures all of it on the calling thread; needs a current context where it is timed. A stop
/// request ends it at the next frame and keeps what was measured; errors are thrown.
[[nodiscard]] PaperTable reproduce(const PaperExperiment& experiment, const ReproduceOptions& options,
                                   const Progress& progress = {}, const TableObserver& afterSetting = {});

}  // namespace cullscope
