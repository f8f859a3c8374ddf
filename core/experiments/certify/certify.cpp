#include "core/experiments/certify/certify.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <latch>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/error.h"
#include "core/experiments/certify/shrink.h"
#include "core/gpu/context.h"
#include "core/gpu/gpu_frame.h"
#include "core/measure/accuracy.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::certify {
namespace {

constexpr std::chrono::seconds kBetweenStates{5};

uint64_t sceneSeed(const CertifyRequest& request, uint64_t block) { return request.seed * 1'000'003 + block; }
Random viewRandom(const CertifyRequest& request, uint64_t block, uint64_t view) {
    return Random((sceneSeed(request, block) * 7919 + view) * 2 + 1);
}

Certificate beginning(const CertifyRequest& request) {
    Certificate certificate;
    certificate.strategy = strategyText(request.strategy);
    certificate.seed = request.seed;
    certificate.blocks = std::max<uint64_t>(1, (request.views + kViewsOfABlock - 1) / kViewsOfABlock);
    certificate.shard = request.shard;
    certificate.shards = request.shards;
    certificate.done.assign(certificate.blocks, false);
    return certificate;
}

Certificate beginningOrState(const CertifyRequest& request) {
    Certificate certificate = beginning(request);
    std::error_code ignored;
    if (request.state.empty() || !std::filesystem::exists(request.state, ignored)) return certificate;
    Certificate kept = readCertificate(request.state);
    if (kept.strategy != certificate.strategy || kept.seed != certificate.seed || kept.blocks != certificate.blocks ||
        kept.shard != certificate.shard || kept.shards != certificate.shards)
        throwUsage(CULLSCOPE_TR("%1 has the state of another run, of %2 with seed %3: name another file, or remove it."),
                   {request.state.string(), kept.strategy, std::to_string(kept.seed)});
    return kept;
}

/// The work of all threads.
class Run {
public:
    Run(const CertifyRequest& request, const Progress& progress)
        : m_request(request), m_progress(progress), m_certificate(beginningOrState(request)) {}

    Certificate finish() {
        const size_t wanted = m_request.threads > 0 ? m_request.threads : std::max(1U, std::thread::hardware_concurrency());
        const size_t threads = std::min<uint64_t>(wanted, std::max<uint64_t>(1, m_certificate.blocksToDo()));
        {
            std::latch begun{ptrdiff_t(threads)}, ended{ptrdiff_t(threads)};
            std::vector<std::jthread> workers;
            for (size_t i = 0; i < threads; ++i) try {
                    workers.emplace_back([&] { work(begun, ended); });
                } catch (const std::system_error&) {
                    // The system gives no further thread: the others do the work.
                    begun.count_down();
                    ended.count_down();
                }
            if (workers.empty()) throwInput(CULLSCOPE_TR("The system gives no thread for this: close other programs."));
        }
        if (!m_request.state.empty()) writeCertificate(m_request.state, m_certificate);
        if (m_failure) std::rethrow_exception(m_failure);
        return std::move(m_certificate);
    }

private:
    /// The next block of this shard that is not done and not under way; none: there is none.
    std::optional<uint64_t> next() {
        const std::lock_guard lock(m_mutex);
        if (m_failure || m_progress.stopRequested() || m_certificate.counterexamples.size() >= m_request.mostCounterexamples)
            return std::nullopt;
        for (; m_next < m_certificate.blocks; ++m_next)
            if (m_certificate.ofShard(m_next) && !m_certificate.done[m_next]) return m_next++;
        return std::nullopt;
    }

    /// All threads have their contexts before any of them works, and keep them until all are done: EGL's display is one for the
    /// process, and the end of a context may end it for the others.
    void work(std::latch& begun, std::latch& ended) {
        std::unique_ptr<HeadlessContext> context = makeContext();
        begun.arrive_and_wait();
        if (context) tryBlocks();
        ended.arrive_and_wait();
        const std::lock_guard lock(m_contexts);
        context.reset();
    }

    std::unique_ptr<HeadlessContext> makeContext() {
        const std::lock_guard lock(m_contexts);
        try {
            // An OpenGL context belongs to the thread that made it.
            return std::make_unique<HeadlessContext>();
        } catch (const std::exception&) {
            fail();
            return nullptr;
        }
    }

    void tryBlocks() {
        try {
            Renderer renderer;
            const Progress quiet{nullptr, m_progress.stop};
            while (const std::optional<uint64_t> block = next()) add(*block, certifyBlock(m_request, *block, renderer, quiet));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) fail();
        } catch (const std::exception&) {
            fail();
        }
    }

