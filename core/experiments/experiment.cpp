#include "core/experiments/experiment.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/experiments/run_rows.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

void noteScene(ResultTable& table, const Scene& scene) {
    if (table.scene == scene.name() && table.triangles == scene.triangleCount()) return;
    table.scene = scene.name();
    table.sceneSha256 = scene.sha256();
    table.triangles = scene.triangleCount();
}

/// Notes why strategies have no row; each reason once in a table.
void noteLeftOut(ResultTable& table, const MeasureResult& result) {
    for (const Message& why : result.leftOut) {
        const auto same = [&](const Message& note) { return note.english() == why.english(); };
        if (std::none_of(table.notes.begin(), table.notes.end(), same)) table.notes.push_back(why);
    }
}

void noteBrokenPromises(ResultTable& table, const MeasureResult& result) {
    for (const RunMeasurement& run : result.runs) {
        std::vector<std::string>& broken = table.brokenPromises;
        const std::string strategy = strategyText(run.strategy);
        if (run.promiseBroken() && std::find(broken.begin(), broken.end(), strategy) == broken.end()) broken.push_back(strategy);
    }
}

/// Adds rows, and what follows from all rows so far.
void addRows(ResultTable& table, const Experiment& experiment, const Rows& rows) {
    for (const Row& row : rows) table.addRow(row);
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < experiment.plots.size(); ++i) {
        if (experiment.plots[i].ofFrames()) {
            plots.push_back(table.plots[i]);
            continue;
        }
        for (LinePlot& plot : plotsOf(experiment.plots[i], table)) plots.push_back(std::move(plot));
    }
    table.plots = std::move(plots);
    table.checks = checked(experiment.checks, table);
}

/// Measures a setting that is not timed and adds its rows. `scene`: null where the setting names none.
void addMeasured(ResultTable& table, const Experiment& experiment, const Setting& setting, const ScenePointer& scene,
                 const Progress& progress) {
    if (scene) noteScene(table, *scene);
    // The desktop measures on a thread of its own, which has no context.
    std::optional<HeadlessContext> own;
    if (experiment.draws && !hasCurrentContext()) own.emplace();
    if (experiment.draws) table.gl = requireOpenGl45();
    Rows rows = experiment.measured(setting, scene, progress);
    for (Row& row : rows) row.insert(setting.labels.begin(), setting.labels.end());
    addRows(table, experiment, rows);
}

/// The stage of a program without windows. It keeps the newest scene, its upload and its structures: consecutive settings often
/// use the same one.
ExperimentStage ownStage(const Experiment& experiment, const SceneSourceOptions& source) {
    ExperimentStage stage;
    stage.scene = [&, specification = std::string(), kept = ScenePointer()](size_t number, const Progress& progress) mutable {
        const std::string& wanted = experiment.settings[number].scene;
        if (wanted != specification) kept = wanted.empty() ? nullptr : openScene(wanted, source, progress).scene;
        specification = wanted;
        return kept;
    };
    stage.measure = [shared = std::make_shared<MeasuredScene>()](const MeasureRequest& request, const Progress& progress) {
        return measure(request, progress, {}, shared.get());
    };
    return stage;
}

void runSetting(ResultTable& table, const Experiment& experiment, size_t number, const ExperimentStage& stage, int repetitions,
                const Progress& progress) {
    constexpr double kOpened = 0.05;
    const Setting& setting = experiment.settings[number];
    const ScenePointer scene = stage.scene(number, progress.part(0.0, kOpened));
    const Progress rest = progress.part(kOpened, 1.0);
    if (setting.timed())
        addRuns(table, experiment, setting,
                stage.measure(measureRequest(setting, scene, pathOf(setting, *scene, rest), repetitions), rest));
    else
        addMeasured(table, experiment, setting, scene, rest);
}

void addStrategies(const Axis& axis, Setting& setting) {
    for (const CellValue& value : axis.values) {
        std::string text = std::get<std::string>(value);
        if (axis.kind == Axis::Kind::Parameter) {
            StrategyRequest request = strategyFromText(axis.strategy);
            request.parameters.setFromText(axis.key, text);
            text = strategyText(request);
        }
        if (std::find(setting.strategies.begin(), setting.strategies.end(), text) == setting.strategies.end())
            setting.strategies.push_back(text);
    }
}

void set(Setting& setting, const Axis& axis, const CellValue& value) {
    setting.labels[axis.key] = value;
    if (axis.kind == Axis::Kind::Scene) setting.scene = std::get<std::string>(value);
    if (axis.kind == Axis::Kind::Path) setting.path = std::get<std::string>(value);
}

}  // namespace

