#include "core/experiments/certify/certify.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
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
/// Of the views, those in parallel projection.
constexpr double kParallelShare = 0.2;

uint64_t sceneSeed(const CertifyRequest& request, uint64_t block) { return request.seed * 1'000'003 + block; }
Random viewRandom(const CertifyRequest& request, uint64_t block, uint64_t view) {
    return Random((sceneSeed(request, block) * 7919 + view) * 2 + 1);
}

std::vector<Certificate> beginnings(const CertifyRequest& request) {
    std::vector<Certificate> certificates;
    for (const StrategyRequest& strategy : request.strategies) {
        Certificate certificate;
        certificate.strategy = strategyText(strategy);
        if (std::ranges::find(certificates, certificate.strategy, &Certificate::strategy) != certificates.end())
            throwUsage(CULLSCOPE_TR("%1 is named twice: name each strategy once."), {certificate.strategy});
        certificate.seed = request.seed;
        certificate.blocks = std::max<uint64_t>(1, (request.views + kViewsOfABlock - 1) / kViewsOfABlock);
        certificate.shard = request.shard;
        certificate.shards = request.shards;
        certificate.done.assign(certificate.blocks, false);
        certificates.push_back(std::move(certificate));
    }
    if (certificates.empty()) throwUsage(CULLSCOPE_TR("Name the strategy to be certified."));
    return certificates;
}

std::string namesOf(const std::vector<Certificate>& certificates) {
    std::string names;
    for (const Certificate& one : certificates) names += (names.empty() ? "" : ", ") + one.strategy;
    return names;
}

bool ofTheSameRun(const std::vector<Certificate>& some, const std::vector<Certificate>& others) {
    return std::ranges::equal(some, others, [&](const Certificate& one, const Certificate& other) {
        return one.strategy == other.strategy && one.seed == other.seed && one.blocks == other.blocks &&
               one.shard == other.shard && one.shards == other.shards && one.done.size() == other.done.size();
    });
}

std::vector<Certificate> beginningsOrState(const CertifyRequest& request) {
    std::vector<Certificate> certificates = beginnings(request);
    std::error_code ignored;
    if (request.state.empty() || !std::filesystem::exists(request.state, ignored)) return certificates;
    std::vector<Certificate> kept = readCertificates(request.state);
    const auto differs = [&](const Certificate& one) {
        return one.viewsVersion != kViewsVersion || one.done != kept.front().done;
    };
    if (std::ranges::any_of(kept, differs))
        throwUsage(CULLSCOPE_TR("%1 was written by another version: its blocks are not those of this one."),
                   {request.state.string()});
    if (!ofTheSameRun(kept, certificates))
        throwUsage(CULLSCOPE_TR("%1 has the state of another run, of %2 with seed %3: name another file, or remove it."),
                   {request.state.string(), namesOf(kept), std::to_string(kept.front().seed)});
    return kept;
}

/// The work of all triers.
class Run {
public:
    Run(const CertifyRequest& request, const Progress& progress)
        : m_request(request), m_progress(progress), m_certificates(beginningsOrState(request)) {}

    std::vector<Certificate> finish() {
        {
            std::vector<std::jthread> workers;
            for (size_t i = 0; i < threads(); ++i) try {
                    workers.emplace_back([this] { work(); });
                } catch (const std::system_error&) {
                    // The system gives no further thread: the others do the work.
                }
            if (workers.empty()) throwInput(CULLSCOPE_TR("The system gives no thread for this: close other programs."));
        }
        if (!m_request.state.empty()) writeCertificates(m_request.state, m_certificates);
        if (m_failure) std::rethrow_exception(m_failure);
        return std::move(m_certificates);
    }

private:
    /// The next block of this shard that is not done and not under way; none: there is none.
    std::optional<uint64_t> next() {
        const std::lock_guard lock(m_mutex);
        size_t counterexamples = 0;
        for (const Certificate& one : m_certificates) counterexamples += one.counterexamples.size();
        if (m_failure || m_progress.stopRequested() || counterexamples >= m_request.mostCounterexamples) return std::nullopt;
        for (; m_next < blocks().blocks; ++m_next)
            if (blocks().ofShard(m_next) && !blocks().done[m_next]) return m_next++;
        return std::nullopt;
    }

