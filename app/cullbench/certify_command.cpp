#include <algorithm>
#include <charconv>

#include "app/cullbench/certify_workers.h"
#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/certify/certify.h"

namespace cullscope::cullbench {
namespace {

struct CertifyOptions {
    std::string shard, state, cases, json;
    std::string store;
    std::vector<std::string> strategies, parameters, merge;
    uint64_t views = 10'000, seed = 1;
    size_t threads = 0;
    bool worker = false;
};

void report(const std::vector<certify::Certificate>& certificates, const CertifyOptions& options, const ReportKeeper& keeper,
            Context& context) {
    const auto lost = [](const certify::Certificate& one) { return !one.counterexamples.empty(); };
    if (context.stop.stop_requested() && !std::ranges::all_of(certificates, &certify::Certificate::complete))
        context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    else if (std::ranges::any_of(certificates, lost))
        context.exitStatus = 1;
    if (!options.json.empty()) writeText(options.json, certify::certificatesJson(certificates));
    for (const certify::Certificate& one : certificates)
        printText(options.json == "-" ? stderr : stdout, certify::certificateText(one));
    for (const certify::Certificate& one : certificates) keeper.keep(reportOf(one));
}

void merge(const CertifyOptions& options, const ReportKeeper& keeper, Context& context) {
    std::vector<certify::Certificate> certificates;
    for (const std::string& file : options.merge)
        for (certify::Certificate& one : certify::readCertificates(file)) certificates.push_back(std::move(one));
    report(certify::merged(certificates), options, keeper, context);
}

void run(const CertifyOptions& options, Context& context) {
    checkOutputPlaces({options.json, options.state}, options.store);
    const ReportKeeper keeper(options.store, context);
    if (!options.merge.empty()) {
        if (!options.strategies.empty()) throwUsage(CULLSCOPE_TR("--merge takes state files alone: leave out the strategy."));
        return merge(options, keeper, context);
    }
    if (options.strategies.empty()) throwUsage(CULLSCOPE_TR("Name the strategy to be certified, or state files with --merge."));
    certify::CertifyRequest request;
    request.strategies = strategiesOf(options.strategies, options.parameters);
    request.views = options.views;
    request.seed = options.seed;
    if (!options.shard.empty()) std::tie(request.shard, request.shards) = shardFromText(options.shard);
    request.state = options.state;
    request.cases = options.cases;
    request.threads = options.threads;
    if (options.worker) return tryBlocksOfParent(request, context.stop);
    if (options.threads != 1) request.trier = workerProcess;
    {
        const HeadlessContext gl;
        for (const StrategyRequest& strategy : request.strategies) requireAvailable(strategy, gl.info());
    }
    const std::vector<certify::Certificate> certificates = certify::certify(request, terminalProgress(context));
    clearProgress();
    report(certificates, options, keeper, context);
}

}  // namespace

void addCertifyCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("certify", "Tries random views of random scenes against a strategy's promise");
    auto options = std::make_shared<CertifyOptions>();
    command->add_option("STRATEGY", options->strategies,
                        "strategies, as in -s: tried at the same views, each with a certificate");
    command->add_option("-p,--parameter", options->parameters, "parameter, as in measure: key=value or STRATEGY.key=value")
        ->allow_extra_args(false);
    command->add_option("--views", options->views, "how many views, of all shards together")
        ->check(CLI::Range(uint64_t{1}, uint64_t{10'000'000'000}))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "number that scenes and views start from")->capture_default_str();
    command->add_option("--shard", options->shard, "I/N: the I-th of N parts of the work, from 1");
    command->add_option("--state", options->state, "file that keeps what is done; a run that is there is gone on with");
    command->add_option("--cases", options->cases, "folder for counterexamples, shrunk and written as scenes");
    command
        ->add_option("--threads", options->threads,
                     "how many blocks at once, each in a process of its own (default: one a processor)")
        ->check(CLI::Range(size_t{1}, size_t{1024}));
    command->add_option("--merge", options->merge, "state files of shards, to be put together");
    command->add_option("--json", options->json, "result file; - is standard output");
    addReportStoreOption(*command, options->store);
    command->add_flag("--worker", options->worker)->group("");
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