    void fail() {
        const std::lock_guard lock(m_mutex);
        if (!m_failure) m_failure = std::current_exception();
    }

    void add(uint64_t block, BlockResult result) {
        const std::lock_guard lock(m_mutex);
        m_certificate.done[block] = true;
        m_certificate.views += result.views;
        m_certificate.promised += result.promised;
        m_certificate.refused += result.refused;
        m_certificate.coveredPixels += result.coveredPixels;
        for (Counterexample& one : result.counterexamples) m_certificate.counterexamples.push_back(std::move(one));
        m_progress.tell(double(m_certificate.blocksDone()) / double(m_certificate.blocksToDo()), CULLSCOPE_TR("certifying"));
        const auto now = std::chrono::steady_clock::now();
        if (m_request.state.empty() || now - m_written < kBetweenStates) return;
        m_written = now;
        writeCertificate(m_request.state, m_certificate);
    }

    const CertifyRequest& m_request;
    const Progress& m_progress;
    std::mutex m_mutex, m_contexts;
    Certificate m_certificate;
    uint64_t m_next = 0;
    std::chrono::steady_clock::time_point m_written = std::chrono::steady_clock::now();
    std::exception_ptr m_failure;
};

Counterexample shrunkAndWritten(const CertifyRequest& request, uint64_t block, uint64_t number, uint64_t lost, Example example,
                                Renderer& renderer, const Progress& progress) {
    Counterexample found;
    found.block = block;
    found.view = number;
    found.lostPixels = lost;
    example = shrunk(request.strategy, std::move(example), renderer, progress);
    found.triangles = example.scene->triangleCount();
    found.objects = example.scene->instances().size();
    found.size = example.view.viewport;
    if (request.cases.empty()) return found;
    std::error_code failure;
    std::filesystem::create_directories(request.cases, failure);
    const std::filesystem::path file =
        request.cases / fmt::format("{}-{}-{}-{}", request.strategy.id, request.seed, block, number);
    found.fileShowsIt = writeExample(file, request.strategy, example, renderer);
    found.file = file.string();
    return found;
}

}  // namespace

uint64_t Certificate::blocksDone() const { return uint64_t(std::ranges::count(done, true)); }

uint64_t Certificate::blocksToDo() const {
    uint64_t count = 0;
    for (uint64_t block = 0; block < blocks; ++block) count += ofShard(block) ? 1 : 0;
    return count;
}

BlockResult certifyBlock(const CertifyRequest& request, uint64_t block, Renderer& renderer, const Progress& progress) {
    BlockResult result;
    result.views = kViewsOfABlock;
    const ScenePointer scene = randomScene(sceneSeed(request, block));
    const SceneBuffers buffers(scene, Upload::Vbo);
    StructureStore structures;
    BuiltStrategyPointer strategy;
    try {
        strategy = buildStrategy(strategyOf(request.strategy), request.strategy.parameters, scene, structures, progress);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Interrupted || error.kind() == ErrorKind::OpenGl) throw;
        result.refused = kViewsOfABlock;
        return result;
    }
    for (uint64_t number = 0; number < kViewsOfABlock; ++number) {
        progress.check();
        Random random = viewRandom(request, block, number);
        const RandomView tried = randomView(*scene, random, Sizes::UpTo1025);
        const View view(tried.camera, tried.viewport);
        if (strategy->promiseAt(view) == Promise::Approximate) continue;
        GpuFrame frame(renderer, buffers, view);
        const ViewStatePointer state = strategy->begin();
        try {
            strategy->draw(frame, *state);
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Interrupted || error.kind() == ErrorKind::OpenGl) throw;
            ++result.refused;
            continue;
        }
        ++result.promised;
        const Reference truth = itemBufferReference(renderer, buffers, view, strategy->referenceFacing());
        result.coveredPixels += truth.coveredPixels;
        Framebuffer target(tried.viewport);
        const uint64_t lost = judge(renderer, buffers, frame.take(), truth, target).lostPixels();
        if (lost > 0)
            result.counterexamples.push_back(shrunkAndWritten(request, block, number, lost, {scene, tried}, renderer, progress));
    }
    return result;
}

Certificate certify(const CertifyRequest& request, const Progress& progress) { return Run(request, progress).finish(); }

}  // namespace cullscope::certify