    /// Several contexts of Mesa's software OpenGL disturb each other where threads of one process draw with them.
    [[nodiscard]] size_t threads() const {
        if (!m_request.trier) return 1;
        const size_t wanted = m_request.threads > 0 ? m_request.threads : std::max(1U, std::thread::hardware_concurrency());
        return std::min<uint64_t>(wanted, std::max<uint64_t>(1, blocks().blocksToDo()));
    }

    /// On a thread of its own, so that no context of the caller's is put in another one's place.
    void work() {
        try {
            const BlockTrier trier = (m_request.trier ? m_request.trier : TrierMaker(ownContext))(m_request);
            const Progress quiet{nullptr, m_progress.stop};
            while (const std::optional<uint64_t> block = next()) add(*block, trier(*block, quiet));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) fail();
        } catch (const std::exception&) {
            fail();
        }
    }

    static BlockTrier ownContext(const CertifyRequest& request) {
        // The renderer ends before its context.
        struct Drawing {
            HeadlessContext context;
            Renderer renderer;
        };
        const auto drawing = std::make_shared<Drawing>();
        return [drawing, &request](uint64_t block, const Progress& progress) {
            return certifyBlock(request, block, drawing->renderer, progress);
        };
    }

    void fail() {
        const std::lock_guard lock(m_mutex);
        if (!m_failure) m_failure = std::current_exception();
    }

    /// All strategies have the same blocks, and have done the same.
    [[nodiscard]] const Certificate& blocks() const { return m_certificates.front(); }

    void add(uint64_t block, std::vector<BlockResult> results) {
        const std::lock_guard lock(m_mutex);
        for (size_t i = 0; i < results.size(); ++i) {
            Certificate& certificate = m_certificates[i];
            certificate.done[block] = true;
            certificate.views += results[i].views;
            certificate.promised += results[i].promised;
            certificate.refused += results[i].refused;
            certificate.coveredPixels += results[i].coveredPixels;
            for (Counterexample& one : results[i].counterexamples) certificate.counterexamples.push_back(std::move(one));
        }
        m_progress.tell(double(blocks().blocksDone()) / double(blocks().blocksToDo()), CULLSCOPE_TR("certifying"));
        const auto now = std::chrono::steady_clock::now();
        if (m_request.state.empty() || now - m_written < kBetweenStates) return;
        m_written = now;
        writeCertificates(m_request.state, m_certificates);
    }

    const CertifyRequest& m_request;
    const Progress& m_progress;
    std::mutex m_mutex;
    std::vector<Certificate> m_certificates;  ///< by strategy
    uint64_t m_next = 0;
    std::chrono::steady_clock::time_point m_written = std::chrono::steady_clock::now();
    std::exception_ptr m_failure;
};

Counterexample shrunkAndWritten(const CertifyRequest& request, const StrategyRequest& strategy, uint64_t block, uint64_t number,
                                uint64_t lost, Example example, Renderer& renderer, const Progress& progress) {
    Counterexample found;
    found.block = block;
    found.view = number;
    found.lostPixels = lost;
    example = shrunk(strategy, std::move(example), renderer, progress);
    found.triangles = example.scene->triangleCount();
    found.objects = example.scene->instances().size();
    found.size = example.view.viewport;
    if (request.cases.empty()) return found;
    std::error_code failure;
    std::filesystem::create_directories(request.cases, failure);
    const std::filesystem::path file = request.cases / fmt::format("{}-{}-{}-{}", strategy.id, request.seed, block, number);
    found.fileShowsIt = writeExample(file, strategy, example, renderer);
    found.file = file.string();
    return found;
}

