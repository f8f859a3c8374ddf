#include "tests/benchmark/run_experiment.h"

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "core/base/atomic_file.h"
#include "tests/support/experiment_faults.h"

namespace cullscope::benchmark {
namespace {

void write(const ResultTable& table, const std::filesystem::path& folder) {
    writeFileAtomically(folder / (table.experiment + ".csv"), [&](std::ostream& out) { out << rowsCsv(table); });
    if (!table.plots.empty())
        writeFileAtomically(folder / (table.experiment + ".svg"), [&](std::ostream& out) { out << linePlotsSvg(table.plots); });
}

}  // namespace

int runAndReport(const BenchmarkRun& run) {
    const std::vector<std::string> faults = test::experimentFaults(run.experiment);
    if (!faults.empty()) throw std::logic_error(faults.front());
    if (!run.folder.empty()) std::filesystem::create_directories(run.folder);
    std::optional<HeadlessContext> gl;
    if (run.experiment.needsOpenGl()) gl.emplace();
    size_t finished = 0;
    const ResultTable table = runExperiment(run.experiment, {}, {}, [&](const ResultTable& soFar) {
        std::fprintf(stderr, "%s: %zu of %zu settings, %zu rows\n", soFar.experiment.c_str(), ++finished,
                     run.experiment.settings.size(), soFar.rows.size());
    });
    std::fputs(tableText(table).c_str(), stdout);
    for (const std::string& strategy : table.brokenPromises)
        std::printf("%s promises to lose no pixel and lost some\n", strategy.c_str());
    std::fflush(stdout);
    if (!run.folder.empty()) write(table, run.folder);
    return table.checkFailed() || !table.brokenPromises.empty() ? 1 : 0;
}

int benchmarkMain(int argc, char** argv, const char* usage, const RunOfArguments& runOf) try {
    const std::optional<BenchmarkRun> run = runOf({argv + 1, argv + argc});
    if (run) return runAndReport(*run);
    std::fprintf(stderr, "%s\n", usage);
    return 2;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}

}  // namespace cullscope::benchmark
