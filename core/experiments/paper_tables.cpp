#include "core/experiments/paper_tables.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/experiments/cho_figure_6.h"
#include "core/experiments/han_hong_tables.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

/// Keeps the newest scene: consecutive settings often use the same one.
class SceneKeeper {
public:
    explicit SceneKeeper(const SceneSourceOptions& options) : m_options(options) {}

    const ScenePointer& open(const std::string& specification, const Progress& progress) {
        if (!m_scene || specification != m_specification) m_scene = openScene(specification, m_options, progress).scene;
        m_specification = specification;
        return m_scene;
    }

private:
    const SceneSourceOptions& m_options;
    std::string m_specification;
    ScenePointer m_scene;
};

void noteScene(PaperTable& table, const Scene& scene) {
    if (table.scene == scene.name() && table.triangles == scene.triangleCount()) return;
    table.scene = scene.name();
    table.sceneSha256 = scene.sha256();
    table.triangles = scene.triangleCount();
}

/// Notes why strategies have no row; each reason once in a table.
void noteLeftOut(PaperTable& table, const MeasureResult& result) {
    for (const Message& why : result.leftOut) {
        const auto same = [&](const Message& note) { return note.english() == why.english(); };
        if (std::none_of(table.notes.begin(), table.notes.end(), same)) table.notes.push_back(why);
    }
}

void runSetting(PaperTable& table, const PaperExperiment& experiment, const PaperSetting& setting, SceneKeeper& scenes,
                int repetitions, const Progress& progress) {
    constexpr double kOpened = 0.05;
    const ScenePointer& scene = scenes.open(setting.scene, progress.part(0.0, kOpened));
    const Progress rest = progress.part(kOpened, 1.0);
    if (setting.timed())
        addMeasured(table, experiment, setting, measure(measureRequest(setting, scene, repetitions), rest));
    else
        addBuilt(table, experiment, *scene, rest);
}

}  // namespace

bool PaperExperiment::timed() const {
    return std::any_of(settings.begin(), settings.end(), [](const PaperSetting& setting) { return setting.timed(); });
}

const std::vector<PaperExperiment>& paperExperiments() {
    static const std::vector<PaperExperiment> kExperiments = [] {
        std::vector<PaperExperiment> experiments = hanHongTables();
        experiments.push_back(choFigure6());
        return experiments;
    }();
    return kExperiments;
}

const PaperExperiment& findPaperExperiment(std::string_view id) {
    std::string known;
    for (const PaperExperiment& experiment : paperExperiments()) {
        if (experiment.id == id) return experiment;
        known += (known.empty() ? "" : ", ") + experiment.id;
    }
    throwUsage(CULLSCOPE_TR("There is no experiment \"%1\". Known: %2."), {std::string(id), known});
}

PaperTable emptyTable(const PaperExperiment& experiment) {
    PaperTable table;
    table.experiment = experiment.id;
    table.title = experiment.title;
    table.source = experiment.source;
    table.notes = experiment.notes;
    table.columns = experiment.columns;
    table.plots = experiment.plots;
    return table;
}

MeasureRequest measureRequest(const PaperSetting& setting, const ScenePointer& scene, int repetitions) {
    MeasureRequest request;
    request.scene = scene;
    for (const std::string& strategy : setting.strategies) request.strategies.push_back(strategyFromText(strategy));
    request.leaveOutUnavailable = true;
    request.path = cameraPath(setting.path, *scene);
    request.size = setting.size;
    request.windows = setting.windows;
    request.upload = setting.upload;
    request.timing.fixedRepetitions = repetitions;
    return request;
}

void addMeasured(PaperTable& table, const PaperExperiment& experiment, const PaperSetting& setting, const MeasureResult& result) {
    noteScene(table, *result.request.scene);
    table.gl = result.gl;
    table.interrupted = table.interrupted || result.interrupted;
    experiment.addMeasured(table, setting, result);
    if (experiment.plotMeasured != nullptr) experiment.plotMeasured(table, setting, result);
    noteLeftOut(table, result);
    for (const RunMeasurement& run : result.runs) {
        std::vector<std::string>& broken = table.brokenPromises;
        const std::string strategy = strategyText(run.strategy);
        if (run.promiseBroken() && std::find(broken.begin(), broken.end(), strategy) == broken.end()) broken.push_back(strategy);
    }
}

void addBuilt(PaperTable& table, const PaperExperiment& experiment, const Scene& scene, const Progress& progress) {
    noteScene(table, scene);
    experiment.addBuilt(table, scene, progress);
}

PaperTable reproduce(const PaperExperiment& experiment, const ReproduceOptions& options, const Progress& progress,
                     const TableObserver& afterSetting) {
    PaperTable table = emptyTable(experiment);
    SceneKeeper scenes(options.sceneSource);
    const double settings = double(experiment.settings.size());
    for (size_t i = 0; i < experiment.settings.size() && !table.interrupted; ++i) {
        try {
            runSetting(table, experiment, experiment.settings[i], scenes, options.repetitions,
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
