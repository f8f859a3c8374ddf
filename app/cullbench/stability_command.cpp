#include <algorithm>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/reports.h"
#include "core/gpu/context.h"

namespace cullscope::cullbench {
namespace {

struct StabilityOptions {
    std::string which, json, store;
    bool everything = false;
};

void run(const StabilityOptions& options, Context& context) {
    const std::vector<const stability::StabilityCase*> cases = stability::casesNamed(options.which);
    checkOutputPlaces({options.json}, options.store);
    const ReportKeeper keeper(options.store, context);
    const HeadlessContext gl;
    Renderer renderer;
    std::vector<stability::CaseResult> results;
    try {
        for (size_t i = 0; i < cases.size(); ++i)
            results.push_back(stability::runCase(
                {renderer, gl.info(),
                 terminalProgress(context).part(double(i) / double(cases.size()), double(i + 1) / double(cases.size()))},
                *cases[i]));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Interrupted || results.empty()) throw;
        context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    }
    clearProgress();
    const bool right = std::ranges::all_of(results, &stability::CaseResult::right);
    if (context.exitStatus == 0 && !right) context.exitStatus = 1;
    if (!options.json.empty()) writeText(options.json, stability::batteryJson(results, gl.info()));
    printText(options.json == "-" ? stderr : stdout, stability::batteryText(results, options.everything || cases.size() == 1));
    keeper.keep(reportOf(results, gl.info()));
}

}  // namespace

void addStabilityCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("stability", "Runs the battery of extreme cases over every strategy");
    auto options = std::make_shared<StabilityOptions>();
    command->add_option("--case", options->which, "number or name of a case, as in 16 or 16-bowl (default: all)");
    command->add_flag("--all-findings", options->everything, "a line for each finding too");
    command->add_option("--json", options->json, "result file; - is standard output");
    addReportStoreOption(*command, options->store);
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
