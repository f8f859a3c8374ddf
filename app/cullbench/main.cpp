// cullbench: all measurements of Cullscope, without a window.

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <system_error>
#include <thread>

#include "app/cullbench/commands.h"
#include "core/base/error.h"
#include "core/experiments/result_file.h"

namespace {

using namespace cullscope;
using namespace cullscope::cullbench;

/// The first Ctrl-C is a stop request, which keeps the measurements made so far; the second ends the program at once. The signals
/// are blocked in every thread; one thread waits for them.
std::stop_source stopOnInterrupt() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
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

[[noreturn]] void refuseOutput(int number) {
    throwUsage(CULLSCOPE_TR("Standard output cannot be written: %1. Send it somewhere else."), {systemReason(number)});
}

int run(int argc, char** argv) {
    const std::stop_source interrupt = stopOnInterrupt();
    Context context;
    context.stop = interrupt.get_token();

    CLI::App app("Measures what a renderer does not draw, and what that costs in accuracy.", "cullbench");
    app.set_version_flag("--version", toolVersion().version + " (" + toolVersion().commit + ")");
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--models", context.sceneOptions.modelFolders, "folder that holds bunny.obj; may be given more than once")
        ->allow_extra_args(false);
    addListCommand(app, context);
    addRenderCommand(app, context);
    addMeasureCommand(app, context);
    addExportCommand(app, context);
    addInspectCommand(app, context);
    addPathCommand(app, context);
    addReproduceCommand(app, context);
    addSweepCommand(app, context);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& failure) {
        return app.exit(failure) == 0 ? 0 : static_cast<int>(ErrorKind::Usage);
    } catch (const std::system_error& failure) {
        // fmt throws this where a print failed.
        if (std::ferror(stdout) == 0) throw;
        refuseOutput(failure.code().value());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) refuseOutput(errno);
    return context.exitStatus;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        clearProgress();
        fmt::print(stderr, "cullbench: {}\n", error.what());
        return static_cast<int>(error.kind());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "cullbench: There is not enough memory for this: use a smaller scene.\n");
        return static_cast<int>(ErrorKind::Input);
    } catch (const std::exception& error) {
        fmt::print(stderr, "cullbench: {}\n", error.what());
        return static_cast<int>(ErrorKind::Input);
    }
}