/// Whether a strategy serves what is asked of it; stops and failures of OpenGL are thrown.
template <typename Ask>
bool served(const Ask& ask) {
    try {
        ask();
        return true;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Interrupted || error.kind() == ErrorKind::OpenGl) throw;
        return false;
    }
}

/// A view, with the truth of each facing rule drawn once for all strategies.
class TriedView {
public:
    TriedView(Renderer& renderer, const SceneBuffers& buffers, const View& view)
        : m_renderer(renderer), m_buffers(buffers), m_view(view) {}

    /// Draws it by a strategy where that promises to lose nothing, and counts it. Returns how many pixels were lost.
    uint64_t lostBy(const BuiltStrategy& strategy, BlockResult& result) {
        if (strategy.promiseAt(m_view) == Promise::Approximate) return 0;
        GpuFrame frame(m_renderer, m_buffers, m_view);
        const ViewStatePointer state = strategy.begin();
        if (!served([&] { strategy.draw(frame, *state); })) {
            ++result.refused;
            return 0;
        }
        ++result.promised;
        const Reference& truth = truthUnder(strategy.referenceFacing());
        result.coveredPixels += truth.coveredPixels;
        if (!m_target) m_target.emplace(m_view.viewport());
        return judge(m_renderer, m_buffers, frame.take(), truth, *m_target).lostPixels();
    }

private:
    const Reference& truthUnder(Facing facing) {
        const auto same = std::ranges::find(m_truths, facing, &Reference::facing);
        if (same != m_truths.end()) return *same;
        return m_truths.emplace_back(itemBufferReference(m_renderer, m_buffers, m_view, facing));
    }

    Renderer& m_renderer;
    const SceneBuffers& m_buffers;
    View m_view;
    std::vector<Reference> m_truths;
    std::optional<Framebuffer> m_target;
};

}  // namespace

uint64_t Certificate::blocksDone() const { return uint64_t(std::ranges::count(done, true)); }

uint64_t Certificate::blocksToDo() const {
    uint64_t count = 0;
    for (uint64_t block = 0; block < blocks; ++block) count += ofShard(block) ? 1 : 0;
    return count;
}

std::vector<BlockResult> certifyBlock(const CertifyRequest& request, uint64_t block, Renderer& renderer,
                                      const Progress& progress) {
    std::vector<BlockResult> results(request.strategies.size(), BlockResult{kViewsOfABlock});
    const ScenePointer scene = randomScene(sceneSeed(request, block));
    const SceneBuffers buffers(scene, Upload::Vbo);
    StructureStore structures;
    std::vector<BuiltStrategyPointer> built;
    for (size_t i = 0; i < results.size(); ++i) {
        const StrategyRequest& strategy = request.strategies[i];
        built.emplace_back();
        if (!served(
                [&] { built.back() = buildStrategy(strategyOf(strategy), strategy.parameters, scene, structures, progress); }))
            results[i].refused = kViewsOfABlock;
    }
    for (uint64_t number = 0; number < kViewsOfABlock; ++number) {
        progress.check();
        Random random = viewRandom(request, block, number);
        const RandomView tried = randomView(*scene, random, Sizes::UpTo1025, kParallelShare);
        TriedView view(renderer, buffers, View(tried.camera, tried.viewport));
        for (size_t i = 0; i < results.size(); ++i) {
            if (!built[i]) continue;
            const uint64_t lost = view.lostBy(*built[i], results[i]);
            if (lost > 0)
                results[i].counterexamples.push_back(
                    shrunkAndWritten(request, request.strategies[i], block, number, lost, {scene, tried}, renderer, progress));
        }
    }
    return results;
}

std::vector<Certificate> certify(const CertifyRequest& request, const Progress& progress) {
    return Run(request, progress).finish();
}

}  // namespace cullscope::certify
