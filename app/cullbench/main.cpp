// cullbench: all measurements of Cullscope, without a window.

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <sstream>
#include <thread>

#include "app/command_words.h"
#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/base/last_words.h"
#include "core/base/memory_limit.h"
#include "core/base/standard_streams.h"
#include "core/experiments/result_file.h"

namespace {

using namespace cullscope;
using namespace cullscope::cullbench;

/// As by nohup, whose program lives on when its terminal is closed.
bool isIgnored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The first Ctrl-C, or the closing of the terminal, is a stop request, which keeps the measurements made so far; the second ends
/// the program at once. The signals are blocked in every thread; one thread waits for them.
std::stop_source stopOnInterrupt() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    if (!isIgnored(SIGHUP)) sigaddset(&signals, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::stop_source source;
    std::thread([source, signals]() mutable {
        for (int received = 0; sigwait(&signals, &received) == 0;) {
            if (source.stop_requested()) _exit(static_cast<int>(ErrorKind::Interrupted));
            source.request_stop();
        }
    }).detach();
    return source;
}

/// Help, the version, or what is wrong with the words.
int said(const CLI::App& app, const CLI::ParseError& failure) {
    std::ostringstream out, err;
    const int status = app.exit(failure, out, err) == 0 ? 0 : static_cast<int>(ErrorKind::Usage);
    printText(stderr, err.str());
    printText(stdout, out.str());
    flushOutput();
    return status;
}

int run(int argc, char** argv) {
    const std::stop_source interrupt = stopOnInterrupt();
    Context context;
    context.stop = interrupt.get_token();
    context.command = commandLine({argv + 1, argv + argc});

    CLI::App app("Measures what a renderer does not draw, and what that costs in accuracy.", "cullbench");
    sayFailuresOnOneLine(app);
    app.set_version_flag("--version", toolVersion().version + " (" + toolVersion().commit + ")");
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--models", context.sceneOptions.modelFolders, "folder that holds bunny.obj; may be given more than once")
        ->allow_extra_args(false);
    addListCommand(app, context);
    addRenderCommand(app, context);
    addMeasureCommand(app, context);
    addFigureCommand(app, context);
    addExportCommand(app, context);
    addInspectCommand(app, context);
    addPathCommand(app, context);
    addReproduceCommand(app, context);
    addSweepCommand(app, context);
    addStabilityCommand(app, context);
    addSelfTestCommand(app, context);
    addSuiteCommand(app, context);
    addJudgeCommand(app, context);
    addCertifyCommand(app, context);
    addAdviseCommand(app, context);
    addRaceCommand(app, context);
    addWorstCommand(app, context);
    addStoreCommand(app, context);
    addStudyCommand(app, context);
    refuseEmptyValues(app);
    try {
        refuseEmptyAssignments(argc, argv);
        app.parse(argc, argv);
        flushOutput();
    } catch (const CLI::ParseError& failure) {
        return said(app, failure);
    } catch (const ReaderGone&) {
        // Who closed the pipe has read enough; commands write their files and set their status before they print.
    }
    return context.exitStatus;
}

}  // namespace

int main(int argc, char** argv) {
    keepStandardStreams();
    endWithSentenceOnTerminate();
    endWithSentenceOnWant();
    const ExitsForWant exits;
    try {
        return run(argc, argv);
    } catch (const ReaderGone&) {
        return 0;  // of help and version
    } catch (const Error& error) {
        clearProgress();
        say(stderr, "cullbench: {}\n", error.what());
        return static_cast<int>(error.kind());
    } catch (const std::bad_alloc&) {
        say(stderr, "cullbench: There is not enough memory for this: use a smaller scene.\n");
        return static_cast<int>(ErrorKind::Input);
    } catch (const std::exception& error) {
        say(stderr, "cullbench: It cannot go on: {}. {}\n", error.what(),
            memoryIsShort() ? "Close other programs, or allow this one more memory (ulimit -v)."
                            : "Close other programs, or use a smaller scene.");
        return static_cast<int>(ErrorKind::Input);
    }
}
