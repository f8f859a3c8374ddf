#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/experiments/store/recorder.h"
#include "core/measure/meter.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"

namespace cullscope::cullbench {

/// The state that all commands share.
struct Context {
    std::stop_token stop;             ///< Ctrl-C
    SceneSourceOptions sceneOptions;  ///< --models
    int exitStatus = 0;               ///< of the command, where it throws no error
    std::string command;              ///< the words that the program was given, as a shell takes them
};

void addListCommand(CLI::App& app, Context& context);
void addRenderCommand(CLI::App& app, Context& context);
void addMeasureCommand(CLI::App& app, Context& context);
void addFigureCommand(CLI::App& app, Context& context);
void addExportCommand(CLI::App& app, Context& context);
void addInspectCommand(CLI::App& app, Context& context);
void addPathCommand(CLI::App& app, Context& context);
void addReproduceCommand(CLI::App& app, Context& context);
void addSweepCommand(CLI::App& app, Context& context);
void addStabilityCommand(CLI::App& app, Context& context);
void addSelfTestCommand(CLI::App& app, Context& context);
void addSuiteCommand(CLI::App& app, Context& context);
void addJudgeCommand(CLI::App& app, Context& context);
void addCertifyCommand(CLI::App& app, Context& context);
void addAdviseCommand(CLI::App& app, Context& context);
void addRaceCommand(CLI::App& app, Context& context);
void addWorstCommand(CLI::App& app, Context& context);
void addStoreCommand(CLI::App& app, Context& context);
void addStudyCommand(CLI::App& app, Context& context);

/// Words of a command line as a POSIX shell takes them, with the program's name in front.
[[nodiscard]] std::string commandLine(const std::vector<std::string>& words);

/// Of --shard I/N: I and N, I from 1 to N. Throws Error(Usage).
[[nodiscard]] std::pair<uint64_t, uint64_t> shardFromText(const std::string& text);

/// A progress bar on standard error where that is a terminal; none in a pipe.
[[nodiscard]] Progress terminalProgress(const Context& context);
/// Removes the bar from the terminal; to be called before a print.
void clearProgress();

/// The scene that a command works on.
struct SceneChoice {
    std::string specification;  ///< SCENE
    std::string hide;           ///< --hide, as in "3,7-9"
};
void addSceneOptions(CLI::App& command, SceneChoice& choice);

/// Opens a scene with a progress bar, without its hidden objects; prints the loader's repairs of the file on standard error.
[[nodiscard]] OpenedScene openSceneForCommand(const SceneChoice& choice, const Context& context);

/// Checks of options: a finite number above 0; one of [least, most]; a whole number from 0.
[[nodiscard]] CLI::Validator positiveNumber();
[[nodiscard]] CLI::Validator numberBetween(double least, double most);
[[nodiscard]] CLI::Validator countFromZero();

/// "640x480". Throws Error(Usage).
[[nodiscard]] Viewport sizeFromText(const std::string& text, const std::string& option = "--size");
/// "x,y,z". Throws Error(Usage) naming the option.
[[nodiscard]] Vec3 vectorFromText(const std::string& option, const std::string& text);

/// Strategies from `-s A,B:key=value` and `-p [A.]key=value`. Throws Error(Usage).
[[nodiscard]] std::vector<StrategyRequest> strategiesOf(const std::vector<std::string>& texts,
                                                        const std::vector<std::string>& parameters);

/// `--projection` and `--height`, with a prefix for a second camera.
struct ProjectionOptions {
    std::string projection;  ///< an id; empty: as the camera or the path has it
    double height = 0.0;     ///< of a parallel view, in scene units; 0: what the camera shows at its target

    [[nodiscard]] bool given() const { return !projection.empty() || height > 0.0; }
    /// The camera with that projection. Throws Error(Usage) for the height of a perspective camera.
    [[nodiscard]] Camera of(const Camera& camera) const;
    /// The path with that projection; its height is that of the first pose.
    void applyTo(CameraPath& path) const;
};
void addProjectionOptions(CLI::App& command, ProjectionOptions& options, const std::string& prefix = "--");

/// How `measure` and `sweep` measure.
struct RunOptions {
    std::string path;  ///< empty: the scene's default
    std::string size = "640x480", upload = "vbo";
    std::string windowViews = "one";
    int windows = 1, repeat = 0;
    double fovx = 0.0;  ///< degrees; 0: the path's own field of view
    ProjectionOptions projection;

    /// Throws Error(Usage).
    [[nodiscard]] Viewport viewport() const { return sizeFromText(size); }
    [[nodiscard]] Upload uploadBy() const { return upload == "vbo" ? Upload::Vbo : Upload::VertexArray; }
    [[nodiscard]] std::string pathFor(const Scene& scene) const { return path.empty() ? defaultPathName(scene) : path; }
    /// The views of that path, with the field of view.
    [[nodiscard]] CameraPath viewsOf(const Scene& scene, const Progress& progress) const;
};
void addRunOptions(CLI::App& command, RunOptions& options);
/// Those of them that say which views: path, lens, projection and size.
void addViewOptions(CLI::App& command, RunOptions& options);
/// --no-limit: without the run of limitOfCulling(), and so without shares of the headroom.
void addLimitOption(CLI::App& command, bool& noLimit);
/// `--fovx`.
CLI::Option* addFieldOption(CLI::App& command, double& fovx);
/// `-s` and `-p`; `strategiesOf` reads them.
void addStrategyOptions(CLI::App& command, std::vector<std::string>& strategies, std::vector<std::string>& parameters);

/// --store FILE: every pose goes into that store once it is measured.
void addStoreOption(CLI::App& command, std::string& store);
/// The recorder of --store; null without it. Throws where the store cannot be opened.
[[nodiscard]] std::unique_ptr<store::Recorder> recorderOf(const std::string& store, const std::string& experiment,
                                                          const Context& context);
/// Throws the Error that kept measurements from the store; to be called when everything else is said.
void requireRecorded(const std::unique_ptr<store::Recorder>& recorder);

/// --store FILE of a command that measures no frames to keep: the report goes into that store.
void addReportStoreOption(CLI::App& command, std::string& store);
/// The store of that option, opened before the work, so that a wrong name is told then; without the option it keeps nothing.
class ReportKeeper {
public:
    ReportKeeper(const std::string& store, const Context& context);
    /// With the command of the context. What was interrupted is not kept: a study would take it for done.
    void keep(store::Report report) const;

private:
    std::optional<store::ResultStore> m_store;
    const Context& m_context;
};

/// Throws Error(OpenGl) with one sentence where this OpenGL does not meet a strategy's requirement.
void requireAvailable(const StrategyRequest& request, const GlInfo& gl);

/// Checks that files can be written (requireWritable), before the work instead of after it; empty paths pass. Throws
/// Error(Usage), also where two of them are one file, or one is a result store or the `store` that is written to: a result file
/// in its place would take all measurements away.
void checkOutputPlaces(const std::vector<std::string>& paths, const std::string& store = {});

/// Throws Error(Interrupted): a measurement was stopped before it had anything that could be written in place of an older result.
[[noreturn]] void throwNothingMeasured();

/// Writes text to a file, completely or not at all; "-" is standard output.
void writeText(const std::string& path, const std::string& text);

}  // namespace cullscope::cullbench
