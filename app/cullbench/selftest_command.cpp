#include "app/cullbench/certify_workers.h"
#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/self_test.h"

namespace cullscope::cullbench {
namespace {

struct SelfTestOptions {
    bool gpu = false;
    std::string scene, json;
    uint64_t views = SelfTestRequest().certifiedViews;
    int repeat = 0;
};

void run(const SelfTestOptions& options, Context& context) {
    checkOutputPlaces({options.json});
    SelfTestRequest request;
    request.graphicsCard = options.gpu;
    request.court = options.scene;
    request.certifiedViews = options.views;
    request.experiments = {context.sceneOptions, options.repeat};
    request.trier = workerProcess;
    FILE* out = options.json == "-" ? stderr : stdout;
    const SelfTest test = selfTest(request, terminalProgress(context), [out](const std::string& text) {
        clearProgress();
        printText(out, text + "\n");
        if (out == stdout) flushOutput();
    });
    clearProgress();
    if (!options.json.empty()) writeText(options.json, selfTestJson(test));
    if (test.interrupted)
        context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    else if (!test.right())
        context.exitStatus = 1;
    say(out, "{}: {}\n", test.gl.renderer,
        test.interrupted ? "stopped"
        : test.right()   ? "every promise and check holds"
                         : "something does not hold, see above");
}

}  // namespace

void addSelfTestCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("selftest", "What holds on this machine, and how fast it is, as one file to be sent");
    auto options = std::make_shared<SelfTestOptions>();
    command->add_flag("--gpu", options->gpu, "with the sizes for a graphics card, up to a billion triangles");
    command->add_option("--scene", options->scene, "the scene that is copied behind walls (default: plant)");
    command->add_option("--views", options->views, "random views that are tried of each strategy")
        ->check(CLI::Range(uint64_t{1}, uint64_t{1'000'000'000}))
        ->capture_default_str();
    command->add_option("--repeat", options->repeat, "repetitions of each timed frame (default: 3)")
        ->check(CLI::Range(1, 100000));
    command->add_option("--json", options->json, "result file; - is standard output");
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
