#include "app/cullbench/certify_workers.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/gpu/context.h"

extern char** environ;

namespace cullscope::cullbench {
namespace {

constexpr const char* kThreadsOfMesa = "LP_NUM_THREADS";

/// A process and one end of the socket that is its standard input and output.
class Worker {
public:
    Worker(std::vector<std::string> words, std::vector<std::string> environment) {
        std::array<int, 2> ends{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse();
        m_socket = ends[0];
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO}) posix_spawn_file_actions_adddup2(&actions, ends[1], stream);
        const int failure = posix_spawn(&m_process, "/proc/self/exe", &actions, nullptr, pointersTo(words).data(),
                                        pointersTo(environment).data());
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        if (failure != 0) {
            close(m_socket);
            refuse();
        }
    }
    ~Worker() {
        // The worker's input ends, and with it the worker.
        close(m_socket);
        waitpid(m_process, nullptr, 0);
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    [[nodiscard]] std::vector<certify::BlockResult> tryBlock(uint64_t block, const Progress& progress) {
        const std::string question = std::to_string(block) + "\n";
        const bool asked = send(m_socket, question.data(), question.size(), MSG_NOSIGNAL) == ssize_t(question.size());
        std::string answer;
        std::array<char, 4096> part{};
        while (asked && (answer.empty() || answer.back() != '\n')) {
            const ssize_t length = recv(m_socket, part.data(), part.size(), 0);
            if (length <= 0) break;
            answer.append(part.data(), size_t(length));
        }
        if (!answer.empty() && answer.back() == '\n') return certify::blockFromJson(answer);
        // Ctrl-C reaches the workers, too.
        progress.check();
        throwOpenGl(CULLSCOPE_TR("A process that tried block %1 ended by itself. Try it with cullbench certify --threads 1."),
                    {std::to_string(block)});
    }

private:
    /// As the system takes them: the last one is null.
    static std::vector<char*> pointersTo(std::vector<std::string>& texts) {
        std::vector<char*> pointers;
        for (std::string& text : texts) pointers.push_back(text.data());
        pointers.push_back(nullptr);
        return pointers;
    }

    [[noreturn]] static void refuse() {
        throwInput(
            CULLSCOPE_TR("The system gives no further process: close other programs, or take cullbench certify --threads 1."));
    }

    pid_t m_process = 0;
    int m_socket = -1;
};

}  // namespace

certify::BlockTrier workerProcess(const certify::CertifyRequest& request) {
    std::vector<std::string> words{"cullbench", "certify", "--worker", "--seed", std::to_string(request.seed)};
    for (const StrategyRequest& strategy : request.strategies) words.push_back(strategyText(strategy));
    if (!request.cases.empty()) words.insert(words.end(), {"--cases", request.cases.string()});
    std::vector<std::string> environment;
    for (char** variable = environ; *variable != nullptr; ++variable) environment.emplace_back(*variable);
    if (std::getenv(kThreadsOfMesa) == nullptr) environment.push_back(std::string(kThreadsOfMesa) + "=0");
    const auto worker = std::make_shared<Worker>(std::move(words), std::move(environment));
    return [worker](uint64_t block, const Progress& progress) { return worker->tryBlock(block, progress); };
}

void tryBlocksOfParent(const certify::CertifyRequest& request, std::stop_token stop) {
    const HeadlessContext gl;
    Renderer renderer;
    const Progress progress{nullptr, std::move(stop)};
    try {
        for (uint64_t block = 0; std::cin >> block;) {
            std::puts(certify::blockJson(certify::certifyBlock(request, block, renderer, progress)).c_str());
            std::fflush(stdout);
        }
    } catch (const Error& error) {
        // Ctrl-C reaches every process of the command, of which the first one says so.
        if (error.kind() != ErrorKind::Interrupted) throw;
    }
}

}  // namespace cullscope::cullbench