bool Experiment::needsOpenGl() const {
    return draws || std::any_of(settings.begin(), settings.end(), [](const Setting& setting) { return setting.timed(); });
}

std::vector<Setting> settingsOf(const std::vector<Axis>& axes, const Setting& common) {
    std::vector<Setting> settings{common};
    for (const Axis& axis : axes) {
        if (axis.kind == Axis::Kind::Strategy || axis.kind == Axis::Kind::Parameter)
            for (Setting& setting : settings) addStrategies(axis, setting);
        if (axis.inTurns()) continue;
        std::vector<Setting> product;
        for (const Setting& setting : settings)
            for (const CellValue& value : axis.values) {
                product.push_back(setting);
                set(product.back(), axis, value);
            }
        settings = std::move(product);
    }
    return settings;
}

std::vector<ResultColumn> columnsOf(const std::vector<Axis>& axes) {
    std::vector<ResultColumn> columns;
    for (const Axis& axis : axes) columns.push_back({axis.key, axis.title, ResultColumn::Origin::Axis});
    return columns;
}

ResultTable emptyTable(const Experiment& experiment) {
    ResultTable table;
    table.experiment = experiment.id;
    table.title = experiment.title;
    table.source = experiment.source;
    table.notes = experiment.notes;
    const auto hasLimit = [](const Setting& setting) { return std::ranges::count(setting.strategies, limitText()) > 0; };
    if (std::ranges::any_of(experiment.settings, hasLimit))
        table.notes.push_back(
            {CULLSCOPE_TR("%1 draws exactly the visible triangles, which are found beforehand: what any culling "
                          "could gain at most. How much of that a method gains is its share of the headroom."),
             {limitText()}});
    table.columns = experiment.columns;
    for (const RowPlot& described : experiment.plots) table.plots.push_back(plotsOf(described, table).front());
    return table;
}

CameraPath pathOf(const Setting& setting, const Scene& scene, const Progress& progress) {
    return setting.views ? setting.views(scene) : cameraPath(setting.path, scene, progress);
}

std::vector<StrategyRequest> requestsOf(const Setting& setting) {
    std::vector<StrategyRequest> requests;
    for (const std::string& strategy : setting.strategies) requests.push_back(strategyFromText(strategy));
    return requests;
}

MeasureRequest measureRequest(const Setting& setting, const ScenePointer& scene, int repetitions) {
    return measureRequest(setting, scene, pathOf(setting, *scene), repetitions);
}

MeasureRequest measureRequest(const Setting& setting, const ScenePointer& scene, const CameraPath& path, int repetitions) {
    MeasureRequest request;
    request.scene = scene;
    request.strategies = requestsOf(setting);
    request.leaveOutUnavailable = true;
    request.path = path;
    request.size = setting.size;
    request.windows = setting.windows;
    request.differentViews = setting.differentViews;
    request.upload = setting.upload;
    request.timing = setting.timing;
    if (repetitions > 0) request.timing.fixedRepetitions = repetitions;
    request.baselinesToo = setting.baselinesToo;
    request.limitToo = setting.limitToo;
    request.refusalsAreResults = setting.refusalsAreResults;
    request.secondsOfAStrategy = setting.secondsOfAStrategy;
    return request;
}

void addRuns(ResultTable& table, const Experiment& experiment, const Setting& setting, const MeasureResult& result) {
    noteScene(table, *result.request.scene);
    table.gl = result.gl;
    table.interrupted = table.interrupted || result.interrupted;
    if (experiment.plotFrames) experiment.plotFrames(table, setting, result);
    addRows(table, experiment, experiment.rowsOfRuns ? experiment.rowsOfRuns(setting, result) : runRows(setting, result));
    noteLeftOut(table, result);
    noteBrokenPromises(table, result);
}

ResultTable runExperiment(const Experiment& experiment, const ExperimentOptions& options, const Progress& progress,
                          const TableObserver& afterSetting, const ExperimentStage& stage) {
    ResultTable table = emptyTable(experiment);
    ExperimentStage used = ownStage(experiment, options.sceneSource);
    if (stage.scene) used.scene = stage.scene;
    if (stage.measure) used.measure = stage.measure;
    const double settings = double(experiment.settings.size());
    for (size_t i = 0; i < experiment.settings.size() && !table.interrupted; ++i) {
        try {
            runSetting(table, experiment, i, used, options.repetitions,
                       progress.part(double(i) / settings, double(i + 1) / settings));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) throw;
            table.interrupted = true;
        }
        if (afterSetting) afterSetting(table);
    }
    return table;
}

}  // namespace cullscope
