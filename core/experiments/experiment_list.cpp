#include "core/experiments/experiment_list.h"

#include "core/base/error.h"
#include "core/experiments/bsp_planes.h"
#include "core/experiments/cho_figure_6.h"
#include "core/experiments/han_hong_layouts.h"
#include "core/experiments/han_hong_readings.h"
#include "core/experiments/han_hong_tables.h"
#include "core/experiments/han_hong_views.h"
#include "core/experiments/lecture_quiz.h"
#include "core/experiments/lecture_table.h"
#include "core/experiments/occlusion_growth.h"
#include "core/experiments/plant_figures.h"

namespace cullscope {

const std::vector<Experiment>& knownExperiments() {
    static const std::vector<Experiment> kExperiments = [] {
        std::vector<Experiment> experiments = hanHongTables();
        experiments.push_back(han_hong::tableLayouts());
        experiments.push_back(han_hong::tableViews());
        experiments.push_back(sphericalReadings());
        experiments.push_back(sphericalDomain());
        for (Experiment& figure : choFigure6()) experiments.push_back(std::move(figure));
        experiments.push_back(lectureTable());
        for (Experiment& question : lectureQuestions()) experiments.push_back(std::move(question));
        experiments.push_back(bspPlanes());
        for (Experiment& plants : plantFigures()) experiments.push_back(std::move(plants));
        for (Experiment& growth : occlusionGrowth()) experiments.push_back(std::move(growth));
        return experiments;
    }();
    return kExperiments;
}

const Experiment& findExperiment(std::string_view id) {
    std::string known;
    for (const Experiment& experiment : knownExperiments()) {
        if (experiment.id == id) return experiment;
        known += (known.empty() ? "" : ", ") + experiment.id;
    }
    throwUsage(CULLSCOPE_TR("There is no experiment \"%1\". Known: %2."), {std::string(id), known});
}

}  // namespace cullscope
